#include "vulkan/state.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>

namespace gabor::vulkan {

namespace {

std::atomic<int> messages = 0;

VKAPI_ATTR VkBool32 VKAPI_CALL report(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    ++messages;
    fmt::print(stderr, "validation: {}\n", data->pMessage);
    return VK_FALSE;
}

std::string_view validation() {
    const char* value = std::getenv("GABOR_VALIDATION");
    return value && std::string_view(value) != "0" ? value : "";
}

bool validating() {
    return !validation().empty();
}

} // namespace

vk::raii::Context load_vulkan() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw RequestError("no Vulkan loader found: install libvulkan1 and a driver (mesa-vulkan-drivers has "
                           "one that needs no GPU)");
    }
}

vk::raii::Instance make_instance(const vk::raii::Context& context, const Presentation& presentation) {
    const vk::ApplicationInfo application("gabor", 1, nullptr, 0, VK_API_VERSION_1_1);
    vk::StructureChain<vk::InstanceCreateInfo, vk::ValidationFeaturesEXT> chain;
    chain.get<vk::InstanceCreateInfo>().pApplicationInfo = &application;
    const std::array layers{"VK_LAYER_KHRONOS_validation"};
    std::vector<const char*> extensions = presentation.instance_extensions;
    // GPU-assisted validation makes shaders take many times as long, and these other checks must not see its
    // buffers.
    using Check = vk::ValidationFeatureEnableEXT;
    const std::vector<Check> features =
        validation() == "gpu" ? std::vector{Check::eGpuAssisted}
        : presentation.can_present // Dear ImGui's backend allocates against best practices
            ? std::vector{Check::eSynchronizationValidation}
            : std::vector{Check::eSynchronizationValidation, Check::eBestPractices};
    if (validating()) {
        extensions.insert(extensions.end(),
                          {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME});
        chain.get<vk::InstanceCreateInfo>().setPEnabledLayerNames(layers);
        chain.get<vk::ValidationFeaturesEXT>().setEnabledValidationFeatures(features);
    } else {
        chain.unlink<vk::ValidationFeaturesEXT>();
    }
    chain.get<vk::InstanceCreateInfo>().setPEnabledExtensionNames(extensions);
    try {
        return {context, chain.get<vk::InstanceCreateInfo>()};
    } catch (const vk::IncompatibleDriverError&) {
        throw RequestError(
            "no Vulkan driver found: install one (mesa-vulkan-drivers has one that needs no GPU)");
    }
}

vk::raii::DebugUtilsMessengerEXT make_messenger(const vk::raii::Instance& instance) {
    if (!validating())
        return nullptr;
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    return {instance, vk::DebugUtilsMessengerCreateInfoEXT(
                          {}, Severity::eError | Severity::eWarning,
                          Type::eGeneral | Type::eValidation | Type::ePerformance, report)};
}

int validation_messages() {
    return messages;
}

} // namespace gabor::vulkan

#include "vulkan/state.hpp"

#include "error.hpp"
#include "names.hpp"
#include "system/desktop.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace gabor::vulkan {

namespace {

// ---- The instance ----

std::atomic<int> messages = 0;

VKAPI_ATTR VkBool32 VKAPI_CALL report(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                      const VkDebugUtilsMessengerCallbackDataEXT* data, void*) {
    const auto says = [&](std::string_view words) {
        return std::string_view(data->pMessage).find(words) != std::string_view::npos;
    };
    if (says("Attempting to enable") &&
        (says(VK_EXT_DEBUG_UTILS_EXTENSION_NAME) || says(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME)))
        return VK_FALSE; // newer layers advise against the extensions that turn them on
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

std::string how_to_get_a_driver() {
    for (const char* name :
         {"VK_DRIVER_FILES", "VK_ICD_FILENAMES", "VK_LOADER_DRIVERS_SELECT",
          "VK_LOADER_DRIVERS_DISABLE"}) // the loader reads the second only without the first
        if (const char* value = std::getenv(name); value && *value)
            return fmt::format("the environment variable {} is '{}', which hides other drivers: unset it, or "
                               "name a driver's file that works",
                               name, value);
    return std::string(system::how_to_get_a_driver);
}

namespace {

// Throws RequestError if there is no Vulkan loader.
vk::raii::Context load_vulkan() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw RequestError(fmt::format("no Vulkan loader found: {}", system::how_to_get_vulkan));
    }
}

void ask_for_messages(vk::DebugUtilsMessengerCreateInfoEXT& info) {
    using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
    using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
    info.setMessageSeverity(Severity::eError | Severity::eWarning)
        .setMessageType(Type::eValidation | Type::ePerformance);
    VkDebugUtilsMessengerCreateInfoEXT& plain = info; // vk::'s type of the callback changed in Vulkan-Hpp 1.4
    plain.pfnUserCallback = report;
}

bool has(const std::vector<vk::ExtensionProperties>& extensions, std::string_view name) {
    return std::ranges::any_of(extensions, [&](const vk::ExtensionProperties& extension) {
        return name == extension.extensionName.data();
    });
}

// Loads the validation layers if GABOR_VALIDATION requests them. Throws RequestError if there is no driver.
vk::raii::Instance make_instance(const vk::raii::Context& context, const Presentation& presentation) {
    const vk::ApplicationInfo application("gabor", 1, nullptr, 0, VK_API_VERSION_1_1);
    vk::StructureChain<vk::InstanceCreateInfo, vk::ValidationFeaturesEXT,
                       vk::DebugUtilsMessengerCreateInfoEXT>
        chain;
    chain.get<vk::InstanceCreateInfo>().pApplicationInfo = &application;
    const std::array layers{"VK_LAYER_KHRONOS_validation"};
    std::vector<const char*> extensions = presentation.instance_extensions;
    // GPU-assisted validation makes shaders many times slower. It replaces the other checks, which must not
    // see its buffers.
    using Check = vk::ValidationFeatureEnableEXT;
    const std::vector<Check> features =
        validation() == "gpu" ? std::vector{Check::eGpuAssisted}
        : presentation.can_present // Dear ImGui's backend violates best practices when allocating
            ? std::vector{Check::eSynchronizationValidation}
            : std::vector{Check::eSynchronizationValidation, Check::eBestPractices};
    if (validating()) {
        extensions.insert(extensions.end(),
                          {VK_EXT_DEBUG_UTILS_EXTENSION_NAME, VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME});
        chain.get<vk::InstanceCreateInfo>().setPEnabledLayerNames(layers);
        chain.get<vk::ValidationFeaturesEXT>().setEnabledValidationFeatures(features);
        ask_for_messages(chain.get<vk::DebugUtilsMessengerCreateInfoEXT>()); // about the instance itself
    } else {
        chain.unlink<vk::ValidationFeaturesEXT>();
        chain.unlink<vk::DebugUtilsMessengerCreateInfoEXT>();
    }
    // Only on request does the loader list drivers over Metal. They lack parts of Vulkan that no pass uses.
    if (has(context.enumerateInstanceExtensionProperties(), VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME)) {
        extensions.push_back(VK_KHR_PORTABILITY_ENUMERATION_EXTENSION_NAME);
        chain.get<vk::InstanceCreateInfo>().flags = vk::InstanceCreateFlagBits::eEnumeratePortabilityKHR;
    }
    chain.get<vk::InstanceCreateInfo>().setPEnabledExtensionNames(extensions);
    try {
        return {context, chain.get<vk::InstanceCreateInfo>()};
    } catch (const vk::IncompatibleDriverError&) {
        throw RequestError("no Vulkan driver found: " + how_to_get_a_driver());
    }
}

// Returns a messenger that counts and prints messages of the validation layers; null without them.
vk::raii::DebugUtilsMessengerEXT make_messenger(const vk::raii::Instance& instance) {
    if (!validating())
        return nullptr;
    vk::DebugUtilsMessengerCreateInfoEXT info;
    ask_for_messages(info);
    info.messageType |= vk::DebugUtilsMessageTypeFlagBitsEXT::eGeneral;
    return {instance, info};
}

// ---- The device ----

// The kinds of devices in the order of VkPhysicalDeviceType, and their ranks: the lowest is the best.
constexpr std::array kinds{std::pair{"other", 4}, std::pair{"integrated GPU", 1},
                           std::pair{"discrete GPU", 0}, std::pair{"virtual GPU", 2}, std::pair{"CPU", 3}};

struct Candidate {
    vk::raii::PhysicalDevice physical;
    DeviceInfo info;
    int rank;
    std::uint32_t family;
    std::uint32_t timestamp_bits;
    bool executable_properties;
};

// Before Vulkan 1.2, a device may report only the driver's version number.
std::string driver_name(const vk::raii::PhysicalDevice& physical,
                        const vk::PhysicalDeviceProperties& properties) {
    if (properties.apiVersion < VK_API_VERSION_1_2)
        return fmt::format("version {:#x}", properties.driverVersion);
    const auto chain =
        physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties>();
    const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
    return fmt::format("{} {}", driver.driverName.data(), driver.driverInfo.data());
}

bool has_extension(const vk::raii::PhysicalDevice& physical, std::string_view name) {
    return has(physical.enumerateDeviceExtensionProperties(), name);
}

std::vector<Candidate> candidates(const vk::raii::Instance& instance, const Presentation& presentation) {
    std::vector<Candidate> found;
    vk::raii::PhysicalDevices physicals(nullptr);
    try {
        physicals = vk::raii::PhysicalDevices(instance);
    } catch (const vk::InitializationFailedError&) {
        // the loader reports this if no driver has a device
    }
    for (const vk::raii::PhysicalDevice& physical : physicals) {
        const auto families = physical.getQueueFamilyProperties();
        const auto family = std::ranges::find_if(families, [&](const vk::QueueFamilyProperties& properties) {
            const auto index = static_cast<std::uint32_t>(&properties - families.data());
            const bool computes = static_cast<bool>(properties.queueFlags & vk::QueueFlagBits::eCompute);
            return computes &&
                   (!presentation.can_present || (properties.queueFlags & vk::QueueFlagBits::eGraphics &&
                                                  presentation.can_present(*instance, *physical, index)));
        });
        if (family == families.end() || physical.getProperties().apiVersion < VK_API_VERSION_1_1 ||
            (presentation.can_present && !has_extension(physical, VK_KHR_SWAPCHAIN_EXTENSION_NAME)))
            continue;
        const auto chain =
            physical.getProperties2<vk::PhysicalDeviceProperties2, vk::PhysicalDeviceSubgroupProperties>();
        const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
        DeviceInfo info;
        info.index = static_cast<std::uint32_t>(found.size());
        info.name = properties.deviceName.data();
        const auto type = static_cast<std::size_t>(properties.deviceType);
        const auto [kind, rank] = kinds[type < kinds.size() ? type : 0];
        info.kind = kind;
        info.driver = driver_name(physical, properties);
        info.api = fmt::format("{}.{}.{}", VK_API_VERSION_MAJOR(properties.apiVersion),
                               VK_API_VERSION_MINOR(properties.apiVersion),
                               VK_API_VERSION_PATCH(properties.apiVersion));
        for (const vk::MemoryHeap& heap : physical.getMemoryProperties().memoryHeaps)
            if (heap.flags & vk::MemoryHeapFlagBits::eDeviceLocal)
                info.memory = std::max<std::uint64_t>(info.memory, heap.size);
        info.storage_buffer = properties.limits.maxStorageBufferRange;
        info.group_invocations = properties.limits.maxComputeWorkGroupInvocations;
        info.subgroup = chain.get<vk::PhysicalDeviceSubgroupProperties>().subgroupSize;
        info.timestamps = family->timestampValidBits != 0 && properties.limits.timestampPeriod > 0;
        found.push_back({physical, std::move(info), rank,
                         static_cast<std::uint32_t>(family - families.begin()), family->timestampValidBits,
                         has_extension(physical, VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME)});
    }
    if (found.empty())
        throw RequestError("no Vulkan 1.1 device found: " + how_to_get_a_driver());
    return found;
}

Candidate choose(std::vector<Candidate> all, const std::string& selector) {
    if (selector.empty())
        return std::move(*std::ranges::min_element(all, {}, &Candidate::rank));
    std::vector<std::string> names;
    for (const Candidate& candidate : all)
        names.push_back(fmt::format("{} ({})", candidate.info.index, candidate.info.name));
    const bool is_index = selector.find_first_not_of("0123456789") == selector.npos;
    std::erase_if(all, [&](const Candidate& candidate) {
        return is_index ? fmt::to_string(candidate.info.index) != selector
                        : lower(candidate.info.name).find(lower(selector)) == selector.npos;
    });
    if (all.size() != 1)
        throw RequestError(fmt::format("--device '{}' matches {} device: the devices are {}", selector,
                                       all.empty() ? "no" : "more than one", fmt::join(names, ", ")));
    return std::move(all.front());
}

vk::raii::Device make_device(const Candidate& candidate, const Presentation& presentation) {
    const float priority = 1;
    const vk::DeviceQueueCreateInfo queue({}, candidate.family, 1, &priority);
    vk::StructureChain<vk::DeviceCreateInfo, vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR> chain;
    std::vector<const char*> extensions;
    if (presentation.can_present)
        extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
    if (constexpr const char* subset = "VK_KHR_portability_subset"; // Vulkan wants it enabled where it is
        has_extension(candidate.physical, subset))
        extensions.push_back(subset);
    if (candidate.executable_properties) {
        extensions.push_back(VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME);
        chain.get<vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>().pipelineExecutableInfo =
            VK_TRUE;
    } else {
        chain.unlink<vk::PhysicalDevicePipelineExecutablePropertiesFeaturesKHR>();
    }
    chain.get<vk::DeviceCreateInfo>().setQueueCreateInfos(queue).setPEnabledExtensionNames(extensions);
    return {candidate.physical, chain.get<vk::DeviceCreateInfo>()};
}

std::unique_ptr<Device::State> make_state(const std::string& selector, const Presentation& presentation) {
    vk::raii::Context context = load_vulkan();
    vk::raii::Instance instance = make_instance(context, presentation);
    vk::raii::DebugUtilsMessengerEXT messenger = make_messenger(instance);
    Candidate chosen = choose(candidates(instance, presentation), selector);
    vk::raii::Device device = make_device(chosen, presentation);
    vk::raii::Queue queue(device, chosen.family, 0);
    const double tick = double{chosen.physical.getProperties().limits.timestampPeriod} * 1e-9;
    const std::uint64_t mask =
        chosen.timestamp_bits < 64 ? (std::uint64_t{1} << chosen.timestamp_bits) - 1 : ~std::uint64_t{0};
    constexpr auto shared =
        coherent | vk::MemoryPropertyFlagBits::eHostCached | vk::MemoryPropertyFlagBits::eDeviceLocal;
    const bool unified = std::ranges::any_of(
        chosen.physical.getMemoryProperties().memoryTypes, // unused entries have no flags
        [&](const vk::MemoryType& type) { return (type.propertyFlags & shared) == shared; });
    return std::unique_ptr<Device::State>(
        new Device::State{std::move(context), std::move(instance), std::move(messenger),
                          std::move(chosen.physical), chosen.info, chosen.family, std::move(device),
                          std::move(queue), tick, mask, unified, chosen.executable_properties});
}

} // namespace

int validation_messages() {
    return messages;
}

bool out_of_memory(const std::error_code& code) {
    return code == vk::Result::eErrorOutOfDeviceMemory || code == vk::Result::eErrorOutOfHostMemory;
}

std::vector<DeviceInfo> devices() {
    const vk::raii::Context context = load_vulkan();
    const vk::raii::Instance instance = make_instance(context, {});
    std::vector<DeviceInfo> result;
    for (Candidate& candidate : candidates(instance, {}))
        result.push_back(std::move(candidate.info));
    return result;
}

Device::Device(const std::string& selector, const Presentation& presentation)
    : state_(make_state(selector, presentation)) {}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;

const DeviceInfo& Device::info() const {
    return state_->info;
}

bool Device::unified() const {
    return state_->unified;
}

} // namespace gabor::vulkan

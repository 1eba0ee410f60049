// A Vulkan layer that makes one device function fail, chosen by GABOR_FAULT: `vkAllocateMemory:3` fails the
// third call and all later ones. Functions that allocate report that device memory is exhausted; functions
// that execute report a lost device. GABOR_FAULT_TYPES, such as `42`, gives devices these
// VkPhysicalDeviceTypes, a digit each, in the order in which the program asks for them, and calls them
// "device 0", "device 1", ....

#include <vulkan/vk_layer.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

PFN_vkGetInstanceProcAddr next_instance_function = nullptr;
PFN_vkGetDeviceProcAddr next_device_function = nullptr;

PFN_vkGetPhysicalDeviceProperties next_properties = nullptr; // of the program's only instance
PFN_vkGetPhysicalDeviceProperties2 next_properties_2 = nullptr;

VkDevice device = VK_NULL_HANDLE; // the program creates only one

template <typename Function>
Function next(const char* name) {
    return reinterpret_cast<Function>(next_device_function(device, name));
}

// Returns whether this call must fail.
bool fails(std::string_view name) {
    static const std::string fault = [] {
        const char* value = std::getenv("GABOR_FAULT");
        return std::string(value ? value : "");
    }();
    static std::atomic<int> calls = 0;
    const std::size_t colon = fault.find(':');
    return colon != std::string::npos && fault.substr(0, colon) == name &&
           ++calls >= std::atoi(fault.c_str() + colon + 1);
}

// A device function that can fail.
struct Fault {
    const char* name;
    VkResult failure;
};
constexpr Fault allocation{"vkAllocateMemory", VK_ERROR_OUT_OF_DEVICE_MEMORY};
constexpr Fault pipeline{"vkCreateComputePipelines", VK_ERROR_OUT_OF_DEVICE_MEMORY};
constexpr Fault submission{"vkQueueSubmit", VK_ERROR_DEVICE_LOST};
constexpr Fault wait{"vkWaitForFences", VK_ERROR_DEVICE_LOST};

template <const Fault& fault, typename Function>
struct Failing;
template <const Fault& fault, typename... Arguments>
struct Failing<fault, VkResult(VKAPI_PTR*)(Arguments...)> {
    static VKAPI_ATTR VkResult VKAPI_CALL call(Arguments... arguments) {
        if (!fails(fault.name))
            return next<VkResult(VKAPI_PTR*)(Arguments...)>(fault.name)(arguments...);
        next<PFN_vkDeviceWaitIdle>("vkDeviceWaitIdle")(device); // so that nothing in use is freed afterwards
        return fault.failure;
    }
};

// Finds the loader's link to the next layer in a chain of structures, and advances it for that layer.
template <typename Link, typename Info>
auto take_link(const Info* info, VkStructureType type) {
    auto* link = const_cast<Link*>(static_cast<const Link*>(info->pNext));
    while (link->sType != type || link->function != VK_LAYER_LINK_INFO)
        link = const_cast<Link*>(static_cast<const Link*>(link->pNext));
    const auto* layer = link->u.pLayerInfo;
    link->u.pLayerInfo = layer->pNext;
    return layer;
}

VKAPI_ATTR VkResult VKAPI_CALL create_instance(const VkInstanceCreateInfo* info,
                                               const VkAllocationCallbacks* callbacks, VkInstance* created) {
    const auto* layer =
        take_link<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_instance_function = layer->pfnNextGetInstanceProcAddr;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(next_instance_function(nullptr, "vkCreateInstance"));
    const VkResult result = create(info, callbacks, created);
    if (result == VK_SUCCESS) {
        next_properties = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties>(
            next_instance_function(*created, "vkGetPhysicalDeviceProperties"));
        next_properties_2 = reinterpret_cast<PFN_vkGetPhysicalDeviceProperties2>(
            next_instance_function(*created, "vkGetPhysicalDeviceProperties2"));
    }
    return result;
}

// Replaces the type and the name of a device.
void retype(VkPhysicalDevice physical, VkPhysicalDeviceProperties& properties) {
    static std::vector<VkPhysicalDevice> seen;
    const char* types = std::getenv("GABOR_FAULT_TYPES");
    if (!types)
        return;
    if (std::ranges::find(seen, physical) == seen.end())
        seen.push_back(physical);
    const auto index = static_cast<std::size_t>(std::ranges::find(seen, physical) - seen.begin());
    if (index < std::strlen(types)) {
        properties.deviceType = static_cast<VkPhysicalDeviceType>(types[index] - '0');
        std::snprintf(properties.deviceName, sizeof properties.deviceName, "device %zu", index);
    }
}

VKAPI_ATTR void VKAPI_CALL get_properties(VkPhysicalDevice physical, VkPhysicalDeviceProperties* properties) {
    next_properties(physical, properties);
    retype(physical, *properties);
}

VKAPI_ATTR void VKAPI_CALL get_properties_2(VkPhysicalDevice physical,
                                            VkPhysicalDeviceProperties2* properties) {
    next_properties_2(physical, properties);
    retype(physical, properties->properties);
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* callbacks, VkDevice* created) {
    const auto* layer = take_link<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device_function = layer->pfnNextGetDeviceProcAddr;
    if (fails("vkCreateDevice"))
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        layer->pfnNextGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
    const VkResult result = create(physical, info, callbacks, created);
    device = *created;
    return result;
}

template <typename Function>
PFN_vkVoidFunction any(Function* function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

PFN_vkVoidFunction own_function(std::string_view name) {
    const std::pair<const Fault&, PFN_vkVoidFunction> own[]{
        {allocation, any(Failing<allocation, PFN_vkAllocateMemory>::call)},
        {pipeline, any(Failing<pipeline, PFN_vkCreateComputePipelines>::call)},
        {submission, any(Failing<submission, PFN_vkQueueSubmit>::call)},
        {wait, any(Failing<wait, PFN_vkWaitForFences>::call)}};
    for (const auto& [fault, function] : own)
        if (name == fault.name)
            return function;
    return nullptr;
}

} // namespace

extern "C" {

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetDeviceProcAddr(VkDevice of, const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return any(vkGetDeviceProcAddr);
    const PFN_vkVoidFunction own = own_function(name);
    return own ? own : next_device_function(of, name);
}

VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance of, const char* name) {
    const std::string_view wanted = name;
    if (wanted == "vkGetInstanceProcAddr")
        return any(vkGetInstanceProcAddr);
    if (wanted == "vkGetDeviceProcAddr")
        return any(vkGetDeviceProcAddr);
    if (wanted == "vkCreateInstance")
        return any(create_instance);
    if (wanted == "vkCreateDevice")
        return any(create_device);
    if (wanted == "vkGetPhysicalDeviceProperties")
        return any(get_properties);
    if (wanted == "vkGetPhysicalDeviceProperties2")
        return any(get_properties_2);
    return next_instance_function ? next_instance_function(of, name) : nullptr;
}
}

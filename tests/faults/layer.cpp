// A Vulkan layer that makes one device function fail, chosen by GABOR_FAULT: `vkAllocateMemory:3` fails the
// third call and all later ones. Functions that allocate report that device memory is exhausted; functions
// that execute report a lost device.

#include <vulkan/vk_layer.h>

#include <atomic>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

namespace {

PFN_vkGetInstanceProcAddr next_instance_function = nullptr;
PFN_vkGetDeviceProcAddr next_device_function = nullptr;

template <typename Function>
Function next(VkDevice device, const char* name) {
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

VKAPI_ATTR VkResult VKAPI_CALL allocate_memory(VkDevice device, const VkMemoryAllocateInfo* info,
                                               const VkAllocationCallbacks* callbacks,
                                               VkDeviceMemory* memory) {
    if (fails("vkAllocateMemory"))
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    return next<PFN_vkAllocateMemory>(device, "vkAllocateMemory")(device, info, callbacks, memory);
}

VKAPI_ATTR VkResult VKAPI_CALL create_pipelines(VkDevice device, VkPipelineCache cache, std::uint32_t count,
                                                const VkComputePipelineCreateInfo* infos,
                                                const VkAllocationCallbacks* callbacks,
                                                VkPipeline* pipelines) {
    if (fails("vkCreateComputePipelines"))
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    return next<PFN_vkCreateComputePipelines>(device, "vkCreateComputePipelines")(device, cache, count, infos,
                                                                                  callbacks, pipelines);
}

VkDevice queues_device = VK_NULL_HANDLE; // the program creates only one device

VKAPI_ATTR VkResult VKAPI_CALL queue_submit(VkQueue queue, std::uint32_t count, const VkSubmitInfo* submits,
                                            VkFence fence) {
    if (fails("vkQueueSubmit"))
        return VK_ERROR_DEVICE_LOST;
    return next<PFN_vkQueueSubmit>(queues_device, "vkQueueSubmit")(queue, count, submits, fence);
}

VKAPI_ATTR VkResult VKAPI_CALL wait_for_fences(VkDevice device, std::uint32_t count, const VkFence* fences,
                                               VkBool32 all, std::uint64_t timeout) {
    // Wait for running work, so that nothing in use is freed afterwards.
    const VkResult result =
        next<PFN_vkWaitForFences>(device, "vkWaitForFences")(device, count, fences, all, timeout);
    return fails("vkWaitForFences") ? VK_ERROR_DEVICE_LOST : result;
}

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
                                               const VkAllocationCallbacks* callbacks, VkInstance* instance) {
    const auto* layer =
        take_link<VkLayerInstanceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    next_instance_function = layer->pfnNextGetInstanceProcAddr;
    const auto create =
        reinterpret_cast<PFN_vkCreateInstance>(next_instance_function(nullptr, "vkCreateInstance"));
    return create(info, callbacks, instance);
}

VKAPI_ATTR VkResult VKAPI_CALL create_device(VkPhysicalDevice physical, const VkDeviceCreateInfo* info,
                                             const VkAllocationCallbacks* callbacks, VkDevice* device) {
    const auto* layer = take_link<VkLayerDeviceCreateInfo>(info, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    next_device_function = layer->pfnNextGetDeviceProcAddr;
    if (fails("vkCreateDevice"))
        return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    const auto create = reinterpret_cast<PFN_vkCreateDevice>(
        layer->pfnNextGetInstanceProcAddr(VK_NULL_HANDLE, "vkCreateDevice"));
    const VkResult result = create(physical, info, callbacks, device);
    queues_device = *device;
    return result;
}

template <typename Function>
PFN_vkVoidFunction any(Function* function) {
    return reinterpret_cast<PFN_vkVoidFunction>(function);
}

PFN_vkVoidFunction own_function(std::string_view name) {
    if (name == "vkAllocateMemory")
        return any(allocate_memory);
    if (name == "vkCreateComputePipelines")
        return any(create_pipelines);
    if (name == "vkQueueSubmit")
        return any(queue_submit);
    if (name == "vkWaitForFences")
        return any(wait_for_fences);
    return nullptr;
}

} // namespace

extern "C" {

VK_LAYER_EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetDeviceProcAddr(VkDevice device,
                                                                             const char* name) {
    if (std::strcmp(name, "vkGetDeviceProcAddr") == 0)
        return any(vkGetDeviceProcAddr);
    const PFN_vkVoidFunction own = own_function(name);
    return own ? own : next_device_function(device, name);
}

VK_LAYER_EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL vkGetInstanceProcAddr(VkInstance instance,
                                                                               const char* name) {
    const std::string_view wanted = name;
    if (wanted == "vkGetInstanceProcAddr")
        return any(vkGetInstanceProcAddr);
    if (wanted == "vkGetDeviceProcAddr")
        return any(vkGetDeviceProcAddr);
    if (wanted == "vkCreateInstance")
        return any(create_instance);
    if (wanted == "vkCreateDevice")
        return any(create_device);
    return next_instance_function ? next_instance_function(instance, name) : nullptr;
}
}

#include "vulkan/state.hpp"

#include "error.hpp"

#include <fmt/format.h>
#include <spirv-tools/optimizer.hpp>

#include <ctime>
#include <limits>
#include <tuple>
#include <unordered_map>

namespace gabor::vulkan {

namespace {

using Words = std::vector<std::uint32_t>;

// Returns the module as if it had been compiled with these constants. Without this, SwiftShader would keep
// the branches that they exclude, and lavapipe would compile many of them.
Words specialized(std::span<const std::uint32_t> spirv, std::span<const std::uint32_t> constants,
                  bool optimized) {
    std::unordered_map<std::uint32_t, Words> values;
    for (std::uint32_t id = 0; id < constants.size(); ++id)
        values[id] = {constants[id]};
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_1);
    std::string messages;
    optimizer.SetMessageConsumer([&messages](spv_message_level_t, const char*, const spv_position_t&,
                                             const char* message) { messages += message; });
    optimizer.RegisterPass(spvtools::CreateSetSpecConstantDefaultValuePass(values))
        .RegisterPass(spvtools::CreateFreezeSpecConstantValuePass())
        .RegisterPass(spvtools::CreateFoldSpecConstantOpAndCompositePass())
        .RegisterPass(spvtools::CreateCCPPass())
        .RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass())
        .RegisterPass(spvtools::CreateAggressiveDCEPass());
    if (optimized)
        optimizer.RegisterPerformancePasses();
    spvtools::OptimizerOptions options;
    options.set_run_validator(false); // glslang's output is valid
    Words result;
    if (!optimizer.Run(spirv.data(), spirv.size(), &result, options))
        throw std::runtime_error("SPIRV-Tools cannot specialize a pass: " + messages);
    return result;
}

vk::DescriptorType type_of(const Pass::Interface& interface, std::uint32_t binding) {
    return interface.uniform && binding + 1 == interface.buffers ? vk::DescriptorType::eUniformBuffer
                                                                 : vk::DescriptorType::eStorageBuffer;
}

} // namespace

Pass::Pass(const Device& device, std::span<const std::uint32_t> spirv, Interface interface,
           std::span<const std::uint32_t> constants)
    : state_(std::make_unique<State>()) {
    const vk::raii::Device& logical = device.state().device;
    state_->interface = interface;

    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    for (std::uint32_t i = 0; i < interface.buffers; ++i)
        bindings.emplace_back(i, type_of(interface, i), 1, vk::ShaderStageFlagBits::eCompute);
    state_->set_layout =
        vk::raii::DescriptorSetLayout(logical, vk::DescriptorSetLayoutCreateInfo({}, bindings));

    const vk::PushConstantRange push(vk::ShaderStageFlagBits::eCompute, 0, interface.push_bytes);
    vk::PipelineLayoutCreateInfo layout({}, *state_->set_layout);
    if (interface.push_bytes)
        layout.setPushConstantRanges(push);
    state_->layout = vk::raii::PipelineLayout(logical, layout);

    const Words words = specialized(spirv, constants, interface.optimized);
    const vk::raii::ShaderModule module(logical, {{}, words.size() * sizeof(words.front()), words.data()});
    const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute, *module, "main");
    const auto flags = interface.statistics && device.state().executable_properties
                           ? vk::PipelineCreateFlagBits::eCaptureStatisticsKHR
                           : vk::PipelineCreateFlagBits{};
    const std::clock_t start = std::clock();
    state_->pipeline =
        vk::raii::Pipeline(logical, nullptr, vk::ComputePipelineCreateInfo(flags, stage, *state_->layout));
    state_->seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

double Pass::seconds() const {
    return state_->seconds;
}

Pass::~Pass() = default;
Pass::Pass(Pass&&) noexcept = default;
Pass& Pass::operator=(Pass&&) noexcept = default;

std::map<std::string, std::uint64_t> Pass::statistics(const Device& device) const {
    if (!device.state().executable_properties)
        throw RequestError(fmt::format("{} does not report compiler statistics: use a driver with "
                                       "VK_KHR_pipeline_executable_properties, such as RADV",
                                       device.info().name));
    std::map<std::string, std::uint64_t> result;
    for (const vk::PipelineExecutableStatisticKHR& statistic :
         device.state().device.getPipelineExecutableStatisticsKHR({*state_->pipeline, 0}))
        if (statistic.format == vk::PipelineExecutableStatisticFormatKHR::eUint64)
            result.emplace(statistic.name.data(), statistic.value.u64);
    return result;
}

struct Job::State {
    const Device::State& device;
    const Pass::State& pass;
    vk::raii::DescriptorPool descriptors = nullptr;
    vk::raii::DescriptorSet set = nullptr;
    vk::raii::CommandPool pool = nullptr;
    vk::raii::CommandBuffer commands = nullptr;
    vk::raii::QueryPool queries = nullptr;
    vk::raii::Fence fence = nullptr;
    bool under_way = false;
};

Job::Job(const Device& device, const Pass& pass, const Buffers& buffers)
    : state_(new State{device.state(), pass.state()}) {
    const vk::raii::Device& logical = device.state().device;
    std::vector<vk::DescriptorPoolSize> sizes;
    for (std::uint32_t i = 0; i < buffers.size(); ++i)
        sizes.emplace_back(type_of(pass.state().interface, i), 1);
    state_->descriptors = vk::raii::DescriptorPool(
        logical,
        vk::DescriptorPoolCreateInfo(vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes));
    vk::raii::DescriptorSets sets(
        logical, vk::DescriptorSetAllocateInfo(*state_->descriptors, *pass.state().set_layout));
    state_->set = std::move(sets.front());

    for (std::uint32_t i = 0; i < buffers.size(); ++i) {
        const vk::DescriptorBufferInfo info(*buffers[i].get().state().buffer, 0, VK_WHOLE_SIZE);
        logical.updateDescriptorSets(
            vk::WriteDescriptorSet(*state_->set, i, 0, type_of(pass.state().interface, i), {}, info), {});
    }

    state_->pool = vk::raii::CommandPool(logical, {{}, device.state().family});
    vk::raii::CommandBuffers commands(logical, {*state_->pool, vk::CommandBufferLevel::ePrimary, 1});
    state_->commands = std::move(commands.front());
    if (device.info().timestamps)
        state_->queries = vk::raii::QueryPool(logical, {{}, vk::QueryType::eTimestamp, 2});
    state_->fence = vk::raii::Fence(logical, vk::FenceCreateInfo());
}

Job::~Job() {
    // The device may still use the buffers. A lost device has nothing to wait for.
    if (state_ && state_->under_way)
        try {
            wait();
        } catch (const vk::SystemError&) {
        }
}

Job::Job(Job&&) noexcept = default;

void Job::submit(std::span<const Dispatch> dispatches, const std::optional<Copy>& copy) {
    using Access = vk::AccessFlagBits;
    using Stage = vk::PipelineStageFlagBits;
    const vk::raii::CommandBuffer& commands = state_->commands;
    const bool timed = state_->device.info.timestamps;
    state_->pool.reset();
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    if (timed) {
        commands.resetQueryPool(*state_->queries, 0, 2);
        commands.writeTimestamp(Stage::eTopOfPipe, *state_->queries, 0);
    }
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *state_->pass.layout, 0, *state_->set, {});
    for (const Dispatch& dispatch : dispatches) {
        if (&dispatch != dispatches.data())
            commands.pipelineBarrier(
                Stage::eComputeShader, Stage::eComputeShader, {},
                vk::MemoryBarrier(Access::eShaderWrite, Access::eShaderRead | Access::eShaderWrite), {}, {});
        const Pass::State& pass = dispatch.other ? dispatch.other->state() : state_->pass;
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pass.pipeline);
        if (!dispatch.push.empty())
            commands.pushConstants<std::byte>(
                *state_->pass.layout, vk::ShaderStageFlagBits::eCompute, 0,
                vk::ArrayProxy<const std::byte>(static_cast<std::uint32_t>(dispatch.push.size()),
                                                dispatch.push.data()));
        commands.dispatch(dispatch.groups.x, dispatch.groups.y, dispatch.groups.z);
    }
    if (timed)
        commands.writeTimestamp(Stage::eComputeShader, *state_->queries, 1);
    if (copy) {
        commands.pipelineBarrier(Stage::eComputeShader, Stage::eTransfer, {},
                                 vk::MemoryBarrier(Access::eShaderWrite, Access::eTransferRead), {}, {});
        commands.copyBuffer(*copy->from.state().buffer, *copy->to.state().buffer,
                            vk::BufferCopy(0, 0, copy->bytes));
    }
    commands.pipelineBarrier(
        Stage::eComputeShader | Stage::eTransfer, Stage::eHost, {},
        vk::MemoryBarrier(Access::eShaderWrite | Access::eTransferWrite, Access::eHostRead), {}, {});
    commands.end();
    state_->device.queue.submit(vk::SubmitInfo({}, {}, *commands), *state_->fence);
    state_->under_way = true;
}

double Job::wait() {
    state_->under_way = false;
    const vk::raii::Device& logical = state_->device.device;
    std::ignore = logical.waitForFences(*state_->fence, VK_TRUE, std::numeric_limits<std::uint64_t>::max());
    logical.resetFences(*state_->fence);
    if (!state_->device.info.timestamps)
        return std::numeric_limits<double>::quiet_NaN();
    const auto [result, ticks] = state_->queries.getResults<std::uint64_t>(
        0, 2, 2 * sizeof(std::uint64_t), sizeof(std::uint64_t), vk::QueryResultFlagBits::e64);
    return static_cast<double>((ticks[1] - ticks[0]) & state_->device.timestamp_mask) *
           state_->device.timestamp_seconds;
}

} // namespace gabor::vulkan

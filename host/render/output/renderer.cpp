#include "render/output/renderer.hpp"

#include "passes/pictures.h"
#include "seconds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace gabor::render {

namespace {

constexpr std::size_t band_bytes = std::size_t{16} << 20;
// The device takes about this long for each band, so that the work ends soon after a sink throws.
constexpr double band_seconds = 0.1;
constexpr int first_pixels = 1 << 14;      // of the first band, whose cost is unknown
constexpr double most_growth = 4;          // from one band to the next
constexpr std::size_t most_pipelines = 16; // lavapipe uses a megabyte for each

// A band's memory on the device, and the job that fills it.
class BandBuffer {
  public:
    BandBuffer(const vulkan::Device& device, const Renderer& renderer, int rows)
        : row_values_(static_cast<std::size_t>(renderer.plan().width) * renderer.plan().channels.size()),
          values_(device, static_cast<std::size_t>(rows) * row_values_ * sizeof(float),
                  values_memory(device)),
          source_(renderer.plan().source.width == 0
                      ? std::nullopt
                      : std::optional<vulkan::Buffer>(std::in_place, device,
                                                      renderer.plan().source.values(rows) * sizeof(float),
                                                      vulkan::Memory::upload)),
          job_(renderer.job(values_, source_ ? &*source_ : nullptr)) {
        if (!device.unified())
            staging_.emplace(device, values_.size(), vulkan::Memory::readback);
    }

    void submit(const Renderer& renderer, const Band& band, const Fill& fill) {
        if (source_)
            fill(source_->as<float>().first(renderer.plan().source.values(band.rows)));
        count_ = static_cast<std::size_t>(band.rows) * row_values_;
        submitted_ = Clock::now();
        std::optional<vulkan::Job::Copy> copy;
        if (staging_)
            copy.emplace(vulkan::Job::Copy{values_, *staging_, count_ * sizeof(float)});
        renderer.submit(job_, band, 0, copy);
    }

    // Returns the seconds that the band took.
    double wait() {
        const double seconds = job_.wait();
        return std::isnan(seconds) ? seconds_since(submitted_) : seconds;
    }
    std::span<const float> values() const {
        return (staging_ ? *staging_ : values_).as<float>().first(count_);
    }

  private:
    std::size_t row_values_;
    vulkan::Buffer values_;
    std::optional<vulkan::Buffer> source_;
    std::optional<vulkan::Buffer> staging_; // used if the host cannot read the device's memory
    vulkan::Job job_;
    std::size_t count_ = 0;
    Clock::time_point submitted_;
};

} // namespace

vulkan::Memory values_memory(const vulkan::Device& device) {
    return device.unified() ? vulkan::Memory::readback : vulkan::Memory::device;
}

DeviceKind kind_of(const vulkan::Device& device) {
    return device.info().kind == "CPU" ? DeviceKind::cpu : DeviceKind::gpu;
}

vulkan::Pass make_pass(const vulkan::Device& device, const Plan& plan, const Step& step, bool statistics) {
    const auto found = std::ranges::find(passes::pictures, step.shader, &passes::Module::name);
    return {device,
            found->spirv,
            {static_cast<std::uint32_t>(plan.tables.size() + (plan.source.width > 0 ? 2 : 1)),
             static_cast<std::uint32_t>(step.push.size()), statistics},
            step.constants};
}

Renderer::Renderer(const vulkan::Device& device, Plan plan) : device_(device) {
    set(std::move(plan));
}

void Renderer::set(Plan plan) {
    plan_ = std::move(plan);
    if (passes_.size() > most_pipelines)
        passes_.clear();
    of_steps_.clear();
    for (const Step& step : plan_.steps) {
        const std::pair key(step.shader, step.constants);
        auto found = passes_.find(key);
        if (found == passes_.end())
            found = passes_.emplace(key, make_pass(device_, plan_, step)).first;
        of_steps_.push_back(&found->second);
    }
    for (std::size_t i = 0; i < plan_.tables.size(); ++i) {
        const Bytes& table = plan_.tables[i];
        if (i == tables_.size())
            tables_.emplace_back(device_, table.size(), vulkan::Memory::upload);
        else if (tables_[i].size() < table.size())
            tables_[i] = vulkan::Buffer(device_, table.size(), vulkan::Memory::upload);
        std::ranges::copy(table, tables_[i].as<std::byte>().begin());
    }
}

vulkan::Job Renderer::job(const vulkan::Buffer& values, const vulkan::Buffer* source) const {
    vulkan::Job::Buffers buffers{values};
    buffers.insert(buffers.end(), tables_.begin(),
                   tables_.begin() + static_cast<std::ptrdiff_t>(plan_.tables.size()));
    if (source)
        buffers.push_back(*source);
    return {device_, *of_steps_.front(), buffers};
}

void Renderer::submit(vulkan::Job& job, const Band& band, int before,
                      const std::optional<vulkan::Job::Copy>& copy) const {
    std::vector<Bytes> pushes;
    std::vector<vulkan::Job::Dispatch> dispatches;
    pushes.reserve(plan_.steps.size());
    for (const Step& step : plan_.steps) {
        Bytes& push = pushes.emplace_back(step.push);
        passes::Band pushed{};
        std::memcpy(&pushed, push.data(), sizeof pushed);
        pushed.first_row += band.first_row;
        pushed.height = band.rows;
        pushed.before = before;
        std::uint32_t rows = groups(band.rows, static_cast<std::uint32_t>(step.group.rows));
        if (!step.runs.empty()) {
            const auto end = [](const auto& run) { return run.first + run.second; };
            const auto first = std::ranges::upper_bound(step.runs, band.first_row, {}, end);
            const auto last = std::ranges::lower_bound(step.runs, band.first_row + band.rows, {},
                                                       &std::pair<int, int>::first);
            pushed.first_run += static_cast<std::uint32_t>(first - step.runs.begin());
            rows = static_cast<std::uint32_t>(last - first);
        }
        std::memcpy(push.data(), &pushed, sizeof pushed);
        dispatches.push_back({push,
                              {groups(step.across, static_cast<std::uint32_t>(step.group.columns)), rows},
                              of_steps_[dispatches.size()]});
    }
    job.submit(dispatches, copy);
}

void render_region(const vulkan::Device& device, const Request& request, const image::Rect& region,
                   const Sink& sink, bool normals) {
    Viewport viewport = viewport_of(request, region);
    viewport.normals = normals;
    const Renderer renderer(device, plan(request, viewport, load_paint(request.paint), kind_of(device)));
    render_plan(device, renderer, sink);
}

void render_plan(const vulkan::Device& device, const Renderer& renderer, const Sink& sink, const Fill& fill) {
    const Plan& plan = renderer.plan();
    const std::size_t row_values = std::max(static_cast<std::size_t>(plan.width) * plan.channels.size(),
                                            static_cast<std::size_t>(plan.source.width));
    const std::size_t limit = std::min<std::size_t>(band_bytes, device.info().storage_buffer);
    const int fitting = std::max(1, static_cast<int>(limit / (row_values * sizeof(float))));
    const int most_rows = most_rows_of_a_band(plan, fitting);
    std::array<BandBuffer, 2> buffers{BandBuffer(device, renderer, most_rows),
                                      BandBuffer(device, renderer, most_rows)};

    Band band = band_at(plan, 0, std::clamp(first_pixels / plan.width, 1, fitting));
    buffers[0].submit(renderer, band, fill);
    for (std::size_t i = 0; band.rows > 0; ++i) {
        const double growth = std::min(band_seconds / buffers[i % 2].wait(), most_growth);
        const int end = band.first_row + band.rows;
        band = end == plan.height
                   ? Band{}
                   : band_at(plan, end, std::clamp(static_cast<int>(band.rows * growth), 1, fitting));
        if (band.rows > 0)
            buffers[(i + 1) % 2].submit(renderer, band, fill);
        sink(buffers[i % 2].values());
    }
}

} // namespace gabor::render

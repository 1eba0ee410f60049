#include "render/bands.hpp"

#include "render/filler.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>

namespace gabor::render {

namespace {

constexpr std::size_t band_bytes = std::size_t{16} << 20;

// A band's memory on the device, and the job that fills it.
class BandBuffer {
  public:
    BandBuffer(const vulkan::Device& device, const Filler& filler, std::size_t bytes)
        : result_(device, bytes, device.unified() ? vulkan::Memory::readback : vulkan::Memory::device),
          job_(filler.job(device, result_)) {
        if (!device.unified())
            staging_.emplace(device, bytes, vulkan::Memory::readback);
    }

    void submit(const Filler& filler, const Filler::Band& band, std::size_t values) {
        values_ = values;
        std::optional<vulkan::Job::Copy> copy;
        if (staging_)
            copy.emplace(vulkan::Job::Copy{result_, *staging_, values * sizeof(float)});
        filler.submit(job_, band, copy);
    }

    double wait() { return job_.wait(); }
    std::span<const float> values() const {
        return (staging_ ? *staging_ : result_).as<float>().first(values_);
    }

  private:
    vulkan::Buffer result_;
    std::optional<vulkan::Buffer> staging_; // where the host cannot read the device's memory
    vulkan::Job job_;
    std::size_t values_ = 0;
};

} // namespace

Times render_bands(const vulkan::Device& device, const Picture& picture, const image::Window& region,
                   const std::function<void(std::span<const float>)>& sink) {
    using Clock = std::chrono::steady_clock;
    const auto seconds_since = [](Clock::time_point start) {
        return std::chrono::duration<double>(Clock::now() - start).count();
    };
    const Clock::time_point start = Clock::now();

    const std::unique_ptr<Filler> filler = make_filler(device, picture, region);
    const std::size_t row_values = static_cast<std::size_t>(region.width) * channels(picture).size();
    const std::size_t limit = std::min<std::size_t>(band_bytes, device.info().storage_buffer);
    const int fitting = static_cast<int>(limit / (row_values * sizeof(float)));
    const std::vector<Filler::Band> bands = filler->bands(fitting);
    const auto values = [&](const Filler::Band& band) {
        return static_cast<std::size_t>(band.rows) * row_values;
    };
    const int most_rows = std::ranges::max(bands, {}, &Filler::Band::rows).rows;
    const std::size_t bytes = static_cast<std::size_t>(most_rows) * row_values * sizeof(float);
    std::array<BandBuffer, 2> buffers{BandBuffer(device, *filler, bytes), BandBuffer(device, *filler, bytes)};

    Times times;
    buffers[0].submit(*filler, bands[0], values(bands[0]));
    times.first_dispatch = seconds_since(start);
    for (std::size_t i = 0; i < bands.size(); ++i) {
        const Clock::time_point before = Clock::now();
        times.gpu += buffers[i % 2].wait();
        times.waiting += seconds_since(before);
        if (i + 1 < bands.size())
            buffers[(i + 1) % 2].submit(*filler, bands[i + 1], values(bands[i + 1]));
        sink(buffers[i % 2].values());
    }
    return times;
}

} // namespace gabor::render

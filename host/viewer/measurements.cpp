#include "viewer/measurements.hpp"

#include "statistics/spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::viewer {

namespace {

std::vector<float> first_channel(std::span<const float> values, int channels, int coverage = -1) {
    std::vector<float> result;
    result.reserve(values.size() / static_cast<std::size_t>(channels));
    for (std::size_t i = 0; i < values.size(); i += static_cast<std::size_t>(channels))
        if (coverage < 0 || values[i + static_cast<std::size_t>(coverage)] > 0)
            result.push_back(values[i]);
    return result;
}

// The half plane that the periodogram has, as a whole plane with frequency 0 in the middle.
std::optional<MeasuredSpectrum> spectrum_of(std::span<const float> values, Extent extent, double scale) {
    if (!statistics::segment_side(extent.width, extent.height))
        return {};
    statistics::Spectrum spectrum(extent.width, extent.height);
    double mean = 0;
    for (const float value : values)
        mean += value;
    mean /= static_cast<double>(values.size());
    const auto width = static_cast<std::size_t>(extent.width);
    std::vector<float> row(width);
    for (std::size_t start = 0; start < values.size(); start += width) {
        std::ranges::transform(values.subspan(start, width), row.begin(),
                               [&](float value) { return static_cast<float>(value - mean); });
        spectrum.add_row(row);
    }
    const std::vector<double> half = spectrum.periodogram();
    const int side = spectrum.side();
    const auto power = [&](int fx, int fy) {
        if (fx < 0) {
            fx = -fx;
            fy = -fy;
        }
        const int rows = (fy + side) % side;
        return half[static_cast<std::size_t>(rows) * static_cast<std::size_t>(side / 2 + 1) +
                    static_cast<std::size_t>(fx)];
    };
    const double strongest = std::max(*std::ranges::max_element(half), 1e-30);
    MeasuredSpectrum result{side, scale / side, {}};
    result.decibels.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            result.decibels.push_back(static_cast<float>(
                10 * std::log10(std::max(power(x - side / 2, y - side / 2) / strongest, 1e-12))));
    return result;
}

} // namespace

MeasuringThread::MeasuringThread() : thread_([this] { work(); }) {}

MeasuringThread::~MeasuringThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
        tasks_.clear();
    }
    wake_.notify_one();
    thread_.join();
}

void MeasuringThread::reset() {
    const std::lock_guard lock(mutex_);
    ++generation_;
    tasks_.clear();
    // The spectrum stays in view until there is another.
    std::optional<MeasuredSpectrum> spectrum = std::move(measured_.spectrum);
    measured_ = {};
    measured_.spectrum = std::move(spectrum);
    gaussianity_ = statistics::Gaussianity();
}

void MeasuringThread::post(Task task) {
    {
        const std::lock_guard lock(mutex_);
        task.generation = generation_;
        tasks_.push_back(std::move(task));
    }
    wake_.notify_one();
}

void MeasuringThread::add_samples(std::span<const float> values, int channels, int coverage) {
    post({0, first_channel(values, channels, coverage), {}, 1});
}

void MeasuringThread::add_picture(std::span<const float> values, int channels, Extent extent, double scale) {
    post({0, first_channel(values, channels), extent, scale});
}

Measurements MeasuringThread::measured() const {
    const std::lock_guard lock(mutex_);
    return measured_;
}

bool MeasuringThread::idle() const {
    const std::lock_guard lock(mutex_);
    return tasks_.empty() && !busy_;
}

void MeasuringThread::work() {
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [this] { return ending_ || !tasks_.empty(); });
        if (ending_)
            return;
        const Task task = std::move(tasks_.front());
        tasks_.pop_front();
        busy_ = true;
        lock.unlock();
        measure(task);
        lock.lock();
        busy_ = false;
    }
}

void MeasuringThread::measure(const Task& task) {
    if (task.extent.width > 0) {
        std::optional<MeasuredSpectrum> spectrum = spectrum_of(task.values, task.extent, task.scale);
        const std::lock_guard lock(mutex_);
        if (task.generation == generation_)
            measured_.spectrum = std::move(spectrum);
        return;
    }
    statistics::Moments moments;
    statistics::Gaussianity gaussianity;
    std::array<std::uint64_t, histogram_bars> histogram{};
    for (const float value : task.values) {
        if (!std::isfinite(value))
            continue;
        moments.add(value);
        gaussianity.add(value);
        const double bar = (value / histogram_end + 1) * histogram_bars / 2;
        if (bar >= 0 && bar < histogram_bars)
            ++histogram[static_cast<std::size_t>(bar)];
    }
    const std::lock_guard lock(mutex_);
    if (task.generation != generation_)
        return;
    measured_.moments.merge(moments);
    gaussianity_.merge(gaussianity);
    measured_.cvm = gaussianity_.index();
    std::ranges::transform(measured_.histogram, histogram, measured_.histogram.begin(), std::plus());
}

} // namespace gabor::viewer

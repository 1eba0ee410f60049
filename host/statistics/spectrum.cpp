#include "statistics/spectrum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>
#include <numeric>

namespace gabor::statistics {

namespace {

constexpr int longest_side = 512;
constexpr int shortest_side = 8;
constexpr std::int64_t most_values = std::int64_t(1) << 25; ///< largest size of the stored rows, in floats

} // namespace

Spectrum::Spectrum(int width, int height, int side)
    : segments_(width, height, 1, side, side / 2), transform_(side),
      segment_(static_cast<std::size_t>(side * side)),
      power_(static_cast<std::size_t>(side * (side / 2 + 1))) {}

void Spectrum::add_row(std::span<const float> row) {
    for (const int left : segments_.add_row(row)) {
        segments_.copy_windowed(left, 0, segment_, segments_.side());
        const std::span<const std::complex<float>> values = transform_(segment_);
        for (std::size_t i = 0; i < values.size(); ++i)
            power_[i] += std::norm(std::complex<double>(values[i]));
    }
}

std::vector<double> Spectrum::periodogram() const {
    const double window_power = segments_.window_power();
    const double side = segments_.side();
    const auto segments = static_cast<double>(segments_.count());
    // Parseval: sum_k |X_k|^2 = side^2 sum (w x)^2, whose expectation is side^2 window_power^2 variance.
    const double scale = 1 / (segments * side * side * window_power * window_power);
    std::vector<double> result(power_);
    for (double& cell : result)
        cell *= scale;
    return result;
}

std::optional<int> segment_side(int width, int height) {
    const int longest = std::min({width / 2, height / 2, longest_side});
    if (longest < shortest_side)
        return {};
    int side = static_cast<int>(std::bit_floor(static_cast<unsigned>(longest)));
    while (std::int64_t(side) * width > most_values && side > shortest_side)
        side /= 2;
    return side;
}

namespace {

using Frequency = std::complex<double>; ///< along x and y, in cells

/// A periodogram of real data as a function on the whole plane: even, with period `side`.
class Plane {
  public:
    Plane(std::span<const double> half, int side) : half_(half), side_(side) {}

    double operator()(int x, int y) const {
        x &= side_ - 1;
        y &= side_ - 1;
        if (x > side_ / 2) {
            x = side_ - x;
            y = (side_ - y) & (side_ - 1);
        }
        return half_[static_cast<std::size_t>(y * (side_ / 2 + 1) + x)];
    }

    /// Calls visit(x, y, power) for each cell, x and y in (-side / 2, side / 2].
    template <typename Visit>
    void for_each(Visit visit) const {
        for (int y = 1 - side_ / 2; y <= side_ / 2; ++y)
            for (int x = 1 - side_ / 2; x <= side_ / 2; ++x)
                visit(x, y, (*this)(x, y));
    }

  private:
    std::span<const double> half_;
    int side_;
};

/// Power per annulus. Each cell's power is shared by the two nearest annuli according to its distance,
/// because cells fall unevenly into narrow annuli.
std::vector<double> radial_profile(const Plane& plane, int side) {
    std::vector<double> radial(static_cast<std::size_t>(side / std::numbers::sqrt2) + 2);
    plane.for_each([&](int x, int y, double power) {
        const double r = std::hypot(x, y);
        const auto inner = static_cast<std::size_t>(r);
        const double share = r - static_cast<double>(inner);
        radial[inner] += (1 - share) * power;
        radial[inner + 1] += share * power;
    });
    return radial;
}

/// Returns the distance from `peak`, in the direction of `step`, at which the profile falls to half of its
/// peak.
double half_width(std::span<const double> profile, std::size_t peak, int step) {
    const double half = profile[peak] / 2;
    double inside = profile[peak];
    double distance = 0;
    for (auto i = static_cast<std::ptrdiff_t>(peak) + step; i >= 0 && i < std::ssize(profile); i += step) {
        const double value = profile[static_cast<std::size_t>(i)];
        if (value < half)
            return distance + (inside - half) / (inside - value);
        inside = value;
        ++distance;
    }
    return distance;
}

double full_width(std::span<const double> profile) {
    const auto peak =
        static_cast<std::size_t>(std::max_element(profile.begin(), profile.end()) - profile.begin());
    return half_width(profile, peak, -1) + half_width(profile, peak, 1);
}

/// Returns the width of a lobe whose profile is noisy. The largest of many annuli overestimates the peak, so
/// the width at half that height would be too small. To avoid this, smooths the profile with a triangle whose
/// half base is a quarter of the width, then removes the width that this adds: widths add in squares, as for
/// a Gaussian lobe.
double lobe_width(std::span<const double> profile) {
    const double reach = full_width(profile) / 4;
    const auto last = static_cast<std::ptrdiff_t>(reach);
    double weights = 0;
    double squares = 0;
    std::vector<double> smooth(profile.size());
    for (std::ptrdiff_t d = -last; d <= last; ++d) {
        const double weight = 1 - std::abs(static_cast<double>(d)) / reach;
        weights += weight;
        squares += weight * static_cast<double>(d * d);
        for (auto i = std::max<std::ptrdiff_t>(0, -d);
             i < std::ssize(profile) - std::max<std::ptrdiff_t>(0, d); ++i)
            smooth[static_cast<std::size_t>(i)] += weight * profile[static_cast<std::size_t>(i + d)];
    }
    const double width = full_width(smooth);
    return std::sqrt(width * width - 8 * std::numbers::ln2 * squares / weights);
}

/// Finds the mode of the periodogram under a kernel of the given radius, by mean shift from its largest cell
/// (Fukunaga and Hostetler, 1975). The standard deviation of a cell is its mean divided by the root of the
/// number of segments, so a parabola through three cells would only fit the scatter.
Frequency find_peak(const Plane& plane, double radius) {
    Frequency peak;
    double largest = 0;
    plane.for_each([&](int x, int y, double power) {
        if (power > largest) {
            largest = power;
            peak = Frequency(x, y);
        }
    });
    for (int step = 0; step < 50; ++step) {
        Frequency shift;
        double weight = 0;
        for (int y = static_cast<int>(std::ceil(peak.imag() - radius)); y <= peak.imag() + radius; ++y)
            for (int x = static_cast<int>(std::ceil(peak.real() - radius)); x <= peak.real() + radius; ++x) {
                const Frequency d = Frequency(x, y) - peak;
                const double w = plane(x, y) * std::max(0.0, 1 - std::norm(d) / (radius * radius));
                shift += w * d;
                weight += w;
            }
        if (weight == 0)
            break;
        peak += shift / weight;
    }
    return peak;
}

} // namespace

SpectrumSummary summarize(std::span<const double> periodogram, int side) {
    const Plane plane(periodogram, side);
    const double cells = side;
    SpectrumSummary summary;
    summary.radial = radial_profile(plane, side);
    summary.radial_step = 1 / cells;
    summary.power = std::reduce(summary.radial.begin(), summary.radial.end());
    summary.resolution = 2 / cells; // 1.44 from the Hann window, the rest from sharing between annuli
    if (!(summary.power > 0))
        return summary;
    const double width = lobe_width(summary.radial);
    summary.bandwidth = width / cells;

    const Frequency peak = find_peak(plane, std::max(2.5, width));
    if (const double distance = std::abs(peak); distance >= 1) {
        const double degrees = std::arg(peak) * 180 / std::numbers::pi;
        summary.peak = {distance / cells, std::fmod(degrees + 360, 180)};
    }
    return summary;
}

} // namespace gabor::statistics

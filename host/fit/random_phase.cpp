#include "fit/random_phase.hpp"

#include "statistics/transform.hpp"

#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <random>
#include <span>

namespace gabor::fit {

namespace {

using Complex = std::complex<double>;

/// A transform on the whole plane.
class Plane {
  public:
    Plane(std::span<const std::complex<float>> half, int side)
        : side_(side), values_(static_cast<std::size_t>(side) * static_cast<std::size_t>(side)) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const bool kept = x <= side / 2;
                const int ky = kept ? y : (side - y) % side;
                const int kx = kept ? x : side - x;
                const Complex value = half[static_cast<std::size_t>(ky * (side / 2 + 1) + kx)];
                (*this)(x, y) = kept ? value : std::conj(value);
            }
    }
    Complex& operator()(int x, int y) { return values_[static_cast<std::size_t>(y * side_ + x)]; }

  private:
    int side_;
    std::vector<Complex> values_;
};

// The jumps from each edge to the opposite one.
std::vector<float> jumps(std::span<const float> picture, int side) {
    std::vector<float> result(picture.size());
    const auto at = [side](int x, int y) { return static_cast<std::size_t>(y * side + x); };
    const int last = side - 1;
    for (int i = 0; i < side; ++i) {
        const float across = picture[at(last, i)] - picture[at(0, i)];
        result[at(0, i)] += across;
        result[at(last, i)] -= across;
        const float down = picture[at(i, last)] - picture[at(i, 0)];
        result[at(i, 0)] += down;
        result[at(i, last)] -= down;
    }
    return result;
}

} // namespace

std::vector<float> random_phase(const std::vector<float>& picture, int side, std::uint32_t seed) {
    statistics::Transform transform(side);
    const auto pixels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
    std::mt19937 generator(seed);
    std::vector<float> noise(pixels);
    for (float& value : noise) // phases of white noise: those of opposite frequencies are opposite
        value = static_cast<float>(generator() >> 8) * 0x1p-24f - 0.5f;
    Plane phases(transform(noise), side);

    std::vector<float> result;
    for (std::size_t begin = 0; begin < picture.size(); begin += pixels) {
        const std::span<const float> channel = std::span(picture).subspan(begin, pixels);
        Plane spectrum(transform(channel), side);
        Plane smooth(transform(jumps(channel, side)), side);
        // A real picture is the transform of Re - Im of its own transform, real part less imaginary part.
        std::vector<float> hartley(pixels);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const auto cosine = [side](int k) { return std::cos(2 * std::numbers::pi * k / side); };
                const bool zero = x == 0 && y == 0;
                const double curvature = zero ? 1 : 2 * cosine(x) + 2 * cosine(y) - 4;
                Complex value = spectrum(x, y) - (zero ? Complex() : smooth(x, y) / curvature);
                if (const double length = std::abs(phases(x, y)); !zero && length > 0)
                    value *= phases(x, y) / length;
                hartley[static_cast<std::size_t>(y * side + x)] =
                    static_cast<float>((value.real() - value.imag()) / static_cast<double>(pixels));
            }
        Plane back(transform(hartley), side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                result.push_back(static_cast<float>(back(x, y).real() - back(x, y).imag()));
    }
    return result;
}

} // namespace gabor::fit

#include "noise/spectrum.hpp"

#include <algorithm>
#include <cmath>

namespace gabor::noise {

namespace {

// The same as gabor_derived_seed in shaders/gabor_noise.glsl.
std::uint32_t derived_seed(std::uint32_t seed, int index) {
    std::uint32_t word = seed + static_cast<std::uint32_t>(index) * 0x85ebca6bu;
    word = (word ^ word >> 16) * 0x21f0aaadu + 0x9e3779b1u;
    word = (word ^ word >> 15) * 0xd35a2d97u;
    return word ^ word >> 15;
}

// One piece of a range of frequencies or orientations.
struct Piece {
    double place; // its centre in the range, from -1 to 1
    double share; // fraction of the range's power
    int index;    // determines its seed
};

// Returns floor(count) pieces. As the fractional part of `count` goes from 0.8 to 1, they fade out and
// floor(count) + 1 pieces fade in, so that the noise is continuous in `count`. The amplitudes of these two
// sets are proportional to `left` and 1 - left.
std::vector<Piece> pieces(double count) {
    const int fewer = static_cast<int>(count);
    const double left = std::min(5 - 5 * (count - fewer), 1.0);
    std::vector<Piece> all;
    for (const int n : {fewer, fewer + 1}) {
        const double amplitude = n == fewer ? left : 1 - left;
        const double part = amplitude * amplitude / (left * left + (1 - left) * (1 - left));
        for (int i = 0; i < n && part > 0; ++i)
            all.push_back({(2.0 * i + 1) / n - 1, part / n, i + n % 2 * 64});
    }
    return all;
}

// The bandwidth of a kernel, which is inversely proportional to its radius, fills the gaps between pieces.
// `frequencies` and `orientations` use enough pieces to cover their ranges evenly.
std::vector<Piece> frequencies(const Lobe& lobe) {
    return pieces(
        std::clamp(2.857 * lobe.frequency_spread * lobe.frequency * lobe.longest_radius() + 0.8, 1.0, 16.0));
}

std::vector<Piece> orientations(const Lobe& lobe, double frequency) {
    const double quarters = lobe.orientation_spread / 90;
    return pieces(std::clamp(quarters * (4.44 * frequency * lobe.longest_radius() + 0.6) + 0.8, 1.0, 64.0));
}

void add_lobe(std::vector<Wave>& waves, const Lobe& lobe, double share, std::uint32_t seed, bool in_space) {
    if (lobe.is_one_wave()) {
        waves.push_back({lobe.frequency, lobe.angle(), lobe.radii(), share, seed});
        return;
    }
    const bool isotropic = in_space && lobe.orientation_spread == 90;
    for (const Piece& along : frequencies(lobe)) {
        const double frequency = lobe.frequency * (1 + lobe.frequency_spread * along.place);
        if (isotropic) {
            const std::uint32_t own =
                lobe.frequency_spread == 0 ? seed : derived_seed(seed, 128 * along.index);
            waves.push_back({frequency, 0, lobe.radii(), share * along.share, own, true});
            continue;
        }
        for (const Piece& around : orientations(lobe, frequency))
            waves.push_back({frequency, lobe.angle() + radians(lobe.orientation_spread) * around.place,
                             lobe.radii(), share * along.share * around.share,
                             derived_seed(seed, 128 * along.index + around.index)});
    }
}

Lobe with_round_kernel(Lobe lobe) {
    lobe.radius *= std::sqrt(lobe.stretch);
    lobe.stretch = 1;
    return lobe;
}

} // namespace

std::vector<Wave> waves(std::span<const Lobe> lobes, std::uint32_t seed, bool in_space) {
    double power = 0;
    for (const Lobe& lobe : lobes)
        power += lobe.power;
    std::vector<Wave> all;
    for (std::size_t i = 0; i < lobes.size(); ++i)
        if (lobes[i].power > 0)
            add_lobe(all, in_space ? with_round_kernel(lobes[i]) : lobes[i], lobes[i].power / power,
                     lobes.size() == 1 ? seed : derived_seed(seed, static_cast<int>(i)), in_space);
    return all;
}

std::array<double, 2> Wave::in_kernels() const {
    return {frequency * radius[0] * std::cos(angle), frequency * radius[1] * std::sin(angle)};
}

std::vector<std::array<double, 2>> radii(std::span<const Wave> waves) {
    std::vector<std::array<double, 2>> all;
    for (const Wave& wave : waves)
        if (std::ranges::find(all, wave.radius) == all.end())
            all.push_back(wave.radius);
    return all;
}

} // namespace gabor::noise

// Compares every combination of points, kernel and envelope on the device with the double-precision
// reference. Weights alternate, since they only scale an impulse.

#include "largest.hpp"
#include "reference/reference.hpp"
#include "study/noise.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace gabor;
using noise::mix;
using noise::spread;
using study::Envelope;
using study::Ingredients;
using study::Kernel;
using study::Points;
using study::Weights;

namespace {

struct Impulse {
    double x; // in cells
    double y;
    double weight;
    double phase; // in turns
};

std::uint32_t reversed(std::uint32_t word) {
    std::uint32_t result = 0;
    for (int bit = 0; bit < 32; ++bit)
        result |= (word >> bit & 1) << (31 - bit);
    return result;
}

// Uses single precision like the device: other rounding near the threshold would add or drop an impulse.
int poisson(float mean, std::uint32_t cell_word) {
    int count = 0;
    std::uint32_t draw = 0;
    for (; mean > 0; mean -= 64) {
        const float end = std::exp(-std::min(mean, 64.0f));
        for (float product = 1;; ++count) {
            product *=
                (static_cast<float>(mix(cell_word + draw++ * spread, cell_word) >> 8) + 0.5f) * 0x1p-24f;
            if (product <= end)
                break;
        }
    }
    return count;
}

// Point `index` of Sobol's sequence, as 32-bit fractions.
std::pair<std::uint32_t, std::uint32_t> sobol(std::uint32_t index) {
    // The direction numbers of the primitive polynomial x + 1, from m_1 = 1, are v_(k+1) = v_k ^ (v_k >> 1).
    std::uint32_t second = 0;
    for (std::uint32_t v = 0x80000000u, rest = index; rest != 0; rest >>= 1, v ^= v >> 1)
        if (rest & 1)
            second ^= v;
    return {reversed(index), second};
}

// Laine and Karras' hash on the reversed bits.
std::uint32_t owen(std::uint32_t fraction, std::uint32_t seed) {
    std::uint32_t v = reversed(fraction) + seed;
    for (const std::uint32_t factor : {0x6c50b47cu, 0xb82f1e52u, 0xc7afe638u, 0x8d22f6e6u})
        v ^= v * factor;
    return reversed(v);
}

// Returns a point in the parallelogram of a and b, moved into the Voronoi cell of its nearest lattice point.
std::pair<double, double> hexagon(const study::HexagonalLattice& hex, double u, double v) {
    const double x = (u - 0.5) * hex.a[0] + (v - 0.5) * hex.b[0];
    const double y = (u - 0.5) * hex.a[1] + (v - 0.5) * hex.b[1];
    std::pair<double, double> best{x, y};
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j) {
            const double dx = x - i * hex.a[0] - j * hex.b[0];
            const double dy = y - i * hex.a[1] - j * hex.b[1];
            if (std::hypot(dx, dy) < std::hypot(best.first, best.second) - 1e-9)
                best = {dx, dy};
        }
    return best;
}

// Returns a point in sub-cell `index` of n equal sub-cells in round(sqrt(n)) rows.
std::pair<double, double> jittered(int n, int index, double u, double v) {
    const int rows = static_cast<int>(std::lround(std::sqrt(n)));
    const int row = index * rows / n;
    const auto first_of = [&](int r) { return (r * n + rows - 1) / rows; };
    const int first = first_of(row);
    const int width = first_of(row + 1) - first;
    return {(index - first + u) / width, (first + v * width) / n};
}

double envelope(Envelope envelope, double x, double y) {
    const double square = x * x + y * y;
    const bool inside = square <= 1;
    switch (envelope) {
    case Envelope::gaussian:
        return inside ? std::exp(-std::numbers::pi * square) : 0;
    case Envelope::c0:
        return inside ? std::exp(-std::numbers::pi * square) - std::exp(-std::numbers::pi) : 0;
    case Envelope::c1_radial:
        return inside ? std::pow(1 - square, 2) : 0;
    default:
        return std::pow(std::max(1 - x * x, 0.0) * std::max(1 - y * y, 0.0), 2);
    }
}

// The impulses of a cell in double precision, from the definitions: Sobol points from direction numbers, and
// hexagons from the lattice by brute force.
std::vector<Impulse> cell_impulses(const Ingredients& it, std::int32_t cell_x, std::int32_t cell_y,
                                   std::uint32_t seed) {
    cell_x = noise::wrapped(cell_x, it.period);
    cell_y = noise::wrapped(cell_y, it.period);
    const std::uint32_t cell_word = noise::impulse_word(cell_x, cell_y, -1, seed);
    const bool counted = it.points == Points::poisson;
    const int count = counted ? poisson(static_cast<float>(it.impulses), cell_word) : it.impulses;
    const study::HexagonalLattice hex = study::hexagonal_lattice(it.impulses);
    std::vector<Impulse> impulses;
    for (int k = 0; k < count; ++k) {
        const std::uint32_t word = noise::impulse_word(cell_x, cell_y, k, seed);
        const double u = ((word >> 20) + 0.5) / 4096;
        const double v = ((word >> 8 & 0xfff) + 0.5) / 4096;
        std::pair<double, double> place{u, v};
        if (it.points == Points::jittered)
            place = jittered(it.impulses, k, u, v);
        if (it.points == Points::jittered_hex) {
            place = hexagon(hex, u, v);
            place.first += (k + 0.5) / it.impulses;
            place.second += (k * hex.step % it.impulses + 0.5) / it.impulses;
        }
        if (it.points == Points::sobol || it.points == Points::scrambled_sobol) {
            const bool plain = it.points == Points::sobol;
            auto [x, y] = sobol(static_cast<std::uint32_t>(k) + (plain ? cell_word : 0));
            if (!plain) {
                x = owen(x, cell_word);
                y = owen(y, mix(cell_word, 1));
            }
            place = {(x >> 8) * 0x1p-24, (y >> 8) * 0x1p-24};
        }
        double weight = 1;
        if (it.weights == Weights::uniform)
            weight = ((word & 0xff) - 127.5) / 128;
        if (it.weights == Weights::bernoulli)
            weight = word & 0x80 ? -1 : 1;
        const double phase = it.kernel == Kernel::random_phase ? (mix(word, 2) >> 8) * 0x1p-24
                             : it.kernel == Kernel::cosine     ? 0.25
                                                               : 0;
        impulses.push_back({place.first, place.second, weight, phase});
    }
    return impulses;
}

// The sum of all impulses within reach, without the normalization K.
double ingredients_sum(const Ingredients& it, const study::PlaneWave& wave, double x, double y,
                       std::uint32_t seed) {
    double sum = 0;
    // The kernel and the hexagons reach less than two cells each way.
    for (int j = static_cast<int>(std::floor(y)) - 2; j <= std::floor(y) + 2; ++j)
        for (int i = static_cast<int>(std::floor(x)) - 2; i <= std::floor(x) + 2; ++i)
            for (const Impulse& impulse : cell_impulses(it, i, j, seed)) {
                const double dx = x - i - impulse.x;
                const double dy = y - j - impulse.y;
                const double turns =
                    wave.frequency * (dx * std::cos(wave.orientation) + dy * std::sin(wave.orientation));
                sum += impulse.weight * envelope(it.envelope, dx, dy) *
                       std::sin(2 * std::numbers::pi * (turns + impulse.phase));
            }
    return sum;
}

// The position and the instance's seed of a value that passes/ingredients.comp computes.
struct Place {
    double x;
    double y;
    std::uint32_t seed;
};

Place random_place(std::uint32_t instance, std::uint32_t noise_seed, std::uint32_t place_seed) {
    const std::uint32_t x = mix(instance * spread, place_seed);
    const std::uint32_t y = mix(x, place_seed ^ 0x85ebca6bu);
    return {(x >> 8) * 0x1p-24, (y >> 8) * 0x1p-24, mix(instance * spread + noise_seed, noise_seed)};
}

} // namespace

TEST_CASE("combinations of ingredients agree with the reference", "[ingredients]") {
    const vulkan::Device device;
    const study::PlaneWave wave{4, 0.7};
    test::Largest largest;
    std::uint32_t seed = 11;
    for (const study::Points points : study::all_points)
        for (const study::Kernel kernel : study::all_kernels)
            for (const study::Envelope envelope : study::all_envelopes) {
                constexpr int counts[]{1, 2, 3, 4, 7, 13, 29};
                const int n = counts[seed % 7];
                const study::Weights weights = study::all_weights[seed % study::all_weights.size()];
                const study::Ingredients it{points, weights, kernel, envelope, n, seed % 5 == 0 ? 3 : 0};
                study::Noise noise(device, it, wave);
                std::vector<float> values(64);
                noise.fill(values, {}, 5, ++seed, 99);
                const double amplitude = 1 / std::sqrt(study::variance(it, wave));
                for (std::uint32_t i = 0; i < values.size(); ++i) {
                    const Place p = random_place(5 + i, seed, 99);
                    const double expected = amplitude * ingredients_sum(it, wave, p.x, p.y, p.seed);
                    largest.see(values[i], expected, 1e-5,
                                [&] { return fmt::format("{}, value {}", study::csv_fields(it), i); });
                }
            }
    largest.check("ingredients");
}

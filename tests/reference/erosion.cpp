#include "reference/erosion.hpp"

#include "reference/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace gabor::noise {

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// A position on a lattice axis: `local` spacings from node `cell`, with `nodes` nodes per unit of length.
struct Axis {
    std::int32_t cell;
    double local;
    double nodes;
    std::int32_t period;
};

// Without a period, the number of nodes per unit is a multiple of 1 / 65536, chosen in single precision. A
// period holds a whole number of nodes.
Axis axis_at(std::int32_t cell, double local, float period, float nodes) {
    const auto steps =
        static_cast<std::int64_t>(std::floor(std::clamp(nodes, 1e-4f, 3e4f) * 65536.0f + 0.5f));
    if (period > 0) {
        const float whole = std::floor(period * (static_cast<float>(steps) / 65536.0f) + 0.5f);
        const auto count = static_cast<std::int32_t>(std::max(whole, 4.0f));
        const double turns = (cell + local) / period;
        return {0, (turns - std::floor(turns)) * count, static_cast<double>(count) / period, count};
    }
    const std::int64_t product = cell * steps; // 63 bits
    const std::int64_t index = product >> 16;
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(index)),
            static_cast<double>(product - index * 65536) / 65536 + local * static_cast<double>(steps) / 65536,
            static_cast<double>(steps) / 65536, 0};
}

std::int32_t line(const Axis& axis, std::int32_t offset) {
    return wrapped(wrapped(std::int64_t{axis.cell} + offset, 0), axis.period);
}

// The cubic B-spline at a distance d from its node, and its derivative.
double spline(double d) {
    const double a = std::abs(d);
    return a >= 2 ? 0 : (std::pow(2 - a, 3) - 4 * std::pow(std::max(1 - a, 0.0), 3)) / 6;
}
double spline_slope(double d) {
    const double a = std::abs(d);
    const double slope = a >= 2 ? 0 : (-std::pow(2 - a, 2) + 4 * std::pow(std::max(1 - a, 0.0), 2)) / 2;
    return d < 0 ? -slope : slope;
}

double spline_curvature(double d) {
    const double a = std::abs(d);
    return a >= 2 ? 0 : 2 - a - 4 * std::max(1 - a, 0.0);
}

double mask_of(double t, double rounding) {
    const double rounded = t < rounding ? t * t / (2 * rounding) : t - rounding / 2;
    return 1 - std::pow(1 - std::min(rounded, 1.0), 2);
}

} // namespace

Terrain terrain(const Ground& ground, Vector<2> dx, Vector<2> dy, std::uint32_t seed) {
    const Axis x = axis_at(ground.cell[0], ground.local[0], ground.period[0], 1);
    const Axis y = axis_at(ground.cell[1], ground.local[1], ground.period[1], 1);
    const auto left = static_cast<std::int32_t>(std::floor(x.local));
    const auto below = static_cast<std::int32_t>(std::floor(y.local));
    std::complex<double> value, slope_x, slope_y, xx, xy, yy;
    for (std::int32_t i = left - 1; i <= left + 2; ++i) {
        for (std::int32_t j = below - 1; j <= below + 2; ++j) {
            const std::uint32_t word = lattice_word(line(x, i), line(y, j), seed);
            const std::complex<double> amplitude(static_cast<std::int32_t>(word),
                                                 static_cast<std::int32_t>(word << 16));
            value += amplitude * spline(x.local - i) * spline(y.local - j);
            slope_x += amplitude * x.nodes * spline_slope(x.local - i) * spline(y.local - j);
            slope_y += amplitude * y.nodes * spline(x.local - i) * spline_slope(y.local - j);
            xx += amplitude * x.nodes * x.nodes * spline_curvature(x.local - i) * spline(y.local - j);
            xy += amplitude * x.nodes * y.nodes * spline_slope(x.local - i) * spline_slope(y.local - j);
            yy += amplitude * y.nodes * y.nodes * spline(x.local - i) * spline_curvature(y.local - j);
        }
    }
    // The noises have variance 1 and correlations like exp(-curvature d^2 / 2). A Gaussian filter with a
    // deviation of half a pixel has the covariance matrix (dx dx^T + dy dy^T) / 4.
    const double curvature = 2.0 / 3 / (151.0 / 315);
    const double filter_xx = (dx[0] * dx[0] + dy[0] * dy[0]) / 4,
                 filter_yy = (dx[1] * dx[1] + dy[1] * dy[1]) / 4,
                 filter_xy = (dx[0] * dx[1] + dy[0] * dy[1]) / 4;
    const double kept = 1 / std::sqrt((1 + curvature * filter_xx) * (1 + curvature * filter_yy) -
                                      std::pow(curvature * filter_xy, 2));
    const double damped = std::exp(-std::pow(two_pi * 0.4, 2) / 2 * (1 - kept * kept));
    const double unit = kept * 315.0 / 151 * std::numbers::sqrt3 / 2147483648.0;
    const double a = unit * value.real(), b = unit * value.imag();
    const double small = damped * std::sin(two_pi * 0.4 * b), height = a + (0.3 + 0.12 * a) * small;
    const double turn = two_pi * 0.4, cosine = damped * std::cos(turn * b);
    const auto slope = [&](std::complex<double> d) {
        return 0.33 * unit * (d.real() * (1 + 0.12 * small) + (0.3 + 0.12 * a) * cosine * turn * d.imag());
    };
    const auto bend = [&](std::complex<double> dd, std::complex<double> d, std::complex<double> e) {
        return slope(dd) + 0.33 * unit * unit *
                               (0.12 * cosine * turn * (d.real() * e.imag() + d.imag() * e.real()) -
                                (0.3 + 0.12 * a) * small * turn * turn * d.imag() * e.imag());
    };
    const Vector<2> slopes{slope(slope_x), slope(slope_y)};
    const double to_ridge = std::pow(1 + height * height, -1.5) / 0.33;
    return {0.33 * height,
            slopes,
            height / std::sqrt(1 + height * height),
            {bend(xx, slope_x, slope_x), bend(xy, slope_x, slope_y), bend(yy, slope_y, slope_y)},
            {to_ridge * slopes[0], to_ridge * slopes[1]}};
}

namespace {

// Without slopes.
Terrain eroded_point(int taps, const Ground& ground, Vector<2> dx, Vector<2> dy, const Terrain& base,
                     const Erosion& erosion, std::uint32_t seed) {
    Terrain result{base.height, {}, base.ridge};
    const auto rounding = [&](double cosine) {
        return std::lerp(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * cosine);
    };
    Vector<2> steer = base.slope;
    double open = 1;
    double gully = base.ridge, depth = double{erosion.strength} / erosion.gully_frequency, width = 1;
    double mask = 1, round = rounding(base.ridge);
    float frequency = erosion.gully_frequency;
    for (int octave = 0; octave < erosion.octaves; ++octave) {
        const double steep = std::max(std::hypot(steer[0], steer[1]), 1e-9);
        mask *= std::pow(mask_of(steep / std::max(double{erosion.onset_slope}, 1e-6), round), 2);
        if (octave == 0)
            open = std::lerp(mask, 1.0, std::pow(std::max(base.ridge, 0.0), 2)); // flat valleys stay open
        const Vector<2> wave{-steer[1] / steep * frequency, steer[0] / steep * frequency};
        // The filter is nearly Gaussian, with a deviation of half a pixel: what it keeps of a wave reaches 0
        // where a Gaussian keeps 2 %.
        const double across = std::pow(dot(wave, dx), 2) + std::pow(dot(wave, dy), 2);
        const double kept =
            std::max(1.02 * std::exp(-std::numbers::pi * std::numbers::pi / 2 * across) - 0.02, 0.0);
        std::complex<double> z;
        if (kept > 0) {
            const float nodes = 0.8f * (0.5f * static_cast<float>(taps)) * frequency;
            const Axis x = axis_at(ground.cell[0], ground.local[0], ground.period[0], nodes);
            const Axis y = axis_at(ground.cell[1], ground.local[1], ground.period[1], nodes);
            const Field<2> field =
                wave_noise(taps, wave, lattice_derived_seed(seed, octave))
                    .field({{x.cell, y.cell}, {x.local, y.local}, {x.nodes, y.nodes}, {x.period, y.period}});
            const double s = erosion.uniformity;
            z = kept * s / std::sqrt(1 + s * s * std::norm(field.value)) * field.value;
        }
        gully = std::lerp(gully, erosion.gully_weight * z.real(), mask);
        result.ridge = std::lerp(result.ridge, z.real(), mask);
        result.height += open * depth * gully;
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double side = z.imag() < 0 ? -two_pi : two_pi;
            steer[axis] -= side * kept * erosion.branching * erosion.gully_weight * depth * mask * wave[axis];
        }
        mask *= erosion.detail / (1 + mask * (double{erosion.detail} - 1));
        round = rounding(z.real());
        mask *= mask_of((1 - kept) / 2 + std::abs(z.imag()), round * width);
        width *= erosion.lacunarity;
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return result;
}

// The base at an offset.
Terrain continued(const Terrain& base, Vector<2> d) {
    const auto& [xx, xy, yy] = base.curvature;
    return {base.height + dot(base.slope, d) + (xx * d[0] * d[0] + yy * d[1] * d[1]) / 2 + xy * d[0] * d[1],
            {base.slope[0] + xx * d[0] + xy * d[1], base.slope[1] + xy * d[0] + yy * d[1]},
            base.ridge + dot(base.ridge_slope, d)};
}

} // namespace

Terrain eroded(int taps, const Ground& ground, Vector<2> dx, Vector<2> dy, const Terrain& base,
               const Erosion& erosion, std::uint32_t seed) {
    Terrain result = eroded_point(taps, ground, dx, dy, base, erosion, seed);
    const double finest =
        erosion.gully_frequency * std::pow(erosion.lacunarity, std::max(erosion.octaves - 1, 0));
    const double step = 1e-5 / std::max(finest, 1.0);
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const auto height = [&](double distance) {
            Vector<2> offset{};
            offset[axis] = distance;
            Ground moved = ground;
            moved.local[axis] += distance;
            return eroded_point(taps, moved, dx, dy, continued(base, offset), erosion, seed).height;
        };
        const double ahead = height(step), behind = height(-step);
        result.slope[axis] = (ahead - behind) / (2 * step);
        result.crease = std::max(result.crease, std::abs(ahead + behind - 2 * result.height) / step);
    }
    return result;
}

} // namespace gabor::noise

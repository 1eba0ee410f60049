#include "reference/fractal.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>

namespace gabor::noise {

namespace {

using std::numbers::pi;

// A node's window h along an axis at a distance in node spacings, and its derivatives.
struct Window {
    double half_width;
    std::function<std::array<double, 3>(double)> at; // 0 beyond the half-width
};

// Hann's window.
Window hann(double half_width) {
    return {half_width, [half_width](double d) {
                const LatticeWindow h = lattice_window(3, d / half_width);
                return std::array{h.value, h.slope / half_width, h.curvature / half_width / half_width};
            }};
}

// c^2 (1 + t (1 - c)) = (1 + t) c^2 - t c^3, where c is Hann's window over four nodes.
Window squared_hann(double t) {
    return {2, [t, c = hann(2)](double d) {
                const auto [value, slope, curvature] = c.at(d);
                const double first = 2 * (1 + t) * value - 3 * t * value * value; // by c
                const double second = 2 * (1 + t) - 6 * t * value;
                return std::array{value * value * (1 + t - t * value), first * slope,
                                  second * slope * slope + first * curvature};
            }};
}

Window window(bool perlin, double variance) {
    return perlin ? squared_hann(std::min(5.5 * variance, 2.0))
                  : hann(std::min(1.5 * std::sqrt(1 + variance / 0.294), 2.0));
}

double kept_even(double s) {
    return std::pow(1 + 2.888 * s + 1.52 * s * s * s / (s + 0.5855), -0.25);
}
double kept_odd(double s) {
    return std::pow(1 + 2.704 * s + 1.173 * s * s * s / (s + 0.149), -0.75);
}

// The mean over places of the sum of the squares of a derivative of h at all nodes is its integral.
double power(const Window& window, std::size_t derivative) {
    constexpr int steps = 64; // exact for sums of few cosines
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double d = window.half_width * ((2.0 * i + 1) / steps - 1);
        sum += std::pow(window.at(d)[derivative], 2);
    }
    return 2 * window.half_width / steps * sum;
}

// The nodes of an octave whose windows reach a point along an axis: their words, and for each the window u
// and its derivative.
struct Reached {
    std::uint32_t word;
    std::array<double, 2> even, odd; // u and u', v and v'
};

// Divides the windows by the root of the sum of their squares, by the quotient rule.
void normalize(std::vector<Reached>& nodes, std::array<double, 2> Reached::*part) {
    double square = 0, product = 0;
    for (const Reached& node : nodes) {
        square += std::pow((node.*part)[0], 2);
        product += (node.*part)[0] * (node.*part)[1];
    }
    for (Reached& node : nodes) {
        auto& [value, slope] = node.*part;
        slope = slope / std::sqrt(square) - value * product / std::pow(square, 1.5);
        value /= std::sqrt(square);
    }
}

// An octave's lattice. A point at p has the coordinates cell + local in node spacings; `along` has the
// derivatives of these by the coordinates of p, in kernel radii: along[k] those by coordinate k.
template <std::size_t N>
struct Octave {
    std::array<std::int64_t, N> cell;
    Vector<N> local;
    std::array<std::int32_t, N> period;
    std::array<Vector<N>, N> along;
    std::uint32_t salt;
};

template <std::size_t N>
std::vector<Reached> reached(const Octave<N>& octave, std::size_t axis, const Window& window) {
    std::vector<Reached> nodes;
    const double local = octave.local[axis];
    for (double node = std::ceil(local - window.half_width); node <= local + window.half_width; ++node) {
        const auto [value, slope, curvature] = window.at(local - node);
        const std::int32_t index =
            wrapped(octave.cell[axis] + static_cast<std::int64_t>(node), octave.period[axis]);
        nodes.push_back({salted_line_word(index, static_cast<int>(axis), octave.salt),
                         {value, slope},
                         {slope, curvature}});
    }
    normalize(nodes, &Reached::even);
    normalize(nodes, &Reached::odd);
    return nodes;
}

// The amplitudes of a node: one of smooth noise, one along each axis of Perlin noise.
std::array<double, 2> amplitudes(const std::array<std::uint32_t, 2>& lines, double time) {
    const std::complex<double> a = lattice_amplitude(node_word(lines), time);
    return {a.real(), a.imag()};
}
std::array<double, 3> amplitudes(const std::array<std::uint32_t, 3>& lines, double time) {
    const std::complex<double> a = lattice_amplitude(node_word(lines), time);
    const std::uint32_t row = lines[1] * lines[2] >> 8 | 0x800001u;
    return {a.real(), a.imag(),
            lattice_amplitude(node_word(std::array{lines[0], next_word(row) >> 8 | 0x800001u}), time).real()};
}

// What a filter does to an octave.
template <std::size_t N>
struct Filter {
    Vector<N> variance{};
    double oblique = 1; // factor
};

// The value of an octave and its gradient along the lattice's axes, with variance 1 if nothing is filtered.
template <std::size_t N>
std::array<double, N + 1> octave_sum(const Octave<N>& octave, bool perlin, const Filter<N>& filter,
                                     double time) {
    std::array<std::vector<Reached>, N> nodes;
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < N; ++axis) {
        nodes[axis] = reached(octave, axis, window(perlin, filter.variance[axis]));
        for (Reached& node : nodes[axis])
            for (std::size_t k = 0; k < 2; ++k) {
                node.even[k] *= kept_even(filter.variance[axis]);
                node.odd[k] *= kept_odd(filter.variance[axis]);
            }
        count *= nodes[axis].size();
    }
    std::array<double, N + 1> sum{}; // the noise, then its gradient
    for (std::size_t number = 0; number < count; ++number) {
        std::array<const Reached*, N> at;
        std::array<std::uint32_t, N> lines;
        std::size_t rest = number;
        for (std::size_t axis = 0; axis < N; ++axis) {
            at[axis] = &nodes[axis][rest % nodes[axis].size()];
            rest /= nodes[axis].size();
            lines[axis] = at[axis]->word;
        }
        const auto each = amplitudes(lines, time);
        for (std::size_t term = 0; term < (perlin ? N : 1); ++term)
            for (std::size_t by = 0; by <= N; ++by) { // 0 is the value, others are derivatives
                double product = each[term];
                for (std::size_t axis = 0; axis < N; ++axis)
                    product *= (perlin && axis == term ? at[axis]->odd : at[axis]->even)[by == axis + 1];
                sum[by] += product;
            }
    }
    for (double& number : sum)
        number *= filter.oblique / lattice_amplitude_deviation() / (perlin ? std::sqrt(N) : 1);
    return sum;
}

// The share of an octave's variance that its filter leaves, and the variances of its slopes along the axes.
template <std::size_t N>
std::array<double, N + 1> powers(bool perlin, const Filter<N>& filter) {
    std::array<double, N + 1> sum{};
    for (std::size_t term = 0; term < (perlin ? N : 1); ++term) {
        double share = std::pow(filter.oblique, 2) / (perlin ? N : 1);
        for (std::size_t axis = 0; axis < N; ++axis)
            share *= std::pow((perlin && axis == term ? kept_odd : kept_even)(filter.variance[axis]), 2);
        sum[0] += share;
        for (std::size_t axis = 0; axis < N; ++axis) {
            const Window h = window(perlin, filter.variance[axis]);
            const std::size_t derivative = perlin && axis == term;
            sum[axis + 1] += share * power(h, derivative + 1) / power(h, derivative);
        }
    }
    return sum;
}

// The filter of an octave under a pixel, and the share of its variance that is left.
template <std::size_t N>
std::pair<Filter<N>, double> filter_of(const Octave<N>& octave, const Pixel<N>& pixel, bool perlin) {
    std::array<Vector<N>, 2> steps{};
    for (std::size_t axis = 0; axis < N; ++axis) {
        for (std::size_t k = 0; k < N; ++k) {
            steps[0][axis] += 0.5 * pixel.dx[k] * octave.along[k][axis];
            steps[1][axis] += 0.5 * pixel.dy[k] * octave.along[k][axis];
        }
        for (Vector<N>& step : steps)
            step[axis] = std::clamp(step[axis], -1e3, 1e3);
    }
    const auto covariance = [&](std::size_t i, std::size_t k) {
        return steps[0][i] * steps[0][k] + steps[1][i] * steps[1][k];
    };
    Filter<N> filter;
    for (std::size_t i = 0; i < N; ++i) {
        filter.variance[i] = covariance(i, i);
        for (std::size_t k = 0; k < i; ++k) {
            const double square = std::pow(2.9 * covariance(i, k), 2) / (1 + 2.9 * covariance(i, i)) /
                                  (1 + 2.9 * covariance(k, k));
            filter.oblique *= std::pow(1 / (1 - square / 2), perlin ? 3 : 1);
        }
    }
    const double straight = powers(perlin, Filter<N>{filter.variance, 1})[0];
    const double left = straight * std::pow(filter.oblique, 2);
    filter.oblique = std::min(filter.oblique, 1 / std::sqrt(straight)); // no more than everything is left
    filter.oblique *= std::clamp(1000 * left - 1, 0.0, 1.0); // an octave fades in where 1/1000 is left
    return {filter, std::min(straight * std::pow(filter.oblique, 2), 1.0)};
}

// The places of the octaves: a position is multiplied by a matrix of multiples of 1/4096, and moved.
Vector<2> step_of(const Fractal& fractal, const Vector<2>&) {
    return {fractal.lacunarity * std::cos(fractal.turn), fractal.lacunarity * std::sin(fractal.turn)};
}
// Rodrigues: a turn about the unit vector a is cos + (1 - cos) a a^T + sin [a]x, with a = (1, 1, 1) /
// sqrt(3).
Vector<3> step_of(const Fractal& fractal, const Vector<3>&) {
    const double c = std::cos(fractal.turn), s = std::sin(fractal.turn);
    return {fractal.lacunarity * (c + (1 - c) / 3), fractal.lacunarity * ((1 - c) / 3 - s / std::sqrt(3)),
            fractal.lacunarity * ((1 - c) / 3 + s / std::sqrt(3))};
}

// The matrix of a step, row by row, in units of 1/4096.
std::array<std::array<std::int64_t, 2>, 2> matrix(const Vector<2>& step) {
    const std::int64_t c = std::llround(4096 * step[0]), s = std::llround(4096 * step[1]);
    return {{{c, -s}, {s, c}}};
}
std::array<std::array<std::int64_t, 3>, 3> matrix(const Vector<3>& step) {
    const std::int64_t same = std::llround(4096 * step[0]), next = std::llround(4096 * step[1]),
                       last = std::llround(4096 * step[2]);
    return {{{same, next, last}, {last, same, next}, {next, last, same}}};
}

constexpr std::array<double, 2> moved(const Vector<2>&) {
    return {0.382, 0.731};
}
constexpr std::array<double, 3> moved(const Vector<3>&) {
    return {0.382, 0.731, 0.545};
}

template <std::size_t N>
bool is_endless(const Place<N>& place) {
    return std::all_of(place.period.begin(), place.period.end(), [](auto period) { return period == 0; });
}

template <std::size_t N>
std::vector<Octave<N>> octaves_of(const Place<N>& place, const Fractal& fractal, std::uint32_t seed) {
    const auto salt = [&](std::size_t octave) {
        return mix(seed * spread + static_cast<std::uint32_t>(octave) * 0x85ebca6bu, 0xc2b2ae35u);
    };
    Octave<N> first;
    for (std::size_t axis = 0; axis < N; ++axis) {
        first.cell[axis] = place.cell[axis];
        first.along[axis] = {};
        first.along[axis][axis] = place.radius[axis];
    }
    first.local = place.local;
    first.period = place.period;
    first.salt = salt(0);
    std::vector<Octave<N>> octaves{first};
    const auto rows = matrix(step_of(fractal, place.local));
    const auto offset = moved(place.local);
    for (std::size_t i = 1; static_cast<double>(i) < fractal.octaves; ++i) {
        const Octave<N>& last = octaves.back();
        Octave<N> next{};
        next.salt = salt(i);
        for (std::size_t axis = 0; axis < N; ++axis) {
            if (is_endless(place)) {
                std::int64_t product = 0; // of the matrix and the cell, which is exact
                next.local[axis] = offset[axis];
                for (std::size_t k = 0; k < N; ++k) {
                    const double factor = static_cast<double>(rows[axis][k]) / 4096;
                    product += rows[axis][k] * last.cell[k];
                    next.local[axis] += factor * last.local[k];
                    for (std::size_t by = 0; by < N; ++by)
                        next.along[by][axis] += factor * last.along[by][k];
                }
                const auto whole = static_cast<std::int64_t>(std::floor(static_cast<double>(product) / 4096));
                next.cell[axis] = wrapped(whole, 0);
                next.local[axis] += static_cast<double>(product - 4096 * whole) / 4096;
            } else {
                // The period of the first octave becomes a whole number of nodes of this one.
                const double scale = std::pow(fractal.lacunarity, i), period = place.period[axis];
                const double nodes = std::min(std::floor(period * scale + 0.5), 1e9);
                const double growth = period > 0 ? nodes / period : scale;
                next.period[axis] = period > 0 ? static_cast<std::int32_t>(nodes) : 0;
                const double at = wrapped(place.cell[axis], place.period[axis]) + place.local[axis];
                const double position = growth * (period > 0 ? at - period * std::floor(at / period) : at) +
                                        static_cast<double>(i) * offset[axis];
                next.cell[axis] = static_cast<std::int64_t>(std::floor(position));
                next.local[axis] = position - std::floor(position);
                next.along[axis][axis] = growth * place.radius[axis];
            }
        }
        octaves.push_back(next);
    }
    return octaves;
}

// E|n + sqrt(removed) z| over a normal z, which is a folded normal distribution, and its derivative by n.
std::array<double, 2> mean_magnitude(double n, double removed) {
    if (removed <= 0)
        return {std::abs(n), n < 0 ? -1.0 : 1.0};
    const double share = std::erf(n / std::sqrt(2 * removed));
    return {std::sqrt(2 * removed / pi) * std::exp(-n * n / (2 * removed)) + n * share, share};
}

template <std::size_t N>
FractalNoise<N> fractal_sum(const Place<N>& place, const std::optional<Pixel<N>>& pixel,
                            const Fractal& fractal, std::uint32_t seed) {
    FractalNoise<N> sum;
    double total = 0, left = 0;
    const std::vector<Octave<N>> octaves = octaves_of(place, fractal, seed);
    for (std::size_t i = 0; i < octaves.size(); ++i) {
        const Octave<N>& octave = octaves[i];
        double weight = std::pow(fractal.gain, i) * std::min(fractal.octaves - static_cast<double>(i), 1.0);
        total += weight * weight;
        const auto [filter, kept] =
            pixel ? filter_of(octave, *pixel, fractal.perlin) : std::pair(Filter<N>(), 1.0);
        const auto noise = octave_sum(octave, fractal.perlin, filter, place.time);
        Vector<N> gradient{};
        Symmetric<N> lost{};
        const auto in_pairs = [&](const auto& add) { // xx, yy, zz, then xy, xz, yz
            std::size_t k = N;
            for (std::size_t a = 0; a < N; ++a) {
                lost[a] += add(a, a);
                for (std::size_t b = a + 1; b < N; ++b)
                    lost[k++] += add(a, b);
            }
        };
        for (std::size_t axis = 0; axis < N; ++axis)
            for (std::size_t by = 0; by < N; ++by)
                gradient[by] += noise[axis + 1] * octave.along[by][axis];
        if (pixel) {
            const auto whole = powers(fractal.perlin, Filter<N>()), rest = powers(fractal.perlin, filter);
            in_pairs([&](std::size_t a, std::size_t b) {
                double covariance = 0;
                for (std::size_t axis = 0; axis < N; ++axis)
                    covariance += std::max(whole[axis + 1] - rest[axis + 1], 0.0) * octave.along[a][axis] *
                                  octave.along[b][axis];
                return covariance;
            });
        }
        double value = noise[0], share = kept;
        if (fractal.shape != Fractal::Shape::fbm)
            sum.crease = std::min(sum.crease, std::sqrt(value * value + 1 - kept));
        if (fractal.shape != Fractal::Shape::fbm) {
            const auto [mean, slope] = mean_magnitude(value, 1 - kept);
            value = mean - std::sqrt(2 / pi);
            in_pairs([&, slope = slope](std::size_t a, std::size_t b) {
                return (1 - slope * slope) * gradient[a] * gradient[b];
            });
            for (double& along : gradient)
                along *= slope;
            // E|a b| of normal values with correlation `kept`, minus the square of E|a|
            share = 2 / pi * (std::sqrt(1 - kept * kept) + kept * std::asin(kept) - 1);
            weight *= (fractal.shape == Fractal::Shape::ridged ? -1 : 1) / std::sqrt(1 - 2 / pi);
        }
        sum.noise += weight * value;
        left += weight * weight * share;
        for (std::size_t axis = 0; axis < N; ++axis)
            sum.gradient[axis] += weight * gradient[axis];
        for (std::size_t k = 0; k < lost.size(); ++k)
            sum.lost[k] += weight * weight * lost[k];
    }
    sum.noise /= std::sqrt(total);
    for (double& along : sum.gradient)
        along /= std::sqrt(total);
    for (double& one : sum.lost)
        one /= total;
    sum.removed = pixel ? std::clamp(1 - left / total, 0.0, 1.0) : 0;
    return sum;
}

} // namespace

Vector<2> fractal_windows(bool perlin, double variance, double distance) {
    const Window h = window(perlin, variance);
    Vector<2> windows{}, squares{};
    for (int node = -4; node <= 4; ++node) { // as many as reach any point
        const auto all = h.at(distance - std::floor(distance) + node);
        for (std::size_t k = 0; k < 2; ++k)
            squares[k] += all[k] * all[k];
    }
    for (std::size_t k = 0; k < 2; ++k)
        windows[k] = h.at(distance)[k] / std::sqrt(squares[k]);
    return windows;
}

Vector<2> fractal_kept(double variance) {
    return {kept_even(variance), kept_odd(variance)};
}

template <std::size_t N>
FractalNoise<N> fractal_noise(const Place<N>& place, const Fractal& fractal, std::uint32_t seed) {
    return fractal_sum<N>(place, {}, fractal, seed);
}

template <std::size_t N>
FractalNoise<N> fractal_noise(const Place<N>& place, const Pixel<N>& pixel, const Fractal& fractal,
                              std::uint32_t seed) {
    return fractal_sum<N>(place, pixel, fractal, seed);
}

template <std::size_t N>
double rounding_margin(const Place<N>& place, const Fractal& fractal) {
    double margin = 0.5;
    const auto see = [&](double number) {
        margin = std::min(margin, std::abs(number - std::floor(number) - 0.5));
    };
    if (is_endless(place))
        for (const double number : step_of(fractal, place.local))
            see(4096 * number);
    else
        for (double i = 1; i < fractal.octaves; ++i)
            for (const std::int32_t period : place.period)
                see(period * std::pow(fractal.lacunarity, i));
    return margin;
}

template FractalNoise<2> fractal_noise(const Place<2>&, const Fractal&, std::uint32_t);
template FractalNoise<3> fractal_noise(const Place<3>&, const Fractal&, std::uint32_t);
template FractalNoise<2> fractal_noise(const Place<2>&, const Pixel<2>&, const Fractal&, std::uint32_t);
template FractalNoise<3> fractal_noise(const Place<3>&, const Pixel<3>&, const Fractal&, std::uint32_t);
template double rounding_margin(const Place<2>&, const Fractal&);
template double rounding_margin(const Place<3>&, const Fractal&);

} // namespace gabor::noise

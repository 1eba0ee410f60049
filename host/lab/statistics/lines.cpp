#include "statistics/lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace gabor::statistics {

namespace {

constexpr int cell = Lines::pixels_per_cell;

// In cycles per cell along x and y. Frequencies that are their own mirror images are missing, because their
// power has half the degrees of freedom.
constexpr std::array<std::array<int, 2>, 6> frequencies{{{1, 0}, {0, 1}, {1, 1}, {1, -1}, {1, 2}, {2, 1}}};

} // namespace

Lines::Lines(int side) : side_(side) {
    if (side < 32 || side % cell != 0)
        throw std::invalid_argument("lines need pictures of whole cells, at least eight along a side");
    for (int step = 0; step <= reach; ++step) {
        for (int x = 0; x < side; ++x) {
            const double phase = 2 * std::numbers::pi * step * x / side;
            cosine_.push_back(static_cast<float>(std::cos(phase)));
            sine_.push_back(static_cast<float>(std::sin(phase)));
        }
    }
    sums_.resize(std::size_t{steps} * steps * cell * cell);
    powers_.resize(frequencies.size() * steps * steps);
}

// At f cycles per cell plus `step` cycles per picture, pixel x = cell * m + r has the phase -2 pi (f r / cell
// + step x / side). So the sums over m, one for each r, serve every f.
void Lines::add_row(std::span<const float> row) {
    std::array<std::array<Complex, cell>, steps> along{};
    const auto side = static_cast<std::size_t>(side_);
    for (std::size_t step = 0; step <= reach; ++step) {
        std::array<double, cell> real{};
        std::array<double, cell> imaginary{};
        const float* cosine = cosine_.data() + step * side;
        const float* sine = sine_.data() + step * side;
        for (std::size_t x = 0; x < side; x += cell) {
            for (std::size_t r = 0; r < cell; ++r) {
                real[r] += double{row[x + r] * cosine[x + r]};
                imaginary[r] -= double{row[x + r] * sine[x + r]};
            }
        }
        for (std::size_t r = 0; r < cell; ++r) {
            along[reach + step][r] = {real[r], imaginary[r]};
            along[reach - step][r] = {real[r], -imaginary[r]};
        }
    }
    for (int step = 0; step < steps; ++step) {
        const Complex turn = std::polar(1.0, -2 * std::numbers::pi * (step - reach) * row_ / side_);
        Complex* sum = sums_.data() + std::ptrdiff_t{step * cell + row_ % cell} * steps * cell;
        for (const auto& residues : along)
            for (const Complex& part : residues)
                *sum++ += turn * part;
    }
    if (++row_ == side_)
        end_picture();
}

void Lines::end_picture() {
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
        const auto [fx, fy] = frequencies[f];
        for (std::size_t y = 0; y < steps; ++y) {
            for (std::size_t x = 0; x < steps; ++x) {
                Complex sum = 0;
                for (std::size_t ry = 0; ry < cell; ++ry)
                    for (std::size_t rx = 0; rx < cell; ++rx)
                        sum += std::polar(1.0,
                                          -2 * std::numbers::pi / cell *
                                              (fx * static_cast<double>(rx) + fy * static_cast<double>(ry))) *
                               sums_[((y * cell + ry) * steps + x) * cell + rx];
                powers_[(f * steps + y) * steps + x] += std::norm(sum);
            }
        }
    }
    std::ranges::fill(sums_, Complex());
    row_ = 0;
}

double Lines::largest() const {
    double result = std::numeric_limits<double>::quiet_NaN();
    constexpr std::size_t around = std::size_t{steps} * steps;
    for (std::size_t f = 0; f < frequencies.size(); ++f) {
        const double line = powers_[f * around + around / 2];
        double sum = -line;
        for (std::size_t i = 0; i < around; ++i)
            sum += powers_[f * around + i];
        result = std::fmax(result, line / (sum / (around - 1))); // fmax ignores NaN
    }
    return result;
}

void NoiseLines::add_row(std::span<const float> row) {
    using Of = float (*)(float);
    constexpr std::array<Of, count> functions{
        [](float n) { return n; }, [](float n) { return n * n; }, [](float n) { return std::abs(n); },
        [](float n) { return n * n * n * n; }, [](float n) { return std::abs(n) > 2.5f ? 1.0f : 0.0f; }};
    of_row_.resize(row.size());
    for (std::size_t f = 0; f < count; ++f) {
        std::ranges::transform(row, of_row_.begin(), functions[f]);
        lines_[f].add_row(of_row_);
    }
}

std::array<double, NoiseLines::count> NoiseLines::largest() const {
    std::array<double, count> result{};
    std::ranges::transform(lines_, result.begin(), &Lines::largest);
    return result;
}

} // namespace gabor::statistics

// Compares hills and erosion with the double-precision reference, and checks the properties of a good
// terrain.

#include "noise.hpp"
#include "reference/erosion.hpp"
#include "statistics/moments.hpp"

#include <bit>
#include <optional>
#include <vector>

using namespace gabor;
using noise::Terrain;
using test::Largest;
using test::Random;

namespace {

struct Sample {
    std::int32_t column = 0, row = 0;
    gabor_vec2 local{0, 0}, period{0, 0}, dx{0, 0}, dy{0, 0};
    std::optional<Terrain> base; // replaces the hills; exactly representable in floats
    std::uint32_t seed = 7;
    noise::Erosion erosion;

    noise::Ground ground() const { return {{column, row}, {local.x, local.y}, {period.x, period.y}}; }
    Sample beside(float x, float y) const {
        Sample moved = *this;
        moved.local = local + gabor_vec2(x, y);
        return moved;
    }
};

std::string to_string(const Sample& s) {
    const auto& e = s.erosion;
    const Terrain base = s.base.value_or(Terrain());
    return fmt::format("cell ({}, {}) + ({}, {}), period ({}, {}), pixel ({}, {}) ({}, {}), base {} {} ({}, "
                       "{}) {}, seed {}, erosion {} {} {} {} {} {} {} {} {} {} {} {}",
                       s.column, s.row, s.local.x, s.local.y, s.period.x, s.period.y, s.dx.x, s.dx.y, s.dy.x,
                       s.dy.y, s.base.has_value(), base.height, base.slope[0], base.slope[1], base.ridge,
                       s.seed, e.octaves, e.gully_frequency, e.strength, e.lacunarity, e.gain, e.onset_slope,
                       e.detail, e.uniformity, e.ridge_rounding, e.crease_rounding, e.gully_weight,
                       e.branching);
}

// The drop-in's terrain, converted to the reference's types.
template <typename Functions>
struct Terrains {
    using GaborTerrain = typename Functions::GaborTerrain;
    Functions n;

    static Terrain wide(const GaborTerrain& t) {
        return {t.height,
                {t.slope.x, t.slope.y},
                t.ridge,
                {t.curvature.x, t.curvature.y, t.curvature.z},
                {t.ridge_slope.x, t.ridge_slope.y}};
    }
    static auto erosion(const Sample& s) {
        return std::bit_cast<typename Functions::GaborErosion>(s.erosion);
    }
    static auto ground(const Sample& s) {
        return typename Functions::GaborTerrainPlace{{s.column, s.row}, s.local, s.period};
    }

    GaborTerrain base(const Sample& s) {
        if (!s.base)
            return n.gabor_terrain_at(ground(s), s.dx, s.dy, s.seed);
        const auto at = [](double value) { return static_cast<float>(value); };
        const auto& [height, slope, ridge, curvature, ridge_slope, crease] = *s.base;
        return {at(height),
                {at(slope[0]), at(slope[1])},
                at(ridge),
                {at(curvature[0]), at(curvature[1]), at(curvature[2])},
                {at(ridge_slope[0]), at(ridge_slope[1])}};
    }
    Terrain hills(const Sample& s) { return wide(n.gabor_terrain_at(ground(s), s.dx, s.dy, s.seed)); }
    Terrain eroded(const Sample& s) {
        return wide(n.gabor_eroded_at(ground(s), s.dx, s.dy, base(s), erosion(s), s.seed));
    }
};

Sample drawn(Random& random) {
    Sample s;
    const bool far = random.word() % 2, tiled = random.one_in(4);
    const auto cell = [&] {
        return tiled ? 0 : far ? random.cell() : static_cast<std::int32_t>(random.uniform(-5, 5));
    };
    s.column = cell();
    s.row = cell();
    for (int axis = 0; axis < 2; ++axis) {
        s.local[axis] = random.one_in(8) ? std::round(random.uniform(-2, 2)) : random.uniform(0, 1);
        s.period[axis] = tiled && !random.one_in(4) ? std::round(random.uniform(4, 9)) : 0;
        if (random.word() % 2) {
            s.dx[axis] = random.uniform(-0.2, 0.2);
            s.dy[axis] = random.uniform(-0.2, 0.2);
        }
    }
    if (random.word() % 2)
        s.base = {random.uniform(-1, 1),
                  {random.uniform(-1, 1), random.uniform(-1, 1)},
                  random.uniform(-1, 1),
                  {random.uniform(-2, 2), random.uniform(-2, 2), random.uniform(-2, 2)},
                  {random.uniform(-2, 2), random.uniform(-2, 2)}};
    s.seed = random.word();
    s.erosion = {static_cast<int>(random.word() % 7),
                 std::exp2(random.uniform(-2, 4)),
                 random.uniform(0, 0.3),
                 random.word() % 2 ? 2 : random.uniform(1.5, 2.5),
                 random.uniform(0.3, 0.7),
                 random.uniform(0.2, 2),
                 random.uniform(1, 3),
                 random.uniform(1, 4),
                 random.one_in(4) ? 0 : random.uniform(0, 0.5),
                 random.one_in(4) ? 0 : random.uniform(0, 0.5),
                 random.uniform(0, 1),
                 random.uniform(0, 1.5)};
    return s;
}

// Samples at random points, each in its own terrain.
std::vector<Sample> anywhere(std::size_t count, unsigned seed) {
    Random random(seed);
    std::vector<Sample> samples(count);
    for (Sample& sample : samples) {
        sample.local = random.uniform<gabor_vec2>(0, 8);
        sample.seed = random.word();
    }
    return samples;
}

// Samples of one octave of gullies, each on a plane that slopes in a random direction.
std::vector<Sample> on_planes(std::size_t count, unsigned seed) {
    std::vector<Sample> samples = anywhere(count, seed);
    Random random(seed + 1);
    for (Sample& sample : samples) {
        const double turn = random.uniform(0, 6.2831853);
        sample.base = {0, {std::cos(turn), std::sin(turn)}, 0};
        sample.erosion.octaves = 1;
    }
    return samples;
}

// ---- Measures of a terrain. docs/performance.md has their values.

// The largest step of the height over an interval of 1/64 that is halved 12 times. Each time, the half with
// the larger step is kept, so a jump does not shrink.
double largest_step(auto terrains) {
    double largest = 0;
    for (Sample left : anywhere(1 << 14, 1)) {
        Sample right = left.beside(1.0f / 64, 0);
        double low = terrains.eroded(left).height, high = terrains.eroded(right).height;
        for (int halvings = 0; halvings < 12; ++halvings) {
            const Sample middle = left.beside(0.5f * (right.local.x - left.local.x), 0);
            const double here = terrains.eroded(middle).height;
            const bool lower = std::abs(here - low) > std::abs(high - here);
            (lower ? right : left) = middle;
            (lower ? high : low) = here;
        }
        largest = std::max(largest, std::abs(high - low));
    }
    return largest;
}

// The mean angle in degrees between the gullies of one octave and the slope of the hills, weighted by the
// square of the gullies' own slope.
double gully_angle(auto terrains) {
    constexpr float step = 1.0f / 256;
    double sum = 0, weight = 0;
    for (Sample s : anywhere(1 << 14, 2)) {
        s.erosion.octaves = 1;
        const auto gully = [&](float x, float y) { return terrains.eroded(s.beside(x, y)).ridge; };
        const double x = gully(step, 0) - gully(-step, 0), y = gully(0, step) - gully(0, -step);
        const auto [fall_x, fall_y] = terrains.hills(s).slope;
        const double power = x * x + y * y, fall = std::hypot(fall_x, fall_y);
        if (fall < 0.3 || power == 0)
            continue;
        sum += power * std::asin(std::abs(x * fall_x + y * fall_y) / (std::sqrt(power) * fall));
        weight += power;
    }
    return sum / weight * 180 / std::numbers::pi;
}

// The number of local minima of the terrain per unit area, minus that of the hills. A minimum is lower than
// all eight neighbours, which are 1/64 away.
double pits(auto terrains) {
    constexpr int side = 128;
    int count = 0;
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        std::vector<double> eroded, hills;
        for (int i = 0; i < side * side; ++i) {
            Sample s = Sample().beside(static_cast<float>(i % side) / 64, static_cast<float>(i / side) / 64);
            s.seed = seed;
            eroded.push_back(terrains.eroded(s).height);
            hills.push_back(terrains.hills(s).height);
        }
        const auto is_lowest = [](const std::vector<double>& heights, int i) {
            const auto at = [&](int k) { return heights[static_cast<std::size_t>(k)]; };
            for (const int k : {-1, 1, -side, side, -side - 1, -side + 1, side - 1, side + 1})
                if (at(i + k) <= at(i))
                    return 0;
            return 1;
        };
        for (int y = 1; y + 1 < side; ++y)
            for (int x = 1; x + 1 < side; ++x)
                count += is_lowest(eroded, y * side + x) - is_lowest(hills, y * side + x);
    }
    return count / (8 * std::pow((side - 2) / 64.0, 2));
}

// The largest curvature of gullies on planes, divided by the RMS curvature. A high ratio reveals spikes,
// which could appear where waves cancel.
double spikes(auto terrains) {
    constexpr float step = 1.0f / 64;
    double largest = 0, square = 0;
    const std::vector<Sample> samples = on_planes(1 << 17, 3);
    for (const Sample& s : samples) {
        const auto height = [&](float x, float y) { return terrains.eroded(s.beside(x, y)).height; };
        const double curvature =
            height(-step, 0) + height(step, 0) + height(0, -step) + height(0, step) - 4 * height(0, 0);
        largest = std::max(largest, std::abs(curvature));
        square += curvature * curvature;
    }
    return largest / std::sqrt(square / static_cast<double>(samples.size()));
}

// How much more power the slopes have along the axes than along the diagonals, as a share of the total.
double axes(auto terrains) {
    double fourfold = 0, power = 0;
    for (const Sample& s : anywhere(1 << 18, 5)) {
        const auto [x, y] = terrains.eroded(s).slope;
        const double square = x * x + y * y;
        fourfold += square * std::cos(4 * std::atan2(y, x));
        power += square;
    }
    return fourfold / power;
}

// How much the mean square of gullies on planes varies over a cell of their lattice, which is `cell` wide:
// (largest - least) / mean over 4 x 4 parts of the cell.
double cells(auto terrains, double cell) {
    std::array<statistics::Moments, 16> squares;
    for (const Sample& s : on_planes(1 << 18, 7)) {
        const auto part = [&](double p) {
            return static_cast<std::size_t>(4 * (p / cell - std::floor(p / cell))) % 4;
        };
        squares.at(4 * part(s.local.y) + part(s.local.x)).add(std::pow(terrains.eroded(s).ridge, 2));
    }
    statistics::Moments means;
    for (const statistics::Moments& square : squares)
        means.add(square.mean());
    return (means.maximum() - means.minimum()) / means.mean();
}

template <typename Functions>
void compare(Terrains<Functions> terrains) {
    constexpr int taps = Functions::taps;
    auto& n = terrains.n;
    Random random(taps);
    test::Differences of;
    statistics::Moments error, slope;
    for (int i = 0; i < 1 << 15; ++i) {
        const Sample s = drawn(random);
        const noise::Vector<2> dx{s.dx.x, s.dx.y}, dy{s.dy.x, s.dy.y};
        const Terrain hills = terrains.hills(s), wanted = noise::terrain(s.ground(), dx, dy, s.seed);
        of["gabor_terrain_at"].see(hills.height, wanted.height, 5e-7, s);
        of["gabor_terrain_at"].see(hills.ridge, wanted.ridge, 1e-6, s);
        const Terrain found = terrains.eroded(s);
        const Terrain eroded =
            noise::eroded(taps, s.ground(), dx, dy, s.base.value_or(hills), s.erosion, s.seed);
        const double finest =
            s.erosion.gully_frequency * std::pow(s.erosion.lacunarity, s.erosion.octaves - 1);
        of["gabor_eroded_at"].see(found.height, eroded.height, 5e-6, s);
        of["  its ridge"].see(found.ridge, eroded.ridge, 2e-4, s);
        for (std::size_t k = 0; k < 3; ++k)
            of["  its curvature"].see(hills.curvature[k], wanted.curvature[k], taps == 4 ? 1.5e-5 : 1e-5, s);
        for (std::size_t axis = 0; axis < 2; ++axis) {
            of["gabor_terrain_at"].see(hills.slope[axis], wanted.slope[axis], 2e-6, s);
            of["  its ridge's slope"].see(hills.ridge_slope[axis], wanted.ridge_slope[axis], 5e-6, s);
            if (eroded.crease > 1e-3)
                continue;
            of["  its slope"].see(found.slope[axis], eroded.slope[axis], 1e-4 + 4e-6 * finest, s);
            error.add(found.slope[axis] - eroded.slope[axis]);
            slope.add(eroded.slope[axis]);
        }
        const bool plain = s.column == 0 && s.row == 0 && s.period.x == 0 && s.period.y == 0 && s.dx.x == 0 &&
                           s.dx.y == 0 && s.dy.x == 0;
        if (plain && !s.base)
            of["gabor_eroded"].see(
                n.gabor_eroded(s.local, n.gabor_terrain(s.local, s.seed), terrains.erosion(s), s.seed).height,
                found.height, 1e-5, s);
    }
    const double rms = std::sqrt(slope.variance()), worst = std::max(error.maximum(), -error.minimum());
    fmt::print("slope: rms error {:.5f} of the rms slope {:.3f}, at worst {:.5f}, at {} of {} places\n",
               std::sqrt(error.variance()) / rms, rms, worst / rms, slope.count() / 2, 1 << 15);
    CHECK(slope.count() > 65000);
    CHECK(std::sqrt(error.variance()) < 0.001 * rms);
    CHECK(worst < 0.01 * rms);
    fmt::print("{} taps; largest differences in units of the tolerance\n", taps);
    test::check(of, 7);
}

template <typename Functions>
void check_properties(Terrains<Functions> terrains) {
    constexpr int taps = Functions::taps;
    const auto at_most = [&](const char* name, double value, double limit) {
        fmt::print("{} taps, {}: {:.3g} of {:.3g}\n", taps, name, value, limit);
        CHECK(value <= limit);
    };
    at_most("step over 1/262144", largest_step(terrains), 2e-4);
    at_most("degrees between gullies and slope", gully_angle(terrains), 22);
    at_most("pits per unit of area", pits(terrains), 6);
    at_most("spikes", spikes(terrains), 9);
    at_most("axes", std::abs(axes(terrains)), 0.015);
    at_most("cells", cells(terrains, 2 / (0.8 * taps * 1.5)), 0.05);
}

template <typename Functions>
void check_tiles(Terrains<Functions> terrains) {
    Random random(13);
    int equal = 0;
    for (Sample s : anywhere(1 << 14, 15)) {
        const double endless = terrains.eroded(s).height;
        Sample moved = s;
        for (int axis = 0; axis < 2; ++axis) { // numbers with few bits, so that sums and products are exact
            s.local[axis] = std::round(64 * s.local[axis]) / 64;
            s.period[axis] = static_cast<float>(4 << random.word() % 3);
            moved.period[axis] = s.period[axis];
            moved.local[axis] = s.local[axis] + s.period[axis] * std::round(random.uniform(-3, 3));
        }
        INFO(to_string(s));
        const Terrain here = terrains.eroded(s), there = terrains.eroded(moved);
        REQUIRE(terrains.hills(s).height == terrains.hills(moved).height);
        REQUIRE(here.height == there.height);
        REQUIRE(here.slope[1] == there.slope[1]);
        equal += here.height == endless;
    }
    CHECK(equal < 160); // a period changes the terrain
}

} // namespace

// Rounding in one octave rotates the gullies of the next, so the tolerances exceed the rounding errors.
TEST_CASE("hills and erosion agree with the reference", "[erosion][oracle]") {
    compare(Terrains<test::Lattice2>());
    compare(Terrains<test::Lattice3>());
    compare(Terrains<test::Lattice4>());
}

TEST_CASE("eroded heights are continuous, and gullies run down the slope without spikes or traces of a "
          "lattice",
          "[erosion]") {
    check_properties(Terrains<test::Lattice2>());
    check_properties(Terrains<test::Lattice3>());
}

TEST_CASE("eroded tiles have no seam", "[erosion]") {
    check_tiles(Terrains<test::Lattice2>());
    check_tiles(Terrains<test::Lattice3>());
}

TEST_CASE("a mountain of another size is the same near the origin", "[erosion]") {
    Terrains<test::Lattice3> terrains;
    for (const auto& [distance, most, size] :
         {std::tuple(10, 3e-4, 2.0f), {100, 3e-3, 2.0f}, {10, 3e-4, 0x1p-12f}}) {
        Largest largest;
        Random random(19);
        for (int i = 0; i < 10000; ++i) {
            Sample one;
            one.local =
                random.uniform<gabor_vec2>(-static_cast<float>(distance), static_cast<float>(distance));
            one.base = terrains.hills(one);
            if (size < 1)
                one.erosion.octaves = 2; // more would be beyond the range of frequencies
            Sample other = one;
            other.local = size * one.local;
            other.base->height *= size;
            for (double& curvature : other.base->curvature)
                curvature /= size;
            other.erosion.gully_frequency /= size;
            largest.see(terrains.eroded(other).height / size, terrains.eroded(one).height, most, one);
        }
        largest.check(fmt::format("{} times as large, up to {}", size, distance));
    }
}

TEST_CASE("filtering gullies keeps the mean height", "[erosion]") {
    Terrains<test::Lattice3> terrains;
    std::vector<Sample> samples = anywhere(1 << 17, 11);
    std::vector<double> sharp;
    double relief = 0;
    for (Sample& s : samples) {
        sharp.push_back(terrains.eroded(s).height);
        relief += std::pow(sharp.back(), 2) / static_cast<double>(samples.size());
        s.base = terrains.hills(s); // unfiltered, so that only the gullies differ
    }
    relief = std::sqrt(relief);
    for (const float pixel : {1 / 64.0f, 1 / 24.0f, 1 / 8.0f, 1 / 3.0f, 1.0f, 100.0f}) {
        std::array<statistics::Moments, 3> differences; // in valleys, on slopes, on peaks
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].dx.x = samples[i].dy.y = pixel;
            const double ridge = samples[i].base->ridge;
            differences.at(ridge < -0.5  ? 0
                           : ridge < 0.5 ? 1
                                         : 2)
                .add(terrains.eroded(samples[i]).height - sharp[i]);
        }
        for (const statistics::Moments& difference : differences) {
            const double mean = difference.mean(),
                         error = std::sqrt(difference.variance() / static_cast<double>(difference.count()));
            fmt::print("pixel {:.3f}: {:.2f} +- {:.2f} % of the relief {:.3f}\n", pixel, 100 * mean / relief,
                       100 * error / relief, relief);
            CHECK(std::abs(mean) + 2 * error < 0.01 * relief);
        }
    }
}

// The filter is Gaussian, with a deviation of half the pixel's side. The last pixel is so large that only the
// mean remains.
TEST_CASE("filtered hills are close to the mean of the hills over each pixel, and have the same overall mean",
          "[erosion]") {
    Terrains<test::Lattice3> terrains;
    constexpr int places = 1 << 14, points = 64;
    const std::vector<Sample> middles = anywhere(places, 17);
    struct {
        float pixel;
        double error; // root mean square, relative to the hills' deviation
    } constexpr wanted[]{{1 / 16.0f, 0.02}, {1 / 4.0f, 0.1}, {1, 0.4}, {100, 0.13}};
    for (const auto& [pixel, limit] : wanted) {
        std::mt19937 generator(19);
        std::normal_distribution<float> spread(0, pixel / 2);
        double error = 0, power = 0, bias = 0;
        for (Sample s : middles) {
            double mean = 0;
            for (int k = 0; k < points; ++k) {
                const double height = terrains.hills(s.beside(spread(generator), spread(generator))).height;
                mean += height / points;
                power += std::pow(height, 2) / (places * points);
            }
            s.dx.x = s.dy.y = pixel;
            const double difference = terrains.hills(s).height - mean;
            error += std::pow(difference, 2) / places;
            bias += difference / places;
        }
        error = std::sqrt(error / power);
        bias = std::abs(bias) / std::sqrt(power);
        fmt::print("pixel {:.3f}: rms error {:.4f} of the hills' deviation, bias {:.4f}\n", pixel, error,
                   bias);
        CHECK(error < limit);
        CHECK(bias < 0.01);
    }
}

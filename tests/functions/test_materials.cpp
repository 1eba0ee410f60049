// Checks the slopes of materials, the covariance of slopes that their filters remove, the gloss that follows
// from it, and that colours keep their mean, against differences and averages of the plain materials.

#include "compare.hpp"

#include "gabor_noise.hpp"

#include "gabor_spectrum.hpp"

#include "gabor_fractal.hpp"

#include "gabor_materials.hpp"

#include "gabor_compose.hpp"

#include <boost/math/distributions/normal.hpp>
#include <catch2/catch.hpp>

#include <cstring>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

using namespace gabor::noise;
using gabor::test::Random;
using Vec2 = gabor_vec2;
using Numbers = std::vector<float>;
using Ranges = std::vector<std::pair<float, float>>;

namespace {

struct Material {
    const char* name;
    float step;     // for differences of the height
    double fixed;   // largest error of filtered slopes, relative to their rms
    double gloss;   // largest error of gabor_roughness in a room, relative to the mean
    Ranges numbers; // documented ranges
    Numbers defaults;
    GaborMaterial (*plain)(Vec2 p, const Numbers& parameters, unsigned seed);
    GaborMaterial (*filtered)(Vec2 p, Vec2 dx, Vec2 dy, const Numbers& parameters, unsigned seed);
};

template <typename T>
Numbers numbers_of(const T& parameters) {
    Numbers numbers(sizeof(T) / sizeof(float));
    std::memcpy(numbers.data(), &parameters, sizeof(T));
    return numbers;
}

template <typename T>
T parameters_of(const Numbers& numbers) {
    T parameters;
    std::memcpy(&parameters, numbers.data(), sizeof(T));
    return parameters;
}

// Wood on boards of a unit by half of one, of which half are turned.
GaborMaterial on_boards(Vec2 p, Vec2 dx, Vec2 dy, const Numbers& n, unsigned seed) {
    GaborBoards boards = gabor_boards_default();
    boards.board_width = 1;
    boards.board_length = 0.5f;
    boards.turned_share = 0.5f;
    const GaborBoard board = gabor_board(p, dx, dy, Vec2(0), boards, seed);
    const auto wood = parameters_of<GaborWood>(n);
    return gabor_laid(
        dx.x > 0 ? gabor_wood_filtered_at(board.position, board.dx, board.dy, Vec2(0), wood, board.seed)
                 : gabor_wood_at(board.position, Vec2(0), wood, board.seed),
        board, boards);
}

// Leather with a finish, of which every part is on.
GaborMaterial with_finish(Vec2 p, Vec2 dx, Vec2 dy, const Numbers& n, unsigned seed) {
    GaborFinish finish = gabor_finish_default();
    finish.dirt_amount = 0.5f;
    finish.dust_amount = 0.3f;
    finish.grain_stretch = 3;
    finish.grain_height = 5e-4f;
    const auto leather = parameters_of<GaborLeather>(n);
    return dx.x > 0 ? gabor_finished_filtered(gabor_leather_filtered_at(p, dx, dy, Vec2(0), leather, seed), p,
                                              dx, dy, Vec2(0), finish, seed)
                    : gabor_finished(gabor_leather_at(p, Vec2(0), leather, seed), p, Vec2(0), finish, seed);
}

// Sandstone under paint on boards of a unit by half of one, or under sand without boards.
GaborMaterial with_coat(Vec2 p, Vec2 dx, Vec2 dy, bool paint, unsigned seed) {
    GaborBoards boards = gabor_boards_default();
    boards.board_width = 1;
    boards.board_length = 0.5f;
    const GaborBoard board = gabor_board(p, dx, dy, Vec2(0), boards, seed);
    GaborCoat coat = gabor_coat_default();
    coat.thickness = paint ? 0.01f : 1.0f;
    coat.level = paint ? 0.03f : 0.0f;
    coat.raggedness = paint ? 0.4f : 0.1f;
    const Vec2 to_edge = paint ? board.to_edge : Vec2(1000);
    return dx.x > 0 ? gabor_coated_filtered(gabor_strata_filtered(p, dx, dy, seed), p, dx, dy, Vec2(0),
                                            to_edge, coat, seed)
                    : gabor_coated(gabor_strata(p, seed), p, Vec2(0), to_edge, coat, seed);
}

// A material that a mask raises, with the mask's gradient.
GaborMaterial raised(GaborMaterial m, Vec2 p) {
    m.height += 0.02f * (p.x - p.y);
    m.slope.x += 0.02f;
    m.slope.y -= 0.02f;
    return m;
}

// clang-format off
#define MADE(type, name, ...) {&#name[6], __VA_ARGS__, numbers_of(name##_default()), \
    [](Vec2 p, const Numbers& n, unsigned seed) { return name##_at(p, Vec2(0), parameters_of<type>(n), seed); }, \
    [](Vec2 p, Vec2 dx, Vec2 dy, const Numbers& n, unsigned seed) { \
        return name##_filtered_at(p, dx, dy, Vec2(0), parameters_of<type>(n), seed); }}
// clang-format on
const std::vector<Material> materials = [] {
    std::vector<Material> all{
        MADE(GaborWood, gabor_wood, 2e-4f, 0.03, 0.06, Ranges{{2, 60}, {0, 3}, {0, 1}, {0, 1}}),
        MADE(GaborFabric, gabor_fabric, 2e-4f, 0.03, 0.09,
             Ranges{{2, 60}, {0, 2}, {0, 3}, {0, 1}, {0, 20}, {0, 2}}),
        MADE(GaborLeather, gabor_leather, 1e-3f, 0.03, 0.1, Ranges{{2, 30}, {0, 3}, {0, 3}, {0, 0.7f}}),
        MADE(GaborMarble, gabor_marble, 1e-4f, 0.01, 0.02, Ranges{{0, 1.3f}, {0, 2}, {0, 1}, {0, 1}}),
        MADE(GaborSand, gabor_sand, 1e-3f, 0.03, 0.08, Ranges{{1, 20}, {0, 0.2f}, {0, 0.25f}, {0, 1}}),
        MADE(GaborBrushedMetal, gabor_brushed_metal, 5e-5f, 0.01, 0.06,
             Ranges{{1, 50}, {0, 0.5f}, {0, 0.01f}, {0, 1}, {0, 1}}),
        MADE(GaborScratches, gabor_scratches, 1e-4f, 0.01, 0.06,
             Ranges{{0.01f, 8}, {0.3f, 10}, {-6, 6}, {0, 3.1f}, {0, 0.02f}, {0, 1}}),
        MADE(GaborZebra, gabor_zebra, 1e-4f, 0.01, 0.09,
             Ranges{{0.5f, 20}, {-6, 6}, {0, 1.57f}, {0, 3}, {0, 1}}),
        MADE(GaborBark, gabor_bark, 4e-4f, 0.03, 0.12, Ranges{{0.5f, 10}, {0, 1}, {0, 0.4f}, {0, 1}}),
        MADE(GaborCarbonFibre, gabor_carbon_fibre, 4e-4f, 0.03, 0.09,
             Ranges{{1, 20}, {0, 0.6f}, {0, 3}, {0, 1}}),
        MADE(GaborStrata, gabor_strata, 4e-4f, 0.03, 0.08, Ranges{{1, 30}, {0, 3}, {0, 3}, {0, 1}})};
    // What is off by default.
    for (const auto& [base, name, from_last, number] :
         {std::tuple(1, "herringbone", 0, 2.0f), {1, "corduroy", 1, 1.5f}, {5, "patina", 0, 0.55f}}) {
        all.push_back(all[static_cast<std::size_t>(base)]);
        all.back().name = name;
        all.back().defaults.rbegin()[from_last] = number;
        if (from_last == 1) // whose lobe would be rougher than 1
            all.back().gloss = 0.15;
    }
    const auto wood = numbers_of(gabor_wood_default());
    all.push_back(
        {"boards", 2e-4f, 0.03, 0.09, all.front().numbers, wood,
         [](Vec2 p, const Numbers& n, unsigned seed) { return on_boards(p, Vec2(0), Vec2(0), n, seed); },
         on_boards});
    all.push_back(
        {"finish",
         2e-4f,
         0.03,
         0.1,
         {},
         all[2].defaults,
         [](Vec2 p, const Numbers& n, unsigned seed) { return with_finish(p, Vec2(0), Vec2(0), n, seed); },
         with_finish});
    return all;
}();

// Materials with others over or under them. What shows is not the mean of what would show within a pixel.
const std::vector<Material> combined{
    {"painted",
     1e-4f,
     0.03,
     0,
     {},
     {},
     [](Vec2 p, const Numbers&, unsigned seed) { return with_coat(p, Vec2(0), Vec2(0), true, seed); },
     [](Vec2 p, Vec2 dx, Vec2 dy, const Numbers&, unsigned seed) {
         return with_coat(p, dx, dy, true, seed);
     }},
    {"buried",
     1e-4f,
     0.03,
     0,
     {},
     {},
     [](Vec2 p, const Numbers&, unsigned seed) { return with_coat(p, Vec2(0), Vec2(0), false, seed); },
     [](Vec2 p, Vec2 dx, Vec2 dy, const Numbers&, unsigned seed) {
         return with_coat(p, dx, dy, false, seed);
     }},
    {"covered",
     1e-4f,
     0.03,
     0,
     {},
     {},
     [](Vec2 p, const Numbers&, unsigned seed) {
         return gabor_covered(gabor_strata(p, seed), raised(gabor_marble(p, seed), p), 0.02f);
     },
     [](Vec2 p, Vec2 dx, Vec2 dy, const Numbers&, unsigned seed) {
         return gabor_covered(gabor_strata_filtered(p, dx, dy, seed),
                              raised(gabor_marble_filtered(p, dx, dy, seed), p), 0.02f);
     }},
    {"worn",
     1e-4f,
     0.03,
     0,
     {},
     {},
     [](Vec2 p, const Numbers&, unsigned seed) {
         return gabor_worn(gabor_strata(p, seed), raised(gabor_marble(p, seed), p), 0.01f);
     },
     [](Vec2 p, Vec2 dx, Vec2 dy, const Numbers&, unsigned seed) {
         return gabor_worn(gabor_strata_filtered(p, dx, dy, seed),
                           raised(gabor_marble_filtered(p, dx, dy, seed), p), 0.01f);
     }}};

double wide(float x) {
    return static_cast<double>(x);
}

double square(double x) {
    return x * x;
}

double square(Vec2 v) {
    return square(wide(v.x)) + square(wide(v.y));
}

GaborMaterial value_of(const Material& m, float pixel, Vec2 p, unsigned seed) {
    return pixel > 0 ? m.filtered(p, Vec2(pixel, 0), Vec2(0, pixel), m.defaults, seed)
                     : m.plain(p, m.defaults, seed);
}

// The light of a room with a bright window that `count` random facets with GGX's distribution mirror.
// `spread` holds their squared roughness along the surface, as a symmetric matrix: xx, yy, xy.
double mirrored(const GaborMaterial& m, const Vector<3>& spread, int count, Random& random) {
    const Vector<3> eye{-0.4, 0.2, 0.8944}, window{0.6, -0.3, 0.7416};
    const Vector<3> normal = unit(Vector<3>{-wide(m.slope.x), -wide(m.slope.y), 1});
    const Vector<3> x = unit(Vector<3>{1, 0, wide(m.slope.x)}), y = cross(normal, x);
    const double along = std::sqrt(spread[0]), both = along > 0 ? spread[2] / along : 0; // Cholesky
    const double across = std::sqrt(std::max(spread[1] - square(both), 0.0));
    double light = 0;
    for (int i = 0; i < count; ++i) {
        const double share = (i + wide(random.uniform(0, 0.9999))) / count;
        const double turn = wide(random.uniform(0, 6.2831853)), tilt = std::sqrt(share / (1 - share));
        const double first = tilt * std::cos(turn), second = tilt * std::sin(turn);
        const Vector<3> facet =
            unit(sum(1, normal, 1, sum(along * first, x, both * first + across * second, y)));
        const double seen = 2 * dot(facet, eye) * dot(facet, window) - dot(eye, window);
        light += (0.2 + 1 / (1 + std::exp(6 - 8 * seen))) / count;
    }
    return light;
}

double mirrored(const GaborMaterial& m, float roughness, int count, Random& random) {
    const double spread = square(square(wide(roughness)));
    return mirrored(m, Vector<3>{spread, spread, 0}, count, random);
}

} // namespace

// Near a crease, the second differences at a step and at half of it disagree by a twentieth of the rms slope:
// those points do not count. Steps are where rounding and truncation are smallest.
TEST_CASE("materials' slopes are the derivatives of their heights", "[materials]") {
    constexpr int points = 500;
    auto all = materials;
    all.insert(all.end(), combined.begin(), combined.end());
    for (const Material& m : all)
        for (const float pixel : {0.0f, 0.005f, 0.02f, 0.08f, 0.3f}) {
            Random random(3);
            double rms = 0;
            for (int i = 0; i < points; ++i)
                rms += square(value_of(m, pixel, random.uniform<Vec2>(0, 2), random.word()).slope) / points;
            rms = std::sqrt(rms);
            double error = 0;
            int creases = 0;
            for (int i = 0; i < points; ++i) {
                const Vec2 p = random.uniform<Vec2>(0, 2);
                const auto seed = random.word();
                const GaborMaterial middle = value_of(m, pixel, p, seed);
                double off = 0;
                bool crease = false;
                for (const int axis : {0, 1}) {
                    std::array<double, 2> difference, bend;
                    for (std::size_t half = 0; half < 2; ++half) {
                        Vec2 after = p, before = p;
                        after[axis] += m.step / (half ? 2.0f : 1.0f);
                        before[axis] -= m.step / (half ? 2.0f : 1.0f);
                        const double a = wide(value_of(m, pixel, after, seed).height);
                        const double b = wide(value_of(m, pixel, before, seed).height);
                        difference[half] = (a - b) / (wide(after[axis]) - wide(before[axis]));
                        bend[half] = a - 2 * wide(middle.height) + b;
                    }
                    crease |= std::abs(bend[0] - 4 * bend[1]) > 0.05 * wide(m.step) * rms;
                    off += square((4 * difference[1] - difference[0]) / 3 - wide(middle.slope[axis]));
                }
                creases += crease;
                error += crease ? 0 : off / points;
            }
            fmt::print("  {:<13} pixel {:.3f}: slopes off by {:.4f} of their rms, {} creases\n", m.name,
                       pixel, std::sqrt(error) / rms, creases);
            INFO(m.name << ", pixel " << pixel);
            CHECK(std::sqrt(error) <= (pixel > 0 ? m.fixed : 0.01) * rms);
            CHECK(creases < points / 5); // a filtered weave has the creases of 16 samples
        }
}

// Over a flat material, the coat's surface is normal with the deviation `variation`, and soft by 0.3 of the
// thickness.
TEST_CASE("a coat covers the share of a flat material that its level asks for, near and far", "[materials]") {
    const GaborMaterial flat{gabor_vec3(0), 0, Vec2(0), 0.2f, 1, gabor_vec3(0)};
    for (const float level : {-0.03f, 0.0f, 0.05f})
        for (const float pixel : {0.0f, 0.02f, 0.3f, 4.0f}) {
            GaborCoat coat = gabor_coat_default();
            coat.coat_colour = gabor_vec3(1);
            coat.level = level;
            const double deviation = std::hypot(wide(coat.variation), 0.3 * wide(coat.thickness));
            const double expected = 0.5 * std::erfc(-wide(level) / deviation / std::sqrt(2.0));
            Random random(11);
            constexpr int points = 20000;
            double share = 0, metal = 0;
            for (int i = 0; i < points; ++i) {
                const Vec2 p = random.uniform<Vec2>(0, 100);
                const auto seed = random.word();
                const GaborMaterial m = pixel > 0
                                            ? gabor_coated_filtered(flat, p, Vec2(pixel, 0), Vec2(0, pixel),
                                                                    Vec2(0), Vec2(1000), coat, seed)
                                            : gabor_coated(flat, p, Vec2(0), Vec2(1000), coat, seed);
                share += wide(m.colour.x) / points;
                metal += wide(m.metalness) / points;
                REQUIRE(m.height >= -1e-7f);
                REQUIRE(m.height <= 1.0001f * coat.thickness);
            }
            fmt::print("  level {:.2f}, pixel {:.2f}: coat on {:.3f}, expected {:.3f}\n", level, pixel, share,
                       expected);
            CHECK(std::abs(share - expected) < 0.012);
            CHECK(std::abs(share + metal - 1) < 1e-4);
        }
}

TEST_CASE("a material's filter keeps or loses all variance of its slopes", "[materials]") {
    const auto add = [](Vector<3>& covariance, Vec2 v, const gabor_vec3& lost) { // xx, yy, xy
        const Vector<2> slope{wide(v.x), wide(v.y)};
        covariance = sum(1, covariance, 1,
                         Vector<3>{square(slope[0]) + wide(lost.x), square(slope[1]) + wide(lost.y),
                                   slope[0] * slope[1] + wide(lost.z)});
    };
    for (const Material& m : materials)
        for (const auto& [dx, dy] : {std::pair(Vec2(0.004f, 0), Vec2(0, 0.004f)),
                                     {Vec2(0.014f, 0.014f), Vec2(-0.001f, 0.001f)}, // long and oblique
                                     {Vec2(0.016f, 0), Vec2(0, 0.016f)},
                                     {Vec2(0.06f, 0), Vec2(0, 0.06f)},
                                     {Vec2(0.25f, 0), Vec2(0, 0.25f)},
                                     {Vec2(1, 0), Vec2(0, 1)}}) {
            Random random(5);
            Vector<3> whole{}, kept{}, both{};
            for (int i = 0; i < 5000; ++i) {
                const Vec2 p = random.uniform<Vec2>(0, 40);
                const auto seed = random.word();
                const GaborMaterial filtered = m.filtered(p, dx, dy, m.defaults, seed);
                add(whole, value_of(m, 0, p, seed).slope, gabor_vec3(0));
                add(kept, filtered.slope, gabor_vec3(0));
                add(both, filtered.slope, filtered.lost);
            }
            const double all = whole[0] + whole[1];
            fmt::print(
                "  {:<13} pixel {:.3f}, {:.3f}: kept {:.3f}, with lost {:.3f} of the variance, xy off by "
                "{:.3f}\n",
                m.name, dx.x, dx.y, (kept[0] + kept[1]) / all, (both[0] + both[1]) / all,
                (both[2] - whole[2]) / all);
            INFO(m.name << ", pixel " << dx.x << ", " << dx.y);
            if (m.name == std::string_view("boards")) // whose joints `lost` leaves out
                continue;
            CHECK(std::abs(both[0] + both[1] - all) < 0.12 * all);
            CHECK(std::abs(both[2] - whole[2]) < 0.05 * all);
        }
}

TEST_CASE("far away, materials keep or lose all energy of their slopes, at the corners of all ranges",
          "[materials]") {
    for (const Material& m : materials) {
        if (m.name == std::string_view("boards")) // whose joints `lost` leaves out
            continue;
        const std::size_t colours = m.defaults.size() - m.numbers.size();
        double least = 1, most = 1;
        const auto see = [&](const Numbers& n, bool by_default) {
            Random random(9);
            double whole = 0, power = 0;
            std::size_t count = 0;
            // until the standard error is 2 %, or 17 % for rare scratches
            for (; count < 4000 || (count < 240000 && power - whole * whole / static_cast<double>(count) >
                                                          square(0.02 * whole));
                 ++count) {
                const double energy = square(m.plain(random.uniform<Vec2>(0, 100), n, random.word()).slope);
                whole += energy;
                power += square(energy);
            }
            if (whole < 1e-12 * static_cast<double>(count)) // a relief of 0
                return;
            whole /= static_cast<double>(count);
            const double error = std::sqrt(power / static_cast<double>(count) - square(whole)) /
                                 std::sqrt(static_cast<double>(count));
            for (const float pixel : {4.0f, 40.0f}) {
                double both = 0;
                for (int i = 0; i < 200; ++i) {
                    const GaborMaterial far = m.filtered(random.uniform<Vec2>(0, 100), Vec2(pixel, 0),
                                                         Vec2(0, pixel), n, random.word());
                    both += (square(far.slope) + wide(far.lost.x) + wide(far.lost.y)) / 200;
                }
                const double ratio = both / whole;
                least = std::min(least, ratio);
                most = std::max(most, ratio);
                INFO(m.name << ", pixel " << pixel << ", standard error " << error / whole << ", parameters "
                            << fmt::format("{}",
                                           fmt::join(n.begin() + static_cast<int>(colours), n.end(), ", ")));
                CHECK(both - 3 * error < (by_default ? 1.1 : 1.25) * whole);
                CHECK(both + 3 * error > (by_default ? 0.9 : 0.8) * whole);
            }
        };
        for (unsigned corner = 0; corner < 1u << m.numbers.size(); ++corner) {
            Numbers n = m.defaults;
            for (std::size_t i = 0; i < m.numbers.size(); ++i)
                n[colours + i] = corner >> i & 1 ? m.numbers[i].second : m.numbers[i].first;
            see(n, false);
        }
        fmt::print("  {:<13} kept and lost: {:.2f} to {:.2f} of the energy at the corners,", m.name, least,
                   most);
        least = most = 1;
        see(m.defaults, true);
        fmt::print(" {:.2f} to {:.2f} by default\n", least, most);
    }
}

TEST_CASE("materials keep their gloss at every distance", "[materials]") {
    constexpr int pixels = 24, strata = 24;
    for (const Material& m : materials)
        for (const float pixel : {1 / 256.0f, 1 / 64.0f, 1 / 16.0f, 0.25f, 1.0f}) {
            Random random(6);
            double mean = 0, round = 0, oblong = 0, ignored = 0;
            for (int i = 0; i < pixels; ++i) {
                const Vec2 p = random.uniform<Vec2>(0, 30);
                const auto seed = random.word();
                const auto offset = [&](int stratum) {
                    const double share = (stratum + wide(random.uniform(0.001, 0.999))) / strata;
                    return pixel / 2 * static_cast<float>(quantile(boost::math::normal(), share));
                };
                double expected = 0;
                for (int j = 0; j < strata * strata; ++j) {
                    const Vec2 at(p.x + offset(j % strata), p.y + offset(j / strata));
                    const GaborMaterial plain = value_of(m, 0, at, seed);
                    expected += mirrored(plain, plain.roughness, 4, random) / (strata * strata);
                }
                const GaborMaterial filtered = value_of(m, pixel, p, seed);
                mean += expected / pixels;
                const double sharp = square(square(wide(filtered.roughness)));
                const Vector<3> spread{sharp + wide(filtered.lost.x), sharp + wide(filtered.lost.y),
                                       wide(filtered.lost.z)}; // as in docs/materials.md
                const auto off = [&](const auto& with) {
                    return square(mirrored(filtered, with, 2000, random) - expected) / pixels;
                };
                round += off(gabor_roughness(filtered));
                oblong += off(spread);
                ignored += off(filtered.roughness);
            }
            fmt::print("  {:<13} pixel {:.4f}: light off by {:.3f} of its mean, {:.3f} with round lobes, "
                       "{:.3f} without `lost`\n",
                       m.name, pixel, std::sqrt(oblong) / mean, std::sqrt(round) / mean,
                       std::sqrt(ignored) / mean);
            INFO(m.name << ", pixel " << pixel);
            CHECK(std::sqrt(oblong) / mean < 0.09);
            CHECK(std::sqrt(round) / mean < m.gloss);
        }
}

TEST_CASE("colours keep their mean at the corners of all ranges", "[materials]") {
    constexpr int samples = 6000;
    std::set<decltype(Material::plain)> seen;
    for (const Material& m : materials) {
        if (!seen.insert(m.plain).second)
            continue; // differs only by its defaults
        Random random(7);
        double largest = 0;
        // A finish clips bright colours, and its dirt lies right for one relief.
        const bool finished = m.name == std::string_view("finish");
        const float bright = finished ? 0.6f : 1;
        const std::size_t colours = finished ? 6 : m.defaults.size() - m.numbers.size();
        for (unsigned corner = 0; corner < 3u << m.numbers.size(); ++corner) {
            Numbers n = m.defaults;
            const unsigned look = corner >> m.numbers.size(); // every other colour bright, or all
            for (std::size_t i = 0; i < colours; ++i)
                n[i] =
                    look == 2 || i / 3 % 2 == look ? bright * (1 - 0.15f * static_cast<float>(i % 3)) : 0.02f;
            for (std::size_t i = 0; i < m.numbers.size(); ++i)
                n[colours + i] = corner >> i & 1 ? m.numbers[i].second : m.numbers[i].first;
            std::array<double, 3> mean{}, power{};
            for (int i = 0; i < samples; ++i) {
                const GaborMaterial near = m.plain(random.uniform<Vec2>(0, 3000), n, random.word());
                for (std::size_t c = 0; c < 3; ++c) {
                    mean[c] += wide(near.colour[static_cast<int>(c)]) / samples;
                    power[c] += square(wide(near.colour[static_cast<int>(c)])) / samples;
                }
            }
            const GaborMaterial far = m.filtered(Vec2(3, 4), Vec2(3000, 0), Vec2(0, 3000), n, 7);
            for (std::size_t c = 0; c < 3; ++c) {
                const double error = std::sqrt(std::max(power[c] - square(mean[c]), 0.0) / samples);
                largest = std::max(largest,
                                   (std::abs(wide(far.colour[static_cast<int>(c)]) - mean[c]) - 3 * error) /
                                       mean[c]);
            }
        }
        fmt::print("  {:<13} means off by {:.4f} and three standard errors\n", m.name, largest);
        INFO(m.name);
        CHECK(largest < (0.015));
    }
}

TEST_CASE("turns, shades and tints of boards are independent and uniform", "[materials]") {
    GaborBoards boards = gabor_boards_default();
    boards.turned_share = 0.5f;
    boards.shade_variation = 0.4f;
    boards.hue_variation = 0.2f;
    constexpr int side = 100;
    std::array<std::vector<double>, 4> draws;
    for (int i = 0; i < side * side; ++i) {
        const Vec2 p((static_cast<float>(i % side - side / 2) + 0.5f) * boards.board_width,
                     (static_cast<float>(i / side - side / 2) + 0.5f) * boards.board_length);
        const GaborBoard b = gabor_board(p, Vec2(0), Vec2(0), Vec2(0), boards, 7);
        draws[0].push_back(b.rotation.y > 0.5f ? 1 : -1);
        draws[1].push_back((1 - wide(b.shade)) / 0.2 - 1);
        draws[2].push_back(wide(b.tint.x) / 0.2);
        draws[3].push_back(wide(b.tint.y) / 0.2);
    }
    for (std::size_t i = 0; i < draws.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) {
            const double mean =
                std::inner_product(draws[i].begin(), draws[i].end(), draws[j].begin(), 0.0) / (side * side);
            INFO(i << " and " << j);
            CHECK(std::abs(mean - (i > j ? 0 : i == 0 ? 1 : 1 / 3.0)) < 0.025); // four standard errors
        }
}

// A share of the plane is a joint, others are turned boards; they are as long and wide as asked, also in a
// tile.
TEST_CASE("boards have the asked shapes, shifts and turns, and repeat", "[materials]") {
    for (const auto& [width, length] : {std::pair(0.5f, 2.0f), {1.0f, 1.0f}, {2.0f, 0.5f}}) {
        GaborBoards boards = gabor_boards_default();
        boards.board_width = width;
        boards.board_length = length;
        boards.offset = 0.25f;
        boards.turned_share = 0.5f;
        const bool rows = width > length;
        const auto board_at = [&](Vec2 p, Vec2 period) {
            return gabor_board(p, Vec2(0), Vec2(0), period, boards, 7);
        };
        // The middle of the board at p.
        const auto middle_of = [&](Vec2 p, const GaborBoard& b) {
            const bool turned = b.rotation.y > 0.5f;
            return Vec2(p.x - (turned ? -b.position.y : b.position.x),
                        p.y - (turned ? b.position.x : b.position.y));
        };
        Random random(4);
        int turned = 0, joints = 0;
        for (int i = 0; i < 4000; ++i) {
            const Vec2 p = random.uniform<Vec2>(-40, 40);
            const GaborBoard b = board_at(p, Vec2(0));
            const Vec2 middle = middle_of(p, b);
            turned += b.rotation.y > 0.5f;
            joints += b.joint_cover.x > 0.5f;
            // Columns are shifted along y by a quarter each, rows along x.
            const double line = rows ? wide(middle.y) / wide(length) : wide(middle.x) / wide(width);
            const double along = rows ? wide(middle.x) / wide(width) : wide(middle.y) / wide(length);
            const double shifted = along + 0.25 * std::floor(line) - 0.5;
            CHECK(std::abs(line - std::floor(line) - 0.5) < 1e-4);
            CHECK(std::abs(shifted - std::round(shifted)) < 1e-4);
            CHECK(std::abs(wide(p.x) - wide(middle.x)) < wide(width) / 2 + 1e-4);
            CHECK(std::abs(wide(p.y) - wide(middle.y)) < wide(length) / 2 + 1e-4);
            CHECK(b.seed == board_at(middle, Vec2(0)).seed);
            const Vec2 period(4, 6), next(p.x + 8, p.y - 6);
            const GaborBoard tiled = board_at(p, period), same = board_at(next, period);
            CHECK(tiled.seed == same.seed);
            CHECK(std::abs(wide(tiled.joint_cover.x) - wide(same.joint_cover.x)) < 1e-3);
        }
        for (const float shift :
             {0.5f, 0.25f, 0.38f}) { // in a tile, the last line and the first are neighbours, too
            boards.offset = shift;
            const Vec2 period(4, 4);
            double before = 0;
            for (int line = 0; line < 80; ++line) { // 20 to a unit: each board has several
                const float at = 0.025f + static_cast<float>(line) / 20;
                const Vec2 p = rows ? Vec2(1, at) : Vec2(at, 1), middle = middle_of(p, board_at(p, period));
                const double size = rows ? wide(width) : wide(length);
                const double along = (rows ? wide(middle.x) : wide(middle.y)) / size;
                const double step = along - before - std::round(along - before);
                INFO(width << " x " << length << ", shift " << shift << ", line " << line);
                CHECK((line == 0 || std::abs(step) < 0.01 ||
                       std::abs(std::abs(step) - std::min(shift, 1 - shift)) < 0.13));
                before = along;
            }
            const auto first = middle_of(Vec2(0.02f, 0.02f), board_at(Vec2(0.02f, 0.02f), period));
            const Vec2 other = rows ? Vec2(0.02f, 3.98f) : Vec2(3.98f, 0.02f),
                       last = middle_of(other, board_at(other, period));
            const double size = rows ? wide(width) : wide(length);
            const double step = (rows ? wide(first.x) - wide(last.x) : wide(first.y) - wide(last.y)) / size;
            CHECK(std::abs(std::abs(step - std::round(step)) - std::min(shift, 1 - shift)) < 0.13);
        }
        const double gaps =
            1 - (1 - wide(boards.joint_width) / wide(width)) * (1 - wide(boards.joint_width) / wide(length));
        fmt::print("  boards of {} x {}: {} of 4000 turned, joints {:.4f} of {:.4f}\n", width, length, turned,
                   joints / 4000.0, gaps);
        CHECK(std::abs(turned - 2000) < 150);
        CHECK(std::abs(joints / 4000.0 - gaps) < 0.01);
    }
}

TEST_CASE("a board's pixel is the pixel of its material", "[materials]") {
    GaborBoards boards = gabor_boards_default();
    boards.turned_share = 0.5f;
    Random random(5);
    gabor::test::Largest largest;
    int turned = 0, seen = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec2 p = random.uniform<Vec2>(-9, 9), dx = random.uniform<Vec2>(-0.01f, 0.01f),
                   dy = random.uniform<Vec2>(-0.01f, 0.01f);
        const GaborBoard here = gabor_board(p, dx, dy, Vec2(0), boards, 7);
        for (const auto& [step, pixel] : {std::pair(dx, here.dx), {dy, here.dy}}) {
            const GaborBoard there = gabor_board(p + step, dx, dy, Vec2(0), boards, 7);
            if (there.seed != here.seed)
                continue; // another board
            ++seen;
            const auto name = [&] { return fmt::format("({}, {})", p.x, p.y); };
            largest.see(wide(pixel.x), wide(there.position.x) - wide(here.position.x), 4e-6, name);
            largest.see(wide(pixel.y), wide(there.position.y) - wide(here.position.y), 4e-6, name);
            turned += here.rotation.y > 0.5f;
        }
    }
    largest.check("a board's pixel");
    CHECK(turned > seen / 3);
}

TEST_CASE("a board turns the lost slopes of its material with the slopes", "[materials]") {
    Random random(9);
    gabor::test::Largest largest;
    for (int i = 0; i < 200; ++i) {
        GaborBoard board{};
        const double angle = random.uniform(-3.14, 3.14);
        board.rotation = Vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)));
        board.joint_cover.x = random.uniform(0, 0.9);
        GaborMaterial material = gabor_wood(Vec2(0), 7);
        const Vec2 v = material.slope = random.uniform<Vec2>(-1, 1);
        material.lost = {v.x * v.x, v.y * v.y, v.x * v.y};
        const GaborMaterial laid = gabor_laid(material, board, gabor_boards_default());
        const double free = 1 - wide(board.joint_cover.x);
        const Vec2 turned(static_cast<float>(std::cos(angle) * wide(v.x) - std::sin(angle) * wide(v.y)),
                          static_cast<float>(std::sin(angle) * wide(v.x) + std::cos(angle) * wide(v.y)));
        const auto name = [&] { return fmt::format("({}, {}) by {}", v.x, v.y, angle); };
        largest.see(wide(laid.slope.x), free * wide(turned.x), 1e-6, name);
        largest.see(wide(laid.slope.y), free * wide(turned.y), 1e-6, name);
        largest.see(wide(laid.lost.x), free * wide(turned.x) * wide(turned.x), 2e-6, name);
        largest.see(wide(laid.lost.y), free * wide(turned.y) * wide(turned.y), 2e-6, name);
        largest.see(wide(laid.lost.z), free * wide(turned.x) * wide(turned.y), 2e-6, name);
    }
    largest.check("a board's slopes");
}

TEST_CASE("a pixel of several boards has their mean shade, whichever way it is long", "[materials]") {
    const GaborBoards boards = gabor_boards_default();
    Random random(6);
    for (const Vec2 longest : {Vec2(30, 0), Vec2(0, 30), Vec2(20, -20)})
        for (int i = 0; i < 100; ++i) {
            const GaborBoard b =
                gabor_board(random.uniform<Vec2>(-9, 9), longest, Vec2(0.01f, 0.01f), Vec2(0), boards, 7);
            CHECK(b.shade == Approx(1 - 0.5f * boards.shade_variation).epsilon(1e-4));
        }
}

TEST_CASE("a joint is as rough as its board, and at least 0.8, and no metal", "[materials]") {
    const GaborBoards boards = gabor_boards_default();
    GaborBoard joint = gabor_board(Vec2(0.3f, 0.7f), Vec2(0), Vec2(0), Vec2(0), boards, 7);
    joint.joint_cover.x = 1;
    for (const float roughness : {0.1f, 0.8f, 0.95f}) {
        GaborMaterial material = gabor_wood(Vec2(0), 7);
        material.roughness = roughness;
        material.metalness = 1;
        const GaborMaterial laid = gabor_laid(material, joint, boards);
        CHECK(laid.roughness == Approx(std::max(roughness, 0.8f)));
        CHECK(laid.metalness == 0);
        CHECK(laid.height == Approx(-boards.joint_depth));
        CHECK(laid.colour.x == Approx(boards.joint_colour.x));
    }
}

TEST_CASE("a finish's shift of the hue keeps the mean colour, near and far", "[materials]") {
    GaborFinish finish = gabor_finish_default();
    finish.shade_variation = finish.roughness_variation = finish.grain_contrast = finish.grain_height = 0;
    finish.hue_variation = 0.5f;
    GaborMaterial grey = gabor_wood(Vec2(0), 7);
    grey.colour = gabor_vec3(0.2f);
    Random random(10);
    constexpr int count = 20000;
    Vector<3> sum{};
    for (int i = 0; i < count; ++i) {
        const gabor_vec3 colour =
            gabor_finished(grey, random.uniform<Vec2>(-500, 500), Vec2(0), finish, 7).colour;
        sum = {sum[0] + wide(colour.x), sum[1] + wide(colour.y), sum[2] + wide(colour.z)};
    }
    for (const double channel : sum)
        CHECK(channel / count / 0.2 == Approx(1).epsilon(0.015)); // three standard errors
    const gabor_vec3 far =
        gabor_finished_filtered(grey, Vec2(3, 4), Vec2(40, 0), Vec2(0, 40), Vec2(0), finish, 7).colour;
    for (const float channel : {far.x, far.y, far.z})
        CHECK(channel == Approx(0.2).epsilon(0.01));
}

TEST_CASE("a removed tone leaves the mean of colours of at most 1", "[materials]") {
    gabor::test::Largest largest;
    for (const float deviation : {0.05f, 0.3f, 0.6f, 1.0f})
        for (const float level : {0.1f, 0.5f, 0.75f, 0.97f}) {
            const Vec2 tone(-0.5f * deviation * deviation, deviation * deviation);
            const gabor_vec3 colour(level, 0.6f * level, 0.9f * level);
            const gabor_vec3 found = gabor_impl_toned(colour, tone);
            const auto see = [&](float value, float of) {
                double mean = 0, weight = 0;
                for (double x = -8; x <= 8; x += 1e-3) {
                    const double density = std::exp(-x * x / 2);
                    weight += density;
                    mean += density * std::min(wide(of) * std::exp(wide(tone.x) + x * wide(deviation)), 1.0);
                }
                largest.see(wide(value), mean / weight, 2e-4,
                            [&] { return fmt::format("{} of {}, deviation {}", of, level, deviation); });
            };
            see(found.x, colour.x);
            see(found.y, colour.y);
            see(found.z, colour.z);
        }
    largest.check("a removed tone");
}

TEST_CASE("joints cover no board more than once, however wide they are", "[materials]") {
    GaborBoards boards = gabor_boards_default();
    boards.joint_width = 0.2f;
    Random random(8);
    for (const auto& [width, length] : {std::pair(0.05f, 20.0f), {10.0f, 0.05f}, {0.05f, 0.05f}})
        for (const float pixel : {0.0f, 0.01f, 1.0f})
            for (int i = 0; i < 100; ++i) {
                boards.board_width = width;
                boards.board_length = length;
                const GaborBoard b = gabor_board(random.uniform<Vec2>(-9, 9), Vec2(pixel, 0), Vec2(0, pixel),
                                                 Vec2(0), boards, 7);
                INFO(width << " x " << length << ", pixel " << pixel);
                CHECK(std::abs(b.joint_cover.x - 0.5f) < 0.50001f);
            }
}

TEST_CASE("each weave repeats without a seam", "[materials]") {
    constexpr float near = 0.001953125f;
    const Vec2 period(3, 3);
    for (const float weave : {0.0f, 1.0f, 2.0f}) {
        GaborFabric fabric = gabor_fabric_default();
        fabric.weave = weave;
        fabric.threads = 8;
        const auto step = [&](float x, float y, Vec2 apart) {
            const auto height = [&](float sign) {
                return gabor_fabric_at({x + sign * apart.x, y + sign * apart.y}, period, fabric, 7).height;
            };
            return std::abs(height(1) - height(-1));
        };
        Random random(5);
        double seam = 0, elsewhere = 0;
        for (int i = 0; i < 4000; ++i) {
            const float along = random.uniform(0, 3), x = random.uniform(0, 3);
            seam += step(0, along, {near, 0}) + step(along, 0, {0, near});
            elsewhere += step(x, along, {near, 0}) + step(along, x, {0, near});
        }
        fmt::print("weave {}: steps at the seam {:.2f} times those elsewhere\n", weave, seam / elsewhere);
        CHECK(seam < 1.5 * elsewhere);
    }
}

TEST_CASE("scratches have the asked direction, in a tile one of 24", "[materials]") {
    GaborScratches scratches = gabor_scratches_default();
    scratches.direction_spread = 0;
    Random random(9);
    for (const Vec2 period : {Vec2(0), Vec2(8, 8), Vec2(12, 4), Vec2(4, 12)}) {
        double largest = 0;
        for (scratches.scratch_direction = -6.2f; scratches.scratch_direction < 6.3f;
             scratches.scratch_direction += 0.3f) {
            double x = 0, y = 0; // cosine and sine of twice the slopes' direction
            for (int i = 0; i < 2000; ++i) {
                const Vec2 p = random.uniform<Vec2>(0, 12);
                const Vec2 slope = gabor_scratches_at(p, period, scratches, random.word()).slope;
                x += square(wide(slope.x)) - square(wide(slope.y));
                y += 2 * wide(slope.x) * wide(slope.y);
            }
            const double turns = (std::atan2(-y, -x) / 2 - wide(scratches.scratch_direction)) / 3.14159265;
            largest = std::max(largest, 180 * std::abs(turns - std::round(turns)));
        }
        fmt::print("  period {} x {}: off by at most {:.1f} degrees\n", period.x, period.y, largest);
        INFO(period.x << " x " << period.y);
        CHECK(largest < (period.x > 0 ? 25 : 5));
    }
}

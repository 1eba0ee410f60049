// The distribution of gabor_lattice_3d.glsl over independent instances (GABOR_LAW_SAMPLES per statistic), and
// of its sums by their parts.

#include "law.hpp"
#include "reference/lattice.hpp"
#include "reference/normal_mean.hpp"
#include "sampler_lattice_3d.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace gabor;
using noise::Lattice3d;
using std::numbers::pi;
using test::Entry3d;
using test::Figure;
using test::LatticeSample3d;
using test::LatticeSampler3d;
using test::narrow;
using test::random_unit;
using Vector = Lattice3d::Vector;

namespace {

constexpr std::size_t per_batch = 1 << 17;

// Returns the number of batches for a share of the samples.
int batches(double share) {
    return static_cast<int>(std::ceil(share * test::law_samples() / per_batch));
}

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Returns the sample in another instance.
LatticeSample3d elsewhere(LatticeSample3d sample, test::Draw& draw) {
    sample.place.cell = {draw.cell(), draw.cell(), draw.cell()};
    sample.seed = draw.word();
    return sample;
}

LatticeSample3d at(const std::array<float, 3>& local) {
    LatticeSample3d sample;
    sample.place.local = local;
    sample.frequency = 1;
    sample.direction = {0.6f, 0.48f, 0.64f};
    return sample;
}

} // namespace

TEST_CASE("noise on the lattice in space has its law at each of 4 x 4 x 4 places of a cell", "[law]") {
    const vulkan::Device device;
    LatticeSampler3d sampler(device, per_batch, Entry3d::field);
    test::Draw draw(30);
    const auto places = test::places_of_cell(4, 3);
    const std::size_t per_place = per_batch / places.size();
    test::Laws all(places);
    struct Waves {
        float frequency;
        bool tiled;
    };
    for (const auto& [frequency, tiled] :
         {Waves{0, false}, {0.7f, false}, {4, false}, {30, false}, {1.5f, true}}) {
        test::Laws laws(places);
        for (int batch = 0; batch < batches(1.0 / 8); ++batch) {
            for (std::size_t i = 0; i < per_batch; ++i) {
                LatticeSample3d sample;
                sample.frequency = frequency;
                sample.direction = narrow(random_unit(draw));
                std::ranges::copy(places[i / per_place], sample.place.local.begin());
                for (std::size_t axis = 0; tiled && axis < 3; ++axis) {
                    sample.place.period[axis] = 3 + static_cast<std::int32_t>(draw.word() % 9);
                    sample.place.radius[axis] = 1.5f * draw.uniform(0.8f, 1.25f);
                }
                sampler.samples()[i] = elsewhere(sample, draw);
            }
            const auto answers = sampler.answers(per_batch);
            for (std::size_t i = 0; i < per_batch; ++i) {
                laws.add(i / per_place, answers[i].value[0]);
                laws.add(i / per_place, answers[i].value[1]);
            }
        }
        laws.check(fmt::format("frequency {}{}", frequency, tiled ? ", tiles" : ""));
        all.merge(laws);
    }
    all.check("all waves");
}

namespace {

// A sum of numbers from the answers to a group of samples; the first nine belong to the first sample.
struct Combination {
    std::string name;
    struct Term {
        std::size_t number;
        double factor;
    };
    std::vector<Term> terms;
    double deviation; // that theory predicts
};

// Tests the distributions of combinations over instances; `group_of` makes a group of samples from each.
template <typename GroupOf>
void check(LatticeSampler3d& sampler, const LatticeSample3d& one, const GroupOf& group_of, double share,
           const std::vector<Combination>& combinations) {
    test::Draw draw(41);
    std::vector<Figure> figures;
    for (const Combination& c : combinations)
        figures.emplace_back(c.deviation);
    const std::size_t size = group_of(one).size();
    for (int batch = 0; batch < batches(share); ++batch) {
        for (std::size_t i = 0; i < per_batch; i += size)
            std::ranges::copy(group_of(elsewhere(one, draw)), sampler.samples().subspan(i).begin());
        const auto answers = sampler.answers(per_batch);
        for (std::size_t i = 0; i < per_batch; i += size) {
            for (std::size_t k = 0; k < figures.size(); ++k) {
                double sum = 0;
                for (const auto& [number, factor] : combinations[k].terms)
                    sum += factor * answers[i + number / 9].value[number % 9];
                figures[k].add(sum);
            }
        }
    }
    for (std::size_t k = 0; k < figures.size(); ++k)
        figures[k].check(combinations[k].name);
}

// Both parts of the noise, both of its gradient, and sums of them are jointly normal.
// sum h'^2 = pi^2 / 4 * 3/2 and sum h^2 = 9/8 along an axis, so a slope has the variance pi^2 / 3 + (2 pi
// F)^2.
std::vector<Combination> of_field(const LatticeSample3d& sample) {
    const Vector direction = test::unit(sample.direction);
    const auto slope = [&](std::size_t axis) {
        return std::sqrt(pi * pi / 3 + std::pow(2 * pi * sample.frequency * direction[axis], 2));
    };
    // d/dx of one part and the other part itself covary by 2 pi F_x.
    const double covariance = 2 * pi * sample.frequency * direction[0];
    const double mixed = std::sqrt(1 + 1 + 2 * covariance / slope(0));
    const double slopes = 4 * pi * pi * sample.frequency * sample.frequency * direction[0] * direction[1];
    const double both = std::sqrt(2 + 2 * slopes / (slope(0) * slope(1)));
    return {{"noise", {{1, 1}}, 1},
            {"quadrature", {{0, 1}}, 1},
            {"their sum", {{0, 1}, {1, 1}}, std::sqrt(2.0)},
            {"d/dx", {{3, 1}}, slope(0)},
            {"d/dy", {{5, 1}}, slope(1)},
            {"d/dz", {{7, 1}}, slope(2)},
            {"d/dx + d/dy", {{3, 1 / slope(0)}, {5, 1 / slope(1)}}, both},
            {"quadrature + d/dx", {{0, 1}, {3, 1 / slope(0)}}, mixed}};
}

// Covariance of two places along the lattice's axes, from the windows of the nodes that reach both.
double covariance(const LatticeSample3d& sample, const std::array<float, 3>& lag) {
    double product = 1;
    double turns = 0;
    const Vector direction = test::unit(sample.direction);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto window = [](double offset) {
            return std::abs(offset) < 1.5 ? (1 + std::cos(pi * offset / 1.5)) / 2 : 0;
        };
        double sum = 0;
        for (double node = -3; node <= 5; ++node)
            sum +=
                window(sample.place.local[axis] - node) * window(sample.place.local[axis] + lag[axis] - node);
        product *= sum / (9.0 / 8);
        turns += sample.frequency * direction[axis] * lag[axis] / 1.5;
    }
    return product * std::cos(2 * pi * turns);
}

} // namespace

TEST_CASE("noise on the lattice in space is jointly normal with its gradient and quadrature, pairs of places "
          "and four noises are",
          "[law]") {
    const vulkan::Device device;
    LatticeSampler3d sampler(device, per_batch, Entry3d::field);
    for (const auto& place : {std::array{0.0f, 0.0f, 0.0f}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.5f, 0.0f}}) {
        fmt::print("at {}\n", place);
        check(
            sampler, at(place), [](const LatticeSample3d& s) { return std::array{s}; }, 1.0 / 4,
            of_field(at(place)));
    }
    for (const auto& lag :
         {std::array{0.3f, 0.0f, 0.0f}, {0.0f, 0.7f, 0.7f}, {0.5f, -0.5f, 1.0f}, {1.5f, 0.0f, 0.4f}}) {
        const LatticeSample3d first = at({0.25f, 0.5f, 0});
        const double between = covariance(first, lag);
        const auto pair = [&](LatticeSample3d s) {
            std::array both{s, s};
            for (std::size_t axis = 0; axis < 3; ++axis)
                both[1].place.local[axis] += lag[axis];
            return both;
        };
        fmt::print("lag {}, covariance {:.3f}\n", lag, between);
        check(sampler, first, pair, 1.0 / 4,
              {{"sum", {{1, 1}, {10, 1}}, std::sqrt(2 + 2 * between)},
               {"difference", {{1, 1}, {10, -1}}, std::sqrt(2 - 2 * between)}});
    }
    const auto four = [](const LatticeSample3d& s) {
        std::array all{s, s, s, s};
        for (int channel = 1; channel < 4; ++channel)
            all.at(static_cast<std::size_t>(channel)).seed = noise::lattice_lobe_seed(s.seed, -channel);
        return all;
    };
    fmt::print("four at a node\n");
    check(sampler, at({}), four, 1.0 / 4,
          {{"first + second", {{1, 1}, {10, 1}}, std::numbers::sqrt2},
           {"third - fourth", {{19, 1}, {28, -1}}, std::numbers::sqrt2},
           {"all four", {{1, 1}, {10, 1}, {19, 1}, {28, 1}}, 2}});
}

TEST_CASE("surface noise on the lattice has its law for every normal", "[law]") {
    const vulkan::Device device;
    test::Draw draw(32);
    std::vector<std::array<float, 3>> normals(32);
    for (auto& normal : normals)
        normal = narrow(random_unit(draw));
    for (const Entry3d entry : {Entry3d::surface, Entry3d::surface_isotropic}) {
        LatticeSampler3d sampler(device, per_batch, entry);
        test::Laws laws(normals);
        for (int batch = 0; batch < batches(1.0 / 4); ++batch) {
            for (std::size_t i = 0; i < per_batch; ++i) {
                LatticeSample3d sample = at({draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(0, 1)});
                sample.normal = normals[i % normals.size()];
                sample.direction = narrow(random_unit(draw));
                // Every other direction is near the normal, where another one takes over.
                for (std::size_t axis = 0; i / normals.size() % 2 && axis < 3; ++axis)
                    sample.direction[axis] = sample.normal[axis] + 0.45f * sample.direction[axis];
                sampler.samples()[i] = elsewhere(sample, draw);
            }
            const auto answers = sampler.answers(per_batch);
            for (std::size_t i = 0; i < per_batch; ++i) {
                laws.add(i % normals.size(), answers[i].value[0]);
                laws.add(i % normals.size(), answers[i].value[1]);
            }
        }
        laws.check(entry == Entry3d::surface ? "surface" : "surface, isotropic");
    }
}

TEST_CASE("waves of surface noise are tangent, as long as asked, and of variance 1 together", "[oracle]") {
    test::Draw draw(33);
    double longest = 0;
    double shortest = 1e9;
    for (int i = 0; i < 20000; ++i) {
        const Vector normal = random_unit(draw);
        Vector direction = random_unit(draw);
        if (i % 4 == 0) { // near and along the normal
            for (std::size_t axis = 0; axis < 3; ++axis)
                direction[axis] = normal[axis] + (i % 8 ? 0.3 : 0.01) * direction[axis];
            const double length = std::sqrt(dot(direction, direction));
            for (double& coordinate : direction)
                coordinate /= length;
        }
        const double frequency = draw.uniform(0.1f, 6);
        double power = 0;
        for (const noise::WeightedWave& w : noise::surface_waves(normal, frequency, direction, 1)) {
            power += w.weight * w.weight;
            const double length = std::sqrt(dot(w.wave, w.wave)) / frequency;
            longest = std::max(longest, length);
            shortest = std::min(shortest, length);
            REQUIRE(std::abs(dot(w.wave, normal)) < 1e-9 * frequency);
        }
        REQUIRE(power == Approx(1).margin(1e-9));
    }
    fmt::print("frequency on the surface: {:.9f} to {:.9f} of that asked for\n", shortest, longest);
    CHECK(shortest > 1 - 1e-9);
    CHECK(longest < 1 + 1e-9);
}

// Each vector of a random frame is uniform on the sphere: (u.v)^2k has the mean 1 / (2k + 1) for every v, and
// the harmonics up to degree 8 vanish.
TEST_CASE("the frames of isotropic noise are even in all directions", "[oracle]") {
    test::Draw draw(34);
    std::vector<Vector> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 24; ++i)
        directions.push_back(random_unit(draw));
    constexpr int count = 1 << 17;
    std::vector<std::array<statistics::Moments, 4>> powers(directions.size());
    test::Largest angles;
    for (int i = 0; i < count; ++i) {
        const auto frame = noise::isotropic_frame(draw.word() | 1u);
        for (std::size_t a = 0; a < 3; ++a)
            for (std::size_t b = 0; b < 3; ++b)
                angles.see(dot(frame.at(a), frame.at(b)), a == b ? 1 : 0, 1e-12,
                           [&] { return fmt::format("{}, {}", a, b); });
        for (std::size_t k = 0; k < directions.size(); ++k) {
            std::array<double, 4> sums{};
            for (const Vector& u : frame)
                for (std::size_t n = 0; n < 4; ++n)
                    sums.at(n) += std::pow(dot(u, directions[k]), 2.0 * static_cast<double>(n + 1)) / 3;
            for (std::size_t n = 0; n < 4; ++n)
                powers[k].at(n).add(sums.at(n));
        }
    }
    angles.check("frames");
    test::Largest even; // in standard errors
    for (std::size_t k = 0; k < directions.size(); ++k) {
        for (std::size_t n = 1; n < 4; ++n) { // the squares of a frame sum to 1
            const statistics::Moments& power = powers[k].at(n);
            even.see(power.mean(), 1 / (2.0 * static_cast<double>(n + 1) + 1),
                     4.5 * std::sqrt(power.variance() / count), [&] {
                         return fmt::format("power {} along {:.2f}", 2 * (n + 1),
                                            fmt::join(directions[k], " "));
                     });
        }
    }
    even.check("powers of cosines, in 4.5 standard errors");
}

TEST_CASE("isotropic noise has its law and its gradient's at fixed places", "[law]") {
    const vulkan::Device device;
    struct Where {
        Entry3d entry;
        std::array<float, 3> normal; // of a surface
        const char* name;
    };
    for (const auto& [entry, normal, name] :
         {Where{Entry3d::isotropic, {}, "in space"},
          Where{Entry3d::surface_isotropic, {0.8f, 0, 0.6f}, "on a surface"},
          Where{Entry3d::surface_isotropic, {0, 0, 1}, "on a surface, at a pole"},
          Where{Entry3d::surface_isotropic, {0.6f, 0, 0.8f}, "on a surface, between two frames"}}) {
        LatticeSampler3d sampler(device, per_batch, entry);
        // Of the derivatives along two tangents, or along any two axes: in space 4/3 pi^2 F^2, and 2 pi^2 F^2
        // on a surface, of the waves; pi^2 / 3 of the windows.
        const bool on_surface = entry == Entry3d::surface_isotropic;
        const double slope = std::sqrt(pi * pi / 3 + pi * pi * (on_surface ? 2 : 4.0 / 3));
        const double x = on_surface ? normal[2] : 1,
                     z = on_surface ? -normal[0] : 0; // one of them is x, z; one y
        const std::vector<Combination> combinations{
            {"noise", {{1, 1}}, 1},
            {"quadrature", {{0, 1}}, 1},
            {"their sum", {{0, 1}, {1, 1}}, std::sqrt(2.0)},
            {"d/dx", {{3, x}, {7, z}}, slope},
            {"d/dy", {{5, 1}}, slope},
            {"d/dx + d/dy", {{3, x}, {7, z}, {5, 1}}, std::sqrt(2.0) * slope},
            {"noise + d/dx", {{1, slope}, {3, x}, {7, z}}, std::sqrt(2.0) * slope}};
        for (const auto& place : {std::array{0.0f, 0.0f, 0.0f}, {0.5f, 0.5f, 0.5f}, {0.25f, 0.5f, 0.0f}}) {
            fmt::print("isotropic {}, at {}\n", name, place);
            LatticeSample3d sample = at(place);
            sample.normal = normal;
            check(
                sampler, sample, [](const LatticeSample3d& s) { return std::array{s}; }, 1.0 / 2,
                combinations);
        }
    }
}

// The covariance is the transform of the spectrum: sin(t) / t, t = 2 pi F |lag|, of an even shell, times that
// of the windows.
TEST_CASE("the covariance of isotropic noise in space is that of an even shell of waves, in every direction",
          "[law]") {
    const vulkan::Device device;
    LatticeSampler3d sampler(device, per_batch, Entry3d::isotropic);
    test::Draw draw(35);
    std::vector<Vector> directions{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const auto& diagonal : {std::array{1.0f, 1.0f, 0.0f},
                                 {1.0f, -1.0f, 1.0f},
                                 {0.0f, 1.0f, -1.0f},
                                 {1.0f, 0.0f, 1.0f},
                                 {1.0f, 2.0f, 3.0f}})
        directions.push_back(test::unit(diagonal));
    test::Largest covariances;
    for (const double frequency : {0.5, 1.0, 3.0}) {
        for (const double turns : {0.25, 0.7, 1.2}) {
            const double distance = turns / frequency; // kernel radii
            for (const Vector& direction : directions) {
                statistics::Moments products;
                for (int batch = 0; batch < batches(1.0 / 8); ++batch) {
                    for (std::size_t i = 0; i < per_batch; i += 2) {
                        LatticeSample3d sample =
                            elsewhere(at({draw.uniform(0, 1), draw.uniform(0, 1), draw.uniform(0, 1)}), draw);
                        sample.frequency = static_cast<float>(frequency);
                        sampler.samples()[i] = sample;
                        for (std::size_t axis = 0; axis < 3; ++axis)
                            sample.place.local[axis] += static_cast<float>(1.5 * distance * direction[axis]);
                        sampler.samples()[i + 1] = sample;
                    }
                    const auto answers = sampler.answers(per_batch);
                    for (std::size_t i = 0; i < per_batch; i += 2)
                        for (const int part : {0, 1})
                            products.add(answers[i].value[part] * answers[i + 1].value[part]);
                }
                double expected = std::sin(2 * pi * turns) / (2 * pi * turns);
                for (const double along : direction)
                    expected *= noise::hann_correlation(distance * along);
                const double error = std::sqrt(products.variance() / static_cast<double>(products.count()));
                covariances.see(products.mean(), expected, 4.5 * error, [&] {
                    return fmt::format("frequency {}, distance {}, along {:.2f}", frequency, distance,
                                       fmt::join(direction, " "));
                });
                CHECK(error < 0.01);
            }
        }
    }
    covariances.check("covariances, in 4.5 standard errors");
}

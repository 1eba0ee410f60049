// Compares every function of gabor_noise_3d.glsl with the double-precision reference.

#include "noise.hpp"

using namespace gabor;
using test::Differences;
using test::Largest;
using test::Sample3d;
using Vector = noise::Vector<3>;

namespace {

test::Lattice3 n;

// A random sample with a given frequency. Functions of its position p compute their place as p * 1.5 in
// single precision.
struct Anywhere : Sample3d {
    noise::Place<3> here;

    Anywhere(test::Random& random, float f, bool animated, bool periodic) {
        place = test::any_place<3>(random);
        frequency = f;
        direction = random.uniform<gabor_vec3>(-3, 3);
        normal = random.uniform<gabor_vec3>(-3, 3);
        const double reach = std::exp2(random.uniform(0, 18));
        p = random.uniform<gabor_vec3>(-reach, reach);
        here = test::lattice_place(3, p);
        seed = random.word();
        place.time = here.time = random.uniform(-2, 2);
        place.animated = here.animated = animated;
        if (random.one_in(4)) // near the normal, where the function switches to another direction
            direction = normal + random.uniform<gabor_vec3>(-0.3, 0.3);
        for (std::size_t axis = 0; periodic && axis < 3; ++axis) {
            place.period[axis] = 3 + static_cast<std::int32_t>(random.word() % 9);
            place.radius[axis] = 1.5f * random.uniform(0.8, 1.25);
        }
    }
};

// Waves turn by up to 2 pi F per radius, so the rounding of positions has an effect proportional to F.
double tolerance(double frequency) {
    return 2 * test::tolerance(frequency);
}
double slope_tolerance(double frequency) {
    return 2 * test::slope_tolerance(frequency);
}

void see_field(Largest& largest, const test::Lattice3::GaborField3d& field, const noise::Field<3>& expected,
               const Anywhere& s) {
    const double tight = tolerance(s.frequency);
    // Where a window ends, its second derivative jumps by pi^2 / 2, so the rounding of `local` changes the
    // slope by up to 5 times as much.
    double loose = slope_tolerance(s.frequency);
    for (const double local : s.place.local)
        loose = std::max(loose, 5 * 0x1p-23 * std::abs(local));
    largest.see(field.quadrature, expected.value.real(), tight, s);
    largest.see(field.noise, expected.value.imag(), tight, s);
    for (int axis = 0; axis < 3; ++axis) {
        const std::complex<double> slope = expected.slope[static_cast<std::size_t>(axis)];
        largest.see(field.quadrature_gradient[axis], slope.real(), loose, s);
        largest.see(field.gradient[axis], slope.imag(), loose, s);
    }
    largest.see(field.removed, 0, tight, s); // without the filter
}

// Compares a noise and its gradient, given as (noise, gradient).
void see_gradient(Largest& largest, gabor_vec4 found, const noise::Field<3>& expected, const Anywhere& s) {
    largest.see(found.x, expected.value.imag(), tolerance(s.frequency), s);
    for (std::size_t axis = 0; axis < 3; ++axis)
        largest.see(found[static_cast<int>(axis) + 1], expected.slope[axis].imag(),
                    slope_tolerance(s.frequency), s);
}

} // namespace

TEST_CASE("noise in space and on surfaces agrees with the reference", "[space][oracle]") {
    test::Random random(21);
    Differences of;
    for (int i = 0; i < 1 << 13; ++i) {
        // The frequencies cover 0.1 to 64 evenly in octaves.
        const int octave = i % 16;
        const bool animated = i / 16 % 4 == 1, periodic = i / 16 % 4 == 2;
        const float f = octave == 0 ? 0 : 0.1f * static_cast<float>(std::exp2(octave * 0.62));
        const Anywhere s(random, f, animated, periodic);
        const double tight = tolerance(f);
        const auto place = test::place_of(n, s.place);
        const Vector along = noise::unit(test::wide(s.direction)), normal = noise::unit(test::wide(s.normal));
        const auto wave = noise::wave_noise(3, noise::scaled(f, along), s.seed);
        const auto isotropic = noise::isotropic_noise_3d(f, s.seed);
        const auto surface = noise::surface_noise(normal, f, along, s.seed);
        const auto surface_isotropic = noise::isotropic_surface_noise(normal, f, s.seed);

        see_field(of["gabor_field_3d"], n.gabor_field_3d(place, f, s.direction, s.seed), wave.field(s.place),
                  s);
        see_field(of["gabor_field_3d_isotropic"], n.gabor_field_3d_isotropic(place, f, s.seed),
                  isotropic.field(s.place), s);
        see_field(of["gabor_field_surface"], n.gabor_field_surface(place, s.normal, f, s.direction, s.seed),
                  surface.field(s.place), s);
        see_field(of["gabor_field_surface_isotropic"],
                  n.gabor_field_surface_isotropic(place, s.normal, f, s.seed),
                  surface_isotropic.field(s.place), s);

        if (animated) {
            of["gabor_noise_3d_animated"].see(
                n.gabor_noise_3d_animated(s.p, static_cast<float>(s.place.time), f, s.direction, s.seed),
                wave.field(s.here).value.imag(), tight, s);
            continue;
        }
        const noise::Field<3> here = wave.field(s.here);
        of["gabor_noise_3d"].see(n.gabor_noise_3d(s.p, f, s.direction, s.seed), here.value.imag(), tight, s);
        see(of["gabor_noise_3d_complex"], n.gabor_noise_3d_complex(s.p, f, s.direction, s.seed), here.value,
            tight, s);
        see_gradient(of["gabor_noise_3d_gradient"], n.gabor_noise_3d_gradient(s.p, f, s.direction, s.seed),
                     here, s);
        const gabor_vec4 four = n.gabor_noise_3d_four(s.p, f, s.direction, s.seed);
        for (int c = 0; c < 4; ++c) {
            const std::uint32_t seed = c ? noise::lattice_lobe_seed(s.seed, -c) : s.seed;
            of["gabor_noise_3d_four"].see(
                four[c], noise::wave_noise(3, noise::scaled(f, along), seed).field(s.here).value.imag(),
                tight, s);
        }
        const noise::Field<3> turned = isotropic.field(s.here);
        of["gabor_noise_3d_isotropic"].see(n.gabor_noise_3d_isotropic(s.p, f, s.seed), turned.value.imag(),
                                           tight, s);
        see_gradient(of["gabor_noise_3d_isotropic_gradient"],
                     n.gabor_noise_3d_isotropic_gradient(s.p, f, s.seed), turned, s);
        of["gabor_noise_surface"].see(n.gabor_noise_surface(s.p, s.normal, f, s.direction, s.seed),
                                      surface.field(s.here).value.imag(), tight, s);
        of["gabor_noise_surface_isotropic"].see(n.gabor_noise_surface_isotropic(s.p, s.normal, f, s.seed),
                                                surface_isotropic.field(s.here).value.imag(), tight, s);
        // Tiles are compared near the origin, where p is rounded by 10^-6. The wave turns by 2 pi F per
        // radius.
        const auto p = random.uniform<gabor_vec3>(-8, 8), tile = random.uniform<gabor_vec3>(0.5, 9);
        of["gabor_noise_3d_tiled"].see(n.gabor_noise_3d_tiled(p, tile, f, s.direction, s.seed),
                                       wave.field(test::lattice_tile(3, p, tile)).value.imag(),
                                       1e-4 * (1 + f), s);
    }
    test::check(of, 14);
}

TEST_CASE("noise in space ignores the sign of the frequency and the length of the direction", "[space]") {
    const auto noise = [](float frequency, gabor_vec3 direction) {
        return n.gabor_noise_3d({0.3f, 0.8f, 0.1f}, frequency, direction, 7);
    };
    CHECK(noise(-3, {1, 0, 0}) == noise(3, {1, 0, 0}));
    CHECK(noise(3, {1e20f, 0, 0}) == noise(3, {1, 0, 0}));
}

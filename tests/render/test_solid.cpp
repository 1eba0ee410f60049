#include "error.hpp"
#include "noise/reference_3d.hpp"
#include "render/solid.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

using namespace gabor;
using noise::Vector3;
using render::SolidPicture;
using render::SolidView;
using render::SolidWaves;

namespace {

std::vector<float> rendered(const vulkan::Device& device, const SolidPicture& picture,
                            const image::Window& region, int most_rows) {
    render::check(picture);
    const render::Solid solid(device, picture, region);
    const auto row_values = 2 * static_cast<std::size_t>(region.width); // Y and A
    vulkan::Buffer buffer(device, static_cast<std::size_t>(most_rows) * row_values * sizeof(float),
                          vulkan::Memory::readback);
    vulkan::Job job = solid.job(device, buffer);
    std::vector<float> pixels;
    for (const render::Solid::Band& band : solid.bands(most_rows)) {
        solid.submit(job, band);
        job.wait();
        const auto values = buffer.as<float>().first(static_cast<std::size_t>(band.rows) * row_values);
        pixels.insert(pixels.end(), values.begin(), values.end());
    }
    return pixels;
}

Vector3 along(const Vector3& a, double t, const Vector3& b) {
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}

double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector3 scaled(double s, const Vector3& v) {
    return along({}, s, v);
}

// The camera of passes/solid.comp in double precision.
struct Camera {
    explicit Camera(const SolidPicture& of) : picture(of) {}

    Vector3 ray(double x, double y) const {
        const double side = 2 * 1.05 * std::tan(std::asin(0.25)) / std::min(picture.width, picture.height);
        const double right = (x - picture.width / 2.0) * side;
        const double up = (picture.height / 2.0 - y) * side;
        return along({right, up * sine, up * cosine}, -1, {0, -cosine, sine});
    }

    // Implicit function of the body: 0 on it, and its gradient.
    double value(const Vector3& p) const {
        if (picture.view == SolidView::sphere)
            return dot(p, p) - 1;
        const double whole = dot(p, p) + 0.68 * 0.68 - 0.3 * 0.3;
        return whole * whole - 4 * 0.68 * 0.68 * (p[0] * p[0] + p[1] * p[1]);
    }
    Vector3 normal(const Vector3& p) const {
        Vector3 gradient = p;
        if (picture.view == SolidView::torus) {
            const double whole = dot(p, p) + 0.68 * 0.68 - 0.3 * 0.3;
            gradient = {(whole - 2 * 0.68 * 0.68) * p[0], (whole - 2 * 0.68 * 0.68) * p[1], whole * p[2]};
        }
        return scaled(1 / std::sqrt(dot(gradient, gradient)), gradient);
    }

    // The first zero along a ray: by steps too small to miss more than the thinnest of grazes, then
    // bisection.
    std::optional<Vector3> hit(const Vector3& ray) const {
        double t = 2.9;
        for (; t < 5.5 && value(along(eye, t, ray)) > 0; t += 0.005) {
        }
        if (t >= 5.5)
            return {};
        double before = t - 0.005;
        for (int i = 0; i < 60; ++i) {
            const double middle = (before + t) / 2;
            (value(along(eye, middle, ray)) > 0 ? before : t) = middle;
        }
        return along(eye, t, ray);
    }

    // Where the ray meets the plane that touches the body.
    static Vector3 meet(const Vector3& from, const Vector3& ray, const Vector3& p, const Vector3& normal) {
        return along(from, dot(along(p, -1, from), normal) / dot(ray, normal), ray);
    }

    SolidPicture picture;
    double sine = 0.5;
    double cosine = std::sqrt(0.75);
    Vector3 eye{0, -4 * cosine, 4 * sine};
};

noise::Waves waves_of(const SolidPicture& picture, const Vector3& normal) {
    noise::Waves waves;
    waves.frequency = picture.frequency;
    if (picture.waves == SolidWaves::oriented || picture.waves == SolidWaves::surface)
        waves.direction = scaled(1 / std::sqrt(dot(picture.direction, picture.direction)), picture.direction);
    if (picture.waves == SolidWaves::surface || picture.waves == SolidWaves::surface_isotropic)
        waves.normal = normal;
    return waves;
}

// The noise at p, and how much it changes where p is off by a kernel radius.
struct Expected {
    double value;
    double slope;
};

Expected expected(const SolidPicture& picture, const noise::Waves& waves, const Vector3& p) {
    noise::Place3d place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        place.cell[axis] = static_cast<std::int32_t>(std::floor(p[axis]));
        place.local[axis] = static_cast<float>(p[axis] - std::floor(p[axis]));
    }
    const auto field = noise::Reference3d(noise::recipe_3d(), waves, picture.seed).field(place);
    return {field.value.imag(),
            std::hypot(field.slope[0].imag(), field.slope[1].imag(), field.slope[2].imag())};
}

constexpr SolidWaves all_waves[] = {SolidWaves::oriented, SolidWaves::isotropic, SolidWaves::surface,
                                    SolidWaves::surface_isotropic};

} // namespace

TEST_CASE("each pixel of a slice is the reference at its centre", "[solid]") {
    const vulkan::Device device;
    for (const SolidWaves waves : all_waves) {
        for (const bool filtered : {false, true}) {
            SolidPicture picture{150, 70, SolidView::slice, waves, 11.5, 3.5, {1, 2, -1}, 7.3, 5, filtered};
            const auto pixels = rendered(device, picture, {0, 0, 150, 70}, 70);
            noise::Waves seen = waves_of(picture, {0, 0, 1});
            if (filtered) {
                seen.dx = {1 / picture.scale, 0, 0};
                seen.dy = {0, 1 / picture.scale, 0};
            }
            double largest = 0;
            for (int y = 0; y < picture.height; ++y) {
                for (int x = 0; x < picture.width; ++x) {
                    const std::size_t at = 2 * static_cast<std::size_t>(y * picture.width + x);
                    const Vector3 p{(x + 0.5) / picture.scale, (y + 0.5) / picture.scale, picture.depth};
                    const Expected here = expected(picture, seen, p);
                    REQUIRE(pixels[at + 1] == 1);
                    largest = std::max(largest, std::abs(pixels[at] - here.value) / (1 + 0.1 * here.slope));
                }
            }
            fmt::print("slice, waves {}: largest difference {:.2g}\n", static_cast<int>(waves), largest);
            CHECK(largest < 1.5e-5);
        }
    }
}

TEST_CASE("a sphere and a torus carry the reference", "[solid]") {
    const vulkan::Device device;
    for (const SolidView view : {SolidView::sphere, SolidView::torus}) {
        for (const SolidWaves waves : all_waves) {
            SolidPicture picture{
                160, 120, view, waves, 8, 2, {0.2, -1, 0.4}, 0, 6, waves != SolidWaves::oriented};
            const auto pixels = rendered(device, picture, {0, 0, 160, 120}, 120);
            const Camera camera(picture);
            const double unit = render::sphere_radius(picture);
            double largest = 0;
            int compared = 0;
            for (int y = 0; y < picture.height; ++y) {
                for (int x = 0; x < picture.width; ++x) {
                    const std::size_t at = 2 * static_cast<std::size_t>(y * picture.width + x);
                    REQUIRE(std::isfinite(pixels[at]));
                    const Vector3 ray = camera.ray(x + 0.5, y + 0.5);
                    const auto p = camera.hit(ray);
                    const Vector3 normal = p ? camera.normal(*p) : Vector3{};
                    const double facing = p ? -dot(normal, ray) / std::sqrt(dot(ray, ray)) : 0;
                    if (facing < 0.1) // where grazing rays end is for coverage to blur
                        continue;
                    REQUIRE(pixels[at + 1] > 0);
                    noise::Waves seen = waves_of(picture, normal);
                    if (picture.filtered) {
                        constexpr double step = 1e-4; // of a pixel
                        const auto moved = [&](double dx, double dy) {
                            const Vector3 q =
                                Camera::meet(camera.eye, camera.ray(x + 0.5 + dx, y + 0.5 + dy), *p, normal);
                            return scaled(unit / step, along(q, -1, *p));
                        };
                        seen.dx = moved(step, 0);
                        seen.dy = moved(0, step);
                    }
                    const Expected here = expected(picture, seen, scaled(unit, *p));
                    // Places are off by 10^-6 of the unit, more where rays graze.
                    const double tolerance = 1e-5 + 5e-7 * unit * (here.slope + 20) / facing;
                    largest = std::max(largest, std::abs(pixels[at] - here.value) / tolerance);
                    ++compared;
                }
            }
            fmt::print("view {}, waves {}: {} pixels, largest difference {:.2f} of the tolerance\n",
                       static_cast<int>(view), static_cast<int>(waves), compared, largest);
            CHECK(largest < 1);
            CHECK(compared > 4000);
        }
    }
}

TEST_CASE("coverage is the share of a body's area, and what is not covered is 0", "[solid]") {
    const vulkan::Device device;
    const SolidPicture picture{200, 300, SolidView::sphere};
    const auto pixels = rendered(device, picture, {0, 0, 200, 300}, 300);
    double area = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
        area += pixels[i + 1];
        if (pixels[i + 1] == 0)
            REQUIRE(pixels[i] == 0);
    }
    // The sphere's outline is a circle that leaves 1/20 of the shorter side's half.
    const double radius = 100 / 1.05;
    CHECK(area == Approx(3.14159265 * radius * radius).epsilon(1e-3));
}

TEST_CASE("regions and bands of a solid picture are parts of the whole", "[solid]") {
    const vulkan::Device device;
    for (const SolidView view : {SolidView::slice, SolidView::sphere, SolidView::torus}) {
        SolidPicture picture;
        picture.view = view;
        picture.width = 90;
        picture.height = 80;
        const auto whole = rendered(device, picture, {0, 0, 90, 80}, 80);
        const image::Window region{13, 21, 60, 37};
        const auto part = rendered(device, picture, region, 10);
        REQUIRE(part.size() == std::size_t{60} * 37 * 2);
        for (int y = 0; y < region.height; ++y)
            for (int i = 0; i < 2 * region.width; ++i)
                REQUIRE(
                    part[static_cast<std::size_t>(y * 2 * region.width + i)] ==
                    whole[static_cast<std::size_t>((y + region.y) * 2 * picture.width + 2 * region.x + i)]);
    }
}

TEST_CASE("solid pictures outside the ranges are refused", "[solid]") {
    const auto refused = [](auto change) {
        SolidPicture picture;
        change(picture);
        CHECK_THROWS_AS(render::check(picture), RequestError);
    };
    render::check(SolidPicture{});
    refused([](SolidPicture& p) { p.width = 0; });
    refused([](SolidPicture& p) { p.height = 65537; });
    refused([](SolidPicture& p) { p.scale = 1.9; });
    refused([](SolidPicture& p) { p.frequency = std::numeric_limits<double>::quiet_NaN(); });
    refused([](SolidPicture& p) { p.depth = 1e7; });
    refused([](SolidPicture& p) { p.direction = {0, 0, 0}; });
    refused([](SolidPicture& p) { p.direction = {0, 0, 1e7}; });
}

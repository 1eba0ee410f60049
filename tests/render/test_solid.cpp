#include "error.hpp"
#include "largest.hpp"
#include "reference/lattice_3d.hpp"
#include "render/parameters.hpp"
#include "render/renderer.hpp"

#include "passes/solid_interface.h"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

using namespace gabor;
using noise::Lattice3d;
using Vector3 = Lattice3d::Vector;
using render::Body;
using render::Request;
using render::Shape;
using render::Slice;

namespace {

std::vector<float> rendered(const vulkan::Device& device, const Request& request, const image::Rect& region,
                            int most_rows, bool normals = false) {
    render::check(request);
    render::Viewport viewport = render::viewport_of(request, region);
    viewport.blocks = render::Blocks::none;
    viewport.normals = normals;
    const render::Renderer renderer(device, render::plan(request, viewport));
    const std::size_t row_values = renderer.plan().channels.size() * static_cast<std::size_t>(region.width);
    vulkan::Buffer buffer(device, static_cast<std::size_t>(most_rows) * row_values * sizeof(float),
                          vulkan::Memory::readback);
    vulkan::Job job = renderer.job(buffer);
    std::vector<float> pixels;
    for (const render::Band& band : render::bands(renderer.plan(), most_rows)) {
        renderer.submit(job, band);
        job.wait();
        const auto values = buffer.as<float>().first(static_cast<std::size_t>(band.rows) * row_values);
        pixels.insert(pixels.end(), values.begin(), values.end());
    }
    return pixels;
}

// Formats a pixel's position for messages.
auto pixel_name(auto x, auto y) {
    return [=] { return fmt::format("pixel {}, {}", x, y); };
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
    explicit Camera(const Request& of) : request(of), body(std::get<Body>(of.view)) {}

    // Rotates a vector from the camera's axes by its angles around the body's axis and above the equator.
    Vector3 turned(const Vector3& right_forward_up) const {
        const auto& [x, y, z] = right_forward_up;
        const double yaw = noise::radians(body.yaw);
        return {x * std::cos(yaw) - y * std::sin(yaw), x * std::sin(yaw) + y * std::cos(yaw), z};
    }
    Vector3 right() const { return turned({1, 0, 0}); }
    Vector3 up() const {
        const double pitch = noise::radians(body.pitch);
        return turned({0, std::sin(pitch), std::cos(pitch)});
    }
    Vector3 eye() const {
        const double pitch = noise::radians(body.pitch);
        return scaled(4, turned({0, -std::cos(pitch), std::sin(pitch)}));
    }

    Vector3 ray(double x, double y) const {
        const double side =
            2 * 1.05 * std::tan(std::asin(0.25)) / std::min(request.width, request.height) / body.zoom;
        const Vector3 plane =
            along(scaled((x - request.width / 2.0) * side, right()), (request.height / 2.0 - y) * side, up());
        return along(plane, -0.25, eye());
    }

    // The body's implicit function, which is 0 on the surface.
    double value(const Vector3& p) const {
        if (body.shape == Shape::sphere)
            return dot(p, p) - 1;
        const double whole = dot(p, p) + 0.68 * 0.68 - 0.3 * 0.3;
        return whole * whole - 4 * 0.68 * 0.68 * (p[0] * p[0] + p[1] * p[1]);
    }
    Vector3 normal(const Vector3& p) const {
        Vector3 gradient = p;
        if (body.shape == Shape::torus) {
            const double whole = dot(p, p) + 0.68 * 0.68 - 0.3 * 0.3;
            gradient = {(whole - 2 * 0.68 * 0.68) * p[0], (whole - 2 * 0.68 * 0.68) * p[1], whole * p[2]};
        }
        return scaled(1 / std::sqrt(dot(gradient, gradient)), gradient);
    }

    // Finds the first zero along a ray by small steps, which miss only the thinnest grazes, and bisection.
    std::optional<Vector3> hit(const Vector3& ray) const {
        double t = 2.9;
        for (; t < 5.5 && value(along(eye(), t, ray)) > 0; t += 0.005) {
        }
        if (t >= 5.5)
            return {};
        double before = t - 0.005;
        for (int i = 0; i < 60; ++i) {
            const double middle = (before + t) / 2;
            (value(along(eye(), middle, ray)) > 0 ? before : t) = middle;
        }
        return along(eye(), t, ray);
    }

    // The intersection of the ray with the tangent plane.
    static Vector3 meet(const Vector3& from, const Vector3& ray, const Vector3& p, const Vector3& normal) {
        return along(from, dot(along(p, -1, from), normal) / dot(ray, normal), ray);
    }

    Request request;
    Body body;
};

// The noise at p on a surface or in space, and its sensitivity to an error of p, per kernel radius.
struct Expected {
    double value;
    double slope;
};

Expected expected(const Request& request, const Vector3& normal, const Vector3& p, const Vector3& dx,
                  const Vector3& dy) {
    const noise::Lobe& lobe = request.lobes.front();
    const double angle = noise::radians(lobe.orientation);
    const Vector3 direction{std::cos(angle), std::sin(angle), 0};
    const Body* body = std::get_if<Body>(&request.view);
    const bool isotropic = lobe.orientation_spread > 0;
    Lattice3d::Place place;
    place.time = static_cast<float>(request.time);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double node = 1.5 * p[axis];
        place.cell[axis] = static_cast<std::int32_t>(std::floor(node));
        place.local[axis] = static_cast<float>(node - std::floor(node));
    }
    double value = 0;
    Vector3 slope{};
    const auto add = [&](double weight, const auto& one) {
        const Lattice3d::Field field = request.filter ? one.filtered(place, dx, dy) : one.field(place);
        value += weight * field.value.imag();
        for (std::size_t axis = 0; axis < 3; ++axis)
            slope[axis] += weight * field.slope[axis].imag();
    };
    const bool animated = request.time != 0;
    const bool on_surface = body && !body->solid;
    if (isotropic && on_surface)
        for (const auto& [weight, noise] :
             noise::surface_isotropic(normal, lobe.frequency, request.seed, animated))
            add(weight, noise);
    else if (isotropic)
        add(1, noise::Isotropic3d(lobe.frequency, request.seed, animated));
    else if (on_surface)
        for (const noise::WeightedWave& w :
             noise::surface_waves(normal, lobe.frequency, direction, request.seed))
            add(w.weight, Lattice3d(w.wave, w.seed, animated));
    else
        add(1, Lattice3d(scaled(lobe.frequency, direction), request.seed, animated));
    return {value, std::sqrt(dot(slope, slope))};
}

// The largest difference of a filtered pixel from quadrature; see test_filter_3d.cpp.
constexpr double filter_error = 0.04;

} // namespace

TEST_CASE("each pixel of a slice is the reference at its centre", "[solid]") {
    const vulkan::Device device;
    for (const double spread : {0.0, 90.0}) {
        for (const bool filtered : {false, true}) {
            const Request request{.width = 150,
                                  .height = 70,
                                  .scale = 11.5,
                                  .lobes = {{spread > 0 ? 1.2 : 3.5, 63, 0, spread}},
                                  .seed = 5,
                                  .time = filtered ? 0 : 0.3,
                                  .view = Slice{7.3},
                                  .filter = filtered};
            const auto pixels = rendered(device, request, {0, 0, 150, 70}, 70);
            test::Largest largest;
            for (int y = 0; y < request.height; y += filtered ? 9 : 1) { // quadrature is slow
                for (int x = 0; x < request.width; x += filtered ? 7 : 1) {
                    const std::size_t at = 2 * static_cast<std::size_t>(y * request.width + x);
                    const Vector3 p{(x + 0.5) / request.scale, (y + 0.5) / request.scale, 7.3};
                    const Expected here =
                        expected(request, {0, 0, 1}, p, {1 / request.scale, 0, 0}, {0, 1 / request.scale, 0});
                    REQUIRE(pixels[at + 1] == 1);
                    const double tolerance = (filtered ? filter_error : 1.5e-5) * (1 + 0.1 * here.slope);
                    largest.see(pixels[at], here.value, tolerance, pixel_name(x, y));
                }
            }
            largest.check(fmt::format("{}slice, spread {}", filtered ? "filtered " : "", spread));
        }
    }
}

TEST_CASE("a sphere and a torus show the reference noise", "[solid]") {
    const vulkan::Device device;
    // The default camera of gabor render, and another camera at another time.
    const Body turned{.yaw = -70, .pitch = -55, .zoom = 1.4};
    for (const Body& pose : {Body(), turned})
        for (const Shape shape : {Shape::sphere, Shape::torus}) {
            for (const auto& [solid, spread] : {std::pair(true, 0.0), std::pair(true, 90.0),
                                                std::pair(false, 0.0), std::pair(false, 90.0)}) {
                Body body = pose;
                body.shape = shape;
                body.solid = solid;
                const Request request{.width = 160,
                                      .height = 120,
                                      .scale = 8,
                                      .lobes = {{solid && spread > 0 ? 1.0 : 2.0, -79, 0, spread}},
                                      .seed = 6,
                                      .time = pose == turned ? 0.6 : 0,
                                      .view = body,
                                      .filter = !solid || spread > 0};
                const auto pixels = rendered(device, request, {0, 0, 160, 120}, 120);
                const Camera camera(request);
                const render::Bytes push =
                    render::plan(request, render::viewport_of(request, {0, 0, 1, 1})).steps.front().push;
                const double unit = double{render::values_of<passes::SolidPush>(push).front().unit};
                test::Largest largest;
                int compared = 0;
                const int stride = request.filter ? (spread > 0 ? 17 : 21) : 2; // quadrature is slow
                // Coverage blurs grazing rays. Isotropic noise is filtered up to pixels of 0.3 kernel radii;
                // here a pixel that faces the eye covers 1/8 radius.
                const double least_facing = !request.filter ? 0.1 : spread > 0 ? 0.42 : 0.25;
                for (int y = 0; y < request.height; y += stride) {
                    for (int x = 0; x < request.width; x += stride) {
                        const std::size_t at = 2 * static_cast<std::size_t>(y * request.width + x);
                        REQUIRE(std::isfinite(pixels[at]));
                        const Vector3 ray = camera.ray(x + 0.5, y + 0.5);
                        const auto p = camera.hit(ray);
                        const Vector3 normal = p ? camera.normal(*p) : Vector3{};
                        const double facing = p ? -dot(normal, ray) / std::sqrt(dot(ray, ray)) : 0;
                        if (facing < least_facing)
                            continue;
                        REQUIRE(pixels[at + 1] > 0);
                        Vector3 dx{};
                        Vector3 dy{};
                        if (request.filter) {
                            constexpr double step = 1e-4; // in pixels
                            const auto moved = [&](double right, double down) {
                                const Vector3 q = Camera::meet(
                                    camera.eye(), camera.ray(x + 0.5 + right, y + 0.5 + down), *p, normal);
                                return scaled(unit / step, along(q, -1, *p));
                            };
                            dx = moved(step, 0);
                            dy = moved(0, step);
                        }
                        const Expected here = expected(request, normal, scaled(unit, *p), dx, dy);
                        // Places are off by 10^-6 of the unit, and by more at grazing angles; the normal
                        // turns surface waves by at most four times as much.
                        const double turning = solid || spread > 0 ? 1 : 4;
                        const double tolerance = (request.filter ? filter_error : 1e-5) +
                                                 5e-7 * turning * unit * (here.slope + 20) / facing;
                        largest.see(pixels[at], here.value, tolerance, pixel_name(x, y));
                        ++compared;
                    }
                }
                largest.check(
                    fmt::format("shape {}, solid {}, spread {}", static_cast<int>(shape), solid, spread));
                CHECK(compared > 4000 / (stride * stride));
            }
        }
}

TEST_CASE("coverage is the covered share of a pixel, and uncovered pixels are 0", "[solid]") {
    const vulkan::Device device;
    const Request request{.width = 200, .height = 300, .view = Body(), .filter = true};
    const auto pixels = rendered(device, request, {0, 0, 200, 300}, 300);
    double area = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
        area += pixels[i + 1];
        if (pixels[i + 1] == 0)
            REQUIRE(pixels[i] == 0);
    }
    // The sphere's outline leaves a margin of 1/20 of half the shorter side.
    const double radius = 100 / 1.05;
    CHECK(area == Approx(3.14159265 * radius * radius).epsilon(1e-3));
}

TEST_CASE("regions and bands of a solid picture match the whole", "[solid]") {
    const vulkan::Device device;
    for (const render::View& view :
         {render::View(Slice()), render::View(Body()), render::View(Body{Shape::torus})}) {
        const Request request{.width = 90, .height = 80, .view = view, .filter = true};
        const auto whole = rendered(device, request, {0, 0, 90, 80}, 80);
        const image::Rect region{13, 21, 60, 37};
        const auto part = rendered(device, request, region, 10);
        REQUIRE(part.size() == std::size_t{60} * 37 * 2);
        for (int y = 0; y < region.height; ++y)
            for (int i = 0; i < 2 * region.width; ++i)
                REQUIRE(
                    part[static_cast<std::size_t>(y * 2 * region.width + i)] ==
                    whole[static_cast<std::size_t>((y + region.y) * 2 * request.width + 2 * region.x + i)]);
    }
}

TEST_CASE("a body has quadrature, gradient, phasor and normal beside its noise", "[solid]") {
    const vulkan::Device device;
    for (const render::View& view : {render::View(Slice{1.5}), render::View(Body{.yaw = 20})}) {
        Request request{
            .width = 120, .height = 90, .scale = 12, .lobes = {{1.5, 30}}, .seed = 3, .view = view};
        const auto alone = rendered(device, request, {0, 0, 120, 90}, 90);
        request.quadrature = request.gradient = request.phasor = true;
        REQUIRE(render::channels(request) == std::vector<std::string>{"Y", "quadrature", "gradient.x",
                                                                      "gradient.y", "phase", "intensity",
                                                                      "A"});
        const auto pixels = rendered(device, request, {0, 0, 120, 90}, 90);
        test::Largest phasor, slope;
        int compared = 0;
        for (std::size_t i = 0; i < 120 * 90; ++i) {
            const float* at = &pixels[7 * i];
            REQUIRE(at[0] == Approx(alone[2 * i]).margin(1e-5));
            REQUIRE(at[6] == alone[2 * i + 1]);
            if (at[6] < 1)
                continue;
            const double turn = 2 * std::numbers::pi * at[4];
            const std::string place = fmt::format("pixel {}", i);
            phasor.see(at[5] * std::sin(turn), at[0], 1e-4, place);
            phasor.see(at[5] * std::cos(turn), at[1], 1e-4, place);
            ++compared;
        }
        phasor.check("phasor");
        CHECK(compared > 4000);
        if (!std::holds_alternative<Slice>(view)) {
            const auto lit = rendered(device, request, {0, 0, 120, 90}, 90, true);
            const Camera camera(request);
            test::Largest normal;
            for (std::size_t i = 0; i < 120 * 90; ++i) {
                const float* at = &lit[11 * i];
                REQUIRE(std::equal(at, at + 6, &pixels[7 * i]));
                REQUIRE(at[10] == pixels[7 * i + 6]);
                const double x = static_cast<double>(i % 120) + 0.5, y = static_cast<double>(i / 120) + 0.5;
                const std::optional<Vector3> p = camera.hit(camera.ray(x, y));
                if (at[10] < 1 || !p)
                    continue;
                normal.see(at[6], dot(*p, camera.right()), 1e-4, pixel_name(x, y));
                normal.see(at[7], -dot(*p, camera.up()), 1e-4, pixel_name(x, y));
                normal.see(at[8], dot(*p, camera.eye()) / 4, 1e-4, pixel_name(x, y));
            }
            normal.check("normal");
            continue;
        }
        // The gradient of a slice is that of its pixels, whose rows count downwards.
        const double tolerance = 0.15 * 2 * std::numbers::pi * 1.5 * 3;
        for (std::size_t y = 1; y < 89; ++y) {
            for (std::size_t x = 1; x < 119; ++x) {
                const auto value = [&](std::size_t column, std::size_t row) {
                    return double{pixels[7 * (120 * row + column)]};
                };
                const float* at = &pixels[7 * (120 * y + x)];
                slope.see(at[2], 6 * (value(x + 1, y) - value(x - 1, y)), tolerance, pixel_name(x, y));
                slope.see(at[3], 6 * (value(x, y + 1) - value(x, y - 1)), tolerance, pixel_name(x, y));
            }
        }
        slope.check("gradient");
    }
}

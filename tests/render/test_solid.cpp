// Compares pictures of slices and bodies with the drop-in's functions, translated to C++, at the points that
// the pixels show. tests/functions compares these functions with the reference.

#include "gabor_noise.hpp"

#include "gabor_filter.hpp"

#include "gabor_noise_3d.hpp"

#include "gabor_filter_3d.hpp"

#include "largest.hpp"
#include "reference/vector.hpp"
#include "render/output/renderer.hpp"
#include "render/request/parameters.hpp"

#include <catch2/catch.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

using namespace gabor;
using noise::dot;
using noise::scaled;
using noise::sum;
using render::Blocks;
using render::Projection;
using render::Request;
using Vector = noise::Vector<3>;

namespace {

std::vector<float> rendered(const vulkan::Device& device, const Request& request, const image::Rect& region,
                            bool normals = false, Blocks blocks = Blocks::none) {
    render::check(request);
    render::Viewport viewport = render::viewport_of(request, region);
    viewport.blocks = blocks;
    viewport.normals = normals;
    std::vector<float> pixels;
    render::render_plan(
        device, render::Renderer(device, render::plan(request, viewport)),
        [&](std::span<const float> rows) { pixels.insert(pixels.end(), rows.begin(), rows.end()); });
    return pixels;
}

image::Rect whole(const Request& request) {
    return {0, 0, request.width, request.height};
}

gabor_vec3 narrow(const Vector& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}

// What a pixel shows: a point and the steps to the next pixels, in kernel radii, and the normal there.
struct Seen {
    Vector p{}, dx{}, dy{};
    Vector normal{0, 0, 1};
    double facing = 1; // cosine of the angle between the normal and the ray to the eye
};

// The camera of passes/body.glsl in double precision.
struct Camera {
    explicit Camera(const Request& of) : request(of) {
        if (of.view.is_body()) {
            const double yaw = noise::radians(of.view.orbit.yaw), pitch = noise::radians(of.view.orbit.pitch);
            right = {std::cos(yaw), std::sin(yaw), 0};
            down = {std::sin(yaw) * std::sin(pitch), -std::cos(yaw) * std::sin(pitch), -std::cos(pitch)};
            toward_eye = noise::cross(down, right);
        }
    }

    // The ray from the eye, which is 4 units away from the centre. The unit sphere's outline leaves a margin
    // of 1/20 of its radius.
    Vector ray(double x, double y) const {
        const double side = margin / std::min(request.width, request.height) / request.view.orbit.zoom;
        const Vector across = sum((x - request.width / 2.0) * side, right, 1, scaled(-1, toward_eye));
        return sum(1, across, (y - request.height / 2.0) * side, down);
    }

    // The body's implicit function, which is 0 on the surface, and its direction of steepest ascent.
    double value(const Vector& p) const {
        if (request.view.projection == Projection::sphere)
            return noise::length(p) - 1;
        return std::hypot(std::hypot(p[0], p[1]) - 0.68, p[2]) - 0.3;
    }
    Vector normal(const Vector& p) const {
        const double from_axis = std::hypot(p[0], p[1]);
        const double inside = request.view.projection == Projection::sphere ? 0 : 0.68 / from_axis;
        return noise::unit(Vector{p[0] * (1 - inside), p[1] * (1 - inside), p[2]});
    }

    // Finds the first zero along a ray by bisection after small steps, which miss only rays that barely graze
    // the body.
    std::optional<Seen> seen(double x, double y) const {
        if (request.view.projection == Projection::slice)
            return Seen{{x / request.scale, y / request.scale, request.view.depth},
                        {1 / request.scale, 0, 0},
                        {0, 1 / request.scale, 0}};
        const Vector eye = scaled(4, toward_eye), along = ray(x, y);
        double t = 2.9;
        while (t < 5.5 && value(sum(1, eye, t, along)) > 0)
            t += 0.005;
        if (t >= 5.5)
            return {};
        for (double step = 0.0025; step > 1e-12; step /= 2)
            t += value(sum(1, eye, t, along)) > 0 ? step : -step;
        Seen here{.p = sum(1, eye, t, along)};
        here.normal = normal(here.p);
        here.facing = -dot(here.normal, noise::unit(along));
        const double unit = std::min(request.width, request.height) / (3 * margin * request.scale);
        const auto to = [&](const Vector& next) { // where the ray `next` meets the tangent plane
            const double meets = dot(sum(1, here.p, -1, eye), here.normal) / dot(next, here.normal);
            return scaled(unit, sum(1, sum(1, eye, meets, next), -1, here.p));
        };
        here.dx = scaled(1e6, to(ray(x + 1e-6, y)));
        here.dy = scaled(1e6, to(ray(x, y + 1e-6)));
        here.p = scaled(unit, here.p);
        return here;
    }

    static constexpr double margin = 2 * 1.05 / 3.872983346207417; // tan(asin(1/4)) = 1 / sqrt(15)
    Request request;
    Vector right{1, 0, 0}, down{0, 1, 0}, toward_eye{0, 0, 1};
};

GaborField3d field_at(const Request& request, const Seen& seen) {
    const noise::Lobe& lobe = request.lobes.front();
    const auto angle = static_cast<float>(noise::radians(lobe.orientation));
    const gabor_vec3 along(std::cos(angle), std::sin(angle), 0), normal = narrow(seen.normal);
    const gabor_vec3 dx = narrow(seen.dx), dy = narrow(seen.dy);
    const auto frequency = static_cast<float>(lobe.frequency);
    const bool isotropic = lobe.orientation_spread > 0;
    GaborPlace3d place = gabor_place_3d_at(narrow(seen.p));
    place.evolution = static_cast<float>(request.evolution);
    if (request.view.along_surface() && request.filter)
        return isotropic
                   ? gabor_field_surface_isotropic_filtered(place, dx, dy, normal, frequency, request.seed)
                   : gabor_field_surface_filtered(place, dx, dy, normal, frequency, along, request.seed);
    if (request.view.along_surface())
        return isotropic ? gabor_field_surface_isotropic(place, normal, frequency, request.seed)
                         : gabor_field_surface(place, normal, frequency, along, request.seed);
    if (request.filter)
        return isotropic ? gabor_field_3d_isotropic_filtered(place, dx, dy, frequency, request.seed)
                         : gabor_field_3d_filtered(place, dx, dy, frequency * along, request.seed);
    return isotropic ? gabor_field_3d_isotropic(place, frequency, request.seed)
                     : gabor_field_3d(place, frequency * along, request.seed);
}

void compare(const vulkan::Device& device, const Request& request, Blocks blocks = Blocks::none) {
    const Camera camera(request);
    const bool is_body = request.view.is_body();
    const bool normals = is_body && request.gradient;
    const std::vector<float> pixels = rendered(device, request, whole(request), normals, blocks);
    const std::vector<std::string> channels = render::channels(request, normals);
    std::map<std::string, test::Largest> of;
    for (int y = 0; y < request.height; ++y) {
        for (int x = 0; x < request.width; ++x) {
            const auto seen = camera.seen(x + 0.5, y + 0.5);
            if (!seen || seen->facing < 0.1) // near an outline, where pixels may be partly covered
                continue;
            const GaborField3d field = field_at(request, *seen);
            const Vector slope{field.gradient.x, field.gradient.y, field.gradient.z};
            // Points are off by 5e-7 of their distance from the centre, and by more at grazing angles; the
            // error of the normal rotates surface waves by several times as much.
            const double steepness = 2 * std::numbers::pi * request.lobes.front().frequency + 4;
            const double off = is_body ? 5e-7 * noise::length(seen->p) / seen->facing : 1e-6;
            const double tight = 1e-5 + off * (noise::length(slope) + 20), loose = tight * steepness;
            const std::complex<double> value(field.quadrature, field.noise);
            const std::map<std::string_view, std::pair<double, double>> expected{
                {"Y", {value.imag(), tight}},
                {"quadrature", {value.real(), tight}},
                {"gradient.x", {dot(slope, camera.right), loose}},
                {"gradient.y", {dot(slope, camera.down), loose}},
                {"gradient.z", {dot(slope, camera.toward_eye), loose}},
                {"intensity", {std::abs(value), tight}},
                {"normal.x", {dot(seen->normal, camera.right), 1e-5 / seen->facing}},
                {"normal.y", {dot(seen->normal, camera.down), 1e-5 / seen->facing}},
                {"normal.z", {dot(seen->normal, camera.toward_eye), 1e-5 / seen->facing}}};
            for (std::size_t c = 0; c < channels.size(); ++c) {
                const float found =
                    pixels[static_cast<std::size_t>(y * request.width + x) * channels.size() + c];
                const auto where = [&] { return fmt::format("pixel {}, {}", x, y); };
                if (channels[c] == "A")
                    REQUIRE(found > 0);
                else if (channels[c] == "phase") // as complex numbers, because phases wrap
                    of["phase"].see(
                        std::abs(std::polar(std::abs(value), 2 * std::numbers::pi * found) - value), 0, tight,
                        where);
                else
                    of[channels[c]].see(found, expected.at(channels[c]).first,
                                        expected.at(channels[c]).second, where);
            }
        }
    }
    test::check(of, channels.size() - 1);
}

} // namespace

TEST_CASE("each pixel of a slice is the noise at its centre", "[solid]") {
    const vulkan::Device device;
    for (const double spread : {0.0, 90.0}) {
        Request request{.width = 150,
                        .height = 70,
                        .scale = 11.5,
                        .lobes = {{spread > 0 ? 1.2 : 3.5, 63, 0, spread}},
                        .seed = 5,
                        .evolution = 0.3,
                        .view = {.projection = Projection::slice, .depth = 7.3}};
        compare(device, request);
        compare(device, request, Blocks::fitted);
        request.filter = request.quadrature = request.gradient = request.phasor = true;
        compare(device, request);
    }
}

TEST_CASE("each pixel of a sphere or a torus is the noise where its ray hits the body", "[solid]") {
    const vulkan::Device device;
    for (const Projection shape : {Projection::sphere, Projection::torus})
        for (const bool solid : {false, true})
            for (const double spread : {0.0, 90.0}) {
                // Half of the pictures have every channel, another camera and another time.
                const bool detailed = (shape == Projection::torus) ^ solid ^ (spread > 0);
                render::View body{.projection = shape, .solid = solid};
                if (detailed)
                    body.orbit = {-70, -55, 1.4};
                fmt::print("{}, solid {}, spread {}\n", shape == Projection::torus ? "torus" : "sphere",
                           solid, spread);
                compare(device, {.width = 80,
                                 .height = 60,
                                 .scale = 4,
                                 .lobes = {{solid && spread > 0 ? 1.0 : 2.0, -79, 0, spread}},
                                 .seed = 6,
                                 .evolution = detailed ? 0.6 : 0,
                                 .view = body,
                                 .filter = !solid || spread > 0,
                                 .quadrature = detailed,
                                 .gradient = detailed,
                                 .phasor = detailed});
            }
}

TEST_CASE("coverage is the covered share of a pixel, and uncovered pixels are 0", "[solid]") {
    const vulkan::Device device;
    const Request request{
        .width = 200, .height = 300, .view = {.projection = Projection::sphere}, .filter = true};
    const auto pixels = rendered(device, request, whole(request));
    double area = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
        area += pixels[i + 1];
        if (pixels[i + 1] == 0)
            REQUIRE(pixels[i] == 0);
    }
    // The sphere's outline leaves a margin of 1/20 of its radius.
    const double radius = 100 / 1.05;
    CHECK(area == Approx(3.14159265 * radius * radius).epsilon(1e-3));
}

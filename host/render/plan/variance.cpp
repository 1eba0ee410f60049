#include "render/plan/variance.hpp"

#include "noise/spectrum.hpp"
#include "noise/variance.hpp"
#include "render/plan/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

struct Variances {
    double noise = 0;
    double slope_x = 0;
    double slope_y = 0;
};

// Returns the variances of a wave and of its slope along one axis, with lengths in the wave's own kernel
// radii. The slopes of the wave and of its windows are uncorrelated; for Hann's window, the integral of h'^2
// is pi^2 / 3 times that of h^2.
noise::AxisVariance along_axis(const Request& request, double frequency, double deviation) {
    if (request.filter)
        return noise::filtered_variance(frequency, deviation);
    const double turn = 2 * std::numbers::pi * frequency;
    return {1, turn * turn + std::numbers::pi * std::numbers::pi / 3};
}

// Returns the sums of the variances of the lattice's waves in the plane, or nothing if the filter is on and
// a pixel is wider than a kernel radius.
std::optional<Variances> variances(const Request& request) {
    Variances sum;
    for (const noise::Wave& wave : noise::waves(request.lobes, request.seed)) {
        // The number of kernel radii of the wave per kernel radius of the picture. Windows stretch with the
        // nodes to fit a period.
        const auto kernels = [&](int side, double radius) {
            return axis_along(request, side, radius).radius / double{request.recipe.radius} / radius;
        };
        const double x = kernels(request.width, wave.radius[0]);
        const double y = kernels(request.height, wave.radius[1]);
        const double deviation = 0.5 / request.scale;
        if (request.filter && deviation * std::max(x, y) > 0.5)
            return {};
        const auto across = along_axis(request, wave.frequency * std::cos(wave.angle) / x, deviation * x);
        const auto down = along_axis(request, wave.frequency * std::sin(wave.angle) / y, deviation * y);
        sum.noise += wave.share * across.noise * down.noise;
        sum.slope_x += wave.share * x * x * across.slope * down.noise;
        sum.slope_y += wave.share * y * y * across.noise * down.slope;
    }
    return sum;
}

} // namespace

std::optional<double> known_variance(const Request& request, std::string_view channel) {
    const bool flat = request.view.projection == Projection::flat;
    if (request.kind != Kind::noise || request.view.has_horizon())
        return {}; // a horizon includes the sky
    const bool noise = channel == "Y";
    if (noise && !request.filter)
        return 1;
    if (!flat || !request.paint.empty() || request.recipe.taps < 3)
        return {};
    const std::optional<Variances> all = variances(request);
    if (!all)
        return {};
    if (noise)
        return all->noise;
    if (channel == "gradient.x")
        return all->slope_x;
    if (channel == "gradient.y")
        return all->slope_y;
    return {};
}

} // namespace gabor::render

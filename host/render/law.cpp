#include "render/law.hpp"

#include "noise/variance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gabor::render {

namespace {

// That of the noise's derivative along `axis`, a wave's and its windows': the two are uncorrelated.
std::optional<double> gradient_variance(const Request& request, bool along_y) {
    const Plane* plane = std::get_if<Plane>(&request.view);
    const noise::Recipe recipe = drawing_recipe(request);
    if (!plane || plane->tileable || !request.paint.empty() || !is_one_wave(request) || !recipe.is_lattice())
        return {};
    const noise::Lobe& lobe = request.lobes.front();
    const double along = along_y ? std::sin(lobe.angle()) : std::cos(lobe.angle());
    const double slope = 2 * std::numbers::pi * lobe.frequency * along;
    return slope * slope + noise::window_slope_energy(recipe) / (lobe.radius * lobe.radius);
}

} // namespace

std::optional<double> known_variance(const Request& request, std::string_view channel,
                                     std::optional<double> removed) {
    const bool flat = std::holds_alternative<Plane>(request.view);
    if (!flat && !std::holds_alternative<Slice>(request.view))
        return {}; // sky and background belong to the picture too
    if (request.filter)
        return channel == "Y" && flat && removed ? std::optional(1 - *removed) : std::nullopt;
    if (channel == "gradient.x" || channel == "gradient.y")
        return gradient_variance(request, channel == "gradient.y");
    if (channel == "quadrature") // two phases make sines, whose cosines have another variance
        return drawing_recipe(request).phases == 2 ? std::nullopt : std::optional(1.0);
    constexpr std::array noises{"Y", "second", "third", "fourth"};
    return std::ranges::find(noises, channel) != noises.end() ? std::optional(1.0) : std::nullopt;
}

} // namespace gabor::render

#include "render/axis.hpp"

#include <cmath>

namespace gabor::render {

Axis axis_along(const Picture& picture, int side) {
    const double radius = noise::find_recipe(picture.recipe).radius;
    if (!picture.tileable)
        return {radius, 0};
    const double period = std::floor(side / picture.scale * radius);
    return {period / side * picture.scale, static_cast<std::int32_t>(period)};
}

} // namespace gabor::render

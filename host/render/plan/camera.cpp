#include "render/plan/camera.hpp"

#include <cmath>

namespace gabor::render {

Coordinate Coordinate::moved(double by) const {
    const double carried = std::floor(by);
    Coordinate result{whole + static_cast<std::int64_t>(carried), part + (by - carried)};
    if (result.part >= 1) {
        ++result.whole;
        result.part -= 1;
    }
    return result;
}

Camera default_camera(const Request& request) {
    if (!request.view.is_flat())
        return {};
    return Camera{}.moved(request.width / 2.0 / request.scale, request.height / 2.0 / request.scale);
}

std::pair<std::int32_t, double> cell_at(const Coordinate& coordinate, double cells) {
    const double whole = static_cast<double>(coordinate.whole);
    const double far = whole * cells;
    const double rounding = std::fma(whole, cells, -far); // whole * cells = far + rounding, exactly
    const double base = std::floor(far);
    const double place = (far - base) + rounding + coordinate.part * cells;
    const double carried = std::floor(place);
    const auto cell = static_cast<std::int64_t>(base) + static_cast<std::int64_t>(carried);
    return {static_cast<std::int32_t>(static_cast<std::uint32_t>(cell)), place - carried};
}

Axis axis_along(const Request& request, int side, double radius) {
    const double cells = double{drawing_recipe(request).radius};
    if (!request.view.tileable)
        return {cells, 0};
    const double scale = request.scale * radius;
    const double period = std::floor(side / scale * cells);
    return {period / side * scale, static_cast<std::int32_t>(period)};
}

} // namespace gabor::render

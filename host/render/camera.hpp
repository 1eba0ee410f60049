#pragma once

#include "render/request.hpp"

#include <cstdint>
#include <utility>

namespace gabor::render {

/// A coordinate in kernel radii, as precise far away as near by: whole + part, part in [0, 1).
struct Coordinate {
    std::int64_t whole = 0;
    double part = 0;

    Coordinate moved(double by) const;
    bool operator==(const Coordinate&) const = default;
};

/// The point of the plane in the middle of the view, or under the camera of a horizon, and a magnification.
struct Camera {
    Coordinate x;
    Coordinate y;
    double zoom = 1;

    Camera moved(double by_x, double by_y) const { return {x.moved(by_x), y.moved(by_y), zoom}; }
    bool operator==(const Camera&) const = default;
};

/// The camera of the request's own picture.
Camera default_camera(const Request& request);

/// The cell at a coordinate, and the place in it. `cells`: per kernel radius. Cells wrap around at 2^31, as
/// those of the drop-ins do.
std::pair<std::int32_t, double> cell_at(const Coordinate& coordinate, double cells);

/// The cells along a side of a picture: the recipe's, or as many whole ones as fit a tileable picture.
struct Axis {
    double radius;       ///< cells per kernel radius
    std::int32_t period; ///< in cells, 0 for none
};

/// `side`: width or height of the request. `radius`: of the kernels, as noise::Wave has it.
Axis axis_along(const Request& request, int side, double radius = 1);

/// Rows above the horizon of a picture of so many rows.
constexpr double sky_rows(double height) {
    return height / 4;
}

} // namespace gabor::render

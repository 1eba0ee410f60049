#pragma once

#include "render/request/request.hpp"

#include <cstdint>
#include <utility>

namespace gabor::render {

/// A coordinate in kernel radii: whole + part, with part in [0, 1). It is equally precise everywhere.
struct Coordinate {
    std::int64_t whole = 0;
    double part = 0;

    Coordinate moved(double by) const;
    double value() const { return static_cast<double>(whole) + part; }
    bool operator==(const Coordinate&) const = default;
};

/// The point in the middle of the view (in the horizon view, the point below the camera) and a magnification.
struct Camera {
    Coordinate x;
    Coordinate y;
    double zoom = 1;

    Camera moved(double by_x, double by_y) const { return {x.moved(by_x), y.moved(by_y), zoom}; }
    bool operator==(const Camera&) const = default;
};

/// The camera that gabor render uses.
Camera default_camera(const Request& request);

/// Returns the cell at a coordinate, and the position in it. `cells` is the number of cells per kernel
/// radius. Cells wrap around at 2^31, as in the drop-ins.
std::pair<std::int32_t, double> cell_at(const Coordinate& coordinate, double cells);

/// The cells along a side of a picture; a tileable picture has a whole number of them.
struct Axis {
    double radius;       ///< cells per kernel radius
    std::int32_t period; ///< period in cells; 0 for none
};

/// Returns the cells along a side. `side` is the request's width or height in pixels; `radius` is the radius
/// of the kernels, as in noise::Wave.
Axis axis_along(const Request& request, int side, double radius = 1);

/// Rows above the horizon in a picture of `height` rows.
constexpr double sky_rows(double height) {
    return height / 4;
}

} // namespace gabor::render

#pragma once

#include <cstdint>
#include <vector>

namespace gabor::viewer {

/// A coordinate in kernel radii that is as precise far away as it is near: whole + part, part in [0, 1).
struct Coordinate {
    std::int64_t whole = 0;
    double part = 0;

    Coordinate moved(double by) const;
    bool operator==(const Coordinate&) const = default;
};

/// The point of the plane in the middle of the view.
struct Camera {
    Coordinate x;
    Coordinate y;

    Camera moved(double by_x, double by_y) const { return {x.moved(by_x), y.moved(by_y)}; }
    bool operator==(const Camera&) const = default;
};

/// As in shaders/viewer/grid.glsl.
struct AxisPlace {
    std::int32_t cell;
    float local;
};

/// The place `by` kernel radii from a coordinate. `radius`: cells per kernel radius. Cells wrap around at
/// 2^31, as the drop-in's do.
AxisPlace place_at(const Coordinate& coordinate, double by, double radius);

/// The places along an axis of a view of `pixels` pixels, `scale` pixels per kernel radius, `stride` pixels
/// apart: the first in the middle of the first `stride` pixels.
void add_places(std::vector<AxisPlace>& places, const Coordinate& middle, int pixels, double scale,
                int stride, double radius);

} // namespace gabor::viewer

#include "viewer/tiling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gabor::viewer {

Tiling tiling_of(const Document& document, Extent view) {
    const render::Request& request = document.request;
    const int parts = std::gcd(request.width, request.height);
    const auto fitting = [&](int side, int available) { return available / 2 / (side / parts); };
    const int kept = std::clamp(
        std::min(fitting(request.width, view.width), fitting(request.height, view.height)), 1, parts);
    Tiling tiling;
    tiling.tile = {request.width / parts * kept, request.height / parts * kept};
    tiling.camera = render::default_camera(request);
    tiling.camera.zoom = static_cast<double>(kept) / parts;
    const double scale = request.scale * tiling.camera.zoom;
    const auto moved = [&](const Coordinate& from, const Coordinate& to, int side) {
        const double by = (static_cast<double>(to.whole - from.whole) + (to.part - from.part)) * scale;
        return static_cast<float>(std::floor(by - side * std::floor(by / side)));
    };
    tiling.moved = {moved(tiling.camera.x, document.camera.x, tiling.tile.width),
                    moved(tiling.camera.y, document.camera.y, tiling.tile.height)};
    return tiling;
}

} // namespace gabor::viewer

#include "viewer/drawing.hpp"

#include "noise/spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gabor::viewer {

namespace {

// The highest frequency, in cycles per pixel of the picture.
double cycles_per_pixel(const render::Request& request, const render::Paint& paint) {
    if (!request.paint.empty())
        return render::highest_frequency(request, paint) / request.scale;
    return std::ranges::max(noise::waves(request.lobes, request.seed), {}, &noise::Wave::frequency)
               .frequency /
           request.scale;
}

} // namespace

Drawing drawing_of(const Document& document) {
    render::Request request = document.request;
    request.gradient = request.phasor = false;
    return {with_output(request, document.output),
            is_lit(document) && !render::is_surface(request.kind) && request.view.is_body()};
}

render::Viewport viewport_of(const Drawing& drawing, const Camera& camera, Extent extent, int stride) {
    return {.camera = camera,
            .width = extent.width,
            .height = extent.height,
            .region = {0, 0, (extent.width + stride - 1) / stride, (extent.height + stride - 1) / stride},
            .stride = stride,
            .blocks = render::Blocks::fixed,
            .normals = drawing.normals};
}

int coarsest_stride(const Drawing& drawing, const render::Paint& paint, double zoom) {
    constexpr int coarsest = 16;
    constexpr int coarsest_baked = 4; // blocks lie within cells, which have fewer values at larger strides
    constexpr double least_per_wave = 3;
    const render::Request& request = drawing.request;
    const bool blocks = uses_blocks(request, viewport_of(drawing, {{}, {}, zoom}, {1, 1}));
    int stride = blocks ? coarsest_baked : coarsest;
    const bool fades = request.paint.empty() || request.filter;
    if (render::is_surface(request.kind) || !request.view.is_flat() || (fades && !request.quadrature))
        return stride;
    const double pixels = zoom / cycles_per_pixel(request, paint); // pixels per shortest wave
    while (stride > 1 && pixels < least_per_wave * stride)
        stride /= 2;
    return stride;
}

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

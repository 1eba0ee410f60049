#pragma once

#include "render/plan.hpp"

#include "passes/bake_interface.h"

namespace gabor::render {

/// Covers the pixels first, ..., first + count - 1 with runs of at most `longest` pixels. Pixel i is centred
/// at origin + (i + 0.5) * cells_per_pixel cells and visits the cells within `radius`. The grid decides where
/// runs start, so that all parts of a picture are cut alike; the first and last run may extend past the
/// range.
std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin = 0);

/// Plans passes/bake.comp, and passes/bake_colour.comp for colour. Noises of one kernel radius share a step,
/// since they share their runs. `constants` are those that depend on the request.
void plan_bake(Plan& plan, const Request& request, const Viewport& viewport, DeviceKind device,
               const Constants& constants);

} // namespace gabor::render

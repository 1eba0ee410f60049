#pragma once

#include "render/plan.hpp"

#include "passes/bake_interface.h"

namespace gabor::render {

/// The runs of at most `longest` pixels that cover the pixels first, ..., first + count - 1. Pixel i is
/// centred at origin + (i + 0.5) * cells_per_pixel cells and visits the cells within `radius` of there. Where
/// runs begin depends on the grid alone, so that every part of a picture is cut in the same way; the first
/// and the last run may reach beyond what was asked for.
std::vector<passes::Run> make_runs(int first, int count, double cells_per_pixel, double radius, int longest,
                                   double origin = 0);

/// The tables and steps of passes/bake.comp, and in colour of passes/bake_colour.comp: noises of one kernel
/// radius are filled together, for their pixels fall into the same runs. `constants`: what the request
/// decides.
void plan_bake(Plan& plan, const Request& request, const Viewport& viewport, DeviceKind device,
               const Constants& constants);

} // namespace gabor::render

// The ids of the specialization constants of all passes over a picture, for GLSL and C++.

#ifndef GABOR_CONSTANTS_H
#define GABOR_CONSTANTS_H

#include "passes/interface.h"

GABOR_INTERFACE_BEGIN

// passes/recipe.glsl
const uint impulses_id = 0;
const uint radius_id = 1;
const uint weight_floor_id = 2;
const uint phases_id = 3;
const uint window_id = 4; // the first of three

// What to draw
const uint view_id = 7; // one of the views below
const uint filter_id = 8;
const uint painted_id = 9;
const uint animated_id = 10;

// passes/noise_channels.glsl; passes/erode.comp has only the first
const uint channels_id = 11;
const uint quadrature_id = 12;
const uint gradient_id = 13;
const uint phasor_id = 14;
const uint normal_id = 15;
const uint coverage_id = 16;
const uint removed_id = 17;
const uint coloured_id = 18;

// passes/solid.comp: whether any noise is isotropic, and whether any is not
const uint isotropic_id = 19;
const uint directed_id = 20;

// passes/bake.comp
const uint visited_id = 21;
const uint block_columns_id = 22;
const uint fixed_rows_id = 23;
const uint sum_id = 24;

// passes/material.comp, passes/pixels.comp and passes/bake.comp: whether opposite edges match
const uint tiled_id = 25;

// passes/pixels.comp and passes/bake.comp
const uint few_waves_id = 26;
const uint narrow_waves_id = 27;
const uint wide_waves_id = 28;

// passes/material.comp: what surrounds the material, whether it is laid as boards, and whether it has a
// finish and a coat
const uint environment_id = 29;
const uint boards_id = 30;
const uint finish_id = 31;
const uint coat_id = 37;

// passes/fractal.comp: members of GaborFractal, and whether a warp moves the noise
const uint basis_id = 32;
const uint shape_id = 33;
const uint warped_id = 34;

// passes/terrain.comp: what covers the ground, as in passes/landscape.glsl, and whether there are lakes
const uint cover_id = 35;
const uint lakes_id = 36;

// passes/material.comp and passes/terrain.comp: whether the channels of light are left as they are
const uint unlit_id = 38;

const uint constant_count = 39;

const uint view_flat = 0;
const uint view_sphere = 1;
const uint view_torus = 2;
const uint view_horizon = 3;
const uint view_slice = 4;
const uint view_terrain = 5;
const uint view_landscape = 6;

GABOR_INTERFACE_END

#endif // GABOR_CONSTANTS_H

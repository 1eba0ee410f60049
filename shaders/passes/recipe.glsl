// Includes the drop-in of a recipe. If GABOR_TAPS is defined, it is the lattice, with one SPIR-V module for each number of
// taps. Otherwise it is the sparse noise, with one module, whose macros are specialization constants.

#extension GL_EXT_control_flow_attributes : require

#ifdef GABOR_TAPS
#include "gabor_noise.glsl"
#else

#include "passes/constants.h"

layout(constant_id = impulses_id) const int recipe_impulses = 1;
layout(constant_id = radius_id) const float recipe_radius = 1.0;
layout(constant_id = weight_floor_id) const float recipe_weight_floor = 1.0;
layout(constant_id = phases_id) const int recipe_phases = 2;
layout(constant_id = window_id) const float recipe_window_x = 1.0;
layout(constant_id = window_id + 1) const float recipe_window_y = 0.0;
layout(constant_id = window_id + 2) const float recipe_window_z = 0.0;

#define GABOR_UNCHECKED 1
#define GABOR_IMPULSES recipe_impulses
#define GABOR_CELLS_PER_RADIUS recipe_radius
#define GABOR_WEIGHT_FLOOR recipe_weight_floor
#define GABOR_PHASES recipe_phases
#define GABOR_WINDOW vec3(recipe_window_x, recipe_window_y, recipe_window_z)

// Specialization constants bound the loops, which compilers unroll only if asked.
#define for [[unroll]] for
#include "gabor_sparse.glsl"
#undef for

#endif

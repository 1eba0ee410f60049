// Both drop-ins, the recipe in space as specialization constants: one SPIR-V module serves every recipe.

layout(constant_id = 0) const int recipe_impulses = 1;
layout(constant_id = 1) const float recipe_radius = 1.0;
layout(constant_id = 2) const float recipe_window_x = 3.1;
layout(constant_id = 3) const float recipe_window_y = -3.9;
layout(constant_id = 4) const float recipe_window_z = 1.8;

#define GABOR_UNCHECKED
#define GABOR_3D_IMPULSES recipe_impulses
#define GABOR_3D_RADIUS recipe_radius
#define GABOR_3D_WINDOW vec3(recipe_window_x, recipe_window_y, recipe_window_z)

#include "gabor_noise.glsl"
#include "gabor_noise_3d.glsl"

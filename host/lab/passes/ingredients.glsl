// The ingredients as specialization constants: one SPIR-V module serves every combination.

layout(constant_id = 0) const int ingredient_impulses = 1;
layout(constant_id = 1) const int ingredient_points = 0;
layout(constant_id = 2) const int ingredient_weights = 0;
layout(constant_id = 3) const int ingredient_kernel = 0;
layout(constant_id = 4) const int ingredient_envelope = 0;
layout(constant_id = 5) const int ingredient_period = 0;
layout(constant_id = 6) const int hex_step = 0;
layout(constant_id = 7) const float hex_a_x = 1.0;
layout(constant_id = 8) const float hex_a_y = 0.0;
layout(constant_id = 9) const float hex_b_x = 0.0;
layout(constant_id = 10) const float hex_b_y = 1.0;
layout(constant_id = 11) const float hex_overhang = 0.0;

#define GABOR_UNCHECKED 1
#define GABOR_IMPULSES ingredient_impulses
#define GABOR_POINTS ingredient_points
#define GABOR_WEIGHTS ingredient_weights
#define GABOR_KERNEL ingredient_kernel
#define GABOR_ENVELOPE ingredient_envelope
#define GABOR_PERIOD ingredient_period
#define GABOR_HEX_STEP hex_step
#define GABOR_HEX_A vec2(hex_a_x, hex_a_y)
#define GABOR_HEX_B vec2(hex_b_x, hex_b_y)
#define GABOR_HEX_OVERHANG hex_overhang

#include "gabor_ingredients.glsl"

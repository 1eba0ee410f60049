#version 450
#extension GL_GOOGLE_include_directive : require

#define GABOR_TAPS 3
#include "gabor_lattice.glsl"
#include "drop_in.glsl"

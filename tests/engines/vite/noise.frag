#version 300 es
#include "node_modules/gabor-noise/shaders/gabor_lattice.glsl"
#include "scene.glsl"

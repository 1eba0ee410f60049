#version 300 es
#include "node_modules/gabor-noise/shaders/gabor_noise.glsl"
#include "scene.glsl"

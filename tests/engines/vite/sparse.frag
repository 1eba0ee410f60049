#version 300 es
#include "node_modules/gabor-noise/shaders/gabor_sparse.glsl"
#include "scene.glsl"

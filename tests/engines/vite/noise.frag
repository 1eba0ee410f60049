#version 300 es
precision highp float;

#include "node_modules/gabor-noise/shaders/gabor_noise.glsl"
#include "scene.glsl"

#version 450
#extension GL_GOOGLE_include_directive : require

#include "recipe.glsl"
#include "drop_in.glsl"

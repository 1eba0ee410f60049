#version 450
#extension GL_GOOGLE_include_directive : require

// Nothing but the writing: how fast the picture's memory takes values.

#include "bench.glsl"

float value(vec2 p, uint instance) {
    return frequency;
}

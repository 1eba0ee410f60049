#version 450

#include "gabor_noise.glsl"
#include "gabor_ocean.glsl"

layout(local_size_x = 64) in;
layout(std430, set = 0, binding = 0) restrict buffer Points { vec2 points[]; }; // heights replace their x
layout(push_constant) uniform Push { float wind; float seconds; int count; };

void main() {
	uint i = gl_GlobalInvocationID.x;
	if (i < uint(count))
		points[i].x = gabor_water_height(points[i], seconds, gabor_ocean(wind), 7u);
}

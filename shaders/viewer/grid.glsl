// What the viewer's passes share: a grid of places, one per invocation, or places drawn at random from independent
// instances, for the law of the values. Each pass defines
//     void evaluate(ivec2 cell, vec2 local, uint instance, uint at)
// which writes the channels of one place to values[at] and on.

layout(local_size_x = 8, local_size_y = 8) in;

struct AxisPlace {
    int cell;
    float local; // from that cell's corner, in cells
};

layout(std430, set = 0, binding = 0) writeonly buffer Values { float values[]; };
layout(std430, set = 0, binding = 1) readonly buffer Places { AxisPlace places[]; }; // of columns, then of rows

layout(push_constant) uniform Push {
    float frequency;
    float orientation; // radians
    float time;
    float amplitude;   // of what is not normalized by itself
    uint seed;
    uint width;
    uint height;
    uint first_row;
    uint end_row;
    uint sampling; // 1: places at random
    uint first_sample;
};

layout(constant_id = 12) const int channels = 1;

void evaluate(ivec2 cell, vec2 local, uint instance, uint at);

uint random_word(inout uint state)
{
    state = state * 747796405u + 2891336453u; // PCG-RXS-M-XS of O'Neill, HMC-CS-2014-0905
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return (word >> 22u) ^ word;
}

void main()
{
    uvec2 here = gl_GlobalInvocationID.xy + uvec2(0u, first_row);
    if (here.x >= width || here.y >= end_row)
        return;
    uint index = here.y * width + here.x;
    AxisPlace x = places[here.x];
    AxisPlace y = places[width + here.y];
    ivec2 cell = ivec2(x.cell, y.cell);
    vec2 local = vec2(x.local, y.local);
    uint instance = seed;
    if (sampling != 0u) {
        uint state = (first_sample + index) * 0x9e3779b9u + seed;
        random_word(state);
        instance = random_word(state);
        uint x_word = random_word(state);
        uint y_word = random_word(state);
        cell = ivec2(x_word & 63u, y_word & 63u);
        local = vec2(float(x_word >> 8u), float(y_word >> 8u)) / 16777216.0;
    }
    evaluate(cell, local, instance, index * uint(channels));
}

// What the viewer's passes share: a grid of places of a flat picture, one per invocation; or pixels of a view in
// perspective; or places drawn at random from independent instances, for the law of the values. Each pass defines
//     void evaluate(ivec2 cell, vec2 local, uint instance, uint at)
//     void evaluate_view(vec2 pixel, uint at)
// which write the channels of one place to values[at] and on.

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
    float middle_x;    // of the view, pixels from its corner
    float middle_y;
    float stride;      // pixels per value
    float focal;       // distance of the picture from the eye, pixels
    float unit;        // kernel radii: a body's unit, or from the eye to the middle of a plane in perspective
    float yaw;         // where the eye is, radians
    float pitch;
    int cell_x;        // what is in the middle of a plane
    int cell_y;
    float local_x;
    float local_y;
};

layout(constant_id = 12) const int channels = 1;
layout(constant_id = 13) const int view = 0;     // 0 plane, 1 plane in perspective, 2 sphere, 3 torus
layout(constant_id = 14) const int waves = 0;    // in space: 0 oriented, 1 isotropic, 2 and 3 the same along the surface
layout(constant_id = 15) const int filtered = 0; // 1: by the pixel's footprint

void evaluate(ivec2 cell, vec2 local, uint instance, uint at);
void evaluate_view(vec2 pixel, uint at);

// Where a pixel, counted from the middle, looks at a plane in perspective, in kernel radii from what is in the middle,
// and the steps from there to its neighbours'. False above the horizon.
bool perspective(vec2 pixel, out vec2 p, out vec2 dx, out vec2 dy)
{
    float height = unit * cos(pitch);
    float below = focal * cos(pitch) + pixel.y * sin(pitch);
    p = vec2(height * pixel.x / below, unit * sin(pitch) + height * (pixel.y * cos(pitch) - focal * sin(pitch)) / below);
    dx = stride * vec2(height / below, 0.0);
    dy = stride * height / (below * below) * vec2(-pixel.x * sin(pitch), focal);
    return below > 1.0e-3 * focal;
}

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
    if (view != 0 && sampling == 0u) {
        evaluate_view((vec2(here) + 0.5) * stride - vec2(middle_x, middle_y), index * uint(channels));
        return;
    }
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

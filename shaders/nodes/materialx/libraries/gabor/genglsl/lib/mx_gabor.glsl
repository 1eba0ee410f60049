// Gabor noise from gabor_noise.glsl without its structs: for GLSL, ESSL, Vulkan, WGSL, MSL and Slang. tools/translate copies
// the functions between the marks from the drop-in, and generates ../genosl and ../genmdl from this file. As OSL requires,
// vectors are read and built one component at a time.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- From gabor_noise.glsl ----

#define MX_GABOR_ROWS 0x5bd1e995u
#define MX_GABOR_SLICES 0x27d4eb2fu
#define MX_GABOR_SCALE2D 6.0884665e-28
#define MX_GABOR_SCALE3D 5.7402612e-28

uint mx_gabor_mix(uint word, uint salt)
{
    uint once = (word ^ (word >> 16u)) * 0x21f0aaadu + salt;
    uint twice = (once ^ (once >> 15u)) * 0xd35a2d97u;
    return twice ^ (twice >> 15u);
}

uint mx_gabor_derived_seed(uint seed, int index)
{
    return mx_gabor_mix(seed + uint(index) * 0x85ebca6bu, 0x9e3779b1u);
}

uint mx_gabor_salt(uint seed)
{
    return mx_gabor_mix(seed * 0x9e3779b1u, 0x2545f491u);
}

uint mx_gabor_line_word(int index, uint salt)
{
    uint word = uint(index) * 0x9e3779b1u + salt;
    return ((word * (word ^ (word >> 15u))) >> 8u) | 0x800001u;
}

vec2 mx_gabor_amplitude(uint word)
{
    vec2 u = vec2(float(int(word)), float(int(word << 12u)));

    return (u - 0.89289313 * clamp(u, -2.0119258e9, 2.0119258e9)) * (u * u + 7.3973916e18);
}

vec2 mx_gabor_product(vec2 a, vec2 b)
{
    return a.x * b + a.y * vec2(-b.y, b.x);
}

vec2 mx_gabor_half_turn(float t)
{
    float s = t * t, r = s * s;

    return vec2((1.0 - 19.739171 * s) + r * ((64.934591 - 85.240337 * s) + 56.24243 * r),
                t * ((6.2831852 - 41.341655 * s) + r * ((81.601004 - 76.549782 * s) + 39.536707 * r)));
}

vec2 mx_gabor_wave(float t)
{
    float within = t - floor(t + 0.5);
    vec2 turn = mx_gabor_half_turn(0.25 - abs(within));
    return vec2(turn.y, within < 0.0 ? -turn.x : turn.x);
}

// ---- End ----

// The hash word of a row in a slice of the 3D lattice.
uint mx_gabor_slice_word(uint row, uint slice)
{
    return ((row * slice) >> 8u) | 0x800001u;
}

// The windows 1/2 + 1/2 cos(2/3 pi (x - i)) of the nodes i = -1, 0 and 1. x is in node spacings from node 0.
vec3 mx_gabor_windows(float x)
{
    vec2 turn = mx_gabor_wave(0.33333333 * x);
    float s = 0.4330127 * turn.y;
    float c = 0.5 - 0.25 * turn.x;
    return vec3(c - s, 0.5 + 0.5 * turn.x, c + s);
}

// The derivatives of these windows per kernel radius, which is 3/2 node spacings.
vec3 mx_gabor_slopes(float x)
{
    vec2 turn = mx_gabor_wave(0.33333333 * x);
    float s = 0.78539816 * turn.y;
    float c = 1.3603495 * turn.x;
    return vec3(s - c, -2.0 * s, s + c);
}

// The sum over three nodes along an axis. `turn` is the wave's phase step between nodes, as a complex number.
vec2 mx_gabor_sum(vec2 a, vec2 b, vec2 c, vec3 weights, vec2 turn)
{
    vec2 before = mx_gabor_product(turn, a);
    vec2 after = mx_gabor_product(vec2(turn.x, -turn.y), c);
    return weights.x * before + weights.y * b + weights.z * after;
}

// The same for two sums at once.
vec4 mx_gabor_sums(vec4 a, vec4 b, vec4 c, vec3 weights, vec2 turn)
{
    vec2 first = mx_gabor_sum(vec2(a.x, a.y), vec2(b.x, b.y), vec2(c.x, c.y), weights, turn);
    vec2 second = mx_gabor_sum(vec2(a.z, a.w), vec2(b.z, b.w), vec2(c.z, c.w), weights, turn);
    return vec4(first.x, first.y, second.x, second.y);
}

// The sums over a row of nodes, weighted by the windows along x and by their slopes.
vec4 mx_gabor_row(uint row, uint before, uint middle, uint after, vec3 windows, vec3 slopes, vec2 turn)
{
    vec2 a = mx_gabor_amplitude(before * row);
    vec2 b = mx_gabor_amplitude(middle * row);
    vec2 c = mx_gabor_amplitude(after * row);
    vec2 value = mx_gabor_sum(a, b, c, windows, turn);
    vec2 slope = mx_gabor_sum(a, b, c, slopes, turn);
    return vec4(value.x, value.y, slope.x, slope.y);
}

// Noise, quadrature and the noise's gradient per kernel radius. p is in kernel radii, the wave in cycles per radius.
vec4 mx_gabor_field2d(vec2 p, vec2 wave, int seed)
{
    float x = 1.5 * p.x;
    float y = 1.5 * p.y;
    float column = floor(x + 0.5);
    float row = floor(y + 0.5);
    x = clamp(x - column, -0.5, 0.5);
    y = clamp(y - row, -0.5, 0.5);
    int i = int(column);
    int j = int(row);
    uint columns = mx_gabor_salt(uint(seed));
    uint rows = columns ^ MX_GABOR_ROWS;
    uint before = mx_gabor_line_word(i - 1, columns);
    uint middle = mx_gabor_line_word(i, columns);
    uint after = mx_gabor_line_word(i + 1, columns);

    float turns_x = wave.x / 1.5;
    float turns_y = wave.y / 1.5;
    vec2 turn = mx_gabor_wave(turns_x);
    vec3 windows = mx_gabor_windows(x);
    vec3 slopes = mx_gabor_slopes(x);
    vec4 a = mx_gabor_row(mx_gabor_line_word(j - 1, rows), before, middle, after, windows, slopes, turn);
    vec4 b = mx_gabor_row(mx_gabor_line_word(j, rows), before, middle, after, windows, slopes, turn);
    vec4 c = mx_gabor_row(mx_gabor_line_word(j + 1, rows), before, middle, after, windows, slopes, turn);
    vec2 turn_y = mx_gabor_wave(turns_y);
    vec4 sum = mx_gabor_sums(a, b, c, mx_gabor_windows(y), turn_y);
    vec4 along_y = mx_gabor_sums(a, b, c, mx_gabor_slopes(y), turn_y);

    vec2 phase = MX_GABOR_SCALE2D * mx_gabor_wave(x * turns_x + y * turns_y);
    vec2 value = mx_gabor_product(vec2(sum.x, sum.y), phase);
    vec2 slope_x = mx_gabor_product(vec2(sum.z, sum.w), phase);
    vec2 slope_y = mx_gabor_product(vec2(along_y.x, along_y.y), phase);
    return vec4(value.y, value.x, slope_x.y + 6.2831853 * wave.x * value.x, slope_y.y + 6.2831853 * wave.y * value.x);
}

// The sums over a slice of the 3D lattice, weighted by the windows along x or their slopes, and by `weights` along y.
vec4 mx_gabor_slice(uint slice, uint below, uint level, uint above, uint before, uint middle, uint after, vec3 windows,
                    vec3 slopes, vec2 turn, vec3 weights, vec2 turn_y)
{
    vec4 a = mx_gabor_row(mx_gabor_slice_word(below, slice), before, middle, after, windows, slopes, turn);
    vec4 b = mx_gabor_row(mx_gabor_slice_word(level, slice), before, middle, after, windows, slopes, turn);
    vec4 c = mx_gabor_row(mx_gabor_slice_word(above, slice), before, middle, after, windows, slopes, turn);
    return mx_gabor_sums(a, b, c, weights, turn_y);
}

// Noise in 3D and its gradient, in the units of mx_gabor_field2d.
vec4 mx_gabor_field3d(vec3 p, vec3 wave, int seed)
{
    float x = 1.5 * p.x;
    float y = 1.5 * p.y;
    float z = 1.5 * p.z;
    float column = floor(x + 0.5);
    float row = floor(y + 0.5);
    float layer = floor(z + 0.5);
    x = clamp(x - column, -0.5, 0.5);
    y = clamp(y - row, -0.5, 0.5);
    z = clamp(z - layer, -0.5, 0.5);
    int i = int(column);
    int j = int(row);
    int k = int(layer);
    uint columns = mx_gabor_salt(uint(seed));
    uint rows = columns ^ MX_GABOR_ROWS;
    uint slices = columns ^ MX_GABOR_SLICES;
    uint before = mx_gabor_line_word(i - 1, columns);
    uint middle = mx_gabor_line_word(i, columns);
    uint after = mx_gabor_line_word(i + 1, columns);
    uint below = mx_gabor_line_word(j - 1, rows);
    uint level = mx_gabor_line_word(j, rows);
    uint above = mx_gabor_line_word(j + 1, rows);
    uint front = mx_gabor_line_word(k - 1, slices);
    uint centre = mx_gabor_line_word(k, slices);
    uint back = mx_gabor_line_word(k + 1, slices);

    vec2 turn_x = mx_gabor_wave(wave.x / 1.5);
    vec2 turn_y = mx_gabor_wave(wave.y / 1.5);
    vec2 turn_z = mx_gabor_wave(wave.z / 1.5);
    vec3 wx = mx_gabor_windows(x);
    vec3 sx = mx_gabor_slopes(x);
    vec3 wy = mx_gabor_windows(y);
    vec3 sy = mx_gabor_slopes(y);
    vec3 wz = mx_gabor_windows(z);
    vec4 a = mx_gabor_slice(front, below, level, above, before, middle, after, wx, sx, turn_x, wy, turn_y);
    vec4 b = mx_gabor_slice(centre, below, level, above, before, middle, after, wx, sx, turn_x, wy, turn_y);
    vec4 c = mx_gabor_slice(back, below, level, above, before, middle, after, wx, sx, turn_x, wy, turn_y);
    vec4 sum = mx_gabor_sums(a, b, c, wz, turn_z);
    vec4 along_z = mx_gabor_sums(a, b, c, mx_gabor_slopes(z), turn_z);
    a = mx_gabor_slice(front, below, level, above, before, middle, after, wx, sx, turn_x, sy, turn_y);
    b = mx_gabor_slice(centre, below, level, above, before, middle, after, wx, sx, turn_x, sy, turn_y);
    c = mx_gabor_slice(back, below, level, above, before, middle, after, wx, sx, turn_x, sy, turn_y);
    vec4 along_y = mx_gabor_sums(a, b, c, wz, turn_z);

    vec2 phase = MX_GABOR_SCALE3D * mx_gabor_wave((x * wave.x + y * wave.y + z * wave.z) / 1.5);
    vec2 value = mx_gabor_product(vec2(sum.x, sum.y), phase);
    vec2 slope_x = mx_gabor_product(vec2(sum.z, sum.w), phase);
    vec2 slope_y = mx_gabor_product(vec2(along_y.x, along_y.y), phase);
    vec2 slope_z = mx_gabor_product(vec2(along_z.x, along_z.y), phase);
    return vec4(value.y, slope_x.y + 6.2831853 * wave.x * value.x, slope_y.y + 6.2831853 * wave.y * value.x,
                slope_z.y + 6.2831853 * wave.z * value.x);
}

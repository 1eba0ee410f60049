// The sums of octaves of gabor_fractal.glsl, written like mx_gabor.glsl, which stands before this file. A basis is 0 for
// smooth noise or 1 for Perlin noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// For a node at distance d, in node spacings: its window u, the derivative of u, the window v, and the derivative of v.
// Both windows are divided as in gabor_fractal.glsl; smooth noise has no v. The squares of the four shifts of
// cos(pi d / 4)^4 sum to (35 + cos(2 pi d)) / 32, and those of its derivative to pi^2 (5 - cos(2 pi d)) / 32.
vec4 mx_gabor_fractal_window(float d, int basis)
{
    if (basis == 0) {
        if (abs(d) > 1.5) return vec4(0.0, 0.0, 0.0, 0.0);
        vec2 wave = mx_gabor_wave(0.33333333 * d);
        return vec4(0.47140452 + 0.47140452 * wave.x, -0.98730732 * wave.y, 0.0, 0.0); // sqrt(2)/3, 2/9 sqrt(2) pi
    }
    vec2 turn = mx_gabor_wave(0.25 * d);
    vec2 whole = mx_gabor_wave(d);
    float hann = 0.5 + 0.5 * turn.x;
    float slope = -0.78539816 * turn.y; // pi/4
    float even = 5.6568542 / sqrt(35.0 + whole.x); // sqrt(32)
    float odd = 1.8006327 / sqrt(5.0 - whole.x); // sqrt(32)/pi
    float v = 2.0 * hann * slope;
    float bend = 2.0 * slope * slope - 2.4674011 * hann * turn.x; // pi^2/4
    return vec4(even * hann * hann, even * (v + 3.1415927 * hann * hann * whole.y / (35.0 + whole.x)), odd * v,
                odd * (bend - 3.1415927 * v * whole.y / (5.0 - whole.x))); // pi
}

// The sums over a row of four nodes: of real amplitudes times v and its derivative, and of imaginary ones times u and
// its derivative; if not mixed, of real ones times u and its derivative.
vec4 mx_gabor_fractal_row(uint row, uint a, uint b, uint c, uint d, vec4 at_a, vec4 at_b, vec4 at_c, vec4 at_d,
                          int mixed)
{
    vec2 first = mx_gabor_amplitude(a * row);
    vec2 second = mx_gabor_amplitude(b * row);
    vec2 third = mx_gabor_amplitude(c * row);
    vec2 fourth = mx_gabor_amplitude(d * row);
    if (mixed == 0)
        return vec4(at_a.x * first.x + at_b.x * second.x + at_c.x * third.x + at_d.x * fourth.x,
                    at_a.y * first.x + at_b.y * second.x + at_c.y * third.x + at_d.y * fourth.x, 0.0, 0.0);
    return vec4(at_a.z * first.x + at_b.z * second.x + at_c.z * third.x + at_d.z * fourth.x,
                at_a.w * first.x + at_b.w * second.x + at_c.w * third.x + at_d.w * fourth.x,
                at_a.x * first.y + at_b.x * second.y + at_c.x * third.y + at_d.x * fourth.y,
                at_a.y * first.y + at_b.y * second.y + at_c.y * third.y + at_d.y * fourth.y);
}

// The sum over a plane of nodes, and its derivatives. In space, `slice` is the word of the plane's slice, else 0.
// Smooth noise and, where `third` is 1, the third term of Perlin noise are the sums that are not mixed.
vec3 mx_gabor_fractal_plane(float x, float y, uint salt, uint slice, int basis, int third)
{
    int mixed = basis - third;
    float column = basis == 0 ? floor(x + 0.5) : floor(x);
    float row = basis == 0 ? floor(y + 0.5) : floor(y);
    float right = x - column;
    float above = y - row;
    int i = int(column);
    vec4 at_a = mx_gabor_fractal_window(right + 1.0, basis);
    vec4 at_b = mx_gabor_fractal_window(right, basis);
    vec4 at_c = mx_gabor_fractal_window(right - 1.0, basis);
    vec4 at_d = mx_gabor_fractal_window(right - 2.0, basis);
    uint a = mx_gabor_line_word(i - 1, salt);
    uint b = mx_gabor_line_word(i, salt);
    uint c = mx_gabor_line_word(i + 1, salt);
    uint d = mx_gabor_line_word(i + 2, salt);
    float value = 0.0;
    float along_x = 0.0;
    float along_y = 0.0;
    for (int j = -1; j < 2 + basis; ++j) {
        uint word = mx_gabor_line_word(int(row) + j, salt ^ MX_GABOR_ROWS);
        if (slice != 0u) word = mx_gabor_slice_word(word, slice);
        if (third == 1) word = (((word ^ (word >> 15u)) * 0xd35a2d97u) >> 8u) | 0x800001u;
        vec4 sum = mx_gabor_fractal_row(word, a, b, c, d, at_a, at_b, at_c, at_d, mixed);
        vec4 at = mx_gabor_fractal_window(above - float(j), basis);
        value += at.x * sum.x + at.z * sum.z;
        along_x += at.x * sum.y + at.z * sum.w;
        along_y += at.y * sum.x + at.w * sum.z;
    }
    return vec3(value, along_x, along_y);
}

// An octave of variance 1 and its derivatives per node spacing. In the plane, `solid` is 0 and z is not used.
vec4 mx_gabor_fractal_octave(float x, float y, float z, int solid, uint salt, int basis)
{
    if (solid == 0) {
        float factor = (basis == 0 ? 1.125 : 0.79549513) * MX_GABOR_SCALE2D; // 9/8, and over sqrt(2)
        vec3 plane = factor * mx_gabor_fractal_plane(x, y, salt, 0u, basis, 0);
        return vec4(plane.x, plane.y, plane.z, 0.0);
    }
    float layer = basis == 0 ? floor(z + 0.5) : floor(z);
    float value = 0.0;
    float along_x = 0.0;
    float along_y = 0.0;
    float along_z = 0.0;
    for (int k = -1; k < 2 + basis; ++k) {
        uint slice = mx_gabor_line_word(int(layer) + k, salt ^ MX_GABOR_SLICES);
        vec4 at = mx_gabor_fractal_window(z - layer - float(k), basis);
        vec3 plane = mx_gabor_fractal_plane(x, y, salt, slice, basis, 0);
        value += at.x * plane.x;
        along_x += at.x * plane.y;
        along_y += at.x * plane.z;
        along_z += at.y * plane.x;
        if (basis == 1) {
            plane = mx_gabor_fractal_plane(x, y, salt, slice, basis, 1);
            value += at.z * plane.x;
            along_x += at.z * plane.y;
            along_y += at.z * plane.z;
            along_z += at.w * plane.x;
        }
    }
    float scale = (basis == 0 ? 1.125 : 0.64951905) * MX_GABOR_SCALE2D; // 9/8, and over sqrt(3)
    return vec4(scale * value, scale * along_x, scale * along_y, scale * along_z);
}

// The sum of octaves, of variance 1, and its derivatives per kernel radius. Each octave is `lacunarity` times finer
// than the previous one, and turned against it by atan(3/4): in space, about (1, 1, 1). It is also moved, so that its
// nodes are not those of the previous one. A step's parts are multiples of 1/4096, as in gabor_fractal.glsl. A shape is
// 0 for fBm, 1 for billows or 2 for ridges.
vec4 mx_gabor_fractal(vec3 p, int solid, float octaves, float lacunarity, float gain, int shape, int basis, int seed)
{
    float x = 1.5 * p.x;
    float y = 1.5 * p.y;
    float z = 1.5 * p.z;
    float grain = 4096.0 * min(max(lacunarity, 1.0), 4.0);
    float a = floor((solid == 0 ? 0.8 : 0.86666667) * grain + 0.5) / 4096.0; // 13/15
    float b = floor((solid == 0 ? 0.6 : -0.27974349) * grain + 0.5) / 4096.0; // 1/15 - sqrt(3)/5
    float c = solid == 0 ? 0.0 : floor(0.41307683 * grain + 0.5) / 4096.0; // 1/15 + sqrt(3)/5
    // the derivatives of an octave's position along x; those along y and z have the same parts
    float along_a = 1.5;
    float along_b = 0.0;
    float along_c = 0.0;
    float count = min(max(octaves, 1.0), 16.0);
    float amplitude = 1.0;
    float power = 0.0;
    float value = 0.0;
    float slope_x = 0.0;
    float slope_y = 0.0;
    float slope_z = 0.0;
    for (int i = 0; i < int(ceil(count)); ++i) {
        uint salt = mx_gabor_mix(uint(seed) * 0x9e3779b1u + uint(i) * 0x85ebca6bu, 0xc2b2ae35u);
        vec4 octave = mx_gabor_fractal_octave(x, y, z, solid, salt, basis == 1 ? 1 : 0);
        float weight = amplitude * min(count - float(i), 1.0);
        power += weight * weight;
        amplitude *= gain;
        float noise = octave.x;
        float factor = weight;
        if (shape > 0) { // 1.6588964 is 1/sqrt(1 - 2/pi)
            factor = (shape == 1) == (noise >= 0.0) ? 1.6588964 * weight : -1.6588964 * weight;
            noise = noise - (noise >= 0.0 ? 0.79788456 : -0.79788456); // sqrt(2/pi)
        }
        value += factor * noise;
        slope_x += factor * (octave.y * along_a + octave.z * along_b + octave.w * along_c);
        if (solid == 0) {
            slope_y += factor * (octave.z * along_a - octave.y * along_b);
            float turned = a * along_a - b * along_b;
            along_b = b * along_a + a * along_b;
            along_a = turned;
            float moved = a * x - b * y + 0.382;
            y = b * x + a * y + 0.731;
            x = moved;
        } else {
            slope_y += factor * (octave.y * along_c + octave.z * along_a + octave.w * along_b);
            slope_z += factor * (octave.y * along_b + octave.z * along_c + octave.w * along_a);
            float turned_a = a * along_a + b * along_b + c * along_c;
            float turned_b = a * along_b + b * along_c + c * along_a;
            along_c = a * along_c + b * along_a + c * along_b;
            along_a = turned_a;
            along_b = turned_b;
            float moved_x = a * x + b * y + c * z + 0.382;
            float moved_y = a * y + b * z + c * x + 0.731;
            z = a * z + b * x + c * y + 0.545;
            x = moved_x;
            y = moved_y;
        }
    }
    float scale = 1.0 / sqrt(max(power, 1.0e-30));
    return vec4(scale * value, scale * slope_x, scale * slope_y, scale * slope_z);
}

// gabor_lattice_3d.glsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.glsl; every name that it adds begins with gabor_ or Gabor.
//
//     float n = gabor_noise_3d(p, 2.0, vec3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
//
// Functions to call, at the end of the file:
//     gabor_noise_3d, gabor_noise_3d_isotropic                 solid noise along one direction, or along all
//     gabor_noise_3d_gradient, _complex, _four                 with its gradient or quadrature; four independent ones
//     gabor_noise_3d_tiled, _animated                          with exact periods in space, and in time
//     gabor_noise_surface, gabor_noise_surface_isotropic       waves that lie in the tangent plane
//     gabor_noise_3d_filtered                                  averaged over a pixel
//     gabor_place_3d, gabor_wave_3d, gabor_field_3d, gabor_value_3d, gabor_isotropic_3d, gabor_surface_3d,
//     gabor_surface_isotropic_3d                               all of it, by integer cell and offset and for a pixel
//
// As in the plane, the nodes c of a cubic lattice, R = 3/2 to the kernel radius, have independent normal amplitudes A,
// and each sends out a wave under a product of Hann windows h(x) = (1 + cos pi x) / 2 that ends one kernel radius away:
//
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
//
// The nearest node and its neighbours, 27, reach a point. Whatever the wave vector F is, the variance is 1 at every
// place: so F may follow a surface, which sees the frequency asked for and no trace of the lattice. Several directions
// are a sum of independent noises, which makes everything, gradients and pairs of places too, jointly normal.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_GLSL
#define GABOR_LATTICE_3D_GLSL

#ifndef GABOR_LATTICE_GLSL
#error "Include gabor_lattice.glsl before gabor_lattice_3d.glsl"
#endif
#if GABOR_TAPS != 3
#error "gabor_lattice_3d.glsl needs GABOR_TAPS 3"
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace. And what a pixel covers there.
struct GaborPlace3d {
    ivec3 cell;
    vec3 local;
    vec3 radius;
    ivec3 period;
    bool animated;
    float time;
    bool filtered; // whether to average over the pixel: see gabor_noise_3d_filtered
    vec3 dx;
    vec3 dy;
};

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField3d {
    vec2 value;
    vec2 slope_x;
    vec2 slope_y;
    vec2 slope_z;
};

// ---- The nodes around a place --------------------------------------------------------------------------------------

// Complex numbers, three and three times three.
struct GaborVector {
    vec3 real;
    vec3 imaginary;
};

struct GaborMatrix {
    mat3 real;
    mat3 imaginary;
};

GaborMatrix gabor_impl_matrix(GaborVector a, GaborVector b, GaborVector c)
{
    return GaborMatrix(mat3(a.real, b.real, c.real), mat3(a.imaginary, b.imaginary, c.imaginary));
}

GaborVector gabor_impl_column(GaborMatrix m, int i, vec2 factor)
{
    return GaborVector(factor.x * m.real[i] - factor.y * m.imaginary[i], factor.x * m.imaginary[i] + factor.y * m.real[i]);
}

// Each column's sum with three complex factors.
GaborVector gabor_impl_sums(vec3 window, GaborVector wave, GaborMatrix m)
{
    vec3 real = window * wave.real;
    vec3 imaginary = window * wave.imaginary;
    return GaborVector(real * m.real - imaginary * m.imaginary, real * m.imaginary + imaginary * m.real);
}

vec2 gabor_impl_sum(vec3 window, GaborVector wave, GaborVector v, vec2 factor)
{
    vec3 real = window * wave.real;
    vec3 imaginary = window * wave.imaginary;
    return gabor_impl_product(factor, vec2(dot(real, v.real) - dot(imaginary, v.imaginary),
                                           dot(real, v.imaginary) + dot(imaginary, v.real)));
}

// The three lines of nodes along an axis.
struct GaborLines {
    uvec4 word;
    vec3 window;
    vec3 slope;
    GaborVector wave; // relative to the middle node's
    float offset;     // of the place from that node, in node spacings
};

GaborLines gabor_impl_lines(int first, float offset, int period, uint salt, float turns)
{
    GaborWindows windows = gabor_impl_windows(offset);
    vec4 cosines;
    vec4 sines;
    gabor_impl_node_waves(gabor_impl_wave(turns), cosines, sines);
    return GaborLines(gabor_impl_line_words(first, period, salt), windows.value.xyz, windows.slope.xyz,
                      GaborVector(cosines.xyz, sines.xyz), offset);
}

// The amplitude of a node. `channel` is 0, or that of another, independent noise.
vec2 gabor_impl_amplitude_3d(uint word, GaborPlace3d place, int channel)
{
    for (int i = 0; i < channel; ++i)
        word = gabor_impl_next_word(word);
    vec2 amplitude = gabor_impl_amplitude(word);
    if (place.animated) {
        uint second = gabor_impl_next_word(word);
        vec2 time = gabor_impl_wave(place.time);
        amplitude = 0.70710678 * (amplitude + time.x * gabor_impl_amplitude(second)
                                  + time.y * gabor_impl_amplitude(gabor_impl_next_word(second)));
    }
    return amplitude;
}

// A row of nodes: its word, made of those of a row and a slice, is odd and of 24 bits as theirs are.
GaborVector gabor_impl_row_3d(uvec4 columns, uint lines, GaborPlace3d place, int channel)
{
    uint row = (lines >> 8u) | 0x800001u;
    vec2 a = gabor_impl_amplitude_3d(gabor_impl_node_word(columns.x, row), place, channel);
    vec2 b = gabor_impl_amplitude_3d(gabor_impl_node_word(columns.y, row), place, channel);
    vec2 c = gabor_impl_amplitude_3d(gabor_impl_node_word(columns.z, row), place, channel);
    return GaborVector(vec3(a.x, b.x, c.x), vec3(a.y, b.y, c.y));
}

GaborMatrix gabor_impl_slice_3d(uvec4 columns, uvec4 rows, uint slice, GaborPlace3d place, int channel)
{
    return gabor_impl_matrix(gabor_impl_row_3d(columns, rows.x * slice, place, channel),
                             gabor_impl_row_3d(columns, rows.y * slice, place, channel),
                             gabor_impl_row_3d(columns, rows.z * slice, place, channel));
}

// All that reach a place: the lines, and the amplitudes where they meet, slice by slice, a column for each row.
struct GaborNodes3d {
    GaborLines x;
    GaborLines y;
    GaborLines z;
    vec2 base; // K times the wave at the middle node: E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1
    GaborMatrix a;
    GaborMatrix b;
    GaborMatrix c;
};

GaborNodes3d gabor_impl_nodes_3d(GaborPlace3d place, vec3 wave, uint seed, int channel)
{
    vec3 first = floor(place.local - GABOR_RADIUS) + 1.0;
    vec3 offset = place.local - first - 1.0;
    ivec3 node = place.cell + ivec3(first);
    vec3 turns = wave / place.radius;
    uint salt = gabor_impl_salt(seed);
    GaborNodes3d n;
    n.x = gabor_impl_lines(node.x, offset.x, place.period.x, salt, turns.x);
    n.y = gabor_impl_lines(node.y, offset.y, place.period.y, salt ^ 0x5bd1e995u, turns.y);
    n.z = gabor_impl_lines(node.z, offset.z, place.period.z, salt ^ 0x27d4eb2fu, turns.z);
    float scale = inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    n.base = scale * gabor_impl_wave(dot(turns, offset));
    n.a = gabor_impl_slice_3d(n.x.word, n.y.word, n.z.word.x, place, channel);
    n.b = gabor_impl_slice_3d(n.x.word, n.y.word, n.z.word.y, place, channel);
    n.c = gabor_impl_slice_3d(n.x.word, n.y.word, n.z.word.z, place, channel);
    return n;
}

GaborField3d gabor_impl_field_3d(GaborPlace3d place, vec3 wave, uint seed, int channel)
{
    GaborNodes3d n = gabor_impl_nodes_3d(place, wave, seed, channel);
    GaborLines x = n.x;
    GaborLines y = n.y;
    GaborLines z = n.z;
    GaborMatrix sums = gabor_impl_matrix(gabor_impl_sums(x.window, x.wave, n.a), gabor_impl_sums(x.window, x.wave, n.b),
                                         gabor_impl_sums(x.window, x.wave, n.c));
    GaborMatrix slopes = gabor_impl_matrix(gabor_impl_sums(x.slope, x.wave, n.a), gabor_impl_sums(x.slope, x.wave, n.b),
                                           gabor_impl_sums(x.slope, x.wave, n.c));
    GaborVector values = gabor_impl_sums(y.window, y.wave, sums);
    vec2 value = gabor_impl_sum(z.window, z.wave, values, n.base);
    vec2 slope_x = gabor_impl_sum(z.window, z.wave, gabor_impl_sums(y.window, y.wave, slopes), n.base);
    vec2 slope_y = gabor_impl_sum(z.window, z.wave, gabor_impl_sums(y.slope, y.wave, sums), n.base);
    vec2 slope_z = gabor_impl_sum(z.slope, z.wave, values, n.base);
    vec2 turned = 6.2831853 * vec2(-value.y, value.x);
    vec3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d(value, stretch.x * slope_x + wave.x * turned, stretch.y * slope_y + wave.y * turned,
                        stretch.z * slope_z + wave.z * turned);
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// From what an axis' three nodes have, the matrix' columns, to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4,
// by a Fourier transform of three points, turned to the place. Within half a
// deviation of the filter from its window's end a node fades, so that nothing jumps. The result is transposed.
GaborMatrix gabor_impl_waves(GaborMatrix m, GaborLines lines, float deviation)
{
    vec3 to_end = 1.0 - abs(lines.offset + vec3(1.0, 0.0, -1.0)) / GABOR_RADIUS;
    vec3 reach = clamp(to_end / max(0.5 * deviation, 1.0e-6), 0.0, 1.0);
    reach *= reach * (3.0 - 2.0 * reach);
    GaborVector a = gabor_impl_column(m, 0, reach.x * vec2(lines.wave.real.x, lines.wave.imaginary.x));
    GaborVector b = gabor_impl_column(m, 1, vec2(reach.y, 0.0));
    GaborVector c = gabor_impl_column(m, 2, reach.z * vec2(lines.wave.real.z, lines.wave.imaginary.z));
    vec3 even_real = 0.25 * b.real - 0.125 * (a.real + c.real);
    vec3 even_imaginary = 0.25 * b.imaginary - 0.125 * (a.imaginary + c.imaginary);
    vec3 odd_real = 0.21650635 * (c.imaginary - a.imaginary);
    vec3 odd_imaginary = 0.21650635 * (a.real - c.real);
    m.real = mat3(even_real - odd_real, 0.5 * (a.real + b.real + c.real), even_real + odd_real);
    m.imaginary = mat3(even_imaginary - odd_imaginary, 0.5 * (a.imaginary + b.imaginary + c.imaginary),
                       even_imaginary + odd_imaginary);
    vec2 turn = gabor_impl_wave(0.5 * lines.offset / GABOR_RADIUS);
    m = gabor_impl_matrix(gabor_impl_column(m, 0, vec2(turn.x, -turn.y)), gabor_impl_column(m, 1, vec2(1.0, 0.0)),
                          gabor_impl_column(m, 2, turn));
    return GaborMatrix(transpose(m.real), transpose(m.imaginary));
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: (det(1 + S^2))^(-1/4).
vec2 gabor_impl_filtered_3d(GaborPlace3d place, vec3 wave, uint seed)
{
    vec3 dx = clamp(place.dx, -1.0e6, 1.0e6);
    vec3 dy = clamp(place.dy, -1.0e6, 1.0e6);
    vec3 stretch = place.radius / GABOR_RADIUS;
    vec3 deviation = 0.5 * stretch * sqrt(dx * dx + dy * dy);
    GaborNodes3d n = gabor_impl_nodes_3d(place, wave, seed, 0);
    n.a = gabor_impl_waves(gabor_impl_waves(n.a, n.y, deviation.y), n.x, deviation.x);
    n.b = gabor_impl_waves(gabor_impl_waves(n.b, n.y, deviation.y), n.x, deviation.x);
    n.c = gabor_impl_waves(gabor_impl_waves(n.c, n.y, deviation.y), n.x, deviation.x);
    vec2 one = vec2(1.0, 0.0);
    vec2 sum = vec2(0.0);
    float kept = 0.0;
    for (int b = 0; b < 3; ++b) {
        GaborMatrix m = gabor_impl_matrix(gabor_impl_column(n.a, b, one), gabor_impl_column(n.b, b, one),
                                          gabor_impl_column(n.c, b, one));
        m = gabor_impl_waves(m, n.z, deviation.z);
        for (int a = 0; a < 3; ++a) {
            for (int c = 0; c < 3; ++c) {
                vec3 aside = vec3(float(a - 1), float(b - 1), float(c - 1));
                vec3 k = wave + 0.5 * stretch * aside;
                float left = exp(-4.934802 * (dot(k, dx) * dot(k, dx) + dot(k, dy) * dot(k, dy)));
                sum += left * vec2(m.real[a][c], m.imaginary[a][c]);
                kept += left * left * exp2(-2.0 * dot(aside, aside));
            }
        }
    }
    vec3 area = cross(dx, dy);
    float trace = dot(dx, dx) + dot(dy, dy);
    float fade = inversesqrt(sqrt(max(1.0 + 0.0625 * trace * trace + dot(area, area) * (dot(area, area) / 256.0 - 0.125), 1.0)));
    return vec2(fade * gabor_impl_product(sum, n.base).y, 1.0 - fade * fade * (8.0 / 27.0) * kept);
}

// ---- By place: the noise, averaged over the pixel if `filtered`, and the variance that this removes -----------------

vec2 gabor_value_3d(GaborPlace3d place, vec3 wave, uint seed)
{
    if (place.filtered)
        return gabor_impl_filtered_3d(place, wave, seed);
    return vec2(gabor_impl_field_3d(place, wave, seed, 0).value.y, 0.0);
}

// The noise of index `index` in a sum of independent ones, with that power.
vec2 gabor_impl_term(GaborPlace3d place, vec3 wave, uint seed, int index, float power)
{
    return vec2(sqrt(power), power) * gabor_value_3d(place, wave, gabor_impl_mix(seed + uint(index) * 0x85ebca6bu, 0x9e3779b1u));
}

// A vector brought to length 1, or 0 where its largest coordinate is not within [10^-30, 10^30].
vec3 gabor_impl_unit(vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    return largest >= 1.0e-30 && largest <= 1.0e30 ? normalize(v / largest) : vec3(0.0);
}

vec3 gabor_wave_3d(float frequency, vec3 direction)
{
    return min(abs(frequency), 1.0e6) * gabor_impl_unit(direction);
}

// Directions evenly along a spiral over half the sphere. Their number is real, the last one has what is left of the
// power: so all of it is continuous in frequency.
vec2 gabor_isotropic_3d(GaborPlace3d place, float frequency, uint seed)
{
    float count = 8.0 + 8.0 * min(frequency * frequency, 64.0);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < int(ceil(count)); ++i) {
        float share = min(count - float(i), 1.0);
        float z = (float(i) + 0.5 * share) / count;
        vec3 direction = vec3(sqrt(1.0 - z * z) * gabor_impl_wave(0.61803399 * float(i)), z);
        sum += gabor_impl_term(place, gabor_wave_3d(frequency, direction), seed, i, share / count);
    }
    return sum;
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
vec2 gabor_surface_3d(GaborPlace3d place, vec3 normal, float frequency, vec3 direction, uint seed)
{
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    vec3 other = cross(direction, abs(direction.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float share = smoothstep(0.0625, 0.25, dot(direction, direction));
    float power = share * share / (share * share + (1.0 - share) * (1.0 - share));
    vec2 sum = vec2(0.0);
    if (share > 0.0)
        sum += gabor_impl_term(place, gabor_wave_3d(frequency, direction), seed, 0, power);
    if (share < 1.0)
        sum += gabor_impl_term(place, gabor_wave_3d(frequency, other), seed, 1, 1.0 - power);
    return sum;
}

// Directions evenly over half a turn from that of the circle around `axis` on which the normal lies.
vec2 gabor_impl_tangents(GaborPlace3d place, vec3 normal, vec3 axis, float frequency, uint seed, int first, float power)
{
    float count = 2.0 + 4.5 * min(abs(frequency), 32.0);
    vec3 along = gabor_impl_unit(cross(axis, normal));
    vec2 sum = vec2(0.0);
    for (int i = 0; i < int(ceil(count)) && power > 0.0; ++i) {
        float share = min(count - float(i), 1.0);
        vec2 turn = gabor_impl_wave(0.5 * (float(i) + 0.5 * share) / count);
        vec3 direction = turn.x * along + turn.y * cross(normal, along);
        sum += gabor_impl_term(place, gabor_wave_3d(frequency, direction), seed, first + i, power * share / count);
    }
    return sum;
}

// Around z, and near its poles around x.
vec2 gabor_surface_isotropic_3d(GaborPlace3d place, vec3 normal, float frequency, uint seed)
{
    normal = gabor_impl_unit(normal);
    float share = smoothstep(0.25, 0.5, dot(normal.xy, normal.xy));
    float power = share * share / (share * share + (1.0 - share) * (1.0 - share));
    return gabor_impl_tangents(place, normal, vec3(0.0, 0.0, 1.0), frequency, seed, 0, power)
         + gabor_impl_tangents(place, normal, vec3(1.0, 0.0, 0.0), frequency, seed, 256, 1.0 - power);
}

GaborField3d gabor_field_3d(GaborPlace3d place, vec3 wave, uint seed)
{
    return gabor_impl_field_3d(place, wave, seed, 0);
}

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
{
    return GaborPlace3d(cell, local, vec3(GABOR_RADIUS), ivec3(0), false, 0.0, false, vec3(0.0), vec3(0.0));
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R; at 10^5 a float steps by 0.008
//   frequency  cycles per kernel radius; its magnitude is used, up to 10^6
//   direction  of the wave vector, of any length; with 0, or beyond 10^30, its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Where frequency and direction vary continuously so does the noise: each wave turns about its own node. A slope of
// theirs adds to that of the noise.
float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed)
{
    return gabor_value_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), gabor_wave_3d(frequency, direction), seed).x;
}

// The noise at p and its analytic gradient: (noise, d/dx, d/dy, d/dz), derivatives per kernel radius, continuous
// everywhere. For bump mapping take away the part along the normal.
vec4 gabor_noise_3d_gradient(vec3 p, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    GaborField3d field = gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed);
    return vec4(field.value.y, field.slope_x.y, field.slope_y.y, field.slope_z.y);
}

// The noise at p with its quadrature, for gabor_phasor: see gabor_noise_complex.
vec2 gabor_noise_3d_complex(vec3 p, float frequency, vec3 direction, uint seed)
{
    return gabor_field_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), gabor_wave_3d(frequency, direction), seed).value;
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
vec4 gabor_noise_3d_four(vec3 p, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    vec3 wave = gabor_wave_3d(frequency, direction);
    return vec4(gabor_impl_field_3d(place, wave, seed, 0).value.y, gabor_impl_field_3d(place, wave, seed, 1).value.y,
                gabor_impl_field_3d(place, wave, seed, 2).value.y, gabor_impl_field_3d(place, wave, seed, 3).value.y);
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
float gabor_noise_3d_tiled(vec3 p, vec3 period, float frequency, vec3 direction, uint seed)
{
    period = max(period, vec3(0.0009765625));
    vec3 nodes = max(floor(period * GABOR_RADIUS + 0.5), vec3(3.0));
    GaborPlace3d place = gabor_place_3d(ivec3(0), (p - floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = ivec3(nodes);
    return gabor_value_3d(place, gabor_wave_3d(frequency, direction), seed).x;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
float gabor_noise_3d_animated(vec3 p, float time, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    place.animated = true;
    place.time = time;
    return gabor_value_3d(place, gabor_wave_3d(frequency, direction), seed).x;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel is
// a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
vec2 gabor_noise_3d_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    place.filtered = true;
    place.dx = dx;
    place.dy = dy;
    return gabor_value_3d(place, gabor_wave_3d(frequency, direction), seed);
}

// Solid noise along all directions, a sum of 8 + 8 F^2 of them.
float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed)
{
    return gabor_isotropic_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, seed).x;
}

// Noise on a surface at its point p, its waves along the projection of a direction, with the law of gabor_noise_3d.
//   normal  of the surface at p, of any length but 0
// The frequency is exact where the surface is flat; where it is curved with radius r, the waves of a kernel bend.
float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed)
{
    return gabor_surface_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).x;
}

// Noise on a surface along all directions of its tangent plane alike: a sum of 2 + 4.5 F, of twice as many between two axes.
float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed)
{
    return gabor_surface_isotropic_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).x;
}

#endif // GABOR_LATTICE_3D_GLSL

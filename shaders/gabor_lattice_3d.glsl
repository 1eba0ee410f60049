// gabor_lattice_3d.glsl: exactly normalized Gabor noise in space, and on surfaces without parametrization.
//
// Paste or include this file after gabor_lattice.glsl, in the same dialects; every name it adds begins with gabor_,
// Gabor or GABOR_.
//
//     float n = gabor_noise_3d(p, 2.0, vec3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
//
// Functions to call, at the end of the file; those with _filtered average over a pixel:
//     gabor_noise_3d, _filtered                           solid noise along one direction
//     gabor_noise_3d_gradient, _complex, _four            with its gradient, with its quadrature, four independent ones
//     gabor_noise_3d_tiled, _animated                     with exact periods in space, and in time
//     gabor_noise_3d_isotropic, _isotropic_filtered       along all directions alike
//     gabor_noise_surface, _filtered                      waves that lie in the tangent plane
//     gabor_noise_surface_isotropic, _isotropic_filtered  along all directions of the tangent plane
//     gabor_place_3d, gabor_wave_3d, gabor_field_3d, gabor_filtered_3d, ...    all of it by integer cell and offset
//
// As in the plane, the nodes c of a cubic lattice, R = 3/2 to the kernel radius, have independent normal complex
// amplitudes A, and each sends out a wave under a product of Hann windows h(x) = (1 + cos pi x) / 2 that ends one kernel
// radius from it. The nearest node and its neighbours, 27, reach a point:
//
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
//
// The variance is 1 at every place for every wave vector F. So F may follow a surface, which then sees the frequency
// asked for and no trace of the lattice. Several directions are summed as independent noises, with weights whose squares
// sum to 1: the noise, its gradient, its quadrature and any of its values together are jointly normal.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_GLSL
#define GABOR_LATTICE_3D_GLSL

#ifndef GABOR_LATTICE_GLSL
#error "Include gabor_lattice.glsl before gabor_lattice_3d.glsl, which uses its lattice"
#endif
#if GABOR_TAPS != 3
#error "gabor_lattice_3d.glsl needs GABOR_TAPS 3"
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    ivec3 cell;
    vec3 local;
    vec3 radius;
    ivec3 period;
    bool animated;
    float time;
};

// What a pixel covers of space, if the noise is to be averaged over it: see gabor_noise_3d_filtered.
struct GaborFootprint3d {
    bool filtered;
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

GaborVector gabor_impl_column(GaborMatrix m, int i)
{
    return GaborVector(m.real[i], m.imaginary[i]);
}

GaborVector gabor_impl_scaled(GaborVector v, vec2 factor)
{
    return GaborVector(factor.x * v.real - factor.y * v.imaginary, factor.x * v.imaginary + factor.y * v.real);
}

// Each column's sum with the factors of an axis' three nodes.
GaborVector gabor_impl_sums(vec4 real, vec4 imaginary, GaborMatrix m)
{
    return GaborVector(real.xyz * m.real - imaginary.xyz * m.imaginary, real.xyz * m.imaginary + imaginary.xyz * m.real);
}

vec2 gabor_impl_sum(vec4 real, vec4 imaginary, GaborVector v)
{
    return vec2(dot(real.xyz, v.real) - dot(imaginary.xyz, v.imaginary),
                dot(real.xyz, v.imaginary) + dot(imaginary.xyz, v.real));
}

// The lines of nodes along each axis, and the amplitudes where they meet, slice by slice along z: a column for each row.
struct GaborNodes3d {
    GaborAxis x;
    GaborAxis y;
    GaborAxis z;
    vec2 step_x; // e^(2 pi i F.x / R), what the wave turns from one node to the next along x
    vec2 step_y; // along y
    vec2 step_z; // along z
    vec3 offset; // from the middle node, in node spacings
    vec2 base;   // K times the wave there, with which E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1
    GaborMatrix first;
    GaborMatrix second;
    GaborMatrix third;
};

// The amplitude of a node given the xor of its lines' words: `channel` is 0, or that of an independent noise.
vec2 gabor_impl_amplitude_3d(uint lines, GaborPlace3d place, int channel)
{
    uint word = gabor_impl_node_word(lines);
    for (int i = 0; i < channel; ++i)
        word = gabor_impl_next_word(word);
    return place.animated ? gabor_impl_amplitude_at(word, gabor_impl_wave(place.time)) : gabor_impl_amplitude(word);
}

GaborVector gabor_impl_row_3d(uvec4 columns, uint row, GaborPlace3d place, int channel)
{
    vec2 a = gabor_impl_amplitude_3d(columns.x ^ row, place, channel);
    vec2 b = gabor_impl_amplitude_3d(columns.y ^ row, place, channel);
    vec2 c = gabor_impl_amplitude_3d(columns.z ^ row, place, channel);
    return GaborVector(vec3(a.x, b.x, c.x), vec3(a.y, b.y, c.y));
}

GaborMatrix gabor_impl_slice_3d(uvec4 columns, uvec4 rows, uint slice, GaborPlace3d place, int channel)
{
    return gabor_impl_matrix(gabor_impl_row_3d(columns, rows.x ^ slice, place, channel),
                             gabor_impl_row_3d(columns, rows.y ^ slice, place, channel),
                             gabor_impl_row_3d(columns, rows.z ^ slice, place, channel));
}

GaborNodes3d gabor_impl_nodes_3d(GaborPlace3d place, vec3 wave, uint seed, int channel)
{
    vec3 corner = floor(place.local - GABOR_RADIUS) + 1.0;
    vec3 x = place.local - corner;
    ivec3 node = place.cell + ivec3(corner);
    vec3 turns = wave / place.radius;
    GaborNodes3d nodes;
    nodes.step_x = gabor_impl_wave(turns.x);
    nodes.x = gabor_impl_axis(node.x, x.x, place.period.x, gabor_impl_salt(seed, 0u), nodes.step_x);
    nodes.step_y = gabor_impl_wave(turns.y);
    nodes.y = gabor_impl_axis(node.y, x.y, place.period.y, gabor_impl_salt(seed, 1u), nodes.step_y);
    nodes.step_z = gabor_impl_wave(turns.z);
    nodes.z = gabor_impl_axis(node.z, x.z, place.period.z, gabor_impl_salt(seed, 2u), nodes.step_z);
    nodes.offset = x - 1.0;
    float scale = inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    nodes.base = scale * gabor_impl_wave(dot(turns, nodes.offset));
    nodes.first = gabor_impl_slice_3d(nodes.x.word, nodes.y.word, nodes.z.word.x, place, channel);
    nodes.second = gabor_impl_slice_3d(nodes.x.word, nodes.y.word, nodes.z.word.y, place, channel);
    nodes.third = gabor_impl_slice_3d(nodes.x.word, nodes.y.word, nodes.z.word.z, place, channel);
    return nodes;
}

// The field of one channel.
GaborField3d gabor_impl_field_3d(GaborPlace3d place, vec3 wave, uint seed, int channel)
{
    GaborNodes3d n = gabor_impl_nodes_3d(place, wave, seed, channel);
    GaborMatrix sums = gabor_impl_matrix(gabor_impl_sums(n.x.real, n.x.imaginary, n.first),
                                         gabor_impl_sums(n.x.real, n.x.imaginary, n.second),
                                         gabor_impl_sums(n.x.real, n.x.imaginary, n.third));
    GaborMatrix slopes = gabor_impl_matrix(gabor_impl_sums(n.x.slope_real, n.x.slope_imaginary, n.first),
                                           gabor_impl_sums(n.x.slope_real, n.x.slope_imaginary, n.second),
                                           gabor_impl_sums(n.x.slope_real, n.x.slope_imaginary, n.third));
    GaborVector rows = gabor_impl_sums(n.y.real, n.y.imaginary, sums);
    GaborVector slopes_x = gabor_impl_sums(n.y.real, n.y.imaginary, slopes);
    GaborVector slopes_y = gabor_impl_sums(n.y.slope_real, n.y.slope_imaginary, sums);
    vec2 value = gabor_impl_product(n.base, gabor_impl_sum(n.z.real, n.z.imaginary, rows));
    vec2 slope_x = gabor_impl_product(n.base, gabor_impl_sum(n.z.real, n.z.imaginary, slopes_x));
    vec2 slope_y = gabor_impl_product(n.base, gabor_impl_sum(n.z.real, n.z.imaginary, slopes_y));
    vec2 slope_z = gabor_impl_product(n.base, gabor_impl_sum(n.z.slope_real, n.z.slope_imaginary, rows));
    vec2 turned = 6.2831853 * vec2(-value.y, value.x);
    vec3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d(value, stretch.x * slope_x + wave.x * turned, stretch.y * slope_y + wave.y * turned,
                        stretch.z * slope_z + wave.z * turned);
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// From what an axis' three nodes have, the matrix' columns, to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4,
// so a is turned by a third of a turn from node to node. `x` is the offset from the middle node, in node spacings.
// Within half a deviation of the filter from its window's end a node fades: nothing jumps. The result is transposed.
GaborMatrix gabor_impl_waves(float x, vec2 step, float deviation, GaborMatrix m)
{
    vec3 to_end = 1.0 - abs(vec3(x + 1.0, x, x - 1.0)) / GABOR_RADIUS;
    vec3 reach = clamp(to_end / max(0.5 * deviation, 1.0e-6), 0.0, 1.0);
    reach *= reach * (3.0 - 2.0 * reach);
    GaborVector a = gabor_impl_scaled(gabor_impl_column(m, 0), reach.x * step);
    GaborVector b = gabor_impl_scaled(gabor_impl_column(m, 1), vec2(reach.y, 0.0));
    GaborVector c = gabor_impl_scaled(gabor_impl_column(m, 2), reach.z * vec2(step.x, -step.y));
    GaborVector both = GaborVector(a.real + c.real, a.imaginary + c.imaginary);
    GaborVector even = GaborVector(0.25 * b.real - 0.125 * both.real, 0.25 * b.imaginary - 0.125 * both.imaginary);
    GaborVector odd = GaborVector(0.21650635 * (c.imaginary - a.imaginary), 0.21650635 * (a.real - c.real));
    GaborVector low = GaborVector(even.real - odd.real, even.imaginary - odd.imaginary);
    GaborVector high = GaborVector(even.real + odd.real, even.imaginary + odd.imaginary);
    vec2 turn = gabor_impl_wave(x / (2.0 * GABOR_RADIUS));
    m = gabor_impl_matrix(gabor_impl_scaled(low, vec2(turn.x, -turn.y)),
                          GaborVector(0.5 * (b.real + both.real), 0.5 * (b.imaginary + both.imaginary)),
                          gabor_impl_scaled(high, turn));
    return GaborMatrix(transpose(m.real), transpose(m.imaginary));
}

// The noise at a place averaged over a footprint, and the variance that this removes: see gabor_noise_3d_filtered.
// Between nodes the field is a sum of 27 waves, with wave vectors k = F + (a, b, c) / 2. A normal footprint of covariance
// S leaves exp(-2 pi^2 k.S k) of each. The middle one has (2/3)^3 of the variance, along each axis its neighbours 1/4 of
// what it has.
vec2 gabor_filtered_3d(GaborPlace3d place, vec3 wave, vec3 dx, vec3 dy, uint seed)
{
    dx = clamp(dx, -1.0e6, 1.0e6);
    dy = clamp(dy, -1.0e6, 1.0e6);
    GaborNodes3d n = gabor_impl_nodes_3d(place, wave, seed, 0);
    vec3 stretch = place.radius / GABOR_RADIUS;
    vec3 deviation = 0.5 * stretch * sqrt(dx * dx + dy * dy);
    n.first = gabor_impl_waves(n.offset.y, n.step_y, deviation.y, n.first);
    n.second = gabor_impl_waves(n.offset.y, n.step_y, deviation.y, n.second);
    n.third = gabor_impl_waves(n.offset.y, n.step_y, deviation.y, n.third);
    n.first = gabor_impl_waves(n.offset.x, n.step_x, deviation.x, n.first);
    n.second = gabor_impl_waves(n.offset.x, n.step_x, deviation.x, n.second);
    n.third = gabor_impl_waves(n.offset.x, n.step_x, deviation.x, n.third);
    vec2 sum = vec2(0.0);
    float kept = 0.0;
    for (int b = 0; b < 3; ++b) {
        GaborMatrix m = gabor_impl_matrix(gabor_impl_column(n.first, b), gabor_impl_column(n.second, b),
                                          gabor_impl_column(n.third, b));
        m = gabor_impl_waves(n.offset.z, n.step_z, deviation.z, m);
        for (int a = 0; a < 3; ++a) {
            for (int c = 0; c < 3; ++c) {
                vec3 aside = vec3(float(a - 1), float(b - 1), float(c - 1));
                vec3 k = wave + 0.5 * stretch * aside;
                vec2 along = vec2(dot(k, dx), dot(k, dy));
                float left = exp(-4.934802 * dot(along, along));
                sum += left * vec2(m.real[a][c], m.imaginary[a][c]);
                kept += left * left * exp2(-2.0 * dot(aside, aside));
            }
        }
    }
    // Over more than a kernel radius even what is left of frequency 0 averages out: (det(1 + S^2))^(-1/4).
    vec3 area = cross(dx, dy);
    float trace = 0.25 * (dot(dx, dx) + dot(dy, dy));
    float determinant = 0.0625 * dot(area, area);
    float fade = inversesqrt(sqrt(max(1.0 + trace * trace + determinant * (determinant - 2.0), 1.0)));
    return vec2(fade * gabor_impl_product(sum, n.base).y, 1.0 - fade * fade * (8.0 / 27.0) * kept);
}

// ---- Sums of independent noises ------------------------------------------------------------------------------------

// One of them, by its index in the sum: with its variance removed, if there is a footprint.
vec2 gabor_impl_lobe_3d(GaborPlace3d place, vec3 wave, GaborFootprint3d footprint, uint seed, int index)
{
    seed = gabor_impl_mix(seed, uint(index));
    if (footprint.filtered)
        return gabor_filtered_3d(place, wave, footprint.dx, footprint.dy, seed);
    return vec2(gabor_impl_field_3d(place, wave, seed, 0).value.y, 0.0);
}

// A vector brought to length 1, or 0 where its largest coordinate is not within [10^-30, 10^30].
vec3 gabor_impl_unit(vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    return largest >= 1.0e-30 && largest <= 1.0e30 ? normalize(v / largest) : vec3(0.0);
}

// Directions evenly over the half sphere, along a spiral.
vec2 gabor_isotropic_3d(GaborPlace3d place, float frequency, GaborFootprint3d footprint, uint seed)
{
    frequency = min(abs(frequency), 1.0e6);
    int directions = 6 + int(8.0 * min(frequency * frequency, 64.0));
    vec2 sum = vec2(0.0);
    for (int i = 0; i < directions; ++i) {
        float height = (float(i) + 0.5) / float(directions);
        vec2 across = sqrt((1.0 - height) * (1.0 + height)) * gabor_impl_wave(0.61803399 * float(i));
        sum += gabor_impl_lobe_3d(place, frequency * vec3(across, height), footprint, seed, i);
    }
    return sum * vec2(inversesqrt(float(directions)), 1.0 / float(directions));
}

// Where the surface faces the direction, another one at right angles to it takes over.
vec2 gabor_surface(GaborPlace3d place, vec3 normal, float frequency, vec3 direction, GaborFootprint3d footprint, uint seed)
{
    frequency = min(abs(frequency), 1.0e6);
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    vec3 other = cross(direction, abs(direction.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float share = smoothstep(0.0625, 0.25, dot(direction, direction));
    vec2 weight = normalize(vec2(share, 1.0 - share));
    vec2 sum = vec2(0.0);
    if (weight.x > 0.0)
        sum += vec2(weight.x, weight.x * weight.x)
             * gabor_impl_lobe_3d(place, frequency * gabor_impl_unit(direction), footprint, seed, 0);
    if (weight.y > 0.0)
        sum += vec2(weight.y, weight.y * weight.y)
             * gabor_impl_lobe_3d(place, frequency * gabor_impl_unit(other), footprint, seed, 1);
    return sum;
}

// Directions evenly over half a turn in the tangent plane, from that of the parallels around the axis z, and near its
// poles from that of those around the axis x.
vec2 gabor_surface_isotropic(GaborPlace3d place, vec3 normal, float frequency, GaborFootprint3d footprint, uint seed)
{
    frequency = min(abs(frequency), 1.0e6);
    normal = gabor_impl_unit(normal);
    int directions = 2 + int(4.0 * min(frequency, 64.0));
    float share = smoothstep(0.25, 0.5, dot(normal.xy, normal.xy));
    vec2 weights = normalize(vec2(share, 1.0 - share));
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 2 * directions; ++i) {
        float weight = i < directions ? weights.x : weights.y;
        vec2 turn = gabor_impl_wave(0.5 * float(i) / float(directions));
        vec3 along = gabor_impl_unit(cross(i < directions ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
        vec3 wave = frequency * (turn.x * along + turn.y * cross(normal, along));
        if (weight > 0.0)
            sum += vec2(weight, weight * weight) * gabor_impl_lobe_3d(place, wave, footprint, seed, i);
    }
    return sum * vec2(inversesqrt(float(directions)), 1.0 / float(directions));
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
{
    return GaborPlace3d(cell, local, vec3(GABOR_RADIUS), ivec3(0), false, 0.0);
}

// The wave vector of a frequency and a direction, with the ranges of gabor_noise_3d.
vec3 gabor_wave_3d(float frequency, vec3 direction)
{
    return min(abs(frequency), 1.0e6) * gabor_impl_unit(direction);
}

// The noise at a place, by its wave vector, all of it.
GaborField3d gabor_field_3d(GaborPlace3d place, vec3 wave, uint seed)
{
    return gabor_impl_field_3d(place, wave, seed, 0);
}

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float steps
//              by 0.008.
//   frequency  cycles per kernel radius; its magnitude is used, up to 10^6
//   direction  of the wave vector, of any length; with 0, or beyond 10^30, its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Frequency and direction may vary from place to place: where they are continuous so is the noise, for each wave turns
// about its own node. A slope of theirs adds to that of the noise.
float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed)
{
    return gabor_field_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), gabor_wave_3d(frequency, direction), seed).value.y;
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
    vec3 radius = nodes / period;
    vec3 within = p - floor(p / period) * period;
    GaborPlace3d place = GaborPlace3d(ivec3(0), within * radius, radius, ivec3(nodes), false, 0.0);
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
float gabor_noise_3d_animated(vec3 p, float time, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    place.animated = true;
    place.time = time;
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The footprint is normal, with a standard deviation of half a pixel. In proportion to the noise the error is 0.2 % where
// pixels have a tenth of a radius, 2 % at a third, and at frequencies below 1 grows to 20 % at a radius.
vec2 gabor_noise_3d_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    return gabor_filtered_3d(place, gabor_wave_3d(frequency, direction), dx, dy, seed);
}

// Solid noise along all directions: a sum of 6 + 8 F^2 of them.
float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed)
{
    GaborFootprint3d none = GaborFootprint3d(false, vec3(0.0), vec3(0.0));
    return gabor_isotropic_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, none, seed).x;
}

// Noise on a surface at its point p, its waves along one direction, with the law of gabor_noise_3d.
//   normal     of the surface at p, of any length but 0
//   direction  any vector: the waves run along its projection to the tangent plane, which has no meaning where the
//              surface faces it; from 30 to 14 degrees around there waves at right angles take over.
// The frequency is exact where the surface is flat; where it is curved with radius r, the waves of a kernel bend, and
// frequencies spread by as much as 4/r.
float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed)
{
    GaborFootprint3d none = GaborFootprint3d(false, vec3(0.0), vec3(0.0));
    return gabor_surface(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, none, seed).x;
}

// Noise on a surface at its point p, along all directions of its tangent plane alike: a sum of 2 + 4 F, twice as many in
// between where parallels around two axes meet.
float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed)
{
    GaborFootprint3d none = GaborFootprint3d(false, vec3(0.0), vec3(0.0));
    return gabor_surface_isotropic(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, none, seed).x;
}

#endif // GABOR_LATTICE_3D_GLSL

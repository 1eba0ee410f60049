// gabor_lattice_3d.hlsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_spectrum.hlsl, which has the filter; every name that it adds begins with gabor_, Gabor or GABOR_: for HLSL, shader model 5.0 and up.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hlsl. Paste or include it after gabor_spectrum.hlsl.
//
//     float n = gabor_noise_3d(p, 2.0, float3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
// As in the plane, of the nodes c of a lattice, R = 3/2 to the kernel radius, the nearest and its neighbours, 27, reach
// a point with their waves under Hann's windows h, times independent normal amplitudes A:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// Whatever the wave vector F is, the variance is 1 at every place: so F may follow a surface, which sees the frequency
// asked for and no trace of the lattice. Several directions are a sum of independent noises, jointly normal like one.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_LATTICE_3D_HLSL
#define GABOR_LATTICE_3D_HLSL
#ifndef GABOR_SPECTRUM_HLSL
#error Include gabor_lattice.hlsl and gabor_spectrum.hlsl before gabor_lattice_3d.hlsl
#elif GABOR_TAPS != 3
#error gabor_lattice_3d.hlsl needs GABOR_TAPS 3
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    int3 cell;
    float3 local;
    float3 radius;
    int3 period;
    bool animated;
    float time;
    bool filtered; // whether to average over the pixel whose sides are dx and dy: see gabor_noise_3d_filtered
    float3 dx;
    float3 dy;
};

GaborPlace3d GaborPlace3d_of(int3 cell, float3 local, float3 radius, int3 period, bool animated, float time, bool filtered, float3 dx, float3 dy)
{
    GaborPlace3d made;
    made.cell = cell;
    made.local = local;
    made.radius = radius;
    made.period = period;
    made.animated = animated;
    made.time = time;
    made.filtered = filtered;
    made.dx = dx;
    made.dy = dy;
    return made;
}

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GaborPlace3d gabor_place_3d(int3 cell, float3 local) {
    return GaborPlace3d_of(cell, local, (float3)(GABOR_RADIUS), (int3)(0), false, 0.0, false, (float3)(0.0), (float3)(0.0));
}

// The noise and its quadrature, each with its gradient per kernel radius. Apart, so that compilers drop unused ones.
struct GaborField3d {
    float noise;
    float3 gradient;
    float quadrature;
    float3 quadrature_gradient;
    float removed; // variance that the average over the pixel takes away
};

GaborField3d GaborField3d_of(float noise, float3 gradient, float quadrature, float3 quadrature_gradient, float removed)
{
    GaborField3d made;
    made.noise = noise;
    made.gradient = gradient;
    made.quadrature = quadrature;
    made.quadrature_gradient = quadrature_gradient;
    made.removed = removed;
    return made;
}

// ---- The noise at a place ------------------------------------------------------------------------------------------

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
float3 gabor_impl_unit(float3 v) {
    v = clamp(v, -1.0e15, 1.0e15);
    return v * rsqrt(max(dot(v, v), 1.0e-30));
}

// Adds slice k of nodes: to `sum` the noise and, in zw, derivatives of windows along x, to `slopes` along y and z. The
// filter adds mixed derivatives, with its covariances yz, zx, xy.
void gabor_impl_add_slice(inout float4 sum, inout float4 slopes, GaborPlace3d place, GaborAxis x, GaborAxis y, GaborAxis z,
                          int k, float3 mixed) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    float4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, z.node[k].xy);
    slopes += float4(gabor_impl_product(slope.xy, z.node[k].xy), gabor_impl_product(slice.xy, z.node[k].zw));
    if (place.filtered)
        sum += float4(gabor_impl_product(mixed.x * slope.xy + mixed.y * slice.zw, z.node[k].zw)
                    + mixed.z * gabor_impl_product(slope.zw, z.node[k].xy), 0.0, 0.0);
}

// The noise of 27 nodes; filtered by three waves along each axis. E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1, and the
// derivative of a wave is 2 pi i F times it.
GaborField3d gabor_impl_sum_3d(GaborPlace3d place, float3 wave, GaborMatrix pixel, uint salt) {
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, GABOR_RADIUS);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                  GABOR_RADIUS);
    GaborAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                  GABOR_RADIUS);
    float2 turn = rsqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
              * gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    if (place.filtered) {
        float3 blurred = gabor_impl_symmetric_3d(pixel, wave);
        gabor_impl_filter(x, pixel.diagonal.x, blurred.x);
        gabor_impl_filter(y, pixel.diagonal.y, blurred.y);
        gabor_impl_filter(z, pixel.diagonal.z, blurred.z);
        turn *= exp(-19.739209 * dot(wave, blurred));
    }
    float4 sum = (float4)(0.0), slopes = (float4)(0.0);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 0, pixel.mixed);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 1, pixel.mixed);
    gabor_impl_add_slice(sum, slopes, place, x, y, z, 2, pixel.mixed);
    sum = float4(gabor_impl_product(sum.xy, turn), gabor_impl_product(sum.zw, turn));
    slopes = float4(gabor_impl_product(slopes.xy, turn), gabor_impl_product(slopes.zw, turn));
    return GaborField3d_of(sum.y, float3(sum.w, slopes.y, slopes.w) + 6.2831853 * sum.x * wave,
                        sum.x, float3(sum.z, slopes.x, slopes.z) - 6.2831853 * sum.y * wave, 0.0);
}

void gabor_impl_accumulate_3d(inout GaborField3d sum, GaborField3d field, float amplitude) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * field.quadrature_gradient;
}

// The share of its variance that a lobe keeps, of a pixel whose axes are at right angles: see gabor_impl_transmitted.
float gabor_impl_transmitted_3d(float3 wave, float3 major, float3 minor) {
    float2 d = 1.0 + 1.6449341 * float2(dot(major, major), dot(minor, minor));
    float2 k = float2(dot(wave, major), dot(wave, minor));
    return exp(-min(9.8696044 * dot(k * k, 1.0 / d), 80.0)) * rsqrt(d.x * d.y);
}

// The covariance of the place's pixel; beyond a deviation of 1/2 that at 1/2, at which noise has the amplitude that is
// left. And the share of its variance that the noise keeps.
GaborMatrix gabor_impl_pixel(GaborPlace3d place, float3 wave, float3 stretch, out float amplitude, out float transmitted) {
    float3 dx = clamp(place.dx, -1.0e6, 1.0e6) * stretch;
    float3 dy = clamp(place.dy, -1.0e6, 1.0e6) * stretch;
    float2 twice = float2(dot(dx, dx) - dot(dy, dy), 2.0 * dot(dx, dy)); // its axes are turned by half of that angle
    float cosine = twice.x / max(length(twice), 1.0e-30);
    float2 turn = sqrt(max(0.5 + float2(0.5, -0.5) * cosine, 0.0));
    if (twice.y < 0.0) turn.y = -turn.y;
    float3 major = turn.x * dx + turn.y * dy;
    float3 minor = turn.x * dy - turn.y * dx;
    transmitted = gabor_impl_transmitted_3d(wave, major, minor);
    major *= rsqrt(max(dot(major, major), 1.0));
    minor *= rsqrt(max(dot(minor, minor), 1.0));
    amplitude = sqrt(transmitted / gabor_impl_transmitted_3d(wave, major, minor));
    if (!(transmitted > 1.0e-10)) transmitted = 0.0; // or not a number
    return GaborMatrix_of(0.25 * (major * major + minor * minor),
                       0.25 * (major.yzx * major.zxy + minor.yzx * minor.zxy));
}

// With periods, whose nodes are not 1 / GABOR_RADIUS apart, everything counts in units of GABOR_RADIUS nodes.
GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, float3 direction, uint seed) {
    float3 stretch = place.radius / GABOR_RADIUS;
    float3 wave = min(abs(frequency), 1.0e6) * gabor_impl_unit(direction) / stretch;
    uint salt = gabor_impl_salt(seed);
    float amplitude = 1.0, transmitted = 1.0, wide = 0.0;
    GaborMatrix pixel = GaborMatrix_of((float3)(0.0), (float3)(0.0));
    if (place.filtered) {
        pixel = gabor_impl_pixel(place, wave, stretch, amplitude, transmitted);
        float3 variance = pixel.diagonal;
        wide = clamp(100.0 * sqrt(max(max(variance.x, variance.y), variance.z)) - 9.0, 0.0, 1.0);
    }
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 1.0 - transmitted);
    if (transmitted == 0.0)
        return sum;
    if (wide < 1.0)
        gabor_impl_accumulate_3d(sum, gabor_impl_sum_3d(place, wave, pixel, salt), (1.0 - wide) * amplitude);
    if (wide > 0.0) {
        float4 noise, quadrature;
        gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.time, wave, pixel,
                                  wide > 0.0, salt, noise, quadrature);
        gabor_impl_accumulate_3d(sum, GaborField3d_of(noise.x, noise.yzw, quadrature.x, quadrature.yzw, 0.0),
                                 wide * amplitude);
    }
    sum.gradient *= stretch;
    sum.quadrature_gradient *= stretch;
    return sum;
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
void gabor_impl_add_term(inout GaborField3d sum, GaborPlace3d place, float frequency, float3 direction, uint seed,
                         int index, float power) {
    GaborField3d term = gabor_field_3d(place, frequency, direction, gabor_lobe_seed(seed, index));
    gabor_impl_accumulate_3d(sum, term, sqrt(power));
    sum.removed += power * term.removed;
}

// Of directions evenly in a range, a real number `count` of them, the last in what is left of it: the place of number
// `index`, from 0 to 1, and its power. That is nearly in proportion to its size, but falls to 0 as the square of that: in
// proportion, the amplitude, its root, would begin with an infinite slope.
float2 gabor_impl_direction(int index, float count) {
    float2 size = float2(min(count - float(index), 1.0), frac(count)); // of this one, and of the last
    float2 power = size * size * 1.05 / (size + 0.05);
    return float2((float(index) + 0.5 * size.x) / count, power.x / (floor(count) + power.y));
}

// Directions evenly on a spiral over half the sphere.
GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, uint seed) {
    float count = 8.0 + 8.0 * min(frequency * frequency, 64.0);
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = 0; i < int(ceil(count)); ++i) {
        float2 part = gabor_impl_direction(i, count);
        float3 direction = float3(sqrt(1.0 - part.x * part.x) * gabor_impl_wave(0.61803399 * float(i)), part.x);
        gabor_impl_add_term(sum, place, frequency, direction, seed, i, part.y);
    }
    return sum;
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
GaborField3d gabor_surface_3d(GaborPlace3d place, float3 normal, float frequency, float3 direction, uint seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    float3 other = cross(direction, abs(direction.z) < 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float power = gabor_impl_takeover(smoothstep(0.0625, 0.25, dot(direction, direction)));
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = power > 0.0 ? 0 : 1; i < (power < 1.0 ? 2 : 1); ++i)
        gabor_impl_add_term(sum, place, frequency, i == 0 ? direction : other, seed, i, i == 0 ? power : 1.0 - power);
    return sum;
}

// Directions evenly over half a turn in the tangent plane, from the circle of latitude around z; near the poles around x.
GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, float3 normal, float frequency, uint seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0 + 4.5 * min(abs(frequency), 32.0);
    float power = gabor_impl_takeover(smoothstep(0.25, 0.5, dot(normal.xy, normal.xy)));
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int axis = 0; axis < 2; ++axis) {
        float3 along = gabor_impl_unit(cross(axis == 0 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0), normal));
        for (int i = 0; i < int(ceil(count)) && power > 0.0; ++i) {
            float2 part = gabor_impl_direction(i, count);
            float2 turn = gabor_impl_wave(0.5 * part.x);
            float3 direction = turn.x * along + turn.y * cross(normal, along);
            gabor_impl_add_term(sum, place, frequency, direction, seed, 256 * axis + i, power * part.y);
        }
        power = 1.0 - power;
    }
    return sum;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p, frequency, seed  as for gabor_noise
//   direction           of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
float gabor_noise_3d(float3 p, float frequency, float3 direction, uint seed) {
    return gabor_field_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), frequency, direction, seed).noise;
}

// The same with its gradient: (noise, d/dx, d/dy, d/dz). For bumps take away the part of it along the normal.
float4 gabor_noise_3d_gradient(float3 p, float frequency, float3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), frequency, direction, seed);
    return float4(field.noise, field.gradient);
}

// (quadrature, noise), for gabor_phasor: see gabor_noise_complex.
float2 gabor_noise_3d_complex(float3 p, float frequency, float3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), frequency, direction, seed);
    return float2(field.quadrature, field.noise);
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
float4 gabor_noise_3d_four(float3 p, float frequency, float3 direction, uint seed) {
    return float4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
float gabor_noise_3d_tiled(float3 p, float3 period, float frequency, float3 direction, uint seed) {
    period = clamp(period, 0.0009765625, 1.0e9);
    float3 nodes = max(floor(period * GABOR_RADIUS + 0.5), (float3)(3.0));
    GaborPlace3d place = gabor_place_3d((int3)(0), (p - floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = (int3)(nodes);
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
float gabor_noise_3d_animated(float3 p, float time, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = GaborPlace3d_of((int3)(0), p * GABOR_RADIUS, (float3)(GABOR_RADIUS), (int3)(0), true, time,
                                      false, (float3)(0.0), (float3)(0.0));
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter and its accuracy are those of gabor_noise_filtered: 1 % up to a third of a kernel radius along the pixel's
// longest axis, 2 % up to a whole one. Continuous in the place and in both steps. On GPUs 1.4 times gabor_noise_3d up to
// steps of 0.18, with 27 nodes; from 0.2 on 4.2 times, with 64, and up to 6.6 times with 125.
float2 gabor_noise_3d_filtered(float3 p, float3 dx, float3 dy, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = GaborPlace3d_of((int3)(0), p * GABOR_RADIUS, (float3)(GABOR_RADIUS), (int3)(0), false, 0.0,
                                      true, dx, dy);
    GaborField3d field = gabor_field_3d(place, frequency, direction, seed);
    return float2(field.noise, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 noises, rounded up, for a frequency F of at most 8, and no more
// beyond. Its power differs between directions by 14 % (root mean square) at F = 0.5, 16 % at 1 and 25 % at 4.
float gabor_noise_3d_isotropic(float3 p, float frequency, uint seed) {
    return gabor_isotropic_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), frequency, seed).noise;
}

// Noise on a surface at its point p, whose normal has any length from 10^-15 to 10^15, its waves along the projection of a direction: one
// noise, two where that is 14 to 30 degrees from the normal. Where the surface is curved the waves of a kernel bend.
float gabor_noise_surface(float3 p, float3 normal, float frequency, float3 direction, uint seed) {
    return gabor_surface_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

// The same along all directions of the tangent plane: 2 + 4.5 F noises, F up to 32, twice as many 30 to 45 degrees from z.
float gabor_noise_surface_isotropic(float3 p, float3 normal, float frequency, uint seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_LATTICE_3D_HLSL

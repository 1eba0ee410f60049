// gabor_noise_3d.glsl: Gabor noise in space, and on surfaces without parametrization.
//
// Paste or include this file after gabor_noise.glsl, whose hash and sine it uses, in the same dialects: GLSL 450, 330
// core or 300 es. It declares no resources, and every name it adds begins with gabor_, Gabor
// or GABOR_3D_.
//
//     float n = gabor_noise_3d(p, 4.0, vec3(1.0, 0.0, 0.0), 7u);        // mean 0, variance 1
//     float s = gabor_noise_surface_isotropic(p, normal, 4.0, 7u);      // on any mesh
//
// Functions to call, at the end of the file:
//     gabor_noise_3d, gabor_noise_3d_isotropic    solid noise along one direction, or along all
//     gabor_noise_3d_gradient                     with its analytic gradient, for bump mapping
//     gabor_noise_3d_complex                      with its quadrature, for gabor_phasor
//     gabor_noise_3d_tiled, gabor_noise_3d_animated   with exact periods in space, and in time
//     gabor_noise_surface, gabor_noise_surface_isotropic   waves that lie in the tangent plane
//     gabor_kernel_3d, ..., gabor_filtered_3d, gabor_field_3d   all of it by integer cell, and filtered
//
// The noise is a sum of Gabor kernels around random places x_i (sparse convolution):
//
//     n(p) = K sum_i q(d.x) q(d.y) q(d.z) sin(2 pi (f_i.d + phase_i)),     d = p - x_i
//
// The unit of length is the kernel radius: the window q ends at 1, where it and its slope are 0. Every wave vector f_i
// is the same for oriented noise, and uniform on the sphere of radius F, impulse by impulse, for isotropic noise. On a
// surface it is projected to the tangent plane and brought to length F again, so that the surface sees the frequency
// that was asked for and no trace of the grid [after Lagae et al., "Procedural noise using sparse Gabor convolution",
// 2009]. The phases are random, whatever f_i is: so K makes the variance exactly 1 at every frequency and every place,
// on every surface, irrespective of its curvature and its slope against the grid.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_3D_GLSL
#define GABOR_NOISE_3D_GLSL

#ifndef GABOR_NOISE_GLSL
#error gabor_noise_3d.glsl uses the hash and the sine of gabor_noise.glsl: put that file before it
#endif

// A fragment shader of GLSL ES that asks for no more gets ints of 16 bits, and floats too where it says mediump.
#ifdef GL_ES
precision highp float;
precision highp int;
#endif

// ---- Recipe: how quality is bought ---------------------------------------------------------------------------------
// Define these before the file for another recipe, and GABOR_UNROLL, see gabor_noise.glsl, where it is known: lavapipe
// then takes half as long. The default visits 27 impulses, with sidelobes of -24 dB and cvm 0.06, on surfaces along all
// tangents 0.22. GABOR_3D_RADIUS 1.5 with GABOR_3D_WINDOW vec3(0.7, -0.9, 1.2) visits 64: -50 dB and cvm 0.01.

// N, impulses per cell: an int, at least 1.
#ifndef GABOR_3D_IMPULSES
#define GABOR_3D_IMPULSES 1
#endif
#if !defined(GABOR_UNCHECKED) && GABOR_3D_IMPULSES < 1
#error GABOR_3D_IMPULSES is an int, at least 1
#endif

// R, cells per kernel radius: a float, at least 1. Each axis visits ceil(2 R) + 1 cells.
#ifndef GABOR_3D_RADIUS
#define GABOR_3D_RADIUS 1.0
#endif

// The window: q(x) = u^2 (c.x + c.y u + c.z u^2) with u = 1 - x^2.
#ifndef GABOR_3D_WINDOW
#define GABOR_3D_WINDOW vec3(3.1, -3.9, 1.8)
#endif

void gabor_impl_check_macros_3d()
{
    gabor_impl_macro_must_be_an_int(GABOR_3D_IMPULSES);
    gabor_impl_macro_must_be_a_float(GABOR_3D_RADIUS);
    gabor_impl_macro_must_be_a_vec3(GABOR_3D_WINDOW);
}

// ---- Impulses ------------------------------------------------------------------------------------------------------

// The word of impulse `index` in a cell; everything about the impulse follows from it: x, y, phase and tempo by its
// bits as in gabor_noise.glsl, z and the direction as below. All weights are 1: in space the strata alone take nearly
// all of the fourth cumulant away.
uint gabor_impulse_word_3d(int column, uint row_word, int index)
{
    return gabor_impl_row_word(column, row_word + uint(index) * 0x85ebca6bu);
}

// Place of an impulse in its cell, plus 1: in [1, 2)^3. The places of all words are a lattice, whose shortest waves, of
// phase and place together, have more than 150 periods in a cell.
vec3 gabor_place_plus_one_3d(uint word)
{
    return vec3(gabor_impl_position_plus_one(word),
                uintBitsToFloat(0x3f800000u | ((word * GABOR_IMPL_CELL_STRIDE) >> 9u)));
}

// Phase of the impulse, in turns: 256 of them, evenly spread.
float gabor_phase_3d(uint word)
{
    return float(word & 0xffu) * 0.00390625;
}

// Direction of an impulse: uniform on the unit sphere, for its height is uniform (Archimedes).
vec3 gabor_sphere_3d(uint word)
{
    vec2 uniform_plus_one = gabor_impl_position_plus_one(gabor_impl_mix(word, 0x85ebca6bu));
    float height = 2.0 * uniform_plus_one.x - 3.0;
    float turns = uniform_plus_one.y - 1.0;
    float across = sqrt((1.0 - height) * (1.0 + height));
    return vec3(across * gabor_impl_sine(turns + 0.25), across * gabor_impl_sine(turns), height);
}

// A direction brought to the plane that is perpendicular to a unit normal, or anywhere if that is 0, and to length 1.
// Less than 1/8 of the unit from the normal it becomes shorter, and 0 where they agree: no field of directions goes
// around a sphere without a zero. It is continuous with its first derivatives.
vec3 gabor_tangent_3d(vec3 direction, vec3 normal)
{
    vec3 tangent = direction - dot(direction, normal) * normal;
    float square = dot(tangent, tangent);
    return tangent * (square > 0.015625 ? inversesqrt(square) : 12.0 - 256.0 * square);
}

// The direction of an impulse, a unit vector, brought to the plane that is perpendicular to a unit normal, or left as
// it is where that is 0, and to length 1. Last its weight: around the normal, where the direction in the plane turns
// ever faster, it falls to 0, with a continuous derivative.
vec4 gabor_tangent_and_weight_3d(vec3 direction, vec3 normal)
{
    vec3 tangent = direction - dot(direction, normal) * normal;
    float square = dot(tangent, tangent);
    float away = min(8.0 * square, 1.0);
    return vec4(tangent * inversesqrt(max(square, 1.0e-12)), away * (2.0 - away));
}

// The window q along each axis, 0 from |x| = 1 on.
vec3 gabor_window_3d(vec3 x)
{
    vec3 c = GABOR_3D_WINDOW;
    vec3 u = max(1.0 - x * x, 0.0);
    return u * u * (c.x + u * (c.y + u * c.z));
}

// Its derivative.
vec3 gabor_window_slope_3d(vec3 x)
{
    vec3 c = GABOR_3D_WINDOW;
    vec3 u = max(1.0 - x * x, 0.0);
    return -2.0 * x * u * (2.0 * c.x + u * (3.0 * c.y + u * (4.0 * c.z)));
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// s^2, of the Gaussian exp(-x^2 / (2 s^2)) that stands for the window: its second moment, where the integral of u^n is
// I_n, and that of x^2 u^n is I_n / (2n+3).
float gabor_window_variance_3d()
{
    vec3 areas = GABOR_3D_WINDOW * vec3(16.0 / 15.0, 32.0 / 35.0, 256.0 / 315.0);
    return dot(areas, vec3(1.0 / 7.0, 1.0 / 9.0, 1.0 / 11.0)) / dot(areas, vec3(1.0));
}

// What a wave keeps of its amplitude, given its dot products with the blur vectors of gabor_filtered_3d.
float gabor_damping_3d(vec2 blurred)
{
    return exp(-19.739209 * gabor_window_variance_3d() * dot(blurred, blurred));
}

// ---- Functions to call ---------------------------------------------------------------------------------------------

// Gabor kernels ready to be summed: all that the noise needs to know of its waves.
struct GaborKernel3d {
    vec3 wave;       // the wave vector of all impulses, cycles per kernel radius
    float amplitude; // K
    float frequency; // 0, or the length of a wave vector that each impulse has in its own direction, instead of `wave`
    vec3 normal;     // unit vector to which those are perpendicular, or 0
    vec3 blur_x;     // what a pixel's footprint does to them: see gabor_filtered_3d
    vec3 blur_y;
};

// K and nothing else yet. There are N R^3 impulses per unit volume, and random phases average sin^2 to 1/2, so by
// Campbell's theorem
//     1 / K^2 = N R^3 J^3 / 2,     J = integral over [-1, 1] of q^2.
// The integral of u^n over [-1, 1], u = 1 - x^2, is I_n = I_(n-1) 2n / (2n+1), I_4 = 256/315, so J is a quadratic form
// of the window's coefficients: here as a sum of squares, by Cholesky's decomposition, for its terms would cancel.
GaborKernel3d gabor_kernel_of_wave_3d(vec3 wave, float frequency, vec3 normal)
{
    vec3 c = GABOR_3D_WINDOW;
    float first = c.x + (10.0 / 11.0) * c.y + (120.0 / 143.0) * c.z;
    float second = c.y + 1.6 * c.z;
    float energy = (256.0 / 315.0) * (first * first + (20.0 / 1573.0) * second * second
                                      + (704.0 / 1738165.0) * c.z * c.z);
    float density = float(GABOR_3D_IMPULSES) * GABOR_3D_RADIUS * GABOR_3D_RADIUS * GABOR_3D_RADIUS;
    float amplitude = inversesqrt(0.5 * density * energy * energy * energy);
    return GaborKernel3d(wave, amplitude, frequency, normal, vec3(0.0), vec3(0.0));
}

// A frequency within [10^-6, 10^6], by its magnitude.
float gabor_frequency_3d(float frequency)
{
    float magnitude = abs(frequency);
    return magnitude > 1.0e-6 ? min(magnitude, 1.0e6) : 1.0e-6;
}

// A vector brought to length 1, or 0 where its largest coordinate is not within [10^-30, 10^30].
vec3 gabor_unit_3d(vec3 v)
{
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    return largest >= 1.0e-30 && largest <= 1.0e30 ? normalize(v / largest) : vec3(0.0);
}

// Oriented solid noise: frequency and direction as in gabor_noise_3d. Make kernels once where they do not vary.
GaborKernel3d gabor_kernel_3d(float frequency, vec3 direction)
{
    return gabor_kernel_of_wave_3d(gabor_frequency_3d(frequency) * gabor_unit_3d(direction), 0.0, vec3(0.0));
}

// Isotropic solid noise, its spectrum a shell around frequency 0.
GaborKernel3d gabor_kernel_isotropic_3d(float frequency)
{
    return gabor_kernel_of_wave_3d(vec3(0.0), gabor_frequency_3d(frequency), vec3(0.0));
}

// Oriented surface noise, see gabor_noise_surface.
GaborKernel3d gabor_kernel_surface(float frequency, vec3 direction, vec3 normal)
{
    vec3 tangent = gabor_tangent_3d(gabor_unit_3d(direction), gabor_unit_3d(normal));
    return gabor_kernel_of_wave_3d(gabor_frequency_3d(frequency) * tangent, 0.0, vec3(0.0));
}

// Surface noise along all directions of the tangent plane, see gabor_noise_surface_isotropic. Whatever the normal, the
// squares of the weights of gabor_tangent_and_weight_3d have the same mean over the sphere, 0.9702904.
GaborKernel3d gabor_kernel_surface_isotropic(float frequency, vec3 normal)
{
    vec3 unit = gabor_unit_3d(normal);
    GaborKernel3d kernel = gabor_kernel_of_wave_3d(vec3(0.0), gabor_frequency_3d(frequency), unit);
    kernel.amplitude *= dot(unit, unit) > 0.0 ? 1.0151942 : 1.0;
    return kernel;
}

// The same kernel seen through a pixel, whose footprint is a Gaussian with a standard deviation of half a pixel.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// A Gaussian of variance s^2 times a wave, filtered by a Gaussian of covariance S = (dx dx^T + dy dy^T) / 4, is one
// again: with D = S (s^2 + S)^-1 its wave vector f becomes f - D f, its amplitude falls by exp(-2 pi^2 s^2 f.D f), and
// its energy by det(1 + S / s^2)^(1/2) besides. D = blur_x blur_x^T + blur_y blur_y^T by Cholesky's decomposition.
// This window is no Gaussian, and here it does not widen: the noise differs from what the footprint averages by less
// than 0.15 / F in root mean square, 0.03 at frequency 4, for F from 1 to 8 and pixels of up to a kernel radius. Its
// standard deviation is right within 0.02. Beyond, it goes on falling towards 0.
GaborKernel3d gabor_filtered_3d(GaborKernel3d kernel, vec3 dx, vec3 dy)
{
    dx = 0.5 * clamp(dx, -1.0e6, 1.0e6);
    dy = 0.5 * clamp(dy, -1.0e6, 1.0e6);
    float s2 = gabor_window_variance_3d();
    float x = inversesqrt(s2 + dot(dx, dx));
    kernel.blur_x = x * dx;
    float along = dot(kernel.blur_x, dy);
    float y = inversesqrt(max(s2 + dot(dy, dy) - along * along, s2));
    kernel.blur_y = y * (dy - along * kernel.blur_x);
    vec2 blurred = vec2(dot(kernel.wave, kernel.blur_x), dot(kernel.wave, kernel.blur_y));
    kernel.wave -= blurred.x * kernel.blur_x + blurred.y * kernel.blur_y;
    kernel.amplitude *= sqrt(s2 * x * y) * gabor_damping_3d(blurred);
    return kernel;
}

// Where to evaluate, and how space and time close upon themselves.
struct GaborPlace3d {
    ivec3 cell;   // any integers, but for the last few before the world wraps around at 2^31
    vec3 local;   // offset from that cell's corner, in cells: any small vector, [0, 1)^3 is the most precise
    vec3 radius;  // cells per kernel radius along each axis: GABOR_3D_RADIUS, or between half of it and it
    ivec3 period; // in cells, 0 for none
    float time;   // in periods of time: only its fraction counts
};

// (cell + local) / GABOR_3D_RADIUS kernel radii, without periods, at time 0: full precision everywhere in a world of
// 2^32 cells each way, where it wraps around.
GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
{
    return GaborPlace3d(cell, local, vec3(GABOR_3D_RADIUS), ivec3(0), 0.0);
}

// The noise as a complex number, whose imaginary part is the noise itself and whose real part is the same with cosines
// for sines, and its gradient. Parts that are not used cost nothing: compilers leave them out.
struct GaborField3d {
    vec2 value;   // real, imaginary: each of mean 0 and variance 1
    vec2 slope_x; // their derivatives along x, per kernel radius, the kernel held fixed
    vec2 slope_y; // along y
    vec2 slope_z; // along z
};

// The noise at a place, by its cell: what all functions below call.
//   kernel  from one of the functions above
//   seed    any; each seed is another instance, independent of the others
// Cost: (ceil(2 R) + 1)^3 N impulses, 27 for the default recipe.
GaborField3d gabor_field_3d(GaborPlace3d place, GaborKernel3d kernel, uint seed)
{
    int visited = int(ceil(2.0 * GABOR_3D_RADIUS)) + 1;
    vec3 whole = floor(place.local);
    vec3 local = place.local - whole;
    vec3 first = floor(local - place.radius);
    ivec3 cell = place.cell + ivec3(whole + first);
    first -= 1.0; // what gabor_place_plus_one_3d has too much
    vec3 cell_side = 1.0 / place.radius;
    float time = fract(place.time);

    uint seed_word = gabor_impl_seed_word(seed);
    GaborField3d sum = GaborField3d(vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));
    GABOR_UNROLL for (int h = 0; h < visited; ++h) {
        uint slice_word = gabor_impl_row_word(gabor_impl_wrap(cell.z + h, place.period.z), seed_word);
        GABOR_UNROLL for (int j = 0; j < visited; ++j) {
            uint row_word = gabor_impl_row_word(gabor_impl_wrap(cell.y + j, place.period.y), slice_word);
            GABOR_UNROLL for (int i = 0; i < visited; ++i) {
                int column = gabor_impl_wrap(cell.x + i, place.period.x);
                GABOR_UNROLL for (int k = 0; k < GABOR_3D_IMPULSES; ++k) {
                    uint word = gabor_impulse_word_3d(column, row_word, k);
                    vec3 impulse = gabor_place_plus_one_3d(word);
                    // The sum in the inner brackets is exact, which leaves one rounding.
                    vec3 d = (local - (impulse + (first + vec3(float(i), float(j), float(h))))) * cell_side;
                    // Eight impulses of 27 reach here.
                    if (max(max(abs(d.x), abs(d.y)), abs(d.z)) < 1.0) {
                        vec3 wave = kernel.wave;
                        float magnitude = 1.0;
                        if (kernel.frequency > 0.0) {
                            vec4 tangent = gabor_tangent_and_weight_3d(gabor_sphere_3d(word), kernel.normal);
                            wave = kernel.frequency * tangent.xyz;
                            vec2 blurred = vec2(dot(wave, kernel.blur_x), dot(wave, kernel.blur_y));
                            magnitude = tangent.w * gabor_damping_3d(blurred);
                            wave -= blurred.x * kernel.blur_x + blurred.y * kernel.blur_y;
                        }
                        float turns = dot(wave, d) + gabor_phase_3d(word) + gabor_impl_phase_rate(word) * time;
                        vec3 q = gabor_window_3d(d);
                        vec3 slope = gabor_window_slope_3d(d) * q.yzx * q.zxy;
                        vec2 unit = magnitude * vec2(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns));
                        vec2 value = (q.x * q.y * q.z) * unit;
                        vec2 turned = 6.2831853 * vec2(-value.y, value.x);
                        sum.value += value;
                        sum.slope_x += slope.x * unit + wave.x * turned;
                        sum.slope_y += slope.y * unit + wave.y * turned;
                        sum.slope_z += slope.z * unit + wave.z * turned;
                    }
                }
            }
        }
    }
    // With fewer cells per radius there are fewer impulses.
    vec3 fewer = place.radius / GABOR_3D_RADIUS;
    float scale = kernel.amplitude * inversesqrt(fewer.x * fewer.y * fewer.z);
    return GaborField3d(scale * sum.value, scale * sum.slope_x, scale * sum.slope_y, scale * sum.slope_z);
}

// The noise at (cell + local) / GABOR_3D_RADIUS kernel radii, in full precision everywhere. See gabor_place_3d and
// gabor_field_3d.
float gabor_noise_3d_at(ivec3 cell, vec3 local, GaborKernel3d kernel, uint seed)
{
    return gabor_field_3d(gabor_place_3d(cell, local), kernel, seed).value.y;
}

// Oriented solid noise at p: mean 0, variance 1 at every place, nearly Gaussian, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R. Where p is large its own rounding shows: at 10^5 a float steps
//              by 0.008.
//   frequency  cycles per kernel radius; its magnitude is used, within [10^-6, 10^6]. From about 1 up the noise is a
//              distinct lobe; above 64 the places of impulses are too coarse for the exact variance.
//   direction  of the wave vector, of any length; with 0, or beyond 10^30, its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Frequency and direction may vary from place to place: where they are continuous so is the noise, for each wave turns
// about its own impulse. A slope of theirs adds to that of the noise.
float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed)
{
    return gabor_noise_3d_at(ivec3(0), p * GABOR_3D_RADIUS, gabor_kernel_3d(frequency, direction), seed);
}

// Isotropic solid noise at p: as gabor_noise_3d, but each impulse has its own direction, uniform on the sphere. What a
// plane or a surface shows of it is a slice: all frequencies up to the one asked for. gabor_noise_surface_isotropic
// shows that one alone.
float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed)
{
    return gabor_noise_3d_at(ivec3(0), p * GABOR_3D_RADIUS, gabor_kernel_isotropic_3d(frequency), seed);
}

// Oriented solid noise at p and its analytic gradient: (noise, d/dx, d/dy, d/dz), derivatives per kernel radius,
// continuous everywhere. For bump mapping take away the part along the normal.
vec4 gabor_noise_3d_gradient(vec3 p, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_3D_RADIUS);
    GaborField3d field = gabor_field_3d(place, gabor_kernel_3d(frequency, direction), seed);
    return vec4(field.value.y, field.slope_x.y, field.slope_y.y, field.slope_z.y);
}

// Oriented solid noise at p with its quadrature: the real part has cosines where the imaginary part, the noise, has
// sines. Both have mean 0 and variance 1, and at one place are independent.
vec2 gabor_noise_3d_complex(vec3 p, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_3D_RADIUS);
    return gabor_field_3d(place, gabor_kernel_3d(frequency, direction), seed).value;
}

// The place p, in kernel radii, of noise that repeats after `period` kernel radii along each axis: for gabor_field_3d.
// Each period is at least 2, a kernel's diameter. A shorter one is taken as 2. Where period * R is not whole, cells
// grow until a whole number fits, and mean and variance stay what they are.
GaborPlace3d gabor_place_3d_tiled(vec3 p, vec3 period)
{
    period = max(period, vec3(2.0));
    vec3 cells = floor(period * GABOR_3D_RADIUS);
    vec3 radius = cells / period;
    vec3 within = p - floor(p / period) * period;
    return GaborPlace3d(ivec3(0), within * radius, radius, ivec3(cells), 0.0);
}

// Oriented solid noise that repeats after `period` kernel radii along each axis, exactly, whatever the frequency and
// direction: see gabor_place_3d_tiled.
float gabor_noise_3d_tiled(vec3 p, vec3 period, float frequency, vec3 direction, uint seed)
{
    return gabor_field_3d(gabor_place_3d_tiled(p, period), gabor_kernel_3d(frequency, direction), seed).value.y;
}

// Oriented solid noise that evolves in place, without drift, and is itself again whenever `time` has gone by 1. At
// every time it is gabor_noise_3d of some instance.
float gabor_noise_3d_animated(vec3 p, float time, float frequency, vec3 direction, uint seed)
{
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_3D_RADIUS);
    place.time = time;
    return gabor_field_3d(place, gabor_kernel_3d(frequency, direction), seed).value.y;
}

// Noise on a surface at its point p, its waves along one direction: mean 0, variance 1, continuous as the normal is.
//   p, frequency, seed  as in gabor_noise_3d
//   direction           any vector: the waves run along its projection to the tangent plane. Where that is less than
//                       1/8 of its length the frequency falls, to 0 where the surface faces it.
//   normal              of the surface at p, of any length but 0, and the same for both sides
// Frequency and direction are exact where the surface is flat; where it is curved with radius r, the waves of a kernel
// bend, and frequencies spread by as much as 1/r.
float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed)
{
    return gabor_noise_3d_at(ivec3(0), p * GABOR_3D_RADIUS, gabor_kernel_surface(frequency, direction, normal), seed);
}

// Noise on a surface at its point p, its waves along all directions of the tangent plane alike: as gabor_noise_surface,
// but that no point of the surface is special.
float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed)
{
    return gabor_noise_3d_at(ivec3(0), p * GABOR_3D_RADIUS, gabor_kernel_surface_isotropic(frequency, normal), seed);
}

#endif // GABOR_NOISE_3D_GLSL

// gabor_lattice_3d.hpp: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.hpp; every name that it adds begins with gabor_ or Gabor: for C++ on the CPU.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hpp.
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

#ifndef GABOR_LATTICE_3D_HPP
#define GABOR_LATTICE_3D_HPP
#ifndef GABOR_LATTICE_HPP
#error Include gabor_lattice.hpp before gabor_lattice_3d.hpp
#elif GABOR_TAPS != 3
#error gabor_lattice_3d.hpp needs GABOR_TAPS 3
#endif

// Where to evaluate, and how space and time close upon themselves: see GaborPlace.
struct GaborPlace3d {
    gabor_ivec3 cell;
    gabor_vec3 local;
    gabor_vec3 radius;
    gabor_ivec3 period;
    bool animated;
    float time;
    bool filtered; // whether to average over the pixel whose sides are dx and dy: see gabor_noise_3d_filtered
    gabor_vec3 dx;
    gabor_vec3 dy;
};

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField3d {
    gabor_vec2 value;
    gabor_vec2 slope_x;
    gabor_vec2 slope_y;
    gabor_vec2 slope_z;
    float removed; // variance that the average over the pixel takes away
};

// ---- The nodes around a place --------------------------------------------------------------------------------------

#define GABOR_IMPL_SLICES 0x27d4eb2fu // as GABOR_IMPL_ROWS

// Along each axis.
struct GaborAxes3d {
    GaborAxis x;
    GaborAxis y;
    GaborAxis z;
    gabor_vec2 base; // K times the wave at the middle node: E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1
};

GABOR_INLINE GaborAxes3d gabor_impl_axes(GaborPlace3d place, gabor_vec3 wave, std::uint32_t seed) {
    GaborAxes3d n;
    std::uint32_t salt = gabor_impl_salt(seed);
    n.x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, place.radius.x);
    n.y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y, place.radius.y);
    n.z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z, place.radius.z);
    n.base = gabor_cpp_inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
           * gabor_impl_wave(n.x.turns * n.x.offset + n.y.turns * n.y.offset + n.z.turns * n.z.offset);
    return n;
}

// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
GABOR_INLINE std::uint32_t gabor_impl_slice_word(std::uint32_t row, std::uint32_t slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// Adds slice k of nodes, a sum as in the plane: to `sum` the noise, in zw with the derivatives of windows along x, to
// `slopes` with those along y, in zw along z.
GABOR_INLINE void gabor_impl_add_slice(gabor_vec4& sum, gabor_vec4& slopes, GaborAxes3d n, int k, GaborPlace3d place) {
    GaborAxis rows = n.y;
    rows.word[0] = gabor_impl_slice_word(n.y.word[0], n.z.word[k]);
    rows.word[1] = gabor_impl_slice_word(n.y.word[1], n.z.word[k]);
    rows.word[2] = gabor_impl_slice_word(n.y.word[2], n.z.word[k]);
    gabor_vec4 slice;
    gabor_vec4 slope;
    gabor_impl_sum(n.x, rows, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, n.z.node[k].xy());
    slopes += gabor_vec4(gabor_impl_product(slope.xy(), n.z.node[k].xy()), gabor_impl_product(slice.xy(), n.z.node[k].zw()));
}

GABOR_INLINE GaborField3d gabor_impl_windowed(GaborPlace3d place, gabor_vec3 wave, std::uint32_t seed) {
    GaborAxes3d n = gabor_impl_axes(place, wave, seed);
    gabor_vec4 sum = gabor_vec4(0.0f);
    gabor_vec4 slopes = gabor_vec4(0.0f);
    gabor_impl_add_slice(sum, slopes, n, 0, place);
    gabor_impl_add_slice(sum, slopes, n, 1, place);
    gabor_impl_add_slice(sum, slopes, n, 2, place);
    gabor_vec2 value = gabor_impl_product(sum.xy(), n.base);
    gabor_vec2 turned = 6.2831853f * gabor_vec2(-value.y, value.x);
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d{value, stretch.x * gabor_impl_product(sum.zw(), n.base) + wave.x * turned,
                        stretch.y * gabor_impl_product(slopes.xy(), n.base) + wave.y * turned,
                        stretch.z * gabor_impl_product(slopes.zw(), n.base) + wave.z * turned, 0.0f};
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// Three times three complex numbers.
struct GaborMatrix {
    gabor_mat3 real;
    gabor_mat3 imaginary;
};

GABOR_INLINE GaborMatrix gabor_impl_matrix_product(GaborMatrix m, GaborMatrix n) {
    return GaborMatrix{m.real * n.real - m.imaginary * n.imaginary, m.real * n.imaginary + m.imaginary * n.real};
}

// The amplitudes of a slice of nodes, a column for each row, as `x` and `y` take them from nodes to waves.
GABOR_INLINE GaborMatrix gabor_impl_slice(GaborAxes3d n, std::uint32_t slice, GaborPlace3d place, GaborMatrix x, GaborMatrix y) {
    GaborMatrix m;
    for (int j = 0; j < 3; ++j) {
        std::uint32_t row = gabor_impl_slice_word(n.y.word[j], slice);
        for (int i = 0; i < 3; ++i) {
            gabor_vec2 amplitude = gabor_impl_amplitude_at(n.x.word[i] * row, place.animated, place.time);
            m.real[j][i] = amplitude.x;
            m.imaginary[j][i] = amplitude.y;
        }
    }
    return gabor_impl_matrix_product(gabor_impl_matrix_product(x, m), y);
}

// What an axis' three nodes add to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4.
// Within half a deviation of the filter from its window's end a node fades, so that nothing jumps.
GABOR_INLINE GaborMatrix gabor_impl_waves(GaborAxis axis, float deviation) {
    gabor_vec3 d = (axis.offset + gabor_vec3(1.0f, 0.0f, -1.0f)) / GABOR_RADIUS;
    gabor_vec2 step = gabor_impl_wave(axis.turns);
    gabor_vec3 reach = gabor_cpp_clamp((1.0f - gabor_cpp_abs(d)) / gabor_cpp_max(0.5f * deviation, 1.0e-6f), 0.0f, 1.0f);
    reach *= 0.5f * reach * (3.0f - 2.0f * reach);
    gabor_vec3 real = reach * gabor_vec3(step.x, 1.0f, step.x);
    gabor_vec3 imaginary = reach * gabor_vec3(step.y, 0.0f, -step.y);
    gabor_vec2 turn = 0.5f * gabor_impl_wave(0.5f * d.y);
    gabor_vec3 c = turn.x * gabor_vec3(-0.5f, 1.0f, -0.5f) + turn.y * gabor_vec3(-0.8660254f, 0.0f, 0.8660254f); // half of cos(pi d)
    gabor_vec3 s = turn.y * gabor_vec3(-0.5f, 1.0f, -0.5f) - turn.x * gabor_vec3(-0.8660254f, 0.0f, 0.8660254f);
    return GaborMatrix{gabor_mat3{real * c + imaginary * s, real, real * c - imaginary * s},
                       gabor_mat3{imaginary * c - real * s, imaginary, imaginary * c + real * s}};
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: (det(1 + S^2))^(-1/4).
GABOR_INLINE GaborField3d gabor_impl_filtered(GaborPlace3d place, gabor_vec3 wave, std::uint32_t seed) {
    gabor_vec3 dx = gabor_cpp_clamp(place.dx, -1.0e6f, 1.0e6f);
    gabor_vec3 dy = gabor_cpp_clamp(place.dy, -1.0e6f, 1.0e6f);
    gabor_vec3 stretch = place.radius / GABOR_RADIUS;
    gabor_vec3 deviation = 0.5f * stretch * gabor_cpp_sqrt(dx * dx + dy * dy);
    GaborAxes3d n = gabor_impl_axes(place, wave, seed);
    GaborMatrix x = gabor_impl_waves(n.x, deviation.x);
    GaborMatrix y = gabor_impl_waves(n.y, deviation.y);
    GaborMatrix z = gabor_impl_waves(n.z, deviation.z);
    x = GaborMatrix{gabor_cpp_transpose(x.real), gabor_cpp_transpose(x.imaginary)};
    GaborMatrix first = gabor_impl_slice(n, n.z.word[0], place, x, y);
    GaborMatrix second = gabor_impl_slice(n, n.z.word[1], place, x, y);
    GaborMatrix third = gabor_impl_slice(n, n.z.word[2], place, x, y);
    gabor_vec2 sum = gabor_vec2(0.0f);
    gabor_vec2 slope_x = gabor_vec2(0.0f);
    gabor_vec2 slope_y = gabor_vec2(0.0f);
    gabor_vec2 slope_z = gabor_vec2(0.0f);
    float kept = 0.0f;
    for (int b = 0; b < 3; ++b) {
        GaborMatrix m = GaborMatrix{gabor_mat3{first.real[b], second.real[b], third.real[b]},
                                    gabor_mat3{first.imaginary[b], second.imaginary[b], third.imaginary[b]}};
        m = gabor_impl_matrix_product(m, z);
        for (int c = 0; c < 3; ++c) {
            for (int a = 0; a < 3; ++a) {
                gabor_vec3 aside = gabor_vec3(float(a - 1), float(b - 1), float(c - 1));
                gabor_vec3 k = wave + 0.5f * stretch * aside;
                float left = gabor_cpp_exp(-4.934802f * (gabor_cpp_dot(k, dx) * gabor_cpp_dot(k, dx) + gabor_cpp_dot(k, dy) * gabor_cpp_dot(k, dy)));
                gabor_vec2 value = left * gabor_vec2(m.real[c][a], m.imaginary[c][a]);
                sum += value;
                slope_x += k.x * gabor_vec2(-value.y, value.x);
                slope_y += k.y * gabor_vec2(-value.y, value.x);
                slope_z += k.z * gabor_vec2(-value.y, value.x);
                kept += left * left * gabor_cpp_exp2(-2.0f * gabor_cpp_dot(aside, aside));
            }
        }
    }
    float trace = 0.25f * (gabor_cpp_dot(dx, dx) + gabor_cpp_dot(dy, dy));
    float determinant = 0.0625f * gabor_cpp_dot(gabor_cpp_cross(dx, dy), gabor_cpp_cross(dx, dy));
    float fade = gabor_cpp_inversesqrt(gabor_cpp_sqrt(gabor_cpp_max(1.0f + trace * trace + determinant * (determinant - 2.0f), 1.0f)));
    gabor_vec2 base = fade * n.base;
    return GaborField3d{gabor_impl_product(base, sum), gabor_impl_product(base, 6.2831853f * slope_x),
                        gabor_impl_product(base, 6.2831853f * slope_y), gabor_impl_product(base, 6.2831853f * slope_z),
                        1.0f - fade * fade * (8.0f / 27.0f) * kept};
}

// ---- By place ------------------------------------------------------------------------------------------------------

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GABOR_INLINE GaborPlace3d gabor_place_3d(gabor_ivec3 cell, gabor_vec3 local) {
    return GaborPlace3d{cell, local, gabor_vec3(GABOR_RADIUS), gabor_ivec3(0), false, 0.0f, false, gabor_vec3(0.0f), gabor_vec3(0.0f)};
}

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
GABOR_INLINE gabor_vec3 gabor_impl_unit(gabor_vec3 v) {
    v = gabor_cpp_clamp(v, -1.0e15f, 1.0e15f);
    return v * gabor_cpp_inversesqrt(gabor_cpp_max(gabor_cpp_dot(v, v), 1.0e-30f));
}

GABOR_INLINE gabor_vec3 gabor_wave_3d(float frequency, gabor_vec3 direction) {
    return gabor_cpp_min(gabor_cpp_abs(frequency), 1.0e6f) * gabor_impl_unit(direction);
}

GABOR_INLINE GaborField3d gabor_field_3d(GaborPlace3d place, gabor_vec3 wave, std::uint32_t seed) {
    if (place.filtered)
        return gabor_impl_filtered(place, wave, seed);
    return gabor_impl_windowed(place, wave, seed);
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
GABOR_INLINE void gabor_impl_add_term(GaborField3d& sum, GaborPlace3d place, gabor_vec3 wave, std::uint32_t seed, int index, float power) {
    GaborField3d term = gabor_field_3d(place, wave, gabor_lobe_seed(seed, index));
    sum.value += gabor_cpp_sqrt(power) * term.value;
    sum.slope_x += gabor_cpp_sqrt(power) * term.slope_x;
    sum.slope_y += gabor_cpp_sqrt(power) * term.slope_y;
    sum.slope_z += gabor_cpp_sqrt(power) * term.slope_z;
    sum.removed += power * term.removed;
}

// Directions evenly along a spiral over half the sphere. Their number is real and the last one has what is left of the
// power, so that all is continuous in frequency.
GABOR_INLINE GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, std::uint32_t seed) {
    float count = 8.0f + 8.0f * gabor_cpp_min(frequency * frequency, 64.0f);
    GaborField3d sum = GaborField3d{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f};
    for (int i = 0; i < int(gabor_cpp_ceil(count)); ++i) {
        float share = gabor_cpp_min(count - float(i), 1.0f) / count;
        float z = float(i) / count + 0.5f * share;
        gabor_vec3 direction = gabor_vec3(gabor_cpp_sqrt(1.0f - z * z) * gabor_impl_wave(0.61803399f * float(i)), z);
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, i, share);
    }
    return sum;
}

// The power of the first of two sums where it takes over from the second as x goes from `low` to `high`.
GABOR_INLINE float gabor_impl_takeover(float low, float high, float x) {
    float share = gabor_cpp_smoothstep(low, high, x);
    return share * share / (share * share + (1.0f - share) * (1.0f - share));
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
GABOR_INLINE GaborField3d gabor_surface_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    gabor_vec3 other = gabor_cpp_cross(direction, gabor_cpp_abs(direction.z) < 0.7f ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f));
    direction -= gabor_cpp_dot(direction, normal) * normal;
    other -= gabor_cpp_dot(other, normal) * normal;
    float power = gabor_impl_takeover(0.0625f, 0.25f, gabor_cpp_dot(direction, direction));
    GaborField3d sum = GaborField3d{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f};
    if (power > 0.0f)
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, 0, power);
    if (power < 1.0f)
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, other), seed, 1, 1.0f - power);
    return sum;
}

// Directions evenly over half a turn from that of the parallel around an axis: z, and near its poles x.
GABOR_INLINE GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0f + 4.5f * gabor_cpp_min(gabor_cpp_abs(frequency), 32.0f);
    float power = gabor_impl_takeover(0.25f, 0.5f, gabor_cpp_dot(normal.xy(), normal.xy()));
    GaborField3d sum = GaborField3d{gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), gabor_vec2(0.0f), 0.0f};
    for (int axis = 0; axis < 2; ++axis) {
        gabor_vec3 along = gabor_impl_unit(gabor_cpp_cross(axis == 0 ? gabor_vec3(0.0f, 0.0f, 1.0f) : gabor_vec3(1.0f, 0.0f, 0.0f), normal));
        for (int i = 0; i < int(gabor_cpp_ceil(count)) && power > 0.0f; ++i) {
            float share = gabor_cpp_min(count - float(i), 1.0f) / count;
            gabor_vec2 turn = gabor_impl_wave(0.5f * (float(i) / count + 0.5f * share));
            gabor_vec3 direction = turn.x * along + turn.y * gabor_cpp_cross(normal, along);
            gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, 256 * axis + i, power * share);
        }
        power = 1.0f - power;
    }
    return sum;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// gabor_noise_3d with its quadrature, for gabor_phasor: see gabor_noise_complex.
GABOR_INLINE gabor_vec2 gabor_noise_3d_complex(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_field_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), gabor_wave_3d(frequency, direction), seed).value;
}

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R; at 10^5 a float steps by 0.008
//   frequency  cycles per kernel radius; its magnitude is used, up to 10^6
//   direction  of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Where frequency and direction vary continuously so does the noise; a slope of theirs adds to that of the noise.
GABOR_INLINE float gabor_noise_3d(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_noise_3d_complex(p, frequency, direction, seed).y;
}

// The noise at p and its gradient: (noise, d/dx, d/dy, d/dz), per kernel radius. For bumps take away the part along the
// normal.
GABOR_INLINE gabor_vec4 gabor_noise_3d_gradient(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS);
    GaborField3d field = gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed);
    return gabor_vec4(field.value.y, field.slope_x.y, field.slope_y.y, field.slope_z.y);
}

// Four noises at p, independent of each other; the first is gabor_noise_3d.
GABOR_INLINE gabor_vec4 gabor_noise_3d_four(gabor_vec3 p, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_vec4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

// Solid noise that repeats after `period` kernel radii along each axis, exactly: see gabor_noise_tiled.
GABOR_INLINE float gabor_noise_3d_tiled(gabor_vec3 p, gabor_vec3 period, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    period = gabor_cpp_max(period, gabor_vec3(0.0009765625f));
    gabor_vec3 nodes = gabor_cpp_max(gabor_cpp_floor(period * GABOR_RADIUS + 0.5f), gabor_vec3(3.0f));
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), (p - gabor_cpp_floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = gabor_ivec3(nodes);
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
GABOR_INLINE float gabor_noise_3d_animated(gabor_vec3 p, float time, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS);
    place.animated = true;
    place.time = time;
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
GABOR_INLINE gabor_vec2 gabor_noise_3d_filtered(gabor_vec3 p, gabor_vec3 dx, gabor_vec3 dy, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    GaborPlace3d place = gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS);
    place.filtered = true;
    place.dx = dx;
    place.dy = dy;
    GaborField3d field = gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed);
    return gabor_vec2(field.value.y, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 of them.
GABOR_INLINE float gabor_noise_3d_isotropic(gabor_vec3 p, float frequency, std::uint32_t seed) {
    return gabor_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), frequency, seed).value.y;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction.
// The frequency is as asked for where the surface is flat; where it is curved the waves of a kernel bend.
GABOR_INLINE float gabor_noise_surface(gabor_vec3 p, gabor_vec3 normal, float frequency, gabor_vec3 direction, std::uint32_t seed) {
    return gabor_surface_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).value.y;
}

// Noise on a surface along all directions of its tangent plane: a sum of 2 + 4.5 F, of twice as many between two axes.
GABOR_INLINE float gabor_noise_surface_isotropic(gabor_vec3 p, gabor_vec3 normal, float frequency, std::uint32_t seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d(gabor_ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).value.y;
}

#endif // GABOR_LATTICE_3D_HPP

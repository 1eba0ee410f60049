// gabor_lattice_3d.hlsl: exactly normalized Gabor noise in space, and on surfaces without parametrization. Include it
// after gabor_lattice.hlsl; every name that it adds begins with gabor_ or Gabor: for HLSL, shader model 5.0 and up.
//
// Made from shaders/gabor_lattice_3d.glsl by tools/translate: change that file, not this one. Paste or include it after gabor_lattice.hlsl.
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

#ifndef GABOR_LATTICE_3D_HLSL
#define GABOR_LATTICE_3D_HLSL
#ifndef GABOR_LATTICE_HLSL
#error Include gabor_lattice.hlsl before gabor_lattice_3d.hlsl
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

// The noise as a complex number, whose imaginary part is the noise itself and whose real part its quadrature, and its
// derivatives per kernel radius. Parts that are not used cost nothing: compilers leave them out.
struct GaborField3d {
    float2 value;
    float2 slope_x;
    float2 slope_y;
    float2 slope_z;
    float removed; // variance that the average over the pixel takes away
};

GaborField3d GaborField3d_of(float2 value, float2 slope_x, float2 slope_y, float2 slope_z, float removed)
{
    GaborField3d made;
    made.value = value;
    made.slope_x = slope_x;
    made.slope_y = slope_y;
    made.slope_z = slope_z;
    made.removed = removed;
    return made;
}

// ---- The nodes around a place --------------------------------------------------------------------------------------

#define GABOR_IMPL_SLICES 0x27d4eb2fu // as GABOR_IMPL_ROWS

// Along each axis.
struct GaborAxes3d {
    GaborAxis x;
    GaborAxis y;
    GaborAxis z;
    float2 base; // K times the wave at the middle node: E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1
};

GaborAxes3d gabor_impl_axes(GaborPlace3d place, float3 wave, uint seed) {
    GaborAxes3d n;
    uint salt = gabor_impl_salt(seed);
    n.x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, place.radius.x);
    n.y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y, place.radius.y);
    n.z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z, place.radius.z);
    n.base = rsqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
           * gabor_impl_wave(n.x.turns * n.x.offset + n.y.turns * n.y.offset + n.z.turns * n.z.offset);
    return n;
}

// The word of a row in a slice of nodes: odd and of 24 bits, as those of lines are.
uint gabor_impl_slice_word(uint row, uint slice) {
    return ((row * slice) >> 8u) | 0x800001u;
}

// Adds slice k of nodes, a sum as in the plane: to `sum` the noise, in zw with the derivatives of windows along x, to
// `slopes` with those along y, in zw along z.
void gabor_impl_add_slice(inout float4 sum, inout float4 slopes, GaborAxes3d n, int k, GaborPlace3d place) {
    GaborAxis rows = n.y;
    rows.word[0] = gabor_impl_slice_word(n.y.word[0], n.z.word[k]);
    rows.word[1] = gabor_impl_slice_word(n.y.word[1], n.z.word[k]);
    rows.word[2] = gabor_impl_slice_word(n.y.word[2], n.z.word[k]);
    float4 slice;
    float4 slope;
    gabor_impl_sum(n.x, rows, place.animated, place.time, slice, slope);
    gabor_impl_add(sum, slice, n.z.node[k].xy);
    slopes += float4(gabor_impl_product(slope.xy, n.z.node[k].xy), gabor_impl_product(slice.xy, n.z.node[k].zw));
}

GaborField3d gabor_impl_windowed(GaborPlace3d place, float3 wave, uint seed) {
    GaborAxes3d n = gabor_impl_axes(place, wave, seed);
    float4 sum = (float4)(0.0);
    float4 slopes = (float4)(0.0);
    gabor_impl_add_slice(sum, slopes, n, 0, place);
    gabor_impl_add_slice(sum, slopes, n, 1, place);
    gabor_impl_add_slice(sum, slopes, n, 2, place);
    float2 value = gabor_impl_product(sum.xy, n.base);
    float2 turned = 6.2831853 * float2(-value.y, value.x);
    float3 stretch = place.radius / GABOR_RADIUS;
    return GaborField3d_of(value, stretch.x * gabor_impl_product(sum.zw, n.base) + wave.x * turned,
                        stretch.y * gabor_impl_product(slopes.xy, n.base) + wave.y * turned,
                        stretch.z * gabor_impl_product(slopes.zw, n.base) + wave.z * turned, 0.0);
}

// ---- Filtering -----------------------------------------------------------------------------------------------------

// Three times three complex numbers.
struct GaborMatrix {
    float3x3 real;
    float3x3 imaginary;
};

GaborMatrix GaborMatrix_of(float3x3 real, float3x3 imaginary)
{
    GaborMatrix made;
    made.real = real;
    made.imaginary = imaginary;
    return made;
}

GaborMatrix gabor_impl_matrix_product(GaborMatrix m, GaborMatrix n) {
    return GaborMatrix_of(mul(n.real, m.real) - mul(n.imaginary, m.imaginary), mul(n.imaginary, m.real) + mul(n.real, m.imaginary));
}

// The amplitudes of a slice of nodes, a column for each row, as `x` and `y` take them from nodes to waves.
GaborMatrix gabor_impl_slice(GaborAxes3d n, uint slice, GaborPlace3d place, GaborMatrix x, GaborMatrix y) {
    GaborMatrix m;
    for (int j = 0; j < 3; ++j) {
        uint row = gabor_impl_slice_word(n.y.word[j], slice);
        for (int i = 0; i < 3; ++i) {
            float2 amplitude = gabor_impl_amplitude_at(n.x.word[i] * row, place.animated, place.time);
            m.real[j][i] = amplitude.x;
            m.imaginary[j][i] = amplitude.y;
        }
    }
    return gabor_impl_matrix_product(gabor_impl_matrix_product(x, m), y);
}

// What an axis' three nodes add to the three waves that they are together between nodes:
//     h(x - c) e^(2 pi i F (x - c)) = sum_a h_a e^(2 pi i (F + a/2) (x - c)),   a = -1, 0, 1,   h_a = 1/4, 1/2, 1/4.
// Within half a deviation of the filter from its window's end a node fades, so that nothing jumps.
GaborMatrix gabor_impl_waves(GaborAxis axis, float deviation) {
    float3 d = (axis.offset + float3(1.0, 0.0, -1.0)) / GABOR_RADIUS;
    float2 step = gabor_impl_wave(axis.turns);
    float3 reach = clamp((1.0 - abs(d)) / max(0.5 * deviation, 1.0e-6), 0.0, 1.0);
    reach *= 0.5 * reach * (3.0 - 2.0 * reach);
    float3 real = reach * float3(step.x, 1.0, step.x);
    float3 imaginary = reach * float3(step.y, 0.0, -step.y);
    float2 turn = 0.5 * gabor_impl_wave(0.5 * d.y);
    float3 c = turn.x * float3(-0.5, 1.0, -0.5) + turn.y * float3(-0.8660254, 0.0, 0.8660254); // half of cos(pi d)
    float3 s = turn.y * float3(-0.5, 1.0, -0.5) - turn.x * float3(-0.8660254, 0.0, 0.8660254);
    return GaborMatrix_of(float3x3(real * c + imaginary * s, real, real * c - imaginary * s),
                       float3x3(imaginary * c - real * s, imaginary, imaginary * c + real * s));
}

// Between nodes the field is a sum of 27 waves, k = F + (a, b, c) / 2. Of each a normal filter of covariance S leaves
// exp(-2 pi^2 k.S k), S = (dx dx^T + dy dy^T) / 4. The middle one has (2/3)^3 of the variance; on each axis its
// neighbours have 1/4 of what it has. Last, over more than a kernel radius all averages out: (det(1 + S^2))^(-1/4).
GaborField3d gabor_impl_filtered(GaborPlace3d place, float3 wave, uint seed) {
    float3 dx = clamp(place.dx, -1.0e6, 1.0e6);
    float3 dy = clamp(place.dy, -1.0e6, 1.0e6);
    float3 stretch = place.radius / GABOR_RADIUS;
    float3 deviation = 0.5 * stretch * sqrt(dx * dx + dy * dy);
    GaborAxes3d n = gabor_impl_axes(place, wave, seed);
    GaborMatrix x = gabor_impl_waves(n.x, deviation.x);
    GaborMatrix y = gabor_impl_waves(n.y, deviation.y);
    GaborMatrix z = gabor_impl_waves(n.z, deviation.z);
    x = GaborMatrix_of(transpose(x.real), transpose(x.imaginary));
    GaborMatrix first = gabor_impl_slice(n, n.z.word[0], place, x, y);
    GaborMatrix second = gabor_impl_slice(n, n.z.word[1], place, x, y);
    GaborMatrix third = gabor_impl_slice(n, n.z.word[2], place, x, y);
    float2 sum = (float2)(0.0);
    float2 slope_x = (float2)(0.0);
    float2 slope_y = (float2)(0.0);
    float2 slope_z = (float2)(0.0);
    float kept = 0.0;
    for (int b = 0; b < 3; ++b) {
        GaborMatrix m = GaborMatrix_of(float3x3(first.real[b], second.real[b], third.real[b]),
                                    float3x3(first.imaginary[b], second.imaginary[b], third.imaginary[b]));
        m = gabor_impl_matrix_product(m, z);
        for (int c = 0; c < 3; ++c) {
            for (int a = 0; a < 3; ++a) {
                float3 aside = float3(float(a - 1), float(b - 1), float(c - 1));
                float3 k = wave + 0.5 * stretch * aside;
                float left = exp(-4.934802 * (dot(k, dx) * dot(k, dx) + dot(k, dy) * dot(k, dy)));
                float2 value = left * float2(m.real[c][a], m.imaginary[c][a]);
                sum += value;
                slope_x += k.x * float2(-value.y, value.x);
                slope_y += k.y * float2(-value.y, value.x);
                slope_z += k.z * float2(-value.y, value.x);
                kept += left * left * exp2(-2.0 * dot(aside, aside));
            }
        }
    }
    float trace = 0.25 * (dot(dx, dx) + dot(dy, dy));
    float determinant = 0.0625 * dot(cross(dx, dy), cross(dx, dy));
    float fade = rsqrt(sqrt(max(1.0 + trace * trace + determinant * (determinant - 2.0), 1.0)));
    float2 base = fade * n.base;
    return GaborField3d_of(gabor_impl_product(base, sum), gabor_impl_product(base, 6.2831853 * slope_x),
                        gabor_impl_product(base, 6.2831853 * slope_y), gabor_impl_product(base, 6.2831853 * slope_z),
                        1.0 - fade * fade * (8.0 / 27.0) * kept);
}

// ---- By place ------------------------------------------------------------------------------------------------------

// (cell + local) / GABOR_RADIUS kernel radii: full precision everywhere in a world of 2^32 cells each way.
GaborPlace3d gabor_place_3d(int3 cell, float3 local) {
    return GaborPlace3d_of(cell, local, (float3)(GABOR_RADIUS), (int3)(0), false, 0.0, false, (float3)(0.0), (float3)(0.0));
}

// A vector of any length from 10^-15 to 10^15 brought to length 1; below it falls to 0.
float3 gabor_impl_unit(float3 v) {
    v = clamp(v, -1.0e15, 1.0e15);
    return v * rsqrt(max(dot(v, v), 1.0e-30));
}

float3 gabor_wave_3d(float frequency, float3 direction) {
    return min(abs(frequency), 1.0e6) * gabor_impl_unit(direction);
}

GaborField3d gabor_field_3d(GaborPlace3d place, float3 wave, uint seed) {
    if (place.filtered)
        return gabor_impl_filtered(place, wave, seed);
    return gabor_impl_windowed(place, wave, seed);
}

// Adds term `index` of a sum of independent noises, with its share of the variance.
void gabor_impl_add_term(inout GaborField3d sum, GaborPlace3d place, float3 wave, uint seed, int index, float power) {
    GaborField3d term = gabor_field_3d(place, wave, gabor_lobe_seed(seed, index));
    sum.value += sqrt(power) * term.value;
    sum.slope_x += sqrt(power) * term.slope_x;
    sum.slope_y += sqrt(power) * term.slope_y;
    sum.slope_z += sqrt(power) * term.slope_z;
    sum.removed += power * term.removed;
}

// Directions evenly along a spiral over half the sphere. Their number is real and the last one has what is left of the
// power, so that all is continuous in frequency.
GaborField3d gabor_isotropic_3d(GaborPlace3d place, float frequency, uint seed) {
    float count = 8.0 + 8.0 * min(frequency * frequency, 64.0);
    GaborField3d sum = GaborField3d_of((float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0), 0.0);
    for (int i = 0; i < int(ceil(count)); ++i) {
        float share = min(count - float(i), 1.0) / count;
        float z = float(i) / count + 0.5 * share;
        float3 direction = float3(sqrt(1.0 - z * z) * gabor_impl_wave(0.61803399 * float(i)), z);
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, i, share);
    }
    return sum;
}

// The power of the first of two sums where it takes over from the second as x goes from `low` to `high`.
float gabor_impl_takeover(float low, float high, float x) {
    float share = smoothstep(low, high, x);
    return share * share / (share * share + (1.0 - share) * (1.0 - share));
}

// Where the surface faces the direction, within 14 to 30 degrees, another one at right angles to it takes over.
GaborField3d gabor_surface_3d(GaborPlace3d place, float3 normal, float frequency, float3 direction, uint seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    float3 other = cross(direction, abs(direction.z) < 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float power = gabor_impl_takeover(0.0625, 0.25, dot(direction, direction));
    GaborField3d sum = GaborField3d_of((float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0), 0.0);
    if (power > 0.0)
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, 0, power);
    if (power < 1.0)
        gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, other), seed, 1, 1.0 - power);
    return sum;
}

// Directions evenly over half a turn from that of the parallel around an axis: z, and near its poles x.
GaborField3d gabor_surface_isotropic_3d(GaborPlace3d place, float3 normal, float frequency, uint seed) {
    normal = gabor_impl_unit(normal);
    float count = 2.0 + 4.5 * min(abs(frequency), 32.0);
    float power = gabor_impl_takeover(0.25, 0.5, dot(normal.xy, normal.xy));
    GaborField3d sum = GaborField3d_of((float2)(0.0), (float2)(0.0), (float2)(0.0), (float2)(0.0), 0.0);
    for (int axis = 0; axis < 2; ++axis) {
        float3 along = gabor_impl_unit(cross(axis == 0 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0), normal));
        for (int i = 0; i < int(ceil(count)) && power > 0.0; ++i) {
            float share = min(count - float(i), 1.0) / count;
            float2 turn = gabor_impl_wave(0.5 * (float(i) / count + 0.5 * share));
            float3 direction = turn.x * along + turn.y * cross(normal, along);
            gabor_impl_add_term(sum, place, gabor_wave_3d(frequency, direction), seed, 256 * axis + i, power * share);
        }
        power = 1.0 - power;
    }
    return sum;
}

// ---- The functions to call -----------------------------------------------------------------------------------------

// gabor_noise_3d with its quadrature, for gabor_phasor: see gabor_noise_complex.
float2 gabor_noise_3d_complex(float3 p, float frequency, float3 direction, uint seed) {
    return gabor_field_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), gabor_wave_3d(frequency, direction), seed).value;
}

// Solid noise at p: mean 0, variance 1 and normal at every place, continuous with its first derivatives.
//   p          position in kernel radii, |p| < 2^31 / R; at 10^5 a float steps by 0.008
//   frequency  cycles per kernel radius; its magnitude is used, up to 10^6
//   direction  of the wave vector, of any length from 10^-15 to 10^15; with 0 its frequency is 0
//   seed       any; each seed is another instance, independent of the others
// Where frequency and direction vary continuously so does the noise; a slope of theirs adds to that of the noise.
float gabor_noise_3d(float3 p, float frequency, float3 direction, uint seed) {
    return gabor_noise_3d_complex(p, frequency, direction, seed).y;
}

// The noise at p and its gradient: (noise, d/dx, d/dy, d/dz), per kernel radius. For bumps take away the part along the
// normal.
float4 gabor_noise_3d_gradient(float3 p, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = gabor_place_3d((int3)(0), p * GABOR_RADIUS);
    GaborField3d field = gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed);
    return float4(field.value.y, field.slope_x.y, field.slope_y.y, field.slope_z.y);
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
    period = max(period, (float3)(0.0009765625));
    float3 nodes = max(floor(period * GABOR_RADIUS + 0.5), (float3)(3.0));
    GaborPlace3d place = gabor_place_3d((int3)(0), (p - floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = (int3)(nodes);
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// Solid noise that evolves in place and is itself again whenever `time` has gone by 1: see gabor_noise_animated.
float gabor_noise_3d_animated(float3 p, float time, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = gabor_place_3d((int3)(0), p * GABOR_RADIUS);
    place.animated = true;
    place.time = time;
    return gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed).value.y;
}

// The noise averaged over a pixel, and the variance that this removes.
//   dx, dy  how far p moves, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// The filter is normal, with a standard deviation of half a pixel. Off by 0.1 % of the noise's deviation where a pixel
// is a tenth of a radius, by 2 % at a third; at a radius by 6 % from frequency 2 up, and by up to 17 % below.
float2 gabor_noise_3d_filtered(float3 p, float3 dx, float3 dy, float frequency, float3 direction, uint seed) {
    GaborPlace3d place = gabor_place_3d((int3)(0), p * GABOR_RADIUS);
    place.filtered = true;
    place.dx = dx;
    place.dy = dy;
    GaborField3d field = gabor_field_3d(place, gabor_wave_3d(frequency, direction), seed);
    return float2(field.value.y, field.removed);
}

// Solid noise along all directions: a sum of 8 + 8 F^2 of them.
float gabor_noise_3d_isotropic(float3 p, float frequency, uint seed) {
    return gabor_isotropic_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), frequency, seed).value.y;
}

// Noise on a surface at its point p, whose normal has any length but 0, its waves along the projection of a direction.
// The frequency is as asked for where the surface is flat; where it is curved the waves of a kernel bend.
float gabor_noise_surface(float3 p, float3 normal, float frequency, float3 direction, uint seed) {
    return gabor_surface_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), normal, frequency, direction, seed).value.y;
}

// Noise on a surface along all directions of its tangent plane: a sum of 2 + 4.5 F, of twice as many between two axes.
float gabor_noise_surface_isotropic(float3 p, float3 normal, float frequency, uint seed) {
    return gabor_surface_isotropic_3d(gabor_place_3d((int3)(0), p * GABOR_RADIUS), normal, frequency, seed).value.y;
}

#endif // GABOR_LATTICE_3D_HLSL

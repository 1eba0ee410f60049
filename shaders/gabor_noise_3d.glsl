// gabor_noise_3d.glsl: Gabor noise in space, and on surfaces without texture coordinates, with mean 0, variance 1 and
// a normal distribution at every point.
//
// Paste or include this file after gabor_noise.glsl and gabor_spectrum.glsl, with GABOR_TAPS 3, the default.
//
//     float n = gabor_noise_3d_isotropic(p, 2.0, 7u);                   // 2 cycles per kernel radius, seed 7
//     float s = gabor_noise_surface_isotropic(p, normal, 2.0, 7u);      // on any mesh
//
// Arguments of all functions, besides those of gabor_noise.glsl:
//     direction  a vector along the wave vector, of any length from 10^-15 to 10^15; (0, 0, 0) gives noise of
//                frequency 0
//     normal     normal of the surface, of any length from 10^-15 to 10^15
//     dx, dy     change of p, in kernel radii, from one pixel to the next along x and y: dFdx(p), dFdy(p)
// All may vary with p; where they are continuous, so is the noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_3D_GLSL
#define GABOR_NOISE_3D_GLSL
#ifndef GABOR_SPECTRUM_GLSL
#error Include gabor_noise.glsl and gabor_spectrum.glsl before gabor_noise_3d.glsl
#elif GABOR_TAPS != 3
#error gabor_noise_3d.glsl needs GABOR_TAPS 3
#endif

// ---- Solid noise with one wave vector ------------------------------------------------------------------------------

// float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed)
// float gabor_noise_3d_tiled(vec3 p, vec3 period, float frequency, vec3 direction, uint seed)
//     The noise, with continuous first derivatives.

// float gabor_noise_3d_animated(vec3 p, float moment, float frequency, vec3 direction, uint seed)
// vec4 gabor_noise_3d_four(vec3 p, float frequency, vec3 direction, uint seed)
// vec2 gabor_noise_3d_complex(vec3 p, float frequency, vec3 direction, uint seed)
//     Like gabor_noise_animated, gabor_noise_four and gabor_noise_complex.

// vec4 gabor_noise_3d_gradient(vec3 p, float frequency, vec3 direction, uint seed)
//     (noise, d/dx, d/dy, d/dz). The derivatives are per kernel radius, for a constant wave vector. For a bump map,
//     subtract the gradient's component along the normal.

// vec2 gabor_noise_3d_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, vec3 direction, uint seed)
//     (noise, removed): the noise averaged over a pixel, and the share of its variance that averaging removed. The
//     error is that of gabor_noise_filtered: 1 % as long as the pixel's longest axis is at most a third of a kernel
//     radius, and 2 % up to a whole radius. The result is continuous in p, dx and dy. On GPUs, a call costs 1.4 times
//     as much as gabor_noise_3d for pixels up to 0.18 kernel radii (27 nodes), 4.2 times from 0.2 (64 nodes), and at
//     most 6.6 times (125 nodes).

// ---- Isotropic solid noise -----------------------------------------------------------------------------------------

// float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed)
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions.

// vec4 gabor_noise_3d_isotropic_gradient(vec3 p, float frequency, uint seed)
//     (noise, d/dx, d/dy, d/dz), per kernel radius.

// vec2 gabor_noise_3d_isotropic_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, uint seed)
//     Like gabor_noise_3d_filtered, at less than twice the cost of gabor_noise_3d_isotropic. The rms error against
//     exactly filtered noise is 2 % of a standard deviation as long as the pixel's longest axis is at most 0.3 kernel
//     radii, and 3 % at 0.4. For larger pixels, only the variance is right.

// ---- Noise on a surface --------------------------------------------------------------------------------------------

// float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed)
//     Noise at point p on a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed)
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ---- For large worlds, and for periods, time and filters combined --------------------------------------------------

// A position in node spacings of the lattice, with a period, a time and a pixel: see GaborPlace.
struct GaborPlace3d {
    ivec3 cell;
    vec3 local;
    vec3 radius;
    ivec3 period;
    bool animated;
    float moment;
    bool filtered; // whether to average over a pixel with sides dx and dy: see gabor_noise_3d_filtered
    vec3 dx;
    vec3 dy;
};

// Noise and quadrature, with their gradients per kernel radius. Unused parts cost nothing.
struct GaborField3d {
    float noise;
    vec3 gradient;
    float quadrature; // in isotropic noise, independent of the noise at each point, but not of the noise's gradient
    vec3 quadrature_gradient;
    float removed; // share of the variance that averaging over the pixel removed
};

// GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local)
//     The position (cell + local) / GABOR_RADIUS, in kernel radii, precise anywhere in a world of 2^32 cells along each
//     axis.

// GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, vec3 direction, uint seed)
// GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, uint seed)
// GaborField3d gabor_field_surface(GaborPlace3d place, vec3 normal, float frequency, vec3 direction, uint seed)
// GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, vec3 normal, float frequency, uint seed)
//     The noises above, for a GaborPlace3d. All noise functions call these four.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

GaborPlace3d gabor_place_3d(ivec3 cell, vec3 local) {
    return GaborPlace3d(cell, local, vec3(GABOR_RADIUS), ivec3(0), false, 0.0, false, vec3(0.0), vec3(0.0));
}

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
vec3 gabor_impl_unit(vec3 v) {
    v = clamp(v, -1.0e15, 1.0e15);
    return v * inversesqrt(max(dot(v, v), 1.0e-30));
}

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// Adds slice k of nodes. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the
// window; `slopes` receives the same part of its derivatives along y and z. The filter adds mixed derivatives, weighted
// by its covariances yz, zx, xy.
void gabor_impl_add_node_slice(inout vec4 sum, inout vec4 slopes, GaborPlace3d place, GaborAxis x, GaborAxis y,
                               GaborAxis z, int k, vec3 mixed) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    vec4 slice, slope;
    gabor_impl_sum(x, y, place.animated, place.moment, slice, slope);
    gabor_impl_add_products(sum, slice, z.node[k].xy);
    slopes += vec4(gabor_impl_product(slope.xy, z.node[k].xy), gabor_impl_product(slice.xy, z.node[k].zw));
    if (place.filtered)
        sum += vec4(gabor_impl_product(mixed.x * slope.xy + mixed.y * slice.zw, z.node[k].zw)
                    + mixed.z * gabor_impl_product(slope.zw, z.node[k].xy), 0.0, 0.0);
}

// The noise of 27 nodes. If the place is filtered, the filter uses three waves along each axis: see
// gabor_spectrum.glsl. K makes E[n^2] = K^2 E[|A|^2] / 2 (sum h^2)^3 = 1. A wave's derivative is the wave times
// 2 pi i F.
GaborField3d gabor_impl_sum_3d(GaborPlace3d place, vec3 wave, GaborMatrix pixel, uint salt) {
    GaborAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, GABOR_RADIUS);
    GaborAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                  GABOR_RADIUS);
    GaborAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                  GABOR_RADIUS);
    vec2 turn = inversesqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY)
              * gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    if (place.filtered) {
        vec3 blurred = gabor_impl_symmetric_3d(pixel, wave);
        gabor_impl_filter(x, pixel.diagonal.x, blurred.x);
        gabor_impl_filter(y, pixel.diagonal.y, blurred.y);
        gabor_impl_filter(z, pixel.diagonal.z, blurred.z);
        turn *= exp(-19.739209 * max(dot(wave, blurred), 0.0));
    }
    vec4 sum = vec4(0.0), slopes = vec4(0.0);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 0, pixel.mixed);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 1, pixel.mixed);
    gabor_impl_add_node_slice(sum, slopes, place, x, y, z, 2, pixel.mixed);
    sum = vec4(gabor_impl_product(sum.xy, turn), gabor_impl_product(sum.zw, turn));
    slopes = vec4(gabor_impl_product(slopes.xy, turn), gabor_impl_product(slopes.zw, turn));
    return GaborField3d(sum.y, vec3(sum.w, slopes.y, slopes.w) + 6.2831853 * sum.x * wave,
                        sum.x, vec3(sum.z, slopes.x, slopes.z) - 6.2831853 * sum.y * wave, 0.0);
}

// Adds a field times an amplitude. A kernel radius is `stretch` times the field's unit of length.
void gabor_impl_add_field_3d(inout GaborField3d sum, GaborField3d field, float amplitude, vec3 stretch) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * stretch * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
}

// The perpendicular axes of a pixel, each twice as long as the filter's standard deviation along it: in kernel radii
// for isotropic noise, otherwise in units of GABOR_RADIUS node spacings.
struct GaborPixelAxes {
    vec3 major;
    vec3 minor;
};

GaborPixelAxes gabor_impl_pixel(GaborPlace3d place, vec3 stretch) {
    vec3 dx = clamp(place.dx, -1.0e6, 1.0e6) * stretch;
    vec3 dy = clamp(place.dy, -1.0e6, 1.0e6) * stretch;
    vec2 twice = vec2(dot(dx, dx) - dot(dy, dy), 2.0 * dot(dx, dy)); // at twice the angle of `turn`
    float cosine = twice.x / max(length(twice), 1.0e-30);
    vec2 turn = sqrt(max(0.5 + vec2(0.5, -0.5) * cosine, 0.0));
    if (twice.y < 0.0) turn.y = -turn.y;
    return GaborPixelAxes(turn.x * dx + turn.y * dy, turn.x * dy - turn.y * dx);
}

// Limits the length of each axis to `most`.
GaborPixelAxes gabor_impl_resolved(GaborPixelAxes pixel, float most) {
    return GaborPixelAxes(most * inversesqrt(max(dot(pixel.major, pixel.major), most * most)) * pixel.major,
                      most * inversesqrt(max(dot(pixel.minor, pixel.minor), most * most)) * pixel.minor);
}

GaborMatrix gabor_impl_covariance(GaborPixelAxes pixel) {
    vec3 major = 0.5 * pixel.major, minor = 0.5 * pixel.minor;
    return GaborMatrix(major * major + minor * minor, major.yzx * major.zxy + minor.yzx * minor.zxy);
}

// 1 + 2/3 pi^2 S along each axis of a pixel, where S is the filter's variance: see gabor_impl_transmitted.
vec2 gabor_impl_spread(GaborPixelAxes pixel) {
    return 1.0 + 1.6449341 * vec2(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor));
}

// The share of a lobe's variance that a pixel's filter keeps.
float gabor_impl_transmitted_3d(vec3 wave, GaborPixelAxes pixel) {
    vec2 d = gabor_impl_spread(pixel);
    vec2 k = vec2(dot(wave, pixel.major), dot(wave, pixel.minor));
    return exp(-min(9.8696044 * dot(k * k, 1.0 / d), 80.0)) * inversesqrt(d.x * d.y);
}

// With periods, nodes are not 1 / GABOR_RADIUS kernel radii apart, so all lengths here are in units of GABOR_RADIUS
// node spacings.
GaborField3d gabor_field_3d(GaborPlace3d place, float frequency, vec3 direction, uint seed) {
    vec3 stretch = place.radius / GABOR_RADIUS;
    vec3 wave = min(abs(frequency), 1.0e6) * gabor_impl_unit(direction) / stretch;
    uint salt = gabor_impl_salt(seed);
    float amplitude = 1.0, transmitted = 1.0, wide = 0.0;
    GaborMatrix pixel = GaborMatrix(vec3(0.0), vec3(0.0));
    if (place.filtered) {
        GaborPixelAxes whole = gabor_impl_pixel(place, stretch), resolved = gabor_impl_resolved(whole, 1.0);
        transmitted = gabor_impl_transmitted_3d(wave, whole);
        amplitude = sqrt(transmitted / gabor_impl_transmitted_3d(wave, resolved));
        if (!(transmitted > 1.0e-10)) transmitted = 0.0; // also if it is NaN
        pixel = gabor_impl_covariance(resolved);
        vec3 variance = pixel.diagonal;
        wide = clamp(100.0 * sqrt(max(max(variance.x, variance.y), variance.z)) - 9.0, 0.0, 1.0);
    }
    GaborField3d sum = GaborField3d(0.0, vec3(0.0), 0.0, vec3(0.0), 1.0 - transmitted);
    if (transmitted == 0.0)
        return sum;
    if (wide < 1.0)
        gabor_impl_add_field_3d(sum, gabor_impl_sum_3d(place, wave, pixel, salt), (1.0 - wide) * amplitude, stretch);
    if (wide > 0.0) {
        vec4 noise, quadrature;
        gabor_impl_filtered_space(place.cell, place.local, place.period, place.animated, place.moment, wave, pixel,
                                  wide > 0.0, salt, noise, quadrature);
        gabor_impl_add_field_3d(sum, GaborField3d(noise.x, noise.yzw, quadrature.x, quadrature.yzw, 0.0),
                                wide * amplitude, stretch);
    }
    return sum;
}

// Adds one of two independent noises, which replaces the other as x goes from 0 to 1.
void gabor_impl_add_share_3d(inout GaborField3d sum, GaborField3d term, float x) {
    float power = gabor_impl_takeover(x);
    gabor_impl_add_field_3d(sum, term, sqrt(power), vec3(1.0));
    sum.removed += power * term.removed;
}

GaborField3d gabor_field_surface(GaborPlace3d place, vec3 normal, float frequency, vec3 direction, uint seed) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    vec3 other = cross(direction, abs(direction.z) < 0.7 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float flat_length = dot(direction, direction);
    GaborField3d sum = GaborField3d(0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    for (int i = flat_length > 0.0625 ? 0 : 1; i < (flat_length < 0.25 ? 2 : 1); ++i)
        gabor_impl_add_share_3d(sum,
                                gabor_field_3d(place, frequency, i == 0 ? direction : other, gabor_lobe_seed(seed, i)),
                                i == 0 ? smoothstep(0.0625, 0.25, flat_length)
                                       : smoothstep(-0.25, -0.0625, -flat_length));
    return sum;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three perpendicular unit vectors u_cm, turned at random, each with its own amplitude:
//     n(p) = K Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with the constant variance K^2 E[|A|^2] / 2 sum_c 3 h_c^2. The gradient is
// independent of the value and has the constant covariance K^2 E[|A|^2] / 2 sum_c (3 grad h grad h^T + 4 pi^2 F^2 h^2
// I), because sum_m u_cm u_cm^T is the identity I. Since none of this depends on the directions, both are also normal
// over random directions. On a surface there are two tangent vectors, and the same holds for the value and its
// derivatives along the surface.

// Adds a wave of a node; x, y and z come from gabor_impl_node. `wave` is the wave vector and, in w, the turns from the
// node to the point. The filter (see gabor_spectrum.glsl) multiplies the wave by exp(-2 pi^2 F.S F). With s = 2 pi^2
// S F, it shifts the window along each axis by i s / pi, to middle + cosh s cosine + i sinh s sine / pi.
void gabor_impl_add_node_wave_3d(inout GaborField3d sum, vec4 x, vec4 y, vec4 z, vec4 wave, GaborPlace3d place,
                                 GaborMatrix pixel, uint word) {
    vec2 a = gabor_impl_product(gabor_impl_amplitude_at(word, place.animated, place.moment), gabor_impl_wave(wave.w));
    vec3 middle = vec3(x.y, y.y, z.y), cosine = vec3(x.z, y.z, z.z), sine = vec3(x.w, y.w, z.w);
    vec3 h = middle + cosine, slope = sine * (h.yzx * h.zxy), turned = vec3(0.0);
    vec2 value = h.x * (h.y * h.z) * a;
    if (place.filtered) {
        vec3 s = 19.739209 * gabor_impl_symmetric_3d(pixel, wave.xyz);
        a *= exp(-max(dot(wave.xyz, s), 0.0));
        s = clamp(s, -3.0, 3.0); // changes no wave that the filter keeps
        vec3 r = s * s, even = 1.0 + r * (0.5 + 0.041666667 * r);
        vec3 odd = s * (1.0 + r * (0.16666667 + 0.0083333333 * r));
        float mixed = dot(pixel.mixed, sine.yzx * sine.zxy * h);
        h = middle + even * cosine;
        vec3 i_h = 0.31830989 * odd * sine, i_slope = -3.1415927 * odd * cosine;
        vec3 real = h.yzx * h.zxy - i_h.yzx * i_h.zxy, imaginary = h.yzx * i_h.zxy + i_h.yzx * h.zxy;
        value = vec2(h.x * real.x - i_h.x * imaginary.x + mixed, h.x * imaginary.x + i_h.x * real.x);
        value = gabor_impl_product(value, a);
        slope = even * sine * real - i_slope * imaginary;
        turned = even * sine * imaginary + i_slope * real;
    }
    sum.noise += value.y;
    sum.gradient += slope * a.y + turned * a.x + 6.2831853 * value.x * wave.xyz;
    sum.quadrature += value.x;
    sum.quadrature_gradient += slope * a.x - turned * a.y - 6.2831853 * value.y * wave.xyz;
}

// The directions of isotropic noise: all or, if `only`, those in the tangent plane that two perpendicular unit vectors
// span.
struct GaborTangents {
    bool only;
    vec3 along;
    vec3 across;
};

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions. A wave
// along -u is also a wave along u, so turning the first vector within half a circle reaches every direction of a
// surface. In space, the first vector also tilts along z, and the other two turn around it within a quarter circle.
void gabor_impl_add_node_waves_3d(inout GaborField3d sum, vec4 x, vec4 y, vec4 z, GaborPlace3d place, GaborMatrix pixel,
                                  vec3 scale, GaborTangents tangents, uint column, uvec4 row) {
    uint word = column * row.w;
    vec2 turn = gabor_impl_half_turn(1.1641532e-10 * float(int(word)));
    vec3 first = turn.x * tangents.along + turn.y * tangents.across;
    vec3 second = turn.x * tangents.across - turn.y * tangents.along;
    vec3 d = scale * vec3(x.x, y.x, z.x);
    vec4 u = vec4(first, dot(first, d)), v = vec4(second, dot(second, d)), w = vec4(0.0, 0.0, 1.0, d.z);
    if (!tangents.only) {
        float rise = 4.6566129e-10 * float(int(word << 12u)), level = sqrt(max(1.0 - rise * rise, 0.0));
        vec2 spin = gabor_impl_half_turn(5.8207661e-11 * float(int(word << 20u)));
        vec4 across = v, lifted = level * w - rise * u;
        u = level * u + rise * w;
        v = spin.x * across + spin.y * lifted;
        w = spin.x * lifted - spin.y * across;
    }
    vec4 unit = vec4(scale, 1.0);
    gabor_impl_add_node_wave_3d(sum, x, y, z, unit * u, place, pixel, column * row.x);
    gabor_impl_add_node_wave_3d(sum, x, y, z, unit * v, place, pixel, column * row.y);
    if (!tangents.only) gabor_impl_add_node_wave_3d(sum, x, y, z, unit * w, place, pixel, column * row.z);
}

// (d, middle, cosine, sine) of a node on an axis: the point's offset d from the node; the parts of the window,
// middle = 1/2 and cosine = cos(pi d) / 2; and the window's derivative, sine = -pi / 2 sin(pi d). Filtered windows fade
// out within half a standard deviation of their ends.
vec4 gabor_impl_node(float offset, vec4 node, float variance) {
    offset /= GABOR_RADIUS;
    float fade = 1.0, fall = 1.0;
    if (variance > 0.0) {
        fade = clamp((1.0 - abs(offset)) / clamp(0.5 * sqrt(variance), 0.001, 0.05), 0.0, 1.0);
        fade *= fade * (3.0 - 2.0 * fade);
        fall = fade * exp(-4.934802 * variance);
    }
    return vec4(offset, 0.5 * fade, fall * (node.x - 0.5), fall * node.z);
}

GaborAxis gabor_impl_nodes(int cell, float local, int period, uint salt, float variance) {
    GaborAxis axis = gabor_impl_axis(cell, local, period, salt, 0.0, GABOR_RADIUS);
    axis.node[0] = gabor_impl_node(axis.offset + 1.0, axis.node[0], variance);
    axis.node[1] = gabor_impl_node(axis.offset, axis.node[1], variance);
    axis.node[2] = gabor_impl_node(axis.offset - 1.0, axis.node[2], variance);
    return axis;
}

// The sum over 27 nodes, without the factor K.
GaborField3d gabor_impl_sum_isotropic(GaborPlace3d place, GaborMatrix pixel, vec3 scale, GaborTangents tangents,
                                      uint salt) {
    vec3 s = pixel.diagonal;
    GaborAxis x = gabor_impl_nodes(place.cell.x, place.local.x, place.period.x, salt, s.x);
    GaborAxis y = gabor_impl_nodes(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, s.y);
    GaborAxis z = gabor_impl_nodes(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, s.z);
    GaborField3d sum = GaborField3d(0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    for (int i = 0; i < 9; ++i) {
        int j = i % 3;
        vec4 y_j = j == 0 ? y.node[0] : j == 1 ? y.node[1] : y.node[2];
        vec4 z_k = i < 3 ? z.node[0] : i < 6 ? z.node[1] : z.node[2];
        uint word = (j == 0 ? y.word[0] : j == 1 ? y.word[1] : y.word[2])
                  * (i < 3 ? z.word[0] : i < 6 ? z.word[1] : z.word[2]);
        uvec4 row = gabor_impl_row(word);
        gabor_impl_add_node_waves_3d(sum, x.node[0], y_j, z_k, place, pixel, scale, tangents, x.word[0], row);
        gabor_impl_add_node_waves_3d(sum, x.node[1], y_j, z_k, place, pixel, scale, tangents, x.word[1], row);
        gabor_impl_add_node_waves_3d(sum, x.node[2], y_j, z_k, place, pixel, scale, tangents, x.word[2], row);
    }
    return sum;
}

// The share of isotropic noise's variance that a filter keeps, within 0.008: the mean over all directions u of a lobe's
// share, exp(-q_1 u_1^2 - q_2 u_2^2) / sqrt(d_1 d_2). Along each axis of the pixel, q = 4 pi^2 F^2 S / d with d from
// gabor_impl_spread. If q_1 is the larger, the mean of the exponential over the sphere is nearly the mean of
// exp(-q_1 u_1^2) times gabor_impl_mean_angle((1 - E[u_1^2]) q_2), where E weights directions by exp(-q_1 u_1^2).
float gabor_impl_transmitted_isotropic(float frequency, GaborPixelAxes pixel, GaborTangents tangents) {
    vec2 d = gabor_impl_spread(pixel);
    vec2 unit = min(9.8696044 * frequency * frequency, 1.0e6) / d;
    float mean;
    if (tangents.only) {
        vec2 a = vec2(dot(tangents.along, pixel.major), dot(tangents.along, pixel.minor));
        vec2 b = vec2(dot(tangents.across, pixel.major), dot(tangents.across, pixel.minor));
        float sum = dot(unit, a * a + b * b), apart = length(vec2(dot(unit, a * a - b * b), 2.0 * dot(unit, a * b)));
        mean = exp(min(0.5 * (apart - sum), 0.0)) * gabor_impl_mean_angle(apart);
    } else {
        vec2 q = unit * vec2(dot(pixel.major, pixel.major), dot(pixel.minor, pixel.minor));
        float larger = max(q.x, q.y), smaller = min(q.x, q.y);
        mean = sqrt((1.0 + larger * (0.31500545 + 0.08868891 * larger))
                    / (1.0 + larger * (0.98167212 + larger * (0.42128292 + 0.11292425 * larger))));
        mean *= gabor_impl_mean_angle(smaller * (1.0 - 1.0 / (3.0 + 0.8 * larger)));
    }
    return mean * inversesqrt(d.x * d.y);
}

GaborField3d gabor_impl_isotropic(GaborPlace3d place, float frequency, GaborTangents tangents, uint seed) {
    vec3 stretch = place.radius / GABOR_RADIUS;
    frequency = min(abs(frequency), 1.0e6);
    float amplitude = inversesqrt((tangents.only ? 2.0 : 3.0) * GABOR_IMPL_ENERGY)
                    / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    float transmitted = 1.0;
    GaborMatrix pixel = GaborMatrix(vec3(0.0), vec3(0.0));
    if (place.filtered) {
        GaborPixelAxes whole = gabor_impl_pixel(place, vec3(1.0)), resolved = gabor_impl_resolved(whole, 0.5);
        transmitted = gabor_impl_transmitted_isotropic(frequency, whole, tangents);
        amplitude *= sqrt(transmitted / gabor_impl_transmitted_isotropic(frequency, resolved, tangents));
        pixel = gabor_impl_covariance(GaborPixelAxes(resolved.major * stretch, resolved.minor * stretch));
        if (!(transmitted > 1.0e-10)) transmitted = 0.0; // also if it is NaN
    }
    GaborField3d sum = GaborField3d(0.0, vec3(0.0), 0.0, vec3(0.0), 1.0 - transmitted);
    if (transmitted > 0.0)
        gabor_impl_add_field_3d(sum, gabor_impl_sum_isotropic(place, pixel, frequency / stretch, tangents,
                                                              gabor_impl_salt(seed)), amplitude, stretch);
    return sum;
}

GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, uint seed) {
    return gabor_impl_isotropic(place, frequency, GaborTangents(false, vec3(1.0, 0.0, 0.0), vec3(0.0, 1.0, 0.0)), seed);
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, vec3 normal, float frequency, uint seed) {
    normal = gabor_impl_unit(normal);
    float aside = dot(normal.xy, normal.xy); // squared sine of the normal's angle to the z axis
    GaborField3d sum = GaborField3d(0.0, vec3(0.0), 0.0, vec3(0.0), 0.0);
    for (int i = aside > 0.25 ? 0 : 1; i < (aside < 0.5 ? 2 : 1); ++i) {
        vec3 along = gabor_impl_unit(cross(i == 0 ? vec3(0.0, 0.0, 1.0) : vec3(1.0, 0.0, 0.0), normal));
        GaborField3d term = gabor_impl_isotropic(place, frequency, GaborTangents(true, along, cross(normal, along)),
                                                 gabor_lobe_seed(seed, i));
        gabor_impl_add_share_3d(sum, term, i == 0 ? smoothstep(0.25, 0.5, aside) : smoothstep(-0.5, -0.25, -aside));
    }
    return sum;
}

// ---- Functions of a position ---------------------------------------------------------------------------------------

float gabor_noise_3d(vec3 p, float frequency, vec3 direction, uint seed) {
    return gabor_field_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, direction, seed).noise;
}

vec4 gabor_noise_3d_gradient(vec3 p, float frequency, vec3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return vec4(field.noise, field.gradient);
}

vec2 gabor_noise_3d_complex(vec3 p, float frequency, vec3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, direction, seed);
    return vec2(field.quadrature, field.noise);
}

vec4 gabor_noise_3d_four(vec3 p, float frequency, vec3 direction, uint seed) {
    return vec4(gabor_noise_3d(p, frequency, direction, seed),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -1)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -2)),
                gabor_noise_3d(p, frequency, direction, gabor_lobe_seed(seed, -3)));
}

float gabor_noise_3d_tiled(vec3 p, vec3 period, float frequency, vec3 direction, uint seed) {
    period = clamp(period, 0.0009765625, 1.0e9);
    vec3 nodes = max(floor(period * GABOR_RADIUS + 0.5), vec3(3.0));
    GaborPlace3d place = gabor_place_3d(ivec3(0), (p - floor(p / period) * period) * (nodes / period));
    place.radius = nodes / period;
    place.period = ivec3(nodes);
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

float gabor_noise_3d_animated(vec3 p, float moment, float frequency, vec3 direction, uint seed) {
    GaborPlace3d place = gabor_place_3d(ivec3(0), p * GABOR_RADIUS);
    place.animated = true;
    place.moment = moment;
    return gabor_field_3d(place, frequency, direction, seed).noise;
}

GaborPlace3d gabor_impl_place_of_pixel(vec3 p, vec3 dx, vec3 dy) {
    return GaborPlace3d(ivec3(0), p * GABOR_RADIUS, vec3(GABOR_RADIUS), ivec3(0), false, 0.0, true, dx, dy);
}

vec2 gabor_noise_3d_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, vec3 direction, uint seed) {
    GaborField3d field = gabor_field_3d(gabor_impl_place_of_pixel(p, dx, dy), frequency, direction, seed);
    return vec2(field.noise, field.removed);
}

float gabor_noise_3d_isotropic(vec3 p, float frequency, uint seed) {
    return gabor_field_3d_isotropic(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, seed).noise;
}

vec4 gabor_noise_3d_isotropic_gradient(vec3 p, float frequency, uint seed) {
    GaborField3d field = gabor_field_3d_isotropic(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), frequency, seed);
    return vec4(field.noise, field.gradient);
}

vec2 gabor_noise_3d_isotropic_filtered(vec3 p, vec3 dx, vec3 dy, float frequency, uint seed) {
    GaborField3d field = gabor_field_3d_isotropic(gabor_impl_place_of_pixel(p, dx, dy), frequency, seed);
    return vec2(field.noise, field.removed);
}

float gabor_noise_surface(vec3 p, vec3 normal, float frequency, vec3 direction, uint seed) {
    return gabor_field_surface(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, direction, seed).noise;
}

float gabor_noise_surface_isotropic(vec3 p, vec3 normal, float frequency, uint seed) {
    return gabor_field_surface_isotropic(gabor_place_3d(ivec3(0), p * GABOR_RADIUS), normal, frequency, seed).noise;
}

#endif // GABOR_NOISE_3D_GLSL

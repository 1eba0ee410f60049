// Generated from gabor_noise_3d.glsl by tools/translate, for HLSL, shader model 5.0 and up: change that file, not this one.
// Includes gabor_noise.hlsl; pasted after their texts, it includes nothing.
//
// gabor_noise_3d.hlsl: Gabor noise in 3D, and on surfaces without texture coordinates, with mean 0, variance 1 and a
// normal distribution at every point.
//
//     float n = gabor_noise_3d_isotropic(p, 2.0, 7u);   // 2 cycles per kernel radius, seed 7
//
//     I want                                   call
//     noise in a volume                        gabor_noise_3d
//     the same without a direction             gabor_noise_3d_isotropic
//     noise along a direction on any mesh      gabor_noise_surface
//     the same without a direction             gabor_field_surface_isotropic
//     derivatives, periods, an evolution       a place, then gabor_field_3d and so on
//     noise averaged over a pixel              gabor_filter_3d.hlsl
//
// Arguments of all functions, besides those of gabor_noise.hlsl:
//     direction  a vector along the wave vector, of any length from 10^-15 to 10^15; (0, 0, 0) gives noise of
//                frequency 0
//     normal     normal of the surface, of any length from 10^-15 to 10^15
// All may vary with p; where they are continuous, so is the noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_HLSL
#include "gabor_noise.hlsl"
#endif
#ifndef GABOR_NOISE_3D_HLSL
#define GABOR_NOISE_3D_HLSL 1
#ifndef GABOR_NOISE_HLSL
#error Include gabor_noise.hlsl before gabor_noise_3d.hlsl
#elif GABOR_TAPS != 3
#error gabor_noise_3d.hlsl needs GABOR_TAPS 3
#endif

// A noise, its quadrature, and their gradients per kernel radius: see GaborField. For a bump map, subtract the
// gradient's component along the normal.
struct GaborField3d {
    float noise;
    float3 gradient;
    float quadrature;
    float3 quadrature_gradient;
    float removed;
};

GaborField3d GaborField3d_of(float noise, float3 gradient, float quadrature, float3 quadrature_gradient, float removed)
        {
    GaborField3d made = {noise, gradient, quadrature, quadrature_gradient, removed};
    return made;
}

// float gabor_noise_3d(float3 p, float frequency, float3 direction, uint seed)
// GaborField3d gabor_field_3d(GaborPlace3d place, float3 wave, uint seed)
//     Noise with one wave vector, and continuous first derivatives.

// float gabor_noise_3d_isotropic(float3 p, float frequency, uint seed)
// GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, uint seed)
//     Noise of waves in all directions, at the same cost for every frequency: about seven times that of gabor_noise_3d.
//     Value and gradient are normal, with the same variance at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Second derivatives, and values at several points
//     together, follow mixtures of normal distributions. At each point the quadrature is independent of the noise, but
//     not of the noise's gradient.

// float gabor_noise_surface(float3 p, float3 normal, float frequency, float3 direction, uint seed)
// GaborField3d gabor_field_surface(GaborPlace3d place, float3 normal, float frequency, float3 direction, uint seed)
//     Noise at a point of a surface, with waves along the projection of a direction onto the tangent plane. As the
//     angle between direction and normal falls from 30 to 14 degrees, a second noise, whose direction is perpendicular
//     to the given one, takes over; in between, both are computed. On a curved surface, waves bend within each kernel.

// GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, float3 normal, float frequency, uint seed)
//     Noise of waves along all tangents, at the same cost for every frequency: about five times that of gabor_noise_3d,
//     and about ten times where the normal is 30 to 45 degrees from the z axis. Value and derivatives along the surface
//     have the distributions of gabor_noise_3d_isotropic.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// Scales a vector to length 1 if its length is 10^-15 to 10^15; shorter vectors approach 0.
float3 gabor_impl_unit(float3 v) {
    v = clamp(v, -1.0e15, 1.0e15);
    return v * rsqrt(max(dot(v, v), 1.0e-30));
}

// Adds an independent noise to a sum. A unit of length of the sum is `stretch` times the noise's.
void gabor_impl_add_field_3d(inout GaborField3d sum, GaborField3d field, float amplitude, float3 stretch) {
    sum.noise += amplitude * field.noise;
    sum.gradient += amplitude * stretch * field.gradient;
    sum.quadrature += amplitude * field.quadrature;
    sum.quadrature_gradient += amplitude * stretch * field.quadrature_gradient;
    sum.removed += amplitude * amplitude * field.removed;
}

// ---- One wave vector -----------------------------------------------------------------------------------------------
//
// As in the plane, the nodes c of a lattice with R = 3/2 nodes per kernel radius emit waves under Hann's windows h,
// with independent normal amplitudes A. The windows of the nearest node and its 26 neighbours reach a point:
//     n(p) = K Im sum_c A_c h(x - c_x) h(y - c_y) h(z - c_z) exp(2 pi i F.(p - c)),   sum h^2 = 9/8 along each axis.
// The variance is 1 at every point for any wave vector F. So F may follow a surface, which then shows the requested
// frequency and no trace of the lattice.

// Sums slice k of nodes, as gabor_impl_sum does.
void gabor_impl_sum_slice(GaborImplAxis x, GaborImplAxis y, GaborImplAxis z, int k, float evolution, out float4 sum,
                          out float4 slope) {
    for (int j = 0; j < 3; ++j)
        y.word[j] = gabor_impl_slice_word(y.word[j], z.word[k]);
    gabor_impl_sum(x, y, evolution, sum, slope);
}

// Adds slice k. `sum` receives the noise and, in zw, the part of its derivative along x that comes from the window;
// `slopes` receives the same part of its derivatives along y and z.
void gabor_impl_add_slice(inout float4 sum, inout float4 slopes, GaborImplAxis x, GaborImplAxis y, GaborImplAxis z, int k,
                          float evolution) {
    float4 slice, slope;
    gabor_impl_sum_slice(x, y, z, k, evolution, slice, slope);
    gabor_impl_add_products(sum, slice, z.node[k].xy);
    slopes += float4(gabor_impl_product(slope.xy, z.node[k].xy), gabor_impl_product(slice.xy, z.node[k].zw));
}

// Multiplies the sums by K and by the wave at the point, as gabor_impl_field does: K makes E[n^2] = K^2 E[|A|^2] / 2
// (sum h^2)^3 = 1.
GaborField3d gabor_impl_field_3d(float4 sum, float4 slopes, float2 turn, float3 wave) {
    turn *= rsqrt(GABOR_IMPL_ENERGY) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    sum = float4(gabor_impl_product(sum.xy, turn), gabor_impl_product(sum.zw, turn));
    slopes = float4(gabor_impl_product(slopes.xy, turn), gabor_impl_product(slopes.zw, turn));
    // 6.2831853 is 2 pi
    return GaborField3d_of(sum.y, float3(sum.w, slopes.y, slopes.w) + 6.2831853 * sum.x * wave,
                        sum.x, float3(sum.z, slopes.x, slopes.z) - 6.2831853 * sum.y * wave, 0.0);
}

// With periods, nodes are not 1 / GABOR_CELLS_PER_RADIUS kernel radii apart, so all lengths here are in units of
// GABOR_CELLS_PER_RADIUS node spacings.
GaborField3d gabor_field_3d(GaborPlace3d place, float3 wave, uint seed) {
    float3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = clamp(wave, -1.0e6, 1.0e6) / stretch;
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                      GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, wave.z,
                                      GABOR_CELLS_PER_RADIUS);
    float2 turn = gabor_impl_wave(x.turns * x.offset + y.turns * y.offset + z.turns * z.offset);
    float4 sum = (float4)(0.0), slopes = (float4)(0.0);
    gabor_impl_add_slice(sum, slopes, x, y, z, 0, place.evolution);
    gabor_impl_add_slice(sum, slopes, x, y, z, 1, place.evolution);
    gabor_impl_add_slice(sum, slopes, x, y, z, 2, place.evolution);
    GaborField3d field = gabor_impl_field_3d(sum, slopes, turn, wave);
    field.gradient *= stretch;
    field.quadrature_gradient *= stretch;
    return field;
}

float gabor_noise_3d(float3 p, float frequency, float3 direction, uint seed) {
    return gabor_field_3d(gabor_place_3d_at(p), abs(frequency) * gabor_impl_unit(direction), seed).noise;
}

// The two directions that share a surface's noise: the projections of a direction, and of one perpendicular to it, onto
// the tangent plane. `second` is 0 where the first has all the power, and 1 where the other has.
struct GaborImplSurface {
    float3 direction;
    float3 other;
    float second;
};

GaborImplSurface GaborImplSurface_of(float3 direction, float3 other, float second) {
    GaborImplSurface made = {direction, other, second};
    return made;
}

GaborImplSurface gabor_impl_surface(float3 normal, float3 direction) {
    normal = gabor_impl_unit(normal);
    direction = gabor_impl_unit(direction);
    float3 other = cross(direction, abs(direction.z) < 0.7 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0));
    direction -= dot(direction, normal) * normal;
    other -= dot(other, normal) * normal;
    float second = 1.0 - smoothstep(0.0625, 0.25, dot(direction, direction));
    return GaborImplSurface_of(gabor_impl_unit(direction), gabor_impl_unit(other), second);
}

GaborField3d gabor_field_surface(GaborPlace3d place, float3 normal, float frequency, float3 direction, uint seed) {
    GaborImplSurface surface = gabor_impl_surface(normal, direction);
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = surface.second < 1.0 ? 0 : 1; i < (surface.second > 0.0 ? 2 : 1); ++i) {
        float3 wave = abs(frequency) * (i == 0 ? surface.direction : surface.other);
        float power = gabor_impl_takeover(i == 0 ? 1.0 - surface.second : surface.second);
        gabor_impl_add_field_3d(sum, gabor_field_3d(place, wave, gabor_derived_seed(seed, i)), sqrt(power), (float3)(1.0));
    }
    return sum;
}

float gabor_noise_surface(float3 p, float3 normal, float frequency, float3 direction, uint seed) {
    return gabor_field_surface(gabor_place_3d_at(p), normal, frequency, direction, seed).noise;
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

// The directions of isotropic noise: all or, if `only`, those in the tangent plane that two perpendicular unit vectors
// span.
struct GaborImplTangents {
    bool only;
    float3 along;
    float3 across;
};

GaborImplTangents GaborImplTangents_of(bool only, float3 along, float3 across) {
    GaborImplTangents made = {only, along, across};
    return made;
}

GaborImplTangents gabor_impl_all_directions() {
    return GaborImplTangents_of(false, float3(1.0, 0.0, 0.0), float3(0.0, 1.0, 0.0));
}

// Directions in the tangent plane are measured from the circle of latitude around the z axis or, where the normal is
// near that axis, around the x axis.
GaborImplTangents gabor_impl_tangents(float3 normal, int axis) {
    float3 along = gabor_impl_unit(cross(axis == 0 ? float3(0.0, 0.0, 1.0) : float3(1.0, 0.0, 0.0), normal));
    return GaborImplTangents_of(true, along, cross(normal, along));
}

// The waves of a node: unit wave vectors and, in w, the point's offset from the node along them.
struct GaborImplStar3d {
    float4 first;
    float4 second;
    float4 third;
};

GaborImplStar3d GaborImplStar3d_of(float4 first, float4 second, float4 third) {
    GaborImplStar3d made = {first, second, third};
    return made;
}

// A node's word gives the directions. A wave along -u is also a wave along u, so turning the first vector within half a
// circle reaches every direction of a surface. In 3D, the first vector also tilts along z, and the other two turn
// around it within a quarter circle.
GaborImplStar3d gabor_impl_star_3d(GaborImplTangents tangents, float3 d, uint word) {
    float2 turn = gabor_impl_half_turn(1.1641532e-10 * float(int(word))); // 2^-33
    float3 first = turn.x * tangents.along + turn.y * tangents.across;
    float3 second = turn.x * tangents.across - turn.y * tangents.along;
    float4 u = float4(first, dot(first, d)), v = float4(second, dot(second, d)), w = float4(0.0, 0.0, 1.0, d.z);
    if (!tangents.only) {
        float rise = 4.6566129e-10 * float(int(word << 12u)), level = sqrt(max(1.0 - rise * rise, 0.0)); // 2^-31
        float2 spin = gabor_impl_half_turn(5.8207661e-11 * float(int(word << 20u))); // 2^-34
        float4 across = v, lifted = level * w - rise * u;
        u = level * u + rise * w;
        v = spin.x * across + spin.y * lifted;
        w = spin.x * lifted - spin.y * across;
    }
    return GaborImplStar3d_of(u, v, w);
}

// Adds a wave of a node with this window: (derivatives, value). `wave` is the wave vector and, in w, the turns from the
// node to the point.
void gabor_impl_add_wave_3d(inout GaborField3d sum, float4 window, float4 wave, float evolution, uint word) {
    float2 a = gabor_impl_product(gabor_impl_amplitude_at(word, evolution), gabor_impl_wave(wave.w));
    float2 value = window.w * a;
    sum.noise += value.y;
    sum.gradient += a.y * window.xyz + 6.2831853 * value.x * wave.xyz; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += a.x * window.xyz - 6.2831853 * value.y * wave.xyz;
}

// A node on an axis, with its window and the window's derivative.
struct GaborImplNode {
    float offset; // offset of the point from the node
    float value;
    float slope;
};

GaborImplNode GaborImplNode_of(float offset, float value, float slope) {
    GaborImplNode made = {offset, value, slope};
    return made;
}

GaborImplNode gabor_impl_node(GaborImplAxis axis, int i) {
    float4 node = i == 0 ? axis.node[0] : i == 1 ? axis.node[1] : axis.node[2];
    return GaborImplNode_of((axis.offset + 1.0 - float(i)) / GABOR_CELLS_PER_RADIUS, node.x, node.z);
}

uint gabor_impl_node_word(GaborImplAxis axis, int i) {
    return i == 0 ? axis.word[0] : i == 1 ? axis.word[1] : axis.word[2];
}

// Adds a node's waves. The words of its row times the word of its column give the amplitudes and the directions.
// `scale`: the frequency along each axis.
void gabor_impl_add_node_waves_3d(inout GaborField3d sum, GaborImplNode x, GaborImplNode y, GaborImplNode z, float3 scale,
                                  float evolution, GaborImplTangents tangents, uint column, uint4 row) {
    float3 d = scale * float3(x.offset, y.offset, z.offset);
    GaborImplStar3d star = gabor_impl_star_3d(tangents, d, column * row.w);
    float4 window = float4(x.slope * (y.value * z.value), x.value * (y.slope * z.value), x.value * (y.value * z.slope),
                       x.value * (y.value * z.value));
    float4 unit = float4(scale, 1.0);
    gabor_impl_add_wave_3d(sum, window, unit * star.first, evolution, column * row.x);
    gabor_impl_add_wave_3d(sum, window, unit * star.second, evolution, column * row.y);
    if (!tangents.only) gabor_impl_add_wave_3d(sum, window, unit * star.third, evolution, column * row.z);
}

// The sum over 27 nodes. Lengths are in units of GABOR_CELLS_PER_RADIUS node spacings.
GaborField3d gabor_impl_isotropic(GaborPlace3d place, float frequency, GaborImplTangents tangents, uint seed) {
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y =
        gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                        GABOR_CELLS_PER_RADIUS);
    GaborImplAxis z = gabor_impl_axis(place.cell.z, place.local.z, place.period.z, salt ^ GABOR_IMPL_SLICES, 0.0,
                                      GABOR_CELLS_PER_RADIUS);
    float3 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS, scale = min(abs(frequency), 1.0e6) / stretch;
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = 0; i < 9; ++i) {
        GaborImplNode y_j = gabor_impl_node(y, i % 3), z_k = gabor_impl_node(z, i / 3);
        uint4 row = gabor_impl_row(gabor_impl_node_word(y, i % 3) * gabor_impl_node_word(z, i / 3));
        gabor_impl_add_node_waves_3d(sum, gabor_impl_node(x, 0), y_j, z_k, scale, place.evolution, tangents, x.word[0],
                                     row);
        gabor_impl_add_node_waves_3d(sum, gabor_impl_node(x, 1), y_j, z_k, scale, place.evolution, tangents, x.word[1],
                                     row);
        gabor_impl_add_node_waves_3d(sum, gabor_impl_node(x, 2), y_j, z_k, scale, place.evolution, tangents, x.word[2],
                                     row);
    }
    GaborField3d field = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    float amplitude = rsqrt((tangents.only ? 2.0 : 3.0) * GABOR_IMPL_ENERGY)
                    / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    gabor_impl_add_field_3d(field, sum, amplitude, stretch);
    return field;
}

GaborField3d gabor_field_3d_isotropic(GaborPlace3d place, float frequency, uint seed) {
    return gabor_impl_isotropic(place, frequency, gabor_impl_all_directions(), seed);
}

float gabor_noise_3d_isotropic(float3 p, float frequency, uint seed) {
    return gabor_field_3d_isotropic(gabor_place_3d_at(p), frequency, seed).noise;
}

GaborField3d gabor_field_surface_isotropic(GaborPlace3d place, float3 normal, float frequency, uint seed) {
    normal = gabor_impl_unit(normal);
    float aside = dot(normal.xy, normal.xy); // squared sine of the normal's angle to the z axis
    GaborField3d sum = GaborField3d_of(0.0, (float3)(0.0), 0.0, (float3)(0.0), 0.0);
    for (int i = aside > 0.25 ? 0 : 1; i < (aside < 0.5 ? 2 : 1); ++i) {
        float power = gabor_impl_takeover(i == 0 ? smoothstep(0.25, 0.5, aside) : 1.0 - smoothstep(0.25, 0.5, aside));
        gabor_impl_add_field_3d(sum, gabor_impl_isotropic(place, frequency, gabor_impl_tangents(normal, i),
                                                          gabor_derived_seed(seed, i)), sqrt(power), (float3)(1.0));
    }
    return sum;
}

#endif

// Generated from gabor_spectrum.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest f4456d6b7bff64ad.
//
// gabor_spectrum.wgsl: Gabor noise with any power spectrum, or averaged over a pixel.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     f32 n = gabor_noise_spread(p, 2.0, 0.0, 0.0, 1.5707963, 7u);          // isotropic: mean 0, variance 1
//     vec2f f = gabor_noise_filtered(p, dFdx(p), dFdy(p), 4.0, 0.7854, 7u);    // averaged over a pixel
//
// Positions are in kernel radii, as in gabor_noise.wgsl. Noise has variance 1; filtered noise has variance 1 minus
// the removed share. The filter needs GABOR_TAPS 3, the default.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// ---- Sums of lobes -------------------------------------------------------------------------------------------------

// A lobe: waves around one wave vector. gabor_lobe returns it and documents its members.
struct GaborLobe {
    frequency: f32,
    orientation: f32,
    radius: vec2<f32>,
    power: f32,
}

// A power spectrum: the first `count` lobes, at most GABOR_LOBES.
struct GaborLobes {
    lobe: array<GaborLobe, 4>,
    count: i32,
}

// GaborLobe gabor_lobe(f32 frequency, f32 orientation, f32 radius, f32 power)
//     A lobe of waves around one wave vector.
//       frequency    cycles per unit of p, whatever the radius
//       orientation  as in gabor_noise
//       radius       radius of the lobe's kernels in units of p, positive. The lobe's standard deviation along each
//                    axis is 1/sqrt(12) / radius cycles per unit of p
//       power        power relative to the other lobes, not negative

// GaborLobe gabor_lobe_elliptical(f32 frequency, f32 orientation, vec2f radius, f32 power)
//     The same with different kernel radii along x and y, at the same cost.

// f32 gabor_noise_lobes(vec2f p, GaborLobes lobes, u32 seed)
//     The noise of several lobes at p: a sum of independent noises, normal with mean 0 and variance 1. Costs one
//     gabor_noise per lobe.
//         #define GABOR_LOBES 2              // before the file
//         GaborLobes lobes;
//         lobes.lobe[0] = gabor_lobe(4.0, 0.0, 1.0, 2.0);
//         lobes.lobe[1] = gabor_lobe(2.0, 1.6, 0.5, 1.0);
//         lobes.count = 2;
//         f32 n = gabor_noise_lobes(p, lobes, 7u);

// vec3f gabor_noise_lobes_gradient(vec2f p, GaborLobes lobes, u32 seed)
//     The noise with its analytic gradient per unit of p: (noise, d/dx, d/dy).

// vec2f gabor_noise_lobes_complex(vec2f p, GaborLobes lobes, u32 seed)
//     The noise with its quadrature, like gabor_noise_complex.

// ---- A range of waves, up to isotropic noise -----------------------------------------------------------------------

// f32 gabor_noise_spread(vec2f p, f32 frequency, f32 orientation, f32 frequency_spread,
//                          f32 orientation_spread, u32 seed)
//     Noise of many waves at p. Their orientations are within `orientation_spread` radians of `orientation`, and their
//     frequencies within the fraction `frequency_spread` (0 to 1) of `frequency`, spread as evenly as lobes of kernel
//     radius 1 allow. An orientation_spread of pi/2 gives isotropic noise; its power varies with direction by at most
//     5 % at frequencies from 0.12 to 14, and by up to 7 % at lower ones. The noise has mean 0 and variance 1; it and
//     its derivatives are normal. It is continuous where the arguments are. Costs one gabor_noise per lobe. There are
//         2.86 frequency_spread frequency + 0.8 frequencies, 1 to 16, each with
//         (4.44 frequency + 0.6) orientation_spread / (pi/2) + 0.8 directions, 1 to 64,
//     both rounded down: 10 directions for isotropic noise of frequency 2. Just before one of these numbers changes,
//     for a fifth of all arguments, the noise is a sum of both sets of lobes, the old and the new.

// vec3f gabor_noise_spread_gradient(vec2f p, f32 frequency, f32 orientation, f32 frequency_spread,
//                                  f32 orientation_spread, u32 seed)
//     The noise with its analytic gradient: (noise, d/dx, d/dy).

// vec2f gabor_noise_spread_complex(vec2f p, f32 frequency, f32 orientation, f32 frequency_spread,
//                                 f32 orientation_spread, u32 seed)
//     The noise with its quadrature, like gabor_noise_complex.

// ---- Isotropic noise at a constant cost ----------------------------------------------------------------------------

// f32 gabor_noise_isotropic(vec2f p, f32 frequency, u32 seed)
//     Noise of waves in all directions at p, at the same cost for every frequency: 3.5 times that of gabor_noise. It
//     has mean 0 and variance 1; value and gradient are normal at every point. The power varies with direction only
//     because of the window, by 7 % at frequency 0 and 0.1 % at 1. Values at several points together follow a mixture
//     of normal distributions; those of gabor_noise_spread, a sum over directions, are jointly normal.

// vec3f gabor_noise_isotropic_gradient(vec2f p, f32 frequency, u32 seed)
//     The noise with its analytic gradient: (noise, d/dx, d/dy).

// f32 gabor_noise_isotropic_tiled(vec2f p, vec2f period, f32 frequency, u32 seed)
//     The noise with a period, like gabor_noise_tiled.

// vec2f gabor_noise_isotropic_filtered(vec2f p, vec2f dx, vec2f dy, f32 frequency, u32 seed)
//     (noise, removed), like gabor_noise_filtered, with GABOR_TAPS 3, at about twice the cost of gabor_noise_isotropic.
//     The rms error against exactly filtered noise is 2 % of a standard deviation while the pixel's longest axis is at
//     most 0.3 kernel radii, and 4 % at 0.4. For larger pixels, only the variance is right.

// ---- Filtered for a pixel, with GABOR_TAPS 3 -----------------------------------------------------------------------

// vec2f gabor_noise_filtered(vec2f p, vec2f dx, vec2f dy, f32 frequency, f32 orientation, u32 seed)
//     (noise, removed): Gabor noise at p averaged over a pixel, and the share of its variance that averaging removed.
//     A material can add the removed share, which is lost contrast, to its roughness.
//       dx, dy  change of p from one pixel to the next along x and y: dFdx(p) and dFdy(p), or any two vectors. If p
//               is fract(uv), which jumps, take the derivatives of uv. The filter is Gaussian with the covariance
//               (dx dx^T + dy dy^T) / 4: its standard deviation is half a pixel.
//     The rms error against exactly filtered noise is at most 1 % of a standard deviation while the pixel's longest
//     axis, twice the filter's largest standard deviation, is at most a third of a kernel radius, and 2 % up to a whole
//     radius; at the worst point, these errors are 2 and 3 %. For larger pixels, only the variance is right. The result
//     is continuous in p, dx and dy. The cost on GPUs, relative to gabor_noise, is 1.4 for pixels up to 0.18 kernel
//     radii (9 nodes), 3.1 from 0.2 (16 nodes), 3.4 from 0.66 along x or y (20 nodes), and 3.8 from 0.66 along both (25
//     nodes); between 0.18 and 0.2, both of the first two filters run. On CPUs, where drivers run both sides of a
//     branch, the cost is 3 for small pixels and 5 for larger ones.

// vec4f gabor_noise_filtered_gradient(vec2f p, vec2f dx, vec2f dy, f32 frequency, f32 orientation, u32 seed)
//     The noise with its gradient: (noise, d/dx, d/dy, removed). The gradient ignores the fading of the windows, so its
//     error is up to 7 %.

// vec4f gabor_noise_four_filtered(vec2f p, vec2f dx, vec2f dy, f32 frequency, f32 orientation, u32 seed,
//                                out f32 removed)
//     The four noises of gabor_noise_four, filtered, and the share of its variance that each lost.

// vec2f gabor_noise_lobes_filtered(vec2f p, vec2f dx, vec2f dy, GaborLobes lobes, u32 seed)
//     The noise of gabor_noise_lobes, filtered: (noise, removed).

// vec4f gabor_noise_lobes_filtered_gradient(vec2f p, vec2f dx, vec2f dy, GaborLobes lobes, u32 seed)
//     The noise with its gradient: (noise, d/dx, d/dy, removed).

// vec4f gabor_stripes_filtered(vec2f p, vec2f dx, vec2f dy, vec2f wave, f32 sharpness, u32 seed)
//     gabor_stripes, filtered: (cosine, sine, intensity, removed). Each value is the mean over the removed part of the
//     noise, within 0.1. So (cosine, sine) gets shorter as waves are removed, and its profiles fade to their mean.

// ---- Profiles of a phase, each from 0 to 1 -------------------------------------------------------------------------
//
// The first five take a phase in turns and average over `width` turns, 0.001 to 1: the change of the phase over a
// pixel, for example the frequency times the length of dFdx(p).

// f32 gabor_profile_sine(f32 phase, f32 width)
//     A sine wave from 0 at phase 0 to 1 at half a turn.

// f32 gabor_profile_triangle(f32 phase, f32 width)
//     Straight lines from 0 at phase 0 to 1 at half a turn and back.

// f32 gabor_profile_sawtooth(f32 phase, f32 width)
//     A straight line from 0 at phase 0 to 1 after a turn.

// f32 gabor_profile_pulse(f32 phase, f32 duty, f32 width)
//     1 for the first `duty` (0 to 1) of each turn, then 0.

// f32 gabor_profile_ridges(f32 phase, f32 width)
//     Round ridges between sharp creases: a parabola, 0 at phase 0 and 1 at half a turn.

// The others take the (cosine, sine) of stripes instead of a phase and a width. The profile is sharp where this vector
// has length 1. Where the vector is shorter, because variance was removed or stripes fork, the profile is averaged over
// a range of phases whose mean vector has that length.

// f32 gabor_stripes_sine(vec2f stripes)
// f32 gabor_stripes_triangle(vec2f stripes)
// f32 gabor_stripes_sawtooth(vec2f stripes)
// f32 gabor_stripes_pulse(vec2f stripes, f32 duty)
// f32 gabor_stripes_ridges(vec2f stripes)
//     The profiles of gabor_profile_sine and so on.

// ---- For large worlds, and for periods combined with time ----------------------------------------------------------

// GaborPlace gabor_place_scaled(GaborPlace place, f32 radius)
// GaborPlace gabor_place_stretched(GaborPlace place, vec2f radius)
//     The same position, period and time, for kernels whose radius is `radius` times the place's; the factor may differ
//     along x and y. The position is rounded to a f32, within the period if there is one.

// GaborField gabor_field_lobes(GaborPlace place, GaborLobes lobes, u32 seed)
//     The noise of a sum of lobes, with its quadrature and derivatives per kernel radius of the place.

// GaborField gabor_field_spread(GaborPlace place, f32 frequency, f32 orientation, f32 frequency_spread,
//                               f32 orientation_spread, u32 seed)
//     The noise of a range of waves, like gabor_noise_spread, with quadrature and derivatives per kernel radius.

// GaborField gabor_field_isotropic(GaborPlace place, f32 frequency, u32 seed)
//     Isotropic noise at `place`, with quadrature and derivatives. At each point the quadrature is independent of the
//     noise, but not of the noise's gradient.

// The filter of a pixel, returned by gabor_footprint.
struct GaborFootprint {
    covariance: vec3<f32>,
    resolved: vec3<f32>,
}

// GaborFootprint gabor_footprint(vec2f dx, vec2f dy)
//     The footprint of a pixel, from dx and dy as in gabor_noise_filtered.

// vec4f gabor_stripes_filtered_at(GaborPlace place, vec2f wave, GaborFootprint footprint, f32 sharpness, u32 seed)
//     The same as gabor_stripes_filtered, at `place`, with a footprint as in gabor_field_filtered.

// GaborField gabor_field_filtered(GaborPlace place, GaborKernel kernel, GaborFootprint footprint, u32 seed,
//                                 out f32 removed)
//     The filtered noise at `place`, with quadrature and derivatives, and the removed share of its variance. With a
//     period, multiply dx and dy by place.radius / GABOR_RADIUS before calling gabor_footprint, because nodes are then
//     not 1 / GABOR_RADIUS kernel radii apart.

// GaborField gabor_field_isotropic_filtered(GaborPlace place, f32 frequency, GaborFootprint footprint, u32 seed,
//                                           out f32 removed)
//     The same for isotropic noise.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

fn gabor_impl_add_field(sum: ptr<function, GaborField>, field: GaborField, amplitude: f32) {
    let _e4 = (*sum);
    (*sum).value = (_e4.value + (amplitude * field.value));
    let _e10 = (*sum);
    (*sum).slope_x = (_e10.slope_x + (amplitude * field.slope_x));
    let _e16 = (*sum);
    (*sum).slope_y = (_e16.slope_y + (amplitude * field.slope_y));
    return;
}

fn gabor_place_stretched(place: GaborPlace, radius: vec2<f32>) -> GaborPlace {
    var cell_3: vec2<i32>;
    var unit: vec2<f32>;
    var scaled: GaborPlace;
    let _e6 = gabor_impl_wrap(place.cell.x, place.period.x);
    let _e11 = gabor_impl_wrap(place.cell.y, place.period.y);
    cell_3 = vec2<i32>(_e6, _e11);
    unit = (vec2(1f) / (place.radius * radius));
    let _e20 = cell_3;
    let _e24 = unit;
    let _e28 = unit;
    let _e30 = gabor_place_tiled(((vec2<f32>(_e20) + place.local) * _e24), (vec2<f32>(place.period) * _e28));
    scaled = _e30;
    scaled.animated = place.animated;
    scaled.moment = place.moment;
    let _e36 = scaled;
    return _e36;
}

fn gabor_place_scaled(place: GaborPlace, radius: f32) -> GaborPlace {
    let _e3 = gabor_place_stretched(place, vec2(radius));
    return _e3;
}

// A lobe's wave vector, in cycles per kernel radius along each axis.
fn gabor_impl_lobe_kernel(lobe: GaborLobe) -> GaborKernel {
    var kernel_4: GaborKernel;
    let _e6 = gabor_kernel((lobe.frequency * lobe.radius.x), lobe.orientation);
    kernel_4 = _e6;
    let _e10 = kernel_4;
    kernel_4.wave.y = (_e10.wave.y * (lobe.radius.y / lobe.radius.x));
    let _e19 = kernel_4;
    return _e19;
}

fn gabor_field_lobes(place: GaborPlace, lobes: GaborLobes, seed: u32) -> GaborField {
    var lobes_1: GaborLobes;
    var sum_5: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var power: f32 = 0f;
    var i: i32 = 0i;
    var lobe_1: GaborLobe;
    var stretched: GaborPlace;
    var field_3: GaborField;
    var local_12: f32;
    var scale: f32;
    lobes_1 = lobes;
    loop {
        let _e16 = i;
        let _e17 = lobes_1;
        if !((_e16 < min(_e17.count, 4i))) {
            break;
        }
        {
            let _e26 = i;
            let _e29 = lobes_1.lobe[_e26];
            lobe_1 = _e29;
            let _e31 = lobe_1;
            let _e33 = gabor_place_stretched(place, _e31.radius);
            stretched = _e33;
            let _e35 = stretched;
            let _e36 = lobe_1;
            let _e37 = gabor_impl_lobe_kernel(_e36);
            let _e38 = i;
            let _e39 = gabor_lobe_seed(seed, _e38);
            let _e40 = gabor_field(_e35, _e37, _e39);
            field_3 = _e40;
            let _e43 = field_3;
            let _e45 = lobe_1;
            field_3.slope_x = (_e43.slope_x / vec2(_e45.radius.x));
            let _e51 = field_3;
            let _e53 = lobe_1;
            field_3.slope_y = (_e51.slope_y / vec2(_e53.radius.y));
            let _e59 = field_3;
            let _e60 = lobe_1;
            gabor_impl_add_field((&sum_5), _e59, sqrt(_e60.power));
            let _e64 = power;
            let _e65 = lobe_1;
            power = (_e64 + _e65.power);
        }
        continuing {
            let _e23 = i;
            i = (_e23 + 1i);
        }
    }
    let _e68 = power;
    if (_e68 > 0f) {
        let _e71 = power;
        local_12 = inverseSqrt(_e71);
    } else {
        local_12 = 0f;
    }
    let _e75 = local_12;
    scale = _e75;
    let _e77 = scale;
    let _e78 = sum_5;
    let _e81 = scale;
    let _e82 = sum_5;
    let _e85 = scale;
    let _e86 = sum_5;
    return GaborField((_e77 * _e78.value), (_e81 * _e82.slope_x), (_e85 * _e86.slope_y));
}

// ---- Spreads -------------------------------------------------------------------------------------------------------

// A range of waves is cut into equal pieces of at most 0.7 cycles per kernel radius, with a lobe in the middle of each.
// The power of Hann's window has a standard deviation of 1/sqrt(12) cycles per kernel radius, so the sum of the lobes
// is nearly flat. The number of pieces is the integer part of a number c. As the fraction of c goes from 0.8 to 1,
// these pieces fade out and a set with one more piece fades in, so that the noise is continuous in frequency and
// spread.

// The power of a noise that replaces another as x goes from 0 to 1. If the power were x itself, the amplitudes would be
// square roots, with infinite slopes at the ends.
fn gabor_impl_takeover(x: f32) -> f32 {
    return ((x * x) / ((x * x) + ((1f - x) * (1f - x))));
}

// The number of lobes for `c`; while one set fades into the next, the total of both.
fn gabor_impl_pieces(c: f32) -> i32 {
    var local_13: i32;
    if (fract(c) > 0.8f) {
        local_13 = ((2i * i32(c)) + 1i);
    } else {
        local_13 = i32(c);
    }
    let _e11 = local_13;
    return _e11;
}

// Returns lobe `i` as (position in the range, from -1 to 1; share of the power; number from which its seed derives).
fn gabor_impl_piece(i: i32, c: f32) -> vec3<f32> {
    var i_2: i32;
    var n: i32;
    var left: f32;
    var width: f32;
    i_2 = i;
    n = i32(c);
    left = min((5f - (5f * fract(c))), 1f);
    let _e13 = i_2;
    let _e14 = n;
    if (_e13 >= _e14) {
        {
            let _e16 = i_2;
            let _e17 = n;
            i_2 = (_e16 - _e17);
            let _e19 = n;
            n = (_e19 + 1i);
            let _e23 = left;
            left = (1f - _e23);
        }
    }
    let _e26 = n;
    width = (1f / f32(_e26));
    let _e31 = i_2;
    let _e36 = width;
    let _e40 = left;
    let _e41 = gabor_impl_takeover(_e40);
    let _e42 = width;
    let _e44 = i_2;
    let _e45 = n;
    return vec3<f32>(((((2f * f32(_e31)) + 1f) * _e36) - 1f), (_e41 * _e42), f32((_e44 + ((_e45 & 1i) * 64i))));
}

fn gabor_field_spread(place: GaborPlace, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> GaborField {
    var frequency_8: f32;
    var frequency_spread_1: f32;
    var orientation_spread_1: f32;
    var sum_6: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var shells: f32;
    var shell_count: i32;
    var j_1: i32 = 0i;
    var shell: vec3<f32>;
    var magnitude: f32;
    var directions: f32;
    var direction_count: i32;
    var i_3: i32;
    var direction: vec3<f32>;
    var kernel_5: GaborKernel;
    var field_4: GaborField;
    var amplitude_2: f32;
    frequency_8 = frequency;
    frequency_spread_1 = frequency_spread;
    orientation_spread_1 = orientation_spread;
    let _e17 = frequency_8;
    frequency_8 = min(abs(_e17), 1000000f);
    let _e21 = frequency_spread_1;
    frequency_spread_1 = clamp(_e21, 0f, 1f);
    let _e25 = orientation_spread_1;
    orientation_spread_1 = clamp(_e25, 0f, 1.5707963f);
    let _e30 = frequency_spread_1;
    let _e32 = frequency_8;
    shells = clamp((((2.857f * _e30) * _e32) + 0.8f), 1f, 16f);
    let _e40 = shells;
    let _e41 = gabor_impl_pieces(_e40);
    shell_count = _e41;
    loop {
        let _e45 = j_1;
        let _e46 = shell_count;
        if !((_e45 < _e46)) {
            break;
        }
        {
            let _e52 = j_1;
            let _e53 = shells;
            let _e54 = gabor_impl_piece(_e52, _e53);
            shell = _e54;
            let _e56 = frequency_8;
            let _e58 = frequency_spread_1;
            let _e59 = shell;
            magnitude = (_e56 * (1f + (_e58 * _e59.x)));
            let _e66 = orientation_spread_1;
            let _e69 = magnitude;
            directions = clamp((((0.63661975f * _e66) * ((4.44f * _e69) + 0.6f)) + 0.8f), 1f, 64f);
            let _e80 = directions;
            let _e81 = gabor_impl_pieces(_e80);
            direction_count = _e81;
            i_3 = 0i;
            loop {
                let _e85 = i_3;
                let _e86 = direction_count;
                if !((_e85 < _e86)) {
                    break;
                }
                {
                    let _e92 = i_3;
                    let _e93 = directions;
                    let _e94 = gabor_impl_piece(_e92, _e93);
                    direction = _e94;
                    let _e96 = magnitude;
                    let _e97 = orientation_spread_1;
                    let _e98 = direction;
                    let _e102 = gabor_kernel(_e96, (orientation + (_e97 * _e98.x)));
                    kernel_5 = _e102;
                    let _e104 = kernel_5;
                    let _e106 = shell;
                    let _e109 = direction;
                    let _e113 = gabor_lobe_seed(seed, i32(((128f * _e106.z) + _e109.z)));
                    let _e114 = gabor_field(place, _e104, _e113);
                    field_4 = _e114;
                    let _e116 = shell;
                    let _e118 = direction;
                    amplitude_2 = sqrt((_e116.y * _e118.y));
                    let _e124 = field_4;
                    let _e125 = amplitude_2;
                    gabor_impl_add_field((&sum_6), _e124, _e125);
                }
                continuing {
                    let _e89 = i_3;
                    i_3 = (_e89 + 1i);
                }
            }
        }
        continuing {
            let _e49 = j_1;
            j_1 = (_e49 + 1i);
        }
    }
    let _e127 = sum_6;
    return _e127;
}

// ---- The filter ----------------------------------------------------------------------------------------------------
//
// A Gaussian filter of covariance S multiplies a wave with wave vector k by exp(-2 pi^2 k.S k). If H is the Fourier
// transform of h, one node's kernel h(x) h(y) e^(2 pi i F.d) becomes the integral over q of
//
//     H(q_x) H(q_y) exp(-2 pi^2 (F + q).S (F + q)) e^(2 pi i (F + q).d).
//
// Along an axis and within w of the node, this is a Fourier series of period 2w: a sum over q = a / 2w. With w = 1, the
// three waves a = -1, 0, 1 are h itself. After the filter, they are wrong only near the ends of h: by less than 1 % of
// the noise's standard deviation if the filter's standard deviation is at most 0.1 kernel radii. A wider filter widens
// the kernel beyond the ends of h, and needs the seven waves a = -3 ... 3: with w = 4/3 and four nodes along the axis
// up to a standard deviation of 0.33, and with w up to 5/3 and five nodes beyond that. Between 0.09 and 0.1, seven
// waves gradually replace three. All of this is for GABOR_TAPS 3.
//
// The factor exp(-4 pi^2 S_xy q_x q_y) couples the axes. It acts like exp(S_xy d/dx d/dy): for three waves, 1 + S_xy
// d/dx d/dy is enough. For seven waves, we use the fact that H is nearly a Gaussian:
// H = (H e^(2 pi^2 v q^2)) e^(-2 pi^2 v q^2), where v = 1/3 - 2/pi^2 is the variance of h. Mehler's formula (DLMF
// 18.18.28) then separates the axes: with M = S + v, the centre c = -M^-1 S F of the filtered lobe,
// rho = M_xy / sqrt(M_xx M_yy), r = sqrt(1 - rho^2), lambda = rho / (1 + r) and, for each axis, g = 2 pi^2 r M and
// z = sqrt(2 g) (q - c),
//
//     exp(-2 pi^2 (q - c).M (q - c)) = sqrt(1 - lambda^2) exp(-(z_x^2 + z_y^2) / 2)
//                                      (1 - 2 lambda z_x z_y + 2 lambda^2 (z_x^2 - 1/2) (z_y^2 - 1/2) - ...).
//
// We use these three terms; |lambda| is at most 0.26.

// A symmetric matrix (xx, yy, xy) times a vector.
fn gabor_impl_symmetric(matrix: vec3<f32>, v: vec2<f32>) -> vec2<f32> {
    return ((matrix.xy * v) + (matrix.z * v.yx));
}

// The share of a lobe's variance that a filter of covariance S keeps. If we approximate the lobe's power by a
// Gaussian with the variance 1/12 of Hann's window along each axis, and d is the determinant of 1 + 2/3 pi^2 S, this is
//     d^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F),   where S (1 + 2/3 pi^2 S)^-1 = (S + 2/3 pi^2 |S|) / d.
fn gabor_impl_transmitted(wave: vec2<f32>, covariance: vec3<f32>) -> f32 {
    var area: f32;
    var d: f32;
    var exponent: f32;
    area = (6.579736f * ((covariance.x * covariance.y) - (covariance.z * covariance.z)));
    let _e17 = area;
    d = (1f + (6.579736f * ((covariance.x + covariance.y) + _e17)));
    let _e23 = d;
    let _e25 = gabor_impl_symmetric(covariance, wave);
    let _e26 = area;
    exponent = ((39.478416f / _e23) * dot(wave, (_e25 + (_e26 * wave))));
    let _e32 = exponent;
    let _e38 = d;
    return (exp(-(clamp(_e32, 0f, 80f))) * inverseSqrt(_e38));
}

// Approximates exp(-q/2) I_0(q/2), the mean of exp(-q cos^2) over angles, by the square root of a rational function.
fn gabor_impl_mean_angle(q: f32) -> f32 {
    return sqrt(((1f + (q * (0.19075951f + (0.0865599f * q)))) / (1f + (q * (1.1907595f + (q * (0.60787135f + (0.27193594f * q))))))));
}

// Returns a node's filtered window, in the form with three waves, and the window's derivative. The filter multiplies
// the wave q = -1/2, 0 or 1/2 of Hann's window by exp(-2 pi^2 S q^2 - 4 pi^2 (S F) q), where S is its variance along
// the axis. If `even` and `odd` are the even and odd parts of this factor at q = 1/2, the window h becomes
// 1/2 + even (h - 1/2) + i odd h' / pi.
fn gabor_impl_filtered_node(value: f32, slope: f32, part: vec2<f32>, phase: vec2<f32>) -> vec4<f32> {
    var wave_11: vec2<f32>;
    var even: vec2<f32>;
    var odd: vec2<f32>;
    wave_11 = vec2<f32>((value - 0.5f), slope);
    let _e9 = wave_11;
    even = (part.x * _e9);
    let _e18 = wave_11;
    odd = ((part.y * vec2<f32>(-3.1415927f, 0.3183099f)) * _e18);
    let _e22 = even;
    let _e25 = odd;
    let _e28 = gabor_impl_product(vec2<f32>((0.5f + _e22.x), _e25.y), phase);
    let _e29 = even;
    let _e31 = odd;
    let _e34 = gabor_impl_product(vec2<f32>(_e29.y, _e31.x), phase);
    return vec4<f32>(_e28.x, _e28.y, _e34.x, _e34.y);
}

// Filters an axis with the given S and S F. Windows fade out within half a standard deviation of their ends; the middle
// window never fades.
fn gabor_impl_filter(axis: ptr<function, GaborAxis>, variance: f32, blurred: f32) {
    var rise: f32;
    var part_1: vec2<f32>;
    var inside: vec2<f32>;
    var fade: vec2<f32>;
    var turn_6: vec2<f32>;
    var value_6: vec4<f32>;
    var slope_7: vec4<f32>;
    rise = exp((19.739208f * blurred));
    let _e13 = rise;
    let _e15 = rise;
    let _e18 = rise;
    let _e20 = rise;
    part_1 = ((0.5f * exp((-4.934802f * variance))) * vec2<f32>((_e13 + (1f / _e15)), (_e18 - (1f / _e20))));
    let _e28 = (*axis);
    let _e31 = (*axis);
    inside = (vec2(0.33333334f) + (0.6666667f * vec2<f32>(-(_e28.offset), _e31.offset)));
    let _e38 = inside;
    fade = clamp((_e38 / vec2(clamp((0.5f * sqrt(variance)), 0.001f, 0.05f))), vec2(0f), vec2(1f));
    let _e53 = fade;
    let _e54 = fade;
    let _e57 = fade;
    fade = (_e53 * (_e54 * (vec2(3f) - (2f * _e57))));
    let _e63 = (*axis);
    let _e65 = gabor_impl_wave(_e63.turns);
    turn_6 = _e65;
    let _e69 = (*axis);
    gabor_impl_windows(_e69.offset, (&value_6), (&slope_7));
    let _e78 = value_6;
    let _e80 = slope_7;
    let _e82 = part_1;
    let _e83 = fade;
    let _e85 = turn_6;
    let _e87 = gabor_impl_filtered_node(_e78.x, _e80.x, _e82, (_e83.x * _e85));
    (*axis).node[0i] = _e87;
    let _e91 = value_6;
    let _e93 = slope_7;
    let _e95 = part_1;
    let _e99 = gabor_impl_filtered_node(_e91.y, _e93.y, _e95, vec2<f32>(1f, 0f));
    (*axis).node[1i] = _e99;
    let _e103 = value_6;
    let _e105 = slope_7;
    let _e107 = part_1;
    let _e108 = fade;
    let _e110 = turn_6;
    let _e112 = turn_6;
    let _e117 = gabor_impl_filtered_node(_e103.z, _e105.z, _e107, (_e108.y * vec2<f32>(_e110.x, -(_e112.y))));
    (*axis).node[2i] = _e117;
    return;
}

// The filtered noise at `place`, with three waves along each axis.
fn gabor_impl_filtered_narrow(place: GaborPlace, wave: vec2<f32>, s: vec3<f32>, salt: u32) -> GaborField {
    var blurred_1: vec2<f32>;
    var columns: GaborAxis;
    var rows: GaborAxis;
    var turn_7: vec2<f32>;
    var sum_7: vec4<f32>;
    var slope_8: vec4<f32>;
    let _e4 = gabor_impl_symmetric(s, wave);
    blurred_1 = _e4;
    let _e17 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, 1.5f);
    columns = _e17;
    let _e32 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), wave.y, 1.5f);
    rows = _e32;
    let _e34 = columns;
    let _e36 = columns;
    let _e39 = rows;
    let _e41 = rows;
    let _e45 = gabor_impl_wave(((_e34.offset * _e36.turns) + (_e39.offset * _e41.turns)));
    turn_7 = _e45;
    let _e49 = blurred_1;
    gabor_impl_filter((&columns), s.x, _e49.x);
    let _e54 = blurred_1;
    gabor_impl_filter((&rows), s.y, _e54.y);
    let _e59 = columns;
    let _e60 = rows;
    gabor_impl_sum(_e59, _e60, place.animated, place.moment, (&sum_7), (&slope_8));
    let _e67 = sum_7;
    let _e69 = slope_8;
    let _e71 = (s.z * _e69.zw);
    sum_7 = (_e67 + vec4<f32>(_e71.x, _e71.y, 0f, 0f));
    let _e78 = sum_7;
    let _e79 = slope_8;
    let _e82 = blurred_1;
    let _e86 = turn_7;
    let _e90 = gabor_impl_field(_e78, _e79, (exp((-19.739208f * dot(wave, _e82))) * _e86), wave, vec2(1f));
    return _e90;
}

// For the form with seven waves: a complex number for each factor of an axis, 1, q - c and (q - c)^2 - 1 / 4g.
struct GaborFactors {
    real: vec3<f32>,
    imaginary: vec3<f32>,
}

// The nodes along an axis and their filtered windows. At a distance of d kernel radii, the window for each factor is
//     even_0 + C (even_1 + C (even_2 + C even_3)) + i S (odd_1 + C (odd_2 + C odd_3)),
// where C and S are the cosine and sine of 2 pi d / 2w.
struct GaborFilteredAxis {
    even_0_: vec3<f32>,
    even_1_: vec3<f32>,
    even_2_: vec3<f32>,
    even_3_: vec3<f32>,
    odd_1_: vec3<f32>,
    odd_2_: vec3<f32>,
    odd_3_: vec3<f32>,
    reach: f32,
    offset: f32,
    count: i32,
    first: i32,
    period: i32,
    salt: u32,
    turn_back: vec2<f32>,
    back: vec2<f32>,
}

// Builds the windows, without their common factor e^(-g c^2), for a filter with a given standard deviation along the
// axis. `m` is r M in the plane and D in space.
fn gabor_impl_filtered_axis(deviation: f32, m: f32, c: f32, cell: i32, local: f32, period: i32, salt: u32, step: vec2<f32>) -> GaborFilteredAxis {
    var b_2: GaborFilteredAxis;
    var local_15: i32;
    var local_16: f32;
    var zero_1: f32;
    var local_17: f32;
    var g: f32;
    var unit_1: f32;
    var fall: f32;
    var rise_1: f32;
    var sink: f32;
    var t_2: f32;
    var wave_13: vec3<f32>;
    var fall_4_: f32;
    var above: vec3<f32>;
    var below: vec3<f32>;
    var even_1: vec3<f32>;
    var odd_1: vec3<f32>;
    var q_1: vec3<f32>;
    var quarter: f32;
    var even_1_: vec3<f32>;
    var odd_1_: vec3<f32>;
    var even_2_: vec3<f32>;
    var odd_2_: vec3<f32>;
    b_2.reach = clamp((0.35f + (5f * deviation)), 2f, 2.5f);
    let _e18 = b_2;
    if (_e18.reach > 2f) {
        local_15 = 5i;
    } else {
        local_15 = 4i;
    }
    let _e25 = local_15;
    b_2.count = _e25;
    let _e26 = b_2;
    if (_e26.count == 5i) {
        local_16 = 0.5f;
    } else {
        local_16 = 1f;
    }
    let _e33 = local_16;
    zero_1 = (floor((local + _e33)) - 2f);
    let _e40 = b_2;
    if (_e40.count == 5i) {
        let _e44 = zero_1;
        local_17 = clamp((local - _e44), 1.5f, 2.5f);
    } else {
        let _e49 = zero_1;
        local_17 = clamp((local - _e49), 1f, 2f);
    }
    let _e55 = local_17;
    b_2.offset = _e55;
    let _e57 = zero_1;
    b_2.first = (cell + i32(_e57));
    b_2.period = period;
    b_2.salt = salt;
    let _e65 = b_2;
    let _e68 = gabor_impl_wave((-0.5f / _e65.reach));
    b_2.turn_back = _e68;
    b_2.back = vec2<f32>(step.x, -(step.y));
    g = (19.739208f * m);
    let _e78 = b_2;
    unit_1 = (0.75f / _e78.reach);
    let _e83 = g;
    let _e85 = unit_1;
    let _e87 = unit_1;
    fall = exp((((2.5797362f - _e83) * _e85) * _e87));
    let _e92 = g;
    let _e95 = unit_1;
    rise_1 = exp((((2f * _e92) * c) * _e95));
    let _e100 = rise_1;
    sink = (1f / _e100);
    let _e103 = b_2;
    t_2 = (_e103.reach - 2f);
    let _e113 = t_2;
    let _e119 = t_2;
    wave_13 = (vec3<f32>(0.25723323f, 0.12732396f, -0.03693604f) + (_e113 * (vec3<f32>(-0.03099653f, 0.22852218f, 0.10636504f) - (_e119 * vec3<f32>(0.0214304f, 0.11618766f, -0.1615392f)))));
    let _e130 = fall;
    let _e131 = fall;
    let _e133 = fall;
    let _e134 = fall;
    fall_4_ = ((_e130 * _e131) * (_e133 * _e134));
    let _e138 = wave_13;
    let _e139 = fall;
    let _e140 = fall_4_;
    let _e141 = fall_4_;
    let _e142 = fall_4_;
    let _e144 = fall;
    wave_13 = (_e138 * vec3<f32>(_e139, _e140, ((_e141 * _e142) * _e144)));
    let _e148 = wave_13;
    let _e149 = rise_1;
    let _e150 = rise_1;
    let _e151 = rise_1;
    let _e153 = rise_1;
    let _e154 = rise_1;
    let _e156 = rise_1;
    above = (_e148 * vec3<f32>(_e149, (_e150 * _e151), ((_e153 * _e154) * _e156)));
    let _e161 = wave_13;
    let _e162 = sink;
    let _e163 = sink;
    let _e164 = sink;
    let _e166 = sink;
    let _e167 = sink;
    let _e169 = sink;
    below = (_e161 * vec3<f32>(_e162, (_e163 * _e164), ((_e166 * _e167) * _e169)));
    let _e174 = above;
    let _e175 = below;
    even_1 = (_e174 + _e175);
    let _e178 = above;
    let _e179 = below;
    odd_1 = (_e178 - _e179);
    let _e182 = unit_1;
    q_1 = (_e182 * vec3<f32>(1f, 2f, 3f));
    let _e190 = g;
    quarter = (0.25f / _e190);
    let _e193 = q_1;
    let _e194 = odd_1;
    let _e196 = even_1;
    even_1_ = ((_e193 * _e194) - (c * _e196));
    let _e200 = q_1;
    let _e201 = even_1;
    let _e203 = odd_1;
    odd_1_ = ((_e200 * _e201) - (c * _e203));
    let _e207 = q_1;
    let _e208 = odd_1_;
    let _e210 = even_1_;
    let _e213 = quarter;
    let _e214 = even_1;
    even_2_ = (((_e207 * _e208) - (c * _e210)) - (_e213 * _e214));
    let _e218 = q_1;
    let _e219 = even_1_;
    let _e221 = odd_1_;
    let _e224 = quarter;
    let _e225 = odd_1;
    odd_2_ = (((_e218 * _e219) - (c * _e221)) - (_e224 * _e225));
    let _e230 = even_1;
    let _e232 = even_1_;
    let _e234 = even_2_;
    b_2.even_2_ = vec3<f32>(_e230.y, _e232.y, _e234.y);
    let _e238 = even_1;
    let _e240 = even_1_;
    let _e242 = even_2_;
    b_2.even_3_ = vec3<f32>(_e238.z, _e240.z, _e242.z);
    let _e246 = odd_1;
    let _e248 = odd_1_;
    let _e250 = odd_2_;
    b_2.odd_2_ = vec3<f32>(_e246.y, _e248.y, _e250.y);
    let _e254 = odd_1;
    let _e256 = odd_1_;
    let _e258 = odd_2_;
    b_2.odd_3_ = vec3<f32>(_e254.z, _e256.z, _e258.z);
    let _e262 = unit_1;
    let _e266 = quarter;
    let _e271 = b_2;
    b_2.even_0_ = ((_e262 * vec3<f32>(1f, -(c), ((c * c) - _e266))) - (0.5f * _e271.even_2_));
    let _e276 = even_1;
    let _e278 = even_1_;
    let _e280 = even_2_;
    let _e284 = b_2;
    b_2.even_1_ = (vec3<f32>(_e276.x, _e278.x, _e280.x) - (0.75f * _e284.even_3_));
    let _e289 = odd_1;
    let _e291 = odd_1_;
    let _e293 = odd_2_;
    let _e297 = b_2;
    b_2.odd_1_ = (vec3<f32>(_e289.x, _e291.x, _e293.x) - (0.25f * _e297.odd_3_));
    let _e301 = b_2;
    return _e301;
}

// A column or a row of nodes: its word, and for each factor its window times the noise's wave.
struct GaborFilteredLine {
    word: u32,
    window: GaborFactors,
    turn: vec2<f32>,
    phase: vec2<f32>,
}

// The factor by which the windows of line `index` fade, over the last quarter of a node spacing.
fn gabor_impl_fade(b: GaborFilteredAxis, index: i32) -> f32 {
    var fade_1: f32;
    fade_1 = clamp((4f * (b.reach - abs((b.offset - f32(index))))), 0f, 1f);
    let _e14 = fade_1;
    let _e15 = fade_1;
    let _e19 = fade_1;
    return ((_e14 * _e15) * (3f - (2f * _e19)));
}

// Computes line `index` from its turn and phase.
fn gabor_impl_filtered_line(b: GaborFilteredAxis, index: i32, turn: vec2<f32>, phase: vec2<f32>, fade: f32) -> GaborFilteredLine {
    var phase_3: vec2<f32>;
    var line: GaborFilteredLine;
    var real: vec3<f32>;
    var imaginary: vec3<f32>;
    phase_3 = phase;
    let _e11 = gabor_impl_wrap((b.first + index), b.period);
    let _e13 = gabor_impl_line_word(_e11, b.salt);
    line.word = _e13;
    line.turn = turn;
    let _e16 = phase_3;
    line.phase = _e16;
    real = (b.even_0_ + (turn.x * (b.even_1_ + (turn.x * (b.even_2_ + (turn.x * b.even_3_))))));
    imaginary = (turn.y * (b.odd_1_ + (turn.x * (b.odd_2_ + (turn.x * b.odd_3_)))));
    let _e43 = phase_3;
    phase_3 = (_e43 * fade);
    let _e46 = phase_3;
    let _e48 = real;
    let _e50 = phase_3;
    let _e52 = imaginary;
    let _e55 = phase_3;
    let _e57 = imaginary;
    let _e59 = phase_3;
    let _e61 = real;
    line.window = GaborFactors(((_e46.x * _e48) - (_e50.y * _e52)), ((_e55.x * _e57) + (_e59.y * _e61)));
    let _e65 = line;
    return _e65;
}

// Computes line `index` from the previous one.
fn gabor_impl_next_line(line: GaborFilteredLine, b: GaborFilteredAxis, index: i32, fade: f32) -> GaborFilteredLine {
    let _e6 = gabor_impl_product(line.turn, b.turn_back);
    let _e9 = gabor_impl_product(line.phase, b.back);
    let _e10 = gabor_impl_filtered_line(b, index, _e6, _e9, fade);
    return _e10;
}

// The four or five columns of nodes that reach a point.
struct GaborColumns {
    column_0_: GaborFilteredLine,
    column_1_: GaborFilteredLine,
    column_2_: GaborFilteredLine,
    column_3_: GaborFilteredLine,
    column_4_: GaborFilteredLine,
    five: bool,
}

fn gabor_impl_columns(b: GaborFilteredAxis) -> GaborColumns {
    var columns_1: GaborColumns;
    var turn_9: vec2<f32>;
    let _e7 = gabor_impl_wave(((0.5f / b.reach) * b.offset));
    turn_9 = _e7;
    columns_1.five = (b.count == 5i);
    let _e15 = turn_9;
    let _e20 = gabor_impl_fade(b, 0i);
    let _e21 = gabor_impl_filtered_line(b, 0i, _e15, vec2<f32>(1f, 0f), _e20);
    columns_1.column_0_ = _e21;
    let _e23 = columns_1;
    let _e27 = gabor_impl_next_line(_e23.column_0_, b, 1i, 1f);
    columns_1.column_1_ = _e27;
    let _e29 = columns_1;
    let _e33 = gabor_impl_next_line(_e29.column_1_, b, 2i, 1f);
    columns_1.column_2_ = _e33;
    let _e35 = columns_1;
    let _e39 = gabor_impl_fade(b, 3i);
    let _e40 = gabor_impl_next_line(_e35.column_2_, b, 3i, _e39);
    columns_1.column_3_ = _e40;
    let _e42 = columns_1;
    columns_1.column_4_ = _e42.column_3_;
    let _e44 = columns_1;
    if _e44.five {
        let _e47 = columns_1;
        let _e51 = gabor_impl_fade(b, 4i);
        let _e52 = gabor_impl_next_line(_e47.column_3_, b, 4i, _e51);
        columns_1.column_4_ = _e52;
    }
    let _e53 = columns_1;
    return _e53;
}

// The line before line 0, given the phase of the noise's wave there.
fn gabor_impl_line_before(b: GaborFilteredAxis, phase: vec2<f32>) -> GaborFilteredLine {
    var line_2: GaborFilteredLine;
    let _e11 = gabor_impl_wave(((0.5f / b.reach) * (b.offset + 1f)));
    line_2.turn = _e11;
    line_2.phase = phase;
    let _e13 = line_2;
    return _e13;
}

// Returns the sum plus a complex number times the factors.
fn gabor_impl_plus_product(sum: GaborFactors, factors: GaborFactors, real: f32, imaginary: f32) -> GaborFactors {
    return GaborFactors((sum.real + ((real * factors.real) - (imaginary * factors.imaginary))), (sum.imaginary + ((real * factors.imaginary) + (imaginary * factors.real))));
}

// Adds a node to the sums of a row.
fn gabor_impl_add_filtered_node(row: ptr<function, GaborFactors>, column: GaborFilteredLine, row_word: u32, animated: bool, moment: f32) {
    var a_2: vec2<f32>;
    let _e7 = gabor_impl_amplitude_at((column.word * row_word), animated, moment);
    a_2 = _e7;
    let _e9 = (*row);
    let _e11 = a_2;
    let _e13 = a_2;
    let _e15 = gabor_impl_plus_product(_e9, column.window, _e11.x, _e13.y);
    (*row) = _e15;
    return;
}

// The sums of a row over its columns.
fn gabor_impl_filtered_row(columns: GaborColumns, row_word: u32, animated: bool, moment: f32) -> GaborFactors {
    var row_2: GaborFactors = GaborFactors(vec3(0f), vec3(0f));
    gabor_impl_add_filtered_node((&row_2), columns.column_0_, row_word, animated, moment);
    gabor_impl_add_filtered_node((&row_2), columns.column_1_, row_word, animated, moment);
    gabor_impl_add_filtered_node((&row_2), columns.column_2_, row_word, animated, moment);
    gabor_impl_add_filtered_node((&row_2), columns.column_3_, row_word, animated, moment);
    if columns.five {
        gabor_impl_add_filtered_node((&row_2), columns.column_4_, row_word, animated, moment);
    }
    let _e26 = row_2;
    return _e26;
}

// Drops the first factor and moves the others up by one.
fn gabor_impl_next(f: GaborFactors) -> GaborFactors {
    let _e2 = f.real.yz;
    let _e8 = f.imaginary.yz;
    return GaborFactors(vec3<f32>(_e2.x, _e2.y, 0f), vec3<f32>(_e8.x, _e8.y, 0f));
}

// The weighted sum of the products of two axes' factors.
fn gabor_impl_contracted(a: GaborFactors, b: GaborFactors, weights: vec3<f32>) -> vec2<f32> {
    return vec2<f32>(dot(weights, ((a.real * b.real) - (a.imaginary * b.imaginary))), dot(weights, ((a.real * b.imaginary) + (a.imaginary * b.real))));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
fn gabor_impl_filtered_wide(place: GaborPlace, wave: vec2<f32>, s: vec3<f32>, wanted: bool, salt: u32) -> GaborField {
    var m_1: vec2<f32>;
    var deviation_1: vec2<f32>;
    var blurred_2: vec2<f32>;
    var c_4: vec2<f32>;
    var rho: f32;
    var r_1: f32;
    var lambda: f32;
    var mixed: f32;
    var weights_1: vec3<f32>;
    var step_x: vec2<f32>;
    var step_y: vec2<f32>;
    var across: GaborFilteredAxis;
    var along: GaborFilteredAxis;
    var columns_3: GaborColumns;
    var line_3: GaborFilteredLine;
    var local_18: i32;
    var rows_1: i32;
    var value_7: vec2<f32> = vec2(0f);
    var next_x: vec2<f32> = vec2(0f);
    var next_y: vec2<f32> = vec2(0f);
    var j_2: i32 = 0i;
    var row_3: GaborFactors;
    var exponent_1: f32;
    var mean: vec2<f32>;
    var before: vec2<f32>;
    var x_5: vec2<f32>;
    var y_4: vec2<f32>;
    var local_19: f32;
    var scale_1: f32;
    m_1 = (s.xy + vec2(0.13069098f));
    deviation_1 = sqrt(s.xy);
    let _e13 = gabor_impl_symmetric(s, wave);
    blurred_2 = _e13;
    let _e15 = m_1;
    let _e16 = _e15.yx;
    let _e22 = blurred_2;
    let _e23 = gabor_impl_symmetric(vec3<f32>(_e16.x, _e16.y, -(s.z)), _e22);
    let _e27 = m_1;
    let _e29 = m_1;
    c_4 = (_e23 / vec2(((s.z * s.z) - (_e27.x * _e29.y))));
    let _e37 = m_1;
    let _e39 = m_1;
    rho = (s.z * inverseSqrt((_e37.x * _e39.y)));
    let _e46 = rho;
    let _e47 = rho;
    r_1 = sqrt((1f - (_e46 * _e47)));
    let _e52 = rho;
    let _e54 = r_1;
    lambda = (_e52 / (1f + _e54));
    let _e61 = r_1;
    let _e64 = r_1;
    mixed = (((39.478416f * s.z) * _e61) / (1f + _e64));
    let _e71 = mixed;
    let _e74 = mixed;
    let _e76 = mixed;
    weights_1 = vec3<f32>(1f, (-2f * _e71), ((2f * _e74) * _e76));
    let _e86 = gabor_impl_wave((wave.x / 1.5f));
    step_x = _e86;
    let _e94 = gabor_impl_wave((wave.y / 1.5f));
    step_y = _e94;
    let _e96 = deviation_1;
    let _e98 = r_1;
    let _e99 = m_1;
    let _e102 = c_4;
    let _e110 = step_x;
    let _e111 = gabor_impl_filtered_axis(_e96.x, (_e98 * _e99.x), _e102.x, place.cell.x, place.local.x, place.period.x, salt, _e110);
    across = _e111;
    let _e113 = deviation_1;
    let _e115 = r_1;
    let _e116 = m_1;
    let _e119 = c_4;
    let _e129 = step_y;
    let _e130 = gabor_impl_filtered_axis(_e113.y, (_e115 * _e116.y), _e119.y, place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), _e129);
    along = _e130;
    let _e132 = across;
    let _e133 = gabor_impl_columns(_e132);
    columns_3 = _e133;
    let _e135 = along;
    let _e136 = across;
    let _e138 = along;
    let _e149 = gabor_impl_wave((dot(wave, vec2<f32>(_e136.offset, (_e138.offset + 1f))) / 1.5f));
    let _e150 = gabor_impl_line_before(_e135, _e149);
    line_3 = _e150;
    if wanted {
        let _e152 = along;
        local_18 = _e152.count;
    } else {
        local_18 = 0i;
    }
    let _e156 = local_18;
    rows_1 = _e156;
    loop {
        {
            let _e169 = line_3;
            let _e170 = along;
            let _e171 = j_2;
            let _e172 = along;
            let _e173 = j_2;
            let _e174 = gabor_impl_fade(_e172, _e173);
            let _e175 = gabor_impl_next_line(_e169, _e170, _e171, _e174);
            line_3 = _e175;
            let _e176 = columns_3;
            let _e177 = line_3;
            let _e181 = gabor_impl_filtered_row(_e176, _e177.word, place.animated, place.moment);
            row_3 = _e181;
            let _e183 = value_7;
            let _e184 = row_3;
            let _e185 = line_3;
            let _e187 = weights_1;
            let _e188 = gabor_impl_contracted(_e184, _e185.window, _e187);
            value_7 = (_e183 + _e188);
            let _e190 = next_x;
            let _e191 = row_3;
            let _e192 = gabor_impl_next(_e191);
            let _e193 = line_3;
            let _e195 = weights_1;
            let _e196 = gabor_impl_contracted(_e192, _e193.window, _e195);
            next_x = (_e190 + _e196);
            let _e198 = next_y;
            let _e199 = row_3;
            let _e200 = line_3;
            let _e202 = gabor_impl_next(_e200.window);
            let _e203 = weights_1;
            let _e204 = gabor_impl_contracted(_e199, _e202, _e203);
            next_y = (_e198 + _e204);
        }
        let _e206 = j_2;
        let _e208 = (_e206 + 1i);
        j_2 = _e208;
        let _e209 = rows_1;
        if !((_e208 < _e209)) {
            break;
        }
    }
    let _e213 = c_4;
    let _e215 = blurred_2;
    let _e217 = r_1;
    let _e218 = m_1;
    let _e219 = c_4;
    let _e220 = c_4;
    exponent_1 = (19.739208f * (dot((wave + _e213), _e215) + (_e217 * dot(_e218, (_e219 * _e220)))));
    let _e227 = c_4;
    mean = (wave + _e227);
    let _e230 = lambda;
    let _e231 = m_1;
    let _e233 = m_1;
    before = (_e230 * sqrt((_e231.yx / _e233)));
    let _e239 = mean;
    let _e241 = value_7;
    let _e243 = next_x;
    let _e245 = before;
    let _e247 = next_y;
    x_5 = (6.2831855f * (((_e239.x * _e241) + _e243) - (_e245.x * _e247)));
    let _e253 = mean;
    let _e255 = value_7;
    let _e257 = next_y;
    let _e259 = before;
    let _e261 = next_x;
    y_4 = (6.2831855f * (((_e253.y * _e255) + _e257) - (_e259.y * _e261)));
    let _e267 = lambda;
    let _e268 = lambda;
    let _e272 = exponent_1;
    if false {
        local_19 = 1f;
    } else {
        local_19 = 1.125f;
    }
    let _e286 = local_19;
    scale_1 = ((sqrt((1f - (_e267 * _e268))) * exp(-(_e272))) / (1459955300000000000000000000f * _e286));
    let _e290 = scale_1;
    let _e291 = value_7;
    let _e293 = scale_1;
    let _e294 = x_5;
    let _e297 = x_5;
    let _e301 = scale_1;
    let _e302 = y_4;
    let _e305 = y_4;
    return GaborField((_e290 * _e291), (_e293 * vec2<f32>(-(_e294.y), _e297.x)), (_e301 * vec2<f32>(-(_e302.y), _e305.x)));
}

// The share of the form with seven waves in the filtered noise; the rest is the form with three.
fn gabor_impl_wide_share(footprint: GaborFootprint) -> f32 {
    return clamp(((100f * sqrt(max(footprint.resolved.x, footprint.resolved.y))) - 9f), 0f, 1f);
}

fn gabor_impl_filtered(place: GaborPlace, kernel: GaborKernel, footprint: GaborFootprint, wide: f32, seed: u32, removed: ptr<function, f32>) -> GaborField {
    var kernel_7: GaborKernel;
    var stretch_1: vec2<f32>;
    var wave_15: vec2<f32>;
    var transmitted: f32;
    var sum_9: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var s_4: vec3<f32>;
    var salt_7: u32;
    var amplitude_3: f32 = 1f;
    kernel_7 = kernel;
    stretch_1 = (place.radius / vec2(1.5f));
    let _e15 = kernel_7;
    let _e17 = stretch_1;
    wave_15 = (_e15.wave / _e17);
    let _e20 = wave_15;
    let _e22 = gabor_impl_transmitted(_e20, footprint.covariance);
    transmitted = _e22;
    let _e25 = transmitted;
    (*removed) = (1f - _e25);
    let _e35 = transmitted;
    if (_e35 < 0.0000000001f) {
        let _e38 = sum_9;
        return _e38;
    }
    s_4 = footprint.resolved;
    let _e41 = gabor_impl_salt(seed);
    salt_7 = _e41;
    if (distance(footprint.resolved, footprint.covariance) > 0f) {
        let _e50 = amplitude_3;
        let _e51 = transmitted;
        let _e52 = wave_15;
        let _e53 = s_4;
        let _e54 = gabor_impl_transmitted(_e52, _e53);
        amplitude_3 = (_e50 * sqrt((_e51 / _e54)));
    }
    if (wide < 1f) {
        let _e61 = wave_15;
        let _e62 = s_4;
        let _e63 = salt_7;
        let _e64 = gabor_impl_filtered_narrow(place, _e61, _e62, _e63);
        let _e67 = amplitude_3;
        gabor_impl_add_field((&sum_9), _e64, ((1f - wide) * _e67));
    }
    if (wide > 0f) {
        let _e73 = wave_15;
        let _e74 = s_4;
        let _e77 = salt_7;
        let _e78 = gabor_impl_filtered_wide(place, _e73, _e74, (wide > 0f), _e77);
        let _e79 = amplitude_3;
        gabor_impl_add_field((&sum_9), _e78, (wide * _e79));
    }
    let _e83 = sum_9;
    let _e85 = stretch_1;
    sum_9.slope_x = (_e83.slope_x * _e85.x);
    let _e89 = sum_9;
    let _e91 = stretch_1;
    sum_9.slope_y = (_e89.slope_y * _e91.y);
    let _e94 = sum_9;
    return _e94;
}

fn gabor_field_filtered(place: GaborPlace, kernel: GaborKernel, footprint: GaborFootprint, seed: u32, removed: ptr<function, f32>) -> GaborField {
    var kernel_9: GaborKernel;
    kernel_9 = kernel;
    let _e6 = kernel_9;
    let _e7 = gabor_impl_wide_share(footprint);
    let _e10 = gabor_impl_filtered(place, _e6, footprint, _e7, seed, removed);
    return _e10;
}

// ---- The filter in space -------------------------------------------------------------------------------------------
//
// For gabor_noise_3d.wgsl. With M = S + v, a diagonal matrix D with D_ii^2 = M_ii / (M^-1)_ii, C = D^(-1/2) M
// D^(-1/2), B = (1 - C) (1 + C)^-1 and z = 2 pi D^(1/2) (q - c), the coupling of three axes is again a sum of products:
//     exp(-z.C z / 2) = sqrt(8 / |1 + C|) exp(-z.z / 2) (1 + 2 (B_yz z_y z_z + B_zx z_z z_x + B_xy z_x z_y) + ...).
// The right side is the series of exp(z.B z) with Hermite polynomials instead of powers of z, and without B's diagonal,
// which is at most 0.01. We use the terms up to the square of each factor.

// A symmetric 3 x 3 matrix.
struct GaborMatrix {
    diagonal: vec3<f32>,
    mixed: vec3<f32>,
}

fn gabor_impl_symmetric_3d(m: GaborMatrix, v: vec3<f32>) -> vec3<f32> {
    return (((m.diagonal * v) + (m.mixed.zxy * v.yzx)) + (m.mixed.yzx * v.zxy));
}

// The inverse times the determinant.
fn gabor_impl_adjugate(m: GaborMatrix, determinant: ptr<function, f32>) -> GaborMatrix {
    var a_4: GaborMatrix;
    a_4 = GaborMatrix(((m.diagonal.yzx * m.diagonal.zxy) - (m.mixed * m.mixed)), ((m.mixed.yzx * m.mixed.zxy) - (m.diagonal * m.mixed)));
    let _e24 = a_4;
    let _e30 = a_4;
    let _e37 = a_4;
    (*determinant) = (((m.diagonal.x * _e24.diagonal.x) + (m.mixed.y * _e30.mixed.y)) + (m.mixed.z * _e37.mixed.z));
    let _e42 = a_4;
    return _e42;
}

// The word of a row in a slice of nodes: odd with 24 bits, like the words of lines.
fn gabor_impl_slice_word(row: u32, slice: u32) -> u32 {
    return (((row * slice) >> 8u) | 8388609u);
}

// The multiplier of each factor along z. y_0, y_1 and y_2 are the factors along y, and their components are the factors
// along x. `w` is the coupling of y and z, z and x, x and y.
fn gabor_impl_along_z(y_0: vec3<f32>, y_1: vec3<f32>, y_2: vec3<f32>, w: vec3<f32>) -> vec3<f32> {
    return vec3<f32>((y_0.x + (w.z * (y_1.y + ((0.5f * w.z) * y_2.z)))), ((w.y * (y_0.y + (w.z * y_1.z))) + (w.x * (y_1.x + (w.z * y_2.y)))), ((0.5f * (((w.y * w.y) * y_0.z) + ((w.x * w.x) * y_2.x))) + ((w.x * w.y) * (y_1.y + (w.z * y_2.z)))));
}

// The weighted sum of the products of three axes' factors.
fn gabor_impl_contracted_3d(y_0: GaborFactors, y_1: GaborFactors, y_2: GaborFactors, z: GaborFactors, w: vec3<f32>) -> vec2<f32> {
    var slice_1: GaborFactors;
    let _e8 = gabor_impl_along_z(y_0.real, y_1.real, y_2.real, w);
    let _e12 = gabor_impl_along_z(y_0.imaginary, y_1.imaginary, y_2.imaginary, w);
    slice_1 = GaborFactors(_e8, _e12);
    let _e15 = slice_1;
    let _e18 = gabor_impl_contracted(_e15, z, vec3(1f));
    return _e18;
}

// Computes the filtered noise in space and its derivatives at `local`, in node spacings from a cell's corner, with
// seven waves along each axis. If not `wanted`, computes only one row.
fn gabor_impl_filtered_space(cell: vec3<i32>, local: vec3<f32>, period: vec3<i32>, animated: bool, moment: f32, wave: vec3<f32>, s: GaborMatrix, wanted: bool, salt: u32, noise: ptr<function, vec4<f32>>, quadrature: ptr<function, vec4<f32>>) {
    var determinant_1: f32;
    var m_4: GaborMatrix;
    var adjugate: GaborMatrix;
    var blurred_3: vec3<f32>;
    var c_5: vec3<f32>;
    var d_1: vec3<f32>;
    var pairs: vec3<f32>;
    var w_2: vec3<f32>;
    var x_6: GaborFilteredAxis;
    var y_5: GaborFilteredAxis;
    var z_2: GaborFilteredAxis;
    var columns_4: GaborColumns;
    var first: GaborFilteredLine;
    var slice_2: GaborFilteredLine;
    var none: GaborFactors = GaborFactors(vec3(0f), vec3(0f));
    var local_21: i32;
    var rows_2: i32;
    var local_22: i32;
    var slices: i32;
    var value_8: vec2<f32> = vec2(0f);
    var next_x_1: vec2<f32> = vec2(0f);
    var next_y_1: vec2<f32> = vec2(0f);
    var next_z: vec2<f32> = vec2(0f);
    var k: i32 = 0i;
    var y_0_2: GaborFactors;
    var y_1_2: GaborFactors;
    var y_2_2: GaborFactors;
    var row_5: GaborFilteredLine;
    var j_3: i32;
    var sum_10: GaborFactors;
    var real_2: vec3<f32>;
    var imaginary_2: vec3<f32>;
    var quarter_1: vec3<f32>;
    var exponent_2: f32;
    var local_23: f32;
    var scale_2: f32;
    var local_24: f32;
    m_4 = GaborMatrix((s.diagonal + vec3(0.13069098f)), s.mixed);
    let _e19 = m_4;
    let _e22 = gabor_impl_adjugate(_e19, (&determinant_1));
    adjugate = _e22;
    let _e24 = gabor_impl_symmetric_3d(s, wave);
    blurred_3 = _e24;
    let _e26 = adjugate;
    let _e27 = blurred_3;
    let _e28 = gabor_impl_symmetric_3d(_e26, _e27);
    let _e29 = determinant_1;
    c_5 = (_e28 / vec3(-(_e29)));
    let _e34 = m_4;
    let _e36 = determinant_1;
    let _e38 = adjugate;
    d_1 = sqrt(((_e34.diagonal * _e36) / _e38.diagonal));
    let _e43 = d_1;
    let _e45 = d_1;
    pairs = sqrt((_e43.yzx * _e45.zxy));
    let _e51 = m_4;
    let _e53 = d_1;
    let _e58 = pairs;
    let _e63 = gabor_impl_adjugate(GaborMatrix((vec3(1f) + (_e51.diagonal / _e53)), (s.mixed / _e58)), (&determinant_1));
    adjugate = _e63;
    let _e65 = determinant_1;
    let _e67 = pairs;
    let _e69 = adjugate;
    w_2 = (((157.91367f / _e65) * _e67) * _e69.mixed);
    let _e76 = d_1;
    let _e78 = c_5;
    let _e89 = gabor_impl_wave((wave.x / 1.5f));
    let _e90 = gabor_impl_filtered_axis(sqrt(s.diagonal.x), _e76.x, _e78.x, cell.x, local.x, period.x, salt, _e89);
    x_6 = _e90;
    let _e95 = d_1;
    let _e97 = c_5;
    let _e110 = gabor_impl_wave((wave.y / 1.5f));
    let _e111 = gabor_impl_filtered_axis(sqrt(s.diagonal.y), _e95.y, _e97.y, cell.y, local.y, period.y, (salt ^ 1540483477u), _e110);
    y_5 = _e111;
    let _e116 = d_1;
    let _e118 = c_5;
    let _e131 = gabor_impl_wave((wave.z / 1.5f));
    let _e132 = gabor_impl_filtered_axis(sqrt(s.diagonal.z), _e116.z, _e118.z, cell.z, local.z, period.z, (salt ^ 668265263u), _e131);
    z_2 = _e132;
    let _e134 = x_6;
    let _e135 = gabor_impl_columns(_e134);
    columns_4 = _e135;
    let _e137 = y_5;
    let _e138 = y_5;
    let _e141 = y_5;
    let _e146 = gabor_impl_line_before(_e137, vec2<f32>(_e138.back.x, -(_e141.back.y)));
    first = _e146;
    let _e148 = z_2;
    let _e149 = x_6;
    let _e151 = y_5;
    let _e153 = z_2;
    let _e164 = gabor_impl_wave((dot(wave, vec3<f32>(_e149.offset, _e151.offset, (_e153.offset + 1f))) / 1.5f));
    let _e165 = gabor_impl_line_before(_e148, _e164);
    slice_2 = _e165;
    if wanted {
        let _e173 = y_5;
        local_21 = _e173.count;
    } else {
        local_21 = 0i;
    }
    let _e177 = local_21;
    rows_2 = _e177;
    if wanted {
        let _e179 = z_2;
        local_22 = _e179.count;
    } else {
        local_22 = 0i;
    }
    let _e183 = local_22;
    slices = _e183;
    loop {
        {
            let _e199 = slice_2;
            let _e200 = z_2;
            let _e201 = k;
            let _e202 = z_2;
            let _e203 = k;
            let _e204 = gabor_impl_fade(_e202, _e203);
            let _e205 = gabor_impl_next_line(_e199, _e200, _e201, _e204);
            slice_2 = _e205;
            let _e206 = none;
            y_0_2 = _e206;
            let _e208 = none;
            y_1_2 = _e208;
            let _e210 = none;
            y_2_2 = _e210;
            let _e212 = first;
            row_5 = _e212;
            j_3 = 0i;
            loop {
                {
                    let _e216 = row_5;
                    let _e217 = y_5;
                    let _e218 = j_3;
                    let _e219 = y_5;
                    let _e220 = j_3;
                    let _e221 = gabor_impl_fade(_e219, _e220);
                    let _e222 = gabor_impl_next_line(_e216, _e217, _e218, _e221);
                    row_5 = _e222;
                    let _e223 = columns_4;
                    let _e224 = row_5;
                    let _e226 = slice_2;
                    let _e228 = gabor_impl_slice_word(_e224.word, _e226.word);
                    let _e229 = gabor_impl_filtered_row(_e223, _e228, animated, moment);
                    sum_10 = _e229;
                    let _e231 = y_0_2;
                    let _e232 = sum_10;
                    let _e233 = row_5;
                    let _e237 = row_5;
                    let _e241 = gabor_impl_plus_product(_e231, _e232, _e233.window.real.x, _e237.window.imaginary.x);
                    y_0_2 = _e241;
                    let _e242 = y_1_2;
                    let _e243 = sum_10;
                    let _e244 = row_5;
                    let _e248 = row_5;
                    let _e252 = gabor_impl_plus_product(_e242, _e243, _e244.window.real.y, _e248.window.imaginary.y);
                    y_1_2 = _e252;
                    let _e253 = y_2_2;
                    let _e254 = sum_10;
                    let _e255 = row_5;
                    let _e259 = row_5;
                    let _e263 = gabor_impl_plus_product(_e253, _e254, _e255.window.real.z, _e259.window.imaginary.z);
                    y_2_2 = _e263;
                }
                let _e264 = j_3;
                let _e266 = (_e264 + 1i);
                j_3 = _e266;
                let _e267 = rows_2;
                if !((_e266 < _e267)) {
                    break;
                }
            }
            let _e270 = value_8;
            let _e271 = y_0_2;
            let _e272 = y_1_2;
            let _e273 = y_2_2;
            let _e274 = slice_2;
            let _e276 = w_2;
            let _e277 = gabor_impl_contracted_3d(_e271, _e272, _e273, _e274.window, _e276);
            value_8 = (_e270 + _e277);
            let _e279 = next_x_1;
            let _e280 = y_0_2;
            let _e281 = gabor_impl_next(_e280);
            let _e282 = y_1_2;
            let _e283 = gabor_impl_next(_e282);
            let _e284 = y_2_2;
            let _e285 = gabor_impl_next(_e284);
            let _e286 = slice_2;
            let _e288 = w_2;
            let _e289 = gabor_impl_contracted_3d(_e281, _e283, _e285, _e286.window, _e288);
            next_x_1 = (_e279 + _e289);
            let _e291 = next_y_1;
            let _e292 = y_1_2;
            let _e293 = y_2_2;
            let _e294 = none;
            let _e295 = slice_2;
            let _e297 = w_2;
            let _e298 = gabor_impl_contracted_3d(_e292, _e293, _e294, _e295.window, _e297);
            next_y_1 = (_e291 + _e298);
            let _e300 = next_z;
            let _e301 = y_0_2;
            let _e302 = y_1_2;
            let _e303 = y_2_2;
            let _e304 = slice_2;
            let _e306 = gabor_impl_next(_e304.window);
            let _e307 = w_2;
            let _e308 = gabor_impl_contracted_3d(_e301, _e302, _e303, _e306, _e307);
            next_z = (_e300 + _e308);
        }
        let _e310 = k;
        let _e312 = (_e310 + 1i);
        k = _e312;
        let _e313 = slices;
        if !((_e312 < _e313)) {
            break;
        }
    }
    let _e316 = next_x_1;
    let _e318 = next_y_1;
    let _e320 = next_z;
    real_2 = vec3<f32>(_e316.x, _e318.x, _e320.x);
    let _e324 = next_x_1;
    let _e326 = next_y_1;
    let _e328 = next_z;
    imaginary_2 = vec3<f32>(_e324.y, _e326.y, _e328.y);
    let _e333 = d_1;
    quarter_1 = (vec3(0.012665148f) / _e333);
    let _e337 = real_2;
    let _e338 = c_5;
    let _e340 = value_8;
    let _e343 = quarter_1;
    let _e346 = w_2;
    let _e348 = real_2;
    let _e349 = gabor_impl_symmetric_3d(GaborMatrix(vec3(0f), _e346), _e348);
    real_2 = (_e337 + (((wave + _e338) * _e340.x) + (_e343 * _e349)));
    let _e353 = imaginary_2;
    let _e354 = c_5;
    let _e356 = value_8;
    let _e359 = quarter_1;
    let _e362 = w_2;
    let _e364 = imaginary_2;
    let _e365 = gabor_impl_symmetric_3d(GaborMatrix(vec3(0f), _e362), _e364);
    imaginary_2 = (_e353 + (((wave + _e354) * _e356.y) + (_e359 * _e365)));
    let _e370 = c_5;
    let _e372 = blurred_3;
    let _e374 = d_1;
    let _e375 = c_5;
    let _e376 = c_5;
    exponent_2 = (19.739208f * (dot((wave + _e370), _e372) + dot(_e374, (_e375 * _e376))));
    let _e383 = determinant_1;
    if false {
        local_23 = 1f;
    } else {
        local_23 = 1.125f;
    }
    let _e394 = local_23;
    let _e397 = exponent_2;
    scale_2 = (sqrt(((8f / _e383) / _e394)) * exp(-(_e397)));
    let _e402 = scale_2;
    if false {
        local_24 = 1f;
    } else {
        local_24 = 1.125f;
    }
    let _e413 = local_24;
    scale_2 = (_e402 / (1459955300000000000000000000f * _e413));
    let _e416 = scale_2;
    let _e417 = value_8;
    let _e420 = real_2;
    let _e421 = (6.2831855f * _e420);
    (*noise) = (_e416 * vec4<f32>(_e417.y, _e421.x, _e421.y, _e421.z));
    let _e427 = scale_2;
    let _e428 = value_8;
    let _e432 = imaginary_2;
    let _e433 = (-6.2831855f * _e432);
    (*quadrature) = (_e427 * vec4<f32>(_e428.x, _e433.x, _e433.y, _e433.z));
    return;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------
//
// Node c emits waves along three unit vectors u_cm, 60 degrees apart and turned at random, each with its own amplitude:
//     n(p) = K / sqrt(3) Im sum_c h_c sum_m A_cm exp(2 pi i F u_cm.(p - c)).
// Given the directions, n is normal with variance 1. Its gradient is normal with the constant covariance
// K^2 E|A|^2 / 2 sum_c (grad h grad h^T + 2 pi^2 F^2 h^2 I), because sum_m u_cm u_cm^T = 3/2 I, with I the identity.
// Value and gradient are independent. Since none of this depends on the directions, both are also normal over random
// directions.

// Derives four more words from a row's word. Multiplied by a column's word, each is as random as a node's own word.
fn gabor_impl_row(word: u32) -> vec4<u32> {
    var first_1: u32;
    var second_1: u32;
    var third_1: u32;
    var fourth: u32;
    first_1 = ((word ^ (word >> 15u)) * 3545902487u);
    let _e7 = first_1;
    let _e8 = first_1;
    second_1 = ((_e7 ^ (_e8 >> 15u)) * 3545902487u);
    let _e15 = second_1;
    let _e16 = second_1;
    third_1 = ((_e15 ^ (_e16 >> 15u)) * 3545902487u);
    let _e23 = third_1;
    let _e24 = third_1;
    fourth = ((_e23 ^ (_e24 >> 15u)) * 3545902487u);
    let _e31 = first_1;
    let _e36 = second_1;
    let _e41 = third_1;
    let _e46 = fourth;
    return vec4<u32>(((_e31 >> 8u) | 8388609u), ((_e36 >> 8u) | 8388609u), ((_e41 >> 8u) | 8388609u), ((_e46 >> 8u) | 8388609u));
}

// The windows of a node along both axes, and their derivatives. Filtered windows are middle + cosine, and their
// derivatives `sine`.
struct GaborWindows {
    value: vec2<f32>,
    slope: vec2<f32>,
    middle: vec2<f32>,
    cosine: vec2<f32>,
    sine: vec2<f32>,
}

// The covariance of a filter, and the factors by which it damps the cosines of the windows.
struct GaborFilter {
    used: bool,
    covariance: vec3<f32>,
    fall: vec2<f32>,
}

// Adds a node's wave. `a` is its amplitude times the wave at the point. The filter multiplies it by exp(-2 pi^2 F.S F)
// and shifts its window along each axis by i x / pi, x = 2 pi^2 S F: see gabor_impl_filtered_node.
fn gabor_impl_add_node_wave(sum: ptr<function, GaborField>, node: GaborWindows, pixel: GaborFilter, a: vec2<f32>, wave: vec2<f32>) {
    var a_6: vec2<f32>;
    var value_9: vec2<f32>;
    var slope_x: vec2<f32>;
    var slope_y: vec2<f32>;
    var x_7: vec2<f32>;
    var y_6: vec2<f32>;
    var even_2: vec2<f32>;
    var odd_2: vec2<f32>;
    var real_3: vec2<f32>;
    var imaginary_3: vec2<f32>;
    var h_x: vec2<f32>;
    var h_y: vec2<f32>;
    var turned_1: vec2<f32>;
    a_6 = a;
    let _e11 = a_6;
    value_9 = ((node.value.x * node.value.y) * _e11);
    let _e19 = a_6;
    slope_x = ((node.slope.x * node.value.y) * _e19);
    let _e27 = a_6;
    slope_y = ((node.value.x * node.slope.y) * _e27);
    if pixel.used {
        {
            let _e33 = gabor_impl_symmetric(pixel.covariance, wave);
            x_7 = (19.739208f * _e33);
            let _e36 = a_6;
            let _e37 = x_7;
            a_6 = (_e36 * exp(-(max(dot(wave, _e37), 0f))));
            let _e44 = x_7;
            x_7 = clamp(_e44, vec2(-3f), vec2(3f));
            let _e51 = x_7;
            let _e52 = x_7;
            y_6 = (_e51 * _e52);
            let _e56 = y_6;
            let _e59 = y_6;
            even_2 = (vec2(1f) + (_e56 * (vec2(0.5f) + (0.041666668f * _e59))));
            let _e67 = x_7;
            let _e69 = y_6;
            let _e72 = y_6;
            odd_2 = (_e67 * (vec2(1f) + (_e69 * (vec2(0.16666667f) + (0.008333333f * _e72)))));
            let _e82 = even_2;
            real_3 = (node.middle + (_e82 * node.cosine));
            let _e88 = odd_2;
            imaginary_3 = ((0.3183099f * _e88) * node.sine);
            let _e93 = real_3;
            let _e95 = imaginary_3;
            h_x = vec2<f32>(_e93.x, _e95.x);
            let _e99 = real_3;
            let _e101 = imaginary_3;
            h_y = vec2<f32>(_e99.y, _e101.y);
            let _e105 = h_x;
            let _e106 = h_y;
            let _e107 = gabor_impl_product(_e105, _e106);
            let _e119 = a_6;
            let _e120 = gabor_impl_product((_e107 + vec2<f32>(((pixel.covariance.z * node.sine.x) * node.sine.y), 0f)), _e119);
            value_9 = _e120;
            let _e121 = even_2;
            real_3 = (_e121 * node.sine);
            let _e126 = odd_2;
            imaginary_3 = ((-3.1415927f * _e126) * node.cosine);
            let _e130 = real_3;
            let _e132 = imaginary_3;
            let _e135 = h_y;
            let _e136 = gabor_impl_product(vec2<f32>(_e130.x, _e132.x), _e135);
            let _e137 = a_6;
            let _e138 = gabor_impl_product(_e136, _e137);
            slope_x = _e138;
            let _e139 = h_x;
            let _e140 = real_3;
            let _e142 = imaginary_3;
            let _e145 = gabor_impl_product(_e139, vec2<f32>(_e140.y, _e142.y));
            let _e146 = a_6;
            let _e147 = gabor_impl_product(_e145, _e146);
            slope_y = _e147;
        }
    }
    let _e149 = value_9;
    let _e152 = value_9;
    turned_1 = (6.2831855f * vec2<f32>(-(_e149.y), _e152.x));
    let _e158 = (*sum);
    let _e160 = value_9;
    (*sum).value = (_e158.value + _e160);
    let _e163 = (*sum);
    let _e165 = slope_x;
    let _e167 = turned_1;
    (*sum).slope_x = (_e163.slope_x + (_e165 + (wave.x * _e167)));
    let _e172 = (*sum);
    let _e174 = slope_y;
    let _e176 = turned_1;
    (*sum).slope_y = (_e172.slope_y + (_e174 + (wave.y * _e176)));
    return;
}

// Adds a node's three waves, at `d` node spacings from it. The third phase is the difference of the other two.
fn gabor_impl_add_node_waves(sum: ptr<function, GaborField>, place: GaborPlace, node: GaborWindows, pixel: GaborFilter, d: vec2<f32>, frequency: f32, words: vec4<u32>) {
    var node_2: GaborWindows;
    var d_3: vec2<f32>;
    var fade_4: vec2<f32>;
    var u_1: vec2<f32>;
    var v_2: vec2<f32>;
    var first_2: vec2<f32>;
    var second_2: vec2<f32>;
    var third_2: vec2<f32>;
    node_2 = node;
    d_3 = d;
    if pixel.used {
        {
            let _e11 = d_3;
            fade_4 = clamp(((vec2(1f) - (abs(_e11) / vec2(1.5f))) / clamp((0.5f * sqrt(pixel.covariance.xy)), vec2(0.001f), vec2(0.05f))), vec2(0f), vec2(1f));
            let _e38 = fade_4;
            let _e39 = fade_4;
            let _e42 = fade_4;
            fade_4 = (_e38 * (_e39 * (vec2(3f) - (2f * _e42))));
            let _e50 = fade_4;
            node_2.middle = (0.5f * _e50);
            let _e53 = fade_4;
            let _e56 = node_2;
            node_2.cosine = ((_e53 * pixel.fall) * (_e56.value - vec2(0.5f)));
            let _e63 = fade_4;
            let _e66 = node_2;
            node_2.sine = ((_e63 * pixel.fall) * _e66.slope);
        }
    }
    let _e69 = d_3;
    d_3 = (_e69 * (vec2(frequency) / place.radius));
    let _e79 = gabor_impl_half_turn((0.00000000003880511f * f32(i32(words.w))));
    u_1 = _e79;
    let _e82 = u_1;
    let _e85 = u_1;
    let _e88 = u_1;
    v_2 = ((0.5f * _e82) + (0.8660254f * vec2<f32>(-(_e85.y), _e88.x)));
    let _e94 = u_1;
    let _e95 = d_3;
    let _e97 = gabor_impl_wave(dot(_e94, _e95));
    first_2 = _e97;
    let _e99 = v_2;
    let _e100 = d_3;
    let _e102 = gabor_impl_wave(dot(_e99, _e100));
    second_2 = _e102;
    let _e104 = second_2;
    let _e105 = first_2;
    let _e107 = first_2;
    let _e111 = gabor_impl_product(_e104, vec2<f32>(_e105.x, -(_e107.y)));
    third_2 = _e111;
    let _e116 = gabor_impl_amplitude_at(words.x, place.animated, place.moment);
    let _e117 = first_2;
    let _e118 = gabor_impl_product(_e116, _e117);
    first_2 = _e118;
    let _e122 = gabor_impl_amplitude_at(words.y, place.animated, place.moment);
    let _e123 = second_2;
    let _e124 = gabor_impl_product(_e122, _e123);
    second_2 = _e124;
    let _e128 = gabor_impl_amplitude_at(words.z, place.animated, place.moment);
    let _e129 = third_2;
    let _e130 = gabor_impl_product(_e128, _e129);
    third_2 = _e130;
    let _e132 = node_2;
    let _e133 = first_2;
    let _e134 = u_1;
    gabor_impl_add_node_wave(sum, _e132, pixel, _e133, (frequency * _e134));
    let _e138 = node_2;
    let _e139 = second_2;
    let _e140 = v_2;
    gabor_impl_add_node_wave(sum, _e138, pixel, _e139, (frequency * _e140));
    let _e144 = node_2;
    let _e145 = third_2;
    let _e146 = v_2;
    let _e147 = u_1;
    gabor_impl_add_node_wave(sum, _e144, pixel, _e145, (frequency * (_e146 - _e147)));
    return;
}

// The sum over all nodes, without the factor GABOR_IMPL_STAR. Unrolling the loops by hand made them four times slower
// on lavapipe.
fn gabor_impl_sum_isotropic_2d(place: GaborPlace, frequency: f32, pixel: GaborFilter, seed: u32) -> GaborField {
    var frequency_11: f32;
    var salt_9: u32;
    var x_8: GaborAxis;
    var y_7: GaborAxis;
    var stretch_2: vec2<f32>;
    var sum_13: GaborField = GaborField(vec2(0f), vec2(0f), vec2(0f));
    var j_4: i32 = 0i;
    var row_6: vec4<u32>;
    var i_4: i32;
    var node_3: GaborWindows;
    var d_4: vec2<f32>;
    frequency_11 = frequency;
    let _e5 = gabor_impl_salt(seed);
    salt_9 = _e5;
    let _e13 = salt_9;
    let _e17 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e13, 0f, place.radius.x);
    x_8 = _e17;
    let _e25 = salt_9;
    let _e31 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e25 ^ 1540483477u), 0f, place.radius.y);
    y_7 = _e31;
    stretch_2 = (place.radius / vec2(1.5f));
    let _e41 = frequency_11;
    frequency_11 = min(abs(_e41), 1000000f);
    loop {
        let _e55 = j_4;
        if !((_e55 < 3i)) {
            break;
        }
        {
            let _e62 = j_4;
            let _e65 = y_7.word[_e62];
            let _e66 = gabor_impl_row(_e65);
            row_6 = _e66;
            i_4 = 0i;
            loop {
                let _e70 = i_4;
                if !((_e70 < 3i)) {
                    break;
                }
                {
                    let _e79 = i_4;
                    let _e82 = x_8.node[_e79];
                    let _e84 = j_4;
                    let _e87 = y_7.node[_e84];
                    node_3.value = vec2<f32>(_e82.x, _e87.x);
                    let _e91 = stretch_2;
                    let _e92 = i_4;
                    let _e95 = x_8.node[_e92];
                    let _e97 = j_4;
                    let _e100 = y_7.node[_e97];
                    node_3.slope = (_e91 * vec2<f32>(_e95.z, _e100.z));
                    let _e104 = x_8;
                    let _e106 = i_4;
                    let _e111 = y_7;
                    let _e113 = j_4;
                    d_4 = vec2<f32>((_e104.offset - f32((_e106 - 1i))), (_e111.offset - f32((_e113 - 1i))));
                    let _e121 = node_3;
                    let _e122 = d_4;
                    let _e123 = frequency_11;
                    let _e124 = i_4;
                    let _e127 = x_8.word[_e124];
                    let _e128 = row_6;
                    gabor_impl_add_node_waves((&sum_13), place, _e121, pixel, _e122, _e123, (_e127 * _e128));
                }
                continuing {
                    let _e74 = i_4;
                    i_4 = (_e74 + 1i);
                }
            }
        }
        continuing {
            let _e59 = j_4;
            j_4 = (_e59 + 1i);
        }
    }
    let _e131 = sum_13;
    return _e131;
}

fn gabor_impl_scaled_field(field: GaborField, scale: f32) -> GaborField {
    return GaborField((scale * field.value), (scale * field.slope_x), (scale * field.slope_y));
}

fn gabor_field_isotropic(place: GaborPlace, frequency: f32, seed: u32) -> GaborField {
    var none_1: GaborFilter = GaborFilter(false, vec3(0f), vec2(1f));
    var local_25: f32;
    let _e10 = none_1;
    let _e11 = gabor_impl_sum_isotropic_2d(place, frequency, _e10, seed);
    if false {
        local_25 = 1f;
    } else {
        local_25 = 1.125f;
    }
    let _e23 = local_25;
    let _e26 = gabor_impl_scaled_field(_e11, (0.57735026f / (1459955300000000000000000000f * _e23)));
    return _e26;
}

// The share of isotropic noise's variance that a filter keeps: the mean of gabor_impl_transmitted over all directions.
fn gabor_impl_transmitted_isotropic_2d(frequency: f32, covariance: vec3<f32>) -> f32 {
    var area_1: f32;
    var d_5: f32;
    var unit_2: f32;
    var apart: f32;
    var smaller: f32;
    area_1 = (6.579736f * ((covariance.x * covariance.y) - (covariance.z * covariance.z)));
    let _e17 = area_1;
    d_5 = (1f + (6.579736f * ((covariance.x + covariance.y) + _e17)));
    let _e23 = d_5;
    unit_2 = ((39.478416f / _e23) * min((frequency * frequency), 1000000000000f));
    apart = length(vec2<f32>((covariance.x - covariance.y), (2f * covariance.z)));
    let _e39 = area_1;
    let _e44 = apart;
    smaller = (_e39 + max((0.5f * ((covariance.x + covariance.y) - _e44)), 0f));
    let _e51 = unit_2;
    let _e52 = smaller;
    let _e59 = unit_2;
    let _e60 = apart;
    let _e64 = gabor_impl_mean_angle(min((_e59 * _e60), 100000000f));
    let _e66 = d_5;
    return ((exp(-(clamp((_e51 * _e52), 0f, 80f))) * _e64) * inverseSqrt(_e66));
}

fn gabor_field_isotropic_filtered(place: GaborPlace, frequency: f32, footprint: GaborFootprint, seed: u32, removed: ptr<function, f32>) -> GaborField {
    var kept: f32;
    var s_6: vec3<f32>;
    var pixel_3: GaborFilter;
    var local_26: f32;
    let _e6 = gabor_impl_transmitted_isotropic_2d(frequency, footprint.covariance);
    kept = _e6;
    let _e9 = kept;
    (*removed) = (1f - _e9);
    let _e11 = kept;
    if !((_e11 > 0.0000000001f)) {
        {
            (*removed) = 1f;
            return GaborField(vec2(0f), vec2(0f), vec2(0f));
        }
    }
    s_6 = footprint.covariance;
    let _e25 = s_6;
    let _e28 = s_6;
    let _e30 = s_6;
    let _e33 = s_6;
    let _e35 = s_6;
    let _e39 = s_6;
    s_6 = (_e25 * (0.04f / max((0.5f * ((_e28.x + _e30.y) + length(vec2<f32>((_e33.x - _e35.y), (2f * _e39.z))))), 0.04f)));
    let _e51 = s_6;
    let _e54 = s_6;
    pixel_3 = GaborFilter(true, _e51, exp((-4.934802f * _e54.xy)));
    let _e60 = pixel_3;
    let _e61 = gabor_impl_sum_isotropic_2d(place, frequency, _e60, seed);
    if false {
        local_26 = 1f;
    } else {
        local_26 = 1.125f;
    }
    let _e73 = local_26;
    let _e76 = kept;
    let _e77 = s_6;
    let _e78 = gabor_impl_transmitted_isotropic_2d(frequency, _e77);
    let _e82 = gabor_impl_scaled_field(_e61, ((0.57735026f / (1459955300000000000000000000f * _e73)) * sqrt((_e76 / _e78))));
    return _e82;
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_lobe(frequency: f32, orientation: f32, radius: f32, power: f32) -> GaborLobe {
    return GaborLobe(frequency, orientation, vec2(radius), power);
}

fn gabor_lobe_elliptical(frequency: f32, orientation: f32, radius: vec2<f32>, power: f32) -> GaborLobe {
    return GaborLobe(frequency, orientation, radius, power);
}

fn gabor_noise_lobes(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> f32 {
    var lobes_3: GaborLobes;
    lobes_3 = lobes;
    let _e11 = gabor_place(vec2(0i), (p * 1.5f));
    let _e12 = lobes_3;
    let _e13 = gabor_field_lobes(_e11, _e12, seed);
    return _e13.value.y;
}

fn gabor_noise_lobes_gradient(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec3<f32> {
    var lobes_5: GaborLobes;
    var field_6: GaborField;
    lobes_5 = lobes;
    let _e11 = gabor_place(vec2(0i), (p * 1.5f));
    let _e12 = lobes_5;
    let _e13 = gabor_field_lobes(_e11, _e12, seed);
    field_6 = _e13;
    let _e15 = field_6;
    let _e18 = field_6;
    let _e21 = field_6;
    return vec3<f32>(_e15.value.y, _e18.slope_x.y, _e21.slope_y.y);
}

fn gabor_noise_lobes_complex(p: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec2<f32> {
    var lobes_7: GaborLobes;
    lobes_7 = lobes;
    let _e11 = gabor_place(vec2(0i), (p * 1.5f));
    let _e12 = lobes_7;
    let _e13 = gabor_field_lobes(_e11, _e12, seed);
    return _e13.value;
}

fn gabor_noise_spread(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> f32 {
    var place_19: GaborPlace;
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    place_19 = _e13;
    let _e15 = place_19;
    let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
    return _e16.value.y;
}

fn gabor_noise_spread_gradient(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> vec3<f32> {
    var place_20: GaborPlace;
    var field_7: GaborField;
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    place_20 = _e13;
    let _e15 = place_20;
    let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
    field_7 = _e16;
    let _e18 = field_7;
    let _e21 = field_7;
    let _e24 = field_7;
    return vec3<f32>(_e18.value.y, _e21.slope_x.y, _e24.slope_y.y);
}

fn gabor_noise_spread_complex(p: vec2<f32>, frequency: f32, orientation: f32, frequency_spread: f32, orientation_spread: f32, seed: u32) -> vec2<f32> {
    var place_21: GaborPlace;
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    place_21 = _e13;
    let _e15 = place_21;
    let _e16 = gabor_field_spread(_e15, frequency, orientation, frequency_spread, orientation_spread, seed);
    return _e16.value;
}

fn gabor_noise_isotropic(p: vec2<f32>, frequency: f32, seed: u32) -> f32 {
    let _e10 = gabor_place(vec2(0i), (p * 1.5f));
    let _e11 = gabor_field_isotropic(_e10, frequency, seed);
    return _e11.value.y;
}

fn gabor_noise_isotropic_gradient(p: vec2<f32>, frequency: f32, seed: u32) -> vec3<f32> {
    var field_8: GaborField;
    let _e10 = gabor_place(vec2(0i), (p * 1.5f));
    let _e11 = gabor_field_isotropic(_e10, frequency, seed);
    field_8 = _e11;
    let _e13 = field_8;
    let _e16 = field_8;
    let _e19 = field_8;
    return vec3<f32>(_e13.value.y, _e16.slope_x.y, _e19.slope_y.y);
}

fn gabor_noise_isotropic_tiled(p: vec2<f32>, period: vec2<f32>, frequency: f32, seed: u32) -> f32 {
    var place_22: GaborPlace;
    let _e9 = gabor_place_tiled(p, clamp(period, vec2(0.0009765625f), vec2(1000000000f)));
    place_22 = _e9;
    let _e11 = place_22;
    let _e12 = gabor_field_isotropic(_e11, frequency, seed);
    return _e12.value.y;
}

fn gabor_footprint(dx: vec2<f32>, dy: vec2<f32>) -> GaborFootprint {
    var dx_1: vec2<f32>;
    var dy_1: vec2<f32>;
    var footprint_4: GaborFootprint;
    var mean_1: f32;
    var axis_2: vec2<f32>;
    var apart_1: f32;
    var larger: f32;
    var side: f32;
    var smaller_1: f32;
    var local_27: f32;
    dx_1 = dx;
    dy_1 = dy;
    let _e4 = dx_1;
    let _e5 = dx_1;
    let _e7 = dy_1;
    let _e8 = dy_1;
    if !(((dot(_e4, _e5) + dot(_e7, _e8)) < 1000000f)) {
        {
            dx_1 = vec2<f32>(100000f, 0f);
            dy_1 = vec2<f32>(0f, 100000f);
        }
    }
    let _e23 = dx_1;
    let _e24 = dx_1;
    let _e26 = dy_1;
    let _e27 = dy_1;
    let _e29 = ((_e23 * _e24) + (_e26 * _e27));
    let _e30 = dx_1;
    let _e32 = dx_1;
    let _e35 = dy_1;
    let _e37 = dy_1;
    footprint_4.covariance = (0.25f * vec3<f32>(_e29.x, _e29.y, ((_e30.x * _e32.y) + (_e35.x * _e37.y))));
    let _e46 = footprint_4;
    let _e49 = footprint_4;
    mean_1 = (0.5f * (_e46.covariance.x + _e49.covariance.y));
    let _e56 = footprint_4;
    let _e59 = footprint_4;
    let _e64 = footprint_4;
    axis_2 = vec2<f32>((0.5f * (_e56.covariance.x - _e59.covariance.y)), _e64.covariance.z);
    let _e69 = axis_2;
    apart_1 = length(_e69);
    let _e72 = mean_1;
    let _e73 = apart_1;
    larger = (_e72 + _e73);
    let _e77 = footprint_4;
    footprint_4.resolved = _e77.covariance;
    let _e79 = larger;
    if (_e79 > 0.25f) {
        {
            let _e83 = dx_1;
            let _e85 = dy_1;
            let _e88 = dx_1;
            let _e90 = dy_1;
            side = (0.25f * ((_e83.x * _e85.y) - (_e88.y * _e90.x)));
            let _e96 = side;
            let _e97 = larger;
            let _e99 = side;
            smaller_1 = min(((_e96 / _e97) * _e99), 0.25f);
            let _e104 = axis_2;
            let _e105 = apart_1;
            if (_e105 > 0f) {
                let _e110 = smaller_1;
                let _e113 = apart_1;
                local_27 = ((0.5f * (0.25f - _e110)) / _e113);
            } else {
                local_27 = 0f;
            }
            let _e117 = local_27;
            axis_2 = (_e104 * _e117);
            let _e122 = smaller_1;
            let _e125 = axis_2;
            let _e127 = axis_2;
            let _e135 = max((vec2((0.5f * (0.25f + _e122))) + vec2<f32>(_e125.x, -(_e127.x))), vec2(0f));
            let _e136 = axis_2;
            footprint_4.resolved = vec3<f32>(_e135.x, _e135.y, _e136.y);
        }
    }
    let _e141 = footprint_4;
    return _e141;
}

fn gabor_noise_filtered_gradient(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec4<f32> {
    var removed_3: f32;
    var field_9: GaborField;
    let _e14 = gabor_place(vec2(0i), (p * 1.5f));
    let _e15 = gabor_kernel(frequency, orientation);
    let _e16 = gabor_footprint(dx, dy);
    let _e19 = gabor_field_filtered(_e14, _e15, _e16, seed, (&removed_3));
    field_9 = _e19;
    let _e21 = field_9;
    let _e24 = field_9;
    let _e27 = field_9;
    let _e30 = removed_3;
    return vec4<f32>(_e21.value.y, _e24.slope_x.y, _e27.slope_y.y, _e30);
}

fn gabor_noise_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var field_10: vec4<f32>;
    let _e6 = gabor_noise_filtered_gradient(p, dx, dy, frequency, orientation, seed);
    field_10 = _e6;
    let _e8 = field_10;
    let _e10 = field_10;
    return vec2<f32>(_e8.x, _e10.w);
}

fn gabor_noise_isotropic_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, seed: u32) -> vec2<f32> {
    var removed_4: f32;
    var field_11: GaborField;
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    let _e14 = gabor_footprint(dx, dy);
    let _e17 = gabor_field_isotropic_filtered(_e13, frequency, _e14, seed, (&removed_4));
    field_11 = _e17;
    let _e19 = field_11;
    let _e22 = removed_4;
    return vec2<f32>(_e19.value.y, _e22);
}

fn gabor_noise_four_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32, removed: ptr<function, f32>) -> vec4<f32> {
    var four: vec4<f32>;
    var i_5: i32 = 0i;
    var local_28: u32;
    var noise_2: vec4<f32>;
    loop {
        let _e10 = i_5;
        if !((_e10 < 4i)) {
            break;
        }
        {
            let _e17 = i_5;
            if (_e17 == 0i) {
                local_28 = seed;
            } else {
                let _e20 = i_5;
                let _e22 = gabor_lobe_seed(seed, -(_e20));
                local_28 = _e22;
            }
            let _e24 = local_28;
            let _e25 = gabor_noise_filtered_gradient(p, dx, dy, frequency, orientation, _e24);
            noise_2 = _e25;
            let _e27 = i_5;
            let _e29 = noise_2;
            four[_e27] = _e29.x;
            let _e31 = noise_2;
            (*removed) = _e31.w;
        }
        continuing {
            let _e14 = i_5;
            i_5 = (_e14 + 1i);
        }
    }
    let _e33 = four;
    return _e33;
}

fn gabor_noise_lobes_filtered_gradient(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec4<f32> {
    var lobes_9: GaborLobes;
    var sum_14: vec4<f32> = vec4(0f);
    var power_3: f32 = 0f;
    var i_6: i32 = 0i;
    var lobe_2: GaborLobe;
    var unit_3: vec2<f32>;
    var removed_6: f32;
    var field_12: GaborField;
    var noise_3: vec3<f32>;
    var local_29: vec4<f32>;
    lobes_9 = lobes;
    loop {
        let _e13 = i_6;
        let _e14 = lobes_9;
        if !((_e13 < min(_e14.count, 4i))) {
            break;
        }
        {
            let _e23 = i_6;
            let _e26 = lobes_9.lobe[_e23];
            lobe_2 = _e26;
            let _e29 = lobe_2;
            unit_3 = (vec2(1f) / _e29.radius);
            let _e37 = unit_3;
            let _e44 = gabor_place(vec2(0i), ((p * _e37) * 1.5f));
            let _e45 = lobe_2;
            let _e46 = gabor_impl_lobe_kernel(_e45);
            let _e47 = unit_3;
            let _e49 = unit_3;
            let _e51 = gabor_footprint((dx * _e47), (dy * _e49));
            let _e52 = i_6;
            let _e53 = gabor_lobe_seed(seed, _e52);
            let _e56 = gabor_field_filtered(_e44, _e46, _e51, _e53, (&removed_6));
            field_12 = _e56;
            let _e58 = field_12;
            let _e61 = unit_3;
            let _e63 = field_12;
            let _e67 = unit_3;
            let _e69 = field_12;
            noise_3 = vec3<f32>(_e58.value.y, (_e61.x * _e63.slope_x.y), (_e67.y * _e69.slope_y.y));
            let _e75 = sum_14;
            let _e76 = lobe_2;
            let _e79 = noise_3;
            let _e80 = (sqrt(_e76.power) * _e79);
            let _e81 = lobe_2;
            let _e83 = removed_6;
            sum_14 = (_e75 + vec4<f32>(_e80.x, _e80.y, _e80.z, (_e81.power * _e83)));
            let _e90 = power_3;
            let _e91 = lobe_2;
            power_3 = (_e90 + _e91.power);
        }
        continuing {
            let _e20 = i_6;
            i_6 = (_e20 + 1i);
        }
    }
    let _e94 = power_3;
    if (_e94 > 0f) {
        let _e97 = sum_14;
        let _e98 = power_3;
        let _e100 = vec3(inverseSqrt(_e98));
        let _e102 = power_3;
        local_29 = (_e97 * vec4<f32>(_e100.x, _e100.y, _e100.z, (1f / _e102)));
    } else {
        local_29 = vec4(0f);
    }
    let _e112 = local_29;
    return _e112;
}

fn gabor_noise_lobes_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> vec2<f32> {
    var lobes_11: GaborLobes;
    var field_13: vec4<f32>;
    lobes_11 = lobes;
    let _e6 = lobes_11;
    let _e7 = gabor_noise_lobes_filtered_gradient(p, dx, dy, _e6, seed);
    field_13 = _e7;
    let _e9 = field_13;
    let _e11 = field_13;
    return vec2<f32>(_e9.x, _e11.w);
}

// For z = v + sqrt(r) times a complex normal number with independent parts, the mean of z / |z| is about
// v / sqrt(|v|^2 + 8/pi r), and the mean of |z| about sqrt(|v|^2 + pi/2 r). Both are exact for small and for large |v|.
fn gabor_stripes_filtered_at(place: GaborPlace, wave: vec2<f32>, footprint: GaborFootprint, sharpness: f32, seed: u32) -> vec4<f32> {
    var removed_7: f32;
    var value_10: vec2<f32>;
    var power_4: f32;
    var reach: f32;
    let _e6 = gabor_kernel_wave(wave);
    let _e9 = gabor_field_filtered(place, _e6, footprint, seed, (&removed_7));
    value_10 = _e9.value;
    let _e12 = value_10;
    let _e13 = value_10;
    power_4 = dot(_e12, _e13);
    let _e16 = power_4;
    let _e18 = removed_7;
    reach = sqrt((_e16 + (2.546479f * max(_e18, 0f))));
    let _e25 = reach;
    let _e30 = value_10;
    let _e31 = ((sharpness / max((sharpness * _e25), 1f)) * _e30);
    let _e32 = power_4;
    let _e34 = removed_7;
    let _e40 = removed_7;
    return vec4<f32>(_e31.x, _e31.y, sqrt((_e32 + (1.5707963f * max(_e34, 0f)))), _e40);
}

fn gabor_stripes_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, wave: vec2<f32>, sharpness: f32, seed: u32) -> vec4<f32> {
    let _e13 = gabor_place(vec2(0i), (p * 1.5f));
    let _e14 = gabor_footprint(dx, dy);
    let _e15 = gabor_stripes_filtered_at(_e13, wave, _e14, sharpness, seed);
    return _e15;
}

// The mean of a profile over [phase - width / 2, phase + width / 2] is the change of its integral from one end to
// the other, divided by the width. Each whole turn adds the integral of one period.
fn gabor_impl_ends(phase: f32, width: f32) -> vec3<f32> {
    var phase_6: f32;
    var width_2: f32;
    phase_6 = phase;
    width_2 = width;
    let _e4 = width_2;
    width_2 = clamp(_e4, 0.001f, 1f);
    let _e8 = phase_6;
    let _e9 = phase_6;
    phase_6 = (_e8 - floor(_e9));
    let _e12 = phase_6;
    let _e14 = width_2;
    let _e17 = phase_6;
    let _e19 = width_2;
    let _e23 = width_2;
    return vec3<f32>((_e12 - (0.5f * _e14)), (_e17 + (0.5f * _e19)), (1f / _e23));
}

fn gabor_profile_sine(phase: f32, width: f32) -> f32 {
    var x_9: f32;
    x_9 = (3.1415927f * clamp(width, 0.001f, 1f));
    let _e10 = gabor_impl_wave(phase);
    let _e14 = x_9;
    let _e16 = gabor_impl_wave((0.15915494f * _e14));
    let _e18 = x_9;
    return (0.5f - ((0.5f * _e10.x) * (_e16.y / _e18)));
}

fn gabor_impl_triangle_integral(x: f32) -> f32 {
    var turns: f32;
    var t_3: f32;
    var local_30: f32;
    turns = floor(x);
    let _e3 = turns;
    t_3 = (x - _e3);
    let _e7 = turns;
    let _e9 = t_3;
    if (_e9 < 0.5f) {
        let _e12 = t_3;
        let _e13 = t_3;
        local_30 = (_e12 * _e13);
    } else {
        let _e16 = t_3;
        let _e18 = t_3;
        let _e19 = t_3;
        local_30 = (((2f * _e16) - (_e18 * _e19)) - 0.5f);
    }
    let _e25 = local_30;
    return ((0.5f * _e7) + _e25);
}

fn gabor_profile_triangle(phase: f32, width: f32) -> f32 {
    var ends: vec3<f32>;
    let _e2 = gabor_impl_ends(phase, width);
    ends = _e2;
    let _e4 = ends;
    let _e6 = ends;
    let _e8 = gabor_impl_triangle_integral(_e6.y);
    let _e9 = ends;
    let _e11 = gabor_impl_triangle_integral(_e9.x);
    return (_e4.z * (_e8 - _e11));
}

fn gabor_impl_sawtooth_integral(x: f32) -> f32 {
    var turns_1: f32;
    var t_4: f32;
    turns_1 = floor(x);
    let _e3 = turns_1;
    t_4 = (x - _e3);
    let _e7 = turns_1;
    let _e8 = t_4;
    let _e9 = t_4;
    return (0.5f * (_e7 + (_e8 * _e9)));
}

fn gabor_profile_sawtooth(phase: f32, width: f32) -> f32 {
    var ends_1: vec3<f32>;
    let _e2 = gabor_impl_ends(phase, width);
    ends_1 = _e2;
    let _e4 = ends_1;
    let _e6 = ends_1;
    let _e8 = gabor_impl_sawtooth_integral(_e6.y);
    let _e9 = ends_1;
    let _e11 = gabor_impl_sawtooth_integral(_e9.x);
    return (_e4.z * (_e8 - _e11));
}

fn gabor_impl_pulse_integral(x: f32, duty: f32) -> f32 {
    var turns_2: f32;
    turns_2 = floor(x);
    let _e4 = turns_2;
    let _e6 = turns_2;
    return ((duty * _e4) + min((x - _e6), duty));
}

fn gabor_profile_pulse(phase: f32, duty: f32, width: f32) -> f32 {
    var ends_2: vec3<f32>;
    let _e3 = gabor_impl_ends(phase, width);
    ends_2 = _e3;
    let _e5 = ends_2;
    let _e7 = ends_2;
    let _e9 = gabor_impl_pulse_integral(_e7.y, duty);
    let _e10 = ends_2;
    let _e12 = gabor_impl_pulse_integral(_e10.x, duty);
    return (_e5.z * (_e9 - _e12));
}

fn gabor_impl_ridges_integral(x: f32) -> f32 {
    var turns_3: f32;
    var t_5: f32;
    turns_3 = floor(x);
    let _e3 = turns_3;
    t_5 = (x - _e3);
    let _e7 = turns_3;
    let _e9 = t_5;
    let _e10 = t_5;
    let _e14 = t_5;
    return ((0.6666667f * _e7) + ((_e9 * _e10) * (2f - (1.3333333f * _e14))));
}

fn gabor_profile_ridges(phase: f32, width: f32) -> f32 {
    var ends_3: vec3<f32>;
    let _e2 = gabor_impl_ends(phase, width);
    ends_3 = _e2;
    let _e4 = ends_3;
    let _e6 = ends_3;
    let _e8 = gabor_impl_ridges_integral(_e6.y);
    let _e9 = ends_3;
    let _e11 = gabor_impl_ridges_integral(_e9.x);
    return (_e4.z * (_e8 - _e11));
}

// The (phase, width) of stripes. The mean of a unit vector over `width` turns has the length sin(pi width) / (pi
// width); the polynomial inverts this within 0.0025.
fn gabor_impl_phase_of(stripes: vec2<f32>) -> vec2<f32> {
    var phasor: vec2<f32>;
    var y_8: f32;
    let _e1 = gabor_phasor(stripes);
    phasor = _e1;
    let _e4 = phasor;
    y_8 = max((1f - _e4.y), 0f);
    let _e10 = phasor;
    let _e12 = y_8;
    let _e15 = y_8;
    let _e17 = y_8;
    let _e19 = y_8;
    return vec2<f32>(_e10.x, (sqrt(_e12) * (0.7796968f + (_e15 * (0.13925488f + (_e17 * ((0.1322011f * _e19) - 0.05362376f)))))));
}

fn gabor_stripes_sine(stripes: vec2<f32>) -> f32 {
    return (0.5f - (0.5f * stripes.x));
}

fn gabor_stripes_triangle(stripes: vec2<f32>) -> f32 {
    var phase_12: vec2<f32>;
    let _e1 = gabor_impl_phase_of(stripes);
    phase_12 = _e1;
    let _e3 = phase_12;
    let _e5 = phase_12;
    let _e7 = gabor_profile_triangle(_e3.x, _e5.y);
    return _e7;
}

fn gabor_stripes_sawtooth(stripes: vec2<f32>) -> f32 {
    var phase_13: vec2<f32>;
    let _e1 = gabor_impl_phase_of(stripes);
    phase_13 = _e1;
    let _e3 = phase_13;
    let _e5 = phase_13;
    let _e7 = gabor_profile_sawtooth(_e3.x, _e5.y);
    return _e7;
}

fn gabor_stripes_pulse(stripes: vec2<f32>, duty: f32) -> f32 {
    var phase_14: vec2<f32>;
    let _e2 = gabor_impl_phase_of(stripes);
    phase_14 = _e2;
    let _e4 = phase_14;
    let _e6 = phase_14;
    let _e8 = gabor_profile_pulse(_e4.x, duty, _e6.y);
    return _e8;
}

fn gabor_stripes_ridges(stripes: vec2<f32>) -> f32 {
    var phase_15: vec2<f32>;
    let _e1 = gabor_impl_phase_of(stripes);
    phase_15 = _e1;
    let _e3 = phase_15;
    let _e5 = phase_15;
    let _e7 = gabor_profile_ridges(_e3.x, _e5.y);
    return _e7;
}


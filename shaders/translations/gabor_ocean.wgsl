// Generated from gabor_ocean.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 7ee065b258a4aae2.
// Paste it after gabor_noise.wgsl.
//
// gabor_ocean.wgsl: a sea that never repeats, at any point and time, without textures or state, the same on CPU and GPU.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     GaborOcean sea = gabor_ocean(12.0);                            // a wind of 12 m/s; once per draw, or as a uniform
//     GaborWater w = gabor_water(p, 60.5, sea, 7u);                  // p in metres, after 60.5 seconds
//     vec2f place = p + w.shift;                                      // of the water, at the height w.height
//
// I want water under a pixel: gabor_water_filtered. A boat's height: gabor_water_height. A world of any size, or months of
// time: gabor_water_at. Another direction or fetch, a swell, or a film that loops: gabor_ocean_of.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// Waves from one wavelength to half of it. `low`, `early`, `late` and `spread` are multiples of powers of 2, so that sums are exact.
struct GaborOceanBand {
    amplitude: f32, // rms height in metres
    slopes: vec2<f32>, // variance of the slopes along the band's direction and across it
    exponent: i32, // the spacing of nodes is 2^exponent metres
    low: f32, // 65536 times the lowest frequency in Hz
    early: vec3<f32>, // how fast the frequency rises in the first 1/16 of the power, and how much faster in the next 3/16, 4/16,
    late: vec3<f32>, // 4/16, 3/16 and 1/16
    spread: vec3<f32>, // sin(d / 2) of an angle d from the band's direction is a u + b u^3 + c v, u and v uniform in [-1, 1],
    widen: vec2<f32>, // times a linear function of the frequency
    drift: vec2<i32>, // 32768 times the group velocity in nodes per second
}

struct GaborOcean {
    wind: f32, // speed in metres per second, 10 m up
    direction: f32, // where the waves go: radians from +x towards +y
    fetch: f32, // metres of open water upwind, 10^3 to 10^6: beyond 2190 wind^2, waves grow no more
    swell: vec3<f32>, // x: significant height in metres, 0 to 30, y: period in seconds, 5 to 25, z: direction
    loop_seconds: i32, // all repeats after so many, or 0 for never
    tail: vec2<f32>, // variance of the slopes of waves shorter than all bands, along the wind and across it
    band: array<GaborOceanBand, 10>, // the swell is the last
}
// GaborOcean gabor_ocean(f32 wind)
// GaborOcean gabor_ocean_of(f32 wind, f32 direction, f32 fetch, vec3f swell, i32 loop_seconds)
//     A sea for a wind of 2 to 30 m/s; gabor_ocean takes the direction 0 and a fetch of 200 km. Deep water with the JONSWAP
//     spectrum [HBB73] until it is fully developed [PM64], and the directions of [HDE80]. A swell, from a remote storm, has a
//     narrow spread of directions and a sharp peak [G10]; vec3f(0.0) is none. For films, all repeats after a loop of 8, 16, 32
//     ... 4096 seconds, to which other values are rounded down. Its price: groups of waves stand still, and each wave's period
//     becomes an integer fraction of it, so a loop should last several periods of the swell. Compute a sea once, on the CPU if
//     the CPU also asks for heights: the integers may round differently on another device. To change a member, call this again.

// The water whose place at rest is p. It is now at p + shift.
struct GaborWater {
    height: f32, // metres, of mean 0 and normally distributed
    slope: vec2<f32>, // derivatives of the height by p
    shift: vec2<f32>, // horizontal displacement in metres, towards crests, which it sharpens
    jacobian: f32, // of p + shift by p, within 0.1, or 0.2 for a fetch of 1 km: 1 at rest, lower where water folds,
    lost: vec3<f32>, // covariance (xx, yy, xy) of the slopes that a filter removed, for roughness
}
// GaborWater gabor_water(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     p in metres, within 10^5 of the origin; seconds within 10^4 of 0.
// GaborWater gabor_water_filtered(vec2f p, vec2f dx, vec2f dy, f32 seconds, GaborOcean ocean, u32 seed)
//     The same without waves that are too fine for a pixel (dx and dy are dpdx(p), dpdy(p)), whose slopes are in `lost`, as are
//     those of waves shorter than all bands: with them, slopes have the variance that Cox and Munk measured [CM54], if the sea has
//     neither a swell nor a loop. Below 4 m/s or 20 km of fetch, JONSWAP's waves alone have up to 1.8 times that.
// f32 gabor_water_height(vec2f p, f32 seconds, GaborOcean ocean, u32 seed)
//     The height of the water above the fixed point p, where a boat floats: six evaluations.
// GaborWater gabor_water_at(vec2i cell, vec2f local, i32 whole_seconds, f32 fraction, vec2f dx, vec2f dy,
//                           GaborOcean ocean, u32 seed)
//     At the position cell + local in metres, after whole_seconds + fraction: exact for years and anywhere. dx and dy
//     of
//     vec2f(0.0) do not filter.

// [HBB73] Hasselmann and others, "Measurements of wind-wave growth and swell decay during the Joint North Sea Wave Project",
// 1973. [HDE80] Hasselmann, Dunckel, Ewing, "Directional wave spectra observed during JONSWAP 1973", 1980. [G10] Goda, "Random
// seas", 2010. [CM54] Cox, Munk, "Measurement of the roughness of the sea surface from photographs of the sun's glitter", 1954.
// [PM64] Pierson, Moskowitz, "A proposed spectral form for fully developed wind seas", 1964.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
//
// Each band is a lattice noise of two taps whose nodes have wave vectors of their own, drawn from the band's part of the spectrum:
// an angle d from the band's direction and a frequency F, from which the wave number follows by the dispersion relation of deep
// water, (2 pi F)^2 = g |2 pi k|. The lattice drifts with the band's group velocity V, so that groups travel as they should; seen from
// there, phases turn by F - k.V. With V = g / (4 pi F0) along that direction, k.V = F^2 / (2 F0) cos d. F - k.V is an integer, so that
// the phase is exact after any time, and the same on every device: floats below 2^24 and powers of 2 are exact.
//
// Bands 1 to 3 and the swell hold most of the height: there, amplitudes are normal. In the others, their squares are uniform, to make
// up for the kurtosis that different directions give the slopes. Each seed shifts the lattices, so that no place differs from others.

fn gabor_impl_spectrum(f: f32, peak: f32, scale: f32, sharp: f32) -> vec2<f32> {
    var below: f32;
    var local_11: f32;
    var apart: f32;
    below = ((peak * peak) / (f * f));
    if (f < peak) {
        local_11 = 0.07f;
    } else {
        local_11 = 0.09f;
    }
    let _e15 = local_11;
    apart = (((f / peak) - 1f) / _e15);
    let _e21 = apart;
    let _e23 = apart;
    let _e28 = below;
    let _e30 = below;
    return (((scale / f) * exp(((sharp * exp(((-0.5f * _e21) * _e23))) - ((1.25f * _e28) * _e30)))) * vec2<f32>((1f / (((f * f) * f) * f)), 1f));
}

fn gabor_ocean_of(wind: f32, direction: f32, fetch: f32, swell: vec3<f32>, loop_seconds: i32) -> GaborOcean {
    var direction_1: f32;
    var gravity: f32 = 9.81f;
    var tick: f32 = 0.000015258789f;
    var ocean: GaborOcean;
    var local_12: i32;
    var reach_1: f32;
    var peak_1: f32;
    var scale_1: f32;
    var sharp_1: f32 = 1.1939225f;
    var power_1: i32;
    var i: i32 = 0i;
    var local_13: u32;
    var low: f32;
    var remote: bool;
    var width: f32;
    var variance: f32;
    var sum_5: vec2<f32>;
    var fit: vec4<f32>;
    var j_1: i32;
    var f_1: f32;
    var x_5: f32;
    var above: f32;
    var local_14: f32;
    var local_15: f32;
    var s_2: f32;
    var here: f32;
    var part: vec2<f32>;
    var deviation: f32;
    var narrow: f32;
    var c_1: f32;
    var widen: f32;
    var most: f32;
    var end: f32;
    var rest: f32;
    var a_2: f32;
    var b_2: f32;
    var fourth_1: f32;
    var along: f32;
    var early: vec3<f32>;
    var late: vec3<f32>;
    var ahead: vec3<f32>;
    var n: i32;
    var part_1: f32;
    var band: GaborOceanBand;
    var local_16: f32;
    var local_17: f32;
    var tall: f32;
    var local_18: i32;
    var local_19: i32;
    var local_20: f32;
    var speed: f32;
    direction_1 = direction;
    ocean.wind = clamp(wind, 2f, 30f);
    let _e16 = direction_1;
    ocean.direction = _e16;
    ocean.fetch = clamp(fetch, 1000f, 1000000f);
    ocean.swell = vec3<f32>(clamp(swell.x, 0f, 30f), clamp(swell.y, 5f, 25f), swell.z);
    if (loop_seconds > 0i) {
        local_12 = i32((1u << u32((log2(f32(clamp(loop_seconds, 8i, 4096i))) + 0.0002f))));
    } else {
        local_12 = 0i;
    }
    let _e48 = local_12;
    ocean.loop_seconds = _e48;
    let _e49 = gravity;
    let _e50 = ocean;
    let _e53 = ocean;
    let _e55 = ocean;
    reach_1 = min(((_e49 * _e50.fetch) / (_e53.wind * _e55.wind)), 21500f);
    let _e63 = gravity;
    let _e65 = ocean;
    let _e68 = reach_1;
    peak_1 = (((3.5f * _e63) / _e65.wind) * pow(_e68, -0.33f));
    let _e75 = reach_1;
    let _e80 = gravity;
    let _e82 = gravity;
    scale_1 = ((((0.076f * pow(_e75, -0.22f)) * _e80) * _e82) / 1558.5455f);
    let _e90 = peak_1;
    let _e92 = tick;
    power_1 = i32(floor(log2(((0.62f * _e90) / _e92))));
    let _e102 = ocean;
    ocean.tail = ((vec2<f32>(0.00316f, 0.00192f) * _e102.wind) + vec2<f32>(0f, 0.003f));
    loop {
        let _e111 = i;
        if !((_e111 <= 9i)) {
            break;
        }
        {
            let _e118 = i;
            if ((_e118 & 1i) == 0i) {
                local_13 = 128u;
            } else {
                local_13 = 181u;
            }
            let _e126 = local_13;
            let _e127 = power_1;
            let _e128 = i;
            low = (f32((_e126 << u32((_e127 + (_e128 / 2i))))) / 128f);
            let _e138 = i;
            remote = (_e138 == 9i);
            let _e142 = remote;
            if _e142 {
                {
                    let _e144 = ocean;
                    peak_1 = (1f / _e144.swell.y);
                    let _e150 = peak_1;
                    let _e152 = tick;
                    low = (64f * floor((((0.0132813f * _e150) / _e152) + 0.5f)));
                    sharp_1 = 2.0794415f;
                    let _e159 = ocean;
                    direction_1 = _e159.swell.z;
                }
            }
            let _e163 = low;
            width = (0.025878906f * _e163);
            variance = 0f;
            sum_5 = vec2(0f);
            fit = vec4(0f);
            j_1 = 0i;
            loop {
                let _e176 = j_1;
                if !((_e176 < 16i)) {
                    break;
                }
                {
                    let _e183 = tick;
                    let _e184 = low;
                    let _e185 = j_1;
                    let _e189 = width;
                    f_1 = (_e183 * (_e184 + ((f32(_e185) + 0.5f) * _e189)));
                    let _e195 = j_1;
                    x_5 = ((26.5f * f32(_e195)) - 198.75f);
                    let _e201 = f_1;
                    let _e202 = peak_1;
                    above = (_e201 / _e202);
                    let _e205 = remote;
                    if _e205 {
                        local_15 = 75f;
                    } else {
                        let _e208 = above;
                        let _e209 = above;
                        if (_e209 < 1f) {
                            local_14 = 4.06f;
                        } else {
                            local_14 = -2.34f;
                        }
                        let _e216 = local_14;
                        local_15 = (9.77f * pow(_e208, _e216));
                    }
                    let _e220 = local_15;
                    s_2 = _e220;
                    let _e223 = s_2;
                    here = (0.5f / (_e223 + 1f));
                    let _e228 = tick;
                    let _e229 = width;
                    let _e231 = f_1;
                    let _e232 = peak_1;
                    let _e233 = scale_1;
                    let _e234 = sharp_1;
                    let _e235 = gabor_impl_spectrum(_e231, _e232, _e233, _e234);
                    part = ((_e228 * _e229) * _e235);
                    let _e238 = sum_5;
                    let _e239 = part;
                    sum_5 = (_e238 + _e239);
                    let _e241 = variance;
                    let _e242 = part;
                    let _e244 = here;
                    variance = (_e241 + (_e242.x * _e244));
                    let _e247 = fit;
                    let _e248 = part;
                    let _e250 = x_5;
                    let _e251 = here;
                    let _e253 = x_5;
                    let _e254 = x_5;
                    let _e256 = x_5;
                    let _e257 = here;
                    fit = (_e247 + (_e248.x * vec4<f32>(_e250, sqrt(_e251), (_e253 * _e254), (_e256 * sqrt(_e257)))));
                }
                continuing {
                    let _e180 = j_1;
                    j_1 = (_e180 + 1i);
                }
            }
            let _e263 = variance;
            let _e264 = sum_5;
            variance = (_e263 / _e264.x);
            let _e267 = fit;
            let _e268 = sum_5;
            fit = (_e267 / vec4(_e268.x));
            let _e272 = variance;
            deviation = sqrt(_e272);
            let _e276 = variance;
            narrow = ((0.5f / _e276) - 1.8f);
            let _e282 = deviation;
            let _e284 = narrow;
            c_1 = ((0.9f * _e282) * clamp(_e284, 0f, 1f));
            let _e291 = narrow;
            let _e296 = fit;
            let _e298 = fit;
            let _e300 = fit;
            let _e305 = fit;
            let _e307 = fit;
            let _e309 = fit;
            let _e313 = deviation;
            widen = ((clamp((0.3f * _e291), 0f, 1f) * (_e296.w - (_e298.x * _e300.y))) / ((_e305.z - (_e307.x * _e309.x)) * _e313));
            let _e318 = widen;
            widen = (floor((clamp((16384f * _e318), -32f, 32f) + 0.5f)) / 16384f);
            let _e332 = widen;
            let _e336 = fit;
            let _e338 = widen;
            most = (1f / ((1f + (212f * abs(_e332))) - (_e336.x * _e338)));
            let _e344 = deviation;
            let _e346 = most;
            let _e347 = c_1;
            end = min((1.8f * _e344), (_e346 - _e347));
            let _e351 = variance;
            let _e352 = c_1;
            let _e353 = c_1;
            rest = (_e351 - ((_e352 * _e353) / 3f));
            let _e360 = rest;
            let _e363 = end;
            let _e365 = end;
            let _e372 = end;
            a_2 = ((sqrt(max(((0.3047619f * _e360) - ((0.0304762f * _e363) * _e365)), 0f)) - (0.1142857f * _e372)) / 0.152381f);
            let _e378 = end;
            let _e379 = a_2;
            b_2 = (_e378 - _e379);
            let _e382 = a_2;
            let _e383 = a_2;
            let _e385 = a_2;
            let _e388 = a_2;
            let _e391 = b_2;
            let _e395 = b_2;
            let _e396 = b_2;
            let _e399 = a_2;
            let _e401 = a_2;
            let _e404 = a_2;
            let _e406 = b_2;
            let _e410 = b_2;
            let _e412 = b_2;
            let _e417 = c_1;
            let _e418 = c_1;
            let _e421 = rest;
            let _e424 = c_1;
            let _e426 = c_1;
            fourth_1 = (((((_e382 * _e383) * _e385) * ((0.2f * _e388) + (0.5714286f * _e391))) + ((_e395 * _e396) * ((((0.6666667f * _e399) * _e401) + ((0.36363637f * _e404) * _e406)) + ((0.07692308f * _e410) * _e412)))) + ((_e417 * _e418) * ((2f * _e421) + ((0.2f * _e424) * _e426))));
            let _e434 = variance;
            let _e438 = fourth_1;
            along = ((1f - (4f * _e434)) + (4f * _e438));
            early = vec3(0f);
            late = vec3(0f);
            ahead = vec3<f32>(0.0621f, 0.2483f, 0.4965f);
            n = 0i;
            loop {
                let _e455 = n;
                if !((_e455 < 16i)) {
                    break;
                }
                {
                    let _e462 = tick;
                    let _e463 = width;
                    let _e465 = sum_5;
                    let _e468 = tick;
                    let _e469 = low;
                    let _e470 = n;
                    let _e474 = width;
                    let _e478 = peak_1;
                    let _e479 = scale_1;
                    let _e480 = sharp_1;
                    let _e481 = gabor_impl_spectrum((_e468 * (_e469 + ((f32(_e470) + 0.5f) * _e474))), _e478, _e479, _e480);
                    part_1 = (((_e462 * _e463) / _e465.x) * _e481.x);
                    let _e485 = early;
                    let _e487 = ahead;
                    let _e488 = part_1;
                    early = (_e485 + (26.5f * clamp((_e487 / vec3(max(_e488, 0.000000001f))), vec3(0f), vec3(1f))));
                    let _e500 = late;
                    let _e502 = ahead;
                    let _e508 = part_1;
                    late = (_e500 + (26.5f * clamp(((_e502 + vec3<f32>(0.6827f, 0.6827f, 0.5035f)) / vec3(max(_e508, 0.000000001f))), vec3(0f), vec3(1f))));
                    let _e520 = ahead;
                    let _e521 = part_1;
                    ahead = (_e520 - vec3(_e521));
                }
                continuing {
                    let _e459 = n;
                    n = (_e459 + 1i);
                }
            }
            let _e525 = remote;
            if _e525 {
                let _e527 = ocean;
                let _e531 = ocean;
                local_17 = ((0.0625f * _e527.swell.x) * _e531.swell.x);
            } else {
                let _e535 = low;
                if (_e535 > 262144f) {
                    local_16 = 0f;
                } else {
                    let _e539 = sum_5;
                    local_16 = _e539.x;
                }
                let _e542 = local_16;
                local_17 = _e542;
            }
            let _e544 = local_17;
            tall = _e544;
            let _e547 = tall;
            band.amplitude = sqrt(_e547);
            let _e551 = tall;
            let _e553 = sum_5;
            let _e556 = sum_5;
            let _e559 = along;
            let _e561 = along;
            band.slopes = ((((16.195057f * _e551) * _e553.y) / _e556.x) * vec2<f32>(_e559, (1f - _e561)));
            let _e565 = remote;
            if !(_e565) {
                let _e568 = ocean;
                let _e570 = band;
                ocean.tail = (_e568.tail - _e570.slopes);
            }
            let _e574 = remote;
            if _e574 {
                let _e576 = peak_1;
                let _e577 = peak_1;
                local_19 = i32(floor(log2((18f / (_e576 * _e577)))));
            } else {
                let _e585 = power_1;
                let _e588 = i;
                let _e590 = i;
                let _e593 = i;
                if ((_e590 > 0i) && (_e593 < 4i)) {
                    local_18 = 1i;
                } else {
                    local_18 = -1i;
                }
                let _e601 = local_18;
                local_19 = (((34i - (2i * _e585)) - _e588) + _e601);
            }
            let _e604 = local_19;
            band.exponent = _e604;
            let _e606 = low;
            band.low = _e606;
            let _e608 = early;
            let _e610 = early;
            let _e611 = _e610.xy;
            band.early = (floor((((_e608 - vec3<f32>(0f, _e611.x, _e611.y)) * vec3<f32>(4f, 1.3333333f, 1f)) + vec3(0.5f))) / vec3(256f));
            let _e629 = late;
            let _e630 = early;
            let _e632 = late;
            let _e633 = _e632.xy;
            band.late = (floor((((_e629 - vec3<f32>(_e630.z, _e633.x, _e633.y)) * vec3<f32>(1f, 1.3333333f, 4f)) + vec3(0.5f))) / vec3(256f));
            let _e651 = band;
            let _e653 = band;
            let _e656 = band;
            let _e658 = _e656.late.xy;
            band.late = (_e651.late - vec3<f32>(_e653.early.z, _e658.x, _e658.y));
            let _e664 = band;
            let _e667 = band;
            let _e669 = _e667.early.xy;
            band.early = (_e664.early - vec3<f32>(0f, _e669.x, _e669.y));
            let _e676 = a_2;
            let _e677 = b_2;
            let _e678 = c_1;
            band.spread = (floor((511.5f * vec3<f32>(_e676, _e677, _e678))) * vec3<f32>(8f, 0.00390625f, 8f));
            let _e690 = fit;
            let _e694 = widen;
            let _e697 = widen;
            band.widen = floor((16384f * vec2<f32>((1f - ((_e690.x + 1236f) * _e694)), _e697)));
            let _e701 = ocean;
            if (_e701.loop_seconds > 0i) {
                local_20 = 0f;
            } else {
                let _e707 = gravity;
                let _e710 = tick;
                let _e712 = low;
                let _e717 = band;
                local_20 = (((32768f * _e707) / (((12.566371f * _e710) * _e712) * 1.1892071f)) * exp2(-(f32(_e717.exponent))));
            }
            let _e724 = local_20;
            speed = _e724;
            let _e727 = speed;
            let _e729 = direction_1;
            let _e731 = gabor_impl_wave((0.15915494f * _e729));
            band.drift = vec2<i32>(floor(((_e727 * _e731) + vec2(0.5f))));
            let _e738 = i;
            let _e741 = band;
            ocean.band[_e738] = _e741;
        }
        continuing {
            let _e115 = i;
            i = (_e115 + 1i);
        }
    }
    let _e743 = ocean;
    ocean.tail = max(_e743.tail, vec2(0f));
    let _e748 = ocean;
    return _e748;
}

fn gabor_ocean(wind: f32) -> GaborOcean {
    let _e6 = gabor_ocean_of(wind, 0f, 200000f, vec3(0f), 0i);
    return _e6;
}

fn gabor_impl_slopes_along(variances: vec2<f32>, along: vec2<f32>) -> vec3<f32> {
    let _e11 = ((((variances.x - variances.y) * along.x) * along) + vec2<f32>(variances.y, 0f));
    return vec3<f32>(_e11.x, _e11.y, (variances.x + variances.y));
}

// Adds a band's four nodes around a point, together, which CPUs do faster. `quantum` is the spacing of frequencies and its inverse,
// `least` the square of a pixel's shorter side. `squeeze` sums the derivatives of the shift. It and `lost` have xx, xy and xx + yy.
fn gabor_impl_add_band(sum: ptr<function, GaborWater>, squeeze: ptr<function, vec3<f32>>, band: GaborOceanBand, normal: bool, heading: vec2<f32>, quantum: vec2<f32>, least: f32, cell: vec2<i32>, local: vec2<f32>, second: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, seed: u32) {
    var scale_2: f32;
    var half_step: f32;
    var lowest: f32;
    var longest: f32;
    var salt_4: u32;
    var drifted: vec2<i32>;
    var up: i32;
    var down: i32;
    var spacing: f32;
    var rest_1: vec2<f32>;
    var first_1: vec2<f32>;
    var offset: vec2<f32>;
    var node: vec2<i32>;
    var middle: vec2<f32>;
    var fourth_2: vec2<f32>;
    var turns: vec2<f32>;
    var turn_x: vec2<f32>;
    var turn_y: vec2<f32>;
    var slope_6: vec2<f32>;
    var along_x_1: vec4<f32>;
    var along_y_1: vec4<f32>;
    var window: vec4<f32>;
    var window_x: vec4<f32>;
    var window_y: vec4<f32>;
    var from_x: vec4<f32>;
    var from_y: vec4<f32>;
    var west: u32;
    var east: u32;
    var south: u32;
    var north: u32;
    var word_5: vec4<u32>;
    var bits: vec4<u32>;
    var share: vec4<f32>;
    var u_1: vec4<f32>;
    var w: vec4<f32>;
    var rise: vec4<f32>;
    var bent: vec4<f32>;
    var angle: vec4<f32>;
    var part_2: vec4<f32>;
    var lag: vec4<f32>;
    var steep: vec4<f32>;
    var carried: vec4<f32>;
    var count: vec4<f32>;
    var local_22: f32;
    var turning: vec4<f32>;
    var local_23: f32;
    var k: vec4<f32>;
    var chord: vec4<f32>;
    var cosine: vec4<f32>;
    var sine: vec4<f32>;
    var x_6: vec4<f32>;
    var y_4: vec4<f32>;
    var ticks: vec4<u32>;
    var phase_1: vec4<f32>;
    var a_3: vec2<f32>;
    var b_3: vec2<f32>;
    var c_2: vec2<f32>;
    var d: vec2<f32>;
    var square: vec4<f32>;
    var steps_x: vec4<f32>;
    var steps_y: vec4<f32>;
    var kept: vec4<f32>;
    var amplitude_2: vec4<f32>;
    var local_24: vec4<f32>;
    var height: vec4<f32>;
    var along_2: vec4<f32>;
    var steepness: vec4<f32>;
    var squeezed: vec4<f32>;
    var local_25: f32;
    var lost: vec4<f32>;
    scale_2 = ((0.0009765625f * band.low) * quantum.y);
    let _e23 = scale_2;
    half_step = max(0.5f, (1f - (1024f * _e23)));
    let _e30 = scale_2;
    let _e32 = half_step;
    lowest = (quantum.x * floor(((1024f * _e30) + _e32)));
    let _e38 = lowest;
    let _e40 = lowest;
    longest = ((0.0000000001486f * _e38) * _e40);
    let _e46 = longest;
    let _e47 = longest;
    if ((band.amplitude == 0f) || (((_e46 * _e47) * least) > 1.6f)) {
        {
            let _e54 = (*sum);
            let _e57 = gabor_impl_slopes_along(band.slopes, heading);
            (*sum).lost = (_e54.lost + _e57);
            return;
        }
    }
    let _e59 = gabor_impl_salt(seed);
    salt_4 = _e59;
    drifted = ((second & 32767i) * band.drift);
    up = max(band.exponent, 0i);
    down = max(-(band.exponent), 0i);
    spacing = exp2(f32(band.exponent));
    let _e80 = up;
    let _e90 = spacing;
    let _e93 = drifted;
    let _e108 = salt_4;
    let _e112 = salt_4;
    rest_1 = (((((vec2<f32>((cell & vec2((i32((1u << u32(_e80))) - 1i)))) + local) / vec2(_e90)) - (vec2<f32>((_e93 & vec2(32767i))) / vec2(32768f))) - ((fraction / 32768f) * vec2<f32>(band.drift))) + (vec2<f32>(f32((_e108 & 65535u)), f32((_e112 >> 16u))) / vec2(65536f)));
    let _e122 = rest_1;
    first_1 = floor(_e122);
    let _e125 = rest_1;
    let _e126 = first_1;
    offset = clamp((_e125 - _e126), vec2(0f), vec2(1f));
    let _e134 = up;
    let _e138 = down;
    let _e148 = drifted;
    let _e154 = first_1;
    node = (((((cell >> vec2(u32(_e134))) << vec2(u32(_e138))) - ((second >> 15u) * band.drift)) - (_e148 >> vec2(15u))) + vec2<i32>(_e154));
    let _e159 = offset;
    middle = ((2f * _e159) - vec2(1f));
    let _e165 = middle;
    let _e166 = middle;
    let _e168 = middle;
    let _e170 = middle;
    fourth_2 = (((_e165 * _e166) * _e168) * _e170);
    let _e174 = middle;
    let _e177 = fourth_2;
    turns = (vec2(0.125f) + (_e174 * (vec2(0.15625f) - (0.03125f * _e177))));
    let _e186 = turns;
    let _e188 = gabor_impl_half_turn(_e186.x);
    turn_x = (band.amplitude * _e188);
    let _e191 = turns;
    let _e193 = gabor_impl_half_turn(_e191.y);
    turn_y = _e193;
    let _e196 = spacing;
    let _e199 = fourth_2;
    slope_6 = ((1.9634954f / _e196) * (vec2(1f) - _e199));
    let _e204 = turn_x;
    let _e205 = turn_x;
    along_x_1 = vec4<f32>(_e204.x, _e204.y, _e205.x, _e205.y);
    let _e212 = turn_y;
    let _e213 = _e212.xx;
    let _e214 = turn_y;
    let _e215 = _e214.yy;
    along_y_1 = vec4<f32>(_e213.x, _e213.y, _e215.x, _e215.y);
    let _e222 = along_x_1;
    let _e223 = along_y_1;
    window = (_e222 * _e223);
    let _e226 = slope_6;
    let _e228 = turn_x;
    let _e231 = turn_x;
    let _e233 = turn_x;
    let _e236 = turn_x;
    let _e240 = along_y_1;
    window_x = ((_e226.x * vec4<f32>(-(_e228.y), _e231.x, -(_e233.y), _e236.x)) * _e240);
    let _e243 = slope_6;
    let _e245 = turn_y;
    let _e247 = -(_e245.yy);
    let _e248 = turn_y;
    let _e249 = _e248.xx;
    let _e256 = along_x_1;
    window_y = ((_e243.y * vec4<f32>(_e247.x, _e247.y, _e249.x, _e249.y)) * _e256);
    let _e259 = spacing;
    let _e260 = offset;
    from_x = (_e259 * (vec4(_e260.x) - vec4<f32>(0f, 1f, 0f, 1f)));
    let _e271 = spacing;
    let _e272 = offset;
    from_y = (_e271 * (vec4(_e272.y) - vec4<f32>(0f, 0f, 1f, 1f)));
    let _e283 = node;
    let _e285 = salt_4;
    let _e286 = gabor_impl_line_word(_e283.x, _e285);
    west = _e286;
    let _e288 = node;
    let _e292 = salt_4;
    let _e293 = gabor_impl_line_word((_e288.x + 1i), _e292);
    east = _e293;
    let _e295 = node;
    let _e297 = salt_4;
    let _e300 = gabor_impl_line_word(_e295.y, (_e297 ^ 1540483477u));
    south = _e300;
    let _e302 = node;
    let _e306 = salt_4;
    let _e309 = gabor_impl_line_word((_e302.y + 1i), (_e306 ^ 1540483477u));
    north = _e309;
    let _e311 = south;
    let _e312 = west;
    let _e314 = south;
    let _e315 = east;
    let _e317 = north;
    let _e318 = west;
    let _e320 = north;
    let _e321 = east;
    word_5 = vec4<u32>((_e311 * _e312), (_e314 * _e315), (_e317 * _e318), (_e320 * _e321));
    let _e325 = word_5;
    let _e326 = word_5;
    bits = ((_e325 ^ (_e326 >> vec4(15u))) * 3545902487u);
    let _e334 = bits;
    let _e335 = bits;
    bits = (_e334 ^ (_e335 >> vec4(15u)));
    let _e340 = bits;
    share = vec4<f32>((_e340 >> vec4(22u)));
    let _e346 = bits;
    u_1 = vec4<f32>((vec4<i32>((_e346 << vec4(10u))) >> vec4(21u)));
    let _e357 = bits;
    w = vec4<f32>((vec4<i32>((_e357 << vec4(21u))) >> vec4(21u)));
    let _e371 = share;
    let _e377 = share;
    let _e388 = share;
    let _e399 = share;
    let _e410 = share;
    let _e421 = share;
    rise = trunc(((((((vec4(1024f) + (band.early.x * _e371)) + (band.early.y * max((_e377 - vec4(64f)), vec4(0f)))) + (band.early.z * max((_e388 - vec4(256f)), vec4(0f)))) + (band.late.x * max((_e399 - vec4(512f)), vec4(0f)))) + (band.late.y * max((_e410 - vec4(768f)), vec4(0f)))) + (band.late.z * max((_e421 - vec4(960f)), vec4(0f)))));
    let _e437 = u_1;
    let _e439 = u_1;
    bent = trunc((vec4(band.spread.x) + (band.spread.y * trunc(((0.001953125f * _e437) * _e439)))));
    let _e448 = u_1;
    let _e449 = bent;
    let _e451 = w;
    let _e462 = rise;
    angle = (trunc((0.00024414063f * ((_e448 * _e449) + (_e451 * band.spread.z)))) * (vec4(band.widen.x) + (band.widen.y * _e462)));
    let _e469 = angle;
    part_2 = trunc((0.00012207031f * _e469));
    let _e474 = part_2;
    let _e476 = part_2;
    lag = trunc(((0.00048828125f * _e474) * _e476));
    let _e481 = rise;
    let _e483 = rise;
    steep = trunc(((0.0009765625f * _e481) * _e483));
    let _e487 = steep;
    let _e489 = steep;
    let _e491 = lag;
    carried = (_e487 - trunc(((0.0009765625f * _e489) * _e491)));
    let _e496 = scale_2;
    let _e497 = rise;
    let _e499 = half_step;
    count = trunc(((_e496 * _e497) + vec4(_e499)));
    let _e505 = count;
    if (quantum.x > 1f) {
        local_22 = 0f;
    } else {
        local_22 = (band.low / 16384f);
    }
    let _e515 = local_22;
    let _e517 = carried;
    turning = ((quantum.x * _e505) - trunc((_e515 * trunc((6.7265625f * _e517)))));
    if normal {
        local_23 = 0.9986f;
    } else {
        local_23 = 0.978f;
    }
    let _e527 = local_23;
    let _e534 = count;
    let _e536 = count;
    k = (((((_e527 * 0.000000000937f) * quantum.x) * quantum.x) * _e534) * _e536);
    let _e540 = angle;
    chord = (0.00000011920929f * _e540);
    let _e545 = chord;
    let _e547 = chord;
    cosine = (vec4(1f) - ((0.5f * _e545) * _e547));
    let _e552 = chord;
    let _e555 = chord;
    let _e557 = chord;
    sine = (_e552 * sqrt((vec4(1f) - ((0.25f * _e555) * _e557))));
    let _e565 = cosine;
    let _e568 = sine;
    x_6 = ((heading.x * _e565) - (heading.y * _e568));
    let _e573 = cosine;
    let _e576 = sine;
    y_4 = ((heading.y * _e573) + (heading.x * _e576));
    let _e580 = turning;
    let _e585 = word_5;
    ticks = (((vec4<u32>(vec4<i32>(_e580)) * u32(second)) + (_e585 >> vec4(16u))) & vec4(65535u));
    let _e595 = k;
    let _e597 = x_6;
    let _e598 = from_x;
    let _e600 = y_4;
    let _e601 = from_y;
    let _e606 = ticks;
    let _e608 = turning;
    phase_1 = (((0.15915494f * _e595) * ((_e597 * _e598) + (_e600 * _e601))) - (0.000015258789f * (vec4<f32>(_e606) + (_e608 * fraction))));
    let _e614 = phase_1;
    let _e616 = gabor_impl_wave(_e614.x);
    a_3 = _e616;
    let _e618 = phase_1;
    let _e620 = gabor_impl_wave(_e618.y);
    b_3 = _e620;
    let _e622 = phase_1;
    let _e624 = gabor_impl_wave(_e622.z);
    c_2 = _e624;
    let _e626 = phase_1;
    let _e628 = gabor_impl_wave(_e626.w);
    d = _e628;
    let _e631 = word_5;
    square = (0.000015258789f * vec4<f32>((_e631 & vec4(65535u))));
    let _e638 = k;
    let _e639 = x_6;
    let _e642 = y_4;
    steps_x = (_e638 * ((_e639 * dx.x) + (_e642 * dx.y)));
    let _e648 = k;
    let _e649 = x_6;
    let _e652 = y_4;
    steps_y = (_e648 * ((_e649 * dy.x) + (_e652 * dy.y)));
    let _e660 = steps_x;
    let _e661 = steps_x;
    let _e663 = steps_y;
    let _e664 = steps_y;
    kept = exp((-0.125f * ((_e660 * _e661) + (_e663 * _e664))));
    let _e670 = kept;
    let _e671 = square;
    amplitude_2 = (_e670 * sqrt(_e671));
    let _e675 = amplitude_2;
    if normal {
        let _e678 = square;
        let _e684 = square;
        local_24 = ((vec4(1.3034767f) + (0.3870924f * _e678)) + (vec4(0.0960481f) / (vec4(1.0580432f) - _e684)));
    } else {
        local_24 = vec4(2f);
    }
    let _e693 = local_24;
    amplitude_2 = (_e675 * _e693);
    let _e695 = amplitude_2;
    let _e696 = a_3;
    let _e698 = b_3;
    let _e700 = c_2;
    let _e702 = d;
    height = (_e695 * vec4<f32>(_e696.y, _e698.y, _e700.y, _e702.y));
    let _e707 = window;
    let _e708 = amplitude_2;
    let _e710 = a_3;
    let _e712 = b_3;
    let _e714 = c_2;
    let _e716 = d;
    along_2 = ((_e707 * _e708) * vec4<f32>(_e710.x, _e712.x, _e714.x, _e716.x));
    let _e722 = (*sum);
    let _e724 = height;
    let _e725 = window_x;
    let _e727 = height;
    let _e728 = window_y;
    (*sum).slope = (_e722.slope + vec2<f32>(dot(_e724, _e725), dot(_e727, _e728)));
    let _e732 = height;
    let _e733 = window;
    height = (_e732 * _e733);
    let _e735 = k;
    let _e736 = along_2;
    steepness = (_e735 * _e736);
    let _e739 = k;
    let _e740 = height;
    squeezed = (_e739 * _e740);
    if normal {
        local_25 = 1.003f;
    } else {
        local_25 = 1.048f;
    }
    let _e746 = local_25;
    let _e747 = window;
    let _e749 = window;
    let _e751 = k;
    let _e753 = k;
    let _e756 = kept;
    let _e757 = kept;
    lost = (((((_e746 * _e747) * _e749) * _e751) * _e753) * (vec4(1f) - (_e756 * _e757)));
    let _e764 = (*sum);
    let _e766 = height;
    (*sum).height = (_e764.height + dot(_e766, vec4(1f)));
    let _e772 = (*sum);
    let _e774 = steepness;
    let _e775 = x_6;
    let _e777 = steepness;
    let _e778 = y_4;
    (*sum).slope = (_e772.slope + vec2<f32>(dot(_e774, _e775), dot(_e777, _e778)));
    let _e783 = (*sum);
    let _e785 = along_2;
    let _e786 = x_6;
    let _e788 = along_2;
    let _e789 = y_4;
    (*sum).shift = (_e783.shift + vec2<f32>(dot(_e785, _e786), dot(_e788, _e789)));
    let _e793 = (*squeeze);
    let _e794 = squeezed;
    let _e795 = x_6;
    let _e796 = x_6;
    let _e799 = squeezed;
    let _e800 = x_6;
    let _e801 = y_4;
    let _e804 = squeezed;
    (*squeeze) = (_e793 + vec3<f32>(dot(_e794, (_e795 * _e796)), dot(_e799, (_e800 * _e801)), dot(_e804, vec4(1f))));
    let _e811 = (*sum);
    let _e813 = lost;
    let _e814 = x_6;
    let _e815 = x_6;
    let _e818 = lost;
    let _e819 = x_6;
    let _e820 = y_4;
    let _e823 = lost;
    (*sum).lost = (_e811.lost + vec3<f32>(dot(_e813, (_e814 * _e815)), dot(_e818, (_e819 * _e820)), dot(_e823, vec4(1f))));
    return;
}

fn gabor_water_at(cell: vec2<i32>, local: vec2<f32>, whole_seconds: i32, fraction: f32, dx: vec2<f32>, dy: vec2<f32>, ocean: GaborOcean, seed: u32) -> GaborWater {
    var wind_2: vec2<f32>;
    var swell_1: vec2<f32>;
    var water: GaborWater;
    var squeeze_1: vec3<f32> = vec3(0f);
    var local_27: vec2<f32>;
    var quantum_1: vec2<f32>;
    var area: f32;
    var sides: f32;
    var least_1: f32;
    var i_1: i32 = 0i;
    var local_28: i32;
    var remote_1: bool;
    var local_29: vec2<f32>;
    var local_30: i32;
    let _e11 = gabor_impl_wave((0.15915494f * ocean.direction));
    wind_2 = _e11;
    let _e17 = gabor_impl_wave((0.15915494f * ocean.swell.z));
    swell_1 = _e17;
    let _e26 = wind_2;
    let _e27 = gabor_impl_slopes_along(ocean.tail, _e26);
    water = GaborWater(0f, vec2(0f), vec2(0f), 0f, _e27);
    if (ocean.loop_seconds > 0i) {
        local_27 = vec2<f32>(f32((65536i / max(ocean.loop_seconds, 1i))), (0.000015258789f * f32(ocean.loop_seconds)));
    } else {
        local_27 = vec2(1f);
    }
    let _e50 = local_27;
    quantum_1 = _e50;
    area = ((dx.x * dy.y) - (dx.y * dy.x));
    sides = (dot(dx, dx) + dot(dy, dy));
    let _e65 = area;
    let _e67 = area;
    let _e69 = sides;
    let _e70 = sides;
    let _e71 = sides;
    let _e74 = area;
    let _e76 = area;
    least_1 = (((2f * _e65) * _e67) / max((_e69 + sqrt(max(((_e70 * _e71) - ((4f * _e74) * _e76)), 0f))), 0.000000000000000000000000000001f));
    loop {
        let _e89 = i_1;
        if (ocean.swell.x > 0f) {
            local_28 = 10i;
        } else {
            local_28 = 9i;
        }
        let _e99 = local_28;
        if !((_e89 < _e99)) {
            break;
        }
        {
            let _e105 = i_1;
            remote_1 = (_e105 == 9i);
            let _e111 = i_1;
            let _e114 = remote_1;
            let _e115 = i_1;
            let _e118 = i_1;
            let _e123 = remote_1;
            if _e123 {
                let _e124 = swell_1;
                local_29 = _e124;
            } else {
                let _e125 = wind_2;
                local_29 = _e125;
            }
            let _e127 = local_29;
            let _e128 = quantum_1;
            let _e129 = least_1;
            let _e130 = remote_1;
            if _e130 {
                local_30 = 12i;
            } else {
                let _e132 = i_1;
                local_30 = _e132;
            }
            let _e134 = local_30;
            let _e135 = gabor_derived_seed(seed, _e134);
            gabor_impl_add_band((&water), (&squeeze_1), ocean.band[_e111], (_e114 || ((_e115 > 0i) && (_e118 < 4i))), _e127, _e128, _e129, cell, local, whole_seconds, fraction, dx, dy, _e135);
        }
        continuing {
            let _e102 = i_1;
            i_1 = (_e102 + 1i);
        }
    }
    let _e140 = squeeze_1;
    let _e144 = squeeze_1;
    let _e147 = squeeze_1;
    let _e151 = squeeze_1;
    let _e153 = squeeze_1;
    water.jacobian = (((1f - _e140.x) * ((1f - _e144.z) + _e147.x)) - (_e151.y * _e153.y));
    let _e158 = water;
    let _e161 = water;
    let _e164 = water;
    let _e168 = water;
    water.lost = vec3<f32>(_e158.lost.x, (_e161.lost.z - _e164.lost.x), _e168.lost.y);
    let _e172 = water;
    return _e172;
}

fn gabor_water_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    var cell_4: vec2<f32>;
    var second_3: f32;
    cell_4 = floor(p);
    second_3 = floor(seconds);
    let _e10 = cell_4;
    let _e12 = cell_4;
    let _e14 = second_3;
    let _e16 = second_3;
    let _e18 = gabor_water_at(vec2<i32>(_e10), (p - _e12), i32(_e14), (seconds - _e16), dx, dy, ocean, seed);
    return _e18;
}

fn gabor_water(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> GaborWater {
    let _e8 = gabor_water_filtered(p, vec2(0f), vec2(0f), seconds, ocean, seed);
    return _e8;
}

fn gabor_water_height(p: vec2<f32>, seconds: f32, ocean: GaborOcean, seed: u32) -> f32 {
    var water_1: GaborWater = GaborWater(0f, vec2(0f), vec2(0f), 0f, vec3(0f));
    var i_2: i32 = 0i;
    loop {
        let _e16 = i_2;
        if !((_e16 < 6i)) {
            break;
        }
        let _e23 = water_1;
        let _e26 = gabor_water((p - _e23.shift), seconds, ocean, seed);
        water_1 = _e26;
        continuing {
            let _e20 = i_2;
            i_2 = (_e20 + 1i);
        }
    }
    let _e27 = water_1;
    return _e27.height;
}


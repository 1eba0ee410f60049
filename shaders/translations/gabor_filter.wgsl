// Generated from gabor_filter.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 1f98428906cf29fd.
// Paste it after gabor_noise.wgsl, gabor_spectrum.wgsl.
//
// gabor_filter.wgsl: Gabor noise averaged over a pixel, so that distant noise neither flickers nor shows moire.
//
// Paste or include this file after gabor_noise.wgsl, with GABOR_TAPS 3, the default; and after gabor_spectrum.wgsl, if you
// filter its noises.
//
//     vec2f f = gabor_noise_filtered(p, dpdx(p), dpdy(p), 4.0, 0.7854, 7u);   // noise, removed share of its variance
//
//     I want                                   call
//     filtered noise                           gabor_noise_filtered
//     its gradient, or any place or wave       gabor_field_filtered
//     stripes without moire                    gabor_stripes_of(gabor_field_filtered(...), sharpness)
//     isotropic noise, or a sum of lobes       gabor_field_isotropic_filtered, gabor_field_lobes_filtered
//     noise on meshes, filtered                gabor_filter_3d.wgsl
//
// Arguments of all functions, besides those of gabor_noise.wgsl:
//     dx, dy  change of p, in kernel radii, from one pixel to the next along x and y: dpdx(p) and dpdy(p), or any two
//             vectors. Where p jumps, as fract(uv) does, take the derivatives of the coordinate before it jumps. The
//             filter is Gaussian with the covariance (dx dx^T + dy dy^T) / 4: its standard deviation is half a pixel.
// A field's `removed` is the share of the variance that averaging removed. A material can add it, which is lost contrast,
// to its roughness. Gradients are those at a fixed footprint.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// vec2f gabor_noise_filtered(vec2f p, vec2f dx, vec2f dy, f32 frequency, f32 orientation, u32 seed)
//     (noise, removed).

// GaborField gabor_field_filtered(GaborPlace place, vec2f dx, vec2f dy, vec2f wave, u32 seed)
//     The filtered noise at `place`.
//     The rms error against exactly filtered noise is at most 1 % of a standard deviation while the pixel's longest
//     axis, twice the filter's largest standard deviation, is at most a third of a kernel radius, and 2 % up to a whole
//     radius; at the worst point, these errors are 2 and 3 %. For larger pixels, only the variance is right. The result
//     is continuous in p, dx and dy. The cost on GPUs, relative to gabor_noise, is 1.4 for pixels up to 0.18 kernel
//     radii (9 nodes), 3.1 from 0.2 (16 nodes), 3.4 from 0.66 along x or y (20 nodes), and 3.8 from 0.66 along both (25
//     nodes); between 0.18 and 0.2, both of the first two filters run. On CPUs, where drivers run both sides of a
//     branch, the cost is 3 for small pixels and 5 for larger ones.

// GaborField gabor_field_isotropic_filtered(GaborPlace place, vec2f dx, vec2f dy, f32 frequency, u32 seed)
//     gabor_field_isotropic, filtered, at about twice its cost. The rms error against exactly filtered noise is 2 % of a
//     standard deviation while the pixel's longest axis is at most 0.3 kernel radii, and 4 % at 0.4. For larger pixels,
//     only the variance is right.

// GaborField gabor_field_lobes_filtered(GaborPlace place, vec2f dx, vec2f dy, GaborLobes lobes, u32 seed)
//     gabor_field_lobes, filtered. dx and dy are in units of p.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================
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
// waves gradually replace three.
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
    var d_2: f32;
    var exponent: f32;
    area = (6.579736f * ((covariance.x * covariance.y) - (covariance.z * covariance.z)));
    let _e17 = area;
    d_2 = (1f + (6.579736f * ((covariance.x + covariance.y) + _e17)));
    let _e23 = d_2;
    let _e25 = gabor_impl_symmetric(covariance, wave);
    let _e26 = area;
    exponent = ((39.478416f / _e23) * dot(wave, (_e25 + (_e26 * wave))));
    let _e32 = exponent;
    let _e38 = d_2;
    return (exp(-(clamp(_e32, 0f, 80f))) * inverseSqrt(_e38));
}

// The covariance of a pixel's filter: xx, yy, xy in kernel radii^2, where nodes are 1 / GABOR_CELLS_PER_RADIUS apart.
struct GaborFootprint {
    covariance: vec3<f32>,
    resolved: vec3<f32>, // the same, limited to standard deviations of 1/2, the most that the windows allow
}

fn gabor_impl_footprint(dx: vec2<f32>, dy: vec2<f32>) -> GaborFootprint {
    var dx_1: vec2<f32>;
    var dy_1: vec2<f32>;
    var footprint: GaborFootprint;
    var mean: f32;
    var axis_1: vec2<f32>;
    var apart: f32;
    var larger: f32;
    var side_1: f32;
    var smaller: f32;
    var local_15: f32;
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
    footprint.covariance = (0.25f * vec3<f32>(_e29.x, _e29.y, ((_e30.x * _e32.y) + (_e35.x * _e37.y))));
    let _e46 = footprint;
    let _e49 = footprint;
    mean = (0.5f * (_e46.covariance.x + _e49.covariance.y));
    let _e56 = footprint;
    let _e59 = footprint;
    let _e64 = footprint;
    axis_1 = vec2<f32>((0.5f * (_e56.covariance.x - _e59.covariance.y)), _e64.covariance.z);
    let _e69 = axis_1;
    apart = length(_e69);
    let _e72 = mean;
    let _e73 = apart;
    larger = (_e72 + _e73);
    let _e77 = footprint;
    footprint.resolved = _e77.covariance;
    let _e79 = larger;
    if (_e79 > 0.25f) {
        {
            let _e83 = dx_1;
            let _e85 = dy_1;
            let _e88 = dx_1;
            let _e90 = dy_1;
            side_1 = (0.25f * ((_e83.x * _e85.y) - (_e88.y * _e90.x)));
            let _e96 = side_1;
            let _e97 = larger;
            let _e99 = side_1;
            smaller = min(((_e96 / _e97) * _e99), 0.25f);
            let _e104 = axis_1;
            let _e105 = apart;
            if (_e105 > 0f) {
                let _e110 = smaller;
                let _e113 = apart;
                local_15 = ((0.5f * (0.25f - _e110)) / _e113);
            } else {
                local_15 = 0f;
            }
            let _e117 = local_15;
            axis_1 = (_e104 * _e117);
            let _e122 = smaller;
            let _e125 = axis_1;
            let _e127 = axis_1;
            let _e135 = max((vec2((0.5f * (0.25f + _e122))) + vec2<f32>(_e125.x, -(_e127.x))), vec2(0f));
            let _e136 = axis_1;
            footprint.resolved = vec3<f32>(_e135.x, _e135.y, _e136.y);
        }
    }
    let _e141 = footprint;
    return _e141;
}

// Returns a node's filtered window, in the form with three waves, and the window's derivative. The filter multiplies
// the wave q = -1/2, 0 or 1/2 of Hann's window by exp(-2 pi^2 S q^2 - 4 pi^2 (S F) q), where S is its variance along
// the axis. If `even` and `odd` are the even and odd parts of this factor at q = 1/2, the window h becomes
// 1/2 + even (h - 1/2) + i odd h' / pi.
fn gabor_impl_filtered_node(value: f32, slope: f32, part: vec2<f32>, phase: vec2<f32>) -> vec4<f32> {
    var wave_9: vec2<f32>;
    var even: vec2<f32>;
    var odd: vec2<f32>;
    wave_9 = vec2<f32>((value - 0.5f), slope);
    let _e9 = wave_9;
    even = (part.x * _e9);
    let _e18 = wave_9;
    odd = ((part.y * vec2<f32>(-3.1415927f, 0.3183099f)) * _e18);
    let _e22 = even;
    let _e25 = odd;
    let _e28 = gabor_impl_product(vec2<f32>((0.5f + _e22.x), _e25.y), phase);
    let _e29 = even;
    let _e31 = odd;
    let _e34 = gabor_impl_product(vec2<f32>(_e29.y, _e31.x), phase);
    return vec4<f32>(_e28.x, _e28.y, _e34.x, _e34.y);
}

// The derivatives of a node from gabor_impl_filtered_node: the second derivative of its window w is -pi^2 (w - 1/2).
// `faded` is the derivative of the logarithm of the window's fade.
fn gabor_impl_filtered_derivative(node: vec4<f32>, faded: f32, phase: vec2<f32>) -> vec4<f32> {
    let _e6 = (node.zw + (faded * node.xy));
    let _e13 = (-9.869604f * (node.xy - (0.5f * phase)));
    return vec4<f32>(_e6.x, _e6.y, _e13.x, _e13.y);
}

// Filters an axis with the given S and S F. Windows fade out within half a standard deviation of their ends; the middle
// window never fades.
fn gabor_impl_filter(axis: ptr<function, GaborAxis>, variance: f32, blurred: f32, derivative: ptr<function, GaborAxis>) {
    var rise: f32;
    var part_1: vec2<f32>;
    var width_2: f32;
    var t_4: vec2<f32>;
    var fade: vec2<f32>;
    var faded_1: vec2<f32>;
    var turn_6: vec2<f32>;
    var first_1: vec2<f32>;
    var last: vec2<f32>;
    var value_6: vec4<f32>;
    var slope_7: vec4<f32>;
    rise = exp((19.739208f * blurred));
    let _e14 = rise;
    let _e16 = rise;
    let _e19 = rise;
    let _e21 = rise;
    part_1 = ((0.5f * exp((-4.934802f * variance))) * vec2<f32>((_e14 + (1f / _e16)), (_e19 - (1f / _e21))));
    width_2 = clamp((0.5f * sqrt(variance)), 0.001f, 0.05f);
    let _e36 = (*axis);
    let _e39 = (*axis);
    let _e45 = width_2;
    t_4 = clamp(((vec2(0.33333334f) + (0.6666667f * vec2<f32>(-(_e36.offset), _e39.offset))) / vec2(_e45)), vec2(0f), vec2(1f));
    let _e54 = t_4;
    let _e55 = t_4;
    let _e59 = t_4;
    fade = ((_e54 * _e55) * (vec2(3f) - (2f * _e59)));
    let _e66 = width_2;
    let _e68 = t_4;
    let _e71 = t_4;
    let _e75 = fade;
    faded_1 = (((((6f / _e66) * _e68) * (vec2(1f) - _e71)) / max(_e75, vec2(0.000001f))) * vec2<f32>(-1f, 1f));
    let _e86 = (*axis);
    let _e88 = gabor_impl_wave(_e86.turns);
    turn_6 = _e88;
    let _e90 = fade;
    let _e92 = turn_6;
    first_1 = (_e90.x * _e92);
    let _e95 = fade;
    let _e97 = turn_6;
    let _e99 = turn_6;
    last = (_e95.y * vec2<f32>(_e97.x, -(_e99.y)));
    let _e107 = (*axis);
    gabor_impl_windows(_e107.offset, (&value_6), (&slope_7));
    let _e116 = value_6;
    let _e118 = slope_7;
    let _e120 = part_1;
    let _e121 = first_1;
    let _e122 = gabor_impl_filtered_node(_e116.x, _e118.x, _e120, _e121);
    (*axis).node[0i] = _e122;
    let _e126 = value_6;
    let _e128 = slope_7;
    let _e130 = part_1;
    let _e134 = gabor_impl_filtered_node(_e126.y, _e128.y, _e130, vec2<f32>(1f, 0f));
    (*axis).node[1i] = _e134;
    let _e138 = value_6;
    let _e140 = slope_7;
    let _e142 = part_1;
    let _e143 = last;
    let _e144 = gabor_impl_filtered_node(_e138.z, _e140.z, _e142, _e143);
    (*axis).node[2i] = _e144;
    let _e145 = (*axis);
    (*derivative) = _e145;
    let _e152 = (*axis).node[0];
    let _e153 = faded_1;
    let _e155 = first_1;
    let _e156 = gabor_impl_filtered_derivative(_e152, _e153.x, _e155);
    (*derivative).node[0i] = _e156;
    let _e163 = (*axis).node[1];
    let _e168 = gabor_impl_filtered_derivative(_e163, 0f, vec2<f32>(1f, 0f));
    (*derivative).node[1i] = _e168;
    let _e175 = (*axis).node[2];
    let _e176 = faded_1;
    let _e178 = last;
    let _e179 = gabor_impl_filtered_derivative(_e175, _e176.y, _e178);
    (*derivative).node[2i] = _e179;
    return;
}

// The sum over nodes, with the coupling of the axes: 1 + S_xy d/dx d/dy.
fn gabor_impl_coupled_sum(columns: GaborAxis, rows: GaborAxis, coupling: f32, evolution: f32) -> vec2<f32> {
    var sum_9: vec4<f32>;
    var slope_8: vec4<f32>;
    gabor_impl_sum(columns, rows, evolution, (&sum_9), (&slope_8));
    let _e10 = sum_9;
    let _e12 = slope_8;
    return (_e10.xy + (coupling * _e12.zw));
}

// The filtered noise at `place`, with three waves along each axis.
fn gabor_impl_filtered_narrow(place: GaborPlace, wave: vec2<f32>, s: vec3<f32>, salt: u32) -> GaborField {
    var blurred_1: vec2<f32>;
    var columns_1: GaborAxis;
    var rows_1: GaborAxis;
    var turn_7: vec2<f32>;
    var columns_slope: GaborAxis;
    var rows_slope: GaborAxis;
    var value_7: vec2<f32>;
    var along_x_1: vec2<f32>;
    var along_y_1: vec2<f32>;
    let _e4 = gabor_impl_symmetric(s, wave);
    blurred_1 = _e4;
    let _e17 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x, 1.5f);
    columns_1 = _e17;
    let _e32 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), wave.y, 1.5f);
    rows_1 = _e32;
    let _e36 = blurred_1;
    let _e40 = columns_1;
    let _e42 = columns_1;
    let _e45 = rows_1;
    let _e47 = rows_1;
    let _e51 = gabor_impl_wave(((_e40.offset * _e42.turns) + (_e45.offset * _e47.turns)));
    turn_7 = (exp((-19.739208f * dot(wave, _e36))) * _e51);
    let _e54 = columns_1;
    columns_slope = _e54;
    let _e56 = rows_1;
    rows_slope = _e56;
    let _e60 = blurred_1;
    gabor_impl_filter((&columns_1), s.x, _e60.x, (&columns_slope));
    let _e67 = blurred_1;
    gabor_impl_filter((&rows_1), s.y, _e67.y, (&rows_slope));
    let _e72 = columns_1;
    let _e73 = rows_1;
    let _e76 = gabor_impl_coupled_sum(_e72, _e73, s.z, place.evolution);
    value_7 = _e76;
    let _e78 = columns_slope;
    let _e79 = rows_1;
    let _e82 = gabor_impl_coupled_sum(_e78, _e79, s.z, place.evolution);
    along_x_1 = _e82;
    let _e84 = columns_1;
    let _e85 = rows_slope;
    let _e88 = gabor_impl_coupled_sum(_e84, _e85, s.z, place.evolution);
    along_y_1 = _e88;
    let _e90 = value_7;
    let _e91 = along_x_1;
    let _e97 = along_y_1;
    let _e103 = turn_7;
    let _e106 = gabor_impl_field(vec4<f32>(_e90.x, _e90.y, _e91.x, _e91.y), vec4<f32>(_e97.x, _e97.y, 0f, 0f), _e103, wave, vec2(1f));
    return _e106;
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
    reach: f32, // w, in node spacings
    offset: f32, // offset of the point from the first node, in node spacings
    count: i32, // number of nodes, 4 or 5
    first: i32, // index of the first node
    period: i32,
    salt: u32,
    turn_back: vec2<f32>, // turn of the wave q = 1 / 2w from one node to the next
    back: vec2<f32>, // the same for the noise's wave
}

// Builds the windows, without their common factor e^(-g c^2), for a filter with a given standard deviation along the
// axis. `m` is r M in the plane and D in 3D.
fn gabor_impl_filtered_axis(deviation: f32, m: f32, c: f32, cell: i32, local: f32, period: i32, salt: u32, step_: vec2<f32>) -> GaborFilteredAxis {
    var b_2: GaborFilteredAxis;
    var local_17: i32;
    var local_18: f32;
    var zero_1: f32;
    var local_19: f32;
    var g: f32;
    var unit_1: f32;
    var fall: f32;
    var rise_1: f32;
    var sink: f32;
    var t_5: f32;
    var wave_11: vec3<f32>;
    var fall_4_: f32;
    var above: vec3<f32>;
    var below: vec3<f32>;
    var even_1: vec3<f32>;
    var odd_1: vec3<f32>;
    var q: vec3<f32>;
    var quarter: f32;
    var even_1_: vec3<f32>;
    var odd_1_: vec3<f32>;
    var even_2_: vec3<f32>;
    var odd_2_: vec3<f32>;
    b_2.reach = clamp((0.35f + (5f * deviation)), 2f, 2.5f);
    let _e18 = b_2;
    if (_e18.reach > 2f) {
        local_17 = 5i;
    } else {
        local_17 = 4i;
    }
    let _e25 = local_17;
    b_2.count = _e25;
    let _e26 = b_2;
    if (_e26.count == 5i) {
        local_18 = 0.5f;
    } else {
        local_18 = 1f;
    }
    let _e33 = local_18;
    zero_1 = (floor((local + _e33)) - 2f);
    let _e40 = b_2;
    if (_e40.count == 5i) {
        let _e44 = zero_1;
        local_19 = clamp((local - _e44), 1.5f, 2.5f);
    } else {
        let _e49 = zero_1;
        local_19 = clamp((local - _e49), 1f, 2f);
    }
    let _e55 = local_19;
    b_2.offset = _e55;
    let _e57 = zero_1;
    b_2.first = (cell + i32(_e57));
    b_2.period = period;
    b_2.salt = salt;
    let _e65 = b_2;
    let _e68 = gabor_impl_wave((-0.5f / _e65.reach));
    b_2.turn_back = _e68;
    b_2.back = vec2<f32>(step_.x, -(step_.y));
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
    t_5 = (_e103.reach - 2f);
    let _e113 = t_5;
    let _e119 = t_5;
    wave_11 = (vec3<f32>(0.25723323f, 0.12732396f, -0.03693604f) + (_e113 * (vec3<f32>(-0.03099653f, 0.22852218f, 0.10636504f) - (_e119 * vec3<f32>(0.0214304f, 0.11618766f, -0.1615392f)))));
    let _e130 = fall;
    let _e131 = fall;
    let _e133 = fall;
    let _e134 = fall;
    fall_4_ = ((_e130 * _e131) * (_e133 * _e134));
    let _e138 = wave_11;
    let _e139 = fall;
    let _e140 = fall_4_;
    let _e141 = fall_4_;
    let _e142 = fall_4_;
    let _e144 = fall;
    wave_11 = (_e138 * vec3<f32>(_e139, _e140, ((_e141 * _e142) * _e144)));
    let _e148 = wave_11;
    let _e149 = rise_1;
    let _e150 = rise_1;
    let _e151 = rise_1;
    let _e153 = rise_1;
    let _e154 = rise_1;
    let _e156 = rise_1;
    above = (_e148 * vec3<f32>(_e149, (_e150 * _e151), ((_e153 * _e154) * _e156)));
    let _e161 = wave_11;
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
    q = (_e182 * vec3<f32>(1f, 2f, 3f));
    let _e190 = g;
    quarter = (0.25f / _e190);
    let _e193 = q;
    let _e194 = odd_1;
    let _e196 = even_1;
    even_1_ = ((_e193 * _e194) - (c * _e196));
    let _e200 = q;
    let _e201 = even_1;
    let _e203 = odd_1;
    odd_1_ = ((_e200 * _e201) - (c * _e203));
    let _e207 = q;
    let _e208 = odd_1_;
    let _e210 = even_1_;
    let _e213 = quarter;
    let _e214 = even_1;
    even_2_ = (((_e207 * _e208) - (c * _e210)) - (_e213 * _e214));
    let _e218 = q;
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
    fade: vec2<f32>, // factor of the window, and its derivative
    turn: vec2<f32>, // e^(2 pi i d / 2w)
    phase: vec2<f32>, // the same for the noise's wave
}

// The factor by which the windows of line `index` fade over the last quarter of a node spacing, and its derivative.
fn gabor_impl_fade(b: GaborFilteredAxis, index: i32) -> vec2<f32> {
    var d_3: f32;
    var t_6: f32;
    d_3 = (b.offset - f32(index));
    let _e8 = d_3;
    t_6 = clamp((4f * (b.reach - abs(_e8))), 0f, 1f);
    let _e16 = t_6;
    let _e17 = t_6;
    let _e20 = t_6;
    let _e31 = d_3;
    let _e35 = t_6;
    return (_e16 * vec2<f32>((_e17 * (3f - (2f * _e20))), ((-36f * sign(_e31)) * (1f - _e35))));
}

// Computes line `index` from its turn and phase.
fn gabor_impl_filtered_line(b: GaborFilteredAxis, index: i32, turn: vec2<f32>, phase: vec2<f32>, fade: vec2<f32>) -> GaborFilteredLine {
    var line: GaborFilteredLine;
    var real: vec3<f32>;
    var imaginary: vec3<f32>;
    let _e10 = gabor_impl_wrap((b.first + index), b.period);
    let _e12 = gabor_impl_line_word(_e10, b.salt);
    line.word = _e12;
    line.turn = turn;
    line.phase = phase;
    real = (b.even_0_ + (turn.x * (b.even_1_ + (turn.x * (b.even_2_ + (turn.x * b.even_3_))))));
    imaginary = (turn.y * (b.odd_1_ + (turn.x * (b.odd_2_ + (turn.x * b.odd_3_)))));
    line.fade = fade;
    let _e44 = real;
    let _e47 = imaginary;
    let _e51 = imaginary;
    let _e54 = real;
    line.window = GaborFactors(((phase.x * _e44) - (phase.y * _e47)), ((phase.x * _e51) + (phase.y * _e54)));
    let _e58 = line;
    return _e58;
}

// Computes line `index` from the previous one.
fn gabor_impl_next_line(line: GaborFilteredLine, b: GaborFilteredAxis, index: i32, fade: vec2<f32>) -> GaborFilteredLine {
    let _e6 = gabor_impl_product(line.turn, b.turn_back);
    let _e9 = gabor_impl_product(line.phase, b.back);
    let _e10 = gabor_impl_filtered_line(b, index, _e6, _e9, fade);
    return _e10;
}

// The line's window with its fade.
fn gabor_impl_faded(line: GaborFilteredLine) -> GaborFactors {
    return GaborFactors((line.fade.x * line.window.real), (line.fade.x * line.window.imaginary));
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
    var columns_2: GaborColumns;
    var turn_9: vec2<f32>;
    let _e7 = gabor_impl_wave(((0.5f / b.reach) * b.offset));
    turn_9 = _e7;
    columns_2.five = (b.count == 5i);
    let _e15 = turn_9;
    let _e20 = gabor_impl_fade(b, 0i);
    let _e21 = gabor_impl_filtered_line(b, 0i, _e15, vec2<f32>(1f, 0f), _e20);
    columns_2.column_0_ = _e21;
    let _e23 = columns_2;
    let _e29 = gabor_impl_next_line(_e23.column_0_, b, 1i, vec2<f32>(1f, 0f));
    columns_2.column_1_ = _e29;
    let _e31 = columns_2;
    let _e37 = gabor_impl_next_line(_e31.column_1_, b, 2i, vec2<f32>(1f, 0f));
    columns_2.column_2_ = _e37;
    let _e39 = columns_2;
    let _e43 = gabor_impl_fade(b, 3i);
    let _e44 = gabor_impl_next_line(_e39.column_2_, b, 3i, _e43);
    columns_2.column_3_ = _e44;
    let _e46 = columns_2;
    columns_2.column_4_ = _e46.column_3_;
    let _e48 = columns_2;
    if _e48.five {
        let _e51 = columns_2;
        let _e55 = gabor_impl_fade(b, 4i);
        let _e56 = gabor_impl_next_line(_e51.column_3_, b, 4i, _e55);
        columns_2.column_4_ = _e56;
    }
    let _e57 = columns_2;
    return _e57;
}

// The line before line 0, given the phase of the noise's wave there.
fn gabor_impl_line_before(b: GaborFilteredAxis, phase: vec2<f32>) -> GaborFilteredLine {
    var line_3: GaborFilteredLine;
    let _e11 = gabor_impl_wave(((0.5f / b.reach) * (b.offset + 1f)));
    line_3.turn = _e11;
    line_3.phase = phase;
    let _e13 = line_3;
    return _e13;
}

// Returns the sum plus a complex number times the factors.
fn gabor_impl_plus_product(sum: GaborFactors, factors: GaborFactors, real: f32, imaginary: f32) -> GaborFactors {
    return GaborFactors((sum.real + ((real * factors.real) - (imaginary * factors.imaginary))), (sum.imaginary + ((real * factors.imaginary) + (imaginary * factors.real))));
}

// Adds a node to the sums of a row, and to those with the derivative of the fade.
fn gabor_impl_add_filtered_node(row: ptr<function, GaborFactors>, edge: ptr<function, GaborFactors>, column: GaborFilteredLine, row_word: u32, evolution: f32) {
    var a_3: vec2<f32>;
    var b_8: vec2<f32>;
    var c_4: vec2<f32>;
    let _e7 = gabor_impl_amplitude_at((column.word * row_word), evolution);
    a_3 = _e7;
    let _e11 = a_3;
    b_8 = (column.fade.x * _e11);
    let _e16 = a_3;
    c_4 = (column.fade.y * _e16);
    let _e19 = (*row);
    let _e21 = b_8;
    let _e23 = b_8;
    let _e25 = gabor_impl_plus_product(_e19, column.window, _e21.x, _e23.y);
    (*row) = _e25;
    let _e26 = (*edge);
    let _e28 = c_4;
    let _e30 = c_4;
    let _e32 = gabor_impl_plus_product(_e26, column.window, _e28.x, _e30.y);
    (*edge) = _e32;
    return;
}

// The sums of a row over its columns.
fn gabor_impl_filtered_row(columns: GaborColumns, row_word: u32, evolution: f32, edge: ptr<function, GaborFactors>) -> GaborFactors {
    var row_3: GaborFactors = GaborFactors(vec3(0f), vec3(0f));
    var none: GaborFactors;
    let _e10 = row_3;
    none = _e10;
    let _e12 = row_3;
    (*edge) = _e12;
    gabor_impl_add_filtered_node((&row_3), edge, columns.column_0_, row_word, evolution);
    gabor_impl_add_filtered_node((&row_3), (&none), columns.column_1_, row_word, evolution);
    gabor_impl_add_filtered_node((&row_3), (&none), columns.column_2_, row_word, evolution);
    gabor_impl_add_filtered_node((&row_3), edge, columns.column_3_, row_word, evolution);
    if columns.five {
        gabor_impl_add_filtered_node((&row_3), edge, columns.column_4_, row_word, evolution);
    }
    let _e39 = row_3;
    return _e39;
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
    var c_5: vec2<f32>;
    var rho: f32;
    var r_1: f32;
    var lambda: f32;
    var mixed: f32;
    var weights_1: vec3<f32>;
    var step_x: vec2<f32>;
    var step_y: vec2<f32>;
    var across: GaborFilteredAxis;
    var along: GaborFilteredAxis;
    var columns_4: GaborColumns;
    var line_4: GaborFilteredLine;
    var local_20: i32;
    var rows_2: i32;
    var value_8: vec2<f32> = vec2(0f);
    var next_x: vec2<f32> = vec2(0f);
    var next_y: vec2<f32> = vec2(0f);
    var edge_x: vec2<f32> = vec2(0f);
    var edge_y: vec2<f32> = vec2(0f);
    var j_3: i32 = 0i;
    var edge_2: GaborFactors;
    var row_4: GaborFactors;
    var window_2: GaborFactors;
    var exponent_1: f32;
    var mean_1: vec2<f32>;
    var before: vec2<f32>;
    var x_9: vec2<f32>;
    var y_6: vec2<f32>;
    var local_21: f32;
    var scale: f32;
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
    c_5 = (_e23 / vec2(((s.z * s.z) - (_e27.x * _e29.y))));
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
    let _e102 = c_5;
    let _e110 = step_x;
    let _e111 = gabor_impl_filtered_axis(_e96.x, (_e98 * _e99.x), _e102.x, place.cell.x, place.local.x, place.period.x, salt, _e110);
    across = _e111;
    let _e113 = deviation_1;
    let _e115 = r_1;
    let _e116 = m_1;
    let _e119 = c_5;
    let _e129 = step_y;
    let _e130 = gabor_impl_filtered_axis(_e113.y, (_e115 * _e116.y), _e119.y, place.cell.y, place.local.y, place.period.y, (salt ^ 1540483477u), _e129);
    along = _e130;
    let _e132 = across;
    let _e133 = gabor_impl_columns(_e132);
    columns_4 = _e133;
    let _e135 = along;
    let _e136 = across;
    let _e138 = along;
    let _e149 = gabor_impl_wave((dot(wave, vec2<f32>(_e136.offset, (_e138.offset + 1f))) / 1.5f));
    let _e150 = gabor_impl_line_before(_e135, _e149);
    line_4 = _e150;
    if wanted {
        let _e152 = along;
        local_20 = _e152.count;
    } else {
        local_20 = 0i;
    }
    let _e156 = local_20;
    rows_2 = _e156;
    loop {
        {
            let _e175 = line_4;
            let _e176 = along;
            let _e177 = j_3;
            let _e178 = along;
            let _e179 = j_3;
            let _e180 = gabor_impl_fade(_e178, _e179);
            let _e181 = gabor_impl_next_line(_e175, _e176, _e177, _e180);
            line_4 = _e181;
            edge_2 = GaborFactors(vec3(0f), vec3(0f));
            let _e188 = columns_4;
            let _e189 = line_4;
            let _e194 = gabor_impl_filtered_row(_e188, _e189.word, place.evolution, (&edge_2));
            row_4 = _e194;
            let _e196 = line_4;
            let _e197 = gabor_impl_faded(_e196);
            window_2 = _e197;
            let _e199 = value_8;
            let _e200 = row_4;
            let _e201 = window_2;
            let _e202 = weights_1;
            let _e203 = gabor_impl_contracted(_e200, _e201, _e202);
            value_8 = (_e199 + _e203);
            let _e205 = next_x;
            let _e206 = row_4;
            let _e207 = gabor_impl_next(_e206);
            let _e208 = window_2;
            let _e209 = weights_1;
            let _e210 = gabor_impl_contracted(_e207, _e208, _e209);
            next_x = (_e205 + _e210);
            let _e212 = next_y;
            let _e213 = row_4;
            let _e214 = window_2;
            let _e215 = gabor_impl_next(_e214);
            let _e216 = weights_1;
            let _e217 = gabor_impl_contracted(_e213, _e215, _e216);
            next_y = (_e212 + _e217);
            let _e219 = edge_x;
            let _e220 = edge_2;
            let _e221 = window_2;
            let _e222 = weights_1;
            let _e223 = gabor_impl_contracted(_e220, _e221, _e222);
            edge_x = (_e219 + _e223);
            let _e225 = edge_y;
            let _e226 = line_4;
            let _e229 = row_4;
            let _e230 = line_4;
            let _e232 = weights_1;
            let _e233 = gabor_impl_contracted(_e229, _e230.window, _e232);
            edge_y = (_e225 + (_e226.fade.y * _e233));
        }
        let _e236 = j_3;
        let _e238 = (_e236 + 1i);
        j_3 = _e238;
        let _e239 = rows_2;
        if !((_e238 < _e239)) {
            break;
        }
    }
    let _e243 = c_5;
    let _e245 = blurred_2;
    let _e247 = r_1;
    let _e248 = m_1;
    let _e249 = c_5;
    let _e250 = c_5;
    exponent_1 = (19.739208f * (dot((wave + _e243), _e245) + (_e247 * dot(_e248, (_e249 * _e250)))));
    let _e257 = c_5;
    mean_1 = (wave + _e257);
    let _e260 = lambda;
    let _e261 = m_1;
    let _e263 = m_1;
    before = (_e260 * sqrt((_e261.yx / _e263)));
    let _e269 = mean_1;
    let _e271 = value_8;
    let _e273 = next_x;
    let _e275 = before;
    let _e277 = next_y;
    x_9 = (6.2831855f * (((_e269.x * _e271) + _e273) - (_e275.x * _e277)));
    let _e283 = mean_1;
    let _e285 = value_8;
    let _e287 = next_y;
    let _e289 = before;
    let _e291 = next_x;
    y_6 = (6.2831855f * (((_e283.y * _e285) + _e287) - (_e289.y * _e291)));
    let _e296 = edge_x;
    let _e297 = x_9;
    let _e300 = x_9;
    x_9 = (_e296 + vec2<f32>(-(_e297.y), _e300.x));
    let _e304 = edge_y;
    let _e305 = y_6;
    let _e308 = y_6;
    y_6 = (_e304 + vec2<f32>(-(_e305.y), _e308.x));
    let _e313 = lambda;
    let _e314 = lambda;
    let _e318 = exponent_1;
    if false {
        local_21 = 1f;
    } else {
        local_21 = 1.125f;
    }
    let _e332 = local_21;
    scale = ((sqrt((1f - (_e313 * _e314))) * exp(-(_e318))) / (1459955300000000000000000000f * _e332));
    let _e336 = scale;
    let _e337 = value_8;
    let _e340 = scale;
    let _e341 = x_9;
    let _e343 = y_6;
    let _e347 = scale;
    let _e348 = value_8;
    let _e351 = scale;
    let _e352 = x_9;
    let _e354 = y_6;
    return GaborField((_e336 * _e337.y), (_e340 * vec2<f32>(_e341.y, _e343.y)), (_e347 * _e348.x), (_e351 * vec2<f32>(_e352.x, _e354.x)), 0f);
}

// The share of the form with seven waves in the filtered noise; the rest is the form with three.
fn gabor_impl_wide_share(footprint: GaborFootprint) -> f32 {
    return clamp(((100f * sqrt(max(footprint.resolved.x, footprint.resolved.y))) - 9f), 0f, 1f);
}

// Nodes are `stretch` / GABOR_CELLS_PER_RADIUS kernel radii apart.
fn gabor_impl_filtered(place: GaborPlace, footprint: GaborFootprint, wide: f32, wave: vec2<f32>, seed: u32) -> GaborField {
    var wave_14: vec2<f32>;
    var stretch_3: vec2<f32>;
    var transmitted: f32;
    var sum_11: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var s_4: vec3<f32>;
    var salt_8: u32;
    var amplitude_2: f32 = 1f;
    wave_14 = wave;
    stretch_3 = (place.cells_per_radius / vec2(1.5f));
    let _e14 = wave_14;
    let _e21 = stretch_3;
    wave_14 = (clamp(_e14, vec2(-1000000f), vec2(1000000f)) / _e21);
    let _e23 = wave_14;
    let _e25 = gabor_impl_transmitted(_e23, footprint.covariance);
    transmitted = _e25;
    let _e36 = transmitted;
    if (_e36 >= 0.0000000001f) {
        {
            s_4 = footprint.resolved;
            let _e41 = gabor_impl_salt(seed);
            salt_8 = _e41;
            if (distance(footprint.resolved, footprint.covariance) > 0f) {
                let _e50 = amplitude_2;
                let _e51 = transmitted;
                let _e52 = wave_14;
                let _e53 = s_4;
                let _e54 = gabor_impl_transmitted(_e52, _e53);
                amplitude_2 = (_e50 * sqrt((_e51 / _e54)));
            }
            if (wide < 1f) {
                let _e61 = wave_14;
                let _e62 = s_4;
                let _e63 = salt_8;
                let _e64 = gabor_impl_filtered_narrow(place, _e61, _e62, _e63);
                let _e67 = amplitude_2;
                let _e69 = stretch_3;
                gabor_impl_add_field((&sum_11), _e64, ((1f - wide) * _e67), _e69);
            }
            if (wide > 0f) {
                let _e74 = wave_14;
                let _e75 = s_4;
                let _e78 = salt_8;
                let _e79 = gabor_impl_filtered_wide(place, _e74, _e75, (wide > 0f), _e78);
                let _e80 = amplitude_2;
                let _e82 = stretch_3;
                gabor_impl_add_field((&sum_11), _e79, (wide * _e80), _e82);
            }
        }
    }
    let _e86 = transmitted;
    sum_11.removed = (1f - _e86);
    let _e88 = sum_11;
    return _e88;
}

fn gabor_field_filtered(place: GaborPlace, dx: vec2<f32>, dy: vec2<f32>, wave: vec2<f32>, seed: u32) -> GaborField {
    var stretch_4: vec2<f32>;
    var footprint_3: GaborFootprint;
    stretch_4 = (place.cells_per_radius / vec2(1.5f));
    let _e13 = stretch_4;
    let _e15 = stretch_4;
    let _e17 = gabor_impl_footprint((_e13 * dx), (_e15 * dy));
    footprint_3 = _e17;
    let _e19 = footprint_3;
    let _e20 = footprint_3;
    let _e21 = gabor_impl_wide_share(_e20);
    let _e22 = gabor_impl_filtered(place, _e19, _e21, wave, seed);
    return _e22;
}

fn gabor_noise_filtered(p: vec2<f32>, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> vec2<f32> {
    var field_7: GaborField;
    let _e6 = gabor_place_at(p);
    let _e7 = gabor_wave_vector(frequency, orientation);
    let _e8 = gabor_field_filtered(_e6, dx, dy, _e7, seed);
    field_7 = _e8;
    let _e10 = field_7;
    let _e12 = field_7;
    return vec2<f32>(_e10.noise, _e12.removed);
}

// Approximates exp(-q/2) I_0(q/2), the mean of exp(-q cos^2) over angles, by the square root of a rational function.
fn gabor_impl_mean_angle(q: f32) -> f32 {
    return sqrt(((1f + (q * (0.19075951f + (0.0865599f * q)))) / (1f + (q * (1.1907595f + (q * (0.60787135f + (0.27193594f * q))))))));
}

fn gabor_field_lobes_filtered(place: GaborPlace, dx: vec2<f32>, dy: vec2<f32>, lobes: GaborLobes, seed: u32) -> GaborField {
    var lobes_5: GaborLobes;
    var sum_12: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var power_4: f32;
    var i_6: i32 = 0i;
    var lobe_2: GaborLobe;
    var unit_2: vec2<f32>;
    var field_8: GaborField;
    var local_22: f32;
    lobes_5 = lobes;
    let _e15 = lobes_5;
    let _e16 = gabor_impl_lobes_power(_e15);
    power_4 = _e16;
    loop {
        let _e20 = i_6;
        let _e21 = lobes_5;
        if !((_e20 < min(_e21.count, 4i))) {
            break;
        }
        {
            let _e30 = i_6;
            let _e33 = lobes_5.lobe[_e30];
            lobe_2 = _e33;
            let _e36 = lobe_2;
            unit_2 = (vec2(1f) / _e36.radius);
            let _e41 = lobe_2;
            let _e43 = gabor_impl_stretched(place, _e41.radius);
            let _e44 = unit_2;
            let _e46 = unit_2;
            let _e48 = lobe_2;
            let _e49 = gabor_impl_lobe_wave(_e48);
            let _e50 = i_6;
            let _e51 = gabor_derived_seed(seed, _e50);
            let _e52 = gabor_field_filtered(_e43, (_e44 * dx), (_e46 * dy), _e49, _e51);
            field_8 = _e52;
            let _e55 = field_8;
            let _e56 = power_4;
            if (_e56 > 0f) {
                let _e59 = lobe_2;
                let _e61 = power_4;
                local_22 = sqrt((_e59.power / _e61));
            } else {
                local_22 = 0f;
            }
            let _e66 = local_22;
            let _e67 = unit_2;
            gabor_impl_add_field((&sum_12), _e55, _e66, _e67);
        }
        continuing {
            let _e27 = i_6;
            i_6 = (_e27 + 1i);
        }
    }
    let _e69 = sum_12;
    return _e69;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------

// The share of isotropic noise's variance that a filter keeps: the mean of gabor_impl_transmitted over all directions.
fn gabor_impl_transmitted_isotropic_2d(frequency: f32, covariance: vec3<f32>) -> f32 {
    var area_1: f32;
    var d_4: f32;
    var unit_3: f32;
    var apart_1: f32;
    var smaller_1: f32;
    area_1 = (6.579736f * ((covariance.x * covariance.y) - (covariance.z * covariance.z)));
    let _e17 = area_1;
    d_4 = (1f + (6.579736f * ((covariance.x + covariance.y) + _e17)));
    let _e23 = d_4;
    unit_3 = ((39.478416f / _e23) * min((frequency * frequency), 1000000000000f));
    apart_1 = length(vec2<f32>((covariance.x - covariance.y), (2f * covariance.z)));
    let _e39 = area_1;
    let _e44 = apart_1;
    smaller_1 = (_e39 + max((0.5f * ((covariance.x + covariance.y) - _e44)), 0f));
    let _e51 = unit_3;
    let _e52 = smaller_1;
    let _e59 = unit_3;
    let _e60 = apart_1;
    let _e64 = gabor_impl_mean_angle(min((_e59 * _e60), 100000000f));
    let _e66 = d_4;
    return ((exp(-(clamp((_e51 * _e52), 0f, 80f))) * _e64) * inverseSqrt(_e66));
}

// A node's window along both axes, filtered: middle + cosine, and its derivative, sine.
struct GaborWindows {
    middle: vec2<f32>,
    cosine: vec2<f32>,
    sine: vec2<f32>,
}

// Adds a node's wave, filtered with covariance s. `a` is its amplitude times the wave at the point. The filter multiplies
// it by exp(-2 pi^2 F.S F) and shifts its window along each axis by i x / pi, x = 2 pi^2 S F: see
// gabor_impl_filtered_node.
fn gabor_impl_add_filtered_wave(sum: ptr<function, GaborField>, node: GaborWindows, faded: vec2<f32>, s: vec3<f32>, a: vec2<f32>, wave: vec2<f32>) {
    var a_6: vec2<f32>;
    var x_10: vec2<f32>;
    var y_7: vec2<f32>;
    var even_2: vec2<f32>;
    var odd_2: vec2<f32>;
    var real_2: vec2<f32>;
    var imaginary_2: vec2<f32>;
    var h_x: vec2<f32>;
    var h_y: vec2<f32>;
    var value_9: vec2<f32>;
    var along_x_2: vec2<f32>;
    var along_y_2: vec2<f32>;
    a_6 = a;
    let _e8 = gabor_impl_symmetric(s, wave);
    x_10 = (19.739208f * _e8);
    let _e11 = a_6;
    let _e12 = x_10;
    a_6 = (_e11 * exp(-(max(dot(wave, _e12), 0f))));
    let _e19 = x_10;
    x_10 = clamp(_e19, vec2(-3f), vec2(3f));
    let _e26 = x_10;
    let _e27 = x_10;
    y_7 = (_e26 * _e27);
    let _e31 = y_7;
    let _e34 = y_7;
    even_2 = (vec2(1f) + (_e31 * (vec2(0.5f) + (0.041666668f * _e34))));
    let _e42 = x_10;
    let _e44 = y_7;
    let _e47 = y_7;
    odd_2 = (_e42 * (vec2(1f) + (_e44 * (vec2(0.16666667f) + (0.008333333f * _e47)))));
    let _e57 = even_2;
    real_2 = (node.middle + (_e57 * node.cosine));
    let _e63 = odd_2;
    imaginary_2 = ((0.3183099f * _e63) * node.sine);
    let _e68 = real_2;
    let _e70 = imaginary_2;
    h_x = vec2<f32>(_e68.x, _e70.x);
    let _e74 = real_2;
    let _e76 = imaginary_2;
    h_y = vec2<f32>(_e74.y, _e76.y);
    let _e80 = h_x;
    let _e81 = h_y;
    let _e82 = gabor_impl_product(_e80, _e81);
    let _e93 = a_6;
    let _e94 = gabor_impl_product((_e82 + vec2<f32>(((s.z * node.sine.x) * node.sine.y), 0f)), _e93);
    value_9 = _e94;
    let _e96 = even_2;
    real_2 = (_e96 * node.sine);
    let _e101 = odd_2;
    imaginary_2 = ((-3.1415927f * _e101) * node.cosine);
    let _e105 = real_2;
    let _e107 = imaginary_2;
    let _e110 = h_y;
    let _e111 = gabor_impl_product(vec2<f32>(_e105.x, _e107.x), _e110);
    let _e112 = a_6;
    let _e113 = gabor_impl_product(_e111, _e112);
    along_x_2 = _e113;
    let _e115 = h_x;
    let _e116 = real_2;
    let _e118 = imaginary_2;
    let _e121 = gabor_impl_product(_e115, vec2<f32>(_e116.y, _e118.y));
    let _e122 = a_6;
    let _e123 = gabor_impl_product(_e121, _e122);
    along_y_2 = _e123;
    let _e126 = (*sum);
    let _e128 = value_9;
    (*sum).noise = (_e126.noise + _e128.y);
    let _e132 = (*sum);
    let _e134 = along_x_2;
    let _e136 = along_y_2;
    let _e139 = value_9;
    let _e144 = value_9;
    (*sum).gradient = (_e132.gradient + ((vec2<f32>(_e134.y, _e136.y) + (_e139.y * faded)) + ((6.2831855f * _e144.x) * wave)));
    let _e151 = (*sum);
    let _e153 = value_9;
    (*sum).quadrature = (_e151.quadrature + _e153.x);
    let _e157 = (*sum);
    let _e159 = along_x_2;
    let _e161 = along_y_2;
    let _e164 = value_9;
    let _e169 = value_9;
    (*sum).quadrature_gradient = (_e157.quadrature_gradient + ((vec2<f32>(_e159.x, _e161.x) + (_e164.x * faded)) - ((6.2831855f * _e169.y) * wave)));
    return;
}

fn gabor_field_isotropic_filtered(place: GaborPlace, dx: vec2<f32>, dy: vec2<f32>, frequency: f32, seed: u32) -> GaborField {
    var frequency_15: f32;
    var s_6: vec3<f32>;
    var kept: f32;
    var field_9: GaborField;
    var narrower: f32;
    var local_23: f32;
    var amplitude_3: f32;
    var stretch_5: vec2<f32>;
    var unit_4: vec2<f32>;
    var fall_1: vec2<f32>;
    var width_3: vec2<f32>;
    var salt_9: u32;
    var x_11: GaborAxis;
    var y_8: GaborAxis;
    var sum_14: GaborField = GaborField(0f, vec2(0f), 0f, vec2(0f), 0f);
    var j_4: i32 = 0i;
    var row_5: vec4<u32>;
    var i_7: i32;
    var d_5: vec2<f32>;
    var star_2: GaborStar;
    var t_7: vec2<f32>;
    var fade_3: vec2<f32>;
    var change: vec2<f32>;
    var cosine: vec2<f32>;
    var node_2: GaborWindows;
    var faded_3: vec2<f32>;
    frequency_15 = frequency;
    let _e6 = gabor_impl_footprint(dx, dy);
    s_6 = _e6.covariance;
    let _e9 = frequency_15;
    frequency_15 = min(abs(_e9), 1000000f);
    let _e13 = frequency_15;
    let _e14 = s_6;
    let _e15 = gabor_impl_transmitted_isotropic_2d(_e13, _e14);
    kept = _e15;
    let _e24 = kept;
    field_9 = GaborField(0f, vec2(0f), 0f, vec2(0f), (1f - _e24));
    let _e28 = kept;
    if !((_e28 > 0.0000000001f)) {
        {
            field_9.removed = 1f;
            let _e34 = field_9;
            return _e34;
        }
    }
    let _e35 = s_6;
    let _e38 = s_6;
    let _e40 = s_6;
    let _e43 = s_6;
    let _e45 = s_6;
    let _e49 = s_6;
    s_6 = (_e35 * (0.04f / max((0.5f * ((_e38.x + _e40.y) + length(vec2<f32>((_e43.x - _e45.y), (2f * _e49.z))))), 0.04f)));
    let _e60 = frequency_15;
    let _e61 = s_6;
    let _e62 = gabor_impl_transmitted_isotropic_2d(_e60, _e61);
    narrower = _e62;
    if false {
        local_23 = 1f;
    } else {
        local_23 = 1.125f;
    }
    let _e75 = local_23;
    let _e78 = kept;
    let _e79 = narrower;
    amplitude_3 = ((0.57735026f / (1459955300000000000000000000f * _e75)) * sqrt(min((_e78 / max(_e79, 0.000000000000000000000000000001f)), 1f)));
    stretch_5 = (place.cells_per_radius / vec2(1.5f));
    let _e96 = frequency_15;
    let _e97 = stretch_5;
    unit_4 = (vec2(_e96) / _e97);
    let _e101 = s_6;
    let _e102 = stretch_5;
    let _e103 = stretch_5;
    let _e104 = (_e102 * _e103);
    let _e105 = stretch_5;
    let _e107 = stretch_5;
    s_6 = (_e101 * vec3<f32>(_e104.x, _e104.y, (_e105.x * _e107.y)));
    let _e116 = s_6;
    fall_1 = exp((-4.934802f * _e116.xy));
    let _e122 = s_6;
    width_3 = clamp((0.5f * sqrt(_e122.xy)), vec2(0.001f), vec2(0.05f));
    let _e132 = gabor_impl_salt(seed);
    salt_9 = _e132;
    let _e140 = salt_9;
    let _e146 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e140, 0f, 1.5f);
    x_11 = _e146;
    let _e154 = salt_9;
    let _e162 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, (_e154 ^ 1540483477u), 0f, 1.5f);
    y_8 = _e162;
    loop {
        let _e175 = j_4;
        if !((_e175 < 3i)) {
            break;
        }
        {
            let _e182 = j_4;
            let _e185 = y_8.word[_e182];
            let _e186 = gabor_impl_row(_e185);
            row_5 = _e186;
            i_7 = 0i;
            loop {
                let _e190 = i_7;
                if !((_e190 < 3i)) {
                    break;
                }
                {
                    let _e197 = x_11;
                    let _e199 = i_7;
                    let _e204 = y_8;
                    let _e206 = j_4;
                    d_5 = (vec2<f32>((_e197.offset - f32((_e199 - 1i))), (_e204.offset - f32((_e206 - 1i)))) / vec2(1.5f));
                    let _e219 = i_7;
                    let _e222 = x_11.word[_e219];
                    let _e223 = row_5;
                    let _e225 = unit_4;
                    let _e226 = d_5;
                    let _e229 = gabor_impl_star((_e222 * _e223), (_e225 * _e226), place.evolution);
                    star_2 = _e229;
                    let _e232 = d_5;
                    let _e236 = width_3;
                    t_7 = clamp(((vec2(1f) - abs(_e232)) / _e236), vec2(0f), vec2(1f));
                    let _e244 = t_7;
                    let _e245 = t_7;
                    let _e249 = t_7;
                    fade_3 = ((_e244 * _e245) * (vec2(3f) - (2f * _e249)));
                    let _e257 = width_3;
                    let _e260 = t_7;
                    let _e263 = t_7;
                    let _e267 = d_5;
                    change = ((((vec2(-6f) / _e257) * _e260) * (vec2(1f) - _e263)) * sign(_e267));
                    let _e271 = fall_1;
                    let _e272 = i_7;
                    let _e275 = x_11.node[_e272];
                    let _e277 = j_4;
                    let _e280 = y_8.node[_e277];
                    cosine = (_e271 * (vec2<f32>(_e275.x, _e280.x) - vec2(0.5f)));
                    let _e289 = fade_3;
                    let _e291 = fade_3;
                    let _e292 = cosine;
                    let _e294 = fade_3;
                    let _e295 = fall_1;
                    let _e297 = i_7;
                    let _e300 = x_11.node[_e297];
                    let _e302 = j_4;
                    let _e305 = y_8.node[_e302];
                    node_2 = GaborWindows((0.5f * _e289), (_e291 * _e292), ((_e294 * _e295) * vec2<f32>(_e300.z, _e305.z)));
                    let _e311 = change;
                    let _e312 = fade_3;
                    faded_3 = (_e311 / max(_e312, vec2(0.000001f)));
                    let _e319 = node_2;
                    let _e320 = faded_3;
                    let _e321 = s_6;
                    let _e322 = star_2;
                    let _e324 = unit_4;
                    let _e325 = star_2;
                    gabor_impl_add_filtered_wave((&sum_14), _e319, _e320, _e321, _e322.first, (_e324 * _e325.u));
                    let _e330 = node_2;
                    let _e331 = faded_3;
                    let _e332 = s_6;
                    let _e333 = star_2;
                    let _e335 = unit_4;
                    let _e336 = star_2;
                    gabor_impl_add_filtered_wave((&sum_14), _e330, _e331, _e332, _e333.second, (_e335 * _e336.v));
                    let _e341 = node_2;
                    let _e342 = faded_3;
                    let _e343 = s_6;
                    let _e344 = star_2;
                    let _e346 = unit_4;
                    let _e347 = star_2;
                    let _e349 = star_2;
                    gabor_impl_add_filtered_wave((&sum_14), _e341, _e342, _e343, _e344.third, (_e346 * (_e347.v - _e349.u)));
                }
                continuing {
                    let _e194 = i_7;
                    i_7 = (_e194 + 1i);
                }
            }
        }
        continuing {
            let _e179 = j_4;
            j_4 = (_e179 + 1i);
        }
    }
    let _e355 = sum_14;
    let _e356 = amplitude_3;
    let _e357 = stretch_5;
    gabor_impl_add_field((&field_9), _e355, _e356, _e357);
    let _e359 = field_9;
    return _e359;
}


// gabor_filter.glsl: Gabor noise averaged over a pixel, so that distant noise neither flickers nor shows moire.
//
// Paste or include this file after gabor_noise.glsl, with GABOR_TAPS 3, the default; and after gabor_spectrum.glsl, if
// you filter its noises.
//
//     vec2 f = gabor_noise_filtered(p, dFdx(p), dFdy(p), 4.0, 0.7854, 7u);   // noise, removed share of its variance
//
//     I want                                   call
//     filtered noise                           gabor_noise_filtered
//     its gradient, or any place or wave       gabor_field_filtered
//     stripes without moire                    gabor_stripes_of(gabor_field_filtered(...), sharpness)
//     isotropic noise, or a sum of lobes       gabor_field_isotropic_filtered, gabor_field_lobes_filtered
//     noise on meshes, filtered                gabor_filter_3d.glsl
//
// Arguments of all functions, besides those of gabor_noise.glsl:
//     dx, dy  change of p, in kernel radii, from one pixel to the next along x and y: dFdx(p) and dFdy(p), or any two
//             vectors. Where p jumps, as fract(uv) does, take the derivatives of the coordinate before it jumps. The
//             filter is Gaussian with the covariance (dx dx^T + dy dy^T) / 4: its standard deviation is half a pixel.
// A field's `removed` is the share of the variance that averaging removed. A material can add it, which is lost
// contrast, to its roughness. Gradients are those at a fixed footprint. Where the filter's windows fade, they are not
// the derivatives of the returned noise, but are closer to those of the exactly filtered noise.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

#ifndef GABOR_NOISE_GLSL
#error Include gabor_noise.glsl before gabor_filter.glsl
#endif
#if GABOR_TAPS != 3
#error gabor_filter.glsl needs GABOR_TAPS 3
#endif
#ifndef GABOR_FILTER_GLSL
#define GABOR_FILTER_GLSL 1

// vec2 gabor_noise_filtered(vec2 p, vec2 dx, vec2 dy, float frequency, float orientation, uint seed)
//     The filtered noise, and the share of the variance that the filter removed.

// GaborField gabor_field_filtered(GaborPlace place, vec2 dx, vec2 dy, vec2 wave, uint seed)
//     The filtered noise at `place`.
//     The rms error against exactly filtered noise is at most 1 % of a standard deviation while the pixel's longest
//     axis, twice the filter's largest standard deviation, is at most a third of a kernel radius, and 2 % up to a whole
//     radius; at the worst point, these errors are 2 and 3 %. The gradient's error is at most 0.06 of the deviation of
//     the plain gradient, and 0.12 at the worst point. For larger pixels, only the variance is right. The result
//     is continuous in p, dx and dy. The cost on GPUs, relative to gabor_noise, is 1.4 for pixels up to 0.18 kernel
//     radii (9 nodes), 3.1 from 0.2 (16 nodes), 3.4 from 0.66 along x or y (20 nodes), and 3.8 from 0.66 along both (25
//     nodes); between 0.18 and 0.2, both of the first two filters run. On CPUs, where drivers run both sides of a
//     branch, the cost is 3 for small pixels and 5 for larger ones.

#ifdef GABOR_SPECTRUM_GLSL
// GaborField gabor_field_isotropic_filtered(GaborPlace place, vec2 dx, vec2 dy, float frequency, uint seed)
//     gabor_field_isotropic, filtered, at about twice its cost. The rms error against exactly filtered noise is 2 % of
//     a standard deviation while the pixel's longest axis is at most 0.3 kernel radii, and 4 % at 0.4; that of the
//     gradient is 0.08 and 0.11 of the plain gradient's, and 0.2 at the worst point. For larger pixels, only the
//     variance is right.

// GaborField gabor_field_lobes_filtered(GaborPlace place, vec2 dx, vec2 dy, GaborLobes lobes, uint seed)
//     gabor_field_lobes, filtered. dx and dy are in units of p.
#endif

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
vec2 gabor_impl_symmetric(vec3 matrix, vec2 v) {
    return matrix.xy * v + matrix.z * v.yx;
}

// The share of a lobe's variance that a filter of covariance S keeps. If we approximate the lobe's power by a
// Gaussian with the variance 1/12 of Hann's window along each axis, and d is the determinant of 1 + 2/3 pi^2 S, this is
//     d^(-1/2) exp(-4 pi^2 F.S (1 + 2/3 pi^2 S)^-1 F),   where S (1 + 2/3 pi^2 S)^-1 = (S + 2/3 pi^2 |S|) / d.
float gabor_impl_transmitted(vec2 wave, vec3 covariance) {
    float area = 6.5797363 * (covariance.x * covariance.y - covariance.z * covariance.z);
    float d = 1.0 + 6.5797363 * (covariance.x + covariance.y + area);
    float exponent = 39.478418 / d * dot(wave, gabor_impl_symmetric(covariance, wave) + area * wave); // 4 pi^2
    return exp(-clamp(exponent, 0.0, 80.0)) * inversesqrt(d);
}

// The covariance of a pixel's filter: xx, yy, xy in kernel radii^2, where nodes are 1 / GABOR_CELLS_PER_RADIUS apart.
struct GaborImplFootprint {
    vec3 covariance;
    vec3 resolved; // the same, limited to standard deviations of 1/2, the most that the windows allow
};

GaborImplFootprint gabor_impl_footprint(vec2 dx, vec2 dy) {
    if (!(dot(dx, dx) + dot(dy, dy) < 1.0e6)) { // too large, or NaN: no wave is left
        dx = vec2(1.0e5, 0.0);
        dy = vec2(0.0, 1.0e5);
    }
    GaborImplFootprint footprint;
    footprint.covariance = 0.25 * vec3(dx * dx + dy * dy, dx.x * dx.y + dy.x * dy.y);

    // The eigenvalues are mean +- apart. Dividing the determinant by the larger gives the smaller more precisely.
    float mean = 0.5 * (footprint.covariance.x + footprint.covariance.y);
    vec2 axis = vec2(0.5 * (footprint.covariance.x - footprint.covariance.y), footprint.covariance.z);
    float apart = length(axis);
    float larger = mean + apart;
    footprint.resolved = footprint.covariance;
    if (larger > 0.25) {
        float side = 0.25 * (dx.x * dy.y - dx.y * dy.x);
        float smaller = min(side / larger * side, 0.25);
        axis *= apart > 0.0 ? 0.5 * (0.25 - smaller) / apart : 0.0;
        footprint.resolved = vec3(max(0.5 * (0.25 + smaller) + vec2(axis.x, -axis.x), 0.0), axis.y);
    }
    return footprint;
}

// Returns a node's filtered window, in the form with three waves, and the window's derivative. The filter multiplies
// the wave q = -1/2, 0 or 1/2 of Hann's window by exp(-2 pi^2 S q^2 - 4 pi^2 (S F) q), where S is its variance along
// the axis. If `even` and `odd` are the even and odd parts of this factor at q = 1/2, the window h becomes
// 1/2 + even (h - 1/2) + i odd h' / pi.
vec4 gabor_impl_filtered_node(float value, float slope, vec2 part, vec2 phase) {
    vec2 wave = vec2(value - 0.5, slope);
    vec2 even = part.x * wave, odd = part.y * vec2(-3.1415927, 0.31830989) * wave; // pi, 1/pi
    return vec4(gabor_impl_product(vec2(0.5 + even.x, odd.y), phase), gabor_impl_product(vec2(even.y, odd.x), phase));
}

// The derivatives of a node from gabor_impl_filtered_node: the second derivative of its window w is -pi^2 (w - 1/2).
vec4 gabor_impl_filtered_derivative(vec4 node, vec2 phase) {
    return vec4(node.zw, -9.8696044 * (node.xy - 0.5 * phase)); // pi^2
}

// Filters an axis with the given S and S F. Windows fade out within half a standard deviation of their ends; the middle
// window never fades.
void gabor_impl_filter(inout GaborImplAxis axis, float variance, float blurred, out GaborImplAxis derivative) {
    float rise = exp(19.739209 * blurred); // 2 pi^2
    vec2 part = 0.5 * exp(-4.934802 * variance) * vec2(rise + 1.0 / rise, rise - 1.0 / rise); // pi^2 / 2
    float width = clamp(0.5 * sqrt(variance), 0.001, 0.05);
    vec2 t = clamp((0.33333333 + 0.66666667 * vec2(-axis.offset, axis.offset)) / width, 0.0, 1.0); // 1/3, 2/3
    vec2 fade = t * t * (3.0 - 2.0 * t);
    vec2 turn = gabor_impl_wave(axis.turns);
    vec2 first = fade.x * turn, last = fade.y * vec2(turn.x, -turn.y);
    vec4 value, slope;
    gabor_impl_windows(axis.offset, value, slope);
    axis.node[0] = gabor_impl_filtered_node(value.x, slope.x, part, first);
    axis.node[1] = gabor_impl_filtered_node(value.y, slope.y, part, vec2(1.0, 0.0));
    axis.node[2] = gabor_impl_filtered_node(value.z, slope.z, part, last);
    derivative = axis;
    derivative.node[0] = gabor_impl_filtered_derivative(axis.node[0], first);
    derivative.node[1] = gabor_impl_filtered_derivative(axis.node[1], vec2(1.0, 0.0));
    derivative.node[2] = gabor_impl_filtered_derivative(axis.node[2], last);
}

// The sum over nodes, with the coupling of the axes: 1 + S_xy d/dx d/dy.
vec2 gabor_impl_coupled_sum(GaborImplAxis columns, GaborImplAxis rows, float coupling, float evolution) {
    vec4 sum, slope;
    gabor_impl_sum(columns, rows, evolution, sum, slope);
    return sum.xy + coupling * slope.zw;
}

// The filtered noise at `place`, with three waves along each axis.
GaborField gabor_impl_filtered_narrow(GaborPlace place, vec2 wave, vec3 s, uint salt) {
    vec2 blurred = gabor_impl_symmetric(s, wave);
    GaborImplAxis columns = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                                            GABOR_CELLS_PER_RADIUS);
    GaborImplAxis rows = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, wave.y,
                                         GABOR_CELLS_PER_RADIUS);
    // 19.739209 is 2 pi^2
    vec2 turn = exp(-19.739209 * dot(wave, blurred))
              * gabor_impl_wave(columns.offset * columns.turns + rows.offset * rows.turns);
    GaborImplAxis columns_slope = columns, rows_slope = rows; // DXC warns of structs that only a call sets
    gabor_impl_filter(columns, s.x, blurred.x, columns_slope);
    gabor_impl_filter(rows, s.y, blurred.y, rows_slope);
    vec2 value = gabor_impl_coupled_sum(columns, rows, s.z, place.evolution);
    vec2 along_x = gabor_impl_coupled_sum(columns_slope, rows, s.z, place.evolution);
    vec2 along_y = gabor_impl_coupled_sum(columns, rows_slope, s.z, place.evolution);
    return gabor_impl_field(vec4(value, along_x), vec4(along_y, 0.0, 0.0), turn, wave, vec2(1.0));
}

// For the form with seven waves: a complex number for each factor of an axis, 1, q - c and (q - c)^2 - 1 / 4g.
struct GaborImplFactors {
    vec3 real;
    vec3 imaginary;
};

// The nodes along an axis and their filtered windows. At a distance of d kernel radii, the window for each factor is
//     even_0 + C (even_1 + C (even_2 + C even_3)) + i S (odd_1 + C (odd_2 + C odd_3)),
// where C and S are the cosine and sine of 2 pi d / 2w.
struct GaborImplFilteredAxis {
    vec3 even_0;
    vec3 even_1;
    vec3 even_2;
    vec3 even_3;
    vec3 odd_1;
    vec3 odd_2;
    vec3 odd_3;
    float reach;  // w, in node spacings
    float offset; // offset of the point from the first node, in node spacings
    int count;    // number of nodes, 4 or 5
    int first;    // index of the first node
    int period;
    uint salt;
    vec2 turn_back; // turn of the wave q = 1 / 2w from one node to the next
    vec2 back;      // the same for the noise's wave
};

// Builds the windows, without their common factor e^(-g c^2), for a filter with a given standard deviation along the
// axis. `m` is r M in the plane and D in 3D.
GaborImplFilteredAxis gabor_impl_filtered_axis(float deviation, float m, float c, int cell, float local, int period,
                                               uint salt, vec2 step) {
    GaborImplFilteredAxis b;
    b.reach = clamp(0.35 + 5.0 * deviation, 2.0, 2.5);
    b.count = b.reach > 2.0 ? 5 : 4;
    float zero = floor(local + (b.count == 5 ? 0.5 : 1.0)) - 2.0;
    b.offset = b.count == 5 ? clamp(local - zero, 1.5, 2.5) : clamp(local - zero, 1.0, 2.0); // see gabor_impl_axis
    b.first = cell + int(zero);
    b.period = period;
    b.salt = salt;
    b.turn_back = gabor_impl_wave(-0.5 / b.reach);
    b.back = vec2(step.x, -step.y);

    float g = 19.739209 * m, unit = 0.75 / b.reach; // 2 pi^2
    // 2.5797363 is 2/3 pi^2 - 4
    float fall = exp((2.5797363 - g) * unit * unit); // e^(-2 pi^2 (m - v) q^2)
    float rise = exp(2.0 * g * c * unit), sink = 1.0 / rise;
    // H(q) / 2w, within 0.00024, at q = 1, 2 and 3 times 1 / 2w. The values are multiplied by 1, 2 and 4, the leading
    // coefficients of the waves' cosines C, 2 C^2 - 1 and 4 C^3 - 3 C and of their sines S, 2 S C and S (4 C^2 - 1).
    float t = b.reach - 2.0;
    // fits: see tools/constants.py
    vec3 wave = vec3(0.25723323, 0.12732396, -0.03693604)
              + t * (vec3(-0.03099653, 0.22852218, 0.10636504) - t * vec3(0.0214304, 0.11618766, -0.1615392));
    float fall_4 = fall * fall * (fall * fall);
    wave *= vec3(fall, fall_4, fall_4 * fall_4 * fall);
    vec3 above = wave * vec3(rise, rise * rise, rise * rise * rise);
    vec3 below = wave * vec3(sink, sink * sink, sink * sink * sink);
    vec3 even = above + below, odd = above - below;
    vec3 q = unit * vec3(1.0, 2.0, 3.0);
    float quarter = 0.25 / g;
    vec3 even_1 = q * odd - c * even, odd_1 = q * even - c * odd; // for the factor q - c
    vec3 even_2 = q * odd_1 - c * even_1 - quarter * even, odd_2 = q * even_1 - c * odd_1 - quarter * odd;
    b.even_2 = vec3(even.y, even_1.y, even_2.y);
    b.even_3 = vec3(even.z, even_1.z, even_2.z);
    b.odd_2 = vec3(odd.y, odd_1.y, odd_2.y);
    b.odd_3 = vec3(odd.z, odd_1.z, odd_2.z);
    b.even_0 = unit * vec3(1.0, -c, c * c - quarter) - 0.5 * b.even_2;
    b.even_1 = vec3(even.x, even_1.x, even_2.x) - 0.75 * b.even_3;
    b.odd_1 = vec3(odd.x, odd_1.x, odd_2.x) - 0.25 * b.odd_3;
    return b;
}

// A column or a row of nodes: its word, and for each factor its window times the noise's wave.
struct GaborImplFilteredLine {
    uint word;
    GaborImplFactors window;
    float fade; // factor of the window
    vec2 turn;  // e^(2 pi i d / 2w)
    vec2 phase; // the same for the noise's wave
};

// The factor by which the windows of line `index` fade over the last quarter of a node spacing.
float gabor_impl_fade(GaborImplFilteredAxis b, int index) {
    float t = clamp(4.0 * (b.reach - abs(b.offset - float(index))), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

// Computes line `index` from its turn and phase.
GaborImplFilteredLine gabor_impl_filtered_line(GaborImplFilteredAxis b, int index, vec2 turn, vec2 phase, float fade) {
    GaborImplFilteredLine line;
    line.word = gabor_impl_line_word(gabor_impl_wrap(b.first + index, b.period), b.salt);
    line.turn = turn;
    line.phase = phase;
    vec3 real = b.even_0 + turn.x * (b.even_1 + turn.x * (b.even_2 + turn.x * b.even_3));
    vec3 imaginary = turn.y * (b.odd_1 + turn.x * (b.odd_2 + turn.x * b.odd_3));
    line.fade = fade;
    line.window = GaborImplFactors(phase.x * real - phase.y * imaginary, phase.x * imaginary + phase.y * real);
    return line;
}

// Computes line `index` from the previous one.
GaborImplFilteredLine gabor_impl_next_line(GaborImplFilteredLine line, GaborImplFilteredAxis b, int index, float fade) {
    return gabor_impl_filtered_line(b, index, gabor_impl_product(line.turn, b.turn_back),
                                    gabor_impl_product(line.phase, b.back), fade);
}

// The line's window with its fade.
GaborImplFactors gabor_impl_faded(GaborImplFilteredLine line) {
    return GaborImplFactors(line.fade * line.window.real, line.fade * line.window.imaginary);
}

// The four or five columns of nodes that reach a point.
struct GaborImplColumns {
    GaborImplFilteredLine column_0;
    GaborImplFilteredLine column_1;
    GaborImplFilteredLine column_2;
    GaborImplFilteredLine column_3;
    GaborImplFilteredLine column_4;
    bool five;
};

GaborImplColumns gabor_impl_columns(GaborImplFilteredAxis b) {
    GaborImplColumns columns;
    vec2 turn = gabor_impl_wave(0.5 / b.reach * b.offset);
    columns.five = b.count == 5;
    columns.column_0 = gabor_impl_filtered_line(b, 0, turn, vec2(1.0, 0.0), gabor_impl_fade(b, 0));
    columns.column_1 = gabor_impl_next_line(columns.column_0, b, 1, 1.0);
    columns.column_2 = gabor_impl_next_line(columns.column_1, b, 2, 1.0);
    columns.column_3 = gabor_impl_next_line(columns.column_2, b, 3, gabor_impl_fade(b, 3));
    columns.column_4 = columns.column_3;
    if (columns.five) columns.column_4 = gabor_impl_next_line(columns.column_3, b, 4, gabor_impl_fade(b, 4));
    return columns;
}

// Line -1, a row or column of nodes, given the phase of the noise's wave there.
GaborImplFilteredLine gabor_impl_line_before(GaborImplFilteredAxis b, vec2 phase) {
    GaborImplFilteredLine line;
    line.turn = gabor_impl_wave(0.5 / b.reach * (b.offset + 1.0));
    line.phase = phase;
    return line;
}

// Returns the sum plus a complex number times the factors.
GaborImplFactors gabor_impl_plus_product(GaborImplFactors sum, GaborImplFactors factors, float real, float imaginary) {
    return GaborImplFactors(sum.real + (real * factors.real - imaginary * factors.imaginary),
                            sum.imaginary + (real * factors.imaginary + imaginary * factors.real));
}

// Adds a node to the sums of a row.
void gabor_impl_add_filtered_node(inout GaborImplFactors row, GaborImplFilteredLine column, uint row_word,
                                  float evolution) {
    vec2 a = column.fade * gabor_impl_amplitude_at(column.word * row_word, evolution);
    row = gabor_impl_plus_product(row, column.window, a.x, a.y);
}

// The sums of a row over its columns.
GaborImplFactors gabor_impl_filtered_row(GaborImplColumns columns, uint row_word, float evolution) {
    GaborImplFactors row = GaborImplFactors(vec3(0.0), vec3(0.0));
    gabor_impl_add_filtered_node(row, columns.column_0, row_word, evolution);
    gabor_impl_add_filtered_node(row, columns.column_1, row_word, evolution);
    gabor_impl_add_filtered_node(row, columns.column_2, row_word, evolution);
    gabor_impl_add_filtered_node(row, columns.column_3, row_word, evolution);
    if (columns.five) gabor_impl_add_filtered_node(row, columns.column_4, row_word, evolution);
    return row;
}

// Drops the first factor and moves the others up by one.
GaborImplFactors gabor_impl_next(GaborImplFactors f) {
    return GaborImplFactors(vec3(f.real.yz, 0.0), vec3(f.imaginary.yz, 0.0));
}

// The weighted sum of the products of two axes' factors.
vec2 gabor_impl_contracted(GaborImplFactors a, GaborImplFactors b, vec3 weights) {
    return vec2(dot(weights, a.real * b.real - a.imaginary * b.imaginary),
                dot(weights, a.real * b.imaginary + a.imaginary * b.real));
}

// The filtered noise at `place`, with seven waves along each axis. If not `wanted`, computes only one row.
GaborField gabor_impl_filtered_wide(GaborPlace place, vec2 wave, vec3 s, bool wanted, uint salt) {
    // 0.13069097 is 1/3 - 2/pi^2
    vec2 m = s.xy + 0.13069097; // v
    vec2 deviation = sqrt(s.xy);
    vec2 blurred = gabor_impl_symmetric(s, wave);
    vec2 c = gabor_impl_symmetric(vec3(m.yx, -s.z), blurred) / (s.z * s.z - m.x * m.y);
    float rho = s.z * inversesqrt(m.x * m.y);
    float r = sqrt(1.0 - rho * rho);
    float lambda = rho / (1.0 + r);
    // 39.478418 is 4 pi^2
    float mixed = 39.478418 * s.z * r / (1.0 + r); // 2 lambda sqrt(g_x g_y)
    vec3 weights = vec3(1.0, -2.0 * mixed, 2.0 * mixed * mixed);
    vec2 step_x = gabor_impl_wave(wave.x / GABOR_CELLS_PER_RADIUS);
    vec2 step_y = gabor_impl_wave(wave.y / GABOR_CELLS_PER_RADIUS);
    GaborImplFilteredAxis across = gabor_impl_filtered_axis(deviation.x, r * m.x, c.x, place.cell.x, place.local.x,
                                                            place.period.x, salt, step_x);
    GaborImplFilteredAxis along = gabor_impl_filtered_axis(deviation.y, r * m.y, c.y, place.cell.y, place.local.y,
                                                           place.period.y, salt ^ GABOR_IMPL_ROWS, step_y);
    GaborImplColumns columns = gabor_impl_columns(across);
    GaborImplFilteredLine line = gabor_impl_line_before(
        along, gabor_impl_wave(dot(wave, vec2(across.offset, along.offset + 1.0)) / GABOR_CELLS_PER_RADIUS));
    int rows = wanted ? along.count : 0; // saves time where a driver runs both sides of a branch
    vec2 value = vec2(0.0), next_x = vec2(0.0), next_y = vec2(0.0);
    int j = 0; // a do-while loop, because some drivers run a while loop's body once more after its test fails
    do {
        line = gabor_impl_next_line(line, along, j, gabor_impl_fade(along, j));
        GaborImplFactors row = gabor_impl_filtered_row(columns, line.word, place.evolution);
        GaborImplFactors window = gabor_impl_faded(line);
        value += gabor_impl_contracted(row, window, weights);
        next_x += gabor_impl_contracted(gabor_impl_next(row), window, weights);
        next_y += gabor_impl_contracted(row, gabor_impl_next(window), weights);
    } while (++j < rows);
    float exponent = 19.739209 * (dot(wave + c, blurred) + r * dot(m, c * c)); // 2 pi^2
    // The derivative of a wave is 2 pi i (F + q) times the wave. For the factors f_0, f_1, f_2 of an axis,
    // (q - c) f_n = f_(n + 1) + n / 4g f_(n - 1); f_3 is left out.
    vec2 mean = wave + c, before = lambda * sqrt(m.yx / m);
    vec2 x = 6.2831853 * (mean.x * value + next_x - before.x * next_y);
    vec2 y = 6.2831853 * (mean.y * value + next_y - before.y * next_x);
    float scale = sqrt(1.0 - lambda * lambda) * exp(-exponent) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return GaborField(scale * value.y, scale * vec2(x.x, y.x), scale * value.x, -scale * vec2(x.y, y.y), 0.0);
}

// The share of the form with seven waves in the filtered noise; the rest is the form with three.
float gabor_impl_wide_share(GaborImplFootprint footprint) {
    return clamp(100.0 * sqrt(max(footprint.resolved.x, footprint.resolved.y)) - 9.0, 0.0, 1.0);
}

// Nodes are `stretch` / GABOR_CELLS_PER_RADIUS kernel radii apart.
GaborField gabor_impl_filtered(GaborPlace place, GaborImplFootprint footprint, float wide, vec2 wave, uint seed) {
    vec2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    wave = clamp(wave, -1.0e6, 1.0e6) / stretch;
    float transmitted = gabor_impl_transmitted(wave, footprint.covariance);
    GaborField sum = GaborField(0.0, vec2(0.0), 0.0, vec2(0.0), 0.0);
    if (transmitted >= 1.0e-10) {
        vec3 s = footprint.resolved;
        uint salt = gabor_impl_salt(seed);
        float amplitude = 1.0;
        if (distance(footprint.resolved, footprint.covariance) > 0.0)
            amplitude *= sqrt(transmitted / gabor_impl_transmitted(wave, s));
        if (wide < 1.0)
            gabor_impl_add_field(sum, gabor_impl_filtered_narrow(place, wave, s, salt), (1.0 - wide) * amplitude,
                                 stretch);
        if (wide > 0.0)
            gabor_impl_add_field(sum, gabor_impl_filtered_wide(place, wave, s, wide > 0.0, salt), wide * amplitude,
                                 stretch);
    }
    sum.removed = 1.0 - transmitted;
    return sum;
}

GaborField gabor_field_filtered(GaborPlace place, vec2 dx, vec2 dy, vec2 wave, uint seed) {
    vec2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    GaborImplFootprint footprint = gabor_impl_footprint(stretch * dx, stretch * dy);
    return gabor_impl_filtered(place, footprint, gabor_impl_wide_share(footprint), wave, seed);
}

vec2 gabor_noise_filtered(vec2 p, vec2 dx, vec2 dy, float frequency, float orientation, uint seed) {
    GaborField field = gabor_field_filtered(gabor_place_at(p), dx, dy, gabor_wave_vector(frequency, orientation), seed);
    return vec2(field.noise, field.removed);
}

// Approximates exp(-q/2) I_0(q/2), the mean of exp(-q cos^2) over angles, by the square root of a rational function.
float gabor_impl_mean_angle(float q) {
    // fit: see tools/constants.py
    return sqrt((1.0 + q * (0.19075951 + 0.0865599 * q))
                / (1.0 + q * (1.1907595 + q * (0.60787136 + 0.27193595 * q))));
}

#ifdef GABOR_SPECTRUM_GLSL

GaborField gabor_field_lobes_filtered(GaborPlace place, vec2 dx, vec2 dy, GaborLobes lobes, uint seed) {
    GaborField sum = GaborField(0.0, vec2(0.0), 0.0, vec2(0.0), 0.0);
    float power = gabor_impl_lobes_power(lobes);
    for (int i = 0; i < min(lobes.count, GABOR_LOBES); ++i) {
        GaborLobe lobe = lobes.lobe[i];
        vec2 unit = 1.0 / lobe.radius;
        GaborField field = gabor_field_filtered(gabor_impl_stretched(place, lobe.radius), unit * dx, unit * dy,
                                                gabor_impl_lobe_wave(lobe), gabor_derived_seed(seed, i));
        gabor_impl_add_field(sum, field, power > 0.0 ? sqrt(lobe.power / power) : 0.0, unit);
    }
    return sum;
}

// ---- Isotropic noise -----------------------------------------------------------------------------------------------

// The share of isotropic noise's variance that a filter keeps: the mean of gabor_impl_transmitted over all directions.
float gabor_impl_transmitted_isotropic_2d(float frequency, vec3 covariance) {
    float area = 6.5797363 * (covariance.x * covariance.y - covariance.z * covariance.z); // 2/3 pi^2
    float d = 1.0 + 6.5797363 * (covariance.x + covariance.y + area);
    float unit = 39.478418 / d * min(frequency * frequency, 1.0e12); // 4 pi^2
    float apart = length(vec2(covariance.x - covariance.y, 2.0 * covariance.z));
    float smaller = area + max(0.5 * (covariance.x + covariance.y - apart), 0.0);
    return exp(-clamp(unit * smaller, 0.0, 80.0)) * gabor_impl_mean_angle(min(unit * apart, 1.0e8)) * inversesqrt(d);
}

// A node's filtered window along both axes: its value is middle + cosine, its derivative sine.
struct GaborImplWindows {
    vec2 middle;
    vec2 cosine;
    vec2 sine;
};

// Adds a node's wave, filtered with covariance s. `a` is its amplitude times the wave at the point. The filter
// multiplies it by exp(-2 pi^2 F.S F) and shifts its window along each axis by i x / pi, x = 2 pi^2 S F: see
// gabor_impl_filtered_node.
void gabor_impl_add_filtered_wave(inout GaborField sum, GaborImplWindows node, vec3 s, vec2 a, vec2 wave) {
    vec2 x = 19.739209 * gabor_impl_symmetric(s, wave);
    a *= exp(-max(dot(wave, x), 0.0));
    x = clamp(x, -3.0, 3.0); // changes no wave that the filter keeps
    vec2 y = x * x;
    // 0.041666667 is 1/24, 0.16666667 is 1/6 and 0.0083333333 is 1/120
    vec2 even = 1.0 + y * (0.5 + 0.041666667 * y), odd = x * (1.0 + y * (0.16666667 + 0.0083333333 * y));
    vec2 real = node.middle + even * node.cosine, imaginary = 0.31830989 * odd * node.sine; // 1/pi
    vec2 h_x = vec2(real.x, imaginary.x), h_y = vec2(real.y, imaginary.y);
    vec2 value = gabor_impl_product(gabor_impl_product(h_x, h_y) + vec2(s.z * node.sine.x * node.sine.y, 0.0), a);
    real = even * node.sine;
    imaginary = -3.1415927 * odd * node.cosine; // pi
    vec2 along_x = gabor_impl_product(gabor_impl_product(vec2(real.x, imaginary.x), h_y), a);
    vec2 along_y = gabor_impl_product(gabor_impl_product(h_x, vec2(real.y, imaginary.y)), a);
    sum.noise += value.y;
    sum.gradient += vec2(along_x.y, along_y.y) + 6.2831853 * value.x * wave; // 2 pi
    sum.quadrature += value.x;
    sum.quadrature_gradient += vec2(along_x.x, along_y.x) - 6.2831853 * value.y * wave;
}

GaborField gabor_field_isotropic_filtered(GaborPlace place, vec2 dx, vec2 dy, float frequency, uint seed) {
    vec3 s = gabor_impl_footprint(dx, dy).covariance;
    frequency = min(abs(frequency), 1.0e6);
    float kept = gabor_impl_transmitted_isotropic_2d(frequency, s);
    GaborField field = GaborField(0.0, vec2(0.0), 0.0, vec2(0.0), 1.0 - kept);
    if (!(kept > 1.0e-10)) {
        field.removed = 1.0;
        return field;
    }
    // The windows allow a standard deviation of at most 0.2.
    s *= 0.04 / max(0.5 * (s.x + s.y + length(vec2(s.x - s.y, 2.0 * s.z))), 0.04);
    float narrower = gabor_impl_transmitted_isotropic_2d(frequency, s); // at least `kept`, but for rounding
    float amplitude = GABOR_IMPL_STAR * sqrt(min(kept / max(narrower, 1.0e-30), 1.0));
    vec2 stretch = place.cells_per_radius / GABOR_CELLS_PER_RADIUS;
    vec2 unit = frequency / stretch;
    // From here on, nodes are 1 / GABOR_CELLS_PER_RADIUS apart.
    s *= vec3(stretch * stretch, stretch.x * stretch.y);
    vec2 fall = exp(-4.934802 * s.xy), width = clamp(0.5 * sqrt(s.xy), 0.001, 0.05); // pi^2 / 2
    uint salt = gabor_impl_salt(seed);
    GaborImplAxis x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, 0.0, GABOR_CELLS_PER_RADIUS);
    GaborImplAxis y =
        gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt ^ GABOR_IMPL_ROWS, 0.0,
                        GABOR_CELLS_PER_RADIUS);
    GaborField sum = GaborField(0.0, vec2(0.0), 0.0, vec2(0.0), 0.0);
    for (int j = 0; j < 3; ++j) {
        uvec4 row = gabor_impl_row(y.word[j]);
        for (int i = 0; i < 3; ++i) {
            vec2 d = vec2(x.offset - float(i - 1), y.offset - float(j - 1)) / GABOR_CELLS_PER_RADIUS;
            GaborImplStar star = gabor_impl_star(x.word[i] * row, unit * d, place.evolution);
            vec2 t = clamp((1.0 - abs(d)) / width, 0.0, 1.0), fade = t * t * (3.0 - 2.0 * t);
            vec2 cosine = fall * (vec2(x.node[i].x, y.node[j].x) - 0.5);
            GaborImplWindows node =
                GaborImplWindows(0.5 * fade, fade * cosine, fade * fall * vec2(x.node[i].z, y.node[j].z));
            gabor_impl_add_filtered_wave(sum, node, s, star.first, unit * star.u);
            gabor_impl_add_filtered_wave(sum, node, s, star.second, unit * star.v);
            gabor_impl_add_filtered_wave(sum, node, s, star.third, unit * (star.v - star.u));
        }
    }
    gabor_impl_add_field(field, sum, amplitude, stretch);
    return field;
}
#endif

#endif

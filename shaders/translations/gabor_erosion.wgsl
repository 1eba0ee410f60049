// Generated from gabor_erosion.glsl by tools/translate, for WGSL: change that file, not this one.
// Paste it after gabor_noise.wgsl.
//
// gabor_erosion.wgsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
//     let hills = gabor_terrain(p, 7u);                          // or your own height, slope and curvature
//     let rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//     let cover = gabor_ground_cover(rocks);                             // shares of grass, scree, rock and snow
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// A height in units of p, and what erosion needs to know about it. Members that nobody reads cost nothing.
struct GaborTerrain {
    height: f32,
    slope: vec2f,       // the derivatives of the height along x and y
    ridge: f32,         // from -1 in creases and valleys to 1 on ridges and peaks
    curvature: vec3f,   // the second derivatives of the height: xx, xy and yy
    ridge_slope: vec2f, // the derivatives of ridge
}

struct GaborErosion {
    octaves: i32,         // octaves of gullies, 0 to 16, usually 0 to 10: each costs two gabor_noise_gradient
    gully_frequency: f32, // gullies per unit of p in the first octave, 0.001 to 10000, usually 0.1 to 10
    strength: f32,        // how far peaks and valleys move, times the gullies' frequency, 0 to 10, usually 0 to 0.5
    lacunarity: f32,      // frequency of an octave relative to the previous one, 1 to 8, usually 1 to 4
    gain: f32,            // depth of an octave relative to the previous one, 0 to 2, usually 0 to 1: 1 / lacunarity
                          // for equal slopes
    onset_slope: f32,     // slope at which gullies reach their full depth, 0.000001 to 100, usually 0.01 to 4: twice
                          // the rms slope of a map leaves its valleys open
    detail: f32,          // how far fine gullies enter creases, ridges and flat areas, 0.1 to 100, usually 0.1 to 10
    uniformity: f32,      // how uniform the depths of gullies are, 0 to 100, usually 0 to 8: 1 for natural variety, 4
                          // for even stripes
    ridge_rounding: f32,  // width of rounded ridges in radians of the first octave, 0 to 10, usually 0 to 2
    crease_rounding: f32, // width of rounded creases in radians of the first octave, 0 to 10, usually 0 to 2
    gully_weight: f32,    // depth of gullies, as a share of how far peaks and valleys move, 0 to 1
    branching: f32,       // how much of a gully's slope turns finer gullies, 0 to 10, usually 0 to 2: 1 for all of it
}

// fn gabor_erosion() -> GaborErosion
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// fn gabor_terrain(p: vec2f, seed: u32) -> GaborTerrain
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.637 and continuous curvature. The variance
//     of the height differs by up to 17 % between the positions in a square unit.

// fn gabor_eroded(p: vec2f, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain
//     Adds gullies and ridges to the base at p. A base whose ridge is 1 where it is flat gets pointed peaks there.
//     Elsewhere, flat ground stays as it is. The height is continuous where the base and its slope are. The returned
//     slope is the derivative of the height, if the base has its curvature and the derivatives of its ridge; with zeros
//     instead, its rms error is 0.45 times the rms slope. The returned curvature and ridge_slope are 0: to erode the
//     result again, draw it as a heightmap first, which has its curvature in nine texels.

// fn gabor_ground_cover(terrain: GaborTerrain) -> vec4f
//     The shares of grass, scree, rock and snow, whose sum is 1: snow where it is high, rock where it is steep,
//     elsewhere scree where it is fairly high, and grass below. Ridges count as a little higher. Heights are about from
//     -1 to 1, as those of gabor_terrain.

struct GaborTerrainPlace { // the position cell + local: GaborTerrainPlace(vec2i(0), p, vec2f(0.0)) for a point
    cell: vec2i,   // any integers: the world wraps around after 2^32 cells along each axis
    local: vec2f,  // most precise in [0, 1)^2
    period: vec2f, // exact, along x and y: at least 4, or 0 for none. Integers do not change the width of the hills
}

// fn gabor_terrain_at(ground: GaborTerrainPlace, dx: vec2f, dy: vec2f, seed: u32) -> GaborTerrain
// fn gabor_eroded_at(ground: GaborTerrainPlace, dx: vec2f, dy: vec2f, base: GaborTerrain, GaborErosion erosion, -> GaborTerrain
//                              u32 seed)
//     The same with a period, a filter, or both. The filter leaves out features that are too fine for a pixel and keeps
//     the mean height: dx and dy are dpdx(p) and dpdy(p), or vec2f(0.0) for no filter, and slopes are derivatives for a
//     pixel of that size. Without a period, the result is precise at any distance from the origin; with one, cell +
//     local is rounded to an f32. The nodes per unit of p are a multiple of 1 / 65536, so a mountain that is twice as
//     large and has half the frequency looks the same only near the origin: within 3e-4 of its height up to 10 units
//     away, and 3e-3 up to 100.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `cells_per_radius` is in nodes
// per unit of p, so that wave vectors and derivatives are per unit of p.
fn gabor_impl_ground(ground: GaborTerrainPlace, nodes: f32) -> GaborPlace {
    let rounded = u32(clamp(nodes, 1.0e-4, 3.0e4) * 65536.0 + 0.5);
    var place = gabor_place(vec2i(0), vec2f(0.0));
    place.cells_per_radius = vec2f(f32(rounded) / 65536.0);
    let low = (vec2u(ground.cell) & vec2u(0xffffu)) * (rounded & 0xffffu);
    let high = vec2u(ground.cell) * (rounded >> 16u) + vec2u(ground.cell >> vec2u(vec2i(16))) * (rounded & 0xffffu);
    place.cell = vec2i(high + (low >> vec2u(16u)));
    place.local = vec2f(low & vec2u(0xffffu)) / 65536.0 + ground.local * place.cells_per_radius;
    if (ground.period.x <= 0.0 && ground.period.y <= 0.0) { return place; }
    place.period = vec2i(max(floor(ground.period * place.cells_per_radius + 0.5), vec2f(4.0)));
    if (ground.period.x > 0.0) { place.cells_per_radius.x = f32(place.period.x) / ground.period.x; }
    else { place.period.x = 0; }
    if (ground.period.y > 0.0) { place.cells_per_radius.y = f32(place.period.y) / ground.period.y; }
    else { place.period.y = 0; }
    place.cell = vec2i(0);
    place.local = (vec2f(ground.cell) + ground.local) * place.cells_per_radius;
    return place;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
fn gabor_impl_splines(t: f32, value: ptr<function, vec4f>, slope: ptr<function, vec4f>,
                      curvature: ptr<function, vec4f>) {
    let u = 1.0 - t;
    *value = vec4f(u * u * u, 4.0 - 3.0 * t * t * (1.0 + u), 4.0 - 3.0 * u * u * (1.0 + t), t * t * t) / 6.0;
    *slope = 0.5 * vec4f(-u * u, t * (3.0 * t - 4.0), u * (4.0 - 3.0 * u), t * t);
    *curvature = vec4f(u, 3.0 * t - 2.0, 3.0 * u - 2.0, t);
}

// Two noises and their derivatives.
struct GaborImplHills {
    value: vec2f,
    slope_x: vec2f,
    slope_y: vec2f,
    curvature_xx: vec2f,
    curvature_xy: vec2f,
    curvature_yy: vec2f,
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises. y holds the row's spline and its
// derivatives.
fn gabor_impl_add_hill_row(sum: ptr<function, GaborImplHills>, words: vec4u, x: vec4f, slope_x: vec4f,
                           curvature_x: vec4f, y: vec3f) {
    let a = vec4f(vec4i(words)); let b = vec4f(vec4i(words << vec4u(16u)));
    let row = vec2f(dot(x, a), dot(x, b)); let along_x = vec2f(dot(slope_x, a), dot(slope_x, b));
    (*sum).value += y.x * row;
    (*sum).slope_x += y.x * along_x;
    (*sum).slope_y += y.y * row;
    (*sum).curvature_xx += y.x * vec2f(dot(curvature_x, a), dot(curvature_x, b));
    (*sum).curvature_xy += y.y * along_x;
    (*sum).curvature_yy += y.z * row;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
fn gabor_terrain_at(ground: GaborTerrainPlace, dx: vec2f, dy: vec2f, seed: u32) -> GaborTerrain {
    let place = gabor_impl_ground(ground, 1.0);
    let zero = floor(place.local);
    var x: vec4f; var y: vec4f; var slope_x: vec4f; var slope_y: vec4f; var curvature_x: vec4f; var curvature_y: vec4f;
    gabor_impl_splines(place.local.x - zero.x, &x, &slope_x, &curvature_x);
    gabor_impl_splines(place.local.y - zero.y, &y, &slope_y, &curvature_y);
    let salt = gabor_impl_salt(seed);
    let columns = gabor_impl_four_line_words(place.cell.x + i32(zero.x), place.period.x, salt);
    let rows = gabor_impl_four_line_words(place.cell.y + i32(zero.y), place.period.y, salt ^ GABOR_IMPL_ROWS);
    var hills = GaborImplHills(vec2f(0.0), vec2f(0.0), vec2f(0.0), vec2f(0.0), vec2f(0.0), vec2f(0.0));
    gabor_impl_add_hill_row(&hills, columns * rows.x, x, slope_x, curvature_x, vec3f(y.x, slope_y.x, curvature_y.x));
    gabor_impl_add_hill_row(&hills, columns * rows.y, x, slope_x, curvature_x, vec3f(y.y, slope_y.y, curvature_y.y));
    gabor_impl_add_hill_row(&hills, columns * rows.z, x, slope_x, curvature_x, vec3f(y.z, slope_y.z, curvature_y.z));
    gabor_impl_add_hill_row(&hills, columns * rows.w, x, slope_x, curvature_x, vec3f(y.w, slope_y.w, curvature_y.w));
    let s = clamp(vec4f(dx, dy), vec4f(-1.0e9), vec4f(1.0e9));
    let area = s.x * s.w - s.y * s.z;
    // 0.34768212 is (2/3) / (151/315) / 4 and 0.12088286 is ((2/3) / (151/315) / 4)^2
    let kept = inverseSqrt(1.0 + 0.34768212 * dot(s, s) + 0.12088286 * area * area);
    let unit = 1.6825360e-9 * kept; // 315 / 151 sqrt(3) / 2^31: variance 1
    // 3.1582734 is (0.8 pi)^2 / 2
    let noise = unit * hills.value; let wave = exp(3.1582734 * (kept * kept - 1.0)) * gabor_impl_wave(0.4 * noise.y);
    let rough = 0.3 + 0.12 * noise.x; let height = noise.x + rough * wave.y;
    // The height of noises a and b is 0.33 (a + (0.3 + 0.12 a) sin(2 pi 0.4 b)). Its derivatives by a and b;
    // by ab and bb:
    let first = 0.33 * unit * vec2f(1.0 + 0.12 * wave.y, 2.5132741 * rough * wave.x); // 0.8 pi
    // 0.30159289 is 0.12 * 0.8 pi and 6.3165468 is (0.8 pi)^2
    let second = 0.33 * unit * unit * vec2f(0.30159289 * wave.x, -6.3165468 * rough * wave.y);
    let along_x = hills.slope_x; let along_y = hills.slope_y;
    let slope = place.cells_per_radius * vec2f(dot(first, along_x), dot(first, along_y));
    var curvature = vec3f(dot(first, hills.curvature_xx) + along_x.y * (2.0 * second.x * along_x.x + second.y * along_x.y),
                            dot(first, hills.curvature_xy) + second.x * (along_x.x * along_y.y + along_x.y * along_y.x)
                                + second.y * along_x.y * along_y.y,
                            dot(first, hills.curvature_yy) + along_y.y * (2.0 * second.x * along_y.x + second.y * along_y.y));
    curvature *= vec3f(place.cells_per_radius * place.cells_per_radius.x,
                       place.cells_per_radius.y * place.cells_per_radius.y);
    let to_ridge = inverseSqrt(1.0 + height * height);
    return GaborTerrain(0.33 * height, slope, height * to_ridge, curvature,
                        to_ridge * to_ridge * to_ridge / 0.33 * slope);
}

// The complex noise (quadrature, noise), its derivatives along x and y, and its derivative as the wave vector moves in
// a direction.
struct GaborImplBentField {
    value: vec2f,
    along_x: vec2f,
    along_y: vec2f,
    bent: vec2f,
}

// Adds row j of nodes to the sums of gabor_impl_sum, and to `places`, weighted by the nodes' places along x and y.
fn gabor_impl_add_bent_row(sum: ptr<function, vec4f>, along_y: ptr<function, vec2f>, places: ptr<function, vec4f>,
                           x: GaborImplAxis, y_in: GaborImplAxis, j: i32) {
    var y = y_in;
    var before = vec4f(0.0); var row = vec4f(0.0); var after = vec4f(0.0);
    gabor_impl_add_products(&before, x.node[0], gabor_impl_amplitude(x.word[0] * y.word[j]));
    gabor_impl_add_products(&row, x.node[1], gabor_impl_amplitude(x.word[1] * y.word[j]));
    if (GABOR_TAPS > 2) { gabor_impl_add_products(&after, x.node[2], gabor_impl_amplitude(x.word[2] * y.word[j])); }
    var moved = after.xy - before.xy;
    row += before + after;
    if (GABOR_TAPS > 3) {
        after = vec4f(0.0);
        gabor_impl_add_products(&after, x.node[3], gabor_impl_amplitude(x.word[3] * y.word[j]));
        moved += 2.0 * after.xy;
        row += after;
    }
    var here = vec4f(0.0);
    gabor_impl_add_products(&here, row, y.node[j].xy);
    *sum += here;
    *along_y += gabor_impl_product(row.xy, y.node[j].zw);
    *places += vec4f(gabor_impl_product(moved, y.node[j].xy), f32(j - 1) * here.xy);
}

// gabor_field with the derivative of a wave's phase by its wave vector: 2 pi times the offset from the wave's node.
fn gabor_impl_bent_field(place: GaborPlace, wave: vec2f, direction_in: vec2f, seed: u32) -> GaborImplBentField {
    var direction = direction_in;
    var salt = gabor_impl_salt(seed);
    let x = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, salt, wave.x,
                            place.cells_per_radius.x);
    salt ^= GABOR_IMPL_ROWS;
    let y = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, salt, wave.y,
                            place.cells_per_radius.y);
    var sum = vec4f(0.0); var places = vec4f(0.0);
    var along_y = vec2f(0.0);
    gabor_impl_add_bent_row(&sum, &along_y, &places, x, y, 0);
    gabor_impl_add_bent_row(&sum, &along_y, &places, x, y, 1);
    if (GABOR_TAPS > 2) { gabor_impl_add_bent_row(&sum, &along_y, &places, x, y, 2); }
    if (GABOR_TAPS > 3) { gabor_impl_add_bent_row(&sum, &along_y, &places, x, y, 3); }
    let turn = gabor_impl_wave(x.offset * x.turns + y.offset * y.turns);
    let field = gabor_impl_field(sum, vec4f(along_y, 0.0, 0.0), turn, wave,
                                 place.cells_per_radius / GABOR_CELLS_PER_RADIUS);
    let value = vec2f(field.quadrature, field.noise);
    direction *= 6.2831853 / place.cells_per_radius;
    let nodes = direction.x * places.xy + direction.y * places.zw;
    let bent = dot(direction, vec2f(x.offset, y.offset)) * value
              - gabor_impl_product(nodes, turn) / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY);
    return GaborImplBentField(value, vec2f(field.quadrature_gradient.x, field.gradient.x),
                              vec2f(field.quadrature_gradient.y, field.gradient.y), vec2f(-bent.y, bent.x));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded; and its derivatives by t
// and by the rounding.
fn gabor_impl_mask(t: f32, rounding: f32) -> vec3f {
    let part = select(1.0, t / rounding, t < rounding); // how far t is into the rounded start
    let s = max(1.0 - part * (t - 0.5 * part * rounding), 0.0); let slope = s * part;
    return vec3f(1.0 - s * s, 2.0 * slope, -slope * part);
}

// Where the mask m of an octave is below 1, its gullies, of weight w, fade into those of the previous octave:
//     t_i = (1 - m_i) t_(i-1) + m_i w cos(phase_i),   height = base + open sum_i depth_i t_i.
// m_i is 0 where the slope that its gullies follow is 0, and m_(i+1) is 0 where sin(phase_i) is 0: finer gullies end on
// ridges and in creases. To turn finer gullies, each side of a gully adds a constant to the slope that they follow. The
// constant differs between the two sides, but the sides meet where the mask of the finer gullies is 0. If an octave is
// too fine for the pixel, its cosine is replaced by its mean, 0, and the next mask uses the mean of |sin(phase)|.
// `open` is the first mask, and 1 on peaks: it leaves flat valleys as they are, because there gullies would dam them.
// For the exact slope, each quantity is differentiated along x and y: names end in _x and _y, or are vec2f(by x, by y).
// A wave vector keeps its length as it turns, so it changes along the slope that its gullies follow.
fn gabor_eroded_at(ground: GaborTerrainPlace, dx: vec2f, dy: vec2f, base: GaborTerrain, erosion: GaborErosion,
                   seed: u32) -> GaborTerrain {
    var steer = base.slope; var steer_x = base.curvature.xy; var steer_y = base.curvature.yz;
    var gully = base.ridge; var ridge = base.ridge; var sum = 0.0; // t_i, t_i with w = 1, sum_i depth_i t_i
    var gully_slope = base.ridge_slope; var sum_slope = vec2f(0.0);
    var frequency = erosion.gully_frequency; var depth = erosion.strength / erosion.gully_frequency;
    var mask = 1.0; var open = 1.0;
    var rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * base.ridge);
    var mask_slope = vec2f(0.0); var open_slope = vec2f(0.0);
    let rounded = 0.5 * (erosion.ridge_rounding - erosion.crease_rounding); let peak = clamp(base.ridge, 0.0, 1.0);
    var rounding_slope = rounded * base.ridge_slope;
    let per_onset = 1.0 / max(erosion.onset_slope, 1.0e-6);
    for (var i = 0; i < erosion.octaves; i++) {
        let steep = max(length(steer), 1.0e-9);
        let down = steer / steep; let across = vec2f(-down.y, down.x);
        let full = gabor_impl_mask(steep * per_onset, rounding);
        let full_slope = full.y * per_onset * vec2f(dot(down, steer_x), dot(down, steer_y)) + full.z * rounding_slope;
        mask_slope = full.x * (full.x * mask_slope + 2.0 * mask * full_slope);
        mask *= full.x * full.x;
        if (i == 0) {
            open = mix(mask, 1.0, peak * peak);
            open_slope = (1.0 - peak * peak) * mask_slope + (1.0 - mask) * 2.0 * peak * base.ridge_slope;
        }
        let wave = frequency * across;
        // The wave changes by -down * bend.
        let bend = frequency / steep * vec2f(dot(across, steer_x), dot(across, steer_y));
        let steps = vec2f(dot(wave, dx), dot(wave, dy));
        // The share of a wave that a Gaussian filter of standard deviation half a pixel keeps; small shares are 0.
        let share = 1.02 * exp(-4.9348022 * dot(steps, steps)); let kept = max(share - 0.02, 0.0); // pi^2 / 2
        var z = vec2f(0.0); var z_x = vec2f(0.0); var z_y = vec2f(0.0); var kept_slope = vec2f(0.0);
        if (kept > 0.0) {
            // 1.25 gullies per radius.
            let place = gabor_impl_ground(ground, 0.8 * GABOR_CELLS_PER_RADIUS * frequency);
            let field = gabor_impl_bent_field(place, wave, down, gabor_derived_seed(seed, i));
            z = erosion.uniformity * field.value;
            let shrink = inverseSqrt(1.0 + dot(z, z)); // brings the length of z near 1, except where waves cancel
            z *= shrink;
            z_x = shrink * erosion.uniformity * (field.along_x - bend.x * field.bent);
            z_y = shrink * erosion.uniformity * (field.along_y - bend.y * field.bent);
            kept_slope = 9.8696044 * share * dot(steps, vec2f(dot(down, dx), dot(down, dy))) * bend; // pi^2
            z_x = kept * (z_x - dot(z, z_x) * z) + kept_slope.x * z;
            z_y = kept * (z_y - dot(z, z_y) * z) + kept_slope.y * z;
            z *= kept;
        }
        let crest = erosion.gully_weight * z.x;
        gully_slope = mix(gully_slope, erosion.gully_weight * vec2f(z_x.x, z_y.x), mask) + (crest - gully) * mask_slope;
        gully = mix(gully, crest, mask);
        ridge = mix(ridge, z.x, mask);
        sum += depth * gully;
        sum_slope += depth * gully_slope;
        let side = select(1.0, -1.0, z.y < 0.0);
        let turns = 6.2831853 * depth * erosion.branching * erosion.gully_weight * side; // 2 pi
        let turn = turns * kept * mask;
        let turn_slope = turns * (kept * mask_slope + mask * kept_slope);
        steer -= turn * wave;
        steer_x += turn * bend.x * down - turn_slope.x * wave;
        steer_y += turn * bend.y * down - turn_slope.y * wave;
        let wide = frequency / erosion.gully_frequency;
        rounding = mix(erosion.crease_rounding, erosion.ridge_rounding, 0.5 + 0.5 * z.x);
        rounding_slope = rounded * vec2f(z_x.x, z_y.x);
        let edge = gabor_impl_mask(0.5 - 0.5 * kept + abs(z.y), wide * rounding);
        let edge_slope = edge.y * side * vec2f(z_x.y, z_y.y) - 0.5 * edge.y * kept_slope + edge.z * wide * rounding_slope;
        let reach = 1.0 / (1.0 + mask * (erosion.detail - 1.0));
        mask_slope = erosion.detail * reach * (reach * edge.x * mask_slope + mask * edge_slope);
        mask *= erosion.detail * reach * edge.x;
        frequency *= erosion.lacunarity;
        depth *= erosion.gain;
    }
    return GaborTerrain(base.height + open * sum, base.slope + open * sum_slope + sum * open_slope, ridge, vec3f(0.0),
                        vec2f(0.0));
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_erosion() -> GaborErosion {
    return GaborErosion(5, 1.5, 0.12, 2.0, 0.5, 0.5, 1.5, 2.0, 0.1, 0.1, 0.5, 1.0);
}

fn gabor_terrain(p: vec2f, seed: u32) -> GaborTerrain {
    return gabor_terrain_at(GaborTerrainPlace(vec2i(0), p, vec2f(0.0)), vec2f(0.0), vec2f(0.0), seed);
}

fn gabor_eroded(p: vec2f, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    return gabor_eroded_at(GaborTerrainPlace(vec2i(0), p, vec2f(0.0)), vec2f(0.0), vec2f(0.0), base, erosion, seed);
}

fn gabor_ground_cover(terrain: GaborTerrain) -> vec4f {
    let steep = length(terrain.slope);
    let scree = smoothstep(-0.3, 0.35, terrain.height + 0.1 * terrain.ridge); let rock = smoothstep(0.55, 1.0, steep);
    let snow = smoothstep(0.42, 0.62, terrain.height + 0.08 * terrain.ridge) * (1.0 - smoothstep(1.0, 1.9, steep));
    return vec4f((1.0 - snow) * vec3f((1.0 - rock) * vec2f(1.0 - scree, scree), rock), snow);
}

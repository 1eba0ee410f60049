// Generated from gabor_erosion.glsl by tools/translate, for WGSL: change that file, not this one.
// naga 30.0.1 made it from GLSL with the digest 6cc2e36bcf86a120.
// Paste it after gabor_noise.wgsl.
//
// gabor_erosion.wgsl: eroded mountains with branching gullies and ridges, evaluated point by point on any terrain.
//
// Paste or include this file after gabor_noise.wgsl.
//
//     GaborTerrain hills = gabor_terrain(p, 7u);                          // or your own height, slope and curvature
//     GaborTerrain rocks = gabor_eroded(p, hills, gabor_erosion(), 7u);   // height, slope, ridge
//     vec4f cover = gabor_ground_cover(rocks);                             // shares of grass, scree, rock and snow
//
// In each octave, stripes of noise run down the slope, and the cosine of their phase is the height of the gullies. The
// idea comes from runevision's erosion filter (2026), which follows Clay John (2018) and Fewes (2023).
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

// A height in units of p, and what erosion needs to know about it. Members that nobody reads cost nothing.
struct GaborTerrain {
    height: f32,
    slope: vec2<f32>, // the derivatives of the height along x and y
    ridge: f32, // from -1 in creases and valleys to 1 on ridges and peaks
    curvature: vec3<f32>, // the second derivatives of the height: xx, xy and yy
    ridge_slope: vec2<f32>, // the derivatives of ridge
}

struct GaborErosion {
    octaves: i32, // octaves of gullies, 0 to 16, usually 0 to 10: each costs about as much as gabor_noise_gradient
    gully_frequency: f32, // gullies per unit of p in the first octave, 0.001 to 10000, usually 0.1 to 10
    strength: f32, // how far peaks and valleys move, times the gullies' frequency, 0 to 10, usually 0 to 0.5
    lacunarity: f32, // frequency of an octave relative to the previous one, 1 to 8, usually 1 to 4
    gain: f32, // depth of an octave relative to the previous one, 0 to 2, usually 0 to 1: 1 / lacunarity for
    onset_slope: f32, // slope at which gullies reach their full depth, 0.000001 to 100, usually 0.01 to 4: twice
    detail: f32, // how far fine gullies reach into creases, ridges and flat areas, 0.1 to 100, usually 0.1 to 10
    uniformity: f32, // how uniform the depths of gullies are, 0 to 100, usually 0 to 8: 1 for natural variety, 4 for
    ridge_rounding: f32, // width of rounded ridges in radians of the first octave, 0 to 10, usually 0 to 2
    crease_rounding: f32, // width of rounded creases in radians of the first octave, 0 to 10, usually 0 to 2
    gully_weight: f32, // depth of gullies, as a share of how far peaks and valleys move, 0 to 1
    branching: f32, // how much of a gully's slope turns finer gullies, 0 to 10, usually 0 to 2: 1 for all of it
}

// GaborErosion gabor_erosion()
//     Parameters for alpine ridges and valleys on the hills of gabor_terrain.

// GaborTerrain gabor_terrain(vec2f p, u32 seed)
//     Hills to erode: about four units wide, with mean height 0, rms slope 0.637 and continuous curvature. The variance
//     of the height differs by up to 17 % between the positions in a square unit.

// GaborTerrain gabor_eroded(vec2f p, GaborTerrain base, GaborErosion erosion, u32 seed)
//     Adds gullies and ridges to the base at p. A base whose ridge is 1 where it is flat gets pointed peaks there; elsewhere
//     flat ground stays as it is. The height is continuous where the base and its slope are. The returned slope is the
//     derivative of the height, if the base has its curvature and the derivatives of its ridge; with zeros instead, its
//     rms error is 0.45 times the rms slope. The returned curvature and ridge_slope are 0: to erode the result again,
//     draw it as a heightmap first, which has its curvature in nine texels.

// vec4f gabor_ground_cover(GaborTerrain terrain)
//     The shares of grass, scree, rock and snow, whose sum is 1: snow where it is high, rock where it is steep, elsewhere
//     scree where it is fairly high, and grass below. Ridges count as a little higher. Heights are about from -1 to 1, as
//     those of gabor_terrain.

struct GaborTerrainPlace {
    cell: vec2<i32>, // any integers: the world wraps around after 2^32 cells along each axis
    local: vec2<f32>, // most precise in [0, 1)^2
    period: vec2<f32>, // exact, along x and y: at least 4, or 0 for none. Integers do not change the width of the hills
}

// GaborTerrain gabor_terrain_at(GaborTerrainPlace ground, vec2f dx, vec2f dy, u32 seed)
// GaborTerrain gabor_eroded_at(GaborTerrainPlace ground, vec2f dx, vec2f dy, GaborTerrain base, GaborErosion erosion,
//                              u32 seed)
//     The same with a period, a filter, or both. The filter leaves out features that are too fine for a pixel and keeps
//     the mean height: dx and dy are dpdx(p) and dpdy(p), or vec2f(0.0) for no filter, and slopes are derivatives for a
//     pixel of that size. Without a period, the result is precise at any distance from the origin; with one, cell +
//     local is rounded to a f32. The nodes per unit of p are a multiple of 1 / 65536, so a mountain that is twice as
//     large and has half the frequency looks the same only near the origin: within 3e-4 of its height up to 10 units
//     away, and 3e-3 up to 100.

// ====================================================================================================================
// Private implementation
// ====================================================================================================================

// The place on a lattice with about `nodes` nodes per unit of p. This number is rounded to a multiple of 1 / 65536, so
// that its product with the cell splits exactly into integer and fraction. The place's `cells_per_radius` is in nodes
// per unit of p, so that wave vectors and derivatives are per unit of p.
fn gabor_impl_ground(ground: GaborTerrainPlace, nodes: f32) -> GaborPlace {
    var rounded: u32;
    var place_3: GaborPlace;
    var low: vec2<u32>;
    var high: vec2<u32>;
    rounded = u32(((clamp(nodes, 0.0001f, 30000f) * 65536f) + 0.5f));
    let _e15 = gabor_place(vec2(0i), vec2(0f));
    place_3 = _e15;
    let _e18 = rounded;
    place_3.cells_per_radius = vec2((f32(_e18) / 65536f));
    let _e28 = rounded;
    low = ((vec2<u32>(ground.cell) & vec2(65535u)) * (_e28 & 65535u));
    let _e35 = rounded;
    let _e46 = rounded;
    high = ((vec2<u32>(ground.cell) * (_e35 >> 16u)) + (vec2<u32>((ground.cell >> vec2(16u))) * (_e46 & 65535u)));
    let _e53 = high;
    let _e54 = low;
    place_3.cell = vec2<i32>((_e53 + (_e54 >> vec2(16u))));
    let _e61 = low;
    let _e70 = place_3;
    place_3.local = ((vec2<f32>((_e61 & vec2(65535u))) / vec2(65536f)) + (ground.local * _e70.cells_per_radius));
    if ((ground.period.x <= 0f) && (ground.period.y <= 0f)) {
        let _e83 = place_3;
        return _e83;
    }
    let _e86 = place_3;
    place_3.period = vec2<i32>(max(floor(((ground.period * _e86.cells_per_radius) + vec2(0.5f))), vec2(4f)));
    if (ground.period.x > 0f) {
        let _e103 = place_3;
        place_3.cells_per_radius.x = (f32(_e103.period.x) / ground.period.x);
    } else {
        place_3.period.x = 0i;
    }
    if (ground.period.y > 0f) {
        let _e119 = place_3;
        place_3.cells_per_radius.y = (f32(_e119.period.y) / ground.period.y);
    } else {
        place_3.period.y = 0i;
    }
    place_3.cell = vec2(0i);
    let _e137 = place_3;
    place_3.local = ((vec2<f32>(ground.cell) + ground.local) * _e137.cells_per_radius);
    let _e140 = place_3;
    return _e140;
}

// Computes the cubic B-splines of the four nodes around a point, and their derivatives. The point is t in [0, 1) node
// spacings beyond the second node.
fn gabor_impl_splines(t: f32, value: ptr<function, vec4<f32>>, slope: ptr<function, vec4<f32>>, curvature: ptr<function, vec4<f32>>) {
    var u_1: f32;
    u_1 = (1f - t);
    let _e7 = u_1;
    let _e8 = u_1;
    let _e10 = u_1;
    let _e17 = u_1;
    let _e23 = u_1;
    let _e25 = u_1;
    (*value) = (vec4<f32>(((_e7 * _e8) * _e10), (4f - (((3f * t) * t) * (1f + _e17))), (4f - (((3f * _e23) * _e25) * (1f + t))), ((t * t) * t)) / vec4(6f));
    let _e38 = u_1;
    let _e40 = u_1;
    let _e47 = u_1;
    let _e50 = u_1;
    (*slope) = (0.5f * vec4<f32>((-(_e38) * _e40), (t * ((3f * t) - 4f)), (_e47 * (4f - (3f * _e50))), (t * t)));
    let _e57 = u_1;
    let _e63 = u_1;
    (*curvature) = vec4<f32>(_e57, ((3f * t) - 2f), ((3f * _e63) - 2f), t);
    return;
}

fn gabor_impl_four_line_words(index: i32, period: i32, salt: u32) -> vec4<u32> {
    var first_1: i32;
    var second_2: i32;
    var third_2: i32;
    let _e5 = gabor_impl_wrap((index - 1i), period);
    first_1 = _e5;
    let _e7 = first_1;
    let _e8 = gabor_impl_next_node(_e7, period);
    second_2 = _e8;
    let _e10 = second_2;
    let _e11 = gabor_impl_next_node(_e10, period);
    third_2 = _e11;
    let _e13 = first_1;
    let _e14 = gabor_impl_line_word(_e13, salt);
    let _e15 = second_2;
    let _e16 = gabor_impl_line_word(_e15, salt);
    let _e17 = third_2;
    let _e18 = gabor_impl_line_word(_e17, salt);
    let _e19 = third_2;
    let _e20 = gabor_impl_next_node(_e19, period);
    let _e21 = gabor_impl_line_word(_e20, salt);
    return vec4<u32>(_e14, _e16, _e18, _e21);
}

// Two noises and their derivatives.
struct GaborHills {
    value: vec2<f32>,
    slope_x: vec2<f32>,
    slope_y: vec2<f32>,
    curvature_xx: vec2<f32>,
    curvature_xy: vec2<f32>,
    curvature_yy: vec2<f32>,
}

// Adds a row of nodes, with amplitudes uniform between -2^31 and 2^31, to two noises. y holds the row's spline and its
// derivatives.
fn gabor_impl_add_hill_row(sum: ptr<function, GaborHills>, words: vec4<u32>, x: vec4<f32>, slope_x: vec4<f32>, curvature_x: vec4<f32>, y: vec3<f32>) {
    var a_2: vec4<f32>;
    var b_2: vec4<f32>;
    var row_1: vec2<f32>;
    var along_x_1: vec2<f32>;
    a_2 = vec4<f32>(vec4<i32>(words));
    b_2 = vec4<f32>(vec4<i32>((words << vec4(16u))));
    let _e15 = a_2;
    let _e17 = b_2;
    row_1 = vec2<f32>(dot(x, _e15), dot(x, _e17));
    let _e21 = a_2;
    let _e23 = b_2;
    along_x_1 = vec2<f32>(dot(slope_x, _e21), dot(slope_x, _e23));
    let _e28 = (*sum);
    let _e31 = row_1;
    (*sum).value = (_e28.value + (y.x * _e31));
    let _e35 = (*sum);
    let _e38 = along_x_1;
    (*sum).slope_x = (_e35.slope_x + (y.x * _e38));
    let _e42 = (*sum);
    let _e45 = row_1;
    (*sum).slope_y = (_e42.slope_y + (y.y * _e45));
    let _e49 = (*sum);
    let _e52 = a_2;
    let _e54 = b_2;
    (*sum).curvature_xx = (_e49.curvature_xx + (y.x * vec2<f32>(dot(curvature_x, _e52), dot(curvature_x, _e54))));
    let _e60 = (*sum);
    let _e63 = along_x_1;
    (*sum).curvature_xy = (_e60.curvature_xy + (y.y * _e63));
    let _e67 = (*sum);
    let _e70 = row_1;
    (*sum).curvature_yy = (_e67.curvature_yy + (y.z * _e70));
    return;
}

// Wide hills, plus small ones along the contours of a second noise; the higher the wide hills, the higher the small
// ones. The noises are random amplitudes under B-splines, which have a continuous curvature, unlike gabor_noise. Along
// each axis, the squares of the splines sum to 151 / 315 on average, and those of their derivatives to 2 / 3. So a
// filter with a standard deviation of half a pixel multiplies each noise by `kept`, and the variance that it removes
// from the second noise damps the sine.
fn gabor_terrain_at(ground: GaborTerrainPlace, dx: vec2<f32>, dy: vec2<f32>, seed: u32) -> GaborTerrain {
    var place_4: GaborPlace;
    var zero_1: vec2<f32>;
    var x_6: vec4<f32>;
    var y_5: vec4<f32>;
    var slope_x_1: vec4<f32>;
    var slope_y: vec4<f32>;
    var curvature_x_1: vec4<f32>;
    var curvature_y: vec4<f32>;
    var salt_5: u32;
    var columns: vec4<u32>;
    var rows: vec4<u32>;
    var hills: GaborHills = GaborHills(vec2(0f), vec2(0f), vec2(0f), vec2(0f), vec2(0f), vec2(0f));
    var s_2: vec4<f32>;
    var area: f32;
    var kept: f32;
    var unit: f32;
    var noise_1: vec2<f32>;
    var wave_5: vec2<f32>;
    var rough: f32;
    var height: f32;
    var first_2: vec2<f32>;
    var second_3: vec2<f32>;
    var along_x_2: vec2<f32>;
    var along_y_1: vec2<f32>;
    var slope_7: vec2<f32>;
    var curvature_1: vec3<f32>;
    var to_ridge: f32;
    let _e5 = gabor_impl_ground(ground, 1f);
    place_4 = _e5;
    let _e7 = place_4;
    zero_1 = floor(_e7.local);
    let _e17 = place_4;
    let _e20 = zero_1;
    gabor_impl_splines((_e17.local.x - _e20.x), (&x_6), (&slope_x_1), (&curvature_x_1));
    let _e29 = place_4;
    let _e32 = zero_1;
    gabor_impl_splines((_e29.local.y - _e32.y), (&y_5), (&slope_y), (&curvature_y));
    let _e41 = gabor_impl_salt(seed);
    salt_5 = _e41;
    let _e43 = place_4;
    let _e46 = zero_1;
    let _e50 = place_4;
    let _e53 = salt_5;
    let _e54 = gabor_impl_four_line_words((_e43.cell.x + i32(_e46.x)), _e50.period.x, _e53);
    columns = _e54;
    let _e56 = place_4;
    let _e59 = zero_1;
    let _e63 = place_4;
    let _e66 = salt_5;
    let _e69 = gabor_impl_four_line_words((_e56.cell.y + i32(_e59.y)), _e63.period.y, (_e66 ^ 1540483477u));
    rows = _e69;
    let _e86 = columns;
    let _e87 = rows;
    let _e90 = x_6;
    let _e91 = slope_x_1;
    let _e92 = curvature_x_1;
    let _e93 = y_5;
    let _e95 = slope_y;
    let _e97 = curvature_y;
    gabor_impl_add_hill_row((&hills), (_e86 * _e87.x), _e90, _e91, _e92, vec3<f32>(_e93.x, _e95.x, _e97.x));
    let _e102 = columns;
    let _e103 = rows;
    let _e106 = x_6;
    let _e107 = slope_x_1;
    let _e108 = curvature_x_1;
    let _e109 = y_5;
    let _e111 = slope_y;
    let _e113 = curvature_y;
    gabor_impl_add_hill_row((&hills), (_e102 * _e103.y), _e106, _e107, _e108, vec3<f32>(_e109.y, _e111.y, _e113.y));
    let _e118 = columns;
    let _e119 = rows;
    let _e122 = x_6;
    let _e123 = slope_x_1;
    let _e124 = curvature_x_1;
    let _e125 = y_5;
    let _e127 = slope_y;
    let _e129 = curvature_y;
    gabor_impl_add_hill_row((&hills), (_e118 * _e119.z), _e122, _e123, _e124, vec3<f32>(_e125.z, _e127.z, _e129.z));
    let _e134 = columns;
    let _e135 = rows;
    let _e138 = x_6;
    let _e139 = slope_x_1;
    let _e140 = curvature_x_1;
    let _e141 = y_5;
    let _e143 = slope_y;
    let _e145 = curvature_y;
    gabor_impl_add_hill_row((&hills), (_e134 * _e135.w), _e138, _e139, _e140, vec3<f32>(_e141.w, _e143.w, _e145.w));
    s_2 = clamp(vec4<f32>(dx.x, dx.y, dy.x, dy.y), vec4(-1000000000f), vec4(1000000000f));
    let _e161 = s_2;
    let _e163 = s_2;
    let _e166 = s_2;
    let _e168 = s_2;
    area = ((_e161.x * _e163.w) - (_e166.y * _e168.z));
    let _e175 = s_2;
    let _e176 = s_2;
    let _e181 = area;
    let _e183 = area;
    kept = inverseSqrt(((1f + (0.34768212f * dot(_e175, _e176))) + ((0.12088286f * _e181) * _e183)));
    let _e189 = kept;
    unit = (0.000000001682536f * _e189);
    let _e192 = unit;
    let _e193 = hills;
    noise_1 = (_e192 * _e193.value);
    let _e198 = kept;
    let _e199 = kept;
    let _e206 = noise_1;
    let _e209 = gabor_impl_wave((0.4f * _e206.y));
    wave_5 = (exp((3.1582735f * ((_e198 * _e199) - 1f))) * _e209);
    let _e214 = noise_1;
    rough = (0.3f + (0.12f * _e214.x));
    let _e219 = noise_1;
    let _e221 = rough;
    let _e222 = wave_5;
    height = (_e219.x + (_e221 * _e222.y));
    let _e228 = unit;
    let _e232 = wave_5;
    let _e237 = rough;
    let _e239 = wave_5;
    first_2 = ((0.33f * _e228) * vec2<f32>((1f + (0.12f * _e232.y)), ((2.5132742f * _e237) * _e239.x)));
    let _e246 = unit;
    let _e248 = unit;
    let _e251 = wave_5;
    let _e256 = rough;
    let _e258 = wave_5;
    second_3 = (((0.33f * _e246) * _e248) * vec2<f32>((0.3015929f * _e251.x), ((-6.316547f * _e256) * _e258.y)));
    let _e264 = hills;
    along_x_2 = _e264.slope_x;
    let _e267 = hills;
    along_y_1 = _e267.slope_y;
    let _e270 = place_4;
    let _e272 = first_2;
    let _e273 = along_x_2;
    let _e275 = first_2;
    let _e276 = along_y_1;
    slope_7 = (_e270.cells_per_radius * vec2<f32>(dot(_e272, _e273), dot(_e275, _e276)));
    let _e281 = first_2;
    let _e282 = hills;
    let _e285 = along_x_2;
    let _e288 = second_3;
    let _e291 = along_x_2;
    let _e294 = second_3;
    let _e296 = along_x_2;
    let _e302 = first_2;
    let _e303 = hills;
    let _e306 = second_3;
    let _e308 = along_x_2;
    let _e310 = along_y_1;
    let _e313 = along_x_2;
    let _e315 = along_y_1;
    let _e321 = second_3;
    let _e323 = along_x_2;
    let _e326 = along_y_1;
    let _e330 = first_2;
    let _e331 = hills;
    let _e334 = along_y_1;
    let _e337 = second_3;
    let _e340 = along_y_1;
    let _e343 = second_3;
    let _e345 = along_y_1;
    curvature_1 = vec3<f32>((dot(_e281, _e282.curvature_xx) + (_e285.y * (((2f * _e288.x) * _e291.x) + (_e294.y * _e296.y)))), ((dot(_e302, _e303.curvature_xy) + (_e306.x * ((_e308.x * _e310.y) + (_e313.y * _e315.x)))) + ((_e321.y * _e323.y) * _e326.y)), (dot(_e330, _e331.curvature_yy) + (_e334.y * (((2f * _e337.x) * _e340.x) + (_e343.y * _e345.y)))));
    let _e353 = curvature_1;
    let _e354 = place_4;
    let _e356 = place_4;
    let _e359 = (_e354.cells_per_radius * _e356.cells_per_radius.x);
    let _e360 = place_4;
    let _e363 = place_4;
    curvature_1 = (_e353 * vec3<f32>(_e359.x, _e359.y, (_e360.cells_per_radius.y * _e363.cells_per_radius.y)));
    let _e372 = height;
    let _e373 = height;
    to_ridge = inverseSqrt((1f + (_e372 * _e373)));
    let _e379 = height;
    let _e381 = slope_7;
    let _e382 = height;
    let _e383 = to_ridge;
    let _e385 = curvature_1;
    let _e386 = to_ridge;
    let _e387 = to_ridge;
    let _e389 = to_ridge;
    let _e393 = slope_7;
    return GaborTerrain((0.33f * _e379), _e381, (_e382 * _e383), _e385, ((((_e386 * _e387) * _e389) / 0.33f) * _e393));
}

// The complex noise (quadrature, noise), its derivatives along x and y, and its derivative as the wave vector moves in a
// direction.
struct GaborBentField {
    value: vec2<f32>,
    along_x: vec2<f32>,
    along_y: vec2<f32>,
    bent: vec2<f32>,
}

// Adds row j of nodes to the sums of gabor_impl_sum, and to `places`, weighted by the nodes' places along x and y.
fn gabor_impl_add_bent_row(sum: ptr<function, vec4<f32>>, along_y: ptr<function, vec2<f32>>, places: ptr<function, vec4<f32>>, x: GaborAxis, y: GaborAxis, j: i32) {
    var before: vec4<f32> = vec4(0f);
    var row_2: vec4<f32> = vec4(0f);
    var after: vec4<f32> = vec4(0f);
    var moved: vec2<f32>;
    var here: vec4<f32> = vec4(0f);
    let _e25 = gabor_impl_amplitude((x.word[0] * y.word[j]));
    gabor_impl_add_products((&before), x.node[0], _e25);
    let _e37 = gabor_impl_amplitude((x.word[1] * y.word[j]));
    gabor_impl_add_products((&row_2), x.node[1], _e37);
    if true {
        let _e52 = gabor_impl_amplitude((x.word[2] * y.word[j]));
        gabor_impl_add_products((&after), x.node[2], _e52);
    }
    let _e54 = after;
    let _e56 = before;
    moved = (_e54.xy - _e56.xy);
    let _e60 = row_2;
    let _e61 = before;
    let _e62 = after;
    row_2 = (_e60 + (_e61 + _e62));
    if false {
        {
            after = vec4(0f);
            let _e80 = gabor_impl_amplitude((x.word[3] * y.word[j]));
            gabor_impl_add_products((&after), x.node[3], _e80);
            let _e82 = moved;
            let _e84 = after;
            moved = (_e82 + (2f * _e84.xy));
            let _e88 = row_2;
            let _e89 = after;
            row_2 = (_e88 + _e89);
        }
    }
    let _e95 = row_2;
    gabor_impl_add_products((&here), _e95, y.node[j].xy);
    let _e100 = (*sum);
    let _e101 = here;
    (*sum) = (_e100 + _e101);
    let _e103 = (*along_y);
    let _e104 = row_2;
    let _e109 = gabor_impl_product(_e104.xy, y.node[j].zw);
    (*along_y) = (_e103 + _e109);
    let _e111 = (*places);
    let _e112 = moved;
    let _e116 = gabor_impl_product(_e112, y.node[j].xy);
    let _e120 = here;
    let _e122 = (f32((j - 1i)) * _e120.xy);
    (*places) = (_e111 + vec4<f32>(_e116.x, _e116.y, _e122.x, _e122.y));
    return;
}

// gabor_field with the derivative of a wave's phase by its wave vector: 2 pi times the offset from the wave's node.
fn gabor_impl_bent_field(place: GaborPlace, wave: vec2<f32>, direction: vec2<f32>, seed: u32) -> GaborBentField {
    var direction_1: vec2<f32>;
    var salt_6: u32;
    var x_8: GaborAxis;
    var y_7: GaborAxis;
    var sum_7: vec4<f32> = vec4(0f);
    var places_1: vec4<f32> = vec4(0f);
    var along_y_3: vec2<f32> = vec2(0f);
    var turn_6: vec2<f32>;
    var field_4: GaborField;
    var value_5: vec2<f32>;
    var nodes_2: vec2<f32>;
    var local_11: f32;
    var bent: vec2<f32>;
    direction_1 = direction;
    let _e5 = gabor_impl_salt(seed);
    salt_6 = _e5;
    let _e13 = salt_6;
    let _e17 = gabor_impl_axis(place.cell.x, place.local.x, place.period.x, _e13, wave.x, place.cells_per_radius.x);
    x_8 = _e17;
    let _e19 = salt_6;
    salt_6 = (_e19 ^ 1540483477u);
    let _e28 = salt_6;
    let _e32 = gabor_impl_axis(place.cell.y, place.local.y, place.period.y, _e28, wave.y, place.cells_per_radius.y);
    y_7 = _e32;
    let _e46 = x_8;
    let _e47 = y_7;
    gabor_impl_add_bent_row((&sum_7), (&along_y_3), (&places_1), _e46, _e47, 0i);
    let _e55 = x_8;
    let _e56 = y_7;
    gabor_impl_add_bent_row((&sum_7), (&along_y_3), (&places_1), _e55, _e56, 1i);
    if true {
        let _e67 = x_8;
        let _e68 = y_7;
        gabor_impl_add_bent_row((&sum_7), (&along_y_3), (&places_1), _e67, _e68, 2i);
    }
    if false {
        let _e79 = x_8;
        let _e80 = y_7;
        gabor_impl_add_bent_row((&sum_7), (&along_y_3), (&places_1), _e79, _e80, 3i);
    }
    let _e85 = x_8;
    let _e87 = x_8;
    let _e90 = y_7;
    let _e92 = y_7;
    let _e96 = gabor_impl_wave(((_e85.offset * _e87.turns) + (_e90.offset * _e92.turns)));
    turn_6 = _e96;
    let _e98 = sum_7;
    let _e99 = along_y_3;
    let _e105 = turn_6;
    let _e113 = gabor_impl_field(_e98, vec4<f32>(_e99.x, _e99.y, 0f, 0f), _e105, wave, (place.cells_per_radius / vec2(1.5f)));
    field_4 = _e113;
    let _e115 = field_4;
    let _e117 = field_4;
    value_5 = vec2<f32>(_e115.quadrature, _e117.noise);
    let _e121 = direction_1;
    direction_1 = (_e121 * (vec2(6.2831855f) / place.cells_per_radius));
    let _e127 = direction_1;
    let _e129 = places_1;
    let _e132 = direction_1;
    let _e134 = places_1;
    nodes_2 = ((_e127.x * _e129.xy) + (_e132.y * _e134.zw));
    let _e139 = direction_1;
    let _e140 = x_8;
    let _e142 = y_7;
    let _e146 = value_5;
    let _e148 = nodes_2;
    let _e149 = turn_6;
    let _e150 = gabor_impl_product(_e148, _e149);
    if false {
        local_11 = 1f;
    } else {
        local_11 = 1.125f;
    }
    let _e161 = local_11;
    bent = ((dot(_e139, vec2<f32>(_e140.offset, _e142.offset)) * _e146) - (_e150 / vec2((1459955300000000000000000000f * _e161))));
    let _e167 = value_5;
    let _e168 = field_4;
    let _e171 = field_4;
    let _e175 = field_4;
    let _e178 = field_4;
    let _e182 = bent;
    let _e185 = bent;
    return GaborBentField(_e167, vec2<f32>(_e168.quadrature_gradient.x, _e171.gradient.x), vec2<f32>(_e175.quadrature_gradient.y, _e178.gradient.y), vec2<f32>(-(_e182.y), _e185.x));
}

// A mask that rises from 0 and reaches 1 at t = 1, or a little later if its start is rounded; and its derivatives by t and
// by the rounding.
fn gabor_impl_mask(t: f32, rounding: f32) -> vec3<f32> {
    var local_12: f32;
    var part: f32;
    var s_3: f32;
    var slope_8: f32;
    if (t < rounding) {
        local_12 = (t / rounding);
    } else {
        local_12 = 1f;
    }
    let _e6 = local_12;
    part = _e6;
    let _e9 = part;
    let _e11 = part;
    s_3 = max((1f - (_e9 * (t - ((0.5f * _e11) * rounding)))), 0f);
    let _e20 = s_3;
    let _e21 = part;
    slope_8 = (_e20 * _e21);
    let _e25 = s_3;
    let _e26 = s_3;
    let _e30 = slope_8;
    let _e32 = slope_8;
    let _e34 = part;
    return vec3<f32>((1f - (_e25 * _e26)), (2f * _e30), (-(_e32) * _e34));
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
fn gabor_eroded_at(ground: GaborTerrainPlace, dx: vec2<f32>, dy: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    var steer: vec2<f32>;
    var steer_x: vec2<f32>;
    var steer_y: vec2<f32>;
    var gully: f32;
    var ridge: f32;
    var sum_8: f32 = 0f;
    var gully_slope: vec2<f32>;
    var sum_slope: vec2<f32> = vec2(0f);
    var frequency_6: f32;
    var depth: f32;
    var mask: f32 = 1f;
    var open: f32 = 1f;
    var rounding_1: f32;
    var mask_slope: vec2<f32> = vec2(0f);
    var open_slope: vec2<f32> = vec2(0f);
    var rounded_1: f32;
    var peak: f32;
    var rounding_slope: vec2<f32>;
    var per_onset: f32;
    var i: i32 = 0i;
    var steep: f32;
    var down: vec2<f32>;
    var across: vec2<f32>;
    var full: vec3<f32>;
    var full_slope: vec2<f32>;
    var wave_7: vec2<f32>;
    var bend: vec2<f32>;
    var steps: vec2<f32>;
    var share: f32;
    var kept_1: f32;
    var z_1: vec2<f32>;
    var z_x: vec2<f32>;
    var z_y: vec2<f32>;
    var kept_slope: vec2<f32>;
    var place_6: GaborPlace;
    var field_5: GaborBentField;
    var shrink: f32;
    var crest: f32;
    var local_13: f32;
    var side_1: f32;
    var turns: f32;
    var turn_7: f32;
    var turn_slope: vec2<f32>;
    var wide: f32;
    var edge: vec3<f32>;
    var edge_slope: vec2<f32>;
    var reach_1: f32;
    steer = base.slope;
    steer_x = base.curvature.xy;
    steer_y = base.curvature.yz;
    gully = base.ridge;
    ridge = base.ridge;
    gully_slope = base.ridge_slope;
    frequency_6 = erosion.gully_frequency;
    depth = (erosion.strength / erosion.gully_frequency);
    rounding_1 = mix(erosion.crease_rounding, erosion.ridge_rounding, (0.5f + (0.5f * base.ridge)));
    rounded_1 = (0.5f * (erosion.ridge_rounding - erosion.crease_rounding));
    peak = clamp(base.ridge, 0f, 1f);
    let _e61 = rounded_1;
    rounding_slope = (_e61 * base.ridge_slope);
    per_onset = (1f / max(erosion.onset_slope, 0.000001f));
    loop {
        let _e73 = i;
        if !((_e73 < erosion.octaves)) {
            break;
        }
        {
            let _e80 = steer;
            steep = max(length(_e80), 0.000000001f);
            let _e85 = steer;
            let _e86 = steep;
            down = (_e85 / vec2(_e86));
            let _e90 = down;
            let _e93 = down;
            across = vec2<f32>(-(_e90.y), _e93.x);
            let _e97 = steep;
            let _e98 = per_onset;
            let _e100 = rounding_1;
            let _e101 = gabor_impl_mask((_e97 * _e98), _e100);
            full = _e101;
            let _e103 = full;
            let _e105 = per_onset;
            let _e107 = down;
            let _e108 = steer_x;
            let _e110 = down;
            let _e111 = steer_y;
            let _e115 = full;
            let _e117 = rounding_slope;
            full_slope = (((_e103.y * _e105) * vec2<f32>(dot(_e107, _e108), dot(_e110, _e111))) + (_e115.z * _e117));
            let _e121 = full;
            let _e123 = full;
            let _e125 = mask_slope;
            let _e128 = mask;
            let _e130 = full_slope;
            mask_slope = (_e121.x * ((_e123.x * _e125) + ((2f * _e128) * _e130)));
            let _e134 = mask;
            let _e135 = full;
            let _e137 = full;
            mask = (_e134 * (_e135.x * _e137.x));
            let _e141 = i;
            if (_e141 == 0i) {
                {
                    let _e144 = mask;
                    let _e146 = peak;
                    let _e147 = peak;
                    open = mix(_e144, 1f, (_e146 * _e147));
                    let _e151 = peak;
                    let _e152 = peak;
                    let _e155 = mask_slope;
                    let _e158 = mask;
                    let _e162 = peak;
                    open_slope = (((1f - (_e151 * _e152)) * _e155) + ((((1f - _e158) * 2f) * _e162) * base.ridge_slope));
                }
            }
            let _e167 = frequency_6;
            let _e168 = across;
            wave_7 = (_e167 * _e168);
            let _e171 = frequency_6;
            let _e172 = steep;
            let _e174 = across;
            let _e175 = steer_x;
            let _e177 = across;
            let _e178 = steer_y;
            bend = ((_e171 / _e172) * vec2<f32>(dot(_e174, _e175), dot(_e177, _e178)));
            let _e183 = wave_7;
            let _e185 = wave_7;
            steps = vec2<f32>(dot(_e183, dx), dot(_e185, dy));
            let _e192 = steps;
            let _e193 = steps;
            share = (1.02f * exp((-4.934802f * dot(_e192, _e193))));
            let _e199 = share;
            kept_1 = max((_e199 - 0.02f), 0f);
            z_1 = vec2(0f);
            z_x = vec2(0f);
            z_y = vec2(0f);
            kept_slope = vec2(0f);
            let _e217 = kept_1;
            if (_e217 > 0f) {
                {
                    let _e226 = frequency_6;
                    let _e228 = gabor_impl_ground(ground, (1.2f * _e226));
                    place_6 = _e228;
                    let _e230 = place_6;
                    let _e231 = wave_7;
                    let _e232 = down;
                    let _e233 = i;
                    let _e234 = gabor_derived_seed(seed, _e233);
                    let _e235 = gabor_impl_bent_field(_e230, _e231, _e232, _e234);
                    field_5 = _e235;
                    let _e238 = field_5;
                    z_1 = (erosion.uniformity * _e238.value);
                    let _e242 = z_1;
                    let _e243 = z_1;
                    shrink = inverseSqrt((1f + dot(_e242, _e243)));
                    let _e248 = z_1;
                    let _e249 = shrink;
                    z_1 = (_e248 * _e249);
                    let _e251 = shrink;
                    let _e254 = field_5;
                    let _e256 = bend;
                    let _e258 = field_5;
                    z_x = ((_e251 * erosion.uniformity) * (_e254.along_x - (_e256.x * _e258.bent)));
                    let _e263 = shrink;
                    let _e266 = field_5;
                    let _e268 = bend;
                    let _e270 = field_5;
                    z_y = ((_e263 * erosion.uniformity) * (_e266.along_y - (_e268.y * _e270.bent)));
                    let _e276 = share;
                    let _e278 = steps;
                    let _e279 = down;
                    let _e281 = down;
                    let _e286 = bend;
                    kept_slope = (((9.869604f * _e276) * dot(_e278, vec2<f32>(dot(_e279, dx), dot(_e281, dy)))) * _e286);
                    let _e288 = kept_1;
                    let _e289 = z_x;
                    let _e290 = z_1;
                    let _e291 = z_x;
                    let _e293 = z_1;
                    let _e297 = kept_slope;
                    let _e299 = z_1;
                    z_x = ((_e288 * (_e289 - (dot(_e290, _e291) * _e293))) + (_e297.x * _e299));
                    let _e302 = kept_1;
                    let _e303 = z_y;
                    let _e304 = z_1;
                    let _e305 = z_y;
                    let _e307 = z_1;
                    let _e311 = kept_slope;
                    let _e313 = z_1;
                    z_y = ((_e302 * (_e303 - (dot(_e304, _e305) * _e307))) + (_e311.y * _e313));
                    let _e316 = z_1;
                    let _e317 = kept_1;
                    z_1 = (_e316 * _e317);
                }
            }
            let _e320 = z_1;
            crest = (erosion.gully_weight * _e320.x);
            let _e324 = gully_slope;
            let _e326 = z_x;
            let _e328 = z_y;
            let _e332 = mask;
            let _e335 = crest;
            let _e336 = gully;
            let _e338 = mask_slope;
            gully_slope = (mix(_e324, (erosion.gully_weight * vec2<f32>(_e326.x, _e328.x)), vec2(_e332)) + ((_e335 - _e336) * _e338));
            let _e341 = gully;
            let _e342 = crest;
            let _e343 = mask;
            gully = mix(_e341, _e342, _e343);
            let _e345 = ridge;
            let _e346 = z_1;
            let _e348 = mask;
            ridge = mix(_e345, _e346.x, _e348);
            let _e350 = sum_8;
            let _e351 = depth;
            let _e352 = gully;
            sum_8 = (_e350 + (_e351 * _e352));
            let _e355 = sum_slope;
            let _e356 = depth;
            let _e357 = gully_slope;
            sum_slope = (_e355 + (_e356 * _e357));
            let _e360 = z_1;
            if (_e360.y < 0f) {
                local_13 = -1f;
            } else {
                local_13 = 1f;
            }
            let _e368 = local_13;
            side_1 = _e368;
            let _e371 = depth;
            let _e377 = side_1;
            turns = ((((6.2831855f * _e371) * erosion.branching) * erosion.gully_weight) * _e377);
            let _e380 = turns;
            let _e381 = kept_1;
            let _e383 = mask;
            turn_7 = ((_e380 * _e381) * _e383);
            let _e386 = turns;
            let _e387 = kept_1;
            let _e388 = mask_slope;
            let _e390 = mask;
            let _e391 = kept_slope;
            turn_slope = (_e386 * ((_e387 * _e388) + (_e390 * _e391)));
            let _e396 = steer;
            let _e397 = turn_7;
            let _e398 = wave_7;
            steer = (_e396 - (_e397 * _e398));
            let _e401 = steer_x;
            let _e402 = turn_7;
            let _e403 = bend;
            let _e406 = down;
            let _e408 = turn_slope;
            let _e410 = wave_7;
            steer_x = (_e401 + (((_e402 * _e403.x) * _e406) - (_e408.x * _e410)));
            let _e414 = steer_y;
            let _e415 = turn_7;
            let _e416 = bend;
            let _e419 = down;
            let _e421 = turn_slope;
            let _e423 = wave_7;
            steer_y = (_e414 + (((_e415 * _e416.y) * _e419) - (_e421.y * _e423)));
            let _e427 = frequency_6;
            wide = (_e427 / erosion.gully_frequency);
            let _e435 = z_1;
            rounding_1 = mix(erosion.crease_rounding, erosion.ridge_rounding, (0.5f + (0.5f * _e435.x)));
            let _e440 = rounded_1;
            let _e441 = z_x;
            let _e443 = z_y;
            rounding_slope = (_e440 * vec2<f32>(_e441.x, _e443.x));
            let _e449 = kept_1;
            let _e452 = z_1;
            let _e456 = wide;
            let _e457 = rounding_1;
            let _e459 = gabor_impl_mask(((0.5f - (0.5f * _e449)) + abs(_e452.y)), (_e456 * _e457));
            edge = _e459;
            let _e461 = edge;
            let _e463 = side_1;
            let _e465 = z_x;
            let _e467 = z_y;
            let _e472 = edge;
            let _e475 = kept_slope;
            let _e478 = edge;
            let _e480 = wide;
            let _e482 = rounding_slope;
            edge_slope = ((((_e461.y * _e463) * vec2<f32>(_e465.y, _e467.y)) - ((0.5f * _e472.y) * _e475)) + ((_e478.z * _e480) * _e482));
            let _e488 = mask;
            reach_1 = (1f / (1f + (_e488 * (erosion.detail - 1f))));
            let _e497 = reach_1;
            let _e499 = reach_1;
            let _e500 = edge;
            let _e503 = mask_slope;
            let _e505 = mask;
            let _e506 = edge_slope;
            mask_slope = ((erosion.detail * _e497) * (((_e499 * _e500.x) * _e503) + (_e505 * _e506)));
            let _e510 = mask;
            let _e512 = reach_1;
            let _e514 = edge;
            mask = (_e510 * ((erosion.detail * _e512) * _e514.x));
            let _e518 = frequency_6;
            frequency_6 = (_e518 * erosion.lacunarity);
            let _e521 = depth;
            depth = (_e521 * erosion.gain);
        }
        continuing {
            let _e77 = i;
            i = (_e77 + 1i);
        }
    }
    let _e525 = open;
    let _e526 = sum_8;
    let _e530 = open;
    let _e531 = sum_slope;
    let _e534 = sum_8;
    let _e535 = open_slope;
    let _e538 = ridge;
    return GaborTerrain((base.height + (_e525 * _e526)), ((base.slope + (_e530 * _e531)) + (_e534 * _e535)), _e538, vec3(0f), vec2(0f));
}

// ---- Definitions of the public functions ---------------------------------------------------------------------------

fn gabor_erosion() -> GaborErosion {
    return GaborErosion(5i, 1.5f, 0.12f, 2f, 0.5f, 0.5f, 1.5f, 2f, 0.1f, 0.1f, 0.5f, 1f);
}

fn gabor_terrain(p: vec2<f32>, seed: u32) -> GaborTerrain {
    let _e11 = gabor_terrain_at(GaborTerrainPlace(vec2(0i), p, vec2(0f)), vec2(0f), vec2(0f), seed);
    return _e11;
}

fn gabor_eroded(p: vec2<f32>, base: GaborTerrain, erosion: GaborErosion, seed: u32) -> GaborTerrain {
    let _e13 = gabor_eroded_at(GaborTerrainPlace(vec2(0i), p, vec2(0f)), vec2(0f), vec2(0f), base, erosion, seed);
    return _e13;
}

fn gabor_ground_cover(terrain: GaborTerrain) -> vec4<f32> {
    var steep_1: f32;
    var scree: f32;
    var rock: f32;
    var snow: f32;
    steep_1 = length(terrain.slope);
    scree = smoothstep(-0.3f, 0.35f, (terrain.height + (0.1f * terrain.ridge)));
    let _e16 = steep_1;
    rock = smoothstep(0.55f, 1f, _e16);
    let _e30 = steep_1;
    snow = (smoothstep(0.42f, 0.62f, (terrain.height + (0.08f * terrain.ridge))) * (1f - smoothstep(1f, 1.9f, _e30)));
    let _e36 = snow;
    let _e39 = rock;
    let _e42 = scree;
    let _e44 = scree;
    let _e46 = ((1f - _e39) * vec2<f32>((1f - _e42), _e44));
    let _e47 = rock;
    let _e51 = ((1f - _e36) * vec3<f32>(_e46.x, _e46.y, _e47));
    let _e52 = snow;
    return vec4<f32>(_e51.x, _e51.y, _e51.z, _e52);
}


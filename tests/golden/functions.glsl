// Calls every public function of the drop-ins at 64 points. This text is compiled as C++ and as GLSL, after
// the drop-ins and two macros: GOLDEN_... selects the set, and SEE(call) records the result of a call.
//
// One point in four lies on nodes and at the ends of windows, and one in four is far away. Points with
// negative numbers have arbitrary float arguments for which docs/gallery.md promises finite results.

struct Point {
    vec2 p;
    vec3 q;
    float frequency;
    float orientation;
    float frequency_spread;
    float orientation_spread;
    vec3 direction;
    vec3 normal;
    vec2 dx;
    vec2 dy;
    vec3 dx_3d;
    vec3 dy_3d;
    vec2 period;
    vec3 period_3d;
    float time;
    ivec2 cell;
    vec2 local;
    uint seed;
};

// A different word for each point and k.
uint random_word(int point, int k) {
    uint word = (uint(point) * 0x9e3779b1u + uint(k)) * 0x85ebca6bu;
    word = (word ^ (word >> 15u)) * 0x2c1b3c6du;
    word = (word ^ (word >> 12u)) * 0x297a2d39u;
    return word ^ (word >> 15u);
}

// A number from low to high, the same with every compiler.
float drawn(int point, int k, float low, float high) {
    precise float above = (high - low) * (float(random_word(point, k) >> 8u) / 16777216.0f);
    return low + above;
}

// A number from low to high, which is an end for one point in four.
float drawn_to_ends(int point, int k, float low, float high) {
    return min(max(drawn(point, k, 1.17f * low - 0.17f * high, 1.17f * high - 0.17f * low), low), high);
}

// Any float: half of the time random bits, otherwise powers of two, their neighbours, zeros, infinities and NaN.
float any_number(int point, int k) {
    uint word = random_word(point, k);
    uint edge = (word & 0xff800000u) + (word >> 8u) % 3u - 1u;
    uint bits = word % 2u == 0u ? random_word(point, k + 1000) : edge;
#if defined GABOR_ROUNDING // compilers may assume that numbers are finite
    if ((bits & 0x7f800000u) == 0x7f800000u)
        bits &= 0xbfffffffu;
#endif
    return uintBitsToFloat(bits);
}

// Any float within [-most, most].
float any_within(int point, int k, float most) {
    float value = any_number(point, k);
    return abs(value) <= most ? value : min(most, 1.0e30f) * drawn(point, k + 500, -1.0f, 1.0f);
}

// With three taps, nodes lie at even integers, and windows end at odd ones.
float coordinate(int point, int k) {
    int kind = point / 4 % 4;
    float far = drawn(point, k, -2.0e4f, 2.0e4f);
    float near = drawn(point, k, -4.0f, 4.0f);
    return kind == 0 ? floor(near) : kind == 1 && k % 2 == 1 ? floor(near) : kind == 3 ? far : near;
}

#if defined GABOR_ROUNDING
const float MOST = 3.4e38f;
#else
const float MOST = 1.0f / 0.0f;
#endif
const float WORLD = 2.6e8f; // an eighth of 2^31, because lobes may have more nodes per unit

// A point with some arguments of any size.
Point any_of(Point s, int i) {
    s.p = vec2(0.3f, 0.8f);
    s.q = vec3(0.3f, 0.8f, 3.1f);
    s.period = vec2(4.0f, 4.0f);
    s.period_3d = vec3(4.0f, 4.0f, 4.0f);
    int kind = i % 5; // as in file.hpp
    if (kind == 0) {
        s.frequency = any_within(i, 100, MOST);
        s.orientation = any_within(i, 101, 3.4e38f);
    }
    if (kind == 1) {
        s.p = vec2(any_within(i, 102, WORLD), any_within(i, 103, WORLD));
        s.q = vec3(s.p.x, s.p.y, any_within(i, 104, WORLD));
        s.cell = ivec2(int(random_word(i, 105)), int(random_word(i, 106)));
        s.local = vec2(any_within(i, 107, 64.0f), any_within(i, 108, 64.0f));
        s.time = any_within(i, 109, 1.0e38f);
    }
    if (kind == 2) { // no index of a node or cell may overflow
#if defined GOLDEN_SPARSE
        const float longest = 1.0e9f;
#else
        const float longest = MOST;
#endif
        s.p = vec2(any_within(i, 110, 7.0e5f), any_within(i, 111, 7.0e5f));
        s.q = vec3(s.p.x, s.p.y, any_within(i, 112, 7.0e5f));
        s.period = vec2(any_within(i, 113, longest), any_within(i, 114, longest));
        s.period_3d = vec3(s.period.x, s.period.y, any_within(i, 115, longest));
    }
    if (kind == 3) { // pixels of any size
#if defined GOLDEN_EROSION
        s.dx_3d = vec3(any_within(i, 116, 1.0e15f), any_within(i, 117, 1.0e15f), 0.0f);
        s.dy_3d = vec3(any_within(i, 119, 1.0e15f), any_within(i, 120, 1.0e15f), 0.0f);
#else
        s.dx_3d = vec3(any_number(i, 116), any_number(i, 117), any_number(i, 118));
        s.dy_3d = vec3(any_number(i, 119), any_number(i, 120), any_number(i, 121));
#endif
        s.dx = vec2(s.dx_3d.x, s.dx_3d.y);
        s.dy = vec2(s.dy_3d.x, s.dy_3d.y);
    }
#if !defined GOLDEN_SPECTRUM // in the spectrum set, profiles take the direction as stripes
    if (kind == 4) {
        s.direction = vec3(any_within(i, 122, 1.0e15f), any_within(i, 123, 1.0e15f), any_within(i, 124, 1.0e15f));
        s.normal = vec3(any_within(i, 125, 1.0e15f), any_within(i, 126, 1.0e15f), any_within(i, 127, 1.0e15f));
    }
#endif
    return s;
}

Point point_of(int point) {
    bool of_any = point < 0;
    int i = abs(point);
    Point s;
    s.p = vec2(coordinate(i, 0), coordinate(i, 1));
    s.q = vec3(coordinate(i, 2), coordinate(i, 3), coordinate(i, 4));
    s.frequency = i % 16 == 1 ? 20.0f : i % 16 == 2 ? -0.05f : drawn(i, 5, 0.1f, 4.0f);
#if defined GOLDEN_SPECTRUM
    if (i % 16 == 1) s.frequency = 8.0f;
#endif
#if !defined GOLDEN_SPARSE
    if (i % 16 == 3) s.frequency = 0.0f;
#endif
    s.orientation = drawn(i, 6, -4.0f, 4.0f);
    s.frequency_spread = i % 8 == 3 ? 0.0f : drawn(i, 7, 0.0f, 1.1f);
    s.orientation_spread = i % 8 == 5 ? 0.0f : drawn(i, 8, 0.0f, 1.7f);
    s.direction = vec3(drawn(i, 9, -1.0f, 1.0f), drawn(i, 10, -1.0f, 1.0f), drawn(i, 11, -1.0f, 1.0f));
    s.normal = vec3(drawn(i, 12, -0.5f, 0.5f), drawn(i, 13, -0.5f, 0.5f), drawn(i, 14, -0.5f, 0.5f));
#if defined GOLDEN_NOISE_3D
    if (i % 16 == 9) // the longest direction allowed
        s.direction = 1.0e15f * vec3(s.direction.x < 0.0f ? -1.0f : 1.0f, s.direction.y, s.direction.z);
#endif
    if (i % 8 == 6) // the direction is nearly the normal
        s.normal = s.direction + 0.3f * s.normal;
    // Pixels have all sizes and shapes; at steps of 0.18 to 0.2, the filter changes its form.
    float size = i % 8 == 1 ? drawn(i, 15, 0.18f, 0.2f) : exp2(drawn(i, 15, -7.0f, 2.0f));
    s.dx_3d = size * vec3(drawn(i, 16, -1.0f, 1.0f), drawn(i, 17, -1.0f, 1.0f), drawn(i, 18, -1.0f, 1.0f));
    s.dy_3d = size * vec3(drawn(i, 19, -1.0f, 1.0f), drawn(i, 20, -1.0f, 1.0f), drawn(i, 21, -1.0f, 1.0f));
    if (i % 16 == 7) // a line
        s.dy_3d = 0.5f * s.dx_3d;
    if (i % 16 == 15)
        s.dx_3d = 2.0e3f * s.dx_3d;
    s.dx = vec2(s.dx_3d.x, s.dx_3d.y);
    s.dy = vec2(s.dy_3d.x, s.dy_3d.y);
    if (i % 8 == 4) { // along the axes
        s.dx.y = 0.0f;
        s.dy.x = 0.0f;
    }
    s.period = vec2(drawn(i, 22, 0.2f, 9.0f), drawn(i, 23, 0.2f, 9.0f));
    s.period_3d = vec3(s.period.x, s.period.y, drawn(i, 24, 0.2f, 9.0f));
    s.time = drawn(i, 25, -2.0f, 2.0f);
    s.cell = ivec2(int(drawn(i, 26, -2.0e9f, 2.0e9f)), int(drawn(i, 27, -2.0e9f, 2.0e9f)));
    s.local = vec2(drawn(i, 28, -2.0f, 2.0f), drawn(i, 29, -2.0f, 2.0f));
    s.seed = uint(i) * 0x9e3779b1u;
    return of_any ? any_of(s, i) : s;
}

// The number that is recorded for a value: a sum of its components, with derivatives scaled to about 1.

float kept(float v) {
    return v;
}

float kept(vec2 v) {
    return v.x + 0.7f * v.y;
}

float kept(vec3 v) {
    return v.x + 0.7f * v.y - 0.5f * v.z;
}

float kept(vec4 v) {
    return v.x + 0.7f * v.y - 0.5f * v.z + 0.3f * v.w;
}

float flipped(vec2 v) {
    return kept(vec2(v.y, v.x));
}

#if defined GOLDEN_SPARSE
float kept(GaborField f) {
    vec2 slopes = f.quadrature_gradient + 0.7f * f.gradient;
    return f.quadrature + 0.7f * f.noise + 0.05f * (slopes.x + 0.3f * slopes.y);
}
#else
float kept(GaborField f) {
    vec2 slopes = f.quadrature_gradient + 0.7f * f.gradient;
    return f.quadrature + 0.7f * f.noise + f.removed + 0.05f * (slopes.x + 0.3f * slopes.y);
}
#endif

#if defined GOLDEN_NOISE_3D
float kept(GaborField3d f) {
    return f.noise + 0.7f * f.quadrature + f.removed + 0.05f * kept(f.gradient) + 0.03f * kept(f.quadrature_gradient);
}
#endif

#if defined GOLDEN_OCEAN
float kept(GaborWater w) {
    return w.height + 5.0f * kept(w.slope) + 0.5f * kept(w.shift) + 0.3f * w.jacobian + 5.0f * kept(w.lost) + 0.2f * kept(w.velocity);
}
#endif

#if defined GOLDEN_EROSION
float kept(GaborTerrain t) {
    return t.height + 0.2f * kept(t.slope) + 0.5f * t.ridge + 0.01f * kept(t.curvature) + 0.05f * kept(t.ridge_slope);
}
#endif

#if defined GOLDEN_FRACTAL
float kept(GaborFractalNoise f) {
    return f.noise + 0.01f * kept(f.gradient) + f.removed + 0.0001f * kept(f.lost);
}
float kept(GaborFractalNoise3d f) {
    return f.noise + 0.01f * kept(f.gradient) + f.removed + 0.0001f * (kept(f.lost) + kept(f.lost_mixed));
}
float kept(GaborWarp w) {
    return kept(w.place.local) + 0.01f * (kept(w.dx) - kept(w.dy)) + 0.0001f * kept(w.lost);
}
float kept(GaborWarp3d w) {
    return kept(w.place.local) + 0.01f * (kept(w.dx) - kept(w.dy) + 0.7f * kept(w.dz)) + 0.0001f * (kept(w.lost) + kept(w.lost_mixed));
}
#endif

#if defined GOLDEN_MATERIALS
float kept(GaborMaterial m) {
    return kept(m.colour) + 10.0f * m.height + 0.3f * gabor_roughness(m) + 0.2f * m.metalness + 0.1f * kept(m.slope) + kept(m.lost);
}
#endif

#if defined GOLDEN_MATERIALS
float kept(GaborBoard b) {
    return kept(b.position) + 0.7f * kept(b.dx) + 0.3f * kept(b.dy) + float(b.seed >> 8u) / 16777216.0f + kept(b.rotation) + b.shade + kept(b.tint)
           + b.joint_cover.x + (b.joint_cover.y + 0.7f * b.joint_cover.z) / (1.0f + abs(b.joint_cover.y) + abs(b.joint_cover.z)); // its edges may be steep
}
#endif

float kept_gradient(vec3 v) {
    return v.x + 0.05f * v.y + 0.03f * v.z;
}

void see_all(int i) {
    Point s = point_of(i);
    i = abs(i);
#if defined GOLDEN_NOISE || defined GOLDEN_SPARSE
    SEE(gabor_noise(s.p, s.frequency, s.orientation, s.seed))
    SEE(gabor_unorm(gabor_noise(s.p, s.frequency, s.orientation, s.seed)))
    SEE(kept_gradient(gabor_noise_gradient(s.p, s.frequency, s.orientation, s.seed)))
    SEE(flipped(gabor_noise_quadrature(s.p, s.frequency, s.orientation, s.seed)))
    SEE(gabor_turns_intensity(gabor_noise_quadrature(s.p, s.frequency, s.orientation, s.seed)).y)
    SEE(sin(6.2831853f * gabor_turns_intensity(gabor_noise_quadrature(s.p, s.frequency, s.orientation, s.seed)).x))
    SEE(gabor_noise_tiled(s.p, s.period, s.frequency, s.orientation, s.seed))
    SEE(gabor_noise_animated(s.p, s.time, s.frequency, s.orientation, s.seed))
#endif
#if defined GOLDEN_SPARSE
    SEE(gabor_noise_at(s.cell, s.local, gabor_kernel(s.frequency, s.orientation), s.seed))
    GaborPlace place = gabor_place(s.cell, s.local);
    place.cells_per_radius *= 0.9f;
    place.period = ivec2(7, 12);
    place.evolution = s.time;
    SEE(kept(gabor_field(place, gabor_kernel(s.frequency, s.orientation), s.seed)))
#elif !defined GOLDEN_EROSION && !defined GOLDEN_MATERIALS && !defined GOLDEN_OCEAN
    GaborPlace place = gabor_place(s.cell, s.local);
    place.cells_per_radius *= 0.9f;
    place.period = ivec2(7, 12);
    place.evolution = i % 2 == 0 ? s.time : 0.0f;
    GaborPlace tile = gabor_place_tiled(i / 4 % 4 == 3 ? 1.0e-4f * s.p : s.p, s.period);
    tile.evolution = s.time;
    vec2 wave = gabor_wave_vector(s.frequency, s.orientation);
#endif
#if defined GOLDEN_NOISE
    SEE(float(gabor_derived_seed(s.seed, i) >> 8u) / 16777216.0f)
    vec2 uneven = s.frequency * vec2(s.direction.x, s.normal.x);
    float sharpness = drawn(i, 33, 0.0f, 5.0f);
    SEE(gabor_field(gabor_place(s.cell, s.local), wave, s.seed).noise)
    SEE(kept(gabor_field(place, wave, s.seed)))
    SEE(kept(gabor_field(place, uneven, s.seed)))
    SEE(kept(gabor_field(gabor_place_at(s.p), uneven, s.seed)))
    SEE(kept(gabor_field(gabor_place_tiled(s.p, s.period), wave, s.seed)))
    SEE(kept(gabor_stripes(s.p, uneven, sharpness, s.seed)))
    SEE(kept(gabor_stripes_of(gabor_field(place, uneven, s.seed), sharpness)))
#endif
#if defined GOLDEN_SPECTRUM
    GaborPlace here = gabor_place_at(i / 4 % 4 == 3 ? 1.0e-4f * s.p : s.p); // lobes round positions
    GaborLobes lobes;
    lobes.count = 5; // only GABOR_LOBES are used
    lobes.lobe[0] = gabor_lobe(s.frequency, s.orientation, 1.0f, 2.0f);
    lobes.lobe[1] = gabor_lobe(2.0f, 1.6f, drawn(i, 30, 0.5f, 2.0f), i % 8 == 0 ? 0.0f : 1.0f);
    lobes.lobe[2] = gabor_lobe(drawn(i, 31, 0.0f, 3.0f), s.time, 0.7f, drawn(i, 32, 0.0f, 3.0f));
    for (int k = 0; k < 3 && i % 16 == 13; ++k) // no power at all
        lobes.lobe[k].power = 0.0f;
    GaborLobes ellipses = lobes;
    ellipses.lobe[1] = GaborLobe(2.0f, 1.6f, vec2(0.7f, drawn(i, 30, 0.5f, 2.0f)), 1.0f);
#define SPREAD s.frequency, s.orientation, s.frequency_spread, s.orientation_spread, s.seed
    SEE(gabor_noise_spread(s.p, SPREAD))
    SEE(kept(gabor_field_spread(tile, SPREAD)))
    SEE(gabor_noise_isotropic(s.p, s.frequency, s.seed))
    SEE(kept(gabor_field_isotropic(tile, s.frequency, s.seed)))
    SEE(kept(gabor_field_isotropic_filtered(gabor_place_at(s.p), s.dx, s.dy, s.frequency, s.seed)))
    SEE(kept(gabor_field_isotropic_filtered(tile, s.dx, s.dy, s.frequency, s.seed)))
    SEE(kept(gabor_field_lobes(here, lobes, s.seed)))
    SEE(kept(gabor_field_lobes(tile, lobes, s.seed)))
    SEE(kept(gabor_field_lobes(here, ellipses, s.seed)))
    SEE(kept(gabor_field_lobes_filtered(here, s.dx, s.dy, lobes, s.seed)))
    SEE(kept(gabor_field_lobes_filtered(tile, s.dx, s.dy, ellipses, s.seed)))
    GaborLobes fewer = ellipses;
    fewer.count = i % 4;
    SEE(0.2f * kept(gabor_field_lobes(place, fewer, s.seed)))
    SEE(0.2f * kept(gabor_field_lobes_filtered(place, 0.2f * s.dx, 0.2f * s.dy, fewer, s.seed)))
    float spread = i % 16 == 2 ? 0.0f : drawn(i, 34, -0.5f, 0.5f); // at frequency 20, as many directions as there may be
    SEE(gabor_noise_spread(s.p, i % 16 == 2 ? 20.0f : s.frequency, s.orientation, spread, drawn(i, 35, -0.5f, 2.0f), s.seed))
    SEE(kept(gabor_noise_filtered(s.p, s.dx, s.dy, s.frequency, s.orientation, s.seed)))
    SEE(kept(gabor_field_filtered(gabor_place_at(s.p), s.dx, s.dy, wave, s.seed)))
    SEE(kept(gabor_field_filtered(tile, s.dx, s.dy, wave, s.seed)))
    vec2 uneven = s.frequency * vec2(s.direction.x, s.direction.y);
    SEE(kept(gabor_stripes_of(gabor_field_filtered(gabor_place_at(s.p), s.dx, s.dy, uneven, s.seed), abs(s.time))))
    SEE(kept(gabor_stripes_of(gabor_field_filtered(tile, s.dx, s.dy, uneven, s.seed), abs(s.time))))
    vec2 blurred = 0.4f * vec2(s.direction.x, s.direction.y);
    vec3 stripes = gabor_stripes(s.p, uneven, 2.0f, s.seed); // just below length 1, rounding changes profiles
    vec2 sharp = vec2(stripes.x, stripes.y);
    SEE(gabor_profile_triangle(blurred))
    SEE(gabor_profile_sawtooth(blurred))
    SEE(gabor_profile_pulse(blurred, 0.3f))
    SEE(0.01f * gabor_profile_triangle(sharp))
#endif
#if defined GOLDEN_DIRECTION
    vec2 p = i / 4 % 4 == 3 ? 1.0e-3f * s.p : s.p; // the map's frequencies grow with p
    GaborWaves waves;
    for (int k = 0; k < 9; ++k)
        waves.wave[k] = vec2(drawn(i, 40 + k, -3.0f, 3.0f), drawn(i, 50 + k, -3.0f, 3.0f));
    SEE(kept(gabor_node_position(place, i % 9)))
    SEE(kept(gabor_field_waves(place, waves, s.seed)))
    SEE(kept(gabor_field_direction(place, s.seed)))
    SEE(kept(gabor_field_direction(gabor_place_tiled(p, s.period), s.seed)))
    SEE(kept(gabor_stripes_of(gabor_field_direction(gabor_place_at(p), s.seed), 2.0f)))
    SEE(kept(gabor_stripes_of(gabor_field_direction(place, s.seed), 2.0f)))
#endif
#if defined GOLDEN_NOISE_3D || defined GOLDEN_FRACTAL
    GaborPlace3d here = gabor_place_3d_at(s.q), solid = gabor_place_3d(ivec3(s.cell.x, 3, s.cell.y), vec3(s.local.x, s.time, s.local.y));
    solid.cells_per_radius *= vec3(0.9f, 1.1f, 1.0f);
    solid.period = ivec3(7, 0, 12);
    solid.evolution = place.evolution;
    GaborPlace3d block = gabor_place_3d_tiled(s.q, s.period_3d);
    vec3 dx = s.dx_3d, dy = s.dy_3d;
#endif
#if defined GOLDEN_NOISE_3D
    vec3 wave_3d = s.frequency * gabor_impl_unit(s.direction);
    SEE(gabor_noise_3d(s.q, s.frequency, s.direction, s.seed))
    SEE(gabor_noise_3d_isotropic(s.q, s.frequency, s.seed))
    SEE(gabor_noise_surface(s.q, s.normal, s.frequency, s.direction, s.seed))
    SEE(kept(gabor_field_3d(here, wave_3d, s.seed)))
    SEE(kept(gabor_field_3d(solid, wave_3d, s.seed)))
    SEE(kept(gabor_field_3d(block, wave_3d, s.seed)))
    SEE(kept(gabor_field_3d_isotropic(here, s.frequency, s.seed)))
    SEE(kept(gabor_field_3d_isotropic(solid, 0.3f * s.frequency, s.seed)))
    SEE(kept(gabor_field_surface(solid, s.normal, s.frequency, s.direction, s.seed)))
    SEE(kept(gabor_field_surface_isotropic(here, s.normal, 2.0f * s.frequency, s.seed)))
    SEE(kept(gabor_field_surface_isotropic(solid, s.normal, s.frequency, s.seed)))
    SEE(kept(gabor_field_3d_filtered(here, dx, dy, wave_3d, s.seed)))
    SEE(kept(gabor_field_3d_filtered(solid, dx, dy, wave_3d, s.seed)))
    SEE(kept(gabor_field_3d_isotropic_filtered(here, dx, dy, s.frequency, s.seed)))
    SEE(kept(gabor_field_3d_isotropic_filtered(solid, dx, dy, 0.3f * s.frequency, s.seed)))
    SEE(kept(gabor_field_surface_filtered(solid, dx, dy, s.normal, s.frequency, s.direction, s.seed)))
    SEE(kept(gabor_field_surface_isotropic_filtered(solid, dx, dy, s.normal, s.frequency, s.seed)))
#endif
#if defined GOLDEN_FRACTAL
    // Octaves round positions, so they start near the origin. The periods of all octaves are whole numbers before they
    // are rounded, and no step is near a number that rounds to another multiple of 1/4096.
    vec2 p = i / 4 % 4 == 3 ? 1.0e-4f * s.p : s.p;
    vec3 q = i / 4 % 4 == 3 ? 1.0e-4f * s.q : s.q;
    GaborFractal repeats = gabor_fractal(drawn_to_ends(i, 60, 1.0f, 3.0f), drawn_to_ends(i, 61, 0.0f, 1.0f));
    repeats.lacunarity = float(1 + i % 4);
    repeats.basis = i / 4 % 2 == 0 ? GABOR_SMOOTH : GABOR_PERLIN;
    GaborFractal turns = repeats, cubes = gabor_fractal(drawn(i, 62, 1.0f, 3.0f), drawn(i, 63, 0.3f, 0.9f));
    turns.lacunarity = (floor(drawn(i, 64, 64.0f, 256.0f)) + 0.3f) / 64.0f;
    turns.turn = i % 4 == 0 ? 0.0f : i % 4 == 1 ? 1.5707963f : i % 4 == 2 ? 0.6435011f : -0.9272952f;
    cubes.basis = repeats.basis;
    // At a crease, gradients of billows and ridges depend on the last digit.
    GaborFractal rough = turns, rough_repeats = repeats, rough_cubes = cubes;
    rough.shape = rough_repeats.shape = rough_cubes.shape = i % 2 == 0 ? GABOR_BILLOW : GABOR_RIDGED;
    float octaves = turns.octaves, gain = turns.gain, strength = drawn(i, 65, 0.0f, 1.0f);
    GaborPlace near = gabor_place_at(p), far = gabor_place(s.cell, s.local);
    GaborPlace3d far_3d = gabor_place_3d(ivec3(s.cell.x, s.cell.y, i), vec3(s.local.x, s.local.y, s.local.x));
    solid.local.y = s.local.x; // an evolution may be too large for a position
    SEE(gabor_uniform(s.time))
    SEE(gabor_uniform_slope(s.time))
    SEE(gabor_smooth(p, s.seed))
    SEE(gabor_perlin(p, s.seed))
    SEE(gabor_perlin_3d(q, s.seed))
    SEE(gabor_fbm(p, octaves, gain, s.seed))
    SEE(gabor_fbm_3d(q, octaves, gain, s.seed))
    SEE(gabor_billow(p, octaves, gain, s.seed))
    SEE(gabor_ridged(p, octaves, gain, s.seed))
    SEE(kept(gabor_fractal_noise(near, turns, s.seed)))
    SEE(kept(gabor_fractal_noise(far, turns, s.seed)))
    SEE(kept(gabor_fractal_noise(place, repeats, s.seed)))
    SEE(gabor_fractal_noise(tile, rough_repeats, s.seed).noise)
    SEE(gabor_fractal_noise_filtered(near, s.dx, s.dy, rough, s.seed).noise)
    SEE(kept(gabor_fractal_noise_filtered(place, s.dx, s.dy, repeats, s.seed)))
    SEE(gabor_fractal_noise_3d(far_3d, rough_cubes, s.seed).noise)
    SEE(kept(gabor_fractal_noise_3d_filtered(solid, dx, dy, repeats, s.seed)))
    SEE(kept(gabor_warp(far, strength, turns, s.seed)))
    SEE(kept(gabor_warp_filtered(place, s.dx, s.dy, strength, repeats, s.seed)))
    SEE(kept(gabor_warp_3d(solid, strength, repeats, s.seed)))
    SEE(kept(gabor_warp_3d_filtered(solid, dx, dy, strength, repeats, s.seed)))
#endif
#if defined GOLDEN_EROSION
    GaborErosion erosion = gabor_erosion();
    if (i % 4 == 1) { // no parameter has its default
        erosion.octaves = 1 + i / 4 % 6;
        erosion.gully_frequency = drawn(i, 34, 0.2f, 5.0f);
        erosion.strength = drawn(i, 35, 0.0f, 1.0f);
        erosion.lacunarity = drawn(i, 36, 1.5f, 3.0f);
        erosion.gain = drawn(i, 37, 0.3f, 0.7f);
        erosion.onset_slope = drawn(i, 38, 0.05f, 1.0f);
        erosion.detail = drawn(i, 39, 1.0f, 4.0f);
        erosion.uniformity = drawn(i, 40, 0.5f, 4.0f);
        erosion.ridge_rounding = drawn(i, 41, 0.0f, 1.0f);
        erosion.crease_rounding = drawn(i, 42, 0.0f, 1.0f);
        erosion.gully_weight = drawn(i, 43, 0.0f, 1.0f);
        erosion.branching = drawn(i, 44, 0.0f, 1.0f);
    }
    GaborTerrain base = gabor_terrain(s.p, s.seed);
    GaborTerrain slope;
    slope.height = s.time;
    slope.slope = i % 16 == 6 ? vec2(0.0f, 0.0f) : vec2(s.direction.x, s.direction.y);
    slope.ridge = s.direction.z;
    slope.curvature = vec3(drawn(i, 45, -2.0f, 2.0f), drawn(i, 46, -2.0f, 2.0f), drawn(i, 47, -2.0f, 2.0f));
    slope.ridge_slope = vec2(drawn(i, 48, -2.0f, 2.0f), drawn(i, 49, -2.0f, 2.0f));
    GaborTerrainPlace ground;
    ground.cell = ivec2(s.cell.x / 4, s.cell.y / 4);
    ground.local = s.local;
    ground.period = i % 2 == 0 ? vec2(0.0f, 0.0f) : vec2(4.0f, 7.5f) + s.period;
    if (i % 2 == 1) ground.cell = ivec2(i, -i);
    SEE(kept(base))
    SEE(kept(gabor_terrain_at(ground, s.dx, s.dy, s.seed)))
    SEE(kept(gabor_eroded(s.p, base, erosion, s.seed)))
    vec4 ground_shares = gabor_ground_cover(base);
    SEE(ground_shares.x + 2.0f * ground_shares.y + 3.0f * ground_shares.z + 4.0f * ground_shares.w)
    SEE(kept(gabor_eroded(s.p, slope, erosion, s.seed)))
    SEE(kept(gabor_eroded_at(ground, s.dx, s.dy, slope, erosion, s.seed)))
    GaborErosion any;
    any.octaves = i % 7;
    any.gully_frequency = drawn_to_ends(i, 60, 0.1f, 10.0f);
    any.strength = drawn_to_ends(i, 61, 0.0f, 0.5f);
    any.lacunarity = drawn_to_ends(i, 62, 1.0f, 4.0f);
    any.gain = drawn_to_ends(i, 63, 0.0f, 1.0f);
    any.onset_slope = drawn_to_ends(i, 64, 0.05f, 4.0f);
    any.detail = drawn_to_ends(i, 65, 0.1f, 10.0f);
    any.uniformity = drawn_to_ends(i, 66, 0.0f, 8.0f);
    any.ridge_rounding = drawn_to_ends(i, 67, 0.0f, 2.0f);
    any.crease_rounding = drawn_to_ends(i, 68, 0.0f, 2.0f);
    any.gully_weight = drawn_to_ends(i, 69, 0.0f, 1.0f);
    any.branching = drawn_to_ends(i, 70, 0.0f, 2.0f);
    ground.cell = ivec2(i % 9, -(i % 5));
    ground.period = vec2(i % 3 == 0 ? 0.0f : 0.5f * s.period.x, i % 3 == 1 ? 0.0f : s.period.y);
    SEE(kept(gabor_terrain_at(ground, 0.1f * s.dx, 0.1f * s.dy, s.seed)))
    SEE(kept(gabor_eroded_at(ground, 0.1f * s.dx, 0.1f * s.dy, base, any, s.seed)))
#endif
#if defined GOLDEN_OCEAN
    GaborOcean sea = i % 2 == 0 ? gabor_ocean(12.0f) : gabor_ocean_of(GaborSea(6.0f, 3.0e4f, i % 4 == 1 ? 2.5f : 0.0f, 11.0f, -0.7f, 0.0f, 2.2f, i % 4 == 3 ? 64 : 0));
    int second = i % 4 == 0 ? 10000000 + i : i; // four months
    vec2 none = vec2(0.0f, 0.0f), dx = vec2(drawn(i, 45, -3.0f, 3.0f), drawn(i, 46, -3.0f, 3.0f));
    vec2 at = vec2(drawn(i, 47, -900.0f, 900.0f), drawn(i, 48, -900.0f, 900.0f));
    float fraction = drawn(i, 49, 0.0f, 1.0f);
    SEE(kept(gabor_water_at(s.cell, s.local, second, fraction, none, none, sea, s.seed)))
    SEE(kept(gabor_water_at(s.cell, s.local, second, fraction, dx, vec2(-dx.y, dx.x), sea, s.seed)))
    SEE(kept(gabor_water(at, 60.0f * fraction, sea, s.seed)))
    SEE(kept(gabor_water_filtered(at, dx, vec2(dx.y, dx.x), 60.0f * fraction, sea, s.seed)))
    SEE(gabor_water_height(at, 60.0f * fraction, sea, s.seed))
    SEE(0.2f * gabor_foam(at, none, none, gabor_water(at, 60.0f * fraction, sea, s.seed), sea, s.seed))
    SEE(0.2f * gabor_foam(at, dx, vec2(dx.y, dx.x), gabor_water_filtered(at, dx, vec2(dx.y, dx.x), 60.0f * fraction, sea, s.seed), sea, s.seed))
    SEE(sea.tail.x + sea.tail.y + sea.band[3].amplitude + sea.band[GABOR_OCEAN_BANDS].amplitude)
    GaborSea usual = gabor_sea();
    SEE(0.1f * (usual.wind + usual.swell_period) + 1.0e-6f * usual.fetch + usual.swell_direction)
    // Beyond all ranges.
    GaborOcean end = i % 2 == 0 ? gabor_ocean_of(GaborSea(1.0f, 500.0f, 1.0f, 2.0f, 0.5f, 0.0f, 1.3f, 0))
                                    : gabor_ocean_of(GaborSea(40.0f, 3.0e6f, 2.0f, 40.0f, 0.4f, 0.0f, -2.5f, 0));
    SEE(0.1f * kept(gabor_water_at(s.cell, s.local, -i, fraction, none, none, end, s.seed)))
    SEE(0.1f * kept(gabor_water_at(s.cell, s.local, -i, fraction, dx, vec2(dx.y, dx.x), end, s.seed)))
#endif
#if defined GOLDEN_MATERIALS
    vec2 p = i % 4 == 3 ? 0.01f * s.p : s.p; // no farther than 200 units
    vec2 dx = 0.3f * s.dx, dy = 0.3f * s.dy, period = vec2(4.0f, 7.5f);
#define MATERIAL(sharp, filtered, parameters, at, filtered_at)                                                            \
    SEE(kept(sharp(p, s.seed))) SEE(kept(filtered(p, dx, dy, s.seed))) SEE(kept(at(p, period, parameters(), s.seed)))     \
    SEE(kept(filtered_at(p, dx, dy, period, parameters(), s.seed)))
    MATERIAL(gabor_wood, gabor_wood_filtered, gabor_wood_default, gabor_wood_at, gabor_wood_filtered_at)
    MATERIAL(gabor_fabric, gabor_fabric_filtered, gabor_fabric_default, gabor_fabric_at, gabor_fabric_filtered_at)
    MATERIAL(gabor_leather, gabor_leather_filtered, gabor_leather_default, gabor_leather_at, gabor_leather_filtered_at)
    MATERIAL(gabor_marble, gabor_marble_filtered, gabor_marble_default, gabor_marble_at, gabor_marble_filtered_at)
    MATERIAL(gabor_sand, gabor_sand_filtered, gabor_sand_default, gabor_sand_at, gabor_sand_filtered_at)
    MATERIAL(gabor_brushed_metal, gabor_brushed_metal_filtered, gabor_brushed_metal_default, gabor_brushed_metal_at, gabor_brushed_metal_filtered_at)
    MATERIAL(gabor_scratches, gabor_scratches_filtered, gabor_scratches_default, gabor_scratches_at, gabor_scratches_filtered_at)
    MATERIAL(gabor_zebra, gabor_zebra_filtered, gabor_zebra_default, gabor_zebra_at, gabor_zebra_filtered_at)
    MATERIAL(gabor_bark, gabor_bark_filtered, gabor_bark_default, gabor_bark_at, gabor_bark_filtered_at)
    MATERIAL(gabor_carbon_fibre, gabor_carbon_fibre_filtered, gabor_carbon_fibre_default, gabor_carbon_fibre_at, gabor_carbon_fibre_filtered_at)
    MATERIAL(gabor_strata, gabor_strata_filtered, gabor_strata_default, gabor_strata_at, gabor_strata_filtered_at)
    GaborBoards boards = gabor_boards_default();
    boards.turned_share = 0.5f;
    GaborBoard board = gabor_board(p, vec2(0.0f, 0.0f), vec2(0.0f, 0.0f), period, boards, s.seed);
    GaborBoard blurred = gabor_board(p, dx, dy, vec2(0.0f, 0.0f), boards, s.seed);
    GaborMaterial metal = gabor_brushed_metal(p, s.seed), stone = gabor_marble(p, s.seed);
    SEE(kept(gabor_laid(gabor_wood(board.position, board.seed), board, boards)))
    SEE(kept(gabor_laid(gabor_wood_filtered(blurred.position, blurred.dx, blurred.dy, blurred.seed), blurred, boards)))
    SEE(kept(gabor_covered(metal, stone, 0.002f)))
    SEE(kept(gabor_worn(metal, stone, 0.002f)))
    GaborBoards any = GaborBoards(vec3(drawn(i, 60, 0.0f, 1.0f), drawn(i, 61, 0.0f, 1.0f), drawn(i, 62, 0.0f, 1.0f)),
                                  drawn_to_ends(i, 63, 0.05f, 10.0f), drawn_to_ends(i, 64, 0.05f, 20.0f),
                                  drawn_to_ends(i, 65, 0.0f, 1.0f), drawn_to_ends(i, 66, 0.0f, 1.0f), drawn_to_ends(i, 67, 0.0f, 1.0f),
                                  drawn_to_ends(i, 68, 0.0f, 0.2f), drawn_to_ends(i, 69, 0.0f, 0.2f), drawn_to_ends(i, 72, 0.0f, 0.5f));
    vec2 tile = i % 2 == 0 ? vec2(0.0f, 0.0f) : vec2(drawn(i, 70, 0.1f, 20.0f), drawn(i, 71, 0.1f, 20.0f));
    GaborBoard sharp = gabor_board(p, vec2(0.0f, 0.0f), vec2(0.0f, 0.0f), tile, any, s.seed);
    GaborBoard wide = gabor_board(p, dx, dy, tile, any, s.seed);
    SEE(kept(sharp)) SEE(kept(wide)) SEE(kept(gabor_laid(metal, sharp, any))) SEE(kept(gabor_laid(stone, wide, any)))
    SEE(kept(gabor_covered(metal, stone, 0.0f))) SEE(kept(gabor_worn(stone, metal, 0.1f)))
    GaborCoat coat = gabor_coat_default();
    SEE(kept(gabor_coated(gabor_laid(stone, sharp, any), p, period, sharp.to_edge, coat, s.seed)))
    coat.thickness = 1.0f;
    coat.level = 0.0f;
    SEE(kept(gabor_coated_filtered(metal, p, dx, dy, period, wide.to_edge, coat, s.seed)))
    GaborFinish finish = gabor_finish_default();
    SEE(kept(gabor_finished(stone, p, period, finish, s.seed)))
    finish.dirt_amount = 0.5f;
    finish.dust_amount = 0.3f;
    finish.grain_height = 0.0005f;
    SEE(kept(gabor_finished_filtered(metal, p, dx, dy, period, finish, s.seed)))
#endif
}

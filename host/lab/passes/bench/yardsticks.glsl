// The noises that gabor_noise is compared with, each as an expert would write it for speed. p is in kernel radii, and
// `frequency` in waves per kernel radius: for noises without a direction, the centroid of their power spectrum.
// Perlin, simplex and Gabor noises have mean 0 and variance 1.
//
// docs/benchmark.html times the same code in browsers.

// ---- Hash ----

// 2^32 / g, / g^2 and / g^3 with g^4 = g + 1, whose multiples keep apart [Roberts' R3 sequence]
#define YARDSTICK_COLUMN 0xd1b54a33u
#define YARDSTICK_ROW 0xabc98389u
#define YARDSTICK_SEED 0x8cb92ba7u

uint yardstick_state(ivec2 cell, uint seed) {
    return uint(cell.x) * YARDSTICK_COLUMN + uint(cell.y) * YARDSTICK_ROW + seed * YARDSTICK_SEED;
}

// Mixes with one product of 24-bit numbers, which GPUs compute four times as fast as one of 32-bit numbers.
uint yardstick_word(uint state) {
    state ^= state >> 16u;
    return (state >> 8u) * (state & 0xffffffu);
}

// ---- Perlin's noises ----

// Both components are uniform.
vec2 yardstick_slope(uint word) {
    return vec2(float(int(word) >> 16), float(int(word << 16u) >> 16));
}

// Perlin, "Improving noise", 2002, in two dimensions.
float perlin_noise(vec2 p, float frequency, uint seed) {
    p *= 1.6262871 * frequency; // cells per wave
    vec2 corner = floor(p);
    vec2 f = p - corner;
    vec2 fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    uint state = yardstick_state(ivec2(corner), seed);
    float a = dot(yardstick_slope(yardstick_word(state)), f);
    float b = dot(yardstick_slope(yardstick_word(state + YARDSTICK_COLUMN)), f - vec2(1.0, 0.0));
    float c = dot(yardstick_slope(yardstick_word(state + YARDSTICK_ROW)), f - vec2(0.0, 1.0));
    float d = dot(yardstick_slope(yardstick_word(state + YARDSTICK_COLUMN + YARDSTICK_ROW)), f - vec2(1.0, 1.0));
    return 5.677717 / 32768.0 * mix(mix(a, b, fade.x), mix(c, d, fade.x), fade.y);
}

// (perlin_noise, d/dx, d/dy)
vec3 perlin_noise_gradient(vec2 p, float frequency, uint seed) {
    float cells = 1.6262871 * frequency;
    p *= cells;
    vec2 corner = floor(p);
    vec2 f = p - corner;
    vec2 fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec2 slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    uint state = yardstick_state(ivec2(corner), seed);
    vec2 along_a = yardstick_slope(yardstick_word(state));
    vec2 along_b = yardstick_slope(yardstick_word(state + YARDSTICK_COLUMN));
    vec2 along_c = yardstick_slope(yardstick_word(state + YARDSTICK_ROW));
    vec2 along_d = yardstick_slope(yardstick_word(state + YARDSTICK_COLUMN + YARDSTICK_ROW));
    float a = dot(along_a, f);
    float b = dot(along_b, f - vec2(1.0, 0.0));
    float c = dot(along_c, f - vec2(0.0, 1.0));
    float d = dot(along_d, f - vec2(1.0, 1.0));
    float near = mix(a, b, fade.x);
    float far = mix(c, d, fade.x);
    vec2 along = mix(mix(along_a, along_b, fade.x), mix(along_c, along_d, fade.x), fade.y);
    along += slope * vec2(mix(b - a, d - c, fade.y), far - near);
    return 5.677717 / 32768.0 * vec3(mix(near, far, fade.y), cells * along);
}

vec2 yardstick_product(vec2 a, vec2 b) { // of complex numbers
    return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

vec3 yardstick_octave(vec2 p, vec2 turn, float frequency, uint seed) {
    vec3 noise = perlin_noise_gradient(yardstick_product(turn, p), frequency, seed);
    return vec3(noise.x, yardstick_product(vec2(turn.x, -turn.y), noise.yz));
}

// Five octaves: (value, d/dx, d/dy). Each is turned by 37 degrees from the one before: the factors are the powers of
// 1.6 + 1.2 i. `frequency` is that of the first octave, and `gain` the ratio of the amplitudes of neighbouring octaves.
vec3 perlin_fbm(vec2 p, float frequency, float gain, uint seed) {
    vec3 sum = yardstick_octave(p, vec2(-13.4912, 8.6016), frequency, seed + 4u);
    sum = gain * sum + yardstick_octave(p, vec2(-2.816, 7.488), frequency, seed + 3u);
    sum = gain * sum + yardstick_octave(p, vec2(1.12, 3.84), frequency, seed + 2u);
    sum = gain * sum + yardstick_octave(p, vec2(1.6, 1.2), frequency, seed + 1u);
    sum = gain * sum + perlin_noise_gradient(p, frequency, seed);
    float power = gain * gain;
    return sum * inversesqrt(1.0 + power * (1.0 + power * (1.0 + power * (1.0 + power))));
}

float yardstick_corner(uint state, vec2 offset) {
    float near = max(0.5 - dot(offset, offset), 0.0);
    near *= near;
    return near * near * dot(yardstick_slope(yardstick_word(state)), offset);
}

// Perlin, "Noise hardware", 2001: simplex noise, in two dimensions. Sums the three corners of a triangle.
float simplex_noise(vec2 p, float frequency, uint seed) {
    p *= 0.9806820 * frequency;
    const float skew = 0.36602540; // (sqrt(3) - 1) / 2
    const float back = 0.21132487; // (3 - sqrt(3)) / 6
    vec2 corner = floor(p + skew * (p.x + p.y));
    vec2 f = p - corner + back * (corner.x + corner.y);
    bool right = f.x > f.y;
    vec2 middle = right ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    uint state = yardstick_state(ivec2(corner), seed);
    return 225.41178 / 32768.0
         * (yardstick_corner(state, f)
            + yardstick_corner(state + (right ? YARDSTICK_COLUMN : YARDSTICK_ROW), f - middle + back)
            + yardstick_corner(state + YARDSTICK_COLUMN + YARDSTICK_ROW, f - 1.0 + 2.0 * back));
}

// ---- Sparse convolution ----

// An impulse has one word: 11 bits of its place along each axis, in 2^-32 radii from the middle of its cell, and 10 bits
// of its weight or phase. All three are between -2^31 and 2^31.
vec3 yardstick_impulse(uint word) {
    return vec3(float(int(word)), float(int(word << 11u)), float(int(word << 22u)));
}

uint yardstick_generator(ivec2 cell, uint seed) {
    return yardstick_word(yardstick_state(cell, seed));
}

// The next impulse of a cell.
vec3 yardstick_next(inout uint generator) {
    generator = generator * 747796405u + 2891336453u;
    return yardstick_impulse(generator ^ (generator >> 16u));
}

float yardstick_gaussian(vec2 d) {
    return exp2(-4.5323601 * dot(d, d)); // exp(-pi d^2)
}

vec2 yardstick_wave(float frequency, float orientation) {
    return 6.2831853 * frequency * vec2(cos(orientation), sin(orientation));
}

// Returns a Poisson count. Searches the distribution function from the count `at`, whose probability and cumulative
// probability are these.
int yardstick_poisson(uint generator, float mean, int at, float probability, float cumulative) {
    float share = (float(int(generator >> 16u)) + 0.5) / 65536.0;
    int count = at;
    while (cumulative < share) {
        ++count;
        probability *= mean / float(count);
        cumulative += probability;
    }
    while (cumulative - probability > share) {
        cumulative -= probability;
        probability *= float(count) / mean;
        --count;
    }
    return count;
}

float yardstick_cell(vec2 offset, vec2 wave, uint generator, int count) {
    float sum = 0.0;
    for (int k = 0; k < count; ++k) {
        vec3 impulse = yardstick_next(generator);
        vec2 d = offset - impulse.xy / 4294967296.0;
        if (dot(d, d) < 1.0)
            sum += impulse.z * yardstick_gaussian(d) * cos(dot(wave, d));
    }
    return sum;
}

// Lagae, Lefebvre, Drettakis and Dutre, "Procedural noise using sparse Gabor convolution", 2009, with 30 impulses on
// average in each of 9 cells.
float seminal_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 f = p - corner - 0.5;
    vec2 wave = yardstick_wave(frequency, orientation);
    float sum = 0.0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            int count = yardstick_poisson(generator, 30.0, 30, 0.072634527, 0.54835151);
            sum += yardstick_cell(f - vec2(float(i), float(j)), wave, generator, count);
        }
    }
    return 0.633 / 2147483648.0 * sum;
}

// The same with the density of the authors' code: 64 impulses per disk of a kernel, 20.4 in each cell.
float seminal_183_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 f = p - corner - 0.5;
    vec2 wave = yardstick_wave(frequency, orientation);
    float sum = 0.0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            int count = yardstick_poisson(generator, 20.371833, 20, 0.088532530, 0.52609838);
            sum += yardstick_cell(f - vec2(float(i), float(j)), wave, generator, count);
        }
    }
    return 0.768 / 2147483648.0 * sum;
}

float yardstick_odd_wave(uint state, vec2 offset, vec2 wave) {
    vec3 impulse = yardstick_impulse(yardstick_word(state));
    vec2 d = offset - impulse.xy / 4294967296.0;
    float value = yardstick_gaussian(d) * sin(dot(wave, d));
    return dot(d, d) >= 1.0 ? 0.0 : impulse.z < 0.0 ? -value : value;
}

float yardstick_pair(uint state, vec2 offset, vec2 wave) {
    return yardstick_odd_wave(state, offset, wave) + yardstick_odd_wave(state + 0x732b5e51u, offset, wave);
}

// Tavernier, Neyret, Vergne and Thollot, "Making Gabor noise fast and normalized", 2019. Each of 9 cells has 2 impulses. The
// loop over cells is unrolled by hand, because a compiler that estimates cycles can only guess how often a loop runs.
float advice_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 f = p - corner - 0.5;
    vec2 wave = yardstick_wave(frequency, orientation);
    uint middle = yardstick_state(ivec2(corner), seed);
    uint below = middle - YARDSTICK_ROW;
    uint above = middle + YARDSTICK_ROW;
    float sum = yardstick_pair(below - YARDSTICK_COLUMN, f - vec2(-1.0, -1.0), wave);
    sum += yardstick_pair(below, f - vec2(0.0, -1.0), wave);
    sum += yardstick_pair(below + YARDSTICK_COLUMN, f - vec2(1.0, -1.0), wave);
    sum += yardstick_pair(middle - YARDSTICK_COLUMN, f - vec2(-1.0, 0.0), wave);
    sum += yardstick_pair(middle, f, wave);
    sum += yardstick_pair(middle + YARDSTICK_COLUMN, f - vec2(1.0, 0.0), wave);
    sum += yardstick_pair(above - YARDSTICK_COLUMN, f - vec2(-1.0, 1.0), wave);
    sum += yardstick_pair(above, f - vec2(0.0, 1.0), wave);
    sum += yardstick_pair(above + YARDSTICK_COLUMN, f - vec2(1.0, 1.0), wave);
    return 1.416 * sum;
}

// Gabor noise as 3D packages compute it: a complex sum over 8 impulses in each of 9 cells.
float gabor_72_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 f = p - corner - 0.5;
    vec2 wave = yardstick_wave(frequency, orientation);
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            for (int k = 0; k < 8; ++k) {
                vec3 impulse = yardstick_next(generator);
                vec2 d = f - vec2(float(i), float(j)) - impulse.xy / 4294967296.0;
                if (dot(d, d) < 1.0) {
                    float weight = impulse.z < 0.0 ? -yardstick_gaussian(d) : yardstick_gaussian(d);
                    sum += weight * vec2(cos(dot(wave, d)), sin(dot(wave, d)));
                }
            }
        }
    }
    return 0.708 * sum.y;
}

// Tricard et al., "Procedural phasor noise", 2019: the sine of the phase of a complex sum over 16 impulses in each of 9
// cells. The impulses have random phases.
float phasor_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 f = p - corner - 0.5;
    vec2 wave = yardstick_wave(frequency, orientation);
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            for (int k = 0; k < 16; ++k) {
                vec3 impulse = yardstick_next(generator);
                vec2 d = f - vec2(float(i), float(j)) - impulse.xy / 4294967296.0;
                float angle = dot(wave, d) + 6.2831853 / 4294967296.0 * impulse.z;
                sum += yardstick_gaussian(d) * vec2(cos(angle), sin(angle));
            }
        }
    }
    return sum.y * inversesqrt(max(dot(sum, sum), 1.0e-12));
}

// Stripes from a sum of 16 splats: each of 4 x 4 cells has one, which is a wave around a random point.
float splats_16_noise(vec2 p, float frequency, float orientation, uint seed) {
    p *= 1.5;
    vec2 corner = floor(p);
    vec2 wave = yardstick_wave(frequency / 1.5, orientation);
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int j = -1; j <= 2; ++j) {
        for (int i = -1; i <= 2; ++i) {
            uint word = yardstick_word(yardstick_state(ivec2(corner) + ivec2(i, j), seed));
            vec2 place = vec2(float(int(word & 0xffffu)), float(int(word >> 16u))) / 65536.0;
            vec2 d = p - corner - vec2(float(i), float(j)) - 0.5 * (place - 0.5);
            float weight = max(exp2(-2.8853901 * dot(d, d)) - 0.01111, 0.0); // exp(-2 d^2)
            float angle = dot(wave, d) + 6.2831853 * place.x;
            sum += weight * vec2(cos(angle), sin(angle));
            weights += weight;
        }
    }
    sum /= weights;
    return sum.y * min(2.0, inversesqrt(max(dot(sum, sum), 1.0e-12)));
}

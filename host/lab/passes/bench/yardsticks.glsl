// The noises that gabor_noise is compared with, each written plainly, as a competent author would publish it. p is in
// kernel radii, and `frequency` in waves per kernel radius.
//
// docs/benchmark.html times the same code in browsers.

// ---- Hashes ----

uint yardstick_word(ivec2 cell, uint seed) {
    uint word = uint(cell.x) * 0x9e3779b1u ^ (uint(cell.y) * 0x85ebca6bu + seed);
    word = (word ^ (word >> 16u)) * 0x21f0aaadu;
    word = (word ^ (word >> 15u)) * 0xd35a2d97u;
    return word ^ (word >> 15u);
}

// Returns the next value in [0, 1] of a multiplicative congruential generator.
float yardstick_uniform(inout uint generator) {
    generator *= 3039177861u;
    return float(generator) / 4294967296.0;
}

uint yardstick_generator(ivec2 cell, uint seed) {
    return yardstick_word(cell, seed) | 1u;
}

// ---- Perlin's noises ----

// Returns the dot product of the offset and one of eight gradients.
float yardstick_slope(ivec2 corner, vec2 offset, uint seed) {
    uint word = yardstick_word(corner, seed);
    vec2 along = (word & 1u) == 0u ? offset : offset.yx;
    float u = (word & 2u) == 0u ? along.x : -along.x;
    float v = (word & 4u) == 0u ? along.y : -along.y;
    return u + 0.5 * v;
}

// Perlin, "Improving noise", 2002, in two dimensions. Each wave spans two cells.
float perlin_noise(vec2 p, float frequency, uint seed) {
    p *= 2.0 * frequency;
    vec2 corner = floor(p);
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner;
    vec2 fade = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    float a = yardstick_slope(cell, f, seed);
    float b = yardstick_slope(cell + ivec2(1, 0), f - vec2(1.0, 0.0), seed);
    float c = yardstick_slope(cell + ivec2(0, 1), f - vec2(0.0, 1.0), seed);
    float d = yardstick_slope(cell + ivec2(1, 1), f - vec2(1.0, 1.0), seed);
    return mix(mix(a, b, fade.x), mix(c, d, fade.x), fade.y);
}

float yardstick_corner(ivec2 corner, vec2 offset, uint seed) {
    float near = max(0.5 - dot(offset, offset), 0.0);
    near *= near;
    return near * near * yardstick_slope(corner, offset, seed);
}

// Perlin, "Noise hardware", 2001: simplex noise, in two dimensions. Sums the three corners of a triangle.
float simplex_noise(vec2 p, float frequency, uint seed) {
    p *= 2.0 * frequency;
    const float skew = 0.36602540; // (sqrt(3) - 1) / 2
    const float back = 0.21132487; // (3 - sqrt(3)) / 6
    vec2 corner = floor(p + skew * (p.x + p.y));
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner + back * (corner.x + corner.y);
    vec2 middle = f.x > f.y ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    return 70.0 * (yardstick_corner(cell, f, seed) + yardstick_corner(cell + ivec2(middle), f - middle + back, seed)
                   + yardstick_corner(cell + ivec2(1, 1), f - 1.0 + 2.0 * back, seed));
}

// ---- Sparse convolution ----

int yardstick_poisson(float mean, inout uint generator) { // Knuth's method
    float limit = exp(-mean);
    int count = 0;
    float product = yardstick_uniform(generator);
    while (product > limit) {
        ++count;
        product *= yardstick_uniform(generator);
    }
    return count;
}

// Lagae, Lefebvre, Drettakis and Dutre, "Procedural noise using sparse Gabor convolution", 2009. Each of 9 cells has 30
// impulses on average.
float seminal_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 wave = 6.2831853 * frequency * vec2(cos(orientation), sin(orientation));
    float sum = 0.0;
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            int count = yardstick_poisson(30.0, generator);
            for (int k = 0; k < count; ++k) {
                float x = yardstick_uniform(generator);
                float y = yardstick_uniform(generator);
                float weight = 2.0 * yardstick_uniform(generator) - 1.0;
                vec2 d = p - corner - vec2(float(i) + x, float(j) + y);
                if (dot(d, d) < 1.0)
                    sum += weight * exp(-3.14159265 * dot(d, d)) * cos(dot(wave, d));
            }
        }
    }
    return 0.63305 * sum; // variance 1: 30 impulses, E[weight^2] = 1/3, and the integral of the squared kernel, 0.2495
}

float yardstick_impulse(vec2 offset, vec2 wave, inout uint generator) {
    float x = yardstick_uniform(generator);
    float y = yardstick_uniform(generator);
    float weight = yardstick_uniform(generator) < 0.5 ? -1.0 : 1.0;
    vec2 d = offset - vec2(x, y);
    return dot(d, d) < 1.0 ? weight * exp(-3.14159265 * dot(d, d)) * sin(dot(wave, d)) : 0.0;
}

float yardstick_pair(ivec2 cell, vec2 offset, vec2 wave, uint seed) {
    uint generator = yardstick_generator(cell, seed);
    float first = yardstick_impulse(offset, wave, generator);
    return first + yardstick_impulse(offset, wave, generator);
}

// Tavernier, Neyret, Vergne and Thollot, "Making Gabor noise fast and normalized", 2019. Each of 9 cells has 2 impulses. The
// loop over cells is unrolled by hand, because a compiler that estimates cycles can only guess how often a loop runs.
float advice_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    ivec2 cell = ivec2(corner);
    vec2 f = p - corner;
    vec2 wave = 6.2831853 * frequency * vec2(cos(orientation), sin(orientation));
    float sum = yardstick_pair(cell + ivec2(-1, -1), f - vec2(-1.0, -1.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(0, -1), f - vec2(0.0, -1.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(1, -1), f - vec2(1.0, -1.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(-1, 0), f - vec2(-1.0, 0.0), wave, seed);
    sum += yardstick_pair(cell, f, wave, seed);
    sum += yardstick_pair(cell + ivec2(1, 0), f - vec2(1.0, 0.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(-1, 1), f - vec2(-1.0, 1.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(0, 1), f - vec2(0.0, 1.0), wave, seed);
    sum += yardstick_pair(cell + ivec2(1, 1), f - vec2(1.0, 1.0), wave, seed);
    return 1.41553 * sum;
}

// Gabor noise as 3D packages compute it: a complex sum over 8 impulses in each of 9 cells.
float gabor_72_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 wave = 6.2831853 * frequency * vec2(cos(orientation), sin(orientation));
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            for (int k = 0; k < 8; ++k) {
                float x = yardstick_uniform(generator);
                float y = yardstick_uniform(generator);
                float weight = yardstick_uniform(generator) < 0.5 ? -1.0 : 1.0;
                vec2 d = p - corner - vec2(float(i) + x, float(j) + y);
                if (dot(d, d) < 1.0)
                    sum += weight * exp(-3.14159265 * dot(d, d)) * vec2(cos(dot(wave, d)), sin(dot(wave, d)));
            }
        }
    }
    return 0.70777 * sum.y;
}

// Tricard et al., "Procedural phasor noise", 2019: the sine of the phase of a complex sum over 16 impulses in each of 9
// cells. The impulses have random phases.
float phasor_noise(vec2 p, float frequency, float orientation, uint seed) {
    vec2 corner = floor(p);
    vec2 wave = 6.2831853 * frequency * vec2(cos(orientation), sin(orientation));
    vec2 sum = vec2(0.0);
    for (int j = -1; j <= 1; ++j) {
        for (int i = -1; i <= 1; ++i) {
            uint generator = yardstick_generator(ivec2(corner) + ivec2(i, j), seed);
            for (int k = 0; k < 16; ++k) {
                float x = yardstick_uniform(generator);
                float y = yardstick_uniform(generator);
                float phase = 6.2831853 * yardstick_uniform(generator);
                vec2 d = p - corner - vec2(float(i) + x, float(j) + y);
                float angle = dot(wave, d) + phase;
                sum += exp(-3.14159265 * dot(d, d)) * vec2(cos(angle), sin(angle));
            }
        }
    }
    return sum.y * inversesqrt(max(dot(sum, sum), 1.0e-12));
}

// Stripes from a sum of 16 splats: each of 4 x 4 cells has one, which is a wave around a random point.
float splats_16_noise(vec2 p, float frequency, float orientation, uint seed) {
    p *= 1.5;
    vec2 corner = floor(p);
    vec2 wave = 6.2831853 / 1.5 * frequency * vec2(cos(orientation), sin(orientation));
    vec2 sum = vec2(0.0);
    float weights = 0.0;
    for (int j = -1; j <= 2; ++j) {
        for (int i = -1; i <= 2; ++i) {
            uint word = yardstick_word(ivec2(corner) + ivec2(i, j), seed);
            vec2 place = vec2(float(word & 0xffffu), float(word >> 16u)) / 65536.0;
            vec2 d = p - corner - vec2(float(i), float(j)) - 0.5 * (place - 0.5);
            float weight = max(exp(-2.0 * dot(d, d)) - 0.01111, 0.0);
            float angle = dot(wave, d) + 6.2831853 * place.x;
            sum += weight * vec2(cos(angle), sin(angle));
            weights += weight;
        }
    }
    sum /= weights;
    return sum.y * min(2.0, inversesqrt(max(dot(sum, sum), 1.0e-12)));
}

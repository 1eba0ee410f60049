#version 450
#extension GL_GOOGLE_include_directive : require

// Draws a whole picture faster than pixel by pixel: each invocation fills a block of pixels that use the same cells.
//
// In the sparse noise, the kernel of impulse c at (x_c, y_c) is separable as a complex number, and n(x, y) is the imaginary
// part of
//
//     sum_c [K w_c q(x - x_c) e^(2 pi i (F.x (x - x_c) + F.y (y_0 - y_c) + phase_c))] q(y - y_c) e^(2 pi i F.y (y - y_0))
//
// where y_0 is the block's first row. The bracket is computed once per column of the block, and q(y - y_c) once per row. The
// last factor, which all impulses share, multiplies the sum once per pixel. Exponentials at evenly spaced positions follow
// from the first by rotation. In derivatives, q' replaces q, and the wave contributes a factor of 2 pi i F.
//
// In the lattice, the nodes of a row share y_c and q(y - y_c). So c counts rows there, and the bracket is summed over a row.
//
// A slice of solid noise with waves in its plane is also plane noise. Its amplitudes are sums over three nodes along z, each
// times its window.
//
// A spectrum is a sum of such noises, which are added to the picture one after another. For a colour picture there are three
// sums, its components, which passes/bake_colour.comp turns into colours.
//
// To use this pass in an engine, cut columns and rows into runs and set the push constants as host/render/plan/bake.cpp does.

#include "passes/bake_interface.h"
#include "noise_channels.glsl"
#include "recipe.glsl"
#if GABOR_TAPS == 3
#include "gabor_noise_3d.glsl"
#endif

layout(constant_id = visited_id) const int visited = 3; // cells along an axis, ceil(2 R) + 1
layout(constant_id = block_columns_id) const int block_columns = 8;
layout(constant_id = fixed_rows_id) const int fixed_rows = 0; // number of rows if their loop is unrolled, else 0
layout(constant_id = animated_id) const bool animated = false;        // whether time is not 0, for the lattice
layout(constant_id = sum_id) const bool sum = false;             // whether there is more than one noise
layout(constant_id = few_waves_id) const int few_waves = 0; // 1 if this dispatch adds only one noise
layout(constant_id = tiled_id) const bool tiled = false; // whether opposite edges match; divisions make this slow on CPUs
layout(constant_id = view_id) const uint view = view_flat;
const bool slice = view == view_slice; // whether to draw a slice of solid noise, with GABOR_TAPS 3
#ifdef GABOR_TAPS
const int terms = GABOR_TAPS; // rows of nodes
#else
const int terms = visited * visited * recipe_impulses; // impulses
#endif

const bool with_gradient = gradient_at >= 0;
vec2 cell_side = 1.0 / radius;
ivec2 wrap = tiled ? period : ivec2(0);

layout(local_size_x = bake_group) in;

layout(std430, set = 0, binding = 1) readonly buffer Columns { Run columns[]; };
layout(std430, set = 0, binding = 2) readonly buffer Rows { Run rows[]; };
layout(std430, set = 0, binding = 3) readonly buffer Waves { BakeWave waves[]; };
layout(std430, set = 0, binding = 0) buffer Picture { float picture[]; };

// The state of a block, with c from 0 to terms - 1 and k from 0 to block_columns - 1.
vec2 bracket[terms * block_columns];       // the formula's bracket [c, k] of impulses or rows of nodes c in column k
vec2 bracket_slope[terms * block_columns]; // the same with q' instead of q
vec2 envelope[block_columns];              // all factors of the formula but the last, in each column of the row
vec2 slope_x[block_columns];               // the same for the part of the derivatives that comes from the windows
vec2 slope_y[block_columns];

vec2 rotated(vec2 z, vec2 by) {
    return vec2(z.x * by.x - z.y * by.y, z.x * by.y + z.y * by.x);
}

void clear_row() {
    [[unroll]] for (int k = 0; k < block_columns; ++k) {
        envelope[k] = vec2(0.0);
        slope_x[k] = vec2(0.0);
        slope_y[k] = vec2(0.0);
    }
}

// Adds term c to each column of the row, where q is q(y - y_c) and q'(y - y_c).
void add_term(int c, vec2 q) {
    [[unroll]] for (int k = 0; k < block_columns; ++k) {
        envelope[k] += q.x * bracket[c * block_columns + k];
        if (with_gradient) {
            slope_x[k] += q.x * bracket_slope[c * block_columns + k];
            slope_y[k] += q.y * bracket[c * block_columns + k];
        }
    }
}

#ifdef GABOR_TAPS

// The nodes along z that reach the slice: a word and a factor for each.
struct Depth {
    uint word[3];
    float factor[3];
};

Depth depth_of(uint salt) {
    Depth depth;
#if GABOR_TAPS == 3
    if (slice) {
        vec4 windows;
        vec4 slopes;
        gabor_impl_windows(slice_offset, windows, slopes);
        [[unroll]] for (int i = 0; i < 3; ++i) {
            depth.word[i] = gabor_impl_line_word(first_slice + i, salt ^ GABOR_IMPL_SLICES);
            depth.factor[i] = inversesqrt(GABOR_IMPL_ENERGY) * windows[i];
        }
    }
#endif
    return depth;
}

vec2 node_amplitude(uint column, uint row, Depth depth) {
#if GABOR_TAPS == 3
    if (slice) {
        vec2 sum = vec2(0.0);
        [[unroll]] for (int i = 0; i < 3; ++i) {
            uint word = column * gabor_impl_slice_word(row, depth.word[i]);
            sum += depth.factor[i] * gabor_impl_amplitude_at(word, animated ? time : 0.0);
        }
        return sum;
    }
#endif
    return gabor_impl_amplitude_at(column * row, animated ? time : 0.0);
}

// The waves of the nodes of row c at the block's first pixel.
void set_nodes(out vec2 node[GABOR_TAPS], int c, Run across, Run down, BakeWave wave, uint salt, Depth depth) {
    uint row_word = gabor_impl_line_word(gabor_impl_wrap(down.cell + 1 + c, wrap.y), salt ^ GABOR_IMPL_ROWS);
    [[unroll]] for (int i = 0; i < GABOR_TAPS; ++i) {
        uint column_word = gabor_impl_line_word(gabor_impl_wrap(across.cell + 1 + i, wrap.x), salt);
        float turns = dot(wave.wave, (vec2(across.local, down.local) - vec2(i, c)) * cell_side);
        vec2 a = node_amplitude(column_word, row_word, depth);
        node[i] = wave.amplitude / (GABOR_IMPL_DEVIATION * GABOR_IMPL_ENERGY) * rotated(a, gabor_impl_wave(turns));
    }
}

void set_brackets(Run across, Run down, BakeWave wave) {
    vec4 windows[block_columns];
    vec4 slopes[block_columns];
    vec2 turned[block_columns]; // e^(2 pi i F.x (x - x_0)), x_0 the first column
    [[unroll]] for (int k = 0; k < block_columns; ++k) {
        gabor_impl_windows(across.local + float(k) * pixel.x * radius.x - 1.0, windows[k], slopes[k]);
        slopes[k] *= radius.x / GABOR_CELLS_PER_RADIUS;
        turned[k] = k == 0 ? vec2(1.0, 0.0) : rotated(turned[k - 1], wave.column_turn);
    }
    uint salt = gabor_impl_salt(wave.seed);
    Depth depth = depth_of(salt);
    [[unroll]] for (int c = 0; c < terms; ++c) {
        vec2 node[GABOR_TAPS];
        set_nodes(node, c, across, down, wave, salt, depth);
        [[unroll]] for (int k = 0; k < block_columns; ++k) {
            vec2 sum = vec2(0.0);
            vec2 slope = vec2(0.0);
            [[unroll]] for (int i = 0; i < GABOR_TAPS; ++i) {
                sum += windows[k][i] * node[i];
                slope += slopes[k][i] * node[i];
            }
            bracket[c * block_columns + k] = rotated(sum, turned[k]);
            if (with_gradient)
                bracket_slope[c * block_columns + k] = rotated(slope, turned[k]);
        }
    }
}

void sum_row(float row, Run down) {
    vec4 windows;
    vec4 slopes;
    gabor_impl_windows(down.local + row * pixel.y * radius.y - 1.0, windows, slopes);
    clear_row();
    [[unroll]] for (int c = 0; c < terms; ++c)
        add_term(c, vec2(windows[c], slopes[c] * (radius.y / GABOR_CELLS_PER_RADIUS)));
}

#else

float distance_y[terms]; // distance of each impulse from the block's first row

void set_brackets(Run across, Run down, BakeWave wave) {
    uint seed_word = gabor_impl_seed_word(wave.seed);
    [[unroll]] for (int c = 0; c < terms; ++c) {
        ivec2 offset = ivec2(c / recipe_impulses % visited, c / (recipe_impulses * visited));
        uint row_word = gabor_impl_row_word(gabor_impl_wrap(down.cell + offset.y, wrap.y), seed_word);
        uint word = gabor_impl_impulse_word(gabor_impl_wrap(across.cell + offset.x, wrap.x), row_word, c % recipe_impulses);
        GaborImplImpulse impulse = gabor_impl_impulse(word);
        vec2 d = (vec2(across.local, down.local) - (impulse.position_plus_one + (vec2(offset) - 2.0))) * cell_side;
        float turns = dot(wave.wave, d) + impulse.phase + impulse.phase_rate * time;
        vec2 z = wave.amplitude * impulse.magnitude * vec2(gabor_impl_sine(turns + 0.25), gabor_impl_sine(turns));
        distance_y[c] = d.y;
        [[unroll]] for (int k = 0; k < block_columns; ++k) {
            vec2 q = gabor_impl_window(d.x + float(k) * pixel.x);
            bracket[c * block_columns + k] = z * q.x;
            if (with_gradient)
                bracket_slope[c * block_columns + k] = z * q.y;
            z = rotated(z, wave.column_turn);
        }
    }
}

void sum_row(float row, Run down) {
    clear_row();
    [[unroll]] for (int c = 0; c < terms; ++c)
        add_term(c, gabor_impl_window(distance_y[c] + row * pixel.y));
}

#endif

// Writes a channel of the first noise; adds the channels of further noises.
void put(int at, float value, uint index) {
    if (sum && index > 0u)
        value += picture[at];
    picture[at] = value;
}

void put_pixel(int at, vec2 value, vec2 slopes, BakeWave wave, uint index) {
    if (coloured) {
        [[unroll]] for (int i = 0; i < 3; ++i)
            put(at + i, dot(wave.weights[i], value), index);
    } else {
        put(at, value.y, index);
    }
    if (quadrature_at >= 0)
        put(at + quadrature_at, value.x, index);
    if (with_gradient) {
        slopes = stretch * (slopes + 6.2831853 * wave.wave * value.x);
        put(at + gradient_at, slopes.x, index);
        put(at + gradient_at + 1, slopes.y, index);
    }
    if (slice)
        picture[at + coverage_at] = 1.0;
}

// `carrier`: the last factor of the formula. `start`: the index of the block's first pixel in this row.
void put_row(Run across, int start, vec2 carrier, BakeWave wave, uint index) {
    [[unroll]] for (int k = 0; k < block_columns; ++k) {
        if (k >= across.count || across.first + k < 0 || across.first + k >= width)
            continue;
        vec2 slopes = vec2(rotated(slope_x[k], carrier).y, rotated(slope_y[k], carrier).y);
        put_pixel((start + k) * channels, rotated(envelope[k], carrier), slopes, wave, index);
    }
}

void fill(Run across, Run down, uint index) {
    BakeWave wave = waves[index];
    set_brackets(across, down, wave);
    vec2 carrier = vec2(1.0, 0.0);
    int row = down.first - first_row;
    int row_count = fixed_rows > 0 ? fixed_rows : down.count;
    [[unroll]] for (int r = 0; r < row_count; ++r) {
        sum_row(float(r), down);
        if (row >= 0 && row < height)
            put_row(across, before + row * width + across.first, carrier, wave, index);
        carrier = rotated(carrier, wave.row_turn);
        ++row;
    }
}

void main() {
    // Without an early return, lavapipe loads the wave once instead of once for each invocation.
    Run across = columns[first_column_run + min(gl_GlobalInvocationID.x, column_runs - 1u)];
    if (gl_GlobalInvocationID.x >= column_runs)
        across.count = 0;
    Run down = rows[first_run + gl_GlobalInvocationID.y];
    if (few_waves == 1) { // no loop, because compilers would keep a loop of one iteration
        fill(across, down, first_wave);
    } else {
        for (uint i = 0u; i < wave_count; ++i)
            fill(across, down, first_wave + i);
    }
}

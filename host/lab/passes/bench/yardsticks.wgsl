// Generated from yardsticks.glsl by tools/translate and naga: change that file, not this one.

fn yardstick_word(cell: vec2<i32>, seed: u32) -> u32 {
    var word: u32;

    word = ((u32(cell.x) * 2654435761u) ^ ((u32(cell.y) * 2246822507u) + seed));
    let _e13 = word;
    let _e14 = word;
    word = ((_e13 ^ (_e14 >> 16u)) * 569420461u);
    let _e20 = word;
    let _e21 = word;
    word = ((_e20 ^ (_e21 >> 15u)) * 3545902487u);
    let _e27 = word;
    let _e28 = word;
    return (_e27 ^ (_e28 >> 15u));
}

// Returns the next value in [0, 1] of a multiplicative congruential generator.
fn yardstick_uniform(generator: ptr<function, u32>) -> f32 {
    let _e1 = (*generator);
    (*generator) = (_e1 * 3039177861u);
    let _e4 = (*generator);
    return (f32(_e4) / 4294967300f);
}

fn yardstick_generator(cell: vec2<i32>, seed: u32) -> u32 {
    let _e2 = yardstick_word(cell, seed);
    return (_e2 | 1u);
}

// Returns the dot product of the offset and one of eight gradients.
fn yardstick_slope(corner: vec2<i32>, offset: vec2<f32>, seed: u32) -> f32 {
    var word_1: u32;
    var local: vec2<f32>;
    var along: vec2<f32>;
    var local_1: f32;
    var u: f32;
    var local_2: f32;
    var v: f32;

    let _e3 = yardstick_word(corner, seed);
    word_1 = _e3;
    let _e5 = word_1;
    if ((_e5 & 1u) == 0u) {
        local = offset;
    } else {
        local = offset.yx;
    }
    let _e12 = local;
    along = _e12;
    let _e14 = word_1;
    if ((_e14 & 2u) == 0u) {
        let _e19 = along;
        local_1 = _e19.x;
    } else {
        let _e21 = along;
        local_1 = -(_e21.x);
    }
    let _e25 = local_1;
    u = _e25;
    let _e27 = word_1;
    if ((_e27 & 4u) == 0u) {
        let _e32 = along;
        local_2 = _e32.y;
    } else {
        let _e34 = along;
        local_2 = -(_e34.y);
    }
    let _e38 = local_2;
    v = _e38;
    let _e40 = u;
    let _e42 = v;
    return (_e40 + (0.5f * _e42));
}

// Perlin, "Improving noise", 2002, in two dimensions. Each wave spans two cells.
fn perlin_noise(p: vec2<f32>, frequency: f32, seed: u32) -> f32 {
    var p_1: vec2<f32>;
    var corner_1: vec2<f32>;
    var cell_2: vec2<i32>;
    var f: vec2<f32>;
    var fade: vec2<f32>;
    var a: f32;
    var b: f32;
    var c: f32;
    var d: f32;

    p_1 = p;
    let _e4 = p_1;
    p_1 = (_e4 * (2f * frequency));
    let _e8 = p_1;
    corner_1 = floor(_e8);
    let _e11 = corner_1;
    cell_2 = vec2<i32>(_e11);
    let _e14 = p_1;
    let _e15 = corner_1;
    f = (_e14 - _e15);
    let _e18 = f;
    let _e19 = f;
    let _e21 = f;
    let _e23 = f;
    let _e24 = f;
    fade = (((_e18 * _e19) * _e21) * ((_e23 * ((_e24 * 6f) - vec2(15f))) + vec2(10f)));
    let _e36 = cell_2;
    let _e37 = f;
    let _e38 = yardstick_slope(_e36, _e37, seed);
    a = _e38;
    let _e40 = cell_2;
    let _e45 = f;
    let _e50 = yardstick_slope((_e40 + vec2<i32>(1i, 0i)), (_e45 - vec2<f32>(1f, 0f)), seed);
    b = _e50;
    let _e52 = cell_2;
    let _e57 = f;
    let _e62 = yardstick_slope((_e52 + vec2<i32>(0i, 1i)), (_e57 - vec2<f32>(0f, 1f)), seed);
    c = _e62;
    let _e64 = cell_2;
    let _e69 = f;
    let _e74 = yardstick_slope((_e64 + vec2<i32>(1i, 1i)), (_e69 - vec2<f32>(1f, 1f)), seed);
    d = _e74;
    let _e76 = a;
    let _e77 = b;
    let _e78 = fade;
    let _e81 = c;
    let _e82 = d;
    let _e83 = fade;
    let _e86 = fade;
    return mix(mix(_e76, _e77, _e78.x), mix(_e81, _e82, _e83.x), _e86.y);
}

fn yardstick_corner(corner: vec2<i32>, offset: vec2<f32>, seed: u32) -> f32 {
    var near: f32;

    near = max((0.5f - dot(offset, offset)), 0f);
    let _e9 = near;
    let _e10 = near;
    near = (_e9 * _e10);
    let _e12 = near;
    let _e13 = near;
    let _e15 = yardstick_slope(corner, offset, seed);
    return ((_e12 * _e13) * _e15);
}

// Perlin, "Noise hardware", 2001: simplex noise, in two dimensions. Sums the three corners of a triangle.
fn simplex_noise(p: vec2<f32>, frequency: f32, seed: u32) -> f32 {
    var p_3: vec2<f32>;
    var skew: f32 = 0.3660254f;
    var back: f32 = 0.21132487f;
    var corner_3: vec2<f32>;
    var cell_3: vec2<i32>;
    var f_1: vec2<f32>;
    var local_3: vec2<f32>;
    var middle: vec2<f32>;

    p_3 = p;
    let _e4 = p_3;
    p_3 = (_e4 * (2f * frequency));
    let _e12 = p_3;
    let _e13 = skew;
    let _e14 = p_3;
    let _e16 = p_3;
    corner_3 = floor((_e12 + vec2((_e13 * (_e14.x + _e16.y)))));
    let _e24 = corner_3;
    cell_3 = vec2<i32>(_e24);
    let _e27 = p_3;
    let _e28 = corner_3;
    let _e30 = back;
    let _e31 = corner_3;
    let _e33 = corner_3;
    f_1 = ((_e27 - _e28) + vec2((_e30 * (_e31.x + _e33.y))));
    let _e40 = f_1;
    let _e42 = f_1;
    if (_e40.x > _e42.y) {
        local_3 = vec2<f32>(1f, 0f);
    } else {
        local_3 = vec2<f32>(0f, 1f);
    }
    let _e52 = local_3;
    middle = _e52;
    let _e55 = cell_3;
    let _e56 = f_1;
    let _e57 = yardstick_corner(_e55, _e56, seed);
    let _e58 = cell_3;
    let _e59 = middle;
    let _e62 = f_1;
    let _e63 = middle;
    let _e65 = back;
    let _e68 = yardstick_corner((_e58 + vec2<i32>(_e59)), ((_e62 - _e63) + vec2(_e65)), seed);
    let _e70 = cell_3;
    let _e75 = f_1;
    let _e80 = back;
    let _e84 = yardstick_corner((_e70 + vec2<i32>(1i, 1i)), ((_e75 - vec2(1f)) + vec2((2f * _e80))), seed);
    return (70f * ((_e57 + _e68) + _e84));
}

fn yardstick_poisson(mean: f32, generator: ptr<function, u32>) -> i32 {
    var limit: f32;
    var count: i32 = 0i;
    var product: f32;

    limit = exp(-(mean));
    let _e9 = yardstick_uniform(generator);
    product = _e9;
    loop {
        let _e11 = product;
        let _e12 = limit;
        if !((_e11 > _e12)) {
            break;
        }
        {
            let _e15 = count;
            count = (_e15 + 1i);
            let _e18 = product;
            let _e21 = yardstick_uniform(generator);
            product = (_e18 * _e21);
        }
    }
    let _e23 = count;
    return _e23;
}

// Lagae, Lefebvre, Drettakis and Dutre, "Procedural noise using sparse Gabor convolution", 2009. Each of 9 cells has 30
// impulses on average.
fn seminal_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var corner_4: vec2<f32>;
    var wave: vec2<f32>;
    var sum: f32 = 0f;
    var j: i32 = -1i;
    var i: i32;
    var generator_2: u32;
    var count_1: i32;
    var k: i32;
    var x: f32;
    var y: f32;
    var weight: f32;
    var d_1: vec2<f32>;

    corner_4 = floor(p);
    wave = ((6.2831855f * frequency) * vec2<f32>(cos(orientation), sin(orientation)));
    loop {
        let _e18 = j;
        if !((_e18 <= 1i)) {
            break;
        }
        {
            i = -1i;
            loop {
                let _e28 = i;
                if !((_e28 <= 1i)) {
                    break;
                }
                {
                    let _e35 = corner_4;
                    let _e37 = i;
                    let _e38 = j;
                    let _e41 = yardstick_generator((vec2<i32>(_e35) + vec2<i32>(_e37, _e38)), seed);
                    generator_2 = _e41;
                    let _e46 = yardstick_poisson(30f, (&generator_2));
                    count_1 = _e46;
                    k = 0i;
                    loop {
                        let _e50 = k;
                        let _e51 = count_1;
                        if !((_e50 < _e51)) {
                            break;
                        }
                        {
                            let _e59 = yardstick_uniform((&generator_2));
                            x = _e59;
                            let _e63 = yardstick_uniform((&generator_2));
                            y = _e63;
                            let _e68 = yardstick_uniform((&generator_2));
                            weight = ((2f * _e68) - 1f);
                            let _e73 = corner_4;
                            let _e75 = i;
                            let _e77 = x;
                            let _e79 = j;
                            let _e81 = y;
                            d_1 = ((p - _e73) - vec2<f32>((f32(_e75) + _e77), (f32(_e79) + _e81)));
                            let _e86 = d_1;
                            let _e87 = d_1;
                            if (dot(_e86, _e87) < 1f) {
                                let _e91 = sum;
                                let _e92 = weight;
                                let _e95 = d_1;
                                let _e96 = d_1;
                                let _e101 = wave;
                                let _e102 = d_1;
                                sum = (_e91 + ((_e92 * exp((-3.1415927f * dot(_e95, _e96)))) * cos(dot(_e101, _e102))));
                            }
                        }
                        continuing {
                            let _e54 = k;
                            k = (_e54 + 1i);
                        }
                    }
                }
                continuing {
                    let _e32 = i;
                    i = (_e32 + 1i);
                }
            }
        }
        continuing {
            let _e22 = j;
            j = (_e22 + 1i);
        }
    }
    let _e108 = sum;
    return (0.634f * _e108);
}

fn yardstick_impulse(offset: vec2<f32>, wave: vec2<f32>, generator: ptr<function, u32>) -> f32 {
    var x_1: f32;
    var y_1: f32;
    var local_4: f32;
    var weight_1: f32;
    var d_2: vec2<f32>;
    var local_5: f32;

    let _e5 = yardstick_uniform(generator);
    x_1 = _e5;
    let _e9 = yardstick_uniform(generator);
    y_1 = _e9;
    let _e13 = yardstick_uniform(generator);
    if (_e13 < 0.5f) {
        local_4 = -1f;
    } else {
        local_4 = 1f;
    }
    let _e20 = local_4;
    weight_1 = _e20;
    let _e22 = x_1;
    let _e23 = y_1;
    d_2 = (offset - vec2<f32>(_e22, _e23));
    let _e27 = d_2;
    let _e28 = d_2;
    if (dot(_e27, _e28) < 1f) {
        let _e32 = weight_1;
        let _e35 = d_2;
        let _e36 = d_2;
        let _e41 = d_2;
        local_5 = ((_e32 * exp((-3.1415927f * dot(_e35, _e36)))) * sin(dot(wave, _e41)));
    } else {
        local_5 = 0f;
    }
    let _e47 = local_5;
    return _e47;
}

fn yardstick_pair(cell: vec2<i32>, offset: vec2<f32>, wave: vec2<f32>, seed: u32) -> f32 {
    var generator_4: u32;
    var first: f32;

    let _e4 = yardstick_generator(cell, seed);
    generator_4 = _e4;
    let _e8 = yardstick_impulse(offset, wave, (&generator_4));
    first = _e8;
    let _e10 = first;
    let _e13 = yardstick_impulse(offset, wave, (&generator_4));
    return (_e10 + _e13);
}

// Tavernier, Neyret, Vergne and Thollot, "Making Gabor noise fast and normalized", 2019. Each of 9 cells has 2 impulses. The
// loop over cells is unrolled by hand, because a compiler that estimates cycles can only guess how often a loop runs.
fn advice_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var corner_5: vec2<f32>;
    var cell_5: vec2<i32>;
    var f_2: vec2<f32>;
    var wave_3: vec2<f32>;
    var sum_1: f32;

    corner_5 = floor(p);
    let _e6 = corner_5;
    cell_5 = vec2<i32>(_e6);
    let _e9 = corner_5;
    f_2 = (p - _e9);
    wave_3 = ((6.2831855f * frequency) * vec2<f32>(cos(orientation), sin(orientation)));
    let _e19 = cell_5;
    let _e26 = f_2;
    let _e33 = wave_3;
    let _e34 = yardstick_pair((_e19 + vec2<i32>(-1i, -1i)), (_e26 - vec2<f32>(-1f, -1f)), _e33, seed);
    sum_1 = _e34;
    let _e36 = sum_1;
    let _e37 = cell_5;
    let _e43 = f_2;
    let _e49 = wave_3;
    let _e50 = yardstick_pair((_e37 + vec2<i32>(0i, -1i)), (_e43 - vec2<f32>(0f, -1f)), _e49, seed);
    sum_1 = (_e36 + _e50);
    let _e52 = sum_1;
    let _e53 = cell_5;
    let _e59 = f_2;
    let _e65 = wave_3;
    let _e66 = yardstick_pair((_e53 + vec2<i32>(1i, -1i)), (_e59 - vec2<f32>(1f, -1f)), _e65, seed);
    sum_1 = (_e52 + _e66);
    let _e68 = sum_1;
    let _e69 = cell_5;
    let _e75 = f_2;
    let _e81 = wave_3;
    let _e82 = yardstick_pair((_e69 + vec2<i32>(-1i, 0i)), (_e75 - vec2<f32>(-1f, 0f)), _e81, seed);
    sum_1 = (_e68 + _e82);
    let _e84 = sum_1;
    let _e85 = cell_5;
    let _e86 = f_2;
    let _e87 = wave_3;
    let _e88 = yardstick_pair(_e85, _e86, _e87, seed);
    sum_1 = (_e84 + _e88);
    let _e90 = sum_1;
    let _e91 = cell_5;
    let _e96 = f_2;
    let _e101 = wave_3;
    let _e102 = yardstick_pair((_e91 + vec2<i32>(1i, 0i)), (_e96 - vec2<f32>(1f, 0f)), _e101, seed);
    sum_1 = (_e90 + _e102);
    let _e104 = sum_1;
    let _e105 = cell_5;
    let _e111 = f_2;
    let _e117 = wave_3;
    let _e118 = yardstick_pair((_e105 + vec2<i32>(-1i, 1i)), (_e111 - vec2<f32>(-1f, 1f)), _e117, seed);
    sum_1 = (_e104 + _e118);
    let _e120 = sum_1;
    let _e121 = cell_5;
    let _e126 = f_2;
    let _e131 = wave_3;
    let _e132 = yardstick_pair((_e121 + vec2<i32>(0i, 1i)), (_e126 - vec2<f32>(0f, 1f)), _e131, seed);
    sum_1 = (_e120 + _e132);
    let _e134 = sum_1;
    let _e135 = cell_5;
    let _e140 = f_2;
    let _e145 = wave_3;
    let _e146 = yardstick_pair((_e135 + vec2<i32>(1i, 1i)), (_e140 - vec2<f32>(1f, 1f)), _e145, seed);
    sum_1 = (_e134 + _e146);
    let _e149 = sum_1;
    return (1.416f * _e149);
}

// Gabor noise as 3D packages compute it: a complex sum over 8 impulses in each of 9 cells.
fn gabor_72_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var corner_6: vec2<f32>;
    var wave_4: vec2<f32>;
    var sum_2: vec2<f32> = vec2(0f);
    var j_1: i32 = -1i;
    var i_1: i32;
    var generator_5: u32;
    var k_1: i32;
    var x_2: f32;
    var y_2: f32;
    var local_6: f32;
    var weight_2: f32;
    var d_3: vec2<f32>;

    corner_6 = floor(p);
    wave_4 = ((6.2831855f * frequency) * vec2<f32>(cos(orientation), sin(orientation)));
    loop {
        let _e19 = j_1;
        if !((_e19 <= 1i)) {
            break;
        }
        {
            i_1 = -1i;
            loop {
                let _e29 = i_1;
                if !((_e29 <= 1i)) {
                    break;
                }
                {
                    let _e36 = corner_6;
                    let _e38 = i_1;
                    let _e39 = j_1;
                    let _e42 = yardstick_generator((vec2<i32>(_e36) + vec2<i32>(_e38, _e39)), seed);
                    generator_5 = _e42;
                    k_1 = 0i;
                    loop {
                        let _e46 = k_1;
                        if !((_e46 < 8i)) {
                            break;
                        }
                        {
                            let _e55 = yardstick_uniform((&generator_5));
                            x_2 = _e55;
                            let _e59 = yardstick_uniform((&generator_5));
                            y_2 = _e59;
                            let _e63 = yardstick_uniform((&generator_5));
                            if (_e63 < 0.5f) {
                                local_6 = -1f;
                            } else {
                                local_6 = 1f;
                            }
                            let _e70 = local_6;
                            weight_2 = _e70;
                            let _e72 = corner_6;
                            let _e74 = i_1;
                            let _e76 = x_2;
                            let _e78 = j_1;
                            let _e80 = y_2;
                            d_3 = ((p - _e72) - vec2<f32>((f32(_e74) + _e76), (f32(_e78) + _e80)));
                            let _e85 = d_3;
                            let _e86 = d_3;
                            if (dot(_e85, _e86) < 1f) {
                                let _e90 = sum_2;
                                let _e91 = weight_2;
                                let _e94 = d_3;
                                let _e95 = d_3;
                                let _e100 = wave_4;
                                let _e101 = d_3;
                                let _e104 = wave_4;
                                let _e105 = d_3;
                                sum_2 = (_e90 + ((_e91 * exp((-3.1415927f * dot(_e94, _e95)))) * vec2<f32>(cos(dot(_e100, _e101)), sin(dot(_e104, _e105)))));
                            }
                        }
                        continuing {
                            let _e50 = k_1;
                            k_1 = (_e50 + 1i);
                        }
                    }
                }
                continuing {
                    let _e33 = i_1;
                    i_1 = (_e33 + 1i);
                }
            }
        }
        continuing {
            let _e23 = j_1;
            j_1 = (_e23 + 1i);
        }
    }
    let _e112 = sum_2;
    return (0.708f * _e112.y);
}

// Tricard et al., "Procedural phasor noise", 2019: the sine of the phase of a complex sum over 16 impulses in each of 9
// cells. The impulses have random phases.
fn phasor_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var corner_7: vec2<f32>;
    var wave_5: vec2<f32>;
    var sum_3: vec2<f32> = vec2(0f);
    var j_2: i32 = -1i;
    var i_2: i32;
    var generator_6: u32;
    var k_2: i32;
    var x_3: f32;
    var y_3: f32;
    var phase: f32;
    var d_4: vec2<f32>;
    var angle: f32;

    corner_7 = floor(p);
    wave_5 = ((6.2831855f * frequency) * vec2<f32>(cos(orientation), sin(orientation)));
    loop {
        let _e19 = j_2;
        if !((_e19 <= 1i)) {
            break;
        }
        {
            i_2 = -1i;
            loop {
                let _e29 = i_2;
                if !((_e29 <= 1i)) {
                    break;
                }
                {
                    let _e36 = corner_7;
                    let _e38 = i_2;
                    let _e39 = j_2;
                    let _e42 = yardstick_generator((vec2<i32>(_e36) + vec2<i32>(_e38, _e39)), seed);
                    generator_6 = _e42;
                    k_2 = 0i;
                    loop {
                        let _e46 = k_2;
                        if !((_e46 < 16i)) {
                            break;
                        }
                        {
                            let _e55 = yardstick_uniform((&generator_6));
                            x_3 = _e55;
                            let _e59 = yardstick_uniform((&generator_6));
                            y_3 = _e59;
                            let _e64 = yardstick_uniform((&generator_6));
                            phase = (6.2831855f * _e64);
                            let _e67 = corner_7;
                            let _e69 = i_2;
                            let _e71 = x_3;
                            let _e73 = j_2;
                            let _e75 = y_3;
                            d_4 = ((p - _e67) - vec2<f32>((f32(_e69) + _e71), (f32(_e73) + _e75)));
                            let _e80 = wave_5;
                            let _e81 = d_4;
                            let _e83 = phase;
                            angle = (dot(_e80, _e81) + _e83);
                            let _e86 = sum_3;
                            let _e89 = d_4;
                            let _e90 = d_4;
                            let _e94 = angle;
                            let _e96 = angle;
                            sum_3 = (_e86 + (exp((-3.1415927f * dot(_e89, _e90))) * vec2<f32>(cos(_e94), sin(_e96))));
                        }
                        continuing {
                            let _e50 = k_2;
                            k_2 = (_e50 + 1i);
                        }
                    }
                }
                continuing {
                    let _e33 = i_2;
                    i_2 = (_e33 + 1i);
                }
            }
        }
        continuing {
            let _e23 = j_2;
            j_2 = (_e23 + 1i);
        }
    }
    let _e101 = sum_3;
    let _e103 = sum_3;
    let _e104 = sum_3;
    return (_e101.y * inverseSqrt(max(dot(_e103, _e104), 0.000000000001f)));
}

// Stripes from a sum of 16 splats: each of 4 x 4 cells has one, which is a wave around a random point.
fn splats_16_noise(p: vec2<f32>, frequency: f32, orientation: f32, seed: u32) -> f32 {
    var p_9: vec2<f32>;
    var corner_8: vec2<f32>;
    var wave_6: vec2<f32>;
    var sum_4: vec2<f32> = vec2(0f);
    var weights: f32 = 0f;
    var j_3: i32 = -1i;
    var i_3: i32;
    var word_2: u32;
    var place: vec2<f32>;
    var d_5: vec2<f32>;
    var weight_3: f32;
    var angle_1: f32;

    p_9 = p;
    let _e5 = p_9;
    p_9 = (_e5 * 1.5f);
    let _e8 = p_9;
    corner_8 = floor(_e8);
    wave_6 = ((4.1887903f * frequency) * vec2<f32>(cos(orientation), sin(orientation)));
    loop {
        let _e28 = j_3;
        if !((_e28 <= 2i)) {
            break;
        }
        {
            i_3 = -1i;
            loop {
                let _e38 = i_3;
                if !((_e38 <= 2i)) {
                    break;
                }
                {
                    let _e45 = corner_8;
                    let _e47 = i_3;
                    let _e48 = j_3;
                    let _e51 = yardstick_word((vec2<i32>(_e45) + vec2<i32>(_e47, _e48)), seed);
                    word_2 = _e51;
                    let _e53 = word_2;
                    let _e57 = word_2;
                    place = (vec2<f32>(f32((_e53 & 65535u)), f32((_e57 >> 16u))) / vec2(65536f));
                    let _e66 = p_9;
                    let _e67 = corner_8;
                    let _e69 = i_3;
                    let _e71 = j_3;
                    let _e76 = place;
                    d_5 = (((_e66 - _e67) - vec2<f32>(f32(_e69), f32(_e71))) - (0.5f * (_e76 - vec2(0.5f))));
                    let _e85 = d_5;
                    let _e86 = d_5;
                    weight_3 = max((exp((-2f * dot(_e85, _e86))) - 0.01111f), 0f);
                    let _e95 = wave_6;
                    let _e96 = d_5;
                    let _e99 = place;
                    angle_1 = (dot(_e95, _e96) + (6.2831855f * _e99.x));
                    let _e104 = sum_4;
                    let _e105 = weight_3;
                    let _e106 = angle_1;
                    let _e108 = angle_1;
                    sum_4 = (_e104 + (_e105 * vec2<f32>(cos(_e106), sin(_e108))));
                    let _e113 = weights;
                    let _e114 = weight_3;
                    weights = (_e113 + _e114);
                }
                continuing {
                    let _e42 = i_3;
                    i_3 = (_e42 + 1i);
                }
            }
        }
        continuing {
            let _e32 = j_3;
            j_3 = (_e32 + 1i);
        }
    }
    let _e116 = sum_4;
    let _e117 = weights;
    sum_4 = (_e116 / vec2(_e117));
    let _e120 = sum_4;
    let _e123 = sum_4;
    let _e124 = sum_4;
    return (_e120.y * min(2f, inverseSqrt(max(dot(_e123, _e124), 0.000000000001f))));
}

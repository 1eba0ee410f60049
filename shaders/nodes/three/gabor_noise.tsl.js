// gabor_noise.tsl.js: the noise of gabor_noise.glsl, with GABOR_TAPS 3, and the sums of octaves of gabor_fractal.glsl, as
// three.js nodes for WebGPU and WebGL 2.
//
//     material.colorNode = vec3(gabor_unorm(gabor_noise(uv().mul(8), 4, 0.7854, uint(7))));
//
// Arguments are nodes or numbers; gabor_noise.tsl.d.ts has their types and units.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

import { Fn, Loop, abs, ceil, clamp, cross, dFdx, dFdy, dot, exp, float, floor, int, inverseSqrt, ivec2, ivec3, length, max, min,
         normalView, normalize, positionView, pow, select, sign, sqrt, uint, vec2, vec3, vec4 } from "three/tsl";

const ROWS = 0x5bd1e995;
const SLICES = 0x27d4eb2f;
const SCALE2D = 6.0884665e-28;
const SCALE3D = 5.7402612e-28;

const gabor_impl_mix = (word, salt) => {
    const once = word.bitXor(word.shiftRight(uint(16))).mul(uint(0x21f0aaad)).add(salt).toVar();
    const twice = once.bitXor(once.shiftRight(uint(15))).mul(uint(0xd35a2d97)).toVar();
    return twice.bitXor(twice.shiftRight(uint(15)));
};

const gabor_impl_derived_seed = (seed, index) => {
    return gabor_impl_mix(seed.add(uint(index).mul(uint(0x85ebca6b))), uint(0x9e3779b1));
};

const gabor_impl_salt = (seed) => {
    return gabor_impl_mix(seed.mul(uint(0x9e3779b1)), uint(0x2545f491));
};

const gabor_impl_line_word = (index, salt) => {
    const word = uint(index).mul(uint(0x9e3779b1)).add(salt).toVar();
    return word.mul(word.bitXor(word.shiftRight(uint(15)))).shiftRight(uint(8)).bitOr(uint(0x800001));
};

const gabor_impl_amplitude = (word) => {
    const u = vec2(float(int(word)), float(int(word.shiftLeft(uint(12))))).toVar();
    return u.sub(float(0.89289313).mul(clamp(u, -2.0119258e9, 2.0119258e9))).mul(u.mul(u).add(7.3973916e18));
};

const gabor_impl_product = (a, b) => {
    return a.x.mul(b).add(a.y.mul(vec2(b.y.negate(), b.x)));
};

const gabor_impl_half_turn = (t) => {
    const s = t.mul(t).toVar();
    const r = s.mul(s).toVar();
    return vec2(float(1.0).sub(float(19.739171).mul(s)).add(r.mul(float(64.934591).sub(float(85.240337).mul(s)).add(float(56.24243).mul(r)))), t.mul(float(6.2831852).sub(float(41.341655).mul(s)).add(r.mul(float(81.601004).sub(float(76.549782).mul(s)).add(float(39.536707).mul(r))))));
};

const gabor_impl_wave = (t) => {
    const within = t.sub(floor(t.add(0.5))).toVar();
    const turn = gabor_impl_half_turn(float(0.25).sub(abs(within))).toVar();
    return vec2(turn.y, select(within.lessThan(0.0), turn.x.negate(), turn.x));
};

const RADIUS = 1.5;                  // nodes per kernel radius
const TURN = 6.2831853;

// The amplitude of a node; with an evolution, a sum of three amplitudes.
const amplitude_at = (word, evolution) => {
    const first = gabor_impl_amplitude(word);
    if (evolution === undefined) return first;
    const second = word.bitXor(word.shiftRight(uint(15))).mul(uint(0xd35a2d97)).toVar();
    const third = second.bitXor(second.shiftRight(uint(15))).mul(uint(0xd35a2d97)).toVar();
    const turn = gabor_impl_wave(evolution).toVar();
    return first.mul(turn.x.mul(0.5).add(0.5)).add(gabor_impl_amplitude(second).mul(turn.x.mul(-0.5).add(0.5)))
        .add(gabor_impl_amplitude(third).mul(turn.y.mul(0.70710678)));
};

const node_word = (index, salt, period) => {
    if (period !== undefined) {
        index = index.sub(index.div(period).mul(period)).toVar();
        index = select(index.lessThan(int(0)), index.add(period), index);
    }
    return gabor_impl_line_word(index, salt).toVar();
};

// The three nodes along an axis that reach a place, which is in node spacings. `value` is the window times the wave, and
// `slope` its derivative per kernel radius.
const axis = (place, wave, salt, radius = float(RADIUS), period) => {
    const middle = floor(place.add(0.5)).toVar();
    const offset = clamp(place.sub(middle), -0.5, 0.5).toVar();
    return [-1, 0, 1].map(i => {
        const distance = offset.sub(i).toVar();
        const turn = gabor_impl_wave(distance.div(2 * RADIUS)).toVar();
        const phase = gabor_impl_wave(wave.mul(distance).div(radius)).toVar();
        const window = turn.x.mul(0.5).add(0.5).toVar();
        const slope = vec2(turn.y.mul(-TURN / 4).mul(radius).div(RADIUS), window.mul(wave).mul(TURN));
        return { word: node_word(int(middle).add(int(i)), salt, period), value: phase.mul(window).toVar(),
                 slope: gabor_impl_product(phase, slope).toVar() };
    });
};

// Sums over the nodes { word, value, slope } of an axis. next(node) returns the value and its derivatives along the other
// axes; `along` appends the derivative along its own axis.
const along = (nodes, next) => {
    let sums;
    for (const node of nodes) {
        const terms = next(node);
        const made = [gabor_impl_product(terms[0], node.value), ...terms.slice(1).map(term => gabor_impl_product(term, node.value)),
                      gabor_impl_product(terms[0], node.slope)];
        sums = sums ? sums.map((sum, index) => sum.add(made[index]).toVar()) : made.map(term => term.toVar());
    }
    return sums;
};

// Complex noise and its derivatives along x and y.
const plane = (p, wave, seed, evolution, radius = vec2(RADIUS), period) => {
    const place = p.mul(radius).toVar();
    const salt = gabor_impl_salt(seed).toVar();
    const columns = axis(place.x, wave.x, salt, radius.x, period && period.x);
    const rows = axis(place.y, wave.y, salt.bitXor(uint(ROWS)), radius.y, period && period.y);
    return along(rows, row => along(columns, column => [amplitude_at(column.word.mul(row.word).toVar(), evolution)]));
};
const field_of = ([value, x, y]) => vec4(value.y, value.x, x.y, y.y).mul(SCALE2D);
const quadrature_of = ([value, x, y]) => vec4(value.x, value.y, x.x, y.x).mul(SCALE2D);

const function_of = (name, body, ...inputs) => {
    const made = Fn(body).setLayout({ name, type: "vec4", inputs: inputs.map(input => {
        const [type, name] = input.split(" ");
        return { type, name };
    }) });
    const types = { float, vec2, vec3, uint };
    return (...given) => made(...inputs.map((input, index) => types[input.split(" ")[0]](given[index])));
};

// A function for each kind of place: with a period or without, still or with an evolution.
const made = {};
const plane_field = ({ p, period, evolution }, wave, seed) => {
    const name = `gabor_field${period ? "_tiled" : ""}${evolution === undefined ? "" : "_animated"}`;
    made[name] ??= function_of(name, ([p, wave, seed, ...others]) => {
        const side = period && others[0], turns = evolution === undefined ? undefined : others.at(-1);
        if (!side)
            return field_of(plane(p, wave, seed, turns));
        const nodes = max(floor(clamp(side, 1 / 1024, 1e9).mul(RADIUS).add(0.5)), vec2(3)).toVar();
        return field_of(plane(p, wave, seed, turns, nodes.div(side).toVar(), ivec2(nodes).toVar()));
    }, "vec2 p", "vec2 wave", "uint seed", ...period ? ["vec2 period"] : [], ...evolution === undefined ? [] : ["float evolution"]);
    return made[name](p, wave, seed, ...period ? [period] : [], ...evolution === undefined ? [] : [evolution]);
};
const quadrature_field = function_of("gabor_quadrature_field", ([p, wave, seed]) => quadrature_of(plane(p, wave, seed)),
                                     "vec2 p", "vec2 wave", "uint seed");

const slice_word = (row, slice) => row.mul(slice).shiftRight(uint(8)).bitOr(uint(0x800001));

const solid_field = function_of("gabor_solid_field", ([p, wave, seed]) => {
    const place = p.mul(RADIUS).toVar();
    const salt = gabor_impl_salt(seed).toVar();
    const columns = axis(place.x, wave.x, salt);
    const rows = axis(place.y, wave.y, salt.bitXor(uint(ROWS)));
    const slices = axis(place.z, wave.z, salt.bitXor(uint(SLICES)));
    const [value, x, y, z] = along(slices, slice => along(rows, row => {
        const word = slice_word(row.word, slice.word).toVar();
        return along(columns, column => [amplitude_at(column.word.mul(word).toVar())]);
    }));
    return vec4(value.y, x.y, y.y, z.y).mul(SCALE3D);
}, "vec3 p", "vec3 wave", "uint seed");

// ---- Sums of octaves: see gabor_fractal.glsl ------------------------------------------------------------------------

const SMOOTH = 0, PERLIN = 1, FBM = 0, BILLOW = 1, RIDGED = 2;

const uniform_of = noise => {
    const x = clamp(noise, -8, 8).toVar(), y = x.mul(x).toVar();
    const odds = x.mul(y.mul(y.mul(-0.00063190124).add(0.073597476)).add(1.5954352));
    return float(1).div(exp(odds.negate()).add(1));
};

// Divides a window and its derivative at each node by the root of the sum of the squared windows, and multiplies both by `kept`.
const normalized = (windows, kept) => {
    const sum = terms => terms.reduce((sum, term) => sum.add(term)).toVar();
    const scale = inverseSqrt(sum(windows.map(([value]) => value.mul(value)))).toVar();
    const drift = sum(windows.map(([value, slope]) => value.mul(slope))).mul(scale).mul(scale).toVar();
    const factor = kept ? scale.mul(kept).toVar() : scale;
    return windows.map(([value, slope]) => [value.mul(factor).toVar(), slope.sub(drift.mul(value)).mul(factor).toVar()]);
};

const kept_even = variance =>
    inverseSqrt(sqrt(variance.mul(variance.mul(variance).mul(1.52).div(variance.add(0.5855)).add(2.888)).add(1))).toVar();
const kept_odd = variance => {
    const kept = inverseSqrt(sqrt(variance.mul(variance.mul(variance).mul(1.173).div(variance.add(0.149)).add(2.704)).add(1))).toVar();
    return kept.mul(kept).mul(kept).toVar();
};

// The nodes along an axis that reach a place, with their windows [value, slope]; only Perlin noise has odd ones.
const octave_axis = (place, salt, basis, period, variance) => {
    const nodes = basis === PERLIN || variance ? [-1, 0, 1, 2] : [-1, 0, 1], [low, high] = nodes.length === 4 ? [0, 1] : [-0.5, 0.5];
    const middle = floor(place.sub(low)).toVar();
    const offset = clamp(place.sub(middle), low, high).toVar();
    const words = nodes.map(i => node_word(int(middle).add(int(i)), salt, period));
    const even = [], odd = [];
    for (const i of nodes) {
        const distance = offset.sub(i);
        if (basis === PERLIN) {
            const turn = gabor_impl_wave(distance.mul(0.25)).toVar(), t = variance ? min(variance.mul(5.5), 2).toVar() : float(0);
            const hann = turn.x.mul(0.5).add(0.5).toVar(), slope = turn.y.mul(-0.78539816).toVar();
            const share = t.mul(2).add(2).sub(t.mul(hann).mul(3)).toVar(), v = slope.mul(hann).mul(share).toVar();
            even.push([hann.mul(hann).mul(t.sub(t.mul(hann)).add(1)).toVar(), v]);
            odd.push([v, turn.x.mul(hann).mul(share).mul(-1.2337006).add(slope.mul(slope).mul(share.sub(t.mul(hann).mul(3)))).toVar()]);
        } else {
            const half_width = variance ? min(sqrt(variance.div(0.294).add(1)).mul(1.5), 2) : float(1.5);
            const turn = gabor_impl_half_turn(clamp(distance.div(half_width.mul(4)), -0.25, 0.25)).toVar();
            even.push([turn.x.mul(turn.x).toVar(), turn.x.mul(turn.y).mul(-3.1415927).div(half_width).toVar()]);
        }
    }
    const [evens, odds] = [normalized(even, variance && kept_even(variance)), odd.length ? normalized(odd, variance && kept_odd(variance)) : []];
    return words.map((word, i) => ({ word, even: evens[i], odd: odds[i] }));
};

const sum_of = terms => terms.reduce((sums, term) => sums.map((sum, index) => sum.add(term[index]).toVar()));
const times = ([value, slope], factor) => [value.mul(factor), slope.mul(factor)];

// A sum over a plane of nodes, and its derivatives along x and y: of A u(x) u(y) or, if mixed, of A v(x) u(y) + B u(x) v(y).
const plane_sum = (columns, rows, mixed, evolution) => sum_of(rows.map(row => {
    const terms = sum_of(columns.map(column => {
        const amplitude = amplitude_at(column.word.mul(row.word).toVar(), evolution).toVar();
        return mixed ? [...times(column.odd, amplitude.x), ...times(column.even, amplitude.y)] : times(column.even, amplitude.x);
    }));
    return [[0, 0], [0, 1], [1, 0]].map(([y, x]) => { // which derivatives
        const term = row.even[y].mul(terms[x]);
        return mixed ? term.add(row.odd[y].mul(terms[x + 2])) : term;
    });
}));

const solid_sum = (columns, rows, slices, mixed, evolution) => sum_of(slices.map(slice => {
    const within = rows.map(row => ({ ...row, word: slice_word(row.word, slice.word).toVar() }));
    const sum = plane_sum(columns, within, mixed, evolution), [value, slope] = slice.even;
    const terms = [...sum.map(each => each.mul(value)), sum[0].mul(slope)];
    if (!mixed) return terms;
    const third = plane_sum(columns, within.map(row => ({
        ...row, word: slice_word(row.word.bitXor(row.word.shiftRight(uint(15))), uint(0xd35a2d97)).toVar(),
    })), false, evolution);
    return [...third.map(each => each.mul(slice.odd[0])), third[0].mul(slice.odd[1])].map((term, index) => terms[index].add(term));
}));

// A function for each dimension, basis, shape and kind of place, filtered or not. Octaves and gain may vary.
const octaves_field = (size, { p, period, evolution }, pixel, { octaves, gain, lacunarity, turn, basis, shape }, seed) => {
    const kind = `${period ? "_tiled" : ""}${evolution === undefined ? "" : "_animated"}${pixel ? "_filtered" : ""}`;
    const name = `gabor_octaves_${size}d_${basis}_${shape}${kind}`, type = `vec${size}`, vec = size === 2 ? vec2 : vec3;
    const parts = ["x", "y", "z"].slice(0, size).map(part => value => value[part]), perlin = basis === PERLIN;
    made[name] ??= function_of(name, ([p, octaves, gain, lacunarity, turn, seed, ...others]) => {
        const side = period && others.shift(), turns = evolution === undefined ? undefined : others.shift(), [dx, dy] = others;
        const axes = parts.map((_, axis) => vec(...parts.map((_, index) => Number(index === axis))));
        const moved = size === 2 ? vec2(0.382, 0.731) : vec3(0.382, 0.731, 0.545);
        const growth = clamp(lacunarity, 1, 4).toVar(), unit = gabor_impl_wave(turn.mul(0.15915494)).toVar();
        const rest = float(1).sub(unit.x).div(3), lean = unit.y.mul(0.57735027);
        const rotation = size === 2 ? unit : vec3(unit.x.add(rest), rest.sub(lean), rest.add(lean));
        const by = floor(rotation.mul(growth).mul(4096).add(0.5)).div(4096).toVar();
        const stepped = v => size === 2 ? gabor_impl_product(by, v) : v.mul(by.x).add(v.yzx.mul(by.y)).add(v.zxy.mul(by.z));

        const first = side && max(floor(clamp(side, 1 / 1024, 1e9).mul(RADIUS).add(0.5)), vec(3)).toVar();
        const density = side ? first.div(side).toVar() : vec(RADIUS);
        const start = p.mul(density).toVar(), place = start.toVar();
        const lines = axes.map(axis => axis.mul(density).toVar());
        const count = clamp(octaves, 1, 16).toVar(), amplitude = float(1).toVar(), power = float(0).toVar();
        const value = float(0).toVar(), gradient = vec(0).toVar();
        Loop(int(ceil(count)), ({ i }) => {
            let nodes;
            if (side) {
                nodes = min(floor(first.mul(pow(growth, float(i))).add(0.5)), 1e9).toVar();
                const scale = nodes.div(first).toVar();
                place.assign(start.sub(first.mul(floor(start.div(first)))).mul(scale).add(moved.mul(float(i))));
                lines.forEach((line, index) => line.assign(axes[index].mul(density).mul(scale)));
            }
            let variance, oblique, kept;
            if (pixel) {
                const [a, b] = [dx, dy].map(step => clamp(lines.map((line, index) => line.mul(parts[index](step)))
                    .reduce((sum, term) => sum.add(term)).mul(0.5), -1000, 1000).toVar());
                variance = a.mul(a).add(b.mul(b)).toVar();
                const pairs = parts.flatMap((one, index) => parts.slice(index + 1).map(other => [one, other]));
                oblique = pairs.map(([one, other]) => {
                    const covariance = one(a).mul(other(a)).add(one(b).mul(other(b))).toVar();
                    const room = one(variance).mul(2.9).add(1).mul(other(variance).mul(2.9).add(1));
                    return float(1).div(float(1).sub(covariance.mul(covariance).mul(4.205).div(room)));
                }).reduce((product, factor) => product.mul(factor)).toVar();
                const evens = parts.map(part => kept_even(part(variance))).map(each => each.mul(each));
                kept = evens.reduce((product, factor) => product.mul(factor)).toVar();
                if (perlin) {
                    kept = parts.map((part, index) => kept_odd(part(variance)).mul(kept_odd(part(variance))).mul(kept).div(evens[index]))
                        .reduce((sum, term) => sum.add(term)).div(size).toVar();
                    oblique = oblique.mul(oblique).mul(oblique).toVar();
                }
                oblique = min(oblique, inverseSqrt(kept)).mul(clamp(kept.mul(oblique).mul(oblique).mul(1000).sub(1), 0, 1)).toVar();
                kept = kept.mul(oblique).mul(oblique).toVar();
            }
            const salt = gabor_impl_mix(seed.mul(uint(0x9e3779b1)).add(uint(i).mul(uint(0x85ebca6b))), uint(0xc2b2ae35)).toVar();
            const whole = nodes && (size === 2 ? ivec2(nodes) : ivec3(nodes)).toVar();
            const nodes_along = parts.map((part, index) => octave_axis(part(place), index ? salt.bitXor(uint([0, ROWS, SLICES][index])) : salt, basis,
                                                                       whole && part(whole), variance && part(variance)));
            const sums = (size === 2 ? plane_sum : solid_sum)(...nodes_along, perlin, turns);
            const factor = float(SCALE2D * 1.125 / (perlin ? Math.sqrt(size) : 1));
            const [noise, ...slopes] = sums.map(sum => sum.mul(oblique ? oblique.mul(factor) : factor).toVar());
            const slope = vec(...lines.map(line => dot(vec(...slopes), line))).toVar();
            const weight = amplitude.mul(min(count.sub(float(i)), 1)).toVar();
            power.assign(power.add(weight.mul(weight)));
            amplitude.assign(amplitude.mul(gain));
            if (shape === FBM) {
                value.assign(value.add(weight.mul(noise)));
                gradient.assign(gradient.add(slope.mul(weight)));
            } else {
                let mean = abs(noise), rise = sign(noise);
                if (kept) { // the mean of |n| over what the filter removed
                    const deviation = sqrt(max(float(1).sub(kept), 1e-8)).toVar(), t = clamp(noise.div(deviation), -9, 9).toVar();
                    rise = uniform_of(t).mul(2).sub(1).toVar();
                    mean = deviation.mul(exp(t.mul(t).mul(-0.5))).mul(0.79788456).add(noise.mul(rise));
                }
                const share = weight.mul(shape === RIDGED ? -1.6588964 : 1.6588964).toVar();
                value.assign(value.add(share.mul(mean.sub(0.79788456))));
                gradient.assign(gradient.add(slope.mul(share.mul(rise))));
            }
            if (!side) {
                place.assign(stepped(place).add(moved));
                lines.forEach(line => line.assign(stepped(line)));
            }
        });
        const scale = inverseSqrt(max(power, 1e-30)).toVar();
        return vec4(value, gradient, ...size === 2 ? [0] : []).mul(scale);
    }, `${type} p`, "float octaves", "float gain", "float lacunarity", "float turn", "uint seed", ...period ? [`${type} period`] : [],
    ...evolution === undefined ? [] : ["float evolution"], ...pixel ? [`${type} dx`, `${type} dy`] : []);
    const value = made[name](p, octaves, gain, lacunarity, turn, seed, ...period ? [period] : [], ...evolution === undefined ? [] : [evolution],
                             ...pixel ?? []).toVar();
    return { noise: value.x, gradient: size === 2 ? value.yz : value.yzw };
};

// ---- Public functions ----------------------------------------------------------------------------------------------

export const gabor_wave_vector = (frequency, orientation) =>
    gabor_impl_wave(float(orientation).mul(0.15915494)).mul(min(abs(float(frequency)), 1e6));

export const gabor_place_at = p => ({ p });
export const gabor_place_tiled = (p, period) => ({ p, period });
export const gabor_place_3d_at = p => ({ p });

export const gabor_field = (place, wave, seed) => {
    const value = plane_field(place, wave, seed).toVar();
    return { noise: value.x, quadrature: value.y, gradient: value.zw };
};
export const gabor_field_3d = (place, wave, seed) => {
    const value = solid_field(place.p, wave, seed).toVar();
    return { noise: value.x, gradient: value.yzw };
};

export const gabor_noise = (p, frequency, orientation, seed) =>
    gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed).noise;
export const gabor_noise_quadrature = (p, frequency, orientation, seed) => {
    const field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec2(field.noise, field.quadrature);
};
export const gabor_noise_gradient = (p, frequency, orientation, seed) => {
    const field = gabor_field(gabor_place_at(p), gabor_wave_vector(frequency, orientation), seed);
    return vec3(field.noise, field.gradient);
};
export const gabor_noise_tiled = (p, period, frequency, orientation, seed) =>
    gabor_field(gabor_place_tiled(p, period), gabor_wave_vector(frequency, orientation), seed).noise;
export const gabor_noise_animated = (p, evolution, frequency, orientation, seed) =>
    gabor_field({ p, evolution }, gabor_wave_vector(frequency, orientation), seed).noise;
export const gabor_noise_3d = (p, frequency, direction, seed) =>
    gabor_field_3d(gabor_place_3d_at(p), normalize(vec3(direction)).mul(min(abs(float(frequency)), 1e6)), seed).noise;

export const gabor_derived_seed = (seed, index) => gabor_impl_derived_seed(uint(seed), int(index));

export const gabor_stripes_of = (field, sharpness) => {
    const value = vec2(field.quadrature, field.noise).toVar();
    const intensity = length(value).toVar();
    return vec3(value.mul(min(float(sharpness), float(1).div(max(intensity, 1e-10)))), intensity);
};
export const gabor_stripes = (p, wave, sharpness, seed) =>
    gabor_stripes_of(gabor_field(gabor_place_at(p), wave, seed), sharpness);

export const gabor_unorm = noise => clamp(float(noise).mul(0.25).add(0.5), 0, 1);

export const gabor_normal = (gradient, p, height) => {
    const x = dFdx(positionView), y = dFdy(positionView);
    const first = cross(y, normalView), second = cross(normalView, x);
    const area = dot(x, first).toVar();
    const steep = first.mul(dot(gradient, dFdx(p))).add(second.mul(dot(gradient, dFdy(p)))).mul(height).mul(sign(area));
    return normalize(normalView.mul(abs(area)).sub(steep));
};

// gabor_brushed_metal of gabor_materials.glsl: noises of frequency 0 with narrow kernels; one evaluation gives all results.
export const gabor_brushed_metal = (p, seed) => {
    let height = float(0), tone = float(0), slope = vec2(0);
    for (let part = 0; part < 5; ++part) {
        const fine = 2 ** part, density = vec2(0.3 + 0.12 * fine, 9 * fine);
        const field = quadrature_field(vec2(p).mul(density), vec2(0), gabor_derived_seed(seed, part)).toVar();
        height = height.add(field.x.mul(0.0012 / fine));
        slope = slope.add(field.zw.mul(density).mul(0.0012 / fine));
        tone = tone.add(field.y.mul(0.4472136));
    }
    const colour = clamp(vec3(0.55, 0.555, 0.565).mul(exp(tone.sub(0.045).mul(0.09))), 0, 1);
    return { colour, height, slope, roughness: float(0.36), metalness: float(1) };
};

export const GABOR_SMOOTH = SMOOTH, GABOR_PERLIN = PERLIN;
export const GABOR_FBM = FBM, GABOR_BILLOW = BILLOW, GABOR_RIDGED = RIDGED;

export const gabor_uniform = noise => uniform_of(float(noise));

export const gabor_fractal = (octaves, gain, choices = {}) =>
    ({ octaves, gain, lacunarity: 2, turn: 0.64350111, basis: SMOOTH, shape: FBM, ...choices });
export const gabor_fractal_noise = (place, fractal, seed) => octaves_field(2, place, undefined, fractal, seed);
export const gabor_fractal_noise_filtered = (place, dx, dy, fractal, seed) => octaves_field(2, place, [dx, dy], fractal, seed);
export const gabor_fractal_noise_3d = (place, fractal, seed) => octaves_field(3, place, undefined, fractal, seed);
export const gabor_fractal_noise_3d_filtered = (place, dx, dy, fractal, seed) => octaves_field(3, place, [dx, dy], fractal, seed);

export const gabor_smooth = (p, seed) => gabor_fbm(p, 1, 0, seed);
export const gabor_perlin = (p, seed) =>
    gabor_fractal_noise(gabor_place_at(vec2(p).mul(1.186)), gabor_fractal(1, 0, { basis: PERLIN }), seed).noise;
export const gabor_perlin_3d = (p, seed) =>
    gabor_fractal_noise_3d(gabor_place_3d_at(vec3(p).mul(1.186)), gabor_fractal(1, 0, { basis: PERLIN }), seed).noise;
export const gabor_fbm = (p, octaves, gain, seed) => gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain), seed).noise;
export const gabor_fbm_3d = (p, octaves, gain, seed) => gabor_fractal_noise_3d(gabor_place_3d_at(p), gabor_fractal(octaves, gain), seed).noise;
export const gabor_billow = (p, octaves, gain, seed) =>
    gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain, { shape: BILLOW }), seed).noise;
export const gabor_ridged = (p, octaves, gain, seed) =>
    gabor_fractal_noise(gabor_place_at(p), gabor_fractal(octaves, gain, { shape: RIDGED }), seed).noise;

export const gabor_warp = (place, strength, fractal, seed) => {
    const [x, y] = [0, 1].map(part => gabor_fractal_noise(place, fractal, gabor_derived_seed(seed, part)));
    return { place: { ...place, p: vec2(place.p).add(vec2(x.noise, y.noise).mul(strength)) },
             dx: vec2(x.gradient.x, y.gradient.x).mul(strength).add(vec2(1, 0)),
             dy: vec2(x.gradient.y, y.gradient.y).mul(strength).add(vec2(0, 1)) };
};

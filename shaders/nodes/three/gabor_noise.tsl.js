// gabor_noise.tsl.js: the noise of gabor_noise.glsl, with GABOR_TAPS 3, as three.js nodes for WebGPU and WebGL 2.
//
//     material.colorNode = vec3(gabor_unorm(gabor_noise(uv().mul(8), 4, 0.7854, uint(7))));
//
// Arguments are nodes or numbers; gabor_noise.tsl.d.ts has their types and units.
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

import { Fn, abs, clamp, cross, dFdx, dFdy, dot, exp, float, floor, int, ivec2, length, max, min, normalView, normalize,
         positionView, select, sign, uint, vec2, vec3, vec4 } from "three/tsl";

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
        let index = int(middle).add(int(i));
        if (period !== undefined) {
            index = index.sub(index.div(period).mul(period)).toVar();
            index = select(index.lessThan(int(0)), index.add(period), index);
        }
        return { word: gabor_impl_line_word(index, salt).toVar(), value: phase.mul(window).toVar(),
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

const solid_field = function_of("gabor_solid_field", ([p, wave, seed]) => {
    const place = p.mul(RADIUS).toVar();
    const salt = gabor_impl_salt(seed).toVar();
    const columns = axis(place.x, wave.x, salt);
    const rows = axis(place.y, wave.y, salt.bitXor(uint(ROWS)));
    const slices = axis(place.z, wave.z, salt.bitXor(uint(SLICES)));
    const [value, x, y, z] = along(slices, slice => along(rows, row => {
        const word = row.word.mul(slice.word).shiftRight(uint(8)).bitOr(uint(0x800001)).toVar();
        return along(columns, column => [amplitude_at(column.word.mul(word).toVar())]);
    }));
    return vec4(value.y, x.y, y.y, z.y).mul(SCALE3D);
}, "vec3 p", "vec3 wave", "uint seed");

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

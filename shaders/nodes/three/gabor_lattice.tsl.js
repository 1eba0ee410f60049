// gabor_lattice.tsl.js: the noise of gabor_lattice.glsl, with GABOR_TAPS 3, as nodes of three.js: for WebGPU and WebGL 2.
//
//     material.colorNode = vec3(gabor_unorm(gabor_noise(uv().mul(8), 4, 0.7854, uint(7))));
//
// Copyright (c) 2026 The gabor-noise authors. SPDX-License-Identifier: MIT

import { Fn, abs, clamp, float, floor, int, min, select, uint, vec2 } from "three/tsl";

const SPREAD = uint(0x9e3779b1);
const ODD = uint(0xd35a2d97);
const ROWS = uint(0x5bd1e995);
const RADIUS = 1.5;                       // nodes per kernel radius
const SCALE = 1 / (1.4599553e27 * 1.125); // over the deviation of an amplitude and the sum of the squared windows

const shifted = (word, bits) => word.bitXor(word.shiftRight(uint(bits)));

// The word of a column or a row of nodes.
const line_word = (index, salt) =>
    shifted(uint(index).mul(SPREAD).add(salt), 15).mul(ODD).shiftRight(uint(8)).bitOr(uint(0x800001)).toVar();

const salt_of = seed => {
    const salt = uint(0x2545f491);
    const word = shifted(uint(seed).mul(SPREAD), 16).mul(uint(0x21f0aaad)).add(salt).toVar();
    return shifted(shifted(word, 15).mul(ODD).toVar(), 15).toVar();
};

// The amplitude of a node, nearly normal, times SCALE^-1.
const amplitude = word => {
    const u = vec2(float(int(word)), float(int(word.shiftLeft(uint(16))))).toVar();
    return u.sub(clamp(u, -2.0119258e9, 2.0119258e9).mul(0.89289313)).mul(u.mul(u).add(7.3973916e18));
};

// (cos, sin) of 2 pi t by polynomials, precise on every driver.
const turn = Fn(([turns]) => {
    const t = turns.sub(floor(turns.add(0.5))).toVar();
    const y = abs(t).sub(0.25).toVar();
    const s = y.mul(y).toVar();
    const r = s.mul(s).toVar();
    const cosine = s.mul(41.341655).sub(6.2831852)
        .add(r.mul(s.mul(76.549782).sub(81.601004).sub(r.mul(39.536707))));
    const sine = float(1).sub(s.mul(19.739171))
        .add(r.mul(float(64.934591).sub(s.mul(85.240337)).add(r.mul(56.24243)))).toVar();
    return vec2(y.mul(cosine), select(t.lessThan(0), sine.negate(), sine));
}).setLayout({ name: "gabor_turn", type: "vec2", inputs: [{ name: "turns", type: "float" }] });

const product = (a, b) => vec2(a.x.mul(b.x).sub(a.y.mul(b.y)), a.x.mul(b.y).add(a.y.mul(b.x)));

// The three nodes along an axis that reach a point: their words, and Hann's window times the wave.
const axis = (middle, offset, wave, salt) => [-1, 0, 1].map(i => {
    const distance = offset.sub(i).div(RADIUS).toVar();
    const window = turn(distance.mul(0.5)).x.mul(0.5).add(0.5);
    return { word: line_word(int(middle).add(int(i)), salt), factor: turn(wave.mul(distance)).mul(window).toVar() };
});

// The noise and its quadrature, as gabor_noise_complex of gabor_lattice.glsl.
//   p vec2, frequency float, orientation float, seed uint
export const gabor_noise_complex = Fn(([p, frequency, orientation, seed]) => {
    const wave = turn(orientation.mul(0.15915494)).mul(min(abs(frequency), 1e6)).toVar();
    const place = p.mul(RADIUS).toVar();
    const middle = floor(place.sub(RADIUS)).add(2).toVar();
    const offset = place.sub(middle).toVar();
    const salt = salt_of(seed);
    const columns = axis(middle.x, offset.x, wave.x, salt);
    const rows = axis(middle.y, offset.y, wave.y, salt.bitXor(ROWS));
    const sum = vec2(0).toVar();
    for (const row of rows)
        for (const column of columns)
            sum.addAssign(product(product(amplitude(column.word.mul(row.word).toVar()).mul(SCALE), column.factor), row.factor));
    return sum;
}).setLayout({
    name: "gabor_noise_complex",
    type: "vec2",
    inputs: [{ name: "p", type: "vec2" }, { name: "frequency", type: "float" }, { name: "orientation", type: "float" },
             { name: "seed", type: "uint" }],
});

// The noise: mean 0 and variance 1.
export const gabor_noise = (p, frequency, orientation, seed) => gabor_noise_complex(p, frequency, orientation, seed).y;

// To [0, 1], two standard deviations to the ends.
export const gabor_unorm = noise => clamp(float(noise).mul(0.25).add(0.5), 0, 1);

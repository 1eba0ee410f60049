#!/bin/sh
# three.js shortens 32-bit floats to 16 bits by cutting off, not by rounding: toHalfFloat(1.9999) is 1.9990, where the
# nearest half is 2. Values shrink by 0.034 % on average, and errors reach a whole step instead of half a step.
# Versions: three 0.187.0 (npm); Node.js 18 or newer.
# Surprise: IEEE's default is to round to the nearest. Here the error has a sign, so it does not average out over a
# picture: a height field sinks, and light fades, by a third of a thousandth.
# Who is hit: EXRLoader and HDRLoader, which convert values with this function unless FloatType is set; and whoever
# compares such textures with halves that another program wrote.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-save --no-audit --no-fund three@0.187.0 >/dev/null
cat >half.mjs <<'JS'
import { DataUtils, REVISION } from "three";

const half = (x) => DataUtils.fromHalfFloat(DataUtils.toHalfFloat(x));
const nearest = (x) => Math.round(x * 1024) / 1024;  // between 1 and 2 halves are 1 / 1024 apart
let bias = 0, largest = 0, rounded = 0;
const count = 100000;
for (let i = 0; i < count; i++) {
    const x = 1 + (i + 0.5) / count;
    bias += (half(x) / x - 1) / count;
    rounded += (nearest(x) / x - 1) / count;
    largest = Math.max(largest, Math.abs(half(x) - x) * 1024);
}
console.log(`three.js ${REVISION}`);
console.log(`1.9999: expected ${nearest(1.9999)}; seen ${half(1.9999)}`);
console.log(`mean relative error: expected ${rounded.toExponential(1)}; seen ${bias.toExponential(3)}`);
console.log(`largest error in steps: expected 0.5; seen ${largest.toFixed(2)}`);
if (half(1.9999) !== 2047 / 1024 || bias > -3e-4 || largest < 0.99) {
    console.error("the behaviour has changed");
    process.exit(1);
}
JS
node half.mjs

#!/bin/sh
# three.js's EXRLoader reads all channels of a file as one type: with 32-bit floats in R and B and 16-bit floats in G, G
# comes back as other numbers (33000 where 7 was the largest); with 16-bit alpha, an alpha of 1 is off by up to 13.
# Versions: three 0.187.0, parse-exr 1.0.2 (npm); OpenEXR 3.5.3, numpy 2.2.6 (PyPI). Node.js 18 or newer, Python 3.11.
# Surprise: EXR gives each channel a type of its own, and files that keep heights or depths as 32-bit floats beside
# 16-bit colours are common. The loader knows each channel's type, but its readers of pixels keep only the last one.
# parse-exr, which began as the same code, does the same.
# Who is hit: web viewers of renders and map sets with mixed types; they draw garbage, without an error.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
python3 -m pip install --quiet --target "$dir/py" OpenEXR==3.5.3 numpy==2.2.6
(cd "$dir" && npm init -y >/dev/null && npm install --silent three@0.187.0 parse-exr@1.0.2)
PYTHONPATH=$dir/py python3 - "$dir" <<'PY'
import sys
import numpy as np
import OpenEXR

y, x = np.mgrid[:8, :16].astype(np.float32)
full, half = np.float32, np.float16
for name, types in (("same", (full, full, full, full)), ("mixed", (full, half, full, full)), ("alpha", (full, full, full, half))):
    values = (x, y, x + y, np.ones_like(x))
    OpenEXR.File({"compression": OpenEXR.ZIP_COMPRESSION}, {channel: value.astype(kind) for channel, value, kind
                                                           in zip("RGBA", values, types)}).write(f"{sys.argv[1]}/{name}.exr")
PY
cat >"$dir/read.mjs" <<'JS'
import fs from "node:fs";
import { FloatType } from "three";
import { EXRLoader } from "three/examples/jsm/loaders/EXRLoader.js";
import parseExr from "parse-exr";

console.info("three 0.187.0 and parse-exr 1.0.2, floats of 16 and 32 bits in one file");
for (const [reader, parse] of [["three", buffer => new EXRLoader().setDataType(FloatType).parse(buffer)],
                               ["parse-exr", buffer => parseExr(buffer, FloatType)]]) {
    const errors = {};
    for (const name of ["same", "mixed", "alpha"]) {
        const bytes = fs.readFileSync(`${name}.exr`);
        const { data } = parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
        const error = [0, 0, 0, 0];
        for (let y = 0; y < 8; y++)
            for (let x = 0; x < 16; x++)
                [x, y, x + y, 1].forEach((value, c) => {
                    const off = Math.abs(data[4 * (16 * (7 - y) + x) + c] - value);
                    if (!(off <= error[c])) error[c] = off; // a NaN too
                });
        errors[name] = error;
        console.info(`${reader}, ${name}: largest errors of R, G, B, A: expected 0 0 0 0, seen ${error.map(e => e.toPrecision(2)).join(" ")}`);
    }
    const zero = list => list.every(error => error === 0);
    if (!zero(errors.same) || zero(errors.mixed) || zero(errors.alpha)) {
        console.info("the behaviour has changed");
        process.exit(1);
    }
}
JS
cd "$dir"
node read.mjs

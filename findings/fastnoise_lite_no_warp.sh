#!/bin/sh
# FastNoise Lite's npm package cannot warp: DomainWrap(point) leaves every point as it is, without an error, because it
# accepts only Vector2 and Vector3, two classes that the package does not export.
# Versions: fastnoise-lite 1.1.1 (npm); Node.js 18 or newer.
# Surprise: warp types, amplitude and fractal warps are accepted, and the call returns as if it had worked. The call
# silently ignores a point with x and y, although the classes hold nothing else.
# Who is hit: terrain and textures with domain warping in JavaScript: the picture is the plain noise, and differs from
# the Rust port's with the same settings.
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-save --no-audit --no-fund fastnoise-lite@1.1.1 >/dev/null
cat >warp.mjs <<'JS'
import * as module from "fastnoise-lite";

const FastNoise = module.default;
const exported = Object.keys(module);
console.log("fastnoise-lite 1.1.1 exports:", exported.join(", "));
let largest = 0;
for (const type of Object.values(FastNoise.DomainWarpType)) {
    for (const fractal of ["None", "DomainWarpProgressive", "DomainWarpIndependent"]) {
        const noise = new FastNoise(1337);
        noise.SetFrequency(0.05);
        noise.SetDomainWarpType(type);
        noise.SetDomainWarpAmp(30);
        noise.SetFractalType(FastNoise.FractalType[fractal]);
        for (let i = 0; i < 100; i++) {
            const flat = { x: 1.3 * i, y: 0.7 * i }, solid = { ...flat, z: 3.5 };
            noise.DomainWrap(flat);
            noise.DomainWrap(solid);
            largest = Math.max(largest, ...[flat, solid].map((p) => Math.hypot(p.x - 1.3 * i, p.y - 0.7 * i)));
        }
    }
}
console.log(`displacement at amplitude 30: expected up to about 30; seen ${largest}`);
if (largest !== 0 || exported.includes("Vector2")) {
    console.error("the behaviour has changed");
    process.exit(1);
}
JS
node warp.mjs

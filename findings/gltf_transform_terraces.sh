#!/bin/sh
# glTF-Transform's quantize() measures heights with the length of the map: a terrain 4 km wide and 40 m high gets steps
# of 24 cm (about 160 levels), though its positions are stored in 16 bits.
# Versions: @gltf-transform/core and functions 4.5.1 (npm); Node.js 18 or newer.
# Surprise: 14 bits sound like 16 384 levels in each axis, 2.4 mm of 40 m. One scale serves all three axes, that of the
# longest, so the flatter a mesh, the coarser its relief: plains become terraces.
# Who is hit: height fields, sea surfaces and displaced planes in glTF files that were made smaller with quantize().
set -eu
dir=$(mktemp -d)
trap 'rm -rf "$dir"' EXIT
cd "$dir"
npm install --silent --no-save --no-audit --no-fund @gltf-transform/core@4.5.1 @gltf-transform/functions@4.5.1 \
    >/dev/null
cat >terrain.mjs <<'JS'
import { Document, Logger } from "@gltf-transform/core";
import { quantize } from "@gltf-transform/functions";

const count = 201, width = 4000, relief = 40;
const positions = new Float32Array(3 * count * count), triangles = [];
for (let j = 0; j < count; j++) {
    for (let i = 0; i < count; i++) {
        const at = j * count + i, height = relief / 4 * (Math.sin(0.05 * i) + Math.sin(0.03 * j));
        positions.set([i * width / (count - 1), height, j * width / (count - 1)], 3 * at);
        if (i && j) triangles.push(at, at - 1, at - count);
    }
}
const document = new Document().setLogger(new Logger(Logger.Verbosity.SILENT));
const buffer = document.createBuffer();
const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
const primitive = document.createPrimitive().setAttribute("POSITION", accessor("VEC3", positions.slice()))
    .setIndices(accessor("SCALAR", new Uint32Array(triangles)));
const node = document.createNode().setMesh(document.createMesh().addPrimitive(primitive));
document.createScene().addChild(node);
await document.transform(quantize());

const packed = primitive.getAttribute("POSITION"), levels = new Set(), element = [];
let error = 0;
for (let k = 0; k < packed.getCount(); k++) {
    levels.add(packed.getArray()[3 * k + 1]);
    const height = packed.getElement(k, element)[1] * node.getScale()[1] + node.getTranslation()[1];
    error = Math.max(error, Math.abs(height - positions[3 * k + 1]));
}
console.log(`positions in ${packed.getArray().constructor.name}, scale of the node ${node.getScale()}`);
console.log(`heights: expected up to 16384 levels; seen ${levels.size}; largest error ${error.toFixed(3)} m`);
if (levels.size > 200 || error < 0.1) {
    console.error("the behaviour has changed");
    process.exit(1);
}
JS
node terrain.mjs

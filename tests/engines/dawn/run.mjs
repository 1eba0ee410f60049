// Runs WGSL with Dawn, whose compiler is Tint, in Node.js: node run.mjs VALUES.raw gabor_noise
// or a compute shader that writes pictures of 256 values by the rows: node run.mjs VALUES.raw SHADER.wgsl ROWS PICTURES

import { readFileSync, writeFileSync } from "node:fs";
import { create, globals } from "webgpu";

Object.assign(globalThis, globals);
const [path, name, ...sizes] = process.argv.slice(2), [rows = 257, pictures = 1] = sizes.map(Number);
const here = file => new URL(file, import.meta.url);
const code = name.endsWith(".wgsl") ? readFileSync(name, "utf8")
    : readFileSync(here(`../../../shaders/translations/${name}.wgsl`), "utf8") + `
@group(0) @binding(0) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(8) fn main(@builtin(global_invocation_id) pixel: vec3u) {
    values[pixel.y * 256u + pixel.x] = gabor_noise((vec2f(pixel.xy) + 0.5) / 32.0, 4.0, 0.7854, 7u);
}`;

const gpu = create([]); // all else needs it alive
const adapter = await gpu.requestAdapter();
if (!adapter)
    throw Error("Dawn finds no device: set VK_ICD_FILENAMES");
const device = await adapter.requestDevice();
const module = device.createShaderModule({ code });
for (const { type, lineNum, message } of (await module.getCompilationInfo()).messages)
    console.error(`${type} in line ${lineNum}: ${message}`);
const pipeline = await device.createComputePipelineAsync({ layout: "auto", compute: { module, entryPoint: "main" } });

const size = 1024 * rows * pictures;
const values = device.createBuffer({ size, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
const read = device.createBuffer({ size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
pass.setPipeline(pipeline);
pass.setBindGroup(0, device.createBindGroup({
    layout: pipeline.getBindGroupLayout(0), entries: [{ binding: 0, resource: { buffer: values } }]
}));
pass.dispatchWorkgroups(32, rows);
pass.end();
encoder.copyBufferToBuffer(values, 0, read, 0, size);
device.queue.submit([encoder.finish()]);
await read.mapAsync(GPUMapMode.READ);
writeFileSync(path, new Uint8Array(read.getMappedRange()));
const { version } = JSON.parse(readFileSync(here("node_modules/webgpu/package.json")));
console.log(JSON.stringify({ engine: "Dawn", version, dialect: "WGSL by Tint", driver: adapter.info.description }));
device.destroy();

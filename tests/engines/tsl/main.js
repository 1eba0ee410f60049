import * as THREE from "three/webgpu";
import * as tsl from "three/tsl";
import * as gabor from "../../../shaders/nodes/three/gabor_noise.tsl.js";
import { functions } from "./functions.mjs";

const { screenCoordinate, uv, vec3, vec4 } = tsl;

// ?backend=webgl draws with WebGL 2.
const forceWebGL = new URLSearchParams(location.search).get("backend") === "webgl";
const target = new THREE.RenderTarget(256, 256, { type: THREE.FloatType, depthBuffer: false });

// Returns the red channel of the drawn picture. Rows count from the top on three.js' screen and in WebGPU, but WebGL
// reads targets from the bottom.
async function reds(renderer, render) {
    renderer.setRenderTarget(target);
    render();
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 256, 256);
    const values = pixels.filter((_, index) => index % 4 === 0);
    renderer.setRenderTarget(null);
    return Array.from({ length: 256 }, (_, y) => 256 * (forceWebGL ? 255 - y : y))
        .flatMap(start => Array.from(values.subarray(start, start + 256)));
}

// Returns the largest error of gabor_normal on a plane of side 4 that shows 8 kernel radii of noise and whose relief is 0.1
// times the noise.
async function normal_error(renderer) {
    const p = uv().mul(8), field = gabor.gabor_field(gabor.gabor_place_at(p), gabor.gabor_wave_vector(2, 0.5), 7);
    const wanted = tsl.normalize(vec3(field.gradient.mul(-0.1 * 8 / 4), 1));
    const material = new THREE.NodeMaterial();
    material.fragmentNode = vec4(vec3(tsl.length(gabor.gabor_normal(field.gradient, p, 0.1).sub(wanted))), 1);
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(4, 4), material));
    const camera = new THREE.OrthographicCamera(-2, 2, 2, -2, 0.1, 10);
    camera.position.z = 5;
    return Math.max(...await reds(renderer, () => renderer.render(scene, camera)));
}

// Returns how much fBm of Perlin noise in 3D, and warped and tiled smooth noise, change if they are filtered over no pixel.
async function filter_error(renderer) {
    const p = uv().mul(8), place = gabor.gabor_place_3d_at(vec3(p, 0.3)), fractal = gabor.gabor_fractal(4.3, 0.5, { basis: gabor.GABOR_PERLIN });
    const flat = gabor.gabor_warp({ ...gabor.gabor_place_tiled(p, tsl.vec2(4, 5)), evolution: 0.3 }, 0.3, gabor.gabor_fractal(3, 0.5), 7).place;
    const material = new THREE.NodeMaterial(), none = [tsl.vec2(0), tsl.vec2(0)], smooth = gabor.gabor_fractal(3, 0.5);
    material.fragmentNode = vec4(
        tsl.abs(gabor.gabor_fractal_noise_3d(place, fractal, 7).noise.sub(
            gabor.gabor_fractal_noise_3d_filtered(place, vec3(0), vec3(0), fractal, 7).noise)).add(
        tsl.abs(gabor.gabor_fractal_noise(flat, smooth, 7).noise.sub(gabor.gabor_fractal_noise_filtered(flat, ...none, smooth, 7).noise))), 0, 0, 1);
    return Math.max(...await reds(renderer, () => new THREE.QuadMesh(material).render(renderer)));
}

async function draw() {
    const renderer = new THREE.WebGPURenderer({ forceWebGL });
    await renderer.init();
    renderer.setSize(256, 256);
    document.body.append(renderer.domElement);
    const driver = forceWebGL
        ? renderer.backend.gl.getParameter(renderer.backend.gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL)
        : Object.values((({ vendor, architecture }) => ({ vendor, architecture }))(renderer.backend.device.adapterInfo)).join(" ");
    if (!forceWebGL && !renderer.backend.isWebGPUBackend)
        throw new Error("three.js fell back to WebGL");

    const made = functions(gabor, tsl, screenCoordinate.xy.div(32)), values = [];
    for (const value of Object.values(made)) {
        const quad = new THREE.QuadMesh(new THREE.NodeMaterial());
        quad.material.fragmentNode = vec4(vec3(value), 1);
        values.push(...await reds(renderer, () => quad.render(renderer)));
    }
    const error = await normal_error(renderer);
    if (!(error < 1e-3))
        throw new Error(`gabor_normal is off by ${error}`);
    const filtered = await filter_error(renderer);
    if (!(filtered < 1e-4))
        throw new Error(`without a pixel, filters change noise by ${filtered}`);

    const shown = new THREE.QuadMesh(new THREE.NodeMaterial());
    shown.material.fragmentNode = vec4(vec3(gabor.gabor_unorm(made.noise)), 1);
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    shown.render(renderer);
    return {
        engine: "three.js nodes", version: THREE.REVISION, dialect: forceWebGL ? "TSL, GLSL 300 es" : "TSL, WGSL", driver,
        functions: Object.keys(made), values,
    };
}

globalThis.drawn = draw();

import * as THREE from "three/webgpu";
import { screenCoordinate, float, uint, vec3, vec4 } from "three/tsl";
import { gabor_noise, gabor_unorm } from "../../../shaders/nodes/three/gabor_lattice.tsl.js";

// ?backend=webgl draws with WebGL 2.
const forceWebGL = new URLSearchParams(location.search).get("backend") === "webgl";

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

    const noise = gabor_noise(screenCoordinate.xy.div(32), float(4), float(0.7854), uint(7));
    const quad = new THREE.QuadMesh(new THREE.NodeMaterial());
    const target = new THREE.RenderTarget(256, 256, { type: THREE.FloatType, depthBuffer: false });
    quad.material.fragmentNode = vec4(vec3(noise), 1);
    renderer.setRenderTarget(target);
    quad.render(renderer);
    const pixels = await renderer.readRenderTargetPixelsAsync(target, 0, 0, 256, 256);
    const values = pixels.filter((_, index) => index % 4 === 0);
    // Rows of the screen go down in three.js, and so do WebGPU's; WebGL's targets are read from below.
    const row = y => values.subarray(256 * (forceWebGL ? 255 - y : y)).subarray(0, 256);

    const shown = new THREE.QuadMesh(new THREE.NodeMaterial());
    shown.material.fragmentNode = vec4(vec3(gabor_unorm(noise)), 1);
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
    renderer.setRenderTarget(null);
    shown.render(renderer);
    return {
        engine: "three.js nodes", version: THREE.REVISION, dialect: forceWebGL ? "TSL, GLSL 300 es" : "TSL, WGSL", driver,
        values: Array.from({ length: 256 }, (_, y) => Array.from(row(y))).flat(),
    };
}

globalThis.drawn = draw();

import * as THREE from "three";
import CustomShaderMaterial from "three-custom-shader-material/vanilla";

// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

async function draw() {
    const renderer = new THREE.WebGLRenderer({ preserveDrawingBuffer: true });
    renderer.outputColorSpace = THREE.LinearSRGBColorSpace; // shows the same grey values as other engines
    renderer.setSize(256, 257);
    document.body.append(renderer.domElement);
    const material = new CustomShaderMaterial({
        baseMaterial: THREE.MeshBasicMaterial,
        uniforms: { shown: { value: false } },
        fragmentShader: noise + `
            uniform bool shown;
            void main()
            {
                vec2 p = gl_FragCoord.xy / 32.0;
                float n = gabor_noise(p, 4.0, 0.7854, 7u);
                csm_DiffuseColor = vec4(vec3(shown ? gabor_unorm(n) : n), 1.0);
            }`,
    });
    const scene = new THREE.Scene(), camera = new THREE.OrthographicCamera(-1, 1, 1, -1, -1, 1);
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));

    const target = new THREE.WebGLRenderTarget(256, 257, { type: THREE.FloatType, depthBuffer: false });
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    const pixels = new Float32Array(4 * 256 * 257);
    renderer.readRenderTargetPixels(target, 0, 0, 256, 257, pixels);

    renderer.setRenderTarget(null);
    material.uniforms.shown.value = true;
    renderer.render(scene, camera);

    const gl = renderer.getContext();
    return {
        engine: "three-custom-shader-material", version: (await (await fetch("./node_modules/three-custom-shader-material/package.json")).json()).version, dialect: "GLSL 300 es",
        driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
        values: pixels.filter((_, index) => index % 4 === 0),
    };
}

globalThis.drawn = draw();

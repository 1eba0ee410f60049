import * as THREE from "three";

// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

async function draw() {
    const renderer = new THREE.WebGLRenderer();
    renderer.setSize(256, 257);
    document.body.append(renderer.domElement);
    const material = new THREE.ShaderMaterial({
        glslVersion: THREE.GLSL3,
        uniforms: { shown: { value: false } },
        vertexShader: "void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }",
        fragmentShader: noise + `
            uniform bool shown;
            out vec4 value;
            void main()
            {
                vec2 p = gl_FragCoord.xy / 32.0;
                float n = gabor_noise(p, 4.0, 0.7854, 7u);
                value = vec4(vec3(shown ? gabor_unorm(n) : n), 1.0);
            }`,
    });
    const scene = new THREE.Scene();
    scene.add(new THREE.Mesh(new THREE.PlaneGeometry(2, 2), material));

    const target = new THREE.WebGLRenderTarget(256, 257, { type: THREE.FloatType, depthBuffer: false });
    renderer.setRenderTarget(target);
    renderer.render(scene, new THREE.Camera());
    const pixels = new Float32Array(4 * 256 * 257);
    renderer.readRenderTargetPixels(target, 0, 0, 256, 257, pixels);

    renderer.setRenderTarget(null);
    material.uniforms.shown.value = true;
    renderer.render(scene, new THREE.Camera());

    const gl = renderer.getContext();
    return {
        engine: "three.js", version: THREE.REVISION, dialect: "GLSL 300 es",
        driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
        values: pixels.filter((_, index) => index % 4 === 0),
    };
}

globalThis.drawn = draw();

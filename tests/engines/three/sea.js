// A sea whose vertices gabor_water moves, and a box that floats at the height that the CPU computes: sea.cpp, 14 kB of
// WebAssembly, gives the shader its parameters and the box its heights. Drag to turn.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const drop_in = async name => (await fetch(`./node_modules/gabor-noise/shaders/${name}.glsl`)).text();
const drop_ins = await drop_in("gabor_noise") + await drop_in("gabor_ocean");
const cpu = (await WebAssembly.instantiate(await (await fetch("sea.wasm")).arrayBuffer())).instance.exports;

const wind = 12, seed = 7, side = 200, vertices = 512;

// The members of GaborOcean in memory, as uniforms.
function uniforms_of(address) {
    const floats = new Float32Array(cpu.memory.buffer, address), ints = new Int32Array(cpu.memory.buffer, address);
    const band = at => ({
        amplitude: floats[at], exponent: ints[at + 1], low: floats[at + 2], orbit: floats[at + 3], slopes: floats.slice(at + 4, at + 6),
        widen: floats.slice(at + 6, at + 8), spread: floats.slice(at + 8, at + 10), blunt: floats[at + 10], rise: floats[at + 11],
        knots: floats.slice(at + 12, at + 16), faster: floats.slice(at + 16, at + 20), last: floats.slice(at + 20, at + 22),
        carry: floats.slice(at + 22, at + 24), number: floats.slice(at + 24, at + 26), drift: ints.slice(at + 26, at + 28),
    });
    return { wind: floats[0], direction: floats[1], fetch: floats[2], water_depth: floats[3], swell: floats.slice(4, 7), loop_seconds: ints[7],
             tail: floats.slice(8, 10), high: floats.slice(10, 12), band: Array.from({ length: 11 }, (_, i) => band(12 + 28 * i)) };
}

const uniforms = { seconds: { value: 0 }, ocean: { value: uniforms_of(cpu.sea(wind)) } };
const sun = new THREE.Vector3(-0.5, 0.25, -0.8).normalize();
const shared = `
    ${drop_ins}
    uniform float seconds;
    uniform GaborOcean ocean;`;
const water = new THREE.ShaderMaterial({
    glslVersion: THREE.GLSL3,
    uniforms,
    vertexShader: `${shared}
        const float spacing = ${side}.0 / ${vertices}.0; // waves too short for the vertices are left out
        out vec2 p;
        out vec3 eye;
        void main() {
            p = position.xz;
            GaborWater w = gabor_water_filtered(p, vec2(spacing, 0.0), vec2(0.0, spacing), seconds, ocean, ${seed}u);
            vec3 place = vec3(p.x + w.shift.x, w.height, p.y + w.shift.y);
            eye = cameraPosition - place;
            gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
        }`,
    fragmentShader: `${shared}
        in vec2 p;
        in vec3 eye;
        out vec4 colour;
        vec3 sky(vec3 ray) { return mix(vec3(0.62, 0.72, 0.82), vec3(0.18, 0.36, 0.62), sqrt(max(ray.y, 0.0))); }
        void main() {
            GaborWater w = gabor_water_filtered(p, dFdx(p), dFdy(p), seconds, ocean, ${seed}u);
            vec2 slope = w.slope / clamp(w.jacobian, 0.4, 2.0); // where p + shift is
            vec3 normal = normalize(vec3(-slope.x, 1.0, -slope.y)), ray = normalize(eye);
            vec3 sun = vec3(${sun.toArray().join(", ")}), h = normalize(sun + ray);
            float rough = w.lost.x + w.lost.y + 0.0004, facing = max(dot(normal, ray), 0.0);
            float mirrored = 0.02 + 0.98 * pow(1.0 - facing, 5.0) / (1.0 + 22.0 * rough);
            vec2 tilt = h.xz / h.y + slope; // of the facets that mirror the sun, from the mean slope
            float glitter = exp(-dot(tilt, tilt) / rough) / (rough * max(facing, 0.1));
            vec3 light = vec3(0.01, 0.06, 0.07) * (0.6 + 0.4 * dot(normal, sun)) * exp(0.4 * w.height);
            light = mix(light, sky(reflect(-ray, normal)), mirrored) + 0.02 * glitter * vec3(1.0, 0.85, 0.6);
            light = mix(light, vec3(0.8), 0.9 * gabor_foam(p, dFdx(p), dFdy(p), w, ocean, ${seed}u));
            float t = length(eye);
            colour = vec4(mix(sky(vec3(0.0)), light, exp(-1.0e-4 * t * t)), 1.0);
            colour.rgb = pow(colour.rgb, vec3(1.0 / 2.2));
        }`,
});

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0.62, 0.72, 0.82);
const sea = new THREE.Mesh(new THREE.PlaneGeometry(side, side, vertices, vertices).rotateX(-Math.PI / 2), water);
sea.frustumCulled = false; // three.js would use the bounds of the flat plane
const box = new THREE.Mesh(new THREE.BoxGeometry(3, 2, 3), new THREE.MeshStandardMaterial({ color: 0xc8642a }));
const lamp = new THREE.DirectionalLight(0xffeed8, 3);
lamp.position.copy(sun);
scene.add(sea, box, lamp, new THREE.HemisphereLight(0xbfd4ff, 0x203038, 1.5));
const camera = new THREE.PerspectiveCamera(45, innerWidth / innerHeight, 0.1, 500);
camera.position.set(10, 5, 16);
new OrbitControls(camera, renderer.domElement);

// Floats the box at (x, z): its height and tilt follow the water under its corners.
function float_box(x, z, seconds) {
    const [a, b, c, d] = [[-1, -1], [1, -1], [-1, 1], [1, 1]].map(([i, j]) => cpu.height(x + 1.5 * i, z + 1.5 * j, seconds, seed));
    const normal = new THREE.Vector3((a + c - b - d) / 6, 1, (a + b - c - d) / 6).normalize();
    box.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), normal);
    box.position.set(x, (a + b + c + d) / 4 + 0.3, z);
}

export { cpu, renderer, shared, uniforms }; // for a check of the heights
renderer.setAnimationLoop(milliseconds => {
    uniforms.seconds.value = milliseconds / 1000;
    float_box(0, 0, uniforms.seconds.value);
    renderer.render(scene, camera);
    globalThis.drawn = true;
});

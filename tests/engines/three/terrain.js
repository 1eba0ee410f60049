// Draws a plane whose vertices gabor_eroded lifts, with three.js' standard material. Drag to turn it.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const drop_in = async name => (await fetch(`./node_modules/gabor-noise/shaders/${name}.glsl`)).text();
const drop_ins = await drop_in("gabor_noise") + await drop_in("gabor_erosion");

const material = new THREE.MeshStandardMaterial({ roughness: 1 });
material.onBeforeCompile = shader => {
    shader.vertexShader = shader.vertexShader
        .replace("#include <common>", `#include <common>
            ${drop_ins}
            varying vec3 height_slope_ridge;
            const float spacing = 8.0 / 511.0; // vertex spacing; gullies too fine for it fade out
            GaborTerrain ground(vec2 p) {
                vec2 x = vec2(spacing, 0.0), y = vec2(0.0, spacing);
                return gabor_eroded_at(GaborTerrainPlace(ivec2(0), p, vec2(0.0)), x, y, gabor_terrain(p, 7u), gabor_erosion(), 7u);
            }`)
        .replace("#include <beginnormal_vertex>", `
            GaborTerrain here = ground(position.xz);
            vec3 objectNormal = normalize(vec3(-here.slope.x, 1.0, -here.slope.y));
            height_slope_ridge = vec3(here.height, length(here.slope), here.ridge);`)
        .replace("#include <begin_vertex>", "vec3 transformed = vec3(position.x, here.height, position.z);");
    shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", "#include <common>\nvarying vec3 height_slope_ridge;")
        .replace("#include <color_fragment>", `
            vec3 ground = height_slope_ridge;
            vec3 rock = mix(vec3(0.18, 0.15, 0.13), vec3(0.38, 0.35, 0.32), 0.5 + 0.5 * ground.z);
            float grass = smoothstep(0.9, 0.5, ground.y) * smoothstep(0.35, 0.0, ground.x);
            float snow = smoothstep(0.25, 0.5, ground.x - 0.1 * ground.z) * smoothstep(1.4, 0.8, ground.y);
            diffuseColor.rgb = mix(mix(rock, vec3(0.11, 0.14, 0.05), grass), vec3(0.9), snow);`);
};

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
renderer.toneMapping = THREE.ACESFilmicToneMapping;
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0.6, 0.72, 0.85);
scene.fog = new THREE.Fog(scene.background, 6, 16);
const mountains = new THREE.Mesh(new THREE.PlaneGeometry(8, 8, 511, 511).rotateX(-Math.PI / 2), material);
mountains.frustumCulled = false; // three.js would use the bounds of the flat plane
scene.add(mountains, new THREE.HemisphereLight(0xbfd4ff, 0x4a3f35, 1));
const sun = new THREE.DirectionalLight(0xffe8c8, 4);
sun.position.set(-2, 1.2, 1);
scene.add(sun);
const camera = new THREE.PerspectiveCamera(40, innerWidth / innerHeight, 0.1, 50);
camera.position.set(0, 2.6, 6);
const controls = new OrbitControls(camera, renderer.domElement);
controls.addEventListener("change", () => renderer.render(scene, camera));
controls.update();
renderer.render(scene, camera);
globalThis.drawn = true;

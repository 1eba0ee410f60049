// Draws a plane whose vertices gabor_eroded lifts, with three.js' standard material. Drag to turn it.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const drop_in = async name => (await fetch(`./node_modules/gabor-noise/shaders/${name}.glsl`)).text();
const drop_ins = await drop_in("gabor_noise") + await drop_in("gabor_erosion");

const material = new THREE.MeshStandardMaterial({ roughness: 1 });
material.onBeforeCompile = shader => {
    const shared = `#include <common>
        ${drop_ins}
        varying vec2 at;
        GaborTerrain ground(vec2 dx, vec2 dy) { // without what is too fine for steps of dx and dy
            return gabor_eroded_at(GaborTerrainPlace(ivec2(0), at, vec2(0.0)), dx, dy, gabor_terrain(at, 7u), gabor_erosion(), 7u);
        }`;
    shader.vertexShader = shader.vertexShader
        .replace("#include <common>", shared)
        .replace("#include <begin_vertex>", `
            const float spacing = 8.0 / 511.0; // of vertices
            at = position.xz;
            vec3 transformed = vec3(at.x, ground(vec2(spacing, 0.0), vec2(0.0, spacing)).height, at.y);`);
    shader.fragmentShader = shader.fragmentShader
        .replace("#include <common>", shared)
        .replace("#include <color_fragment>", `
            GaborTerrain here = ground(dFdx(at), dFdy(at));
            vec4 cover = gabor_ground_cover(here);
            diffuseColor.rgb = cover.x * vec3(0.11, 0.14, 0.05) + cover.y * vec3(0.3, 0.25, 0.16) + cover.z * vec3(0.28, 0.25, 0.22)
                + cover.w * vec3(0.9);`)
        .replace("#include <normal_fragment_maps>", `
            normal = normalize((viewMatrix * vec4(-here.slope.x, 1.0, -here.slope.y, 0.0)).xyz);`);
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

// The glTF material of a folder that `gabor render --maps` wrote, in the room and under the lamp of the viewer's lit view
// (shaders/passes/light.glsl): material.html?maps=FOLDER&lights=AZIMUTH/ELEVATION;...
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const query = new URLSearchParams(location.search);
const lights = query.get("lights").split(";").map(light => light.split("/").map(Number));

function smoothstep(low, high, x) {
    const t = Math.min(Math.max((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

// The room on a map of all directions: its middle is -z, its top +y.
function room(height) {
    const values = new Float32Array(2 * height * height * 4);
    for (let row = 0, i = 0; row < height; ++row)
        for (let column = 0; column < 2 * height; ++column) {
            const up = Math.PI * ((row + 0.5) / height - 0.5), around = Math.PI * (column + 0.5) / height;
            const [x, y] = [-Math.cos(up) * Math.cos(around), -Math.sin(up)]; // y down
            const open = smoothstep(-0.3, 0.3, 0.35 - Math.abs(x + 0.12 - 0.2 * y)) * smoothstep(-0.3, 0.3, 0.4 - y);
            values.set([0.13 + 0.8 * open, 0.14 + 0.85 * open, 0.16 + 0.95 * open, 1], i++ * 4);
        }
    const map = new THREE.DataTexture(values, 2 * height, height, THREE.RGBAFormat, THREE.FloatType);
    map.mapping = THREE.EquirectangularReflectionMapping;
    map.needsUpdate = true;
    return map;
}

async function draw() {
    const gltf = await new GLTFLoader().loadAsync(`${query.get("maps")}/material.gltf`);
    const { material } = gltf.scene.children[0];
    const { width, height } = material.map.image;
    const renderer = new THREE.WebGLRenderer();
    renderer.setSize(width, height);
    document.body.append(renderer.domElement);
    const scene = new THREE.Scene();
    scene.environment = room(128);
    scene.add(gltf.scene);
    if (query.has("open")) // without occlusion, which the viewer does not have
        material.aoMap = null;
    const lamp = new THREE.PointLight(new THREE.Color(1, 0.96, 0.9), 0.7 * Math.PI, 0, 0);
    scene.add(lamp);
    const camera = new THREE.PerspectiveCamera(0, width / height, 0.1, 10);
    camera.fov = 2 * Math.atan(height / Math.max(width, height) / 2 / 1.8) * 180 / Math.PI;
    camera.updateProjectionMatrix();
    camera.position.z = 1.8;
    const target = new THREE.WebGLRenderTarget(width, height, { type: THREE.FloatType });
    const values = [];
    for (const [azimuth, elevation] of lights) {
        const [a, e] = [azimuth, elevation].map(angle => angle * Math.PI / 180);
        lamp.position.set(2.5 * Math.cos(e) * Math.cos(a), -2.5 * Math.cos(e) * Math.sin(a), 2.5 * Math.sin(e));
        renderer.setRenderTarget(target);
        renderer.render(scene, camera);
        const rgba = new Float32Array(4 * width * height); // rows from the lowest up
        renderer.readRenderTargetPixels(target, 0, 0, width, height, rgba);
        values.push(...Array.from({ length: height }, (_, row) => rgba.subarray(4 * width * (height - 1 - row),
                                                                               4 * width * (height - row))));
    }
    renderer.setRenderTarget(null);
    renderer.render(scene, camera);
    return { engine: "three.js", version: THREE.REVISION, dialect: "GLSL ES", driver: "WebGL", picture: true,
             values: values.flatMap(row => Array.from(row)) };
}

globalThis.drawn = draw();

// Opens every tab of docs/demo/index.html with every option and with sliders and colours off their defaults, runs what it copies
// in each language, and compares the pixels: Shadertoy's with the tab's, and the function's values in GLSL with those in WGSL and
// as nodes. Then measures the noise of one tab.
const SIDE = 64, WIDTH = 160, HEIGHT = 90, TIME = 1.5; // TIME is in seconds
// Values of each kind of function at p.
const VALUES = {
    pattern: "pattern(p)", sea: "sea_in_pixel(4.0 * p, 0.01)",
    material: "vec3(m.colour.g + m.metalness, m.slope.x + m.slope.y, m.height + m.roughness)",
    terrain: "vec3(m.height + m.ridge, m.slope)",
};
const STEP = 20 / 1024; // of the land's map, on a small screen

function open(tab, settings) {
    history.replaceState(null, "", "#" + new URLSearchParams({ tab, bare: "", ...settings }));
    readAddress();
    controlsOf();
}
function textIn(name) {
    const list = document.getElementById("language");
    list.value = name;
    list.dispatchEvent(new Event("change"));
    if (language() !== name)
        throw new Error(`${state.tab} does not offer ${name}`);
    return document.querySelector("textarea").value;
}

const pixelsOf = (gl, width, height) => {
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
};

// Draws the tab at the size of a small screen.
async function drawn() {
    clearTimeout(settle);
    const message = document.getElementById("compiling");
    const once = () => {
        [moving, sharpness, asked] = [false, 1, true];
        drawTab(1000 * TIME);
        return pixelsOf(gl, view.width, view.height); // waits, so that draws do not queue up
    };
    const known = programs.size, shows = new MutationObserver(() => {});
    shows.observe(message, { attributeFilter: ["hidden"], attributeOldValue: true });
    once();
    if (programs.size > known && !shows.takeRecords().some(({ oldValue }) => oldValue !== null)) // even if it is hidden again by now
        throw new Error("the page does not say that it compiles");
    shows.disconnect();
    for (; !message.hidden; once())
        await pause(50);
    return once();
}

function compare(what, made, wanted, tolerance) {
    const far = made.reduce((sum, value, i) => sum + !(Math.abs(value - wanted[i]) <= tolerance), 0) / wanted.length;
    if (made.length !== wanted.length || !(far < 0.003))
        throw new Error(`${what}: ${(100 * far).toFixed(2)} % of the values differ: ${made.slice(0, 4)} from ${wanted.slice(0, 4)}`);
    if (!(Math.max(...wanted) - Math.min(...wanted) > 0.01))
        throw new Error(`${what}: all values are ${wanted[0]}`);
}

// ---- Each language's values at points that are 1 / 16 kernel radii apart, or texels of the land's map apart ----
const place = pixel => kind() === "terrain" ? `${STEP.toFixed(9)} * ${pixel}` : `0.0625 * ${pixel}`;
const called = type => (VALUES[kind()].includes("m.") ? `${type} m = ${kind()}(p); ` : "") + `return vec4(${VALUES[kind()]}, 1.0);`;

const own = document.createElement("canvas").getContext("webgl2");
own.getExtension("EXT_color_buffer_float");
function inGlsl(text) {
    const target = own.createTexture(), pixels = new Float32Array(4 * SIDE * SIDE);
    own.bindTexture(own.TEXTURE_2D, target);
    own.texStorage2D(own.TEXTURE_2D, 1, own.RGBA32F, SIDE, SIDE);
    own.bindFramebuffer(own.FRAMEBUFFER, own.createFramebuffer());
    own.framebufferTexture2D(own.FRAMEBUFFER, own.COLOR_ATTACHMENT0, own.TEXTURE_2D, target, 0);
    own.bindTexture(own.TEXTURE_2D, painting);
    draw(own, `${text}
#define mainImage(color, pixel) color = value_at(pixel)
vec4 value_at(vec2 pixel) { vec2 p = ${place("pixel")}; ${called(kind() === "material" ? "GaborMaterial" : "GaborTerrain")} }`.replace("uniform float iTime; // seconds\n", ""),
         SIDE, SIDE, TIME);
    own.readPixels(0, 0, SIDE, SIDE, own.RGBA, own.FLOAT, pixels);
    own.bindFramebuffer(own.FRAMEBUFFER, null);
    return pixels;
}

let device = null;
async function inWgsl(text) {
    const module = device.createShaderModule({ code: `${text}
@vertex fn cover(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1) * 4.0 - 1.0, f32(index & 2) * 2.0 - 1.0, 0.0, 1.0);
}
@fragment fn value_at(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let p = ${place("pixel.xy")};
    ${called("let")}
}` });
    const format = "rgba32float";
    device.pushErrorScope("validation");
    const pipeline = device.createRenderPipeline({ layout: "auto", vertex: { module }, fragment: { module, targets: [{ format }] } });
    const failure = await device.popErrorScope();
    if (failure)
        throw new Error(`${state.tab}: ${(await module.getCompilationInfo()).messages.map(each => each.message)} ${failure.message}`);
    const target = device.createTexture({ size: [SIDE, SIDE], format, usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
    const buffer = device.createBuffer({ size: 16 * SIDE * SIDE, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const entries = [];
    if (text.includes("var<uniform> iTime")) {
        const time = device.createBuffer({ size: 4, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
        device.queue.writeBuffer(time, 0, Float32Array.of(TIME));
        entries.push({ buffer: time });
    } else if (text.includes("var painted")) {
        const map = device.createTexture({ size: [PAINTED_SIDE, PAINTED_SIDE], format: "rgba8unorm",
                                           usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.RENDER_ATTACHMENT });
        device.queue.copyExternalImageToTexture({ source: saved }, { texture: map }, [PAINTED_SIDE, PAINTED_SIDE]);
        entries.push(map.createView(), device.createSampler({ minFilter: "linear", magFilter: "linear" }));
    }
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view: target.createView(), loadOp: "clear", storeOp: "store" }] });
    pass.setPipeline(pipeline);
    if (entries.length)
        pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
                                                      entries: entries.map((resource, binding) => ({ binding, resource })) }));
    pass.draw(3);
    pass.end();
    encoder.copyTextureToBuffer({ texture: target }, { buffer, bytesPerRow: 16 * SIDE }, [SIDE, SIDE]);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    return new Float32Array(buffer.getMappedRange());
}

const three = name => new URL(`../../tests/engines/three/node_modules/three/build/${name}.js`, location.href.split("#")[0]).href;
let renderer = null;
async function asNodes(text) {
    const { QuadMesh, NodeMaterial, RenderTarget, FloatType, WebGPURenderer } = await import("three/webgpu");
    const { screenCoordinate, vec4 } = await import("three/tsl");
    const still = text.replace('import { time } from "three/tsl";', `const time = ${TIME};`);
    const { pattern } = await import(URL.createObjectURL(new Blob([still], { type: "text/javascript" })));
    renderer ??= new WebGPURenderer();
    await renderer.init();
    const quad = new QuadMesh(new NodeMaterial()), target = new RenderTarget(SIDE, SIDE, { type: FloatType, depthBuffer: false });
    quad.material.fragmentNode = vec4(pattern(screenCoordinate.xy.mul(0.0625)), 1);
    renderer.setRenderTarget(target);
    quad.render(renderer);
    return renderer.readRenderTargetPixelsAsync(target, 0, 0, SIDE, SIDE);
}

// ---- Tabs ----

// Sliders and colours off their defaults, and options at them.
const settingsOf = tab => Object.fromEntries(TABS[tab].controls.map(each => [each.name, each.options || each.check ? each.value
    : each.colour ? "#3b7ea1" : +(each.min + 0.37 * (each.max - each.min)).toFixed(each.step < 1 ? 4 : 0)]));
const OPTIONS = {
    erosion: [{ octaves: 3 }],
    sea: [{ wind: 18, sun: 15, altitude: 9, seconds: 61.25, moving: false }],
    materials: [...new Set(MATERIALS.controls.map(each => each.name.split(".")[0]))].map(preset => ({ preset }))
        .concat({ preset: "oak-planks", boards: true }),
    noise: [{ look: "plain", taps: 2 }, { look: "relief", taps: 4 }, ...["plain", "relief", "colours", "evolving"].map(look => ({ look }))],
};
const optionsOf = tab => OPTIONS[tab] ?? TABS[tab].controls.filter(each => each.options)
    .flatMap(({ name, options }) => options.map(option => ({ [name]: option }))).concat({});

let saved = null, painting = null; // the map of directions as the page saves it
async function saveMap() {
    const { click } = HTMLAnchorElement.prototype;
    let address = "";
    HTMLAnchorElement.prototype.click = function () { address = this.href; };
    document.getElementById("download").click();
    HTMLAnchorElement.prototype.click = click;
    saved = await createImageBitmap(await (await fetch(address)).blob(), { colorSpaceConversion: "none" });
    painting = own.createTexture();
    own.bindTexture(own.TEXTURE_2D, painting);
    own.texImage2D(own.TEXTURE_2D, 0, own.RGBA, own.RGBA, own.UNSIGNED_BYTE, saved);
    for (const [name, value] of [["MIN_FILTER", "LINEAR"], ["MAG_FILTER", "LINEAR"], ["WRAP_S", "CLAMP_TO_EDGE"], ["WRAP_T", "CLAMP_TO_EDGE"]])
        own.texParameteri(own.TEXTURE_2D, own[`TEXTURE_${name}`], own[value]);
}

// Drops a picture of a wave whose crests are 30 degrees from the vertical.
async function dropPicture() {
    const canvas = Object.assign(document.createElement("canvas"), { width: 300, height: 200 }), context = canvas.getContext("2d");
    const turn = Math.PI / 6;
    for (let x = 0; x < 300; ++x)
        for (let y = 0; y < 200; ++y) {
            context.fillStyle = `hsl(0 0% ${50 + 40 * Math.sin(0.2 * (x * Math.cos(turn) + y * Math.sin(turn)))}%)`;
            context.fillRect(x, y, 1, 1);
        }
    const dropped = new DataTransfer();
    dropped.items.add(new File([await new Promise(resolve => canvas.toBlob(resolve))], "wave.png", { type: "image/png" }));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: dropped, bubbles: true }));
    while (values().field !== "painted")
        await pause(20);
    for (let i = 64 * PAINTED_SIDE + 32; i < 64 * PAINTED_SIDE + 96; ++i)
        if (Math.hypot(direction(i)[0] - Math.cos(2 * turn), direction(i)[1] - Math.sin(2 * turn)) > 0.05)
            throw new Error(`the dropped picture gives ${direction(i)}`);
}

async function checkTab(name, settings) {
    const what = `${name} with ${JSON.stringify(settings)}`;
    open(name, { ...settingsOf(name), x: 0.3, y: -0.2, zoom: 1.3, yaw: 0.8, pitch: 0.2, ...settings });
    const shown = await drawn(), offered = languages();
    const glsl = inGlsl(textIn("GLSL"));
    if (tab().terrain) {
        const map = new Float32Array(4 * SIDE * SIDE), code = textIn("GLSL").slice(dropIns().length);
        gl.bindFramebuffer(gl.FRAMEBUFFER, land.frame);
        gl.readPixels(0, 0, SIDE, SIDE, gl.RGBA, gl.FLOAT, map);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        for (let i = 0; i < map.length; i += 4)
            map.set([map[i] + map[i + 3], map[i + 1], map[i + 2], 1], i);
        compare(`${what}, GLSL`, inGlsl(dropIns() + repeated(code)), map, 2e-3);
    }
    const constants = Object.entries(mainValues()).map(constant).join("");
    const picture = offered.includes("Shadertoy") ? textIn("Shadertoy") : textIn("GLSL") + constants + MAIN[kind()];
    own.bindTexture(own.TEXTURE_2D, painting);
    Object.assign(own.canvas, { width: view.width, height: view.height });
    draw(own, picture, view.width, view.height, TIME);
    if (!tab().terrain) // whose picture in Shadertoy is a map
        compare(`${what}, Shadertoy`, pixelsOf(own, view.width, view.height), shown, 4);
    if (device && offered.includes("WGSL"))
        compare(`${what}, WGSL`, await inWgsl(textIn("WGSL")), glsl, 2e-3);
    if (device && offered.includes("TSL"))
        compare(`${what}, TSL`, await asNodes(textIn("TSL")), glsl, 2e-3);
}

globalThis.drawn = (async () => {
    asked = true; // the page itself draws nothing until the end
    document.head.append(Object.assign(document.createElement("script"), { type: "importmap", textContent: JSON.stringify({ imports: {
        "three": three("three.webgpu"), "three/webgpu": three("three.webgpu"), "three/tsl": three("three.tsl") } }) }));
    device = await (await navigator.gpu?.requestAdapter())?.requestDevice() ?? null;
    if (!device && navigator.userAgent.includes("Chrome"))
        throw new Error("there is no WebGPU");
    const size = [innerWidth, innerHeight];
    const resize = (width, height) => Object.defineProperties(globalThis, {
        innerWidth: { value: width, configurable: true }, innerHeight: { value: height, configurable: true } });
    resize(WIDTH, HEIGHT);
    await dropPicture();
    await saveMap();
    for (const name of Object.keys(TABS))
        for (const settings of optionsOf(name))
            await checkTab(name, settings);

    open("sea", { moving: true });
    if (!textIn("Shadertoy").includes("int(iTime)"))
        throw new Error("sea: copied waves do not move");
    await usePage(() => pixelsOf(gl, view.width, view.height));
    resize(...size);
    open("noise", { look: "plain", frequency: 4, orientation: 45, seed: 7, taps: 3 });
    const text = textIn("Shadertoy") // with the pixels of the reference: p = pixel / 32, y upwards
        .replace(/vec2 p = vec2\(x, y\).*;/, "vec2 p = pixel / 32.0;");
    asked = false;
    changed();
    await until(() => !moving && !asked && element("compiling").hidden, "draws at full resolution");
    return { engine: `live page, ${navigator.userAgent.includes("Firefox") ? "Firefox" : "Chromium"}`, dialect: "GLSL 300 es", ...measure(document.createElement("canvas"), text) };
})();

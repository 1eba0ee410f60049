// Opens every tab of docs/demo/index.html with every option and with sliders and colours off their defaults, runs what it copies
// in each language, and compares the pixels with the page's. Uses the page as people do, and measures the noise of one tab. In the
// address, only=TAB.TAB.page does less. run.mjs offers hlslInGlsl.
const WIDTH = 160, HEIGHT = 90, TIME = 1.5; // TIME is in seconds

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
function flipped(pixels) {
    const rows = [...Array(HEIGHT).keys()].map(row => pixels.subarray(4 * WIDTH * row, 4 * WIDTH * (row + 1))), made = new Uint8Array(pixels.length);
    rows.reverse().forEach((row, i) => made.set(row, 4 * WIDTH * i));
    return made;
}

function compare(what, made, wanted, tolerance) {
    let worst = 0, place = 0, far = 0;
    made.forEach((value, i) => {
        const apart = Math.abs(value - wanted[i]);
        far += !(apart <= tolerance) / wanted.length;
        if (!(apart <= worst))
            [worst, place] = [apart, i];
    });
    const said = `${what}: largest difference ${worst} at column ${(place >> 2) % WIDTH}, row ${Math.floor(place / 4 / WIDTH)}`;
    if (made.length !== wanted.length || !(far < 0.003))
        throw new Error(`${said}; ${(100 * far).toFixed(2)} % of the values differ`);
    if (!(Math.max(...wanted.filter((_, i) => i % 4 < 3)) - Math.min(...wanted) > 3))
        throw new Error(`${what}: all values are ${wanted[0]}`);
}

// ---- Each language's picture ----
const own = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT }).getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
function programIn(text) {
    const program = own.createProgram();
    for (const [type, source] of [[own.VERTEX_SHADER, VERTEX], [own.FRAGMENT_SHADER, text]]) {
        const shader = own.createShader(type);
        own.shaderSource(shader, source);
        own.compileShader(shader);
        if (!own.getShaderParameter(shader, own.COMPILE_STATUS))
            throw new Error(`${state.tab}: ${own.getShaderInfoLog(shader)}`);
        own.attachShader(program, shader);
    }
    own.linkProgram(program);
    own.useProgram(program);
    return program;
}
function inGlsl(text) {
    const program = programIn(text);
    own.bindTexture(own.TEXTURE_2D, painting_);
    for (let i = 0; i < own.getProgramParameter(program, own.ACTIVE_UNIFORMS); ++i) {
        const { name } = own.getActiveUniform(program, i), place = own.getUniformLocation(program, name);
        if (name.endsWith("resolution"))
            own.uniform2f(place, WIDTH, HEIGHT);
        else if (name.endsWith("iTime"))
            own.uniform1f(place, TIME);
    }
    own.viewport(0, 0, WIDTH, HEIGHT);
    own.drawArrays(own.TRIANGLES, 0, 3);
    return pixelsOf(own, WIDTH, HEIGHT);
}

let device = null;
async function inWgsl(text) {
    const module = device.createShaderModule({ code: text }), vertex = device.createShaderModule({ code: `
@vertex fn cover(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
    return vec4f(f32(index & 1) * 4.0 - 1.0, f32(index & 2) * 2.0 - 1.0, 0.0, 1.0);
}` });
    const format = "rgba8unorm";
    device.pushErrorScope("validation");
    const pipeline = await device.createRenderPipelineAsync({ layout: "auto", vertex: { module: vertex }, fragment: { module, targets: [{ format }] } })
        .catch(async failure => { throw new Error(`${state.tab}: ${(await module.getCompilationInfo()).messages.map(each => each.message)} ${failure.message}`); });
    await device.popErrorScope();
    const size = [WIDTH, HEIGHT], bytesPerRow = Math.ceil(4 * WIDTH / 256) * 256;
    const target = device.createTexture({ size, format, usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC });
    const buffer = device.createBuffer({ size: bytesPerRow * HEIGHT, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const entries = [];
    for (const [name, binding, ...values] of [["resolution", 0, ...size], ["iTime", 1, TIME]])
        if (text.includes(`var<uniform> ${name}`)) {
            const uniform = device.createBuffer({ size: 16, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST });
            device.queue.writeBuffer(uniform, 0, Float32Array.of(...values));
            entries.push({ binding, resource: { buffer: uniform } });
        }
    if (text.includes("var painted")) {
        const map = device.createTexture({ size: [PAINTED_SIDE, PAINTED_SIDE], format,
                                           usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.RENDER_ATTACHMENT });
        device.queue.copyExternalImageToTexture({ source: saved }, { texture: map }, [PAINTED_SIDE, PAINTED_SIDE]);
        entries.push({ binding: 2, resource: map.createView() }, { binding: 3, resource: device.createSampler({ minFilter: "linear", magFilter: "linear" }) });
    }
    const encoder = device.createCommandEncoder();
    const pass = encoder.beginRenderPass({ colorAttachments: [{ view: target.createView(), loadOp: "clear", storeOp: "store" }] });
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
    pass.draw(3);
    pass.end();
    encoder.copyTextureToBuffer({ texture: target }, { buffer, bytesPerRow }, size);
    device.queue.submit([encoder.finish()]);
    await buffer.mapAsync(GPUMapMode.READ);
    const padded = new Uint8Array(buffer.getMappedRange()), pixels = new Uint8Array(4 * WIDTH * HEIGHT);
    for (let row = 0; row < HEIGHT; ++row)
        pixels.set(padded.subarray(bytesPerRow * row, bytesPerRow * row + 4 * WIDTH), 4 * WIDTH * row);
    return flipped(pixels);
}

const three = name => new URL(`../../tests/engines/three/node_modules/three/build/${name}.js`, location.href.split("#")[0]).href;
let renderer = null;
async function asNodes(text) {
    const { QuadMesh, NodeMaterial, RenderTarget, FloatType, WebGPURenderer } = await import("three/webgpu");
    const { screenCoordinate, vec2, vec4 } = await import("three/tsl");
    const still = text.replace('import { time } from "three/tsl";', `const time = ${TIME};`);
    const { pattern } = await import(URL.createObjectURL(new Blob([still], { type: "text/javascript" })));
    renderer ??= new WebGPURenderer();
    await renderer.init();
    const { x, y, high } = viewValues(), place = screenCoordinate.xy.sub(vec2(WIDTH / 2, HEIGHT / 2)).mul(high / HEIGHT).add(vec2(x, y));
    const quad = new QuadMesh(new NodeMaterial()), target = new RenderTarget(WIDTH, HEIGHT, { type: FloatType, depthBuffer: false });
    quad.material.fragmentNode = vec4(pattern(place), 1);
    renderer.setRenderTarget(target);
    quad.render(renderer);
    const values = await renderer.readRenderTargetPixelsAsync(target, 0, 0, WIDTH, HEIGHT);
    return flipped(Uint8Array.from(values, value => Math.round(255 * Math.min(Math.max(value, 0), 1))));
}

// ---- Tabs ----

// Sliders and colours off their defaults, and options at them.
const settingsOf = tab => Object.fromEntries(TABS[tab].controls.map(each => [each.name, each.options || each.check ? each.value
    : each.colour ? "#3b7ea1" : +(each.min + 0.37 * (each.max - each.min)).toFixed(each.step < 1 ? 4 : 0)]));
const OPTIONS = {
    erosion: [{ preset: "canyon", octaves: 3, water: -2 }, { cover: "badlands", distance: 2, x: 3, y: -5, water: 0 }],
    sea: [{ wind: 18, sun: 15, altitude: 9, seconds: 61.25, moving: false }, { wind: 25, sun: 15, altitude: 30, seconds: 7.5, moving: false }],
    materials: [...new Set(DATA.controls.map(each => each.name.split(".")[0]))].map(preset => ({ preset }))
        .concat({ preset: "oak-planks", boards: true, finish: true }),
    noise: [{ look: "plain", taps: 2 }, { look: "relief", taps: 4 }, ...["plain", "relief", "colours", "evolving"].map(look => ({ look }))],
};
const optionsOf = tab => OPTIONS[tab] ?? TABS[tab].controls.filter(each => each.options)
    .flatMap(({ name, options }) => options.map(option => ({ [name]: option }))).concat({});

let saved = null, painting_ = null; // the map of directions as the page saves it
async function saveMap() {
    const { click } = HTMLAnchorElement.prototype;
    let address = "";
    HTMLAnchorElement.prototype.click = function () { address = this.href; };
    document.getElementById("download").click();
    HTMLAnchorElement.prototype.click = click;
    saved = await createImageBitmap(await (await fetch(address)).blob(), { colorSpaceConversion: "none" });
    painting_ = own.createTexture();
    own.bindTexture(own.TEXTURE_2D, painting_);
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

const HEAD = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
const RUN = {
    GLSL: text => inGlsl(HEAD + text),
    Shadertoy: text => {
        draw(own, text, WIDTH, HEIGHT, TIME);
        return pixelsOf(own, WIDTH, HEIGHT);
    },
    HLSL: async text => flipped(inGlsl(await hlslInGlsl(text))), // whose first row is the uppermost
    WGSL: inWgsl,
    TSL: asNodes,
};
async function checkTab(name, settings) {
    open(name, { ...settingsOf(name), x: 0.3, y: -0.2, zoom: 1.3, yaw: 0.8, pitch: 0.2, ...settings });
    drawWhole(1000 * TIME);
    const shown = pixelsOf(gl, WIDTH, HEIGHT), text = textIn("GLSL");
    // Where rows grow downwards, so does dFdy, and materials that take samples in a pixel take their mirror images.
    const mirrored = text.includes("dFdy(") ? inGlsl(HEAD + text.replaceAll(/dFdy\(\w+\)/g, "(-$&)")) : shown;
    for (const offered of languages())
        if (device || offered !== "WGSL" && offered !== "TSL")
            compare(`${name} with ${JSON.stringify(settings)}, ${offered}`, await RUN[offered](textIn(offered)),
                    ["HLSL", "WGSL"].includes(offered) ? mirrored : shown, 4);
}

// Copied views of land are not drawn: they take minutes to compile on SwiftShader, and test_pages.py compiles them. But the page's map is
// compared with the land that the copied code has where the map does not fade, and its slopes with its heights where it does.
function checkLand(settings) {
    open("erosion", { ...settingsOf("erosion"), ...settings });
    drawWhole(1000 * TIME);
    const shown = pixelsOf(gl, WIDTH, HEIGHT), { side } = map, texel = MAP_WIDTH / side, what = `erosion with ${JSON.stringify(settings)}`;
    if (new Set(shown).size < 50)
        throw new Error(`${what}: the picture has only ${new Set(shown).size} values`);
    const made = new Float32Array(4 * side * side), wanted = made.slice();
    gl.bindFramebuffer(gl.FRAMEBUFFER, map.frame);
    gl.readPixels(0, 0, side, side, gl.RGBA, gl.FLOAT, made);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    programIn(`${HEAD}${textIn("GLSL").replace(/void main\(\)[^]*/, "")}void main()
{
    GaborTerrain here = ground_at(land(), vec2(${corner()}) + ${texel} * gl_FragCoord.xy, ${texel});
    colour = vec4(here.height, here.slope, here.ridge);
}`);
    own.getExtension("EXT_color_buffer_float");
    const texture = own.createTexture(), frame = own.createFramebuffer();
    own.bindTexture(own.TEXTURE_2D, texture);
    own.texStorage2D(own.TEXTURE_2D, 1, own.RGBA32F, side, side);
    own.bindFramebuffer(own.FRAMEBUFFER, frame);
    own.framebufferTexture2D(own.FRAMEBUFFER, own.COLOR_ATTACHMENT0, own.TEXTURE_2D, texture, 0);
    own.viewport(0, 0, side, side);
    own.drawArrays(own.TRIANGLES, 0, 3);
    own.readPixels(0, 0, side, side, own.RGBA, own.FLOAT, wanted);
    own.deleteFramebuffer(frame);
    own.deleteTexture(texture);
    const exact = Math.floor((MAP_WIDTH - MAP_SEAM) / texel) - 1;
    const errors = { exact: [0, 0], faded: [0, 0] }; // of slopes: sum and number
    let worst = 0, place = "";
    for (let y = 0; y < side; ++y)
        for (let x = 0; x < side; ++x) {
            const here = 4 * (side * y + x), beside = [4 * (side * y + (x + 1) % side), 4 * (side * ((y + 1) % side) + x)], faded = x >= exact || y >= exact;
            for (let i = 0; i < 4 && !faded; ++i)
                if (!(Math.abs(made[here + i] - wanted[here + i]) <= worst))
                    [worst, place] = [Math.abs(made[here + i] - wanted[here + i]), `value ${i} of column ${x}, row ${y}`];
            const error = errors[faded ? "faded" : "exact"];
            for (const [i, next] of beside.entries())
                error[0] += Math.abs((made[next] - made[here]) / texel - (made[next + 1 + i] + made[here + 1 + i]) / 2);
            error[1] += 2;
        }
    const [least, most] = [errors.exact, errors.faded].map(([sum, count]) => sum / count);
    if (!(worst < 0.0001))
        throw new Error(`${what}: the map differs from the copied land by ${worst} at ${place}`);
    if (!(most < 1.2 * least))
        throw new Error(`${what}: slopes of the map differ from its heights' by ${most} on average where it fades, and ${least} elsewhere`);
}

globalThis.drawn = (async () => {
    const chosen = new URLSearchParams(location.search).get("only")?.split(".") ?? [...Object.keys(TABS), "page"];
    await until(() => gl && !drawing && !asked && !moving, "draws its first picture");
    drawing = true; // the page itself draws nothing until the end
    document.head.append(Object.assign(document.createElement("script"), { type: "importmap", textContent: JSON.stringify({ imports: {
        "three": three("three.webgpu"), "three/webgpu": three("three.webgpu"), "three/tsl": three("three.tsl") } }) }));
    device = await (await navigator.gpu?.requestAdapter())?.requestDevice() ?? null;
    if (!device && navigator.userAgent.includes("Chrome"))
        throw new Error("there is no WebGPU");
    const resized = (width, height) => Object.assign(view.style, { width, height });
    resized(`${WIDTH}px`, `${HEIGHT}px`);
    for (let frame = 0; frame < 3; ++frame) // until the page has seen its new size
        await new Promise(requestAnimationFrame);
    await dropPicture();
    await saveMap();
    for (const name of chosen)
        for (const settings of TABS[name] ? optionsOf(name) : [])
            await (TABS[name].land ? checkLand(settings) : checkTab(name, settings));

    open("sea", { moving: true });
    if (!textIn("Shadertoy").includes("int(iTime)"))
        throw new Error("sea: copied waves do not move");
    if (chosen.includes("page"))
        await usePage(() => pixelsOf(gl, view.width, view.height));
    resized("", "");
    open("noise", { look: "plain", frequency: 4, orientation: 45, seed: 7, taps: 3 });
    const text = textIn("Shadertoy") // with the pixels of the reference: p = pixel / 32, y upwards
        .replace(/vec2 p = vec2\(.*;/, "vec2 p = vec2(pixel.x, extent.y - pixel.y) / 32.0;");
    drawing = false;
    changed();
    await until(() => !moving && !asked && !drawing && view.width === innerWidth, "draws at full resolution");
    return { engine: `live page, ${navigator.userAgent.includes("Firefox") ? "Firefox" : "Chromium"}`, dialect: "GLSL 300 es", ...measure(document.createElement("canvas"), text) };
})();

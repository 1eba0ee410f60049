// Draws a grid of triangles whose vertices gabor_eroded lifts.
const drop_in = async name => (await fetch(`../../../shaders/translations/${name}.wgsl`)).text();
const code = await drop_in("gabor_noise") + await drop_in("gabor_erosion") + `
const side = 512u; // squares along each side
const spacing = 8.0 / f32(side);

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) at: vec2f,
}

fn ground(p: vec2f, dx: vec2f, dy: vec2f) -> GaborTerrain { // without what is too fine for steps of dx and dy
    return gabor_eroded_at(GaborTerrainPlace(vec2i(0), p, vec2f(0)), dx, dy, gabor_terrain(p, 7u), gabor_erosion(), 7u);
}

@vertex fn lift(@builtin(vertex_index) index: u32) -> Corner {
    const corners = array(vec2u(0, 0), vec2u(0, 1), vec2u(1, 0), vec2u(1, 0), vec2u(0, 1), vec2u(1, 1));
    let square = index / 6;
    let p = spacing * vec2f(vec2u(square % side, square / side) + corners[index % 6]) - 4.0;
    let here = ground(p, vec2f(spacing, 0.0), vec2f(0.0, spacing));
    // The camera is at (0, 2.6, 6) and looks 24 degrees down, with a vertical field of view of 40 degrees.
    let d = vec3f(p.x, here.height, p.y) - vec3f(0.0, 2.6, 6.0);
    let view = vec3f(d.x, 0.914 * d.y - 0.407 * d.z, -0.407 * d.y - 0.914 * d.z);
    let far = 50.0;
    let near = 0.1;
    let position = vec4f(2.747 * view.xy * vec2f(720.0 / 1280.0, 1.0), (view.z - near) * far / (far - near), view.z);
    return Corner(position, p);
}

@fragment fn shade(corner: Corner) -> @location(0) vec4f {
    let here = ground(corner.at, dpdx(corner.at), dpdy(corner.at));
    let normal = normalize(vec3f(-here.slope.x, 1.0, -here.slope.y));
    let cover = gabor_ground_cover(here);
    let colour = cover.x * vec3f(0.11, 0.14, 0.05) + cover.y * vec3f(0.3, 0.25, 0.16) + cover.z * vec3f(0.28, 0.25, 0.22)
               + cover.w * vec3f(0.9);
    let sun = max(dot(normal, normalize(vec3f(-2.0, 1.2, 1.0))), 0.0);
    let light = sun * vec3f(1.5, 1.3, 1.1) + mix(vec3f(0.10, 0.08, 0.07), vec3f(0.25, 0.3, 0.4), 0.5 + 0.5 * normal.y);
    return vec4f(pow(min(colour * light, vec3f(1.0)), vec3f(1.0 / 2.2)), 1.0);
}`;

const device = await (await navigator.gpu.requestAdapter()).requestDevice();
const module = device.createShaderModule({ code });
const canvas = document.querySelector("canvas"), screen = canvas.getContext("webgpu");
const format = navigator.gpu.getPreferredCanvasFormat();
screen.configure({ device, format });
const pipeline = device.createRenderPipeline({
    layout: "auto",
    vertex: { module },
    fragment: { module, targets: [{ format }] },
    depthStencil: { format: "depth24plus", depthWriteEnabled: true, depthCompare: "less" },
});
const depth = device.createTexture({
    size: [canvas.width, canvas.height], format: "depth24plus", usage: GPUTextureUsage.RENDER_ATTACHMENT,
});
const encoder = device.createCommandEncoder();
const pass = encoder.beginRenderPass({
    colorAttachments: [{
        view: screen.getCurrentTexture().createView(), loadOp: "clear", storeOp: "store", clearValue: [0.6, 0.72, 0.85, 1],
    }],
    depthStencilAttachment: { view: depth.createView(), depthLoadOp: "clear", depthStoreOp: "discard", depthClearValue: 1 },
});
pass.setPipeline(pipeline);
pass.draw(6 * 512 * 512);
pass.end();
device.queue.submit([encoder.finish()]);
await device.queue.onSubmittedWorkDone();
globalThis.drawn = true;

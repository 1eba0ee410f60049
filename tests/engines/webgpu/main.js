// The page's address can name another drop-in: ?drop_in=gabor_sparse
const drop_in = new URLSearchParams(location.search).get("drop_in") ?? "gabor_noise";
const noise = await (await fetch(`../../../shaders/translations/${drop_in}.wgsl`)).text();

async function draw() {
    const adapter = await navigator.gpu.requestAdapter();
    const device = await adapter.requestDevice();
    const module = device.createShaderModule({ code: noise + `
        @vertex fn cover(@builtin(vertex_index) index: u32) -> @builtin(position) vec4f {
            return vec4f(f32(index & 1) * 4.0 - 1.0, f32(index & 2) * 2.0 - 1.0, 0.0, 1.0);
        }

        fn noise(position: vec2f) -> f32 {
            return gabor_noise(position / 32.0, 4.0, 0.7854, 7u);
        }

        @fragment fn draw(@builtin(position) position: vec4f) -> @location(0) f32 {
            return noise(position.xy);
        }

        @fragment fn show(@builtin(position) position: vec4f) -> @location(0) vec4f {
            return vec4f(vec3f(gabor_unorm(noise(position.xy))), 1.0);
        }` });
    const pipeline = (entryPoint, format) => device.createRenderPipeline({
        layout: "auto", vertex: { module },
        fragment: { module, entryPoint, targets: [{ format }] },
    });
    const target = device.createTexture({
        size: [256, 257], format: "r32float", usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC,
    });
    const values = device.createBuffer({
        size: 4 * 256 * 257, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ,
    });
    const screen = document.querySelector("canvas").getContext("webgpu");
    const format = navigator.gpu.getPreferredCanvasFormat();
    screen.configure({ device, format });

    const encoder = device.createCommandEncoder();
    const fill = (texture, pipeline) => {
        const pass = encoder.beginRenderPass({
            colorAttachments: [{ view: texture.createView(), loadOp: "clear", storeOp: "store" }],
        });
        pass.setPipeline(pipeline);
        pass.draw(3);
        pass.end();
    };
    fill(target, pipeline("draw", "r32float"));
    fill(screen.getCurrentTexture(), pipeline("show", format));
    encoder.copyTextureToBuffer({ texture: target }, { buffer: values, bytesPerRow: 4 * 256 }, [256, 257]);
    device.queue.submit([encoder.finish()]);
    await values.mapAsync(GPUMapMode.READ);
    return {
        engine: "Chromium WebGPU", dialect: "WGSL", driver: `${adapter.info.vendor} ${adapter.info.architecture}`,
        values: new Float32Array(values.getMappedRange()),
    };
}

globalThis.drawn = draw();

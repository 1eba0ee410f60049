// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

async function draw() {
    const app = new PIXI.Application();
    await app.init({ preference: "webgl", width: 256, height: 257 });
    document.body.append(app.canvas);
    const shader = PIXI.Shader.from({
        gl: {
            vertex: "#version 300 es\nin vec2 aPosition;\nvoid main() { gl_Position = vec4(aPosition, 0.0, 1.0); }",
            // PixiJS reads GLSL 100 unless the text has this line.
            fragment: "#version 300 es\nprecision highp float;\n" + noise + `
                uniform float shown;
                out vec4 value;
                void main()
                {
                    vec2 p = gl_FragCoord.xy / 32.0;
                    float n = gabor_noise(p, 4.0, 0.7854, 7u);
                    value = vec4(vec3(shown > 0.5 ? gabor_unorm(n) : n), 1.0);
                }`,
        },
        resources: { given: { shown: { value: 0, type: "f32" } } },
    });
    const triangle = new PIXI.Mesh({ geometry: new PIXI.Geometry({ attributes: { aPosition: [-1, -1, 3, -1, -1, 3] } }), shader });
    const { renderer } = app, { gl } = renderer;
    const target = PIXI.RenderTexture.create({ width: 256, height: 257, format: "rgba32float" });
    renderer.render({ container: triangle, target });
    renderer.renderTarget.bind(target, false);
    const pixels = new Float32Array(4 * 256 * 257);
    gl.readPixels(0, 0, 256, 257, gl.RGBA, gl.FLOAT, pixels);

    shader.resources.given.uniforms.shown = 1;
    app.stage.addChild(triangle);
    return {
        engine: "PixiJS", version: PIXI.VERSION, dialect: "GLSL 300 es",
        driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
        values: pixels.filter((_, index) => index % 4 === 0),
    };
}

globalThis.drawn = draw();

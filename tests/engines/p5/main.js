// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

const vertex = `#version 300 es
in vec3 aPosition;
void main() { gl_Position = vec4(2.0 * aPosition.xy, 0.0, 1.0); }`; // of a plane of 1 x 1
const fragment = `#version 300 es
precision highp float;
${noise}
uniform float shown;
out vec4 value;
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    float n = gabor_noise(p, 4.0, 0.7854, 7u);
    value = vec4(vec3(shown > 0.5 ? gabor_unorm(n) : n), 1.0);
}`;

globalThis.drawn = new Promise(resolve => new p5(sketch => {
    sketch.setup = () => {
        sketch.pixelDensity(1);
        sketch.createCanvas(256, 257, sketch.WEBGL);
        sketch.noLoop();
    };
    sketch.draw = () => {
        const shader = sketch.createShader(vertex, fragment);
        const target = sketch.createFramebuffer({ format: sketch.FLOAT, antialias: false, depth: false, density: 1 });
        const draw = shown => {
            sketch.noStroke();
            sketch.shader(shader);
            shader.setUniform("shown", shown);
            sketch.plane(1, 1);
        };
        target.draw(() => draw(0));
        target.loadPixels();
        draw(1);
        const gl = sketch.drawingContext;
        resolve({
            engine: "p5.js", version: p5.VERSION, dialect: "GLSL 300 es",
            driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
            values: target.pixels.filter((_, index) => index % 4 === 0),
        });
    };
}));

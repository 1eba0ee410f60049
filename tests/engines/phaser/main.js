// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

// Phaser draws with WebGL 1 unless it is given a context. Its own vertex shader is in GLSL 100, and a program needs two of one version.
const vertex = `#version 300 es
uniform mat4 uProjectionMatrix;
in vec2 inPosition;
void main() { gl_Position = uProjectionMatrix * vec4(inPosition, 1.0, 1.0); }`;
// The canvas has 8 bits a channel: red, green and blue are the digits of noise from -8 to 8.
const fragment = `#version 300 es
${noise}
uniform float shown;
out vec4 value;
void main()
{
    vec2 p = gl_FragCoord.xy / 32.0;
    float n = gabor_noise(p, 4.0, 0.7854, 7u);
    uint word = uint((n + 8.0) * 1048576.0 + 0.5);
    vec3 digits = vec3(uvec3(word >> 16, word >> 8, word) & 255u) / 255.0;
    value = vec4(shown > 0.5 ? vec3(gabor_unorm(n)) : digits, 1.0);
}`;

globalThis.drawn = new Promise(resolve => {
    const canvas = document.querySelector("canvas"), gl = canvas.getContext("webgl2", { preserveDrawingBuffer: true });
    const scene = {
        create() {
            const shader = this.add.shader({ name: "noise", vertexSource: vertex, fragmentSource: fragment }, 128, 128.5, 256, 257);
            shader.setUniform("shown", 0);
            this.game.events.once("postrender", () => {
                const pixels = new Uint8Array(4 * 256 * 257);
                gl.readPixels(0, 0, 256, 257, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
                shader.setUniform("shown", 1);
                this.game.events.once("postrender", () => resolve({
                    engine: "Phaser", version: Phaser.VERSION, dialect: "GLSL 300 es",
                    driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
                    values: Float32Array.from({ length: 256 * 257 },
                        (_, i) => ((pixels[4 * i] * 256 + pixels[4 * i + 1]) * 256 + pixels[4 * i + 2]) / 1048576 - 8),
                }));
            });
        },
    };
    new Phaser.Game({ type: Phaser.WEBGL, canvas, context: gl, width: 256, height: 257, scene, audio: { noAudio: true }, banner: false });
});

import noise from "./noise.frag";
import sparse from "./sparse.frag";

// The page's address can name the other drop-in, a header and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", header = "precision highp float;", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const before = header + "\n" + Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("");
const fragment = { gabor_noise: noise, gabor_sparse: sparse }[drop_in].replace("300 es\n", `$&${before}`);

const vertex = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;

const gl = document.querySelector("canvas").getContext("webgl2");
gl.getExtension("EXT_color_buffer_float");

const program = gl.createProgram();
for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
}
gl.linkProgram(program);

gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 256, 257);
gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);

gl.viewport(0, 0, 256, 257);
gl.useProgram(program);
gl.drawArrays(gl.TRIANGLES, 0, 3);
const pixels = new Float32Array(4 * 256 * 257);
gl.readPixels(0, 0, 256, 257, gl.RGBA, gl.FLOAT, pixels);

gl.bindFramebuffer(gl.FRAMEBUFFER, null);
gl.uniform1i(gl.getUniformLocation(program, "shown"), 1);
gl.drawArrays(gl.TRIANGLES, 0, 3);

globalThis.drawn = {
    engine: "vite-plugin-glsl", version: __PLUGIN_VERSION__, dialect: `GLSL 300 es, ${header}`,
    driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL),
    values: pixels.filter((_, index) => index % 4 === 0),
};

// Draws Shadertoy code, with the code that Shadertoy adds around it, in plain WebGL 2.

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;
const BEFORE = `#version 300 es
precision highp float;
precision highp int;
precision mediump sampler3D;
uniform vec3 iResolution;
uniform float iTime;
uniform vec4 iMouse;
out vec4 shadertoy_out_color;
`;
const AFTER = `
void main() {
    vec4 color = vec4(0.0, 0.0, 0.0, 1.0);
    mainImage(color, gl_FragCoord.xy);
    shadertoy_out_color = vec4(color.xyz, 1.0);
}`;

function draw(gl, text, width, height, time = 0) {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, VERTEX], [gl.FRAGMENT_SHADER, BEFORE + text + AFTER]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
            throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.uniform3f(gl.getUniformLocation(program, "iResolution"), width, height, 1);
    gl.uniform1f(gl.getUniformLocation(program, "iTime"), time);
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
}

// Returns the red channel of a picture of 256 x 256 pixels that mainImage draws.
function redOf(gl, text) {
    gl.getExtension("EXT_color_buffer_float");
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, 256, 256);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, gl.getParameter(gl.TEXTURE_BINDING_2D), 0);
    draw(gl, text, 256, 256);
    const pixels = new Float32Array(4 * 256 * 256);
    gl.readPixels(0, 0, 256, 256, gl.RGBA, gl.FLOAT, pixels);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return pixels.filter((_, index) => index % 4 === 0);
}

// Draws the Shadertoy code into the canvas. Returns the driver's name, and the noise before gabor_unorm is applied.
function measure(canvas, text) {
    const plain = text.replace("vec3(gabor_unorm(n))", "vec3(n)"); // vec3 excludes the example in the drop-in's comment
    if (plain === text)
        throw new Error("the text has no vec3(gabor_unorm(n))");
    const gl = canvas.getContext("webgl2", { preserveDrawingBuffer: true });
    const values = redOf(gl, plain);
    draw(gl, text, canvas.width, canvas.height);
    return { driver: gl.getParameter(gl.getExtension("WEBGL_debug_renderer_info").UNMASKED_RENDERER_WEBGL), values };
}

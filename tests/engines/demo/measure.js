// Opens every tab of docs/demo/index.html with every option, and draws the Shadertoy code that it offers. The code must compile
// and show something; what the tab of the sea copies must show the tab's picture. Then measures the noise of one tab.
function textOf(tab, settings, name = "Shadertoy") {
    history.replaceState(null, "", "#" + new URLSearchParams({ tab, ...settings }));
    readAddress();
    controlsOf();
    const language = document.getElementById("language");
    language.value = name;
    language.dispatchEvent(new Event("change"));
    return document.querySelector("textarea").value;
}

function deviation(values) {
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
}

const pixelsOf = (gl, width, height) => {
    const pixels = new Uint8Array(4 * width * height);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels;
};

// Compares the picture of the sea's tab with those that its copied code draws. Waves that move, move.
async function compareSea() {
    const settings = { bare: "", wind: 18, sun: 15, altitude: 9, seconds: 61.25 };
    const glsl = textOf("sea", { ...settings, moving: false }, "GLSL");
    const texts = { Shadertoy: textOf("sea", { ...settings, moving: false }), GLSL: `${glsl}
void mainImage(out vec4 color, vec2 pixel) {
    vec2 place = vec2(pixel.x, iResolution.y - pixel.y) - 0.5 * iResolution.xy;
    color = vec4(sea_in_pixel(place, 1.0 / iResolution.x), 1.0);
}` };
    const message = document.getElementById("compiling");
    clearTimeout(settle);
    moving = true; // draws coarsely
    asked = false;
    ask();
    await new Promise(requestAnimationFrame);
    if (message.hidden)
        throw new Error("the page does not say that it compiles");
    while (asked || !message.hidden)
        await new Promise(resolve => setTimeout(resolve, 20));
    const { width, height } = view, shown = pixelsOf(gl, width, height);
    asked = true;
    const canvas = Object.assign(document.createElement("canvas"), { width, height });
    const own = canvas.getContext("webgl2");
    for (const [language, text] of Object.entries(texts)) {
        draw(own, text, width, height);
        const apart = pixelsOf(own, width, height).map((value, i) => Math.abs(value - shown[i]));
        const far = apart.filter(each => each > 8).length / apart.length;
        if (!(far < 0.002))
            throw new Error(`sea: ${(100 * far).toFixed(2)} % of what the ${language} code draws is not what the tab shows`);
    }
    if (!textOf("sea", { ...settings, moving: true }).includes("int(iTime)"))
        throw new Error("sea: copied waves do not move");
}

globalThis.drawn = (async () => {
    asked = true; // the page itself draws nothing until the end, because its scenes take seconds on the CPU
    await compareSea();
    const gl = document.createElement("canvas").getContext("webgl2");
    for (const [name, tab] of Object.entries(TABS)) {
        const choices = tab.controls.filter(each => each.options).flatMap(({ name, options }) =>
            options.filter(each => each !== "painted").map(option => ({ [name]: option }))); // painted needs a texture
        for (const settings of choices.length ? choices : [{}]) {
            const shown = deviation(redOf(gl, textOf(name, settings)));
            if (!(shown > 0.01))
                throw new Error(`${name} with ${JSON.stringify(settings)} shows values with a standard deviation of ${shown}`);
            await new Promise(resolve => setTimeout(resolve, 0));
        }
    }
    const text = textOf("noise", { look: "plain", frequency: 4, orientation: 45, seed: 7, taps: 3, bare: "" })
        // The pixels of the reference: p = pixel / 32, y upwards.
        .replace(/vec2 p = vec2\(pixel\.x, iResolution\.y - pixel\.y\) \/ [\d.]+;/, "vec2 p = pixel / 32.0;");
    asked = false;
    changed();
    await new Promise(resolve => setTimeout(resolve, 500)); // wait until the page draws at full resolution
    await new Promise(resolve => requestAnimationFrame(resolve));
    return { engine: "docs/demo", dialect: "GLSL 300 es", ...measure(document.createElement("canvas"), text) };
})();

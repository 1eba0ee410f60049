// Opens every tab of docs/demo/index.html with every option, and draws the Shadertoy code that it offers. The code must compile
// and show something. Then measures the noise of one tab.
function textOf(tab, settings) {
    history.replaceState(null, "", "#" + new URLSearchParams({ tab, ...settings }));
    readAddress();
    controlsOf();
    const language = document.getElementById("language");
    language.value = "Shadertoy";
    language.dispatchEvent(new Event("change"));
    return document.querySelector("textarea").value;
}

function deviation(values) {
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
}

globalThis.drawn = (async () => {
    asked = true; // the page itself draws nothing until the end, because its scenes take seconds on the CPU
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

// Opens every tab of docs/demo/index.html with every choice that it offers, and draws the text that it gives to copy as
// Shadertoy would: each must compile there and show something. Measures the noise of one of them.
async function textOf(tab, settings) {
    location.hash = new URLSearchParams({ tab, ...settings });
    await new Promise(resolve => setTimeout(resolve, 50));
    const language = document.getElementById("language");
    language.value = "Shadertoy";
    language.dispatchEvent(new Event("change"));
    const text = document.querySelector("textarea").value;
    // The pixels that the reference has: p = pixel / 32, y upwards.
    return text.replace(/vec2 p = vec2\(pixel\.x, iResolution\.y - pixel\.y\) \/ [\d.]+;/, "vec2 p = pixel / 32.0;");
}

function deviation(values) {
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
}

globalThis.drawn = (async () => {
    const canvas = document.createElement("canvas");
    const gl = canvas.getContext("webgl2");
    for (const [name, tab] of Object.entries(TABS)) {
        for (const control of tab.controls.filter(each => each.options)) {
            for (const option of control.options.filter(each => each !== "painted")) { // which needs a texture
                const shown = deviation(redOf(gl, await textOf(name, { [control.name]: option })));
                if (!(shown > 0.01))
                    throw new Error(`${name} with ${control.name} ${option} shows values that deviate by ${shown}`);
            }
        }
        if (!tab.controls.some(each => each.options) && !(deviation(redOf(gl, await textOf(name, {}))) > 0.01))
            throw new Error(`${name} shows nothing`);
    }
    const text = await textOf("noise", { look: "plain", frequency: 4, orientation: 45, seed: 7 });
    panel.style.display = "none";
    return { engine: "docs/demo", dialect: "GLSL 300 es", ...measure(document.createElement("canvas"), text) };
})();

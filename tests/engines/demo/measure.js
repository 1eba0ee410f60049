// Sets the controls of docs/demo/index.html, and measures the text that it gives to copy as Shadertoy would draw it. The
// text of every look must be what Shadertoy takes, and show something.
const form = document.querySelector("form");

async function textOf(settings) {
    for (const [name, value] of Object.entries(settings))
        form.elements[name].value = value;
    form.dispatchEvent(new Event("input"));
    await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return form.querySelector("textarea").value;
}

function deviation(values) {
    const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
    return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length);
}

globalThis.drawn = (async () => {
    const settings = { frequency: 4, orientation: 45, seed: 7 };
    const canvas = document.createElement("canvas");
    const gl = canvas.getContext("webgl2");
    for (const look of form.elements.look.options) {
        for (const taps of look.value === "noise" ? [2, 3, 4] : [3]) {
            const shown = deviation(redOf(gl, await textOf({ look: look.value, taps, scale: 16, ...settings })));
            if (!(shown > 0.1))
                throw new Error(`${look.value} with ${taps} taps shows values that deviate by ${shown}`);
        }
    }
    const text = await textOf({ look: "noise", taps: 3, scale: 32, ...settings });
    form.style.display = "none";
    return { engine: "docs/demo", dialect: "GLSL 300 es", ...measure(document.createElement("canvas"), text) };
})();

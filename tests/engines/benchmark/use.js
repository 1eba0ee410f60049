// Measures with the page of tools/package benchmark, and checks its tables and rows.
const wrong = text => { throw new Error(text); };
const element = id => document.getElementById(id);
const cells = text => text.split("|").slice(1, -1).map(cell => cell.trim());
const until = async test => { while (!test()) await new Promise(resolve => setTimeout(resolve, 20)); };

// If noise k costs k ms per megapixel, the row to copy has these numbers below the heads.
function checkRow() {
    const names = SUBJECTS.map(each => each[0]), times = names.map((_, k) => [3, 3, 3].map(empty => empty + k * SIDE * SIDE / 1e6));
    const heads = cells(run.toString().match(/"(\| device .*?)"/)[1]), row = cells(shown({ device: "a", api: "b", names, times }));
    for (const [k, head] of heads.entries()) {
        const subject = { device: "a", API: "b" }[head] ?? `${names.findIndex(name => name === head || !names.includes(head) && name.includes(head))}`;
        if (row[k] !== subject)
            wrong(`${head}: ${row[k]} instead of ${subject}`);
    }
}

function checkTables() {
    const results = [...element("results").children].map(each => each.tagName === "TABLE" ? [...each.tBodies[0].rows].map(row => [...row.cells].map(cell => cell.textContent))
        : each.textContent);
    const [first, webgl, second, webgpu] = results, names = SUBJECTS.slice(1);
    if (results.length !== 4 || !first.startsWith("WebGL 2: ") || !second.startsWith("WebGPU: "))
        wrong(`the results are ${JSON.stringify(results)}`);
    for (const [rows, wanted] of [[webgl, names], [webgpu, names.filter(([, files, , taps]) => !taps && !/filter|3d/.test(files))]]) {
        if (`${rows.map(row => row[0])}` !== `${wanted.map(each => each[0])}`)
            wrong(`the rows are ${rows.map(row => row[0])}`);
        for (const [name, middle, quartiles] of rows) {
            const [low, high] = quartiles.split(" to ").map(Number);
            if (!(0 <= low && low <= +middle && +middle <= high))
                wrong(`${name} takes ${middle} ms, within ${quartiles}`);
        }
        if (!(+rows.at(-1)[1] > 0)) // 270 kernels for each pixel
            wrong(`${rows.at(-1)} take no time`);
    }
    const lines = element("row").textContent.split("\n");
    if (lines.length !== 4 || lines.some(line => cells(line).length !== 8))
        wrong(`the text to copy is ${lines}`);
}

async function checkCopy() {
    for (const forbidden of [false, true]) {
        let written = "";
        const writeText = async text => forbidden ? wrong("forbidden") : written = text;
        Object.defineProperty(navigator, "clipboard", { value: { writeText }, configurable: true });
        element("copy").click();
        await until(() => forbidden ? `${getSelection()}`.trim() : element("copy").textContent === "Copied");
        if ((forbidden ? `${getSelection()}`.trim() : written) !== element("row").textContent)
            wrong("it copies another text");
    }
}

globalThis.drawn = (async () => {
    checkRow();
    element("start").click();
    if (!element("start").disabled)
        wrong("it can start twice");
    await until(() => element("state").textContent === "done");
    checkTables();
    await checkCopy();
    document.body.append(document.createElement("canvas")); // of which run.mjs takes a picture
    return { driver: "", picture: true, values: [] };
})();

// Opens a page of this repository in a headless browser and saves the drawn values:
// run.mjs chrome|firefox PAGE[,SCRIPT...] VALUES.raw [DRIVER [FLAG...]]
// If there are scripts, opens the page from its file and adds the scripts to it, joined into one. The page sets
// globalThis.drawn to a promise of { engine, version, dialect, driver, values }, and shows the noise in its canvas. Flags are
// for Chromium. The driver's name must contain DRIVER, since browsers may silently choose another driver. tools/test-engines ends this
// process after GABOR_SECONDS, but not the browser.

import { execFile } from "node:child_process";
import { mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { tmpdir } from "node:os";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import puppeteer from "puppeteer-core";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript" };
const [name, pages, output, wanted = "", ...flags] = process.argv.slice(2);
const [page, ...scripts] = pages.split(",");
const limit = 1000 * (process.env.GABOR_SECONDS ?? 600);
const angle = flags.some(flag => flag.startsWith("--use-angle")) ? [] : ["--use-angle=swiftshader"];

const server = createServer(async (request, response) => {
    try {
        const path = normalize(new URL(request.url, "http://localhost").pathname);
        const body = await readFile(join(root, path));
        response.writeHead(200, { "content-type": types[extname(path)] ?? "text/plain" }).end(body);
    } catch {
        response.writeHead(404).end();
    }
});
// Returns the standard deviation of a picture's values, which lie between 0 and 1.
function deviation(tab, png) {
    return tab.evaluate(async base64 => {
        const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
        context.drawImage(bitmap, 0, 0);
        const values = context.getImageData(0, 0, bitmap.width, bitmap.height).data.filter((_, i) => i % 4 === 0);
        const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
        return Math.sqrt(values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / values.length) / 255;
    }, png.toString("base64"));
}

// Translates a pixel shader to GLSL ES.
async function hlslInGlsl(text) {
    const folder = await mkdtemp(join(tmpdir(), "gabor-")), [source, binary] = ["shader.hlsl", "shader.spv"].map(each => join(folder, each));
    try {
        await writeFile(source, text);
        const run = promisify(execFile), most = { maxBuffer: 1 << 26 };
        await run("glslangValidator", ["-D", "-V", "-S", "frag", "-e", "main", "--auto-map-bindings", "-o", binary, source], most);
        return (await run("spirv-cross", ["--version", "300", "--es", "--glsl-emit-ubo-as-plain-uniforms", binary], most)).stdout;
    } finally {
        await rm(folder, { recursive: true });
    }
}

await new Promise(resolve => server.listen(0, "localhost", resolve));

const browser = await puppeteer.launch({ protocolTimeout: limit, ...name === "firefox" ? {
    browser: "firefox",
    executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr",
    extraPrefsFirefox: { "webgl.force-enabled": true },
} : {
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", ...angle, ...flags,
           "--enable-unsafe-swiftshader", "--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"],
} });
try {
    const tab = await browser.newPage();
    setTimeout(async () => {
        const asked = tab.evaluate(() => globalThis.waiting).catch(() => ""), busy = new Promise(resolve => setTimeout(resolve, 5000));
        const waiting = await Promise.race([asked, busy]);
        console.error(`The page is not done after ${limit / 1000} s${waiting ? `, and waits ${waiting}` : ""}.`);
        await browser.close();
    }, limit - 20000).unref();
    await tab.setViewport({ width: 1280, height: 720 });
    const messages = [];
    tab.on("console", message => messages.push(message.text()));
    tab.on("pageerror", error => messages.push(error.message));
    await tab.goto(scripts.length ? `file://${root}${page}` : `http://localhost:${server.address().port}/${page}`);
    if (scripts.length) {
        await tab.exposeFunction("hlslInGlsl", hlslInGlsl);
        const texts = await Promise.all(scripts.map(script => readFile(join(root, script), "utf8")));
        await tab.addScriptTag({ content: texts.join(""), type: "module" });
    }
    const { values, ...facts } = await tab.evaluate(async () => {
        while (!("drawn" in globalThis))
            await new Promise(resolve => setTimeout(resolve, 50)); // frames may be slow on the CPU
        const { values, ...facts } = await globalThis.drawn;
        return { values: Array.from(values), ...facts };
    });
    messages.forEach(message => console.error(message));
    if (scripts.length && messages.some(message => !message.includes("GPU stall due to ReadPixels")))
        throw new Error("the page must not write to the console");
    if (!facts.driver.includes(wanted))
        throw new Error(`the driver should be ${wanted} but is ${facts.driver}`);
    const shown = await deviation(tab, Buffer.from(await (await tab.$("canvas")).screenshot()));
    if (!facts.picture && !(Math.abs(shown - 0.24) < 0.04))
        throw new Error(`the page's grey values should have a standard deviation of 0.24, but it is ${shown}`);
    if (scripts.length) { // checks the page at a phone's size
        await tab.setViewport({ width: 390, height: 844 });
        await tab.waitForFunction(() => document.documentElement.clientWidth === 390);
        const wide = await tab.evaluate(() => [...document.querySelectorAll("body *")]
            .filter(each => each.checkVisibility() && each.tabIndex >= 0 && !each.closest("[role=tablist], pre"))
            .filter(each => each.getBoundingClientRect().left < -1 || each.getBoundingClientRect().right > innerWidth + 1)
            .map(each => each.outerHTML.slice(0, 80)));
        if (wide.length)
            throw new Error(`on a phone, these extend beyond the screen: ${wide.join(", ")}`);
    }
    await writeFile(output, new Uint8Array(Float32Array.from(values).buffer));
    console.log(JSON.stringify({ ...facts, version: `${facts.version ?? (await browser.version()).split("/").pop()}` }));
} finally {
    await browser.close();
    server.close();
}

// Opens a page of this repository in headless Chromium and keeps what it drew: run.mjs PAGE VALUES.raw
// The page sets globalThis.drawn to a promise of { engine, version, dialect, driver, values }.

import { readFile, writeFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";

const root = fileURLToPath(new URL("../../..", import.meta.url));
const types = { ".html": "text/html", ".js": "text/javascript", ".mjs": "text/javascript" };
const [page, output] = process.argv.slice(2);

const server = createServer(async (request, response) => {
    try {
        const path = normalize(new URL(request.url, "http://localhost").pathname);
        const body = await readFile(join(root, path));
        response.writeHead(200, { "content-type": types[extname(path)] ?? "text/plain" }).end(body);
    } catch {
        response.writeHead(404).end();
    }
});
await new Promise(resolve => server.listen(0, "localhost", resolve));

const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking",
           "--disable-component-update", "--disable-sync", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
           "--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader"],
});
try {
    const tab = await browser.newPage();
    tab.on("console", message => console.error(message.text()));
    tab.on("pageerror", error => console.error(error.message));
    await tab.goto(`http://localhost:${server.address().port}/${page}`);
    await tab.waitForFunction(() => "drawn" in globalThis);
    const { values, ...facts } = await tab.evaluate(async () => {
        const { values, ...facts } = await globalThis.drawn;
        return { values: Array.from(values), ...facts };
    });
    await writeFile(output, new Uint8Array(Float32Array.from(values).buffer));
    console.log(JSON.stringify({ ...facts, version: `${facts.version ?? browser.version()}` }));
} finally {
    await browser.close();
    server.close();
}

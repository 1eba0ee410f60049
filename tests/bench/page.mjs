// Measures how soon docs/demo/index.html shows a picture of each tab, in Chromium on SwiftShader at 1280 x 720: CPU seconds of all of
// Chromium's processes, seconds, and the CPU time and duration of the page's longest task, each until the first picture.
//   node tests/bench/page.mjs [TAB...]
// tools/test-engines demo installs what it needs. On a busy machine only CPU times mean something.

import { readFile, readFileSync, readdir } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import puppeteer from "../engines/browser/node_modules/puppeteer-core/lib/puppeteer/puppeteer-core.js";

const page = new URL("../../docs/demo/index.html", import.meta.url).href;
const TICKS = 100; // per second, in /proc
const TABS = "erosion sea stripes materials noise fractal spectra photographs".split(" ");

// CPU seconds of a process and of those that it started.
async function cpuSeconds(root) {
    const facts = new Map();
    for (const id of (await promisify(readdir)("/proc")).filter(name => /^\d+$/.test(name)))
        try {
            const text = await promisify(readFile)(`/proc/${id}/stat`, "utf8"), fields = text.slice(text.lastIndexOf(")") + 2).split(" ");
            facts.set(+id, { parent: +fields[1], seconds: (+fields[11] + +fields[12]) / TICKS });
        } catch {} // it has ended
    const below = id => id === root || facts.has(id) && below(facts.get(id).parent);
    return [...facts].reduce((sum, [id, { seconds }]) => sum + (below(id) ? seconds : 0), 0);
}

// CPU time and duration, in milliseconds, of the longest tasks of the page's main thread.
function longest(trace) {
    const { traceEvents } = JSON.parse(readFileSync(trace, "utf8"));
    const main = traceEvents.filter(each => each.name === "thread_name" && each.args.name === "CrRendererMain").map(each => `${each.pid} ${each.tid}`);
    const tasks = traceEvents.filter(each => each.ph === "X" && each.name.endsWith("RunTask") && main.includes(`${each.pid} ${each.tid}`));
    return ["tdur", "dur"].map(which => Math.max(...tasks.map(each => each[which] ?? 0)) / 1000);
}

const folder = await mkdtemp(join(tmpdir(), "gabor-"));
console.log("tab           CPU s       s   longest task: CPU ms      ms");
for (const name of process.argv.length > 2 ? process.argv.slice(2) : TABS) {
    const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", protocolTimeout: 600000, args: [
        "--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking", "--disable-component-update", "--disable-sync",
        "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
    try {
        const tab = await browser.newPage(), trace = join(folder, "trace.json");
        await tab.setViewport({ width: 1280, height: 720 });
        await tab.tracing.start({ path: trace, categories: ["toplevel", "disabled-by-default-devtools.timeline"] });
        await tab.goto(page + (name === TABS[0] ? "" : `#tab=${name}`), { waitUntil: "domcontentloaded" });
        await tab.waitForFunction(() => performance.getEntriesByType("mark").length, { polling: 20, timeout: 600000 });
        const seconds = await tab.evaluate(() => performance.getEntriesByType("mark")[0].startTime / 1000);
        const cpu = await cpuSeconds(browser.process().pid);
        await tab.tracing.stop();
        console.log(name.padEnd(12), ...[cpu.toFixed(1), seconds.toFixed(1), ...longest(trace).map(time => time.toFixed(0))].map((text, i) => text.padStart([6, 7, 22, 7][i])));
    } finally {
        await browser.close();
    }
}
await rm(folder, { recursive: true });

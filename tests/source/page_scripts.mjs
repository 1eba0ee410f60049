// Runs the scripts of docs' pages without a browser: page_scripts.mjs DOCS. Whatever a page asks of the browser can be called, read and
// written, but says nothing. Each test below follows a page's script, and sees its names.

import { readFileSync } from "node:fs";
import vm from "node:vm";

const TESTS = {
    "demo/index.html": () => {
        // A control with the unit ° is an angle, and copied code has the number of each control.
        for (const name of Object.keys(TABS)) {
            state.tab = name;
            const sliders = () => shownControls().filter(each => !each.options && !each.check && !each.colour);
            for (const control of sliders())
                values()[control.name] = control.min + Math.round(0.37 * (control.max - control.min) / control.step) * control.step;
            for (const control of sliders()) {
                const wanted = values()[control.name] * (control.unit === "°" ? Math.PI / 180 : 1), copied = numbers()[control.name];
                if (copied !== "iTime" && !(Math.abs(parseFloat(copied) - wanted) <= 0.01 * Math.min(control.step, 0.01)))
                    fail(`${name}: ${control.label} ${wanted} is copied as ${copied}`);
            }
        }
        // The place under the pointer stays there.
        for (const name of Object.keys(TABS)) {
            state.tab = name;
            if (tab().terrain || tab().sea || values().shape === "ball")
                continue;
            Object.assign(state, start());
            const before = toPlane(100, 50);
            zoomBy(1.7, 100, 50);
            moveBy(30, 20);
            const after = toPlane(130, 70);
            if (!(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-9))
                fail(`${name}: ${before} moves to ${after}`);
        }
        // The land follows the pointer: its middle moves to the left and away as the pointer moves to the right and down.
        state.tab = "erosion";
        Object.assign(state, start());
        moveBy(20, 30, false);
        const right = [-Math.sin(state.yaw), Math.cos(state.yaw)], back = [Math.cos(state.yaw), Math.sin(state.yaw)];
        const along = axis => (state.x * axis[0] + state.y * axis[1]) / state.distance;
        if (!(Math.abs(along(right) * 30 - along(back) * 20) < 1e-9 && along(right) < 0))
            fail(`the land moves by ${along(right)} to the right, and ${along(back)} towards the eye`);
    },
    "benchmark.html": () => {
        // If noise k costs k ms per megapixel, the row to copy has these numbers below the heads.
        const names = SUBJECTS.map(each => each[0]);
        const times = names.map((_, k) => [3, 3, 3].map(empty => empty + k * SIDE * SIDE / 1e6));
        const cells = text => text.split("|").slice(3, -1).map(cell => cell.trim());
        const heads = cells(run.toString().match(/"(\| device .*?)"/)[1]), row = cells(shown({ device: "", api: "", names, times }));
        for (const [k, head] of heads.entries()) {
            const subject = names.includes(head) ? head : names.find(name => name.includes(head));
            if (row[k] !== `${names.indexOf(subject)}`)
                fail(`${head}: ${row[k]} instead of ${names.indexOf(subject)}`);
        }
    },
};

const nothing = new Proxy(function () {}, {
    get: (_, name) => name === Symbol.toPrimitive ? () => "" : name === Symbol.iterator ? function* () {} : nothing,
    set: () => true, apply: () => nothing, construct: () => nothing,
});
for (const [page, test] of Object.entries(TESTS)) {
    const text = readFileSync(`${process.argv[2]}/${page}`, "utf8");
    const script = text.match(/<script>\n([^]*?)<\/script>/)[1];
    const texts = Object.fromEntries([...text.matchAll(/<script type="text\/plain" id="(.*?)".*?>([^]*?)<\/script>/g)].map(each => each.slice(1)));
    const getElementById = id => id in texts ? { textContent: texts[id] } : nothing;
    vm.runInNewContext(`${script};(${test})();`, {
        document: new Proxy({}, { get: (_, name) => name === "getElementById" ? getElementById : nothing }),
        ...Object.fromEntries(["navigator", "history", "getSelection", "setTimeout", "clearTimeout", "requestAnimationFrame", "addEventListener",
                               "getComputedStyle",
                               "matchMedia", "Option", "Image", "ImageData"].map(name => [name, nothing])),
        location: { hash: "" }, innerWidth: 800, innerHeight: 600, devicePixelRatio: 1, URLSearchParams,
        fail: text => {
            console.error(`${page}: ${text}`);
            process.exitCode = 1;
        },
    });
}

// Runs the scripts of docs' pages in browser.mjs: page_scripts.mjs DOCS [--write | --show]. Each test of TESTS follows a page's script,
// and sees its names. STEPS use the pages as people do; after each, digests of what the page shows, writes to the address, copies
// and draws, where they changed, must be those of tests/golden/pages.txt. --write replaces these, and --show prints what they are digests of.

import { createHash } from "node:crypto";
import { readFileSync, writeFileSync } from "node:fs";
import { Browser } from "./browser.mjs";

const TESTS = {
    "demo/index.html": () => {
        // A control with the unit ° is an angle, and copied code has the number of each control.
        for (const name of Object.keys(TABS)) {
            showTab(name);
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
            showTab(name);
            if (tab().terrain || tab().sea || values().shape === "ball")
                continue;
            const before = toPlane(100, 50);
            zoomBy(1.7, 100, 50);
            moveBy(30, 20);
            const after = toPlane(130, 70);
            if (!(Math.hypot(after[0] - before[0], after[1] - before[1]) < 1e-9))
                fail(`${name}: ${before} moves to ${after}`);
        }
        // The land follows the pointer: its middle moves to the left and away as the pointer moves to the right and down.
        showTab("erosion");
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

// ---- What a page shows ---------------------------------------------------------------------------------------------

const rounded = value => typeof value === "number" ? +value.toPrecision(5) : value;
const lines = (value, short = text => text) => JSON.stringify(value, (_, each) => typeof each === "string" ? short(each) : rounded(each));
const choose = (page, language) => {
    page.$("#language").value = language;
    page.$("#language").send("change");
};
function shown(page) {
    // Drop-ins have tests of their own: their names stand for their texts.
    const short = text => Object.entries(page.texts).reduce((text, [name, whole]) => whole.trim() ? text.replace(whole.trim(), `<${name}>`) : text, text);
    const seen = page.root.all().filter(each => !each.hidden && each.tag !== "meta" && each.attributes?.type !== "text/plain").map(each => lines([
        each.tag, each.attributes, [...each.classList.all], each.text, each.innerHTML, each.title, each.label, each.value, each.checked,
        each.type, each.min, each.max, each.step, each.disabled, each.tabIndex], short));
    const language = page.$("#language"), copied = language?.options.filter(each => !each.disabled).map(({ value }) => {
        choose(page, value);
        return `---- ${value}\n${short(page.$("textarea").value)}`;
    }).join("\n") ?? "";
    if (language)
        choose(page, "GLSL");
    return { page: seen.join("\n"), address: page.location.hash, copy: copied, drawing: page.calls.filter(([, name]) => name !== "time" || copied.includes("iTime")).map(call => lines(call, short)).join("\n"),
             said: page.said.splice(0).map(said => lines(said, short)).join("\n") };
}

// ---- Steps ---------------------------------------------------------------------------------------------------------

const control = (page, name) => page.$("#controls").all().find(each => each.name === name);
const visible = page => page.$("#controls").children.filter(label => !label.hidden).map(label => label.children[0]);
const input = (each, value) => {
    each[each.type === "checkbox" ? "checked" : "value"] = value;
    each.send("input");
};
const off = ({ min, max, step }, share = 0.37) => `${+(min + Math.round(share * (max - min) / step) * step).toFixed(6)}`;
const at = (clientX, clientY, more) => ({ clientX, clientY, ...more });
function drag(element, ...places) {
    element.send("pointerdown", places[0]);
    for (const place of places.slice(1))
        element.send("pointermove", place);
    element.send("pointerup", places.at(-1));
}

async function* demo(html) {
    let page = new Browser(html);
    const open = async (hash, options) => {
        page = new Browser(html, { hash, ...options });
        await page.pass(1000);
        return page;
    };
    yield ["opened", await open("")];
    const view = () => page.$("#view"), tab = name => page.root.querySelectorAll("[role=tab]").find(each => each.value === name);
    for (const name of page.root.querySelectorAll("[role=tab]").map(each => each.value)) {
        tab(name).click();
        await page.pass(1000);
        yield [`${name}`, page];
        for (const select of visible(page).filter(each => each.tag === "select"))
            for (const option of select.options) {
                input(select, option.value);
                await page.pass(300);
                yield [`${name} ${select.name} ${option.value}`, page];
                for (const slider of visible(page).filter(each => each.type === "range"))
                    input(slider, off(slider));
                for (const colour of visible(page).filter(each => each.type === "color"))
                    input(colour, "#3a7f05");
                await page.pass(300);
                yield [`${name} ${select.name} ${option.value}, moved`, page];
                if (option === select.options.at(-1))
                    input(select, select.options[0].value);
            }
        for (const box of visible(page).filter(each => each.type === "checkbox"))
            input(box, !box.checked);
        await page.pass(300);
        yield [`${name} checked`, page];
        for (const [k, slider] of visible(page).filter(each => each.type === "range").entries())
            input(slider, off(slider, 0.2 + 0.07 * (k % 9)));
        await page.pass(300);
        yield [`${name} moved`, page];
        drag(view(), at(500, 300), at(540, 320), at(530, 360));
        await page.pass(300);
        yield [`${name} dragged`, page];
        drag(view(), at(500, 300, { shiftKey: true }), at(540, 320, { shiftKey: true }));
        await page.pass(300);
        yield [`${name} dragged with shift`, page];
        view().send("pointerdown", at(400, 300));
        drag(view(), at(500, 300, { pointerId: 2 }), at(560, 330, { pointerId: 2 }));
        view().send("pointercancel", at(400, 300));
        await page.pass(300);
        yield [`${name} pinched`, page];
        for (const given of [{ deltaY: -300 }, { deltaY: 4, deltaMode: 1 }, { deltaY: 1e4 }, { deltaY: -9e3 }, { deltaY: 2400 }]) {
            view().send("wheel", at(600, 200, given));
            await page.pass(300);
            yield [`${name} wheel ${given.deltaY}`, page];
        }
        for (const key of ["ArrowLeft", "ArrowUp", "ArrowRight", "ArrowDown", "ArrowDown", "+", "=", "-", "a"])
            page.said.push([key, view().send("keydown", { key })]);
        await page.pass(300);
        yield [`${name} keys`, page];
        if (!page.$("#plane").hidden)
            for (const place of [at(150, 330), at(190, 340)]) { // of two lobes
                drag(page.$("#plane"), place, at(240, 250), at(600, 100));
                await page.pass(300);
                yield [`${name} dragged in the plane from ${place.clientX}`, page];
            }
        // The address opens the same page.
        const again = new Browser(html, { hash: page.location.hash });
        await again.pass(1000);
        const before = shown(page), after = shown(again), short = text => text.replace(/\d+\.\d+/g, number => (+number).toPrecision(4));
        for (const what of ["address", "copy"])
            if (short(before[what]) !== short(after[what]))
                fail(`demo/index.html: ${name}: ${before.address} opens another page: ${what} ${after[what]}`);
    }
    // Each slider and colour alone changes what is drawn: on a small screen, where land is coarse, and without the panel, so that pictures
    // keep their size. The frame in which land's last slider moves is the one that draws its map.
    await open("", { globals: { innerWidth: 360 } });
    for (const hash of [...page.root.querySelectorAll("[role=tab]").map(each => `#tab=${each.value}`), "#tab=spectra&kind=spread"]) {
        page.location.hash = `${hash}&boards=true&moving=false&bare`;
        page.window.send("hashchange");
        for (const each of visible(page).filter(({ type }) => ["range", "color"].includes(type))) {
            const drawn = [];
            for (const value of each.type === "range" ? [off(each, 0.3), off(each, 0.6)] : ["#3a7f05", "#05307f"]) {
                input(each, value);
                await page.pass(16);
                drawn.push(lines(page.calls));
            }
            if (drawn[0] === drawn[1])
                fail(`demo/index.html: ${hash}: ${each.name} changes nothing`);
        }
        yield [`each slider of ${hash}`, page];
    }
    // Painted directions.
    await open("#tab=stripes&field=painted");
    yield ["painted", page];
    for (const places of [[at(300, 200), at(340, 260), at(420, 300)], [at(450, 300), at(450, 300)]])
        drag(view(), ...places);
    page.$("#download").click();
    await page.pass(300);
    yield ["painted strokes", page];
    page.$("#open").click();
    page.$("#picture").send("change", { target: { files: [{}] } });
    await page.pass(300);
    yield ["opened what is no picture", page];
    await open("#tab=sea&bare");
    page.said.push([page.window.send("dragover"), page.window.send("drop", { dataTransfer: { files: [{ width: 180, height: 100 }] } })]);
    await page.pass(300);
    page.$("#download").click();
    yield ["dropped a picture", page];
    // The address.
    for (const hash of ["#tab=none&x=word&seed=8", "#tab=noise&frequency=99&seed=-3&look=loud&zoom=1e9", "#tab=erosion&pitch=9&distance=0&strength=no&gain=0.1",
                        "#tab=sea&pitch=-1&moving=false&wind=1&yaw=2&distance=99", "#tab=materials&preset=marble&boards=true&marble.scale=2&shape=plane&zoom=0",
                        "#tab=spectra&kind=spread&spread=40&orientation=60&bare"]) {
        yield [`opened ${hash}`, await open(hash)];
        if (hash.includes("spread")) {
            drag(page.$("#plane"), at(150, 330), at(240, 250));
            await page.pass(300);
            yield [`dragged ${hash}`, page];
        }
        page.location.hash = "#tab=stripes&frequency=2.5&x=1.25";
        page.window.send("hashchange");
        await page.pass(300);
        yield [`changed ${hash}`, page];
    }
    // The rest.
    const tabs = page.$("[role=tablist]");
    for (const key of ["ArrowRight", "ArrowLeft", "ArrowLeft", "ArrowLeft", "ArrowLeft", "Enter"])
        page.said.push([key, tabs.send("keydown", { key }), page.focused?.value]);
    page.$("#fold").click();
    page.$("#copy").click();
    page.forbidden = true;
    await page.pass(100);
    yield ["folded, copied", page];
    page.$("#copy").click();
    page.$("#fold").click();
    page.said.push([page.$("#panel").send("submit"), view().send("webglcontextlost")]);
    await page.pass(100);
    yield ["unfolded, copied without permission", page];
    view().send("webglcontextrestored");
    await page.pass(2000);
    yield ["restored", page];
    page.scope.innerWidth = 420;
    page.scope.devicePixelRatio = 3;
    page.window.send("resize");
    await page.pass(300);
    yield ["resized", page];
    for (const hash of ["#tab=sea", "#tab=noise&look=evolving", "#tab=erosion"])
        for (const frame of [12, 70]) {
            await open(hash);
            for (let k = 0; k < 9; ++k) {
                view().send("keydown", { key: "ArrowUp" });
                await page.pass(frame, frame);
            }
            yield [`${hash} with frames of ${frame} ms`, page];
        }
    yield ["without WebGL", await open("", { graphics: null })];
    yield ["with an error", await open("", { graphics: { getProgramParameter: (_, name) => name !== "LINK_STATUS" } })];
    yield ["without compiling in the background", await open("#tab=noise", { graphics: { getExtension: () => null } })];
    yield ["still compiling", await open("#tab=noise", { graphics: { getProgramParameter: () => false } })];
    yield ["still drawing", await open("#tab=noise", { graphics: { clientWaitSync: () => "TIMEOUT_EXPIRED" } })];
    yield ["on a small screen", await open("", { globals: { innerWidth: 360, innerHeight: 640, devicePixelRatio: 3 } })];
    yield ["with less motion", await open("#tab=sea", { globals: { matchMedia: query => ({ matches: query.includes("reduced-motion: reduce") }) } })];
}

// Draws of each noise take as many milliseconds as its place in the list, more or less.
async function* benchmark(html) {
    const texts = Object.fromEntries([...html.matchAll(/<script type="text\/plain" id="(.*?)"/g)].map(each => [each[1], `the text of ${each[1]}`]));
    for (const [clocks, fails] of [[true, false], [false, false], [true, true]]) {
        let page, draws = 0, programs = [], current = null, took = 0;
        const spend = count => {
            for (; count > 0; --count)
                page.now += took = programs.indexOf(current) * (1 + 0.1 * Math.sin(++draws)) + 2;
        };
        let begun = 0;
        const graphics = {
            createProgram: () => (programs.push({}), programs.at(-1)), useProgram: program => current = program, drawArrays: () => spend(1),
            getExtension: name => clocks ? { UNMASKED_RENDERER_WEBGL: "renderer", TIME_ELAPSED_EXT: "elapsed", GPU_DISJOINT_EXT: "disjoint" } : null,
            beginQuery: () => begun = page.now, getParameter: name => name !== "disjoint" && `the ${name}`,
            getQueryParameter: (_, name) => name === "QUERY_RESULT" ? (page.now - begun) * 0.9e6 : true, getProgramParameter: () => !fails,
        };
        const codes = [];
        const device = {
            addEventListener: (_, listener) => fails && listener({ error: { message: "the device fails" } }), createBuffer: ({ size }) => ({ mapAsync: async () => {}, unmap() {},
                getMappedRange: () => new BigUint64Array([1000n, 1000n + BigInt(Math.round(0.8e6 * (page.now - begun)))]).buffer, size }),
            queue: { writeBuffer: (...given) => codes.push(lines(given.slice(1).map(each => each.length ? [...each] : each))), onSubmittedWorkDone: async () => {},
                     submit: ([count]) => { begun = page.now; spend(count); } },
            createShaderModule: ({ code }) => codes.push(code) && {},
            createComputePipelineAsync: async () => (programs.push({ getBindGroupLayout() {} }), programs.at(-1)), createBindGroup: () => ({}),
            createQuerySet: () => ({}), createCommandEncoder: () => {
                let count = 0;
                const pass = { setPipeline: pipeline => current = pipeline, setBindGroup() {}, dispatchWorkgroups: (...sides) => { ++count; pass.sides = sides; },
                               end: () => codes.push(`${pass.sides}`) };
                return { beginComputePass: () => pass, resolveQuerySet() {}, copyBufferToBuffer() {}, finish: () => count };
            },
        };
        const gpu = { requestAdapter: async () => ({ features: new Set(clocks ? ["timestamp-query"] : []), ...clocks && { info: { vendor: "a", device: "gpu" } },
                                                  requestDevice: async () => (programs = [], device) }) };
        page = new Browser(html, { texts, graphics, globals: { GPUBufferUsage: {}, GPUMapMode: {}, navigator: { gpu, ...clocks && { clipboard: { writeText: async text => page.said.push(["copied", text]) } } } } });
        yield ["opened", page];
        page.$("#start").click();
        for (const wait of [40, 4e4]) {
            await page.pass(wait);
            page.said.push([...new Set(codes.splice(0))]);
            yield [`measured for ${wait} ms, ${clocks ? "with" : "without"} clocks${fails ? ", failing" : ""}`, page];
        }
        page.$("#copy").click();
        await page.pass(10);
        yield ["copied", page];
    }
    const page = new Browser(html, { graphics: null });
    yield ["without shaders", page];
    page.$("#start").click();
    await page.pass(100);
    page.$("#copy").click();
    yield ["without graphics", page];
}

// ---- Results -------------------------------------------------------------------------------------------------------

const fail = text => {
    console.error(text);
    process.exitCode = 1;
};
const [docs, choice] = process.argv.slice(2), golden = new URL("../golden/pages.txt", import.meta.url), made = [];
for (const [name, steps] of Object.entries({ "demo/index.html": demo, "benchmark.html": benchmark })) {
    const text = readFileSync(`${docs}/${name}`, "utf8");
    let last = [];
    new Browser(text, { more: `;(${TESTS[name]})();`, globals: { fail: words => fail(`${name}: ${words}`) } });
    for await (const [step, page] of steps(text)) {
        const digests = Object.entries(shown(page)).map(([what, seen]) => {
            if (choice === "--show")
                console.log(`==== ${name}: ${step}: ${what}\n${seen}`);
            return seen && `${what} ${createHash("sha1").update(seen).digest("hex").slice(0, 6)}`;
        });
        made.push(`${name}: ${step}: ${digests.filter(each => each && !last.includes(each)).join(" ")}`);
        last = digests;
    }
}
if (choice === "--write")
    writeFileSync(golden, made.join("\n") + "\n");
const wanted = readFileSync(golden, "utf8").trim().split("\n");
for (let i = 0; i < Math.max(made.length, wanted.length); ++i)
    if (made[i] !== wanted[i])
        fail(`${made[i]}\n    was: ${wanted[i]}\n    If this is meant: node tests/source/page_scripts.mjs docs --write`);

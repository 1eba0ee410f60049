// Uses docs/demo/index.html as people do, and checks what it then draws, copies and writes to its address. measure.js calls usePage;
// each check waits for states of the page, never for times: waiting says for which, and run.mjs says it where the page hangs.
const pause = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
const wrong = text => { throw new Error(`${state.tab}: ${text}`); };
async function until(test, what) {
    for (globalThis.waiting = `until ${state.tab} ${what}`; !test(); )
        await pause(20);
    globalThis.waiting = "";
}
const near = (a, b, error = 1e-9) => Math.hypot(...a.map((value, i) => value - b[i])) < error;
const element = id => document.getElementById(id);
const copiedText = () => document.querySelector("textarea").value;
const clickTab = name => document.querySelector(`[role=tab][value=${name}]`).click();
const inputs = (...types) => [...document.querySelectorAll("#controls label:not([hidden]) :is(input, select)")].filter(each => types.includes(each.type));
function give(input, value) {
    input[input.type === "checkbox" ? "checked" : "value"] = value;
    input.dispatchEvent(new Event("input"));
}
const at = ({ min, max, step }, share) => +(+min + Math.round(share * (max - min) / step) * step).toFixed(6);
function send(target, name, x, y, more = {}) {
    const [Kind, given] = name === "wheel" ? [WheelEvent, { deltaY: x }] : name === "keydown" ? [KeyboardEvent, { key: x }]
        : [PointerEvent, { clientX: x, clientY: y, pointerId: 1 }];
    return target.dispatchEvent(new Kind(name, { cancelable: true, ...given, ...more }));
}
function drag(target, [from, ...places], more) {
    send(target, "pointerdown", ...from, more);
    for (const place of places)
        send(target, "pointermove", ...place, more);
    send(target, "pointerup", ...places.at(-1), more);
}

// What a frame gives to its shaders, if they use it.
const given = [];
function watchUniforms() {
    for (const name of ["uniform1f", "uniform1i", "uniform1ui", "uniform2fv", "uniform3fv"]) {
        const own = gl[name].bind(gl);
        gl[name] = (place, ...values) => { given.push([name, ...values.map(String)]); own(place, ...values); };
    }
}
function frame() {
    given.length = 0;
    moving = false;
    drawWhole(1500);
    return JSON.stringify(given);
}

// ---- Each tab ----

function useControls() {
    for (const select of inputs("select-one")) {
        const seen = new Set(), before = select.value;
        for (const { value } of select.options) {
            give(select, value);
            if (values()[select.name] !== value)
                wrong(`${select.name} is not ${value}`);
            state.language = "Shadertoy";
            changed();
            seen.add(select.name === "preset" ? value : copiedText());
        }
        state.language = "GLSL";
        if (seen.size !== select.options.length)
            wrong(`${select.name}: ${select.options.length} options give ${seen.size} codes`);
        give(select, before);
    }
    for (const box of inputs("checkbox")) {
        const before = copiedText(), on = !box.checked;
        give(box, on);
        if (values()[box.name] !== on || copiedText() === before)
            wrong(`${box.name} changes nothing`);
    }
    for (const input of inputs("range", "color")) {
        const drawn = (input.type === "range" ? [at(input, 0.3), at(input, 0.6)] : ["#3a7f05", "#05307f"]).map(value => {
            give(input, value);
            const control = tab().controls.find(each => each.name === input.name), shown = input.parentElement.querySelector("output");
            const told = shown?.textContent.replace(/(.*) km/, (_, number) => `${1000 * number} m`);
            if (values()[input.name] !== value || shown && told !== +value.toPrecision(3) + control.unit)
                wrong(`${input.name} is ${values()[input.name]}, and shown as ${shown?.textContent}, instead of ${value}`);
            return frame();
        });
        if (drawn[0] === drawn[1])
            wrong(`${input.name} changes nothing`);
    }
    // Copied code has each number; angles are in radians there.
    for (const control of shownControls().filter(each => !each.options && !each.check && !each.colour)) {
        const wanted = values()[control.name] * (control.unit === "°" ? Math.PI / 180 : 1), copied = numbers()[control.name];
        if (copied !== "iTime" && !(Math.abs(parseFloat(copied) - wanted) <= 0.01 * Math.min(control.step, 0.01)))
            wrong(`${control.label} ${wanted} is copied as ${copied}`);
    }
}

const depth = () => tab().land ? 1 / state.distance : tab().sea ? 1 / values().altitude : state.zoom;
function useView() {
    const flat = !tab().land && !tab().sea, painted = { shiftKey: true };
    if (tab().lit) { // a ball turns only sideways
        state.x = 0;
        send(view, "keydown", "ArrowLeft");
        if (values().shape !== "ball" || !near([state.x], [-0.24]))
            wrong(`the ball turns by ${state.x}`);
        give(inputs("select-one").find(each => each.name === "shape"), "plane");
    }
    const place = (x, y) => flat ? toPlane(x, y) : [0, 0], view_ = JSON.stringify(state), started = place(50, 30);
    drag(view, [[50, 30], [70, 45], [90, 40]], painted);
    if (JSON.stringify(state) === view_ || !near(place(90, 40), started))
        wrong("what is under the pointer does not follow it");
    if (tab().land) { // its middle moves to the left and away as the pointer moves to the right and down
        [state.x, state.y] = [0, 0];
        drag(view, [[50, 30], [70, 60]], painted);
        const step = 1.25 * viewValues().away / view.clientWidth, [right, back] = [[Math.sin(state.yaw), -Math.cos(state.yaw)], [Math.cos(state.yaw), Math.sin(state.yaw)]]
            .map(axis => (state.x * axis[0] + state.y * axis[1]) / step);
        if (!near([right, back], [-20, -30], 1e-6))
            wrong(`the land moves by ${right} pixels to the right, and ${back} towards the eye`);
    }
    const [corner, zoom] = [place(120, 20), depth()];
    send(view, "wheel", -100, 0, { clientX: 120, clientY: 20 });
    if (!(depth() > zoom) || !near(place(120, 20), corner))
        wrong("the wheel does not come closer to what is under the pointer");
    for (const [delta, limits] of [[1e5, [1 / 3, 1 / 200, 0.02]], [-1e5, [1 / 0.3, 1 / 2, 50]], [1200, []]]) {
        send(view, "wheel", delta);
        if (limits.length && !limits.some(limit => near([depth()], [limit])))
            wrong(`the wheel goes to ${depth()}`);
    }
    send(view, "pointerdown", 40, 40);
    const apart = depth();
    drag(view, [[60, 40], [80, 40]], { pointerId: 2 });
    send(view, "pointercancel", 40, 40);
    if (!near([depth() / apart], [2], 1e-6))
        wrong(`two fingers that move apart zoom by ${depth() / apart}`);
    const alone = depth();
    drag(view, [[60, 40], [80, 40]], { pointerId: 3 });
    if (!near([depth() / alone], [1], 1e-6))
        wrong(`after another was cancelled, one finger zooms by ${depth() / alone}`);
    state.pitch = 0.5; // far from its limits
    for (const [there, back] of [["ArrowLeft", "ArrowRight"], ["ArrowDown", "ArrowUp"], ["+", "-"]]) {
        const before = [state.x, state.y, state.yaw, state.pitch, depth()], now = () => [state.x, state.y, state.yaw, state.pitch, depth()];
        if (send(view, "keydown", there) || near(now(), before) || send(view, "keydown", back) || !near(now(), before, 1e-6))
            wrong(`${there} and ${back} do not return to the same view`);
    }
    if (!send(view, "keydown", "a"))
        wrong("the page takes the key a");
}

// The address opens the same page.
async function useAddress() {
    const name = state.tab, other = Object.keys(TABS).find(each => each !== name);
    const still = each => each.name !== "seconds" || !values().moving; // a frame may come at any time
    const seen = () => `${JSON.stringify(shownControls().filter(still).map(each => values()[each.name]))} ${JSON.stringify(state, ["tab", ...Object.keys(START)])} ${copiedText()}`
        .replace(/-?\d+\.\d+(e-?\d+)?/g, number => (+number).toPrecision(4));
    history.replaceState(null, "", "#");
    changed();
    await until(() => location.hash, "writes its address");
    const address = location.hash, before = seen();
    location.hash = `#tab=${other}&bare`;
    await until(() => state.tab === other, "opens an address");
    for (const control of TABS[name].controls)
        state.values[name][control.name] = control.value;
    clearTimeout(writing); // of the other tab's address
    location.hash = address;
    await until(() => state.tab === name, "opens its address");
    const other_ = seen(), first = [...before].findIndex((letter, i) => letter !== other_[i]);
    if (other_ !== before)
        wrong(`${address} opens another page: ...${other_.slice(first - 20, first + 60)}... instead of ...${before.slice(first - 20, first + 60)}...`);
}

// ---- The rest ----

// Addresses whose values are unknown or out of range, and what is opened instead.
const ADDRESSES = {
    "#tab=noise&frequency=99&seed=-3&look=loud&zoom=1e9&x=word": { frequency: 12, seed: 0, look: "relief", zoom: 50, x: 0 },
    "#tab=erosion&preset=canyon&pitch=9&distance=0&strength=no&gain=7": { pitch: 1.5, distance: 0.3, strength: 0.12, gain: 1, cover: "desert" },
    "#tab=sea&pitch=-1&moving=false&wind=1&yaw=2&distance=99": { pitch: 0.05, moving: false, wind: 2, yaw: 2, distance: 3 },
    "#tab=materials&preset=marble&boards=true&marble.vein_strength=99&shape=plane&zoom=0": { preset: "marble", boards: true, "marble.vein_strength": 1.3, shape: "plane", zoom: 0.02 },
    "#tab=none&seed=8": { tab: "materials", seed: 8 },
};
function useAddresses() {
    for (const [hash, wanted] of Object.entries(ADDRESSES)) {
        history.replaceState(null, "", hash);
        dispatchEvent(new Event("hashchange"));
        for (const [name, value] of Object.entries(wanted))
            if ((values()[name] ?? state[name]) !== value)
                wrong(`${hash} opens ${name} ${values()[name] ?? state[name]}`);
    }
}

function usePlane() {
    showTab("spectra", { kind: "lobes" });
    panel.hidden = false;
    const box = plane.getBoundingClientRect(), unit = planeScale();
    const pixel = (frequency, degrees) => [box.left + box.width / 2 + frequency * unit * Math.cos(radians(degrees)),
                                           box.bottom - 10 - frequency * unit * Math.sin(radians(degrees))];
    for (const kind of ["lobes", "spread"]) {
        showTab("spectra", { kind, f1: 1.5, o1: 75, frequency: 3, orientation: 75 });
        drag(plane, [pixel(1.6, 74), pixel(3, 100), pixel(5, 30)]);
        const made = kind === "lobes" ? [values().f1, values().o1] : [values().frequency, values().orientation];
        if (!near(made, [5, 30], 0.6))
            wrong(`a lobe dragged to 5 cycles and 30 degrees is at ${made}`);
    }
}

async function usePictures() {
    showTab("stripes", { field: "painted" });
    const middle = [view.clientWidth / 2, view.clientHeight / 2], line = [...Array(17).keys()].map(k => [middle[0] - 40 + 5 * k, middle[1] + 40 - 5 * k]);
    for (let k = 0; k < 12; ++k)
        drag(view, line);
    const under = direction(PAINTED_SIDE * PAINTED_SIDE / 2 + PAINTED_SIDE / 2);
    if (!(under[1] > 0.9)) // the waves go to the right and down: twice their angle is 90 degrees
        wrong(`stripes do not follow a stroke to the right and up: ${under}`);
    const none = new DataTransfer();
    none.items.add(new File(["no picture"], "none.png", { type: "image/png" }));
    element("picture").files = none.files;
    element("picture").dispatchEvent(new Event("change"));
    await until(() => !element("warning").hidden && element("warning").textContent.includes("not a picture"), "refuses what is no picture");
    showTab("stripes", { field: "even" });
    state.zoom = 0.05;
    changed();
    if (element("warning").hidden || !element("warning").textContent.includes("alias"))
        wrong("it does not warn of waves that alias");
}

async function useButtons() {
    const names = Object.keys(TABS), tabs = document.querySelector("[role=tablist]");
    clickTab(names[0]);
    for (const [key, index] of [["ArrowRight", 1], ["ArrowLeft", 0], ["ArrowLeft", names.length - 1], ["ArrowRight", 0]]) {
        send(tabs, "keydown", key);
        if (state.tab !== names[index] || document.activeElement.value !== names[index] || document.activeElement.getAttribute("aria-selected") !== "true")
            wrong(`${key} does not lead to ${names[index]}`);
    }
    for (const expanded of ["false", "true"]) {
        element("fold").click();
        if (element("fold").getAttribute("aria-expanded") !== expanded || element("tab").checkVisibility() !== (expanded === "true"))
            wrong("the panel does not fold");
    }
    let written = "";
    for (const writeText of [async text => { written = text; }, async () => { throw new Error("forbidden"); }]) {
        Object.defineProperty(navigator, "clipboard", { value: { writeText }, configurable: true });
        element("copy").textContent = "Copy";
        element("copy").click();
        await until(() => element("copy").textContent === "Copied", "says that it copied");
    }
    const text = document.querySelector("textarea");
    if (written !== text.value || text.selectionStart !== 0 || text.selectionEnd !== text.value.length)
        wrong("it copies another text");
}

async function useSave(pixels) {
    showTab("noise", { look: "colours" });
    frame();
    const { click } = HTMLAnchorElement.prototype;
    let saved = null;
    HTMLAnchorElement.prototype.click = function () { saved = [this.href, this.download]; };
    element("save").click();
    await until(() => saved, "saves a picture");
    HTMLAnchorElement.prototype.click = click;
    const picture = await createImageBitmap(await (await fetch(saved[0])).blob(), { colorSpaceConversion: "none" });
    const context = Object.assign(document.createElement("canvas"), { width: WIDTH, height: HEIGHT }).getContext("2d");
    context.drawImage(picture, 0, 0);
    compare(`the saved ${saved[1]}`, context.getImageData(0, 0, picture.width, picture.height).data, flipped(pixels()), 0);
    if (saved[1] !== "gabor-noise.png")
        wrong(`it saves ${saved[1]}`);
}

// Says that it compiles while it does. Draws from coarse to fine in bands, and coarsely what moves; where the driver loses all, draws
// again; and shows a compiler's errors.
async function useGraphics(pixels) {
    showTab("noise", { look: "plain", taps: "3" });
    const whole = (frame(), `${pixels()}`), marks = name => performance.getEntriesByName(name).length;
    const again = async (cost, moves) => {
        panel.hidden = false;
        performance.clearMarks();
        [program().cost, moving, drawing] = [cost, moves, false];
        clearTimeout(settle);
        ask();
        await until(() => !drawing, "draws");
        [drawing, panel.hidden] = [true, true];
        return [marks("picture"), marks("sharp")];
    };
    const coarse = await again(1, true);
    if (`${coarse}` !== "1,0")
        wrong(`what moves on a slow device is drawn ${coarse} times: ${document.querySelector("pre").textContent.slice(0, 200)}`);
    const drawn = await again(1, false);
    if (`${drawn}` !== "3,1" || `${pixels()}` !== whole || !element("state").hidden)
        wrong(`bands draw ${drawn} pictures, or not what is drawn at once`);
    const sharp = await again(1e-6, true);
    if (`${sharp}` !== "0,1")
        wrong(`what moves on a fast device is drawn ${sharp} times`);
    const own = gl.getProgramParameter, usual = parallel;
    let compiles = true;
    parallel = { COMPLETION_STATUS_KHR: -1 };
    gl.getProgramParameter = (made, what) => what === -1 ? !compiles : own.call(gl, made, what);
    showTab("noise", { taps: "2" });
    const done = again(0, false);
    await until(() => element("state").textContent === "Compiling…" && !element("state").hidden, "says that it compiles");
    compiles = false;
    if ((await done)[1] !== 1 || !element("state").hidden)
        wrong("it does not draw what it compiled");
    [gl.getProgramParameter, parallel] = [own, usual];
    const lost = gl.getExtension("WEBGL_lose_context");
    const event = name => new Promise(resolve => view.addEventListener(`webglcontext${name}`, resolve, { once: true }));
    for (const [name, wanted] of [["noise", { look: "plain", taps: "3" }], ["erosion", {}], ["sea", { moving: false }]]) {
        showTab(name, wanted);
        map = null; // one that was drawn for a larger view would be finer
        frame();
        const before = pixels();
        let next = event("lost");
        lost.loseContext();
        await next;
        await pause(0); // until the page's listener has allowed to restore it
        next = event("restored");
        lost.restoreContext();
        await next;
        frame();
        const after = pixels(), differ = after.filter((value, i) => value !== before[i]).length / after.length;
        if (differ > (name === "erosion" ? 0.03 : 0)) // up to 1 % of the land, at outlines of hills, was seen to differ
            wrong(`it draws ${100 * differ} % of ${name} otherwise after it lost its context`);
    }
    showTab("noise", { look: "plain", taps: "3" });
    const { code } = tab();
    tab().code = () => "no GLSL";
    changed();
    [drawing, panel.hidden] = [false, false];
    ask();
    await until(() => !drawing && document.querySelector("pre").textContent.includes("ERROR"), "shows a compiler's error");
    [drawing, panel.hidden] = [true, true];
    tab().code = code;
    changed();
}

async function usePage(pixels) {
    view.setPointerCapture = plane.setPointerCapture = () => {}; // a script's events have no pointer to capture
    history.replaceState(null, "", "#tab=erosion&bare");
    readAddress();
    watchUniforms();
    for (const name of Object.keys(TABS)) {
        clickTab(name);
        if (state.tab !== name)
            wrong(`its button does not show ${name}`);
        useControls();
        useView();
        await useAddress();
    }
    useAddresses();
    await useGraphics(pixels);
    usePlane();
    await usePictures();
    await useButtons();
    await useSave(pixels);
}

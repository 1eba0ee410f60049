// Prints as JSON what the demo page copies for each tab and each option: [what, language, code]. Elements are stand-ins that do
// nothing: tools/test-engines demo uses the page in browsers.
//   copied.mjs DOCS/demo [EXPRESSION]    prints the value of this expression of the page, or of its promise, instead

import { readFileSync } from "node:fs";
import vm from "node:vm";

const script = ["texts.js", "page.js"].map(name => readFileSync(`${process.argv[2]}/${name}`, "utf8")).join("");
const nothing = new Proxy(function () {}, {
    get: (_, name) => name === Symbol.iterator ? () => [].values() : name === Symbol.toPrimitive ? () => 0 : nothing,
    set: () => true, apply: () => nothing, construct: () => nothing,
});
const names = "addEventListener requestAnimationFrame setTimeout clearTimeout getComputedStyle history matchMedia ImageData Option ResizeObserver".split(" ");
const scope = { ...Object.fromEntries(names.map(name => [name, nothing])), URLSearchParams, location: { hash: "" }, devicePixelRatio: 1, innerWidth: 900, innerHeight: 600,
                document: { querySelector: () => nothing, querySelectorAll: () => nothing, createElement: () => nothing } };
const copies = `;(() => {
    const copies = [];
    const copy = what => languages().forEach(each => { state.language = each; copies.push([what, each, copied()]); });
    for (const name of Object.keys(TABS)) {
        showTab(name);
        copy(name);
        for (const control of tab().controls.filter(each => each.options || each.check)) {
            // Of the presets, one for each material.
            const options = control.check ? [true] : control.options.filter((each, i, all) => control.name !== "preset" || name !== "materials"
                || all.findIndex(other => DATA.presets[other].material === DATA.presets[each].material) === i);
            for (const option of options) {
                const before = { ...values() };
                values()[control.name] = option;
                if (control.name === "preset")
                    usePreset();
                copy(name + ", " + control.name + " " + option);
                Object.assign(values(), before);
            }
        }
    }
    return JSON.stringify(copies);
})()`;
console.log(await vm.runInNewContext(script + (process.argv[3] ?? copies), scope));

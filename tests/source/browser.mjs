// As much of a browser as docs' pages use, without drawing: a page opens, gets events and says what it shows, and what it asks of
// WebGL. Time passes only in `pass`.

import vm from "node:vm";

const EMPTY = ["meta", "link", "input", "img", "br"];
const decoded = text => text.replace(/&amp;/g, "&").replace(/&lt;/g, "<").replace(/&gt;/g, ">");

class Element {
    constructor(tag, browser) {
        Object.assign(this, { tag, browser, attributes: {}, children: [], listeners: {}, dataset: {}, hidden: false, text: "", style: {},
                              clientWidth: 340, clientHeight: 170 });
        const classes = new Set();
        this.classList = { toggle: (name, on = !classes.has(name)) => { classes[on ? "add" : "delete"](name); return on; }, all: classes };
    }
    get textContent() { return this.text + this.children.map(each => each.textContent).join(""); }
    set textContent(text) { this.text = `${text}`; this.children = []; }
    get options() { return this.all().filter(each => each.tag === "option"); }
    get lastChild() { return this.children.at(-1); }
    all(found = []) {
        for (const each of this.children)
            found.push(each) && each.all(found);
        return found;
    }
    append(...given) {
        for (const each of given)
            typeof each === "string" ? this.text += each : this.children.push(each);
    }
    replaceChildren() { this.children = []; }
    setAttribute(name, value) { this.attributes[name] = `${value}`; }
    matches(selector) {
        return selector.startsWith("#") ? this.attributes.id === selector.slice(1)
            : selector.startsWith("[") ? this.attributes[selector.slice(1, -1).split("=")[0]] === selector.slice(1, -1).split("=")[1] : this.tag === selector;
    }
    querySelectorAll(selectors) {
        return selectors.split(", ").flatMap(selector => selector.split(" ").reduce((found, part) => found.flatMap(each => each.all())
            .filter(each => each.matches(part)), [this]));
    }
    querySelector(selectors) { return this.querySelectorAll(selectors)[0] ?? null; }
    addEventListener(name, listener) { (this.listeners[name] ??= []).push(listener); }
    // Returns whether a listener prevents what the browser would do.
    send(name, given = {}) {
        let prevented = false;
        const event = { pointerId: 1, preventDefault: () => prevented = true, target: this, currentTarget: this, ...given };
        for (const listener of this.listeners[name] ?? [])
            listener(event);
        return prevented;
    }
    click() {
        this.browser.said.push(["click", this.tag, this.attributes.id ?? "", this.download ?? "", this.href ?? ""]);
        this.send("click");
    }
    focus() { this.browser.focused = this; }
    select() { this.browser.said.push(["select", this.tag]); }
    setPointerCapture() {}
    getBoundingClientRect() { return { left: 20, width: 340, bottom: 400 }; }
    getContext(kind, options) { return this.context ??= this.browser.context(kind, options, this); }
    toDataURL() { return `data:${[...this.context.pixels.data]}`; }
    createTHead() { return this.made("thead"); }
    createTBody() { return this.made("tbody"); }
    insertRow() { return this.made("tr"); }
    made(tag) { this.children.push(new Element(tag, this.browser)); return this.lastChild; }
}

function parsed(html, browser) {
    const root = new Element("root", browser), open = [root];
    for (const [, comment, closing, tag, attributes, text] of html.matchAll(/(<!.*?>)|<(\/?)(\w+)((?:\s+[\w:-]+(?:=(?:"[^"]*"|[^\s">]+))?)*)\s*>|([^<]+)/g)) {
        if (comment)
            continue;
        if (text !== undefined) {
            open.at(-1).text += decoded(text).trim() && decoded(text);
        } else if (closing) {
            while (open.length > 1 && open.pop().tag !== tag);
        } else {
            const made = new Element(tag, browser);
            for (const [, name, quoted, bare] of attributes.matchAll(/([\w:-]+)(?:=(?:"([^"]*)"|([^\s">]+)))?/g)) {
                made.attributes[name] = decoded(quoted ?? bare ?? "");
                if (name === "hidden" || name === "disabled")
                    made[name] = true;
            }
            open.at(-1).append(made);
            if (!EMPTY.includes(tag))
                open.push(made);
        }
    }
    for (const option of root.all().filter(each => each.tag === "option"))
        option.value = option.textContent;
    return root;
}

export class Browser {
    // `graphics` are functions of WebGL that answer otherwise than here, or null without WebGL; `texts` are those of elements, by their
    // ids; `more` follows the page's script.
    constructor(html, { hash = "", graphics = {}, texts = {}, globals = {}, more = "" } = {}) {
        Object.assign(this, { said: [], timers: [], frames: [], now: 1000, graphics, calls: [] });
        const [, body, script] = html.match(/^([^]*?)<script>\n([^]*?)<\/script>/);
        const embedded = Object.fromEntries([...body.matchAll(/<script type="text\/plain" id="(.*?)".*?>([^]*?)<\/script>/g)].map(each => each.slice(1)));
        this.texts = { ...embedded, ...texts };
        this.root = parsed(body.replace(/<(script|style).*?>[^]*?<\/\1>/g, ""), this);
        this.window = new Element("window", this);
        this.location = { hash };
        const browser = this, made = tag => new Element(tag, browser);
        const document = {
            querySelector: selector => this.root.querySelector(selector), querySelectorAll: selector => this.root.querySelectorAll(selector),
            getElementById: id => id in this.texts ? { textContent: this.texts[id] } : this.root.querySelector("#" + id),
            createElement: made, execCommand: name => this.said.push(["command", name]),
        };
        this.scope = {
            document, location: this.location, URLSearchParams, innerWidth: 900, innerHeight: 600, devicePixelRatio: 1.25,
            navigator: { clipboard: { writeText: async text => {
                if (this.forbidden)
                    throw new Error("forbidden");
                this.said.push(["copied", text]);
            } } },
            history: { replaceState: (_state, _title, address) => this.location.hash = address },
            setTimeout: (call, wait = 0, ...given) => this.timers.push({ id: ++this.count, at: this.now + wait, call: () => call(...given) }) && this.count,
            clearTimeout: id => this.timers = this.timers.filter(each => each.id !== id),
            requestAnimationFrame: call => this.frames.push(call),
            addEventListener: (...given) => this.window.addEventListener(...given),
            getComputedStyle: () => ({ getPropertyValue: name => name }), getSelection: () => ({ selectAllChildren: each => this.said.push(["select", each.attributes.id]) }),
            matchMedia: () => ({ matches: false }), performance: { now: () => this.now },
            Option: class extends Element { constructor(text, value) { super("option", browser); Object.assign(this, { text, value }); } },
            ImageData: class { constructor(width, height) { Object.assign(this, { width, height, data: new Uint8ClampedArray(4 * width * height) }); } },
            createImageBitmap: async file => { if (!file.width) throw new Error("no picture"); return file; },
            ...globals,
        };
        this.count = 0;
        vm.runInNewContext(script + more, this.scope);
    }
    $(selector) { return this.root.querySelector(selector); }
    context(kind, _options, canvas) {
        if (kind === "2d")
            return new Proxy({ canvas }, { get: (target, name) => name in target ? target[name] : name === "getImageData"
                ? (x, y, width, height) => ({ data: this.picture(width, height, x, y) })
                : (...given) => {
                    if (name === "putImageData")
                        target.pixels = given[0];
                    (canvas.attributes.id ? this.calls : this.said).push([name, ...given.map(each => typeof each === "object" ? "object" : each)]);
                },
            set: (target, name, value) => {
                target[name] = value;
                this.calls.push([name, value]);
                return true;
            } });
        if (!this.graphics)
            return null;
        const sources = new Map(), attached = new Map(), own = this.graphics;
        const answers = {
            createShader: type => ({ type }), createProgram: () => ({ shaders: [] }), createTexture: () => ({}), createFramebuffer: () => ({}), createQuery: () => ({}),
            shaderSource: (shader, text) => sources.set(shader, text) && this.said.push(["shader", text]), attachShader: (program, shader) => attached.set(program, `${attached.get(program)}${sources.get(shader)}`),
            getUniformLocation: (program, name) => new RegExp(`\\buniform [^;]*\\b${name}\\b`).test(attached.get(program)) ? name : null,
            getProgramParameter: () => true, getExtension: () => ({}), isContextLost: () => false, getAttachedShaders: () => ["vertex", "fragment"], getShaderInfoLog: name => `${name} fails`,
            readPixels: (x, y, width, height, format, type, row) => type === "FLOAT" && row.fill(0).set([0.01 * y, -0.02 * y]),
            clientWaitSync: () => "CONDITION_SATISFIED", getParameter: name => `the ${name}`, ...own,
        };
        return new Proxy({}, { get: (_, name) => /^[A-Z]/.test(name) ? name : (...given) => {
            if (/^(uniform|viewport|drawArrays|tex|bindFramebuffer|generateMipmap|framebuffer)/.test(name))
                this.calls.push([name, ...given.map(each => each?.data ? [...each.data].slice(0, 64) : typeof each === "object" && !Array.isArray(each) ? each && "object" : each)]);
            return answers[name]?.(...given);
        } });
    }
    picture(width, height) {
        return Uint8ClampedArray.from({ length: 4 * width * height }, (_, i) => {
            const x = (i >> 2) % width, y = Math.floor((i >> 2) / width);
            return 127 + 60 * Math.sin(0.2 * x + 0.1 * y + (i & 3)) + 60 * Math.cos(0.003 * y * y);
        });
    }
    // Lets time pass, with a frame of this length drawn at its end.
    async pass(milliseconds, frame = 16) {
        const end = this.now + milliseconds;
        do {
            await new Promise(setImmediate);
            this.now = Math.min(end, this.now + frame);
            for (const timer of this.timers.filter(each => each.at <= this.now).sort((a, b) => a.at - b.at)) {
                this.timers = this.timers.filter(each => each !== timer);
                timer.call();
            }
            for (const frame of this.frames.splice(0)) {
                this.calls = [];
                frame(this.now);
            }
        } while (this.now < end);
        await new Promise(setImmediate);
    }
}

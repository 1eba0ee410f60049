// The page's address can name another drop-in and macros: ?drop_in=gabor_sparse&GABOR_IMPULSES=2
const { drop_in = "gabor_noise", ...macros } = Object.fromEntries(new URLSearchParams(location.search));
const noise = Object.entries(macros).map(([name, value]) => `#define ${name} ${value}\n`).join("")
    + await (await fetch(`./node_modules/gabor-noise/shaders/${drop_in}.glsl`)).text();

async function draw() {
    const engine = new BABYLON.Engine(document.querySelector("canvas"));
    const scene = new BABYLON.Scene(engine);
    const effect = new BABYLON.EffectWrapper({
        engine,
        name: "noise",
        uniformNames: ["shown"],
        fragmentShader: noise + `
            uniform bool shown;
            void main()
            {
                vec2 p = gl_FragCoord.xy / 32.0;
                float n = gabor_noise(p, 4.0, 0.7854, 7u);
                gl_FragColor = vec4(vec3(shown ? gabor_unorm(n) : n), 1.0);
            }`,
    });
    await effect.effect.whenCompiledAsync();
    const target = new BABYLON.RenderTargetTexture("noise", { width: 256, height: 257 }, scene, {
        type: BABYLON.Constants.TEXTURETYPE_FLOAT, generateMipMaps: false, generateDepthBuffer: false,
    });
    let shown = false;
    effect.onApplyObservable.add(() => effect.effect.setBool("shown", shown));
    const renderer = new BABYLON.EffectRenderer(engine);
    renderer.render(effect, target);
    const pixels = await target.readPixels();

    shown = true;
    renderer.render(effect);
    return {
        engine: "Babylon.js", version: BABYLON.Engine.Version, dialect: "GLSL 300 es",
        driver: engine.getGlInfo().renderer, values: pixels.filter((_, index) => index % 4 === 0),
    };
}

globalThis.drawn = draw();

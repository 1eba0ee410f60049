const noise = await (await fetch("../../../shaders/gabor_noise.glsl")).text();

async function draw() {
    const engine = new BABYLON.Engine(document.querySelector("canvas"));
    const scene = new BABYLON.Scene(engine);
    const effect = new BABYLON.EffectWrapper({
        engine,
        name: "noise",
        // Babylon sets the precision of floats only.
        fragmentShader: "precision highp float; precision highp int;\n" + noise + `
            void main()
            {
                vec2 p = gl_FragCoord.xy / 32.0;
                gl_FragColor = vec4(gl_FragCoord.y < 256.0 ? gabor_noise(p, 4.0, 0.7854, 7u)
                    : gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u));
            }`,
    });
    await effect.effect.whenCompiledAsync();
    const target = new BABYLON.RenderTargetTexture("noise", { width: 256, height: 257 }, scene, {
        type: BABYLON.Constants.TEXTURETYPE_FLOAT, generateMipMaps: false, generateDepthBuffer: false,
    });
    new BABYLON.EffectRenderer(engine).render(effect, target);
    const pixels = await target.readPixels();
    return {
        engine: "Babylon.js", version: BABYLON.Engine.Version, dialect: "GLSL 300 es",
        driver: engine.getGlInfo().renderer, values: pixels.filter((_, index) => index % 4 === 0),
    };
}

globalThis.drawn = draw();

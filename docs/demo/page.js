// The live page: its tabs, how it draws them, and what it copies. texts.js has the shaders.
"use strict";
const $ = selector => document.querySelector(selector);
const view = $("#view"), panel = $("#panel"), plane = $("#plane");
const radians = degrees => degrees * Math.PI / 180;
const literal = value => `${+value.toFixed(5)}`.replace(/^-?\d+$/, "$&.0");

// ---- Tabs ----------------------------------------------------------------------------------------------------------
// A tab has controls, the shaders that it needs, and the text of a GLSL function, which PICTURE calls. The values `v` in it are the
// names of uniforms when the page draws, and numbers in code to copy. Angles are in degrees in controls.

const range = (name, label, min, max, step, value, unit = "") => ({ name, label, min, max, step, value, unit });
const words = name => name.replaceAll(/[_-]/g, " ");
const capital = word => word[0].toUpperCase() + word.slice(1);
const choice = (name, label, value, options) => ({ name, label, value, options });
const ownValue = control => control.value;
const check = (name, label, value) => ({ name, label, value, check: true });
const FREQUENCY = range("frequency", "Frequency", 0, 12, 0.1, 4);
const DIRECTION = range("orientation", "Direction", 0, 180, 1, 45, "°");
const SEED = range("seed", "Seed", 0, 99, 1, 7);
const LANGUAGES = ["GLSL", "Shadertoy", "HLSL", "WGSL"];
// The direction of the waves, at right angles to the stripes.
const FIELDS = {
    vortex: () => `p / (0.2 + length(p))`,
    rays: () => `vec2(p.y, -p.x) / (0.2 + length(p))`,
    even: v => `vec2(cos(${v.orientation}), sin(${v.orientation}))`,
    flow: v => `normalize(vec2(gabor_noise(0.12 * p, 0.3, 0.6, ${v.seed} + 1u), gabor_noise(0.12 * p, 0.3, 2.1, ${v.seed} + 2u)))`,
};
const PAINTED = "gabor-directions.png", PAINTED_WIDTH = 24;
const painted = v => `vec2 painted_wave(vec2 p)
{
    vec2 twice = 2.0 * textureLod(painted, p / ${literal(PAINTED_WIDTH)} + 0.5, 0.0).xy - 1.0; // cosine and sine of twice the angle
    float angle = 0.5 * atan(twice.y, twice.x);
    return ${v.frequency} * vec2(cos(angle), sin(angle));
}

`;
const PROFILES = {
    sine: s => `0.5 + 0.5 * ${s}.x`,
    triangle: s => `abs(atan(${s}.y, ${s}.x)) / 3.1415927`,
    sawtooth: s => `0.5 + atan(${s}.y, ${s}.x) / 6.2831853`,
    pulse: s => `smoothstep(-0.15, 0.15, ${s}.x)`,
    ridges: s => `1.0 - abs(${s}.y)`,
};
// The rest of the function that draws fractal noise.
const FRACTALS = {
    clouds: v => `    GaborPlace place = gabor_place_at(p + vec2(${v.evolution}, 0.0));
    place.evolution = 0.2 * ${v.evolution}; // the clouds change in place, and after 1 they are as before
    float rank = gabor_uniform(gabor_fractal_noise_filtered(place, dFdx(p), dFdy(p), fractal, ${v.seed}).noise);
    float cloud = smoothstep(-0.05, 0.25, rank - (1.0 - ${v.cover}));
    vec3 white = mix(vec3(1.0), vec3(0.62, 0.66, 0.72), smoothstep(0.1, 0.6, rank - (1.0 - ${v.cover})));
    return mix(vec3(0.2, 0.42, 0.75), white, cloud);
`,
    marble: v => `    GaborWarp warp = gabor_warp(gabor_place_at(p), ${v.strength}, fractal, ${v.seed});
    vec2 dx = dFdx(p).x * warp.dx + dFdx(p).y * warp.dy;
    vec2 dy = dFdy(p).x * warp.dx + dFdy(p).y * warp.dy;
    float n = gabor_fractal_noise_filtered(warp.place, dx, dy, gabor_fractal(3.0, 0.4), gabor_derived_seed(${v.seed}, 7)).noise;
    float vein = exp(-9.0 * n * n);
    return mix(vec3(0.92, 0.9, 0.86) + 0.02 * n, vec3(0.36, 0.38, 0.4), 0.8 * vein);
`,
    ridges: v => `    GaborWarp warp = gabor_warp(gabor_place_at(p), 0.3 * ${v.strength}, gabor_fractal(2.0, 0.5), gabor_derived_seed(${v.seed}, 7));
    vec2 dx = dFdx(p).x * warp.dx + dFdx(p).y * warp.dy;
    vec2 dy = dFdy(p).x * warp.dx + dFdy(p).y * warp.dy;
    fractal.shape = GABOR_RIDGED;
    GaborFractalNoise n = gabor_fractal_noise_filtered(warp.place, dx, dy, fractal, ${v.seed});
    vec2 slope = vec2(dot(n.gradient, warp.dx), dot(n.gradient, warp.dy));
    vec3 normal = normalize(vec3(-0.09 * slope, 1.0));
    float light = max(dot(normal, normalize(vec3(cos(${v.sun}), -sin(${v.sun}), 0.8))), 0.0);
    vec3 rock = mix(vec3(0.36, 0.3, 0.25), vec3(0.86, 0.82, 0.76), gabor_uniform(n.noise));
    return sqrt(rock * (0.12 + 0.95 * light));
`,
    billows: v => `    fractal.shape = GABOR_BILLOW;
    GaborFractalNoise n = gabor_fractal_noise_filtered(gabor_place_at(p), dFdx(p), dFdy(p), fractal, ${v.seed});
    vec3 normal = normalize(vec3(-0.1 * n.gradient, 1.0));
    float light = max(dot(normal, normalize(vec3(cos(${v.sun}), -sin(${v.sun}), 0.8))), 0.0);
    return sqrt(vec3(0.72, 0.6, 0.5) * (0.15 + 0.9 * light));
`,
};
const DATA = JSON.parse(TEXTS["presets.json"]);
const materialOf = values => DATA.presets[values.preset].material;
const byte = value => Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
const hex = colour => typeof colour === "string" ? colour : "#" + colour.map(part => byte(part).toString(16).padStart(2, "0")).join("");
const linear = colour => [1, 3, 5].map(i => parseInt(colour.slice(i, i + 2), 16) / 255)
    .map(part => part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4);
const memberControl = ({ name, kind, min, max, value, about }) => {
    const label = capital(words(name.split(".").at(-1))), whole = kind === "integer";
    const step = whole ? 1 : 10 ** Math.floor(Math.log10((max - min) / 50));
    return kind === "colour" ? { name, label, about, colour: true, value: hex(value) }
        : { ...range(name, label, min, max, step, value, kind === "angle" ? "°" : ""), about, whole };
};
// The value that one of these presets gives to a control.
const presetValue = presets => (control, values) => {
    const value = presets[values.preset]?.[control.given ?? control.name];
    return value === undefined ? control.value : control.colour ? hex(value) : value;
};
const PLACE = "fjord"; // which the page opens with
const seenFrom = ({ yaw, pitch }) => ({ yaw: radians(yaw ?? 0), pitch: radians(pitch ?? 30) });
const COVERS = ["alpine", "meadow", "desert", "badlands"]; // as in landscape.glsl

const landCode = (v, values) => `Ground land()
{
    GaborErosion erosion = gabor_erosion();
${DATA.erosion.map(({ name }) => `    erosion.${name} = ${v[name]};\n`).join("")}\
    vec2 sun = cos(${v.elevation}) * vec2(cos(${v.light}), sin(${v.light}));
    return Ground(ivec2(0), vec2(0.0), ${v.seed}, erosion, ${v.reach}, sun, ${COVERS.indexOf(values.cover)}, ${v.water});
}
`;

const OCEAN_BANDS = 12, OCEAN_MEMBERS = ["wind", "fetch", "swell_height", "swell_period"];
const oceanCode = v => `GaborOcean ocean()
{
    GaborSea sea = gabor_sea(); // whose swell goes 60 degrees from the wind
${OCEAN_MEMBERS.map(name => `    sea.${name} = ${v[name]};\n`).join("")}\
    return gabor_ocean_of(sea); // the same in all pixels: faster if computed once and passed as a uniform
}
`;

const TABS = {
    erosion: {
        label: "Mountains",
        needs: ["gabor_noise", "gabor_fractal", "gabor_erosion", "srgb", "ground", "ranges", "landscape"],
        land: true,
        start: values => seenFrom(DATA.landscape[values.preset]),
        controls: [
            choice("preset", "Place", PLACE, [...new Set([PLACE, ...Object.keys(DATA.landscape)])]),
            choice("cover", "Cover", COVERS[0], COVERS),
            { ...range("water", "Water level", -2, 1, 0.01, -2), given: "water_level", about: "Level of lakes; there are none at -2" },
            { ...range("light", "Sun from", -180, 180, 1, -135, "°"), given: "light_azimuth" },
            { ...range("elevation", "Sun's height", 2, 90, 1, 38, "°"), given: "light_elevation" },
            { ...SEED, value: 0 },
            ...DATA.erosion.map(memberControl)],
        first: { preset: PLACE },
        usual: presetValue(DATA.landscape),
        code: (v, values) => `${landCode(v, values)}
// The colour for a screen. \`place\` is in pixels from the middle of the view, y downwards, and \`wide\` a pixel's side at distance 1.
// For the land itself, call ground_at(land(), p, 0.0): its height, slope and ridge.
vec3 land_in_pixel(vec2 place, float wide)
{
    vec2 yaw = vec2(cos(${v.yaw}), sin(${v.yaw}));
    vec2 pitch = vec2(cos(${v.pitch}), sin(${v.pitch}));
    vec2 middle = vec2(${v.x}, ${v.y});
    return srgb(exposed(seen_by_camera(land(), middle, ${v.away}, yaw, pitch, place, wide).light));
}
`,
        about: "Every point is evaluated on its own: no simulation. The copied code needs no textures, and its land never repeats; this page draws a map of it, which repeats after 20 units. Drag to turn, with Shift to move, scroll to come closer.",
    },
    sea: {
        label: "Sea",
        needs: ["gabor_noise", "gabor_fractal", "gabor_ocean", "srgb", "seascape"],
        macros: `#define GABOR_OCEAN_BANDS ${OCEAN_BANDS} // waves down to 0.1 m\n`,
        sea: true,
        keeps: ["moving", "seconds"],
        start: values => seenFrom({ pitch: 8, ...DATA.ocean[values.preset] }),
        controls: [
            choice("preset", "Weather", "sea", Object.keys(DATA.ocean)),
            range("wind", "Wind", 2, 30, 0.5, 12, " m/s"),
            range("fetch", "Open water", 1000, 1000000, 1000, 200000, " m"),
            range("swell_height", "Swell", 0, 8, 0.1, 0, " m"),
            range("swell_period", "Swell's period", 5, 25, 0.5, 12, " s"),
            { ...range("sun", "Sun's height", 0, 90, 1, 20, "°"), given: "light_elevation" },
            { ...range("light", "Sun from", -180, 180, 1, -130, "°"), given: "light_azimuth" },
            range("altitude", "Camera", 2, 200, 1, 12, " m"),
            check("moving", "Waves move", !matchMedia("(prefers-reduced-motion: reduce)").matches),
            range("seconds", "Time", 0, 600, 0.1, 60, " s"),
            SEED],
        first: { preset: "sea" },
        usual: presetValue(DATA.ocean),
        code: v => `${v === NAMES ? OCEAN_READ : oceanCode(v)}
// The light from the sea or the sky, for a screen. \`place\` is in pixels from the picture's middle, y downwards, and
// \`wide\` a pixel's side at distance 1.
vec3 sea_in_pixel(vec2 place, float wide)
{
    vec2 to_sun = cos(${v.sun}) * vec2(cos(${v.light}), sin(${v.light}));
    Sea water = sea_of(ocean(), ${v.seed}, int(${v.seconds}), fract(${v.seconds}), to_sun);
    vec2 around = vec2(cos(${v.yaw}), sin(${v.yaw}));
    vec2 down = vec2(cos(${v.pitch}), sin(${v.pitch}));
    return srgb(seen_at_sea_in_pixel(water, ${v.altitude}, around, down, place, wide).light);
}
`,
        about: "Each pixel finds its water by itself: no textures, no state, and the sea never repeats. Drag to look around, scroll to rise.",
        animated: values => values.moving,
    },
    stripes: {
        label: "Stripes",
        needs: ["gabor_noise"],
        languages: values => values.field === "painted" ? ["GLSL", "HLSL", "WGSL"] : [...LANGUAGES, "TSL"],
        scale: 48,
        controls: [
            choice("field", "Directions", "vortex", [...Object.keys(FIELDS), "painted"]),
            DIRECTION,
            range("frequency", "Frequency", 0, 6, 0.05, 1.6),
            range("sharpness", "Sharpness", 1, 8, 0.1, 3),
            choice("profile", "Profile", "sine", Object.keys(PROFILES)),
            choice("colours", "Colours", "ink", ["ink", "grey", "zebra", "sea"]),
            SEED],
        shown: (name, values) => name !== "orientation" || values.field === "even",
        code: (v, values) => `${values.field === "painted" ? painted(v) : ""}vec3 pattern(vec2 p)
{
${values.field === "painted" ? `    GaborPlace place = gabor_place_at(p);
    GaborWaves waves;
    for (int i = 0; i < 9; ++i) {
        waves.wave[i] = painted_wave(gabor_node_position(place, i));
    }
    vec3 stripes = gabor_stripes_of(gabor_field_waves(place, waves, ${v.seed}), ${v.sharpness}); // cosine, sine, intensity`
    : `    vec2 direction = ${FIELDS[values.field](v)};
    vec3 stripes = gabor_stripes(p, ${v.frequency} * direction, ${v.sharpness}, ${v.seed}); // cosine, sine, intensity`}
    float t = ${PROFILES[values.profile]("stripes")};
    return ${{ grey: "vec3(t)", ink: "mix(vec3(0.03, 0.05, 0.11), vec3(0.94, 0.89, 0.78), t)",
               zebra: "mix(vec3(0.02), vec3(0.92, 0.86, 0.74), smoothstep(0.3, 0.7, t))",
               sea: "mix(vec3(0.01, 0.09, 0.16), vec3(0.55, 0.85, 0.83), t * t)" }[values.colours]};
}
`,
        about: `Stripes follow any direction field and fork where they must. Choose <em>painted</em> and drag to comb them with the
            mouse, or drop a picture here: stripes then follow its edges.`,
        shortest: values => values.frequency,
    },
    materials: {
        label: "Materials",
        needs: ["gabor_noise", "gabor_spectrum", "gabor_fractal", "gabor_materials", "room", "light", "srgb", "ball"],
        scale: 128,
        lit: true,
        keeps: ["shape", "size", "light", "elevation"],
        controls: [
            { ...choice("preset", "Material", "wood", Object.keys(DATA.presets)), group: name => DATA.presets[name].material },
            ...DATA.controls.map(memberControl),
            ...["boards", "coat", "finish"].flatMap(part => [check(part, capital(part), false),
                                                     ...DATA.boards.filter(each => each.name.startsWith(part)).map(memberControl)]),
            { ...SEED, value: 0 },
            choice("shape", "On", "ball", ["ball", "plane"]),
            range("size", "Size", 0.5, 8, 0.1, 3),
            range("light", "Light from", 0, 360, 1, 130, "°"),
            range("elevation", "Light height", 5, 90, 1, 45, "°")],
        shown: (name, values) => !name.includes(".") || name.startsWith(materialOf(values) + ".")
            || ["boards", "coat", "finish"].some(part => values[part] && name.startsWith(part + ".")),
        first: { preset: "wood" },
        usual: presetValue(DATA.presets),
        code: (v, values) => {
            const material = materialOf(values), name = NAMES[material];
            const type = "Gabor" + material.split("-").map(capital).join("");
            const members = (of, name) => shownControls()
                .filter(each => each.name.startsWith(of + ".") && (v === NAMES || values[each.name] !== each.value))
                .map(each => `    ${name}.${each.name.split(".")[1]} = ${v[each.name]};\n`).join("");
            const own = members(material, name), seed = values.boards ? "board.seed" : v.seed;
            const at = values.boards ? "board.position, board.dx, board.dy" : "p, dFdx(p), dFdy(p)";
            const call = own ? `gabor_${name}_filtered_at(${at}, vec2(0.0), ${name}, ${seed})` : `gabor_${name}_filtered(${at}, ${seed})`;
            const bare = values.boards ? `gabor_laid(${call}, board, boards)` : call;
            const salt = values.boards && values["coat.edge_wear"] > 0 ? "board.seed" : v.seed;
            const laid = !values.coat ? bare
                : `gabor_coated_filtered(${bare}, p, dFdx(p), dFdy(p), vec2(0.0), ${values.boards ? "board.to_edge" : "vec2(1000.0)"}, coat, ${salt})`;
            return `GaborMaterial material(vec2 p) // colour (linear), height, slope, roughness, metalness
{
${own && `    ${type} ${name} = gabor_${name}_default();\n${own}`}${values.boards ? `    GaborBoards boards = gabor_boards_default();
${members("boards", "boards")}    GaborBoard board = gabor_board(p, dFdx(p), dFdy(p), vec2(0.0), boards, ${v.seed});
` : ""}${values.coat ? `    GaborCoat coat = gabor_coat_default();
${members("coat", "coat")}` : ""}${values.finish ? `    GaborFinish finish = gabor_finish_default();
${members("finish", "finish")}    return gabor_finished_filtered(${laid}, p, dFdx(p), dFdy(p), vec2(0.0), finish, ${v.seed});` : `    return ${laid};`}
}
`;
        },
        about: "Colours are linear; heights are in the units of <code>p</code>. Each material is filtered for its pixel, so it never shimmers, and far away its roughness includes the slopes that the filter removed.",
    },
    noise: {
        label: "Noise",
        needs: ["gabor_noise"],
        languages: values => values.taps === "3" ? [...LANGUAGES, "TSL"] : ["GLSL", "Shadertoy", "HLSL"], // others have no macros
        scale: 64,
        controls: [
            choice("look", "Look", "relief", ["plain", "relief", "colours", "evolving"]),
            FREQUENCY, DIRECTION, SEED,
            choice("taps", "Taps", "3", ["3", "2", "4"])],
        code: (v, values) => `vec3 pattern(vec2 p)
{
${{ plain: `    float n = gabor_noise(p, ${v.frequency}, ${v.orientation}, ${v.seed});
    return vec3(gabor_unorm(n));`,
    relief: `    vec3 n = gabor_noise_gradient(p, ${v.frequency}, ${v.orientation}, ${v.seed});
    vec3 normal = normalize(vec3(-0.05 * n.yz, 1.0));
    return vec3(0.9, 0.8, 0.7) * max(dot(normal, normalize(vec3(-1.0, -1.0, 1.0))), 0.0);`,
    colours: `    return vec3(gabor_unorm(gabor_noise(p, ${v.frequency}, ${v.orientation}, ${v.seed})),
                gabor_unorm(gabor_noise(p, ${v.frequency}, ${v.orientation}, gabor_derived_seed(${v.seed}, 1))),
                gabor_unorm(gabor_noise(p, ${v.frequency}, ${v.orientation}, gabor_derived_seed(${v.seed}, 2))));`,
    evolving: `    float n = gabor_noise_animated(p, ${v.evolution}, ${v.frequency}, ${v.orientation}, ${v.seed});
    return vec3(gabor_unorm(n));` }[values.look]}
}
`,
        about: "Mean 0 and variance 1 at every place and every frequency. The wavelength is 1 / frequency kernel radii.",
        animated: values => values.look === "evolving",
        shortest: values => values.frequency,
    },
    fractal: {
        label: "Clouds, fBm",
        needs: ["gabor_noise", "gabor_fractal"],
        scale: 160,
        controls: [
            choice("look", "Look", "clouds", Object.keys(FRACTALS)),
            range("octaves", "Octaves", 1, 10, 0.1, 7),
            range("gain", "Gain", 0.3, 0.9, 0.01, 0.55),
            range("cover", "Cover", 0, 1, 0.01, 0.45),
            range("strength", "Warp", 0, 1, 0.01, 0.35),
            range("sun", "Light from", 0, 360, 1, 135, "°"),
            SEED],
        shown: (name, values) => ({ cover: ["clouds"], strength: ["marble", "ridges"], sun: ["ridges", "billows"] })[name]?.includes(values.look) ?? true,
        code: (v, values) => `vec3 pattern(vec2 p)
{
    GaborFractal fractal = gabor_fractal(${v.octaves}, ${v.gain});
${FRACTALS[values.look](v)}}
`,
        about: "fBm whose mean is 0 and variance 1 for any octaves and gain, so <em>Cover</em> is the share of sky under clouds. Octaves fade in, and out where a pixel cannot show them.",
        animated: values => values.look === "clouds",
        shortest: values => 0.5 * 2 ** (values.octaves - 1),
    },
    spectra: {
        label: "Spectra",
        needs: ["gabor_noise", "gabor_spectrum"],
        scale: 64,
        lobes: 4,
        controls: [
            choice("kind", "Spectrum", "lobes", ["lobes", "spread"]),
            range("frequency", "Frequency", 0, 8, 0.1, 2),
            DIRECTION,
            range("spread", "Spread", 0, 90, 1, 90, "°"),
            range("count", "Lobes", 1, 4, 1, 3),
            ...[0, 1, 2, 3].flatMap(i => [
                range(`f${i}`, `Lobe ${i + 1}: frequency`, 0, 8, 0.05, [4, 1.5, 3, 6][i]),
                range(`o${i}`, "direction", 0, 180, 1, [20, 75, 120, 160][i], "°"),
                range(`w${i}`, "power", 0, 2, 0.05, [1, 1, 0.6, 0.4][i])]),
            SEED],
        shown: (name, values) => {
            const lobe = /^[fow](\d)$/.exec(name);
            if (lobe)
                return values.kind === "lobes" && lobe[1] < values.count;
            return values.kind === "lobes" ? name !== "frequency" && name !== "orientation" && name !== "spread" : name !== "count";
        },
        code: (v, values) => values.kind === "spread" ? `vec3 pattern(vec2 p)
{
    float n = gabor_noise_spread(p, ${v.frequency}, ${v.orientation}, 0.1, ${v.spread}, ${v.seed});
    return vec3(gabor_unorm(n));
}
` : `vec3 pattern(vec2 p)
{
    GaborLobes lobes;
${[...Array(+values.count).keys()].map(i => `    lobes.lobe[${i}] = gabor_lobe(${v["f" + i]}, ${v["o" + i]}, 1.0, ${v["w" + i]});\n`).join("")}\
    lobes.count = ${values.count};
    float n = gabor_field_lobes(gabor_place_at(p), lobes, ${v.seed}).noise;
    return vec3(gabor_unorm(n));
}
`,
        about: "A sum of lobes has any power spectrum. Drag the dots: distance is frequency, angle is direction.",
        shortest: values => values.kind === "spread" ? values.frequency
            : Math.max(...[...Array(+values.count).keys()].map(i => values["f" + i])),
    },
    photographs: {
        label: "Photographs",
        needs: ["gabor_noise", "photograph"],
        scale: 1,
        controls: [],
        code: () => `vec3 pattern(vec2 p) // in pixels of the photograph
{
    return photograph(p);
}
`,
        about: `<p>The command-line program turns a photograph of a texture into a function like this one, without
            tiles or seams:</p><p><code>gabor fit PHOTO.jpg -o photo.json --glsl photo.glsl</code></p><p>It suits textures
            without edges or objects: sand, grass, concrete, cloth, brushed metal.</p>`,
    },
};

// ---- State, kept in the address ------------------------------------------------------------------------------------

const FIRST = "erosion";
const START = { x: 0, y: 0, zoom: 1, yaw: 0.6, pitch: 0.42, distance: 1 };
const LEAST_PITCH = 0.05;
const state = { tab: FIRST, language: "GLSL", values: {} };
for (const [name, tab] of Object.entries(TABS))
    state.values[name] = Object.fromEntries(tab.controls.map(control => [control.name, (tab.usual ?? ownValue)(control, tab.first)]));
const tab = () => TABS[state.tab];
const values = () => state.values[state.tab];
const start = () => ({ ...START, ...tab().start?.(values()) });
const usual = control => (tab().usual ?? ownValue)(control, values());
const shownControls = () => tab().controls.filter(control => tab().shown?.(control.name, values()) ?? true);
const languages = () => tab().languages?.(values()) ?? LANGUAGES;
const language = () => languages().includes(state.language) ? state.language : "GLSL";
function usePreset() {
    for (const control of tab().controls.filter(each => each.name !== "preset" && !tab().keeps?.includes(each.name)))
        values()[control.name] = usual(control);
    Object.assign(state, start());
}

function readAddress() {
    const given = new URLSearchParams(location.hash.slice(1));
    panel.hidden = given.has("bare"); // for the pictures of tools/gallery
    if (Object.hasOwn(TABS, given.get("tab")))
        state.tab = given.get("tab");
    for (const control of tab().controls) {
        const text = given.get(control.name);
        values()[control.name] = usual(control);
        if (text === null)
            continue;
        if (control.options) {
            if (control.options.includes(text))
                values()[control.name] = text;
        } else if (control.colour) {
            if (/^#[\da-f]{6}$/.test(text))
                values()[control.name] = text;
        } else if (control.check) {
            values()[control.name] = text === "true";
        } else if (Number.isFinite(+text)) {
            values()[control.name] = Math.min(Math.max(+text, control.min), control.max);
        }
    }
    Object.assign(state, start());
    for (const name of Object.keys(START))
        if (given.has(name) && Number.isFinite(+given.get(name)))
            state[name] = +given.get(name);
    state.zoom = Math.min(Math.max(state.zoom, 0.02), 50);
    state.distance = Math.min(Math.max(state.distance, 0.3), 3);
    state.pitch = Math.min(Math.max(state.pitch, LEAST_PITCH), 1.5);
}

let writing = 0;
function writeAddress() {
    clearTimeout(writing);
    writing = setTimeout(() => {
        const given = new URLSearchParams({ tab: state.tab });
        for (const control of shownControls())
            if (values()[control.name] !== usual(control))
                given.set(control.name, values()[control.name]);
        if (panel.hidden)
            given.set("bare", "");
        const short = number => `${+number.toPrecision(7)}`;
        for (const [name, usual] of Object.entries(start()))
            if (state[name] !== usual)
                given.set(name, short(state[name]));
        history.replaceState(null, "", "#" + given);
    }, 250);
}

// ---- Code to draw and to copy --------------------------------------------------------------------------------------

const NAMES = new Proxy({}, { get: (_, name) => name.replace(/[.-]/g, "_") });
const angle = control => control.unit === "°";
// What the view gives to shaders: the camera, and the side of the picture, in kernel radii.
function viewValues() {
    const { x, y, yaw, pitch } = state, { preset, strength, gully_frequency, octaves, gain } = values();
    if (!tab().land)
        return { x, y, yaw, pitch, high: view.clientHeight * unitsPerPixel() };
    const { scale } = DATA.landscape[preset]; // of a picture of 960 x 540 pixels, whose middle the camera sees from 0.8 of its width
    const octave = [...Array(octaves).keys()].map(i => strength / gully_frequency * gain ** i);
    return { x: x + 480 / scale, y: y + 270 / scale, yaw, pitch, away: 0.8 * 960 / scale * state.distance,
             reach: octave.reduce((sum, depth) => sum + depth, 0) };
}
function numbers() {
    const v = { evolution: "0.1 * iTime" };
    for (const [name, value] of Object.entries(viewValues()))
        v[name] = literal(value);
    for (const control of shownControls()) {
        const value = values()[control.name];
        v[control.name] = control.name === "seed" ? `${value}u` : control.whole ? `${value}`
            : control.colour ? `vec3(${linear(value).map(literal).join(", ")})`
            : angle(control) ? literal(radians(value)) : typeof value === "number" ? literal(value) : value;
    }
    if (values().moving)
        v.seconds = "iTime";
    return v;
}

const macros = () => values().taps && values().taps !== "3" ? `#define GABOR_TAPS ${values().taps}\n`
    : values().field === "painted" ? "#define GABOR_DIRECTION(p) vec2(0.0) // only gabor_field_waves is called\n" : tab().macros ?? "";
const needed = () => [...tab().needs, ...values().field === "painted" ? ["gabor_direction"] : [],
                      ...values().boards || values().coat || values().finish ? ["gabor_compose"] : []];
const shaders = ending => needed().map(name => TEXTS[name + ending]).join("\n") + "\n";

// The colour for a screen of a pixel of a picture. `pixel` counts from the upper left corner.
const PICTURE = {
    pattern: v => `    vec2 p = vec2(${v.x}, ${v.y}) + ${v.high} / extent.y * (pixel - 0.5 * extent); // in kernel radii
    return pattern(p);
`,
    sea: () => `    return sea_in_pixel(pixel - 0.5 * extent, 1.25 / max(extent.x, extent.y));
`,
    land: () => `    return land_in_pixel(pixel - vec2(0.5, 0.65) * extent, 1.25 / max(extent.x, extent.y));
`,
    material: (v, { shape }) => `    vec3 lamp = vec3(cos(${v.elevation}) * cos(${v.light}), -cos(${v.elevation}) * sin(${v.light}), sin(${v.elevation}));
${shape === "ball" ? `    vec2 place = 2.0 * pixel - extent;
    float side = min(extent.x, extent.y);
    Spot spot = spot_on_ball(place / side, 2.0 / side, ${v.size}, ${v.x});`
    : `    Spot spot = flat_spot(vec2(${v.x}, ${v.y}) + ${v.high} / extent.y * (pixel - 0.5 * extent));`}
    return colour_of_spot(spot, material(spot.p), lamp);
`,
};
const kind = () => tab().land ? "land" : tab().lit ? "material" : tab().sea ? "sea" : "pattern";
const pictureText = v => `${tab().code(v, values())}
vec3 picture(vec2 pixel, vec2 extent)
{
${PICTURE[kind()](v, values())}}
`;
const unitsPerPixel = () => (tab().lit ? values().size : 1) / (tab().scale * state.zoom); // a pixel of the page, not of the screen

const STRUCTS = "(?:Gabor\\w+|Sea|Spot|Ground)";
const WGSL_TYPES = { float: "f32", vec2: "vec2f", vec3: "vec3f" };
// Translates a function: types, declarations, constructors and a few names differ.
const wgsl = code => code
    .replace(/^(\w+) (\w+)\(([^()]*)\)(?=.*\n\{)/gm, (_, type, name, given) =>
        `fn ${name}(${given.replace(/(\w+) (\w+)/g, (_, type, name) => `${name}: ${WGSL_TYPES[type]}`)}) -> ${WGSL_TYPES[type] ?? type}`)
    .replace(RegExp(`^( +)(${STRUCTS}) (\\w+);`, "gm"), "$1var $3: $2;").replace(RegExp(`^( +)${STRUCTS} (\\w+) =`, "gm"), "$1var $2 =")
    .replace(/\bint\(/g, "i32(").replace(/\bivec2\(/g, "vec2i(")
    .replace(/^( +)(?:float|vec[23]) (\w+) =/gm, "$1let $2 =").replace(/\bvec([23])\(/g, "vec$1f(")
    .replace(/for \(int i = (.*); \+\+i\)/g, "for (var i = $1; i++)")
    .replace(/\batan\((?=[^()]*,)/g, "atan2(").replace(/\bdFd([xy])\(/g, "dpd$1(")
    .replace(/\btextureLod\(painted, /g, "textureSampleLevel(painted, painted_sampler, ");

// HLSL casts one number to a vector, and constructs structs by functions.
const hlsl = code => code
    .replace(/\bvec([23])\((?=((?:[^(),]|\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\))*)\))/g, "((float$1)(") // one argument
    .replace(/\(\(float([23])\)\(((?:[^()]|\((?:[^()]|\((?:[^()]|\([^()]*\))*\))*\))*)\)/g, "((float$1)($2))")
    .replace(/\b(i?)vec([23])\b/g, (_, whole, size) => `${whole ? "int" : "float"}${size}`).replace(/\bint2\(0\)/g, "(int2)(0)")
    .replace(/\bmix\(/g, "lerp(").replace(/\bfract\(/g, "frac(").replace(/\bdFd([xy])\(/g, "dd$1(")
    .replace(/\batan\((?=[^()]*,)/g, "atan2(").replace(/(= |return )(Ground|GaborTerrainPlace)\(/g, "$1$2_of(")
    .replace(/\btextureLod\(painted, /g, "painted.SampleLevel(painted_sampler, ");

// Translates an expression to calls of node operations, because JavaScript has no operators for nodes.
function nodes(expression) {
    const tokens = expression.match(/\d[\d.]*u?|\.?\w+|[-+*/(),]/g);
    const isNumber = text => /^-?[\d.]+$/.test(text);
    function operand() {
        const token = tokens.shift();
        let made = token;
        if (token === "-") {
            const negated = operand();
            return isNumber(negated) ? `-${negated}` : `${negated}.negate()`;
        }
        if (token === "(") {
            made = sum();
            tokens.shift();
        } else if (token.endsWith("u")) {
            made = /^\d/.test(token) ? `uint(${token.slice(0, -1)})` : token;
        }
        if (/^\w/.test(token) && tokens[0] === "(") {
            const given = [];
            while (tokens.shift() !== ")")
                given.push(sum());
            made = `${token}(${given.join(", ")})`;
        }
        while (tokens[0]?.startsWith("."))
            made += tokens.shift();
        return made;
    }
    const binary = (next, names) => () => {
        let made = next();
        while (names[tokens[0]]) {
            const left = isNumber(made) ? `float(${made})` : made;
            made = `${left}.${names[tokens.shift()]}(${next()})`;
        }
        return made;
    };
    const product = binary(operand, { "*": "mul", "/": "div" }), sum = binary(product, { "+": "add", "-": "sub" });
    return sum();
}
const tsl = code => code.replace(/\biTime\b/g, "time")
    .replace(/(?: +\w+ (\w+) =| +return) ([^;]+);[^\n]*/g, (_, name, value) => `    ${name ? `const ${name} =` : "return"} ${nodes(value)};`)
    .replace(/^vec3 (\w+)\(vec2 p\)\s*\{/gm, "export const $1 = Fn(([p]) => {").replace(/^\}/gm, "});");
function tslModule(text) {
    const module = TEXTS["gabor_noise.tsl.js"], names = text.match(/(?<![.\w])(?:\w+(?=\()|time\b)/g);
    const imported = /import \{([^}]*)\}/.exec(module)[1].match(/\w+/g);
    const more = [...new Set(names)].filter(name => !name.startsWith("gabor_") && !imported.includes(name));
    return `${more.length ? `import { ${more.join(", ")} } from "three/tsl";\n` : ""}${module}
// material.colorNode = pattern(uv().mul(8));
${text}`;
}

const TRANSLATED = { WGSL: wgsl, HLSL: hlsl, TSL: tsl };
const inLanguage = code => TRANSLATED[language()]?.(code) ?? code;
const functionText = () => inLanguage(tab().code(numbers(), values()));

// What each language has around the functions: what it reads, and its main function.
const painting = { GLSL: "uniform sampler2D painted;\n",
                   HLSL: "Texture2D painted : register(t0);\nSamplerState painted_sampler : register(s0);\n",
                   WGSL: "@group(0) @binding(2) var painted: texture_2d<f32>;\n@group(0) @binding(3) var painted_sampler: sampler;\n" };
const AROUND = {
    GLSL: timed => [`uniform vec2 resolution; // of the picture, in pixels\n${timed ? "uniform float iTime; // seconds\n" : ""}`, `out vec4 colour;
void main()
{
    colour = vec4(picture(vec2(gl_FragCoord.x, resolution.y - gl_FragCoord.y), resolution), 1.0);
}
`],
    Shadertoy: () => ["", `void mainImage(out vec4 color, vec2 pixel)
{
    color = vec4(picture(vec2(pixel.x, iResolution.y - pixel.y), iResolution.xy), 1.0);
}
`],
    HLSL: timed => [`float2 resolution; // of the picture, in pixels\n${timed ? "float iTime; // seconds\n" : ""}`, `float4 main(float4 position : SV_Position) : SV_Target
{
    return float4(picture(position.xy, resolution), 1.0);
}
`],
    WGSL: timed => [`@group(0) @binding(0) var<uniform> resolution: vec2f; // of the picture, in pixels
${timed ? "@group(0) @binding(1) var<uniform> iTime: f32; // seconds\n" : ""}`, `@fragment fn main(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return vec4f(picture(position.xy, resolution), 1.0);
}
`],
};
const ENDINGS = { GLSL: ".glsl", Shadertoy: ".glsl", HLSL: ".hlsl", WGSL: ".wgsl" };
function copied() {
    const name = language(), v = numbers();
    if (name === "TSL")
        return tslModule(tsl(tab().code(v, values())));
    const code = pictureText(v), map = code.includes("painted_wave");
    const [before, after] = AROUND[name](code.includes("iTime"));
    const about = `// ${PAINTED}, which the page saves: not sRGB, linear filter, clamped, first row at y = ${-PAINTED_WIDTH / 2}\n`;
    return `${name === "WGSL" ? "" : name === "HLSL" ? hlsl(macros()) : macros()}${shaders(ENDINGS[name])}${before}${map ? about + painting[name] : ""}
${inLanguage(code)}
${after}`;
}

// ---- WebGL ---------------------------------------------------------------------------------------------------------

let gl = null, parallel = null, floats = false; // floats: whether maps may have 32 bits
const VERTEX = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;

const numeric = () => shownControls().filter(control => !control.options && !control.check);
const typeOf = control => control.name === "seed" ? "uint" : control.whole ? "int" : control.colour ? "vec3" : "float";

const programs = new Map(), refused = new Set(); // refused: those at whose first pixel the driver lost all
let trying = "";
const shaderText = (parts, main) => `#version 300 es
precision highp float;
precision highp int;
uniform float evolution, ${Object.keys(viewValues()).join(", ")};
uniform vec2 screen;
uniform sampler2D painted;
${numeric().map(control => `uniform ${typeOf(control)} ${NAMES[control.name]};\n`).join("")}${macros()}${parts.join("\n")}
${main}`;
function programOf(whole, vertex, captured) {
    if (refused.has(whole))
        throw new Error("The graphics driver fails to compile this shader.");
    if (!programs.has(whole))
        programs.set(whole, { ...compiled(whole, vertex, captured), whole });
    return programs.get(whole);
}
// A drop-in without Perlin noise, which the page does not show and some drivers compile for long.
const dropIn = name => TEXTS[name + ".glsl"].replace(/(\w+\.)?basis ([=!])= GABOR_PERLIN/g, (_, of, sign) => `${sign === "!"}`);
const program = () => programOf(shaderText(needed().map(name => name === "ranges" ? MAPPED : dropIn(name)), `out vec4 result;
${pictureText(NAMES)}
void main() { result = vec4(picture(vec2(gl_FragCoord.x, screen.y - gl_FragCoord.y), screen), 1.0); }`));

function compiled(fragment, vertex = VERTEX, captured = []) {
    const made = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, source);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
    }
    if (captured.length)
        gl.transformFeedbackVaryings(made, captured, gl.INTERLEAVED_ATTRIBS);
    gl.linkProgram(made);
    const places = new Map();
    return { made, tries: 0, cost: 0, at: name => { // cost: milliseconds for a pixel, or 0 if it has drawn nothing yet
        if (!places.has(name))
            places.set(name, gl.getUniformLocation(made, name));
        return places.get(name);
    } };
}

// Browsers that cannot tell have it at the third try, when the page has shown that it compiles.
const ready = used => parallel ? gl.getProgramParameter(used.made, parallel.COMPLETION_STATUS_KHR) : used.tries++ > 1;
function checkLink(used) {
    if (!gl.getProgramParameter(used.made, gl.LINK_STATUS) && !gl.isContextLost())
        throw new Error(gl.getAttachedShaders(used.made).map(shader => gl.getShaderInfoLog(shader)).join("\n"));
}

function set(used, name, value) {
    const place = used.at(name);
    if (!place)
        return;
    if (name === "seed")
        gl.uniform1ui(place, value);
    else if (tab().controls.find(control => control.name === name)?.whole)
        gl.uniform1i(place, value);
    else if (Array.isArray(value))
        gl[`uniform${value.length}fv`](place, value);
    else
        gl.uniform1f(place, value);
}

function setControls(used) {
    for (const control of numeric()) {
        const value = values()[control.name];
        set(used, NAMES[control.name], control.colour ? linear(value) : angle(control) ? radians(value) : value);
    }
}

// ---- The land's map ------------------------------------------------------------------------------------------------
// Shaders that evaluate the ground wherever a ray needs it take minutes to compile on some drivers. The page draws a map of a square of
// land, whose last MAP_SEAM units fade to the land before the square, so that it repeats, and the view reads the map.

const MAP_WIDTH = 20, MAP_SEAM = 4;
// What replaces ranges.glsl where the land is in the map.
const MAPPED = `uniform sampler2D ground_map, hills_map;
uniform float texel; // its width
uniform vec2 corner;
GaborTerrain hills_at(Ground ground, vec2 p, float pixel) {
    float height = textureLod(hills_map, (p - corner) / ${literal(MAP_WIDTH)}, 0.0).x;
    return GaborTerrain(height, vec2(0.0), 0.0, vec3(0.0), vec2(0.0));
}
GaborTerrain ground_on(Ground ground, vec2 p, float pixel, GaborTerrain hills) {
    vec4 here = textureLod(ground_map, (p - corner) / ${literal(MAP_WIDTH)}, log2(max(pixel / texel, 1.0)));
    return GaborTerrain(here.x, here.yz, here.w, vec3(0.0), vec2(0.0));
}
`;
const mapProgram = () => programOf(shaderText(needed().filter(name => name !== "landscape").map(dropIn), `uniform float texel;
uniform vec2 corner;
layout(location = 0) out vec4 ground_here;
layout(location = 1) out float hills_here;
${landCode(NAMES, values())}
void main()
{
    vec2 q = texel * gl_FragCoord.xy, part = clamp((q - ${literal(MAP_WIDTH - MAP_SEAM)}) / ${literal(MAP_SEAM)}, 0.0, 1.0);
    vec2 kept = 1.0 - part * part * (3.0 - 2.0 * part), rise = -6.0 / ${literal(MAP_SEAM)} * part * (1.0 - part);
    ground_here = vec4(0.0);
    hills_here = 0.0;
    for (int i = 0; i < 4; ++i) {
        bvec2 before = bvec2(i & 1, i >> 1);
        vec2 share = mix(kept, 1.0 - kept, before), steep = mix(rise, -rise, before), p = corner + q - ${literal(MAP_WIDTH)} * vec2(before);
        if (share.x * share.y <= 0.0) continue;
        GaborTerrain hills = hills_at(land(), p, texel), here = ground_on(land(), p, texel, hills);
        ground_here += share.x * share.y * vec4(here.height, here.slope, here.ridge);
        ground_here.yz += here.height * steep * share.yx;
        hills_here += share.x * share.y * hills.height;
    }
}`));

let map = null; // { key, side, textures, frame }
const mapKey = () => JSON.stringify([values().cover, values().seed, corner(), DATA.erosion.map(({ name }) => values()[name])]);
function corner() { // the preset's view is in the middle of what does not fade
    const { scale } = DATA.landscape[values().preset];
    return [480 / scale, 270 / scale].map(middle => middle - (MAP_WIDTH - MAP_SEAM) / 2);
}
const mapSide = level => 2 ** Math.ceil(Math.log2(Math.min(Math.max(2 * Math.min(view.clientWidth, view.clientHeight), 256), 2048))) / level;
function newMap(side) {
    const made = { key: mapKey(), side, frame: gl.createFramebuffer() };
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.frame);
    made.textures = (floats ? [gl.RGBA32F, gl.R32F] : [gl.RGBA16F, gl.R16F]).map((format, i) => {
        const texture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texStorage2D(gl.TEXTURE_2D, i === 0 ? 1 + Math.log2(side) : 1, format, side, side);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, i === 0 ? gl.LINEAR_MIPMAP_LINEAR : gl.LINEAR);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0);
        return texture;
    });
    gl.drawBuffers([gl.COLOR_ATTACHMENT0, gl.COLOR_ATTACHMENT1]);
    return made;
}
function removeMap(made) {
    gl.deleteFramebuffer(made?.frame);
    made?.textures.forEach(texture => gl.deleteTexture(texture));
}
function drawMapRows(used, made, from, rows) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, made.frame);
    gl.useProgram(used.made);
    setControls(used);
    for (const [name, value] of Object.entries({ ...viewValues(), corner: corner(), texel: MAP_WIDTH / made.side }))
        set(used, name, value);
    gl.viewport(0, 0, made.side, made.side);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, from, made.side, rows);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.SCISSOR_TEST);
}
const mapped = level => map?.key === mapKey() && map.side >= mapSide(level);
function keepMap(made) {
    gl.bindTexture(gl.TEXTURE_2D, made.textures[0]);
    gl.generateMipmap(gl.TEXTURE_2D);
    removeMap(map);
    map = made;
}
async function drawMap(used, level, first) {
    if (mapped(level))
        return true;
    const made = newMap(mapSide(level));
    const done = await inBands(used, made.side, made.side, (from, rows) => drawMapRows(used, made, from, rows), first);
    if (done)
        keepMap(made);
    else
        removeMap(made);
    return done;
}
function useMap(used) {
    for (const [i, name] of ["ground_map", "hills_map"].entries()) {
        gl.activeTexture(gl.TEXTURE1 + i);
        gl.bindTexture(gl.TEXTURE_2D, map?.textures[i] ?? null);
        gl.uniform1i(used.at(name), 1 + i);
    }
    gl.activeTexture(gl.TEXTURE0);
    set(used, "corner", corner());
    set(used, "texel", MAP_WIDTH / (map?.side ?? 1));
}

// ---- The sea's state -----------------------------------------------------------------------------------------------
// gabor_ocean_of costs more than the rest of a pixel, so a vertex shader calls it when the sea changes, and writes a uniform block that
// the view reads. The first vertex writes what is before the bands, after unused words, and each other vertex writes a band.

const BAND_WORDS = ["words_0", "words_1", "words_2", "words_3", "words_4", "words_5", "words_6"]; // four each
const OCEAN_READ = `layout(std140) uniform State { ivec4 unused[4]; GaborOcean state; };
GaborOcean ocean() { return state; }
`;
function oceanProgram() {
    const bits = value => `floatBitsToInt(${value})`;
    const vertex = shaderText(["gabor_noise", "gabor_ocean"].map(dropIn), `flat out ivec4 ${BAND_WORDS.join(", ")};
${oceanCode(NAMES)}
void main()
{
    GaborOcean all = ocean();
    GaborOceanBand band = all.band[max(gl_VertexID - 1, 0)];
    words_0 = ivec4(${bits("band.amplitude")}, band.exponent, ${bits("vec2(band.low, band.orbit)")});
    words_1 = ${bits("vec4(band.slopes, band.widen)")};
    words_2 = ${bits("vec4(band.spread, band.blunt, band.rise)")};
    words_3 = ${bits("band.knots")};
    words_4 = ${bits("band.faster")};
    words_5 = ${bits("vec4(band.last, band.carry)")};
    words_6 = ivec4(${bits("band.number")}, band.drift);
    if (gl_VertexID == 0) {
        words_4 = ${bits("vec4(all.wind, all.direction, all.fetch, all.water_depth)")};
        words_5 = ivec4(${bits("all.swell")}, all.loop_seconds);
        words_6 = ${bits("vec4(all.tail, all.high)")};
    }
    gl_Position = vec4(0.0);
}`);
    return programOf("#version 300 es\nvoid main() {}", vertex, BAND_WORDS);
}

let ocean = null; // { key, buffer }
function fillOcean(used) {
    const key = JSON.stringify(OCEAN_MEMBERS.map(name => values()[name])), vertices = 1 + OCEAN_BANDS + 2;
    if (ocean?.key === key)
        return;
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, null);
    ocean ??= { buffer: gl.createBuffer() };
    ocean.key = key;
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, ocean.buffer);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 16 * BAND_WORDS.length * vertices, gl.DYNAMIC_COPY);
    gl.useProgram(used.made);
    setControls(used);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, vertices);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, 0, ocean.buffer);
}

// ---- Painted directions --------------------------------------------------------------------------------------------
// The painted directions: a picture with the cosine and the sine of twice the waves' angle in red and green. Twice, because o and
// o + pi give the same stripes. It is PAINTED_WIDTH kernel radii wide, around the origin.
const PAINTED_SIDE = 128;
const paint = new ImageData(PAINTED_SIDE, PAINTED_SIDE);
const direction = i => [paint.data[4 * i] / 127.5 - 1, paint.data[4 * i + 1] / 127.5 - 1];
function setDirection(i, [x, y]) {
    const length = Math.max(Math.hypot(x, y), 1e-9);
    paint.data.set([127.5 + 127.5 * x / length, 127.5 + 127.5 * y / length, 128, 255], 4 * i);
}
for (let i = 0; i < PAINTED_SIDE ** 2; ++i) {
    const x = (i % PAINTED_SIDE) / PAINTED_SIDE - 0.5, y = Math.floor(i / PAINTED_SIDE) / PAINTED_SIDE - 0.5;
    const twice = 10 * x + 4 * Math.sin(7 * y);
    setDirection(i, [Math.cos(twice), Math.sin(twice)]);
}
let paintTexture = null;
function usePaint() {
    if (!paintTexture) {
        paintTexture = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, paintTexture);
        for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER])
            gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
        for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T])
            gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    }
    gl.bindTexture(gl.TEXTURE_2D, paintTexture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, gl.RGBA, gl.UNSIGNED_BYTE, paint);
}

// Paints a stroke from a to b, in kernel radii. Stripes run along it, so waves point across it.
function stroke(a, b) {
    const [x, y] = [b[0] - a[0], b[1] - a[1]], square = x * x + y * y;
    if (square === 0)
        return;
    const twice = [(y * y - x * x) / square, -2 * x * y / square], cell = PAINTED_WIDTH / PAINTED_SIDE, reach = 1.6;
    for (let i = 0; i < PAINTED_SIDE ** 2; ++i) {
        const at = [i % PAINTED_SIDE, Math.floor(i / PAINTED_SIDE)].map((part, k) => (part + 0.5) * cell - PAINTED_WIDTH / 2 - a[k]);
        const along = Math.min(Math.max((at[0] * x + at[1] * y) / square, 0), 1);
        const far = Math.hypot(at[0] - along * x, at[1] - along * y);
        const share = 0.5 * Math.exp(-2 * (far / reach) ** 2) * Math.min(1, 2 * Math.sqrt(square));
        if (share > 0.002)
            setDirection(i, direction(i).map((part, k) => (1 - share) * part + share * twice[k]));
    }
}

// Paints the directions of a picture's edges: its structure tensor, near and, where the picture is flat, far.
async function paintPicture(file) {
    const picture = await createImageBitmap(file), side = PAINTED_SIDE, part = Math.min(picture.width, picture.height);
    const context = Object.assign(document.createElement("canvas"), { width: side, height: side }).getContext("2d");
    context.fillRect(0, 0, side, side); // behind transparent pixels
    context.imageSmoothingQuality = "high";
    context.drawImage(picture, (picture.width - part) / 2, (picture.height - part) / 2, part, part, 0, 0, side, side);
    const { data } = context.getImageData(0, 0, side, side);
    const inside = i => Math.min(Math.max(i, 0), side - 1);
    const at = (x, y) => [0.3, 0.6, 0.1].reduce((sum, weight, k) => sum + weight * data[4 * (side * inside(y) + inside(x)) + k], 0);
    const tensor = [...Array(side * side).keys()].map(i => {
        const column = i % side, row = Math.floor(i / side);
        const x = at(column + 1, row) - at(column - 1, row), y = at(column, row + 1) - at(column, row - 1);
        return [x * x - y * y, 2 * x * y];
    });
    const near = smoothed(tensor, side, 3), far = smoothed(near, side, 20);
    near.forEach((each, i) => setDirection(i, each.map((value, k) => value + 0.05 * far[i][k])));
    showTab("stripes", { field: "painted" });
}
// Means of pairs of numbers over squares, twice.
function smoothed(pairs, side, reach) {
    for (const step of [1, side, 1, side])
        pairs = pairs.map((_, i) => {
            const place = step === 1 ? i % side : Math.floor(i / side), sum = [0, 0];
            for (let k = Math.max(-reach, -place); k <= Math.min(reach, side - 1 - place); ++k)
                pairs[i + k * step].forEach((value, part) => sum[part] += value);
            return sum.map(value => value / (2 * reach + 1));
        });
    return pairs;
}
const download = (href, name) => Object.assign(document.createElement("a"), { href, download: name }).click();
function downloadPaint() {
    const canvas = Object.assign(document.createElement("canvas"), { width: PAINTED_SIDE, height: PAINTED_SIDE });
    canvas.getContext("2d").putImageData(paint, 0, 0);
    download(canvas.toDataURL(), PAINTED);
}

// ---- Drawing: from coarse to fine, in bands of rows, so that nothing takes long ------------------------------------

const BAND = 50, FRAME = 40; // milliseconds that a band may take, and a picture that moves
const COARSEST = 8, COARSEST_SEA = 16; // whose pixels cost most
let asked = false, drawing = false, moving = false, settle = 0, lastFrame = 0, stage = null;
function ask() {
    asked = true;
    if (gl && !drawing)
        drawPictures();
}

function moved() { // draws coarsely while the view moves on slow machines, then sharply
    moving = true;
    clearTimeout(settle);
    settle = setTimeout(() => { moving = false; ask(); }, 180);
    writeAddress();
    ask();
}

function say(text) {
    $("#state").hidden = !text;
    if (text)
        $("#state").textContent = text;
}

const animated = () => tab().animated?.(values());
const after = milliseconds => new Promise(resolve => setTimeout(resolve, milliseconds));
async function drawPictures() {
    drawing = true;
    try {
        while (asked && !gl.isContextLost()) {
            const now = await new Promise(requestAnimationFrame);
            asked = false;
            await (panel.hidden ? drawWhole(now) : drawPicture(now));
            asked ||= animated();
        }
    } catch (error) {
        say("The browser's compiler refuses the shader.");
        $("pre").textContent = error.message;
    }
    drawing = false;
}

// Waits until the device has drawn.
async function finished() {
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    do
        await after(0);
    while (!gl.isContextLost() && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED);
    gl.deleteSync(fence);
}

function sizeOfPicture() {
    const scale = Math.min(devicePixelRatio, tab().land || tab().lit || tab().sea ? 1.5 : 2);
    return [view.clientWidth, view.clientHeight].map(side => Math.max(1, Math.round(side * scale)));
}
function resize([width, height]) {
    if (view.width === width && view.height === height)
        return;
    [view.width, view.height] = [width, height];
    gl.deleteTexture(stage?.texture);
    gl.deleteFramebuffer(stage?.frame);
    stage = { texture: gl.createTexture(), frame: gl.createFramebuffer() };
    gl.bindTexture(gl.TEXTURE_2D, stage.texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, Math.ceil(width / 2) + 1, Math.ceil(height / 2) + 1);
    gl.bindFramebuffer(gl.FRAMEBUFFER, stage.frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, stage.texture, 0);
}

// Draws rows of a picture of this size on the screen, or on the stage for coarser ones.
function drawRows(used, now, [width, height], from, rows) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, width < view.width ? stage.frame : null);
    gl.useProgram(used.made);
    setControls(used);
    if (values().field === "painted")
        usePaint();
    if (tab().land)
        useMap(used);
    for (const [name, value] of Object.entries({ ...viewValues(), screen: [width, height], evolution: now / 10000 }))
        set(used, name, value);
    const more = width < view.width ? 1 : 0; // pixels around the rows, for smooth edges
    gl.viewport(0, 0, width + more, height + more);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, from - more, width + more, rows + 2 * more);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.SCISSOR_TEST);
}
function showRows([width, height], from, rows) {
    const [low, high] = [from, from + rows].map(row => Math.round(row * view.height / height));
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, stage.frame);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, from, width, from + rows, 0, low, view.width, high, gl.COLOR_BUFFER_BIT, gl.LINEAR);
}

function tick(now) {
    if (values().moving) {
        values().seconds = (values().seconds + Math.min(now - lastFrame, 250) / 1000) % 600;
        showValues();
    }
    lastFrame = now;
}

function drawWhole(now) {
    const used = program();
    checkLink(used);
    tick(now);
    resize(sizeOfPicture());
    if (tab().land && !mapped(1)) {
        const made = newMap(mapSide(1)), filling = mapProgram();
        checkLink(filling);
        drawMapRows(filling, made, 0, made.side);
        keepMap(made);
    }
    if (tab().sea) {
        const computing = oceanProgram();
        checkLink(computing);
        fillOcean(computing);
    }
    drawRows(used, now, [view.width, view.height], 0, view.height);
}

// Waits until a program can draw, whose first pixel this draws: some drivers compile only then. Returns false if more is asked for before.
async function usable(used, drawPixel) {
    if (used.cost)
        return true;
    say("Compiling…");
    while (!ready(used)) {
        await after(20);
        if (asked)
            return false;
    }
    await finished(); // Chromium answers some calls, such as checkLink's, only after all that it drew before, and blocks the page
    checkLink(used);
    await finished();
    trying = used.whole;
    drawPixel();
    await finished();
    if (gl.isContextLost())
        return false;
    trying = "";
    used.cost = 0.02;
    return true;
}

// Draws a picture, and finer ones until another is asked for. One that moves gets no finer.
async function drawPicture(now) {
    const used = program(), filling = tab().land ? mapProgram() : null, computing = tab().sea ? oceanProgram() : null;
    if (filling && !await usable(filling, () => { const one = newMap(1); drawMapRows(filling, one, 0, 1); removeMap(one); })
        || computing && !await usable(computing, () => fillOcean(computing))
        || !await usable(used, () => { resize(sizeOfPicture()); drawRows(used, now, [1, 1], 0, 1); }))
        return;
    if (computing)
        fillOcean(computing);
    tick(now);
    resize(sizeOfPicture());
    const { width, height } = view, alone = moving || animated();
    let level = 1;
    while (level < (tab().sea ? COARSEST_SEA : COARSEST) && width * height * used.cost / level ** 2 > FRAME)
        level *= 2;
    for (let first = true; level >= 1 && (first || !alone && !asked); level /= 2, first = false) {
        const size = [Math.ceil(width / level), Math.ceil(height / level)];
        if (filling && !await drawMap(filling, level, first) || !await drawBands(used, now, size, first))
            return;
        performance.mark(level === 1 ? "sharp" : "picture");
        $("#still")?.remove();
        say(level > 1 && !alone ? "Refining…" : "");
    }
}

// Draws rows from the top, as many at a time as a band may take. Returns false if more is asked for before the end, unless it is the first.
async function inBands(used, width, height, draw, first) {
    for (let left = height, rows = height; left > 0; left -= rows) {
        rows = Math.min(left, 2 * rows, Math.max(1, Math.floor(BAND / (used.cost * width))));
        const started = performance.now();
        draw(left - rows, rows);
        await finished();
        if (gl.isContextLost() || asked && !first)
            return false;
        const cost = (performance.now() - started) / (width * rows);
        used.cost = Math.max(cost, 0.5 * (cost + used.cost)); // at once for rows that cost more, slowly for those that cost less
    }
    return true;
}

// Draws a picture of this size. The first one appears as a whole, and only finer ones may remain unfinished.
async function drawBands(used, now, size, first) {
    const [width, height] = size, coarse = width < view.width;
    const done = await inBands(used, width, height, (from, rows) => {
        drawRows(used, now, size, from, rows);
        if (coarse && !first)
            showRows(size, from, rows);
    }, first);
    if (done && coarse && first)
        showRows(size, 0, height);
    return done;
}

// ---- Controls ------------------------------------------------------------------------------------------------------

// The group of a list with this label, or the list itself.
function group(list, label) {
    if (!label)
        return list;
    const found = [...list.children].find(each => each.label === words(label));
    if (!found)
        list.append(Object.assign(document.createElement("optgroup"), { label: words(label) }));
    return found ?? list.lastChild;
}
function controlsOf() {
    const box = $("#controls");
    box.replaceChildren();
    for (const control of tab().controls) {
        const label = document.createElement("label");
        label.dataset.name = control.name;
        label.title = control.about ?? "";
        label.append(control.label);
        const input = document.createElement(control.options ? "select" : "input");
        input.name = control.name;
        label.append(input);
        if (control.options) {
            for (const option of control.options)
                group(input, control.group?.(option)).append(new Option(words(option), option));
        } else if (control.check || control.colour) {
            input.type = control.check ? "checkbox" : "color";
        } else {
            Object.assign(input, { type: "range", min: control.min, max: control.max, step: control.step });
            label.append(document.createElement("output"));
        }
        input.addEventListener("input", () => {
            values()[control.name] = control.check ? input.checked : input.type === "range" ? +input.value : input.value;
            if (control.name === "preset")
                usePreset();
            changed();
        });
        box.append(label);
    }
    $("#about").innerHTML = tab().about;
    $("figure").hidden = state.tab !== "photographs";
    plane.hidden = !tab().lobes;
    for (const button of document.querySelectorAll("[role=tab]")) {
        const chosen = button.value === state.tab;
        button.setAttribute("aria-selected", chosen);
        button.tabIndex = chosen ? 0 : -1;
        if (chosen) // in a row of tabs that is longer than the screen
            button.parentElement.scrollLeft = button.offsetLeft - (button.parentElement.clientWidth - button.offsetWidth) / 2;
    }
    changed();
}

function showValues() {
    const shown = shownControls();
    for (const label of document.querySelectorAll("#controls label")) {
        const control = tab().controls.find(each => each.name === label.dataset.name), value = values()[control.name];
        label.hidden = !shown.includes(control);
        label.querySelector("input, select")[control.check ? "checked" : "value"] = value;
        if (label.querySelector("output"))
            label.querySelector("output").textContent = control.unit === " m" && value >= 10000 ? +(value / 1000).toPrecision(3) + " km"
                : +value.toPrecision(3) + control.unit;
    }
}

function changed() {
    showValues();
    view.classList.toggle("painting", values().field === "painted");
    $("#map").hidden = state.tab !== "stripes";
    $("#download").hidden = values().field !== "painted";
    for (const option of $("#language").options)
        option.hidden = option.disabled = !languages().includes(option.value);
    $("#language").value = language();
    // A wave needs more than two pixels, and already looks wrong below three.
    const pixels = tab().shortest ? tab().scale * state.zoom * Math.min(devicePixelRatio, 2) / tab().shortest(values()) : Infinity;
    $("#warning").hidden = pixels >= 3;
    $("#warning").textContent = `Waves are ${pixels.toFixed(1)} pixels long and alias. Zoom in, lower the frequency, or use the _filtered functions.`;
    $("pre").textContent = functionText();
    if (tab().lobes)
        drawPlane();
    $("textarea").value = copied();
    moved();
}

function showTab(name, given) {
    state.tab = name;
    Object.assign(state, start());
    Object.assign(values(), given);
    controlsOf();
}

for (const [name, each] of Object.entries(TABS)) {
    const button = document.createElement("button");
    Object.assign(button, { type: "button", value: name, textContent: each.label });
    button.setAttribute("role", "tab");
    button.addEventListener("click", () => showTab(name));
    $("[role=tablist]").append(button);
}
$("[role=tablist]").addEventListener("keydown", event => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!step)
        return;
    const all = [...document.querySelectorAll("[role=tab]")];
    const next = all[(all.findIndex(button => button.value === state.tab) + step + all.length) % all.length];
    next.click();
    next.focus();
    event.preventDefault();
});

// The frequency plane, with a dot for each lobe and for its mirror image.
const planeScale = () => plane.clientWidth / 17; // pixels per cycle: 8 each way
function drawPlane() {
    const ratio = devicePixelRatio, context = plane.getContext("2d", { willReadFrequently: true }); // by the CPU: Chromium would wait for its GPU process
    [plane.width, plane.height] = [plane.clientWidth * ratio, plane.clientHeight * ratio];
    context.scale(ratio, ratio);
    const middle = [plane.clientWidth / 2, plane.clientHeight - 10], unit = planeScale();
    const style = getComputedStyle(panel);
    context.strokeStyle = style.getPropertyValue("--line");
    for (const radius of [2, 4, 6, 8]) {
        context.beginPath();
        context.arc(...middle, radius * unit, Math.PI, 2 * Math.PI);
        context.stroke();
    }
    context.fillStyle = style.getPropertyValue("--accent");
    for (const [x, y, power] of lobesInPlane()) {
        context.globalAlpha = 0.25 + 0.75 * Math.min(power, 1);
        context.beginPath();
        context.arc(middle[0] + x * unit, middle[1] - y * unit, 6, 0, 7);
        context.fill();
    }
    context.globalAlpha = 1;
}
function lobesInPlane() {
    const v = values();
    if (v.kind !== "lobes")
        return [...Array(13).keys()].map(i => radians(v.orientation + v.spread * (i - 6) / 6))
            .map(angle => [v.frequency * Math.cos(angle), Math.abs(v.frequency * Math.sin(angle)), 1]);
    return [...Array(+v.count).keys()].map(i => [v["f" + i] * Math.cos(radians(v["o" + i])), v["f" + i] * Math.sin(radians(v["o" + i])), v["w" + i]]);
}
let dragged = -1;
plane.addEventListener("pointerdown", event => {
    const at = inPlane(event);
    const distances = lobesInPlane().map(([x, y]) => Math.hypot(x - at[0], y - at[1]));
    dragged = values().kind === "lobes" ? distances.indexOf(Math.min(...distances)) : 0;
    plane.setPointerCapture(event.pointerId);
    dragLobe(at);
});
plane.addEventListener("pointermove", event => dragged >= 0 && dragLobe(inPlane(event)));
plane.addEventListener("pointerup", () => dragged = -1);
plane.addEventListener("pointercancel", () => dragged = -1);
function inPlane(event) {
    const box = plane.getBoundingClientRect();
    return [(event.clientX - box.left - box.width / 2) / planeScale(), Math.max((box.bottom - 10 - event.clientY) / planeScale(), 0)];
}
function dragLobe([x, y]) {
    const [f, o] = values().kind === "lobes" ? ["f" + dragged, "o" + dragged] : ["frequency", "orientation"];
    values()[f] = +Math.min(Math.hypot(x, y), 8).toFixed(2);
    values()[o] = Math.round(Math.atan2(y, x) * 180 / Math.PI);
    changed();
}

// ---- Navigation ----------------------------------------------------------------------------------------------------

const pointers = new Map();
const toPlane = (x, y) => [state.x + (x - view.clientWidth / 2) * unitsPerPixel(), state.y + (y - view.clientHeight / 2) * unitsPerPixel()];

function zoomBy(factor, x = view.clientWidth / 2, y = view.clientHeight / 2) {
    if (tab().land) {
        state.distance = Math.min(Math.max(state.distance / factor, 0.3), 3);
    } else if (tab().sea) {
        values().altitude = Math.min(Math.max(values().altitude / factor, 2), 200);
    } else {
        const before = toPlane(x, y);
        state.zoom = Math.min(Math.max(state.zoom * factor, 0.02), 50);
        const after = toPlane(x, y);
        state.x += before[0] - after[0];
        state.y += before[1] - after[1];
    }
    changed();
}

function moveBy(x, y, turning = true) {
    if (tab().sea) {
        state.yaw -= x * 0.002;
        state.pitch = Math.min(Math.max(state.pitch - y * 0.002, LEAST_PITCH), 1.5);
    } else if (tab().land && turning) {
        state.yaw += x * 0.005;
        state.pitch = Math.min(Math.max(state.pitch + y * 0.004, LEAST_PITCH), 1.5);
    } else if (tab().land) {
        const step = 1.25 * viewValues().away / Math.max(view.clientWidth, view.clientHeight);
        state.x -= step * (x * Math.sin(state.yaw) + y * Math.cos(state.yaw));
        state.y += step * (x * Math.cos(state.yaw) - y * Math.sin(state.yaw));
    } else if (tab().lit && values().shape === "ball") {
        state.x -= x * 0.006;
    } else {
        state.x -= x * unitsPerPixel();
        state.y -= y * unitsPerPixel();
    }
    moved();
}

view.addEventListener("pointerdown", event => {
    view.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, [event.clientX, event.clientY]);
});
view.addEventListener("pointermove", event => {
    const before = pointers.get(event.pointerId);
    if (!before)
        return;
    const now = [event.clientX, event.clientY];
    const others = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
    if (others.length > 0) {
        const apart = at => Math.hypot(at[0] - others[0][0], at[1] - others[0][1]);
        moveBy((now[0] - before[0]) / 2, (now[1] - before[1]) / 2, false);
        zoomBy(apart(now) / Math.max(apart(before), 1), (now[0] + others[0][0]) / 2, (now[1] + others[0][1]) / 2);
    } else if (values().field === "painted" && !event.shiftKey) {
        stroke(toPlane(...before), toPlane(...now));
        moved();
    } else {
        moveBy(now[0] - before[0], now[1] - before[1], !event.shiftKey);
    }
    pointers.set(event.pointerId, now);
});
for (const name of ["pointerup", "pointercancel"])
    view.addEventListener(name, event => pointers.delete(event.pointerId));
view.addEventListener("wheel", event => {
    event.preventDefault();
    zoomBy(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)), event.clientX, event.clientY);
}, { passive: false });
view.addEventListener("keydown", event => {
    const steps = { ArrowLeft: [40, 0], ArrowRight: [-40, 0], ArrowUp: [0, 40], ArrowDown: [0, -40] };
    if (steps[event.key])
        moveBy(...steps[event.key]);
    else if (event.key === "+" || event.key === "=")
        zoomBy(1.2);
    else if (event.key === "-")
        zoomBy(1 / 1.2);
    else
        return;
    event.preventDefault();
});

$("#fold").addEventListener("click", event => {
    const folded = panel.classList.toggle("folded");
    event.currentTarget.textContent = folded ? "+" : "–";
    event.currentTarget.setAttribute("aria-expanded", !folded);
    event.currentTarget.setAttribute("aria-label", folded ? "Show the controls" : "Hide the controls");
});
$("#language").addEventListener("change", event => {
    state.language = event.target.value;
    changed();
});
let savedPicture = "";
$("#save").addEventListener("click", async () => {
    if (!gl)
        return;
    await finished();
    view.toBlob(picture => {
        URL.revokeObjectURL(savedPicture);
        savedPicture = URL.createObjectURL(picture);
        download(savedPicture, `gabor-${state.tab}.png`);
    });
});
$("#download").addEventListener("click", downloadPaint);
$("#open").addEventListener("click", () => $("#picture").click());
$("#picture").addEventListener("change", event => openPicture(event.target.files[0]));
addEventListener("dragover", event => event.preventDefault());
addEventListener("drop", event => {
    event.preventDefault();
    openPicture(event.dataTransfer.files[0]);
});
async function openPicture(file) {
    try {
        await paintPicture(file);
    } catch {
        $("#warning").hidden = false;
        $("#warning").textContent = "This is not a picture that the browser can read.";
    }
}
$("#copy").addEventListener("click", async event => {
    const button = event.currentTarget, text = $("textarea");
    try {
        await navigator.clipboard.writeText(text.value);
    } catch { // the page may not write to the clipboard
        text.select();
        document.execCommand("copy");
    }
    button.textContent = "Copied";
    setTimeout(() => button.textContent = "Copy", 1500);
});
panel.addEventListener("submit", event => event.preventDefault());
new ResizeObserver(changed).observe(view);
addEventListener("hashchange", () => { readAddress(); controlsOf(); });
view.addEventListener("webglcontextlost", event => {
    event.preventDefault();
    if (trying)
        refused.add(trying);
    trying = "";
});
view.addEventListener("webglcontextrestored", () => {
    programs.clear();
    paintTexture = stage = map = ocean = null;
    view.width = 0;
    for (const name of ["EXT_color_buffer_float", "OES_texture_float_linear", "EXT_color_buffer_half_float"])
        gl.getExtension(name); // at once: the next frame may draw the land's map
    enableExtensions(gl);
});

readAddress();
controlsOf();
if (location.hash || panel.hidden)
    $("#still").remove(); // which shows the page as it opens without an address
// Returns when the page is on the screen: until then, getContext would wait for the browser's own first frames, and block the page.
async function onScreen() {
    await new Promise(resolve => {
        new PerformanceObserver(resolve).observe({ type: "paint", buffered: true });
        setTimeout(resolve, 1000);
    });
    for (let frame = 0; frame < 4; ++frame)
        await new Promise(requestAnimationFrame);
}
async function enableExtensions(context) {
    parallel = context.getExtension("KHR_parallel_shader_compile");
    await after(0);
    const drawn = context.getExtension("EXT_color_buffer_float");
    await after(0);
    floats = drawn && context.getExtension("OES_texture_float_linear");
    if (!floats)
        context.getExtension("EXT_color_buffer_half_float");
    gl = context;
    ask();
}
requestAnimationFrame(async () => {
    if (!panel.hidden)
        await onScreen();
    const context = view.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true, powerPreference: "high-performance" });
    if (context)
        enableExtensions(context);
    else
        $("#about").textContent = "This browser has no WebGL 2 and cannot draw. You can still copy the code.";
});

"""Checks the translations of the lattice's drop-ins and of a texture that gabor fit wrote: each call returns the same
value as the GLSL, which other tests compare with the reference."""

import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import metal
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "engines"), str(HERE.parent / "fit")]
from scene import ROOT, SHADERS, drop_in_path, in_cpp, on_vulkan, run_cpp  # noqa: E402
from textures import colour_noise, write_png  # noqa: E402

# gabor fit writes the last one
FILES = ["gabor_noise", "gabor_spectrum", "gabor_filter", "gabor_direction", "gabor_noise_3d", "gabor_filter_3d", "gabor_erosion",
         "gabor_fractal", "gabor_materials", "gabor_compose", "gabor_ocean", "sea"]
GODOT = pathlib.Path(os.environ.get("GODOT_ROOT", ROOT / "build" / "godot"))
DIRECT3D = pathlib.Path(os.environ.get("GABOR_DIRECT3D", ROOT / "build" / "direct3d"))
DAWN, SWIFTSHADER = HERE.parent / "engines" / "dawn", pathlib.Path("/usr/lib/chromium/vk_swiftshader_icd.json")
DXC = pathlib.Path(os.environ.get("GABOR_DXC", ROOT / "build" / "dxc" / "libdxcompiler.so"))

CALLS = {  # each call, and its column in the table of drop-ins in docs/engine-results.md
    "gabor_noise(p, 4.0, 0.7854, 7u)": "noise",
    "gabor_noise_gradient(p, 4.0, 0.7854, 7u).y": "gradient",
    "gabor_noise_quadrature(p, 4.0, 0.7854, 7u).y": "complex",
    "2.0 * gabor_stripes(p, 0.3 * p, 1.0, 7u).x + 2.0 * gabor_profile_triangle(0.8 * vec2(cos(p.x), sin(p.x)))": "stripes",
    "gabor_noise_tiled(p, vec2(5.0, 7.5), 4.0, 0.7854, 7u)": "tiled",
    "gabor_field(gabor_place_tiled(p, vec2(5.0, 7.5)), gabor_wave_vector(4.0, 0.7854), 7u).quadrature_gradient.x": "tiled",
    "gabor_noise_animated(p, 0.3, 4.0, 0.7854, 7u)": "animated",
    "gabor_noise_spread(p, 2.0, 0.5, 0.3, 0.7, 7u)": "spread",
    "gabor_noise_isotropic(p, 2.0, 7u)": "isotropic",
    "gabor_field_isotropic_filtered(gabor_place_at(p), vec2(0.1, 0.02), vec2(0.03, 0.12), 2.0, 7u).noise": "isotropic",
    "gabor_noise_filtered(p, vec2(0.1, 0.02), vec2(0.03, 0.12), 2.0, 0.5, 7u).x": "filtered",
    "2.0 * gabor_stripes_of(gabor_field_filtered(gabor_place_at(p), vec2(0.1, 0.02), vec2(0.03, 0.12), 0.3 * p, 7u), 1.0).y": "filtered",
    "gabor_field_lobes(gabor_place_at(p), six(), 7u).noise": "lobes",  # six are more than GABOR_LOBES' default, so the macro must work
    "gabor_field_direction(gabor_place_at(p), 7u).noise": "direction map",
    "gabor_noise_3d(q, 2.0, vec3(1.0, 2.0, 3.0), 7u)": "solid",
    "gabor_field_3d(gabor_place_3d_at(q), vec3(0.5, 1.1, 1.6), 7u).gradient.x": "solid",
    "gabor_field_3d_filtered(gabor_place_3d_at(q), vec3(0.1, 0.0, 0.02), vec3(0.0, 0.07, 0.02), vec3(0.5, 1.1, 1.6), 7u).noise": "solid",
    "gabor_noise_surface(q, vec3(0.6, 0.0, 0.8), 2.0, vec3(1.0, 2.0, 3.0), 7u)": "surface",
    "gabor_field_surface_isotropic(gabor_place_3d_at(q), vec3(0.6, 0.0, 0.8), 2.0, 7u).noise": "surface",
    "4.0 * gabor_zebra(p, 7u).colour.y": "materials",
    "60.0 * gabor_sand_filtered(p, vec2(0.1, 0.02), vec2(0.03, 0.12), 7u).height": "materials",
    "8.0 * gabor_wood_at(p, vec2(5.0, 7.5), gabor_wood_default(), 7u).colour.y": "materials",
    "4.0 * gabor_laid(gabor_zebra(p, 7u), gabor_board(p, vec2(0.1, 0.02), vec2(0.03, 0.12), vec2(5.0, 7.5), gabor_boards_default(), 7u), "
    "gabor_boards_default()).colour.y": "materials",
    "2.0 * gabor_terrain(p, 7u).slope.x": "erosion",
    "20.0 * gabor_eroded(p, gabor_terrain(p, 7u), gabor_erosion(), 7u).height": "erosion",
    "gabor_fbm(p, 4.3, 0.5, 7u)": "fractal",
    "gabor_ridged(p, 3.0, 0.5, 7u)": "fractal",
    "gabor_perlin_3d(q, 7u)": "fractal",
    "0.5 * gabor_fractal_noise(gabor_place_tiled(p, vec2(5.0, 7.5)), gabor_fractal(3.0, 0.5), 7u).gradient.x": "fractal",
    "gabor_fractal_noise_filtered(gabor_place(ivec2(1000000000, -1000000000), p), vec2(0.1, 0.02), vec2(0.03, 0.12), "
    "gabor_fractal(4.0, 0.6), 7u).noise": "fractal",
    "4.0 * gabor_warp_3d_filtered(gabor_place_3d_at(q), vec3(0.1, 0.0, 0.02), vec3(0.0, 0.07, 0.02), 0.6, gabor_fractal(3.0, 0.5), 7u).dx.y": "fractal",
    "3.0 * gabor_water(4.0 * p, 100.3, gabor_ocean(8.0), 7u).height": "sea",
    "8.0 * gabor_water_filtered(4.0 * p, vec2(0.2, 0.1), vec2(0.0, 0.3), 100.3, gabor_ocean(8.0), 7u).jacobian": "sea",
    "600.0 * gabor_water_filtered(4.0 * p, 0.1 * p, vec2(0.0, 0.3), 100.3, gabor_ocean(8.0), 7u).lost.x": "sea",
    "3.0 * gabor_water(16.0 * p, 10.3, gabor_ocean_of(GaborSea(13.0, 90000.0, 2.5, 11.0, 2.1, 0.0, 0.6, 64)), 7u).shift.y": "sea",
    "10.0 * gabor_water_at(ivec2(1000000000, -1000000000), 4.0 * p, 1000000000, 0.3, vec2(0.0, 0.0), vec2(0.0, 0.0), gabor_ocean(8.0), 7u).slope.x": "sea",
    "20.0 * (sea(32.0 * p).y + sea_filtered(32.0 * p, vec2(3.0, 0.5), vec2(0.5, 4.0)).x) - 19.0": "fitted",
}
NEEDED = {"solid": 6, "surface": 6, "erosion": 7, "fractal": 8, "materials": 10, "sea": 11, "fitted": 12}
ROWS = 64  # of the pictures that are compared
MACROS = "#define GABOR_LOBES 6\n#define GABOR_DIRECTION(p) (0.3f * (p))\n"


def needed(call):
    """Returns the number of FILES that a call needs."""
    return NEEDED.get(CALLS.get(call), 4)


def named(floats, integers):
    """Returns definitions of GLSL's names of vectors, which CALLS use."""
    return f"typedef {floats}2 vec2;\ntypedef {floats}3 vec3;\ntypedef {integers}2 ivec2;\n"


SIX = """
GaborLobes six()
{
    GaborLobes lobes;
    lobes.count = 6;
    for (int i = 0; i < 6; ++i)
        lobes.lobe[i] = gabor_lobe(1.0f + float(i), 0.5f * float(i), 1.0f, 1.0f);
    return lobes;
}
"""

GLSL = SIX + """
layout(local_size_x = 8) in;
layout(std430, binding = 0) writeonly buffer Values { float values[]; };
void main()
{
    uvec2 pixel = gl_GlobalInvocationID.xy;
    vec2 p = (vec2(pixel) + 0.5) / vec2(32.0, 8.0);
    vec3 q = vec3(p, 0.3);
    float unknown = float(pixel.x >> 8u); // 0
    uint at = pixel.y * 256u + pixel.x;
    CALLS
}
"""
HLSL = named("float", "int") + SIX + """
RWStructuredBuffer<float> values : register(u0);
static float2 p;
static float3 q; // few calls use both p and q
[numthreads(8, 1, 1)] void main(uint3 pixel : SV_DispatchThreadID)
{
    p = (float2(pixel.xy) + 0.5) / float2(32.0, 8.0);
    q = float3(p, 0.3);
    uint at = pixel.y * 256u + pixel.x;
    CALLS
}
"""
ANGLE = SIX + """
out vec4 value;
void main()
{
    vec2 p = gl_FragCoord.xy / vec2(32.0, 8.0);
    vec3 q = vec3(p, 0.3);
    value = vec4(CALL);
}
"""
WGSL = """
alias ivec2 = vec2i;
fn six() -> GaborLobes {
    var lobes: GaborLobes;
    lobes.count = 6;
    for (var i = 0; i < 6; i++) { lobes.lobe[i] = gabor_lobe(1.0 + f32(i), 0.5 * f32(i), 1.0, 1.0); }
    return lobes;
}
fn gabor_field_direction(place: GaborPlace, seed: u32) -> GaborField {
    var waves: GaborWaves;
    for (var i = 0; i < 9; i++) { waves.wave[i] = 0.3 * gabor_node_position(place, i); }
    return gabor_field_waves(place, waves, seed);
}
@group(0) @binding(0) var<storage, read_write> values: array<f32>;
@compute @workgroup_size(8) fn main(@builtin(global_invocation_id) pixel: vec3u) {
    let p = (vec2f(pixel.xy) + 0.5) / vec2f(32.0, 8.0);
    let q = vec3f(p, 0.3);
    let at = pixel.y * 256u + pixel.x;
    CALLS
}
"""


def bands(entry, pixel, shown):
    """Returns a fragment shader that draws each call as a band. `pixel` is the pixel's position, and `shown` shows the noise."""
    return """
#define GABOR_LOBES 6
#define GABOR_DIRECTION(p) (0.3 * (p))
INCLUDES
""" + SIX + f"""
{entry}
{{
    int row = int({pixel}.y);
    vec2 p = vec2({pixel}.x, float(row % ROWS) + 0.5) / vec2(32.0, 8.0);
    vec3 q = vec3(p, 0.3);
    float noise = 0.0;
    CALLS
    {shown}
}}
"""


ES = bands("out vec4 value;\nvoid main()", "gl_FragCoord", "value = vec4(noise);")
GODOT_SHADER = "shader_type canvas_item;\nrender_mode unshaded, blend_disabled;\nuniform float frequency;\nuniform float sharpness;\n" + bands(
    "void fragment()", "FRAGCOORD", """uint bits = floatBitsToUint(noise);
    COLOR = vec4(uvec4(bits, bits >> 8u, bits >> 16u, bits >> 24u) & uvec4(255u)) / 255.0;""").replace("0f", "0").replace("5f", "5")
WARNINGS = "-Wall", "-Wextra", "-Werror"
HEADERS = MACROS + "".join(f'#include "{file}.hpp"\n' for file in FILES)
CPP_LOOP = """#include <fstream>
#include <vector>
void draw(float* row, int y)
{
    for (int x = 0; x < 256; ++x)
        row[x] = gabor_noise({(float(x) + 0.5f) / 32.0f, (float(y) + 0.5f) / 8.0f}, 4.0f, 0.7854f, 7u);
}
int main(int, char** argv)
{
    std::vector<float> noise(256 * 257);
    std::vector<std::uint32_t> words;
    for (int y = 0; y < 257; ++y) {
        draw(&noise[256 * y], y);
        for (int x = 0; x < 256; ++x)
            words.push_back(gabor_impl_line_word(x, gabor_impl_salt(7u))
                            * gabor_impl_line_word(-y, gabor_impl_salt(7u) ^ GABOR_IMPL_ROWS));
    }
    std::ofstream file(argv[1], std::ios::binary);
    file.write(reinterpret_cast<const char*>(noise.data()), 4 * noise.size());
    file.write(reinterpret_cast<const char*>(words.data()), 4 * words.size());
}
"""
COMPILER = os.environ.get("CXX", "c++")
GCC = metal.is_gcc(COMPILER)


class Translations(unittest.TestCase):
    DRAWN = {}  # the values that the GLSL shader draws, by call

    @classmethod
    def setUpClass(cls):
        cls.made = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        write_png(cls.made / "sea.png", colour_noise(160))
        subprocess.run([os.environ["GABOR_PROGRAM"], "fit", "sea.png", "-o", "sea.json", "--lobes", "3", "--glsl", "sea.glsl"],
                       cwd=cls.made, check=True, stdout=subprocess.DEVNULL)
        subprocess.run([sys.executable, "-B", ROOT / "tools" / "translate", "sea.glsl"], cwd=cls.made, check=True)

    def path(self, file, ending):
        return self.made / f"sea.{ending}" if file == "sea" else drop_in_path(file, ending)

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def shader(self, ending, text, calls, rows=ROWS, before=MACROS):
        """Returns a shader that draws a picture of each call, with the drop-ins that they need."""
        files = "".join(self.path(file, ending).read_text() for file in FILES[:max(map(needed, calls))])
        if ending == "hlsl":  # which has no constructors of structs
            calls = [call.replace("GaborSea(", "GaborSea_of(") for call in calls]
        drawn = "\n    ".join(f"values[at + {256 * rows * k}u] = {call};" for k, call in enumerate(calls))
        return before + files + text.replace("CALLS", drawn).replace("CALL", calls[0])

    def groups(self, calls):
        """Returns lists of calls that need the same files."""
        return [list(group) for _, group in itertools.groupby(sorted(calls, key=needed), needed)]

    def drawn(self, ending, text, *compiler, calls=CALLS, rows=ROWS, **options):
        """Returns a picture of each call. `compiler` is a command that takes a shader's file and the SPIR-V file."""
        groups, made = self.groups(calls), []
        for group in groups:
            made.append(self.folder / f"{len(made)}.spv")
            source = made[-1].with_suffix(f".{ending}")
            source.write_text(self.wgsl(group) if ending == "wgsl" else self.shader(ending, text, group, rows, **options))
            subprocess.run([*compiler, source, made[-1]], check=True, stdout=subprocess.DEVNULL)
        _, *values = on_vulkan(*made, rows=rows, pictures=max(map(len, groups)))
        return {call: picture for group, each in zip(groups, values) for call, picture in zip(group, each.reshape(-1, 256 * rows))}

    def glsl(self, **options):
        return self.drawn("glsl", GLSL, "sh", "-c", 'glslangValidator -V -S comp "$0" -o "$1"', before=f"#version 450\n{MACROS}", **options)

    def compare(self, translated, calls=CALLS, inexact="eroded"):
        """Compares each call with GLSL; materials, erosion, fits, octaves and the sea less strictly, because they magnify differences in
        rounding.
        `inexact` are calls of functions that the device computes with few digits."""
        errors = {}
        if not self.DRAWN:
            self.DRAWN.update(self.glsl())
        for call in calls:
            wanted = self.DRAWN[call]
            with self.subTest(call):
                self.assertGreater(wanted.std(), 0.5)
                drawn = translated(call)[:len(wanted)]
                difference = np.abs(drawn - wanted[:len(drawn)])
                print(f"{call}: largest difference {difference.max():.2g} at value {difference.argmax()}")
                error = float(difference.max() / wanted.std())
                self.assertLess(error, 1e-3 if re.search(rf"colour|sand|{inexact}|sea\(", call) else 3e-5 if CALLS[call] in ("sea", "fractal") else 1e-5)
                errors[CALLS[call]] = max(errors.get(CALLS[call], 0), error)
        if folder := os.environ.get("GABOR_MATRIX"):  # for tools/test-engines, which writes docs/engine-results.md
            name = self._testMethodName.removeprefix("test_")
            (pathlib.Path(folder) / f"{name}.json").write_text(json.dumps(errors))

    def compare_hlsl(self, *compiler):
        self.compare(self.drawn("hlsl", HLSL, *compiler).get)

    def test_hlsl_by_glslang(self):
        self.compare_hlsl("sh", "-c", 'glslangValidator -V -D -Od -S comp -e main "$0" -o "$1"')

    def test_hlsl_by_dxc(self):
        if not DXC.exists():
            self.skipTest("libdxcompiler is not installed")
        os.environ["GABOR_DXC"] = str(DXC)
        self.compare_hlsl(sys.executable, "-B", HERE / "dxc.py")

    def compare_direct3d(self, dialect, ending, text):
        if not (DIRECT3D / "direct3d.exe").exists():
            self.skipTest("direct3d.exe is not installed: tools/test-engines fxc installs it")

        def drawn(call):
            shader, values = (self.folder / f"shader.{kind}" for kind in (ending, "raw"))
            shader.write_text(text(call))
            subprocess.run([sys.executable, "-B", HERE.parent / "engines/direct3d/run.py", dialect, values, shader], check=True,
                           env=os.environ | {"GABOR_DIRECT3D": str(DIRECT3D)}, stdout=subprocess.DEVNULL)
            return np.fromfile(values, "<f4")
        self.compare(drawn)

    def test_hlsl_by_fxc(self):
        self.compare_direct3d("fxc", "hlsl", lambda call: self.shader("hlsl", HLSL, [call]))

    def test_angle(self):
        before = f"#version 300 es\nprecision highp float;\n{MACROS}"
        self.compare_direct3d("angle", "frag", lambda call: self.shader("glsl", ANGLE, [call], before=before))

    def wgsl(self, calls):
        """Returns a shader in WGSL, in which users edit this constant."""
        text = self.shader("wgsl", WGSL, calls, before="")
        self.assertEqual(text.count("GABOR_LOBES: i32 = 4;"), needed(calls[0]) > 1)
        return text.replace("GABOR_LOBES: i32 = 4;", "GABOR_LOBES: i32 = 6;")

    def test_wgsl_by_tint(self):
        if not (DAWN / "node_modules").exists() or not SWIFTSHADER.exists():
            self.skipTest("Dawn is not installed: tools/test-engines dawn installs it")
        drawn = {}
        for group in self.groups(CALLS):
            shader, values = self.folder / "shader.wgsl", self.folder / "values.raw"
            shader.write_text(self.wgsl(group))
            subprocess.run(["node", DAWN / "run.mjs", values, shader, str(ROWS), str(len(group))], check=True, stdout=subprocess.DEVNULL,
                           env=os.environ | {"VK_ICD_FILENAMES": str(SWIFTSHADER)})
            drawn |= zip(group, np.fromfile(values, "<f4").reshape(len(group), -1))
        self.compare(drawn.get, inexact="eroded|profile")  # SwiftShader's atan errs by 1e-4

    def test_wgsl_by_naga(self):
        if not shutil.which("naga"):
            self.skipTest("naga is not installed")
        # lavapipe takes minutes to compile naga's loops, but only a second after spirv-opt.
        command = ["sh", "-c", 'naga "$0" "$1" && spirv-opt --eliminate-dead-functions --ssa-rewrite "$1" -o "$1"']
        self.compare(self.drawn("wgsl", WGSL, *command, before="").get)

    def compare_bands(self, text, ending, engine, *arguments, calls=CALLS):
        """Draws each call as a band of one picture, with a script of tests/engines."""
        rows, shader, values = 256 // len(calls), self.folder / f"noise.{ending}", self.folder / "values.raw"
        chosen = "".join(f"if (row / {rows} == {i}) noise = {call};\n    " for i, call in enumerate(calls))
        shader.write_text(text.replace("ROWS", str(rows)).replace("CALLS", chosen))
        subprocess.run([sys.executable, "-B", HERE.parent / "engines" / engine / "run.py", *arguments, values, shader], check=True,
                       stdout=subprocess.DEVNULL)
        bands = np.fromfile(values, "<f4")[:256 * rows * len(calls)].reshape(len(calls), -1)
        self.compare(dict(zip(calls, bands)).get, calls)

    def test_godot(self):
        if not GODOT.exists():
            self.skipTest("Godot is not installed: tools/test-engines godot installs it")
        includes = "".join(f'#include "res://{file}.gdshaderinc"\n' for file in FILES[:-1])
        self.compare_bands(GODOT_SHADER.replace("INCLUDES", includes + self.path("sea", "gdshaderinc").read_text()), "gdshader",
                           "godot", GODOT, "canvas", "mobile", "vulkan")

    def test_opengl_es(self):
        """Runs GLSL after a header that sets mediump, which is 16 bits on this driver. The files set highp themselves. A call of each
        column will do, but not for the table."""
        includes = "".join(self.path(file, "glsl").read_text() for file in FILES)
        calls = CALLS if "GABOR_MATRIX" in os.environ else {column: call for call, column in CALLS.items()}.values()
        self.compare_bands(ES.replace("INCLUDES", includes), "frag", "gles", "precision mediump float;", calls=calls)

    def test_cpp(self):
        # Inlining everything would triple the compile time.
        self.compare_cpp(HEADERS + named("gabor_vec", "gabor_ivec"), "-std=c++11", "-O1", "-Dalways_inline=unused", "-I", SHADERS / "translations", "-I", self.made)

    def test_metal(self):
        text = "".join(self.path(file, "metal").read_text() for file in FILES)
        self.compare_cpp(MACROS + metal.as_cpp(text) + named("float", "int"), "-O1", "-Wno-unused", *metal.options(COMPILER))

    def compare_cpp(self, before, *options):
        """Compares each call in a C++ program. `before` is the text before its main."""
        calls = [re.sub(r"GaborSea\(([^()]*)\)", r"GaborSea{\1}", re.sub(r"(\d\.\d+)", r"\1f", call)) for call in CALLS]
        drawn = in_cpp(self.folder, before + SIX, calls, *WARNINGS, *options, code="p.y *= 4.0f; const gabor_vec3 q(p, 0.3f);", rows=ROWS)
        self.compare(dict(zip(CALLS, drawn.reshape(len(calls), -1))).get)

    def test_cpp_vectors(self):
        """Checks that the compiler vectorizes a loop over points, that its noise equals the shader's within 1e-6, and that the
        lattice's hash words are equal. Without `+ unknown`, the shader compiler would fold constants and reorder products."""
        values, said = run_cpp(self.folder, HEADERS + CPP_LOOP, *WARNINGS, "-std=c++11", "-O3", "-I", SHADERS / "translations", "-I",
                               self.made, *["-fopt-info-vec"] * GCC)
        if GCC:
            self.assertRegex(said, "loop vectorized")
        noise, words = np.split(values, 2)
        wanted, wanted_words = self.glsl(rows=257, calls=[
            "gabor_noise(p, 4.0 + unknown, 0.7854 + unknown, 7u)",
            "uintBitsToFloat(gabor_impl_line_word(int(pixel.x), gabor_impl_salt(7u)) "
            "* gabor_impl_line_word(-int(pixel.y), gabor_impl_salt(7u) ^ GABOR_IMPL_ROWS))"]).values()
        difference = np.abs(noise.view("<f4") - wanted)
        print(f"gabor_noise: largest difference {difference.max():.2g} at value {difference.argmax()}")
        self.assertLess(difference.max(), 1e-6)
        self.assertGreater(len(set(words)), 65000)
        np.testing.assert_array_equal(words, wanted_words.view("<u4"))


if __name__ == "__main__":
    unittest.main()

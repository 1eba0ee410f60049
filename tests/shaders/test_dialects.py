"""gabor_noise.glsl, and gabor_noise_3d.glsl after it, pasted into shaders of every dialect, and the names and constructs that it may use."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

SHADERS = pathlib.Path(os.environ["GABOR_SHADERS"])
SOURCE_3D = (SHADERS / "gabor_noise_3d.glsl").read_text()
SOURCE = (SHADERS / "gabor_noise.glsl").read_text() + SOURCE_3D
VALIDATOR = os.environ["GLSLANG_VALIDATOR"]

RECIPES = {
    "default": {},
    "paper": {"GABOR_IMPULSES": "2", "GABOR_WEIGHT_FLOOR": "1.0", "GABOR_PHASES": "2",
              "GABOR_WINDOW": "vec3(1.0, 0.0, 0.0)"},
    "solid": {"GABOR_3D_IMPULSES": "2", "GABOR_3D_RADIUS": "1.5", "GABOR_3D_WINDOW": "vec3(0.7, -0.9, 1.2)"},
    "wide": {"GABOR_RADIUS": "1.5", "GABOR_WEIGHT_FLOOR": "0.5", "GABOR_WINDOW": "vec3(1.0, -1.0, 1.0)"},
    "native sine": {"GABOR_NATIVE_SINE": "1"},
    "lobes": {"GABOR_LOBES": "6"},
}
HIGHP = "precision highp float; precision highp int;\n"

# The functions to call, with values that no compiler can fold.
USE = """
    vec3 dx = vec3(0.1, p);
    GaborKernel once = gabor_kernel(p.x, p.y);
    float noise = gabor_noise(p, 4.0, 0.7854, 7u) + gabor_noise_at(ivec2(p), fract(p), once, 7u);
    vec3 bump = gabor_noise_gradient(p, 4.0, 0.7854, 7u);
    vec2 phasor = gabor_phasor(gabor_noise_complex(p, 4.0, 0.7854, 7u));
    vec4 four = gabor_noise_four(p, 4.0, 0.7854, 7u);
    noise += bump.x + bump.y + bump.z + phasor.x + phasor.y + four.x + four.y + four.z + four.w
           + gabor_noise_spread(p, 4.0, p.x, 0.5, p.y, 7u);
    GaborLobes lobes;
    for (int i = 0; i < GABOR_LOBES; ++i)
        lobes.lobe[i] = gabor_lobe(p.x, p.y, 0.0, 0.0, 1.0);
    lobes.count = GABOR_LOBES;
    noise += gabor_noise_lobes(p, lobes, 7u) + gabor_noise_sum(p, lobes, 7u);
    noise += dot(gabor_noise_filtered(p, p, p.yx, 4.0, 0.7854, 7u), vec2(1.0))
           + gabor_noise_tiled(p, vec2(5.0, 7.5), 4.0, 0.7854, 7u) + gabor_noise_animated(p, p.x, 4.0, 0.7854, 7u);
    vec3 q = vec3(p, 0.3);
    GaborKernel3d solid = gabor_filtered_3d(gabor_kernel_isotropic_3d(p.y), dx, 0.5 * dx);
    noise += gabor_noise_3d(q, 4.0, q, 7u) + gabor_noise_3d_isotropic(q, 4.0, 7u)
           + dot(gabor_noise_3d_gradient(q, 4.0, q, 7u), vec4(1.0)) + gabor_phasor(gabor_noise_3d_complex(q, 4.0, q, 7u)).x
           + gabor_noise_3d_tiled(q, vec3(5.0, 7.5, 2.0), 4.0, q, 7u) + gabor_noise_3d_animated(q, p.x, 4.0, q, 7u)
           + gabor_noise_surface(q, q, 4.0, q, 7u) + gabor_noise_surface_isotropic(q, q, 4.0, 7u)
           + gabor_noise_3d_at(ivec3(q), fract(q), solid, 7u);
    float unorm = gabor_unorm(noise);
"""
FRAGMENT = "{target} vec4 color;\nvoid main()\n{{\n    vec2 p = gl_FragCoord.xy / 32.0;\n" + USE + \
           "    color = vec4(unorm);\n}}\n"
COMPUTE = "layout(local_size_x = 8, local_size_y = 8) in;\n" \
          "layout(std430, binding = 0) writeonly buffer Result {{ float result[]; }};\n" \
          "void main()\n{{\n    vec2 p = vec2(gl_GlobalInvocationID.xy) / 32.0;\n" + USE + \
          "    result[gl_GlobalInvocationID.x] = unorm;\n}}\n"

# Dialect: version, what comes before the file, shader, its output's qualifiers, stage, options of the compiler.
DIALECTS = {
    "450 fragment": ("450", "", FRAGMENT, "layout(location = 0) out", "frag", []),
    "450 compute": ("450", "", COMPUTE, "", "comp", []),
    "450 fragment for Vulkan": ("450", "", FRAGMENT, "layout(location = 0) out", "frag", ["-V"]),
    "450 compute for Vulkan": ("450", "", COMPUTE, "", "comp", ["-V"]),
    "330 core fragment": ("330 core", "", FRAGMENT, "out", "frag", []),
    "300 es fragment": ("300 es", HIGHP, FRAGMENT, "out", "frag", []),
}


def shader(version, before, body, target, macros={}, times=1):
    defines = "".join(f"#define {name} {value}\n" for name, value in macros.items())
    return f"#version {version}\n{before}{defines}{SOURCE * times}{body.format(target=target)}"


def strip_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.DOTALL)


def outermost(text):
    """What is in no braces and no parentheses."""
    while True:
        text, replaced = re.subn(r"\([^(){}]*\)|\{[^(){}]*\}", " ", text)
        if not replaced:
            return text


class Dialects(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="gabor-")
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def compile(self, source, stage, options):
        """Compiles and links without an error or a warning; the file of SPIR-V, where one was asked for."""
        path, spirv = self.folder / f"shader.{stage}", self.folder / "shader.spv"
        path.write_text(source)
        options = [*options, *(["-o", spirv] if "-V" in options else ["-l"])]
        result = subprocess.run([VALIDATOR, *options, path], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertNotRegex(result.stdout + result.stderr, "ERROR|WARNING")
        return spirv

    def test_every_dialect_compiles_every_recipe(self):
        for dialect, (*parts, stage, options) in DIALECTS.items():
            for recipe, macros in RECIPES.items():
                with self.subTest(dialect, recipe=recipe):
                    self.compile(shader(*parts, macros), stage, options)

    def test_included_twice_it_counts_once(self):
        for dialect, (*parts, stage, options) in DIALECTS.items():
            with self.subTest(dialect):
                self.compile(shader(*parts, times=2), stage, options)

    def test_an_error_would_be_noticed(self):
        *parts, stage, options = DIALECTS["300 es fragment"]
        with self.assertRaises(AssertionError):
            self.compile(shader(*parts, {"GABOR_IMPULSES": "2.0"}), stage, options)

    def test_in_space_it_says_what_must_come_before(self):
        *parts, stage, options = DIALECTS["450 fragment"]
        version, before, body, target = parts
        with self.assertRaisesRegex(AssertionError, "put that file before it"):
            self.compile(f"#version {version}\n{before}{SOURCE_3D}{body.format(target=target)}", stage, options)

    def test_spirv_tools_accept_it(self):
        tools = {"spirv-val": [], "spirv-cross": ["--version", "310", "--es"]}
        found = {tool: options for tool, options in tools.items() if shutil.which(tool)}
        for dialect, (*parts, stage, options) in DIALECTS.items():
            if "-V" in options:
                spirv = self.compile(shader(*parts), stage, options)
                for tool, tool_options in found.items():
                    with self.subTest(tool=tool, dialect=dialect):
                        subprocess.run([tool, *tool_options, spirv], check=True, timeout=60, stdout=subprocess.DEVNULL)
        if len(found) < len(tools):
            self.skipTest(f"not installed: {', '.join(tools.keys() - found.keys())}")


class Names(unittest.TestCase):
    def setUp(self):
        lines = strip_comments(SOURCE).splitlines()
        self.directives = [line.strip() for line in lines if line.strip().startswith("#")]
        self.code = "\n".join(line for line in lines if not line.strip().startswith("#"))

    def test_all_global_names_have_the_prefix(self):
        types = {"bool", "int", "uint", "float", "struct", "void", "const", "highp"}
        vectors = re.compile(r"[biu]?vec[234]|mat[234]")
        names = {name for name in re.findall(r"[A-Za-z_]\w*", outermost(self.code))
                 if name not in types and not vectors.fullmatch(name)}
        self.assertIn("gabor_noise", names)
        self.assertIn("gabor_noise_3d", names)
        self.assertIn("GaborKernel", names)
        self.assertEqual({name for name in names if not re.match("gabor_|Gabor", name)}, set())

    def test_all_macros_have_the_prefix(self):
        macros = {match[1] for line in self.directives if (match := re.match(r"#\s*(?:define|undef)\s+(\w+)", line))}
        self.assertIn("GABOR_IMPULSES", macros)
        self.assertEqual({name for name in macros if not name.startswith("GABOR_")}, set())

    def test_it_leaves_version_and_extensions_to_the_shader(self):
        self.assertEqual({re.match(r"#\s*(\w+)", line)[1] for line in self.directives},
                         {"if", "ifdef", "ifndef", "define", "error", "endif"})

    def test_it_states_its_precision(self):
        guard = "#ifdef GL_ES\nprecision highp float;\nprecision highp int;\n#endif\n"
        self.assertEqual(SOURCE.count(guard), 2)
        self.assertEqual(SOURCE.count("precision "), 4)

    def test_it_declares_no_resources(self):
        self.assertNotRegex(self.code, r"\b(uniform|buffer|shared|layout|in|out|varying|attribute|binding)\b")
        self.assertNotRegex(self.code, r"\b[iu]?(sampler|texture|image)\w*\b")

    def test_it_has_no_constant_arrays_and_no_initializer_lists(self):
        # Drivers copy constant arrays at each access; 300 es knows no initializer lists. Lobes are the only arrays.
        self.assertEqual(set(re.findall(r"\w+ \w+\[\w+\]", self.code)), {"GaborLobe lobe[GABOR_LOBES]"})
        self.assertNotRegex(self.code, r"const[^;()]*\[")
        self.assertNotRegex(self.code, r"=\s*\{")

    def test_no_comment_behind_code_has_a_semicolon(self):
        # Babylon.js splits lines at semicolons before it looks for comments.
        self.assertEqual(re.findall(r"^\s*[^/\s][^\n]*//[^\n]*;[^\n]*", SOURCE, re.MULTILINE), [])


if __name__ == "__main__":
    unittest.main()

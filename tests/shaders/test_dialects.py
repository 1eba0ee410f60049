"""Compiles each drop-in in every dialect, in a shader that includes the drop-ins it depends on and calls all of its
functions. Checks the names and constructs that the drop-ins use."""

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

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "engines"))
from scene import packaged  # noqa: E402

SHADERS = pathlib.Path(os.environ["GABOR_SHADERS"])
VALIDATOR = os.environ["GLSLANG_VALIDATOR"]

# Each set of functions.glsl, and the files to include for it, in order.
FILES = {
    "gabor_sparse": ["gabor_sparse"],
    "gabor_noise": ["gabor_noise"],
    "gabor_spectrum": ["gabor_noise", "gabor_spectrum", "gabor_filter"],
    "gabor_noise_3d": ["gabor_noise", "gabor_filter", "gabor_noise_3d", "gabor_filter_3d"],
    "gabor_materials": ["gabor_noise", "gabor_spectrum", "gabor_fractal", "gabor_materials", "gabor_compose"],
    "gabor_erosion": ["gabor_noise", "gabor_erosion"],
    "gabor_fractal": ["gabor_noise", "gabor_fractal"],
    "gabor_ocean": ["gabor_noise", "gabor_ocean"],
    "gabor_direction": ["gabor_noise", "gabor_direction"],
}
DROP_INS = sorted({*sum(FILES.values(), [])})
MAP = "vec2 gabor_map(vec2 p)\n{\n    return p.yx;\n}\n#define GABOR_DIRECTION(p) gabor_map(p)\n"
SOURCES = {name: "".join((SHADERS / f"{file}.glsl").read_text() for file in files) for name, files in FILES.items()}

LISTED = json.loads(subprocess.run([os.environ["GABOR_PROGRAM"], "recipes", "--json"], capture_output=True, check=True).stdout)
RECIPES = {name: {recipe["name"]: recipe["macros"] for recipe in LISTED if recipe["file"] == f"{name}.glsl"} or {"default": {}}
           for name in FILES}
RECIPES["gabor_spectrum"]["lobes"] = {"GABOR_LOBES": "6"}
RECIPES["gabor_erosion"] |= {"lattice-2": {"GABOR_TAPS": "2"}, "lattice-4": {"GABOR_TAPS": "4"}}

# Invalid values of macros, and the compiler's expected message.
BAD_MACROS = {
    "gabor_sparse": [
        ("GABOR_IMPULSES", "0", "GABOR_IMPULSES must be an int *, at least 1"),
        ("GABOR_IMPULSES", "2.0", "'preprocessor evaluation' : bad expression"),
        ("GABOR_PHASES", "3", "GABOR_PHASES must be a power of two *, from 2 to 256"),
        ("GABOR_PHASES", "512", "GABOR_PHASES must be a power of two *, from 2 to 256"),
        ("GABOR_CELLS_PER_RADIUS", "1", "gabor_impl_needs_int_float_float_int_vec3_macros"),
        ("GABOR_WEIGHT_FLOOR", "1", "gabor_impl_needs_int_float_float_int_vec3_macros"),
        ("GABOR_WINDOW", "1.0", "gabor_impl_needs_int_float_float_int_vec3_macros"),
    ],
    "gabor_noise": [
        ("GABOR_TAPS", "1", "GABOR_TAPS must be 2 *, 3 or 4"),
        ("GABOR_TAPS", "5", "GABOR_TAPS must be 2 *, 3 or 4"),
        ("GABOR_TAPS", "5.5", "'preprocessor evaluation' : bad expression"),
    ],
    "gabor_spectrum": [("GABOR_LOBES", "0", "GABOR_LOBES must be an int *, at least 1")],
    "gabor_noise_3d": [("GABOR_TAPS", "4", "gabor_filter . glsl needs GABOR_TAPS 3")],
    "gabor_materials": [("GABOR_TAPS", "4", "gabor_fractal . glsl needs GABOR_TAPS 3")],
    "gabor_direction": [("GABOR_TAPS", "4", "gabor_direction . glsl needs GABOR_TAPS 3")],
    "gabor_fractal": [("GABOR_TAPS", "4", "gabor_fractal . glsl needs GABOR_TAPS 3")],
    "gabor_ocean": [("GABOR_OCEAN_BANDS", "13", "GABOR_OCEAN_BANDS must be 1 to 12")],
    "gabor_erosion": [("GABOR_TAPS", "5", "GABOR_TAPS must be 2 *, 3 or 4")],
}

# Every public function, with arguments that no compiler can fold.
CALLS = (pathlib.Path(__file__).parents[1] / "golden" / "functions.glsl").read_text().replace("\\\n", "")
FRAGMENT = "{target} vec4 color;\nvoid main()\n{{\n    see_all(int(gl_FragCoord.x));\n    color = vec4(seen);\n}}\n"
COMPUTE = "layout(local_size_x = 8, local_size_y = 8) in;\n" \
          "layout(std430, binding = 0) writeonly buffer Result {{ float result[]; }};\n" \
          "void main()\n{{\n    see_all(int(gl_GlobalInvocationID.x));\n    result[gl_GlobalInvocationID.x] = seen;\n}}\n"

# For each dialect: version, text before the file, shader, qualifiers of its output, stage, compiler options.
DIALECTS = {
    "450 fragment": ("450", "", FRAGMENT, "layout(location = 0) out", "frag", []),
    "450 compute": ("450", "", COMPUTE, "", "comp", []),
    "450 fragment for Vulkan": ("450", "", FRAGMENT, "layout(location = 0) out", "frag", ["-V"]),
    "450 compute for Vulkan": ("450", "", COMPUTE, "", "comp", ["-V"]),
    "330 core fragment": ("330 core", "", FRAGMENT, "out", "frag", []),
    # The calls give it arbitrary bits, but no drop-in of these versions needs it.
    **{f"{version} fragment": (version, "#define uintBitsToFloat float\n", FRAGMENT, "out", "frag", [])
       for version in ("130", "140", "150", "150 core")},
    "300 es fragment": ("300 es", "precision highp float;\n", FRAGMENT, "out", "frag", []),
    "300 es fragment, mediump": ("300 es", "precision mediump float;\n", FRAGMENT, "out", "frag", []),
}


def shader(name, version, before, body, target, macros={}, times=1):
    defines = "".join(f"#define {macro} {value}\n" for macro, value in macros.items())
    calls = f"#define GOLDEN_{name.removeprefix('gabor_').upper()}\n#define precise\n#define SEE(call) seen += call;\nfloat seen = 0.0;\n{CALLS}"
    return f"#version {version}\n{before}{defines}{MAP * ('direction' in name)}{SOURCES[name] * times}{calls}{body.format(target=target)}"


def strip_comments(text):
    return re.sub(r"/\*.*?\*/|//[^\n]*", " ", text, flags=re.DOTALL)


def outermost(text):
    """Returns the text outside of braces and parentheses."""
    while True:
        text, replaced = re.subn(r"\([^(){}]*\)|\{[^(){}]*\}", " ", text)
        if not replaced:
            return text


class Dialects(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def compile(self, source, stage, options):
        """Compiles and links without errors or warnings; returns the SPIR-V file, if requested."""
        path, spirv = self.folder / f"shader.{stage}", self.folder / "shader.spv"
        path.write_text(source)
        options = [*options, *(["-o", spirv] if "-V" in options else ["-l"])]
        result = subprocess.run([VALIDATOR, *options, path], capture_output=True, text=True, timeout=60)
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertNotRegex(result.stdout + result.stderr, "ERROR|WARNING")
        return spirv

    def compile_each(self, paths):
        """Compiles files in one process, which starts in less time than one for each."""
        if not paths:
            return
        result = subprocess.run([VALIDATOR, *paths], capture_output=True, text=True, timeout=300)
        said = [line for line in (result.stdout + result.stderr).splitlines() if line not in map(str, paths)]
        self.assertEqual((result.returncode, said), (0, []))

    def test_every_dialect_compiles_every_recipe(self):
        """Includes each file twice with its first recipe, to test the include guard. For Vulkan, only the default recipe is compiled."""
        for dialect, (*parts, stage, options) in DIALECTS.items():
            paths = []
            if options:  # writes one file in each process
                for name in FILES:
                    with self.subTest(dialect, drop_in=name):
                        self.compile(shader(name, *parts), stage, options)
                continue
            for name, recipes in RECIPES.items():
                if name == "gabor_sparse" and parts[0].startswith("1"):
                    continue  # it needs uintBitsToFloat
                for times, (recipe, macros) in zip([2] + [1] * len(recipes), recipes.items()):
                    paths.append(self.folder / f"{name}-{recipe}.{stage}")
                    paths[-1].write_text(shader(name, *parts, macros, times))
            with self.subTest(dialect):
                self.compile_each(paths)

    def test_shadertoy_texts_compile_with_the_code_that_shadertoy_adds(self):
        before = "precision highp float;\nprecision highp int;\nuniform vec3 iResolution;\nuniform float iTime;\n" \
                 "uniform vec4 iMouse;\nout vec4 result;\n"
        after = "void main() { mainImage(result, gl_FragCoord.xy); }\n"
        texts = sorted(packaged("shadertoy", self.folder / "package").glob("*.frag"))
        self.assertGreaterEqual(len(texts), 2)
        for path in texts:
            with self.subTest(path.name):
                self.compile(f"#version 300 es\n{before}{path.read_text()}{after}", "frag", [])

    def test_shims_compile_and_name_what_they_need(self):
        shims = sorted((SHADERS / "nodes" / "shims").glob("*.glsl"))
        self.assertGreater(len(shims), 0)
        calls = "out vec4 color;\nvoid main()\n{\n    vec3 p = gl_FragCoord.xyz;\n    color = vec4(" \
                "snoise(p.xy) + snoise(p), cnoise(p.xy), cnoise(p), pnoise(p.xy, p.yz) + pnoise(p, p));\n}\n"
        needed = "".join((SHADERS / f"gabor_{name}.glsl").read_text() for name in ("noise", "fractal"))
        for shim, dialect in itertools.product(shims, ("330 core fragment", "300 es fragment", "300 es fragment, mediump", "130 fragment")):
            version, before, *_ = DIALECTS[dialect]
            with self.subTest(shim.name, dialect=dialect):
                self.compile(f"#version {version}\n{before}{needed}{2 * shim.read_text()}{calls}", "frag", [])
            with self.assertRaisesRegex(AssertionError, "Include gabor_noise . glsl and gabor_fractal . glsl before"):
                self.compile(f"#version {version}\n{before}{shim.read_text()}{calls}", "frag", [])

    def test_an_error_names_a_bad_macro(self):
        *parts, stage, options = DIALECTS["300 es fragment"]
        for name, macros in BAD_MACROS.items():
            for macro, value, message in macros:
                with self.subTest(f"{macro} {value}"), self.assertRaisesRegex(AssertionError, message):
                    self.compile(shader(name, *parts, {macro: value}), stage, options)

    def test_a_missing_include_is_named(self):
        version, before, _, _, stage, options = DIALECTS["450 fragment"]
        for name in {*DROP_INS} - {"gabor_noise", "gabor_sparse"}:
            with self.subTest(name), self.assertRaisesRegex(AssertionError, r"Include gabor_noise . glsl \S*.*before"):
                self.compile(f"#version {version}\n{before}{(SHADERS / f'{name}.glsl').read_text()}", stage, options)
        with self.assertRaisesRegex(AssertionError, "Define GABOR_DIRECTION"):
            self.compile(f"#version {version}\n{before}{SOURCES['gabor_direction']}", stage, options)

    def test_an_old_version_is_named(self):
        for name, least, versions in (("gabor_sparse", 330, ("100", "120", "130", "150")), ("gabor_noise", 130, ("100", "120"))):
            for version in versions:
                with self.subTest(name, version=version), \
                        self.assertRaisesRegex(AssertionError, f"needs GLSL {least} or GLSL ES 300"):
                    self.compile(f"#version {version}\n{SOURCES[name]}", "frag", [])

    def test_bundles_compile(self):
        subprocess.run([sys.executable, "-B", SHADERS.parent / "tools" / "package", "bundles", "--stage", self.folder], check=True)
        bundles = sorted(self.folder.glob("gabor_bundle_*.glsl"))
        self.assertEqual(len(bundles), 24)
        made = []
        for bundle, version in itertools.product(bundles, ("450", "300 es")):
            text = bundle.read_text()
            self.assertIn("SPDX-License-Identifier: MIT", text)
            output = "layout(location = 0) out" if version == "450" else "out"
            made.append(self.folder / f"{bundle.stem}-{version[:3]}.frag")
            made[-1].write_text(f"#version {version}\n#define GABOR_DIRECTION(p) (p)\n{text}\n{output} vec4 c;\n"
                                "void main() { c = vec4(gabor_noise(gl_FragCoord.xy, 4.0, 0.7854, 7u)); }\n")
        self.compile_each(made)

    def test_including_two_base_drop_ins_is_an_error(self):
        for both in (("gabor_sparse", "gabor_noise"), ("gabor_noise", "gabor_sparse")):
            with self.assertRaisesRegex(AssertionError, "not both"):
                self.compile("#version 450\n" + "".join(map(SOURCES.get, both)) + "void main() {}\n", "frag", [])

    def test_spirv_tools_accept_it(self):
        tools = [["spirv-val"], ["spirv-cross", "--version", "310", "--es"], ["spirv-cross", "--version", "300", "--es"]]
        found, again = [tool for tool in tools if shutil.which(tool[0])], []
        for dialect, name in [*(("450 fragment for Vulkan", name) for name in FILES), ("450 compute for Vulkan", "gabor_noise")]:
            *parts, stage, options = DIALECTS[dialect]
            spirv = self.compile(shader(name, *parts), stage, options)
            for tool in found:
                if stage == "comp" and "300" in tool:
                    continue  # ESSL 300 has no compute shaders
                with self.subTest(tool=tool, dialect=dialect, drop_in=name):
                    text = subprocess.run([*tool, spirv], check=True, timeout=60, stdout=subprocess.PIPE, text=True).stdout
                    if tool[0] == "spirv-cross":
                        again.append(self.folder / f"{name}-{len(again)}.{stage}")
                        again[-1].write_text(text)
        self.compile_each(again)
        if len(found) < len(tools):
            self.skipTest(f"not installed: {', '.join(tool[0] for tool in tools if tool not in found)}")


class Names(unittest.TestCase):
    def setUp(self):
        self.text = "".join((SHADERS / f"{file}.glsl").read_text() for file in DROP_INS)
        lines = strip_comments(self.text).splitlines()
        self.directives = [line.strip() for line in lines if line.strip().startswith("#")]
        self.code = "\n".join(line for line in lines if not line.strip().startswith("#"))

    def test_all_global_names_have_the_prefix(self):
        types = {"bool", "int", "uint", "float", "struct", "void", "const", "precision", "highp"}
        vectors = re.compile(r"[biu]?vec[234]|mat[234]")
        names = {name for name in re.findall(r"[A-Za-z_]\w*", outermost(self.code))
                 if name not in types and not vectors.fullmatch(name)}
        for wanted in ("gabor_noise", "gabor_noise_spread", "gabor_noise_3d", "GaborKernel", "gabor_impl_windows"):
            self.assertIn(wanted, names)
        self.assertEqual({name for name in names if not re.match("gabor_|Gabor", name)}, set())

    def test_all_macros_have_the_prefix(self):
        macros = {match[1] for line in self.directives if (match := re.match(r"#\s*(?:define|undef)\s+(\w+)", line))}
        self.assertLessEqual({"GABOR_IMPULSES", "GABOR_TAPS"}, macros)
        self.assertEqual({name for name in macros if not name.startswith("GABOR_")}, set())

    def test_it_leaves_version_and_extensions_to_the_shader(self):
        self.assertLessEqual({re.match(r"#\s*(\w+)", line)[1] for line in self.directives},
                             {"if", "ifdef", "ifndef", "elif", "else", "define", "error", "endif"})

    def test_it_states_its_precision(self):
        guard = "#elif defined(GL_ES)\nprecision highp float;\nprecision highp int;\n#endif\n"
        for name in ("gabor_noise", "gabor_sparse"):  # all other files are included after one of these
            with self.subTest(name):
                text = (SHADERS / f"{name}.glsl").read_text()
                self.assertEqual(text.count(guard), 1)
                self.assertEqual(len(re.findall("^precision ", text, re.MULTILINE)), 2)

    def test_no_function_is_overloaded(self):
        # WGSL distinguishes functions by name only.
        for files in FILES.values():
            code = strip_comments("".join((SHADERS / f"{file}.glsl").read_text() for file in files))
            code = re.sub(r"^#(?:elif|else)(?:.|\n)*?^#endif", "", code, flags=re.MULTILINE)
            found = re.findall(r"^\w+ (gabor_\w+)\([^)]*\)\s*\{", code, re.MULTILINE)
            self.assertEqual({name for name in found if found.count(name) > 1}, set())

    def test_the_users_part_names_each_public_function_as_it_is_defined(self):
        signature = r"\w+ gabor_(?!impl_)\w+\([^)]*\)"
        for name in DROP_INS:
            user, _, private = (SHADERS / f"{name}.glsl").read_text().partition("// Private implementation\n")
            if not private:
                continue
            documented = re.findall(f"^// ({signature})", user, re.MULTILINE)
            defined = re.findall(rf"^({signature})\s*\{{", private, re.MULTILINE)
            if name == "gabor_materials":  # describes the functions of one material
                materials = re.findall(r"^Gabor(\w+) gabor_(\w+)_default", private, re.MULTILINE)
                documented = sorted({text.replace("gabor_wood", f"gabor_{word}").replace("GaborWood", f"Gabor{struct}")
                                     for text in documented for struct, word in materials})
                documented, defined = ([re.sub(r"\w+,\s+uint seed", "uint seed", text) for text in texts] for texts in (documented, defined))
            with self.subTest(name):
                self.assertGreater(len(defined), 2)
                self.assertEqual(sorted(re.sub(r"\s*\n//\s*", " ", text) for text in documented),
                                 sorted(re.sub(r"\s+", " ", text) for text in defined))

    def test_no_comment_includes_a_file(self):
        self.assertNotIn("#include", self.text)  # moderngl reads comments, too

    def test_its_messages_have_no_quotes(self):
        # wgpu's GLSL parser, naga, accepts only words and numbers.
        for line in self.directives:
            self.assertNotRegex(line, "[\"']")

    def test_it_declares_no_resources(self):
        self.assertNotRegex(outermost(self.code), r"\b(uniform|buffer|shared|layout|in|out|varying|attribute|binding)\b")
        self.assertNotRegex(self.code, r"\b[iu]?(sampler|texture|image)\w*\b")

    def test_it_has_no_constant_arrays_and_no_initializer_lists(self):
        # Drivers copy constant arrays at each access, and 300 es has no initializer lists. Apart from lobes and bands, the only arrays
        # are those of nodes, four along an axis or nine in the plane. Only constants and bounded loop counters index them.
        self.assertEqual(set(re.findall(r"\w+ \w+\[[\w +]+\]", self.code)),
                         {"GaborLobe lobe[GABOR_LOBES]", "uint word[4]", "vec4 node[4]", "vec2 wave[9]",
                          "GaborOceanBand band[GABOR_OCEAN_BANDS + 2]", "GaborOceanBand bands[GABOR_OCEAN_BANDS + 2]"})
        self.assertNotRegex(self.code, r"const[^;()]*\[")
        self.assertNotRegex(self.code, r"=\s*\{")

    def test_no_comment_behind_code_has_a_semicolon(self):
        # Babylon.js splits lines at semicolons before it looks for comments.
        self.assertEqual(re.findall(r"^\s*[^/\s][^\n]*//[^\n]*;[^\n]*", self.text, re.MULTILINE), [])


if __name__ == "__main__":
    unittest.main()

"""Checks that each translation with a preprocessor compiles alone, because it includes what it needs, and that texts in one
file include nothing: no file is beside them."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import metal

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent / "engines"))
sys.path.append(str(HERE.parents[1] / "tools"))
import copies  # noqa: E402
from scene import drop_in_path  # noqa: E402

COMPILER = os.environ.get("CXX", "c++")
NAMES = [path.stem for path in copies.DROP_INS]
CPP = COMPILER, "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-Wno-unused", "-Wno-parentheses"
# For each ending, the command that compiles a shader from its input, and what the shader needs besides.
LANGUAGES = {
    "hpp": ([*CPP, "-std=c++11", "-x", "c++", "-"], ""),
    "metal": ([*CPP, *metal.options(COMPILER), "-x", "c++", "-"], ""),
    "hlsl": (["glslangValidator", "--stdin", "-S", "comp", "-D", "-V", "-e", "main", "-o", os.devnull], "[numthreads(1, 1, 1)] void main() {}\n"),
}
BEFORE = "#define GABOR_DIRECTION(p) (p)\n"


def text(name, ending):
    made = drop_in_path(name, ending).read_text()
    return metal.as_cpp(made) if ending == "metal" else made


class Alone(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        self.empty = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def compile(self, ending, code, *options):
        (command, *rest), after = LANGUAGES[ending]
        said = subprocess.run([command, *options, *rest], input=BEFORE + code + after, cwd=self.empty, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stdout + said.stderr)

    def write(self, ending):
        for name in [*NAMES, "gabor_vectors"] if ending == "hpp" else NAMES:
            (self.folder / f"{name}.{ending}").write_text(text(name, ending))

    def include(self, ending, names):
        self.write(ending)
        self.compile(ending, "".join(f'#include "{name}.{ending}"\n' for name in names), f"-I{self.folder}")

    def test_each_includes_what_it_needs(self):
        for ending in ("metal", "hlsl"):  # for C++, see below
            for name in NAMES:
                with self.subTest(name, ending=ending):
                    self.include(ending, [name])

    def test_order_of_includes_does_not_matter(self):
        for ending in LANGUAGES:
            with self.subTest(ending):
                names = [name for name in NAMES if name != "gabor_sparse"]
                self.include(ending, [*names[::-1], *names])

    def test_pasted_texts_include_nothing(self):
        order = list(dict.fromkeys(other.stem for path in copies.DROP_INS if path.stem != "gabor_sparse"
                                   for other in [*copies.needed(path), path]))
        for ending in LANGUAGES:
            with self.subTest(ending):
                self.compile(ending, "".join(text(name, ending) for name in ["gabor_vectors"] * (ending == "hpp") + order))

    def test_pasted_texts_need_no_optional_one(self):
        for ending in LANGUAGES:
            for path in copies.DROP_INS:
                with self.subTest(path.stem, ending=ending):
                    order = [other.stem for other in [*copies.required(path), path]]
                    self.compile(ending, "".join(text(name, ending) for name in ["gabor_vectors"] * (ending == "hpp") + order))

    def test_each_function_is_there_alone(self):
        """A header alone has the functions of its optional parts, too."""
        functions = {name: re.findall(r"^\w+ (gabor_\w+)\(", text(name, "hpp").replace("GABOR_INLINE ", ""), re.MULTILINE) for name in NAMES}
        self.assertIn("gabor_wood_filtered", functions["gabor_materials"])
        for name, found in functions.items():
            with self.subTest(name):
                self.assertGreater(len(found), 3)
                self.write("hpp")
                self.compile("hpp", f'#include "{name}.hpp"\nvoid use(const void*);\nvoid all() {{\n'
                             + "".join(f"use(reinterpret_cast<const void*>(&{function}));\n" for function in found) + "}\n", f"-I{self.folder}")


if __name__ == "__main__":
    unittest.main()

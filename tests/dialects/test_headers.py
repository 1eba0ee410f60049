"""Compiles the C++ headers and the code in their manuals without warnings, by each installed compiler, after windows.h or its
macros."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "shaders" / "translations"
FILES = ("gabor_sparse",), ("gabor_noise", "gabor_spectrum", "gabor_filter", "gabor_direction", "gabor_noise_3d", "gabor_filter_3d",
                            "gabor_erosion", "gabor_fractal", "gabor_materials", "gabor_compose", "gabor_ocean")
CODE = re.compile(r"^//     +(\w[^;:\n]*;)(?= *$| +//)", re.MULTILINE)  # a line of code in a manual
MICROSOFT, MINGW = "--target=x86_64-pc-windows-msvc", "x86_64-w64-mingw32-g++"
OLD, NEW = "-std=c++11", "-std=c++20"
COMPILERS = ["g++-12", OLD], ["g++-13", OLD], ["g++-14", OLD], ["clang++", NEW], [MINGW, NEW], ["clang++", OLD, MICROSOFT, "-nostdinc++", "-isystem", "."]
# Clang knows Microsoft's language, but Microsoft's library is not free: this is what the headers need of it.
FLOATS = "".join(f"float {name}(float);\n" for name in
                 "abs acos asin atan ceil cos exp exp2 fabs floor log log2 sin sqrt tan".split())
LIBRARY = {"cmath": f"{FLOATS}float atan2(float, float);\nfloat pow(float, float);\n",
           "cstdint": "using uint32_t = unsigned;\n",
           "cstring": "void* memcpy(void*, const void*, decltype(sizeof 0));\n"}
BEFORE = "".join(f"#include <{name}>\n" for name in LIBRARY) + """#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define GABOR_DIRECTION(p) (p)
"""
DECLARED = "template <typename T> T dFdx(T);\ntemplate <typename T> T dFdy(T);\nvoid use(const void*);\n"


def examples(name):
    """Returns a function for each piece of code in a header's manual, and uses its variables."""
    point, made = "gabor_vec3" if name.endswith("_3d") else "gabor_vec2", ""
    for number, part in enumerate(re.split(r"\n(?://)?\n", (HEADERS / f"{name}.hpp").read_text())):
        if lines := CODE.findall(part):
            code = re.sub(r"\bvec", "gabor_vec", "\n    ".join(lines))
            used = "".join(f"    use(&{variable});\n" for variable in ["normal", *re.findall(r"\w+ (\w+) = ", code)])
            made += f"void {name}_{number}({point} p, gabor_vec3 normal) {{\n    {code}\n{used}}}\n"
    return made


def program(files):
    """Returns the text of a program with these headers, without the start."""
    code = [examples(name) for name in files]
    assert "" not in code, f"{files} have a manual without code"
    return BEFORE + "".join(f'#include "{name}.hpp"\n' for name in files) + DECLARED + "".join(code)


class Headers(unittest.TestCase):
    def test_compile_without_warnings(self):
        for compiler, *options in COMPILERS:
            with self.subTest(compiler, options=options), tempfile.TemporaryDirectory(prefix="gabor-") as folder:
                if not shutil.which(compiler):
                    self.skipTest(f"{compiler} is not installed")
                for name, content in LIBRARY.items():
                    (pathlib.Path(folder) / name).write_text(f"#pragma once\nnamespace std {{\n{content}}}\n")
                for files in FILES:
                    text = "#include <windows.h>\n" * (compiler == MINGW) + program(files)
                    # With -O1, GCC finds unset variables; the others find nothing more.
                    how = ["-c", "-O1"] if compiler.startswith("g++") else ["-fsyntax-only"]
                    command = [compiler, *how, "-Wall", "-Wextra", "-Werror", "-I", HEADERS, *options, "-x", "c++", "-"]
                    result = subprocess.run(command, input=text, text=True, capture_output=True, cwd=folder)
                    self.assertEqual(result.returncode, 0, result.stderr)


if __name__ == "__main__":
    unittest.main()

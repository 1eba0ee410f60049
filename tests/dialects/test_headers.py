"""Compiles the C++ headers and the code in their manuals, without warnings, by every installed compiler, after windows.h or
its macros."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "shaders" / "translations"
CODE = re.compile(r"^//     +(\w[^;:\n]*;)(?= *$| +//)", re.MULTILINE)
FILES = ("gabor_sparse",), ("gabor_noise", "gabor_spectrum", "gabor_direction", "gabor_noise_3d", "gabor_erosion", "gabor_materials")
# What windows.h defines.
MACROS = """#define near
#define far
#define small char
#define interface struct
#define IN
#define OUT
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
"""
# Clang knows Microsoft's language, but Microsoft's standard library is not free: this is what the headers need of it.
FLOATS = "".join(f"float {name}(float);\n" for name in
                 "abs acos asin atan ceil cos exp exp2 fabs floor log log2 sin sqrt tan".split())
MICROSOFT = {"cmath": f"namespace std {{\n{FLOATS}float atan2(float, float);\nfloat pow(float, float);\n}}\n",
             "cstdint": "namespace std { using uint32_t = unsigned; }\n",
             "cstring": "namespace std { void* memcpy(void*, const void*, decltype(sizeof 0)); }\n"}
STANDARD = "".join(f"#include <{name}>\n" for name in MICROSOFT)
MINGW = "x86_64-w64-mingw32-g++"


def examples(name):
    """Returns a function for each piece of code in a header's manual, and uses its variables."""
    point, made = "gabor_vec3" if name == "gabor_noise_3d" else "gabor_vec2", ""
    for number, part in enumerate(re.split(r"\n(?://)?\n", (HEADERS / f"{name}.hpp").read_text())):
        if lines := CODE.findall(part):
            code = re.sub(r"\bvec", "gabor_vec", "\n    ".join(lines))
            used = "".join(f"    use(&{variable});\n" for variable in ["normal", *re.findall(r"\w+ (\w+) = ", code)])
            made += f"void {name}_{number}({point} p, gabor_vec3 normal) {{\n    {code}\n{used}}}\n"
    return made


class Headers(unittest.TestCase):
    def check(self, compiler, *options):
        if not shutil.which(compiler):
            self.skipTest(f"{compiler} is not installed")
        windows = "#include <windows.h>\n" * (compiler == MINGW)
        for files in FILES:
            code = [examples(name) for name in files]
            self.assertNotIn("", code)
            text = f"{windows}{STANDARD}{MACROS}#define GABOR_DIRECTION(p) (p)\n" + "".join(f'#include "{name}.hpp"\n' for name in files)
            text += "void use(const void*);\ngabor_vec2 dFdx(gabor_vec2 p);\ngabor_vec2 dFdy(gabor_vec2 p);\n" + "".join(code)
            for version, whole in (("11", ["-c", "-O1"]), ("20", ["-fsyntax-only"])):  # GCC looks for unset variables with -O1
                with self.subTest(files[0], version=version), tempfile.TemporaryDirectory(prefix="gabor-") as folder:
                    for name, content in MICROSOFT.items():
                        (pathlib.Path(folder) / name).write_text(f"#pragma once\n{content}")
                    command = [compiler, f"-std=c++{version}", "-Wall", "-Wextra", "-Werror", "-I", HEADERS, *whole, *options, "-x", "c++", "-"]
                    result = subprocess.run(command, input=text, text=True, capture_output=True, cwd=folder)
                    self.assertEqual(result.returncode, 0, result.stderr)

    def test_gcc_12(self):
        self.check("g++-12")

    def test_gcc_13(self):
        self.check("g++-13")

    def test_gcc_14(self):
        self.check("g++-14")

    def test_clang(self):
        self.check("clang++")

    def test_mingw(self):
        self.check(MINGW)

    def test_clang_for_microsoft(self):
        self.check("clang++", "--target=x86_64-pc-windows-msvc", "-nostdinc++", "-isystem", ".")


if __name__ == "__main__":
    unittest.main()

"""Runs Metal as C++ on the CPU, since no Metal compiler is available. metal_stdlib in this folder replaces its library."""

import pathlib
import re
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def assigned(match):
    """Returns the assignment of a vector's components as a call."""
    vector, names, value = match.groups()
    return f"gabor_cpp_assign({', '.join(f'{vector}.{name}' for name in names)}, {value});"


def as_cpp(text):
    """Turns swizzles into calls, since C++ has none."""
    text = re.sub(r"([\w.\[\]+]+)\.([xyzw]{2,4}) ([-+*/])= ([^;]*);", r"\1.\2 = \1.\2 \3 (\4);", text)
    text = re.sub(r"([\w.\[\]]+)\.([xyzw]{2,3}) = ([^;]*);", assigned, text)
    return re.sub(r"\.([xyzw]{2,4})\b", r".\1()", text)


def is_gcc(compiler):
    return "Free Software Foundation" in subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout


def options(compiler):
    """Returns compiler options that make literals without a suffix single precision, as in Metal."""
    single = ["-fsingle-precision-constant"] if is_gcc(compiler) else ["-Xclang", "-cl-single-precision-constant"]
    return ["-std=c++20", *single, "-I", HERE, "-I", HERE.parents[1] / "shaders" / "translations"]

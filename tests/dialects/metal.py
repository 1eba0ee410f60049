"""Runs Metal as C++ on the CPU, since no Metal compiler is available. metal_stdlib in this folder replaces its library."""

import pathlib
import re
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def as_cpp(text):
    """Turns swizzles into calls, since C++ has none."""
    return re.sub(r"\.([xyzw]{2,4})\b", r".\1()", text)


def is_gcc(compiler):
    return "Free Software Foundation" in subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout


def options(compiler):
    """Returns compiler options that make literals without a suffix single precision, as in Metal."""
    single = ["-fsingle-precision-constant"] if is_gcc(compiler) else ["-Xclang", "-cl-single-precision-constant"]
    return ["-std=c++20", *single, "-I", HERE, "-I", HERE.parents[1] / "shaders" / "translations"]

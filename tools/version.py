"""The project's version, which CMakeLists.txt defines."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[1]
VERSION = re.search(r"project\(gabor-noise VERSION (\d+\.\d+\.\d+)", (ROOT / "CMakeLists.txt").read_text())[1]

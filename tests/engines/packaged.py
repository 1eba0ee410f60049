"""The files of a package, as its users get them."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]


def packaged(name, folder):
    """Writes the package's files to the folder, and returns it."""
    subprocess.run([sys.executable, "-B", ROOT / "tools" / "package", name, "--stage", folder], check=True)
    return pathlib.Path(folder)

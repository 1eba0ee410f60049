"""Godot in the system under ROOT: run.py ROOT VALUES.raw canvas|compute METHOD DRIVER"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
SHADERS = HERE.parents[2] / "shaders"
root, values, kind, method, driver = sys.argv[1:]
root = pathlib.Path(root)

with tempfile.TemporaryDirectory(prefix="gabor-", dir=root / "tmp") as folder:
    project = pathlib.Path(folder)
    shutil.copytree(HERE, project, dirs_exist_ok=True)
    shutil.copy(SHADERS / "gabor_noise.glsl", project)
    shutil.copy(SHADERS / "translations" / "gabor_noise.gdshaderinc", project)
    result = subprocess.run(
        ["chroot", root, "xvfb-run", "-a", "godot", "--path", f"/{project.relative_to(root)}", "--audio-driver",
         "Dummy", "--rendering-method", method, "--rendering-driver", driver, "--", "values.raw", kind],
        env={"PATH": "/usr/sbin:/usr/bin:/bin", "HOME": "/root"}, stdout=subprocess.PIPE, text=True, check=True)
    print(next(line for line in result.stdout.splitlines() if line.startswith("{")))
    shutil.copy(project / "values.raw", values)

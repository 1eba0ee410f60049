"""Runs Godot in the chroot ROOT: run.py ROOT canvas|node|compute METHOD DRIVER VALUES.raw DROP_IN [NAME=VALUE]
or, with a custom canvas shader, which may include all drop-ins: run.py ROOT canvas METHOD DRIVER VALUES.raw SHADER.gdshader"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent))
from scene import drop_in, packaged, printed  # noqa: E402

root, kind, method, driver, values, name, *macros = sys.argv[1:]
root = pathlib.Path(root)

with tempfile.TemporaryDirectory(prefix="gabor-", dir=root / "tmp") as folder:
    project = pathlib.Path(folder)
    shutil.copytree(HERE, project, dirs_exist_ok=True)
    packaged("godot", project)
    for path in pathlib.Path(printed("godot").name).iterdir():
        shutil.copy(path, project)
    if name.endswith(".gdshader"):
        shutil.copy(name, project / "noise.gdshader")
    else:
        for ending in ("glsl", "gdshaderinc"):
            (project / f"gabor_noise.{ending}").write_text(drop_in(name, macros, ending))
    result = subprocess.run(
        ["chroot", root, "xvfb-run", "-a", "godot", "--path", f"/{project.relative_to(root)}", "--audio-driver",
         "Dummy", "--rendering-method", method, "--rendering-driver", driver, "--", "values.raw", kind],
        env={"PATH": "/usr/sbin:/usr/bin:/bin", "HOME": "/root"}, stdout=subprocess.PIPE, text=True, check=True)
    print(next(line for line in result.stdout.splitlines() if line.startswith("{")))
    shutil.copy(project / "values.raw", values)

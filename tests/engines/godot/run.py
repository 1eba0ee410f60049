"""Runs Godot in the chroot ROOT: run.py ROOT canvas|node|compute METHOD DRIVER VALUES.raw DROP_IN [NAME=VALUE]
or, with a custom canvas shader, which may include all drop-ins: run.py ROOT canvas METHOD DRIVER VALUES.raw SHADER.gdshader"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(str(HERE.parent))
from packaged import packaged  # noqa: E402

SHADERS = HERE.parents[2] / "shaders"
root, kind, method, driver, values, drop_in, *macros = sys.argv[1:]
root = pathlib.Path(root)

with tempfile.TemporaryDirectory(prefix="gabor-", dir=root / "tmp") as folder:
    project = pathlib.Path(folder)
    shutil.copytree(HERE, project, dirs_exist_ok=True)
    packaged("godot", project)
    defines = "".join(f"#define {macro.replace('=', ' ')}\n" for macro in macros)
    for path in (SHADERS / "translations").glob("*.gdshaderinc"):
        shutil.copy(path, project)
    if drop_in.endswith(".gdshader"):
        shutil.copy(drop_in, project / "noise.gdshader")
    else:
        for path in (SHADERS / f"{drop_in}.glsl", SHADERS / "translations" / f"{drop_in}.gdshaderinc"):
            (project / f"gabor_noise{path.suffix}").write_text(defines + path.read_text())
    result = subprocess.run(
        ["chroot", root, "xvfb-run", "-a", "godot", "--path", f"/{project.relative_to(root)}", "--audio-driver",
         "Dummy", "--rendering-method", method, "--rendering-driver", driver, "--", "values.raw", kind],
        env={"PATH": "/usr/sbin:/usr/bin:/bin", "HOME": "/root"}, stdout=subprocess.PIPE, text=True, check=True)
    print(next(line for line in result.stdout.splitlines() if line.startswith("{")))
    shutil.copy(project / "values.raw", values)

"""Checks that tools/cluster, without Snakemake, Slurm or openjd, cuts a picture that is not square into parts that make up the
whole. tools/test-long farm runs them with these."""

import os
import pathlib
import re
import subprocess
import sys
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from program import PROGRAM, ProgramTest  # noqa: E402

CLUSTER = ROOT / "tools" / "cluster"
OPTIONS = "--scale=8", "--seed=3"
# Runs each task of an array at once.
SBATCH = """#!/bin/sh
script=$(cat) last=1
for word; do case $word in --array=1-*) last=${word#--array=1-};; esac; done
for k in $(seq $last); do SLURM_ARRAY_TASK_ID=$k sh -c "$script" >&2; done
echo 1
"""


class Scripts(ProgramTest):
    def assert_whole(self):
        self.succeed("render", "--size=48x31", *OPTIONS, "-o", "one.exr")
        self.assertEqual((self.folder / "grain.exr").read_bytes(), (self.folder / "one.exr").read_bytes())

    def test_an_array(self):
        for name, text in ("sbatch", SBATCH), ("squeue", "#!/bin/sh\n"):
            (self.folder / name).write_text(text)
            (self.folder / name).chmod(0o755)
        subprocess.run([CLUSTER / "array", "48x31", "2", "grain.exr", *OPTIONS], cwd=self.folder, check=True,
                       env=os.environ | {"GABOR": PROGRAM, "PATH": f"{self.folder}:{os.environ['PATH']}"})
        self.assert_whole()

    def test_an_open_job_description(self):
        scripts = re.findall(r"data: \|\n((?: {12}.*\n)+)", (CLUSTER / "picture.openjd.yaml").read_text())
        self.assertEqual(len(scripts), 2)
        given = {"Param.Gabor": PROGRAM, "Param.Size": "48x31", "Param.Options": " ".join(OPTIONS), "Param.Strips": "2",
                 "Param.Folder": str(self.folder), "Param.Output": "grain.exr"}
        for text, task in [*((scripts[0], k) for k in (1, 2)), (scripts[1], 0)]:
            script = re.sub(r"\{\{(.*?)\}\}", lambda match: (given | {"Task.Param.Strip": str(task)})[match[1]], text)
            subprocess.run(["sh", "-c", script], cwd=self.folder, check=True, stdout=subprocess.DEVNULL)
        self.assert_whole()

    def test_strips_and_tiles_of_snakemake(self):
        text = (CLUSTER / "Snakefile").read_text()
        names: dict = {}
        exec(text[text.index("def sides"):text.index("def strips_of")], names)
        for level in 0, 1:
            regions = [names["strip"]({"size": "48x31", "strips": 8}, k, level).split(",") for k in range(1, 1 + (8 >> 2 * level))]
            rows = [row for x, y, width, height in regions for row in range(int(y), int(y) + int(height)) if (x, width) == ("0", str(48 >> level))]
            self.assertEqual(rows, list(range(31 >> level)))
        times = re.findall(r"time=lambda wildcards: (.*),\n", text)
        self.assertEqual([eval(times[0], {"FRAMES": {"a": {"frames": 4}}, "wildcards": types.SimpleNamespace(name="a", k=f"{k:04}")})
                          for k in (1, 2, 4)], [0, 0.25, 0.75])
        for v in range(3):  # from the bottom
            for u in range(2):
                options = names["tile"]({"size": "24x10", "across": 2, "down": 3}, 1001 + u + 10 * v)
                self.assertEqual(options.split()[0], "--size=48x30")
                x, y, width, height = map(int, re.search(r"--region=(.*)", options)[1].split(","))
                self.assertEqual((x, y, width, height), (24 * u, 10 * (2 - v), 24, 10))


if __name__ == "__main__":
    unittest.main()

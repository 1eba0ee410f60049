"""Checks that tools/cluster, without Snakemake, Slurm or openjd, cuts a picture that is not square into parts that make up the
whole. tools/test-long farm runs them with these."""

import fcntl
import os
import pathlib
import re
import shutil
import subprocess
import sys
import types
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from program import PROGRAM, ProgramTest  # noqa: E402

CLUSTER = ROOT / "tools" / "cluster"
OPTIONS = "--scale=8", "--seed=3"
TEXT = (CLUSTER / "Snakefile").read_text()
# Runs each task of an array at once.
SBATCH = """script=$(cat) last=1
for word; do case $word in --array=1-*) last=${word#--array=1-};; esac; done
for k in $(seq $last); do SLURM_ARRAY_TASK_ID=$k sh -c "$script" >&2; done
echo 1
"""


class Scripts(ProgramTest):
    def assert_whole(self):
        self.succeed("render", "--size=48x31", *OPTIONS, "-o", "one.exr")
        self.assertEqual((self.folder / "grain.exr").read_bytes(), (self.folder / "one.exr").read_bytes())

    def test_an_array(self):
        self.script("sbatch", SBATCH)
        self.script("squeue", "")
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

    def script(self, name, text):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f"#!/bin/sh\n{text}\n")
        path.chmod(0o755)

    def test_run_cancels_old_jobs_and_starts_snakemake(self):
        run = self.folder / "tools" / "cluster" / "run"
        run.parent.mkdir(parents=True)
        shutil.copy(CLUSTER / "run", run)
        uuid = "01234567-89ab-cdef-0123-456789abcdef"
        self.script("build/cluster/bin/snakemake", f'echo "$@" >> {self.folder}/said')
        self.script("bin/squeue", f"[ -e cancelled ] || printf '%s\\n' '1 |{uuid} |{self.folder} ' '2 |{uuid} |/elsewhere ' '3 |mine |{self.folder} '")
        self.script("bin/scancel", 'echo cancel "$@" >> said; touch cancelled')
        for options, more in ((), "--cores all"), (("-j4",), "-j4"), (("--executor", "slurm", "--jobs", "9"), "--executor slurm --jobs 9"):
            (self.folder / "said").unlink(missing_ok=True)
            subprocess.run([sys.executable, run, "farm.yaml", *options], cwd=self.folder, check=True, stdout=subprocess.DEVNULL,
                           env=os.environ | {"PATH": f"{self.folder}/bin:{os.environ['PATH']}"})
            common = f"--snakefile {self.folder}/tools/cluster/Snakefile --configfile farm.yaml"
            self.assertEqual((self.folder / "said").read_text().splitlines(), ["cancel 1"] * ("slurm" in options) + [
                f"{common} --unlock", f"{common} --ignore-incomplete --keep-incomplete {more}"])
        with open(self.folder / ".farm.lock") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            refused = subprocess.run([sys.executable, run, "farm.yaml"], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual((refused.returncode, refused.stderr), (1, "run: another run is under way in this folder\n"))

    def test_snakemake(self):
        """Runs the shell command of each task, as Snakemake would: a rule makes a target if its pattern matches."""
        rules = re.sub(r"(?m)^rule (\w+):", r"class rule_\1(Rule):", re.sub(r"(?m)^( +)(input|output|threads|group):", r"\1\2 =", TEXT))
        rules = re.sub(r'(?m)^    shell:((?: +".*"\n)+)', r"    shell = (\1)\n", rules)
        rules = re.sub(r"(?m)^( *)(params|wildcard_constraints):((?:\n\1    .*)+)", r"\1\2 = dict(\3)", rules)
        rules = re.sub(r"(?m)^( *)wildcard_constraints: (.*)", r"\1wildcard_constraints = dict(\2)", rules).replace("localrules: all", "")
        made = []

        class Rule:
            input, group, threads, params, wildcard_constraints = [], "", 1, {}, {}

            def __init_subclass__(cls):
                made.append(cls)
        configuration = {"gabor": PROGRAM, "gabor-lab": "echo", "threads": 3,
                         "pictures": {"grain": {"size": "48x31", "strips": 2, "options": " ".join(OPTIONS)}},
                         "textures": {"bark": {"size": "64x32", "strips": 4, "half": True, "options": "--tileable --scale=8"}},
                         "frames": {"water": {"size": "16x8", "frames": 2, "options": " ".join(OPTIONS)},
                                    "sea": {"size": "16x8", "frames": 2, "seconds": 16, "options": "--view=ocean --loop-seconds=16"}},
                         "udims": {"skin": {"size": "8x4", "across": 3, "down": 2, "options": " ".join(OPTIONS)}},
                         "studies": {"paper": {"figures": ["figure1"], "quick": True}}}
        names = {"config": configuration, "Rule": Rule, "temp": lambda name: name, "touch": lambda name: name, "__name__": "Snakefile"}
        exec(rules, names)
        said, done = [], set()

        def make(target):
            if target in done:
                return
            done.add(target)
            for rule in made[1:]:
                limits = names["wildcard_constraints"] | rule.wildcard_constraints
                pattern = re.sub(r"\\{(\w+)\\}", lambda match: f"(?P<{match[1]}>{limits.get(match[1], '.+')})", re.escape(rule.output))
                if found := re.fullmatch(pattern, target):
                    break
            wildcards = types.SimpleNamespace(**found.groupdict())
            inputs = rule.input(wildcards) if callable(rule.input) else rule.input
            for each in inputs:
                make(each)
            params = types.SimpleNamespace(**{name: value(wildcards) for name, value in rule.params.items()})
            given = {"GABOR": names["GABOR"], "LAB": names["LAB"], "threads": rule.threads, "params": params, "wildcards": wildcards,
                     "input": " ".join(inputs), "output": target}
            lists = {name: " ".join(map(str, value)) for name, value in vars(params).items() if isinstance(value, list)}
            vars(params).update(lists)
            command = rule.shell.format(**given)
            if rule.group:
                said.append(rule.group)
            (self.folder / target).parent.mkdir(exist_ok=True)
            result = subprocess.run(["sh", "-c", command], cwd=self.folder, check=True, stdout=subprocess.PIPE, text=True,
                                    env=os.environ | {"TMPDIR": str(self.folder)})
            if "study" in command:
                said.append(result.stdout.strip())
            self.assertEqual("LP_NUM_THREADS=3" in command, " join {" not in rule.shell or "mktemp" in rule.shell, command)
        self.assertEqual(made[0].input, names["TARGETS"])
        for target in names["TARGETS"]:
            make(target)
        self.assertEqual(said, ["frames"] * 4 + ["study figure1 --quick -o paper"])
        self.assert_whole()
        (self.folder / "one").mkdir()
        self.succeed("texture", "--half", "--size=64x32", "--tileable", "--scale=8", "-o", "one/bark.exr")
        self.succeed("render", "--size=16x8", *OPTIONS, "--frames=2", "-o", "one/water.exr")
        self.succeed("render", "--size=16x8", "--view=ocean", "--loop-seconds=16", "--frames=2", "-o", "one/sea.exr")
        for number, place in {1001: "0,4", 1002: "8,4", 1003: "16,4", 1011: "0,0", 1012: "8,0", 1013: "16,0"}.items():
            self.succeed("texture", "--size=24x8", *OPTIONS, f"--region={place},8,4", "-o", f"one/skin.{number}.exr")
        for path in (self.folder / "one").iterdir():
            self.assertEqual((self.folder / path.name).read_bytes(), path.read_bytes(), path.name)
        self.assertEqual(len(list((self.folder / "one").iterdir())), 1 + 4 + 6)
        self.assertEqual(len(done), (2 + 1) + (4 + 1 + 1) + 4 + 6 + 1)


if __name__ == "__main__":
    unittest.main()

"""Checks that tools/cluster, on this machine and on a real Slurm, writes the same bytes as a single run, runs nothing
twice and leaves no job behind.

tools/test-long farm runs this file, which also prints times; GABOR_PROGRAM and GABOR_LAB are the programs.
"""

import collections
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

import slurm

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from program import PROGRAM, ProgramTest  # noqa: E402

LAB = os.environ["GABOR_LAB"]
CLUSTER = ROOT / "tools" / "cluster"
OPENJD = ROOT / "build" / "cluster" / "bin" / "openjd"
SLURM = ["--executor", "slurm", "--jobs", "20", "--default-resources", "slurm_partition=farm", "mem_mb=200", "runtime=30",
         "--slurm-status-command", "squeue", "--slurm-init-seconds-before-status-checks", "5", "--latency-wait", "30",
         "--retries", "2"]
OPTIONS = "--scale=8 --frequency=1.5 --orientation-spread=90 --seed=7"
CONFIGURATION = f"""
gabor: {{gabor}}
gabor-lab: {{lab}}
pictures: {{{{grain: {{{{size: 600x500, strips: 4, options: {OPTIONS}}}}}}}}}
textures: {{{{bark: {{{{size: 128x128, strips: 5, half: true, options: --tileable --scale=8}}}}}}}}
frames: {{{{water: {{{{size: 64x64, frames: 2, options: {OPTIONS}}}}}}}}}
udims: {{{{skin: {{{{size: 64x64, across: 1, down: 2, options: {OPTIONS}}}}}}}}}
studies: {{{{paper: {{{{figures: [figure1, figure4], quick: true}}}}}}}}
"""
TASKS = (4 + 1) + (5 + 1 + 6 + 1) + 2 + 2 + 2


class FarmTest(ProgramTest):
    """Wraps the programs in scripts that log each request when it begins and when it succeeds."""

    def setUp(self):
        super().setUp()
        self.list = self.folder / "list.txt"
        self.list.touch()
        self.gabor, lab = self.listed(PROGRAM), self.listed(LAB)
        (self.folder / "farm.yaml").write_text(CONFIGURATION.format(gabor=self.gabor, lab=lab))

    def listed(self, program):
        script = self.folder / pathlib.Path(program).name
        script.write_text(f"#!/bin/sh\necho \"begin $*\" >>{self.list}\nsleep ${{DELAY:-0}}\n{program} \"$@\" || exit $?\n"
                          f"echo \"end $*\" >>{self.list}\n")
        script.chmod(0o755)
        return script

    def begun(self, word="begin"):
        return [line.split(" ", 1)[1] for line in self.list.read_text().splitlines() if line.startswith(word)]

    def ended(self):
        return self.begun("end")

    def start(self, *options, delay=0):
        self.log = open(self.folder / "run.log", "a")
        self.addCleanup(self.log.close)
        return subprocess.Popen([CLUSTER / "run", "farm.yaml", *options], cwd=self.folder, stdout=self.log, stderr=self.log,
                                start_new_session=True, env=os.environ | {"DELAY": str(delay)})

    def wait(self, run, condition):
        def met():
            self.assertIsNone(run.poll(), (self.folder / "run.log").read_text()[-5000:])
            return condition()
        slurm.wait_for(met, 1200)

    def finish(self, run):
        self.assertEqual(run.wait(1800), 0, (self.folder / "run.log").read_text()[-5000:])

    def assert_as_on_one_machine(self):
        (self.folder / "one").mkdir()
        options = OPTIONS.split()
        self.succeed("render", "--size=600x500", *options, "-o", "one/grain.exr")
        self.succeed("texture", "--half", "--size=128x128", "--scale=8", "--tileable", "-o", "one/bark.exr")
        self.succeed("render", "--size=64x64", *options, "--frames=2", "-o", "one/water.exr")
        for number, y in ((1001, 64), (1011, 0)):
            self.succeed("texture", "--size=64x128", *options, f"--region=0,{y},64,64", "-o",
                         f"one/skin.{number}.exr")
        for figure in ("figure1", "figure4"):
            self.succeed("study", figure, "--quick", "-o", "one/paper", command=(LAB,))
        files = self.files()
        whole = [name for name, content in files.items() if name.startswith("one/") and content is not None]
        self.assertEqual(len(whole), 1 + 1 + 2 + 2 + 4)
        for name in whole:
            self.assertEqual(files[name.removeprefix("one/")], files[name], name)
        self.assertEqual([name for name in files if name.startswith("strips/")], [], "strips are left after the join")

    def assert_grain_as_on_one_machine(self):
        self.succeed("render", "--size=512x800", "--scale=8", "--seed=3", "-o", "one.exr")
        files = self.files()
        self.assertEqual(files["grain.exr"], files["one.exr"])
        self.assertEqual([name for name in files if "strips." in name or name.startswith("grain.exr.")], [], "strips are left")

    def assert_nothing_done_twice(self, but=0):
        """Checks that no task ran twice, except at most `but` tasks of cancelled jobs, which may finish unrecorded."""
        counts = collections.Counter(self.ended())
        self.assertLessEqual(sum(counts.values()) - len(counts), but, counts)
        self.assertEqual(len(set(self.begun())), TASKS)


class Local(FarmTest):
    def test_one_machine_killed_and_resumed(self):
        run = self.start("--cores", "2", delay=0.5)
        self.wait(run, lambda: len(self.ended()) >= 5)
        second = subprocess.run([CLUSTER / "run", "farm.yaml"], cwd=self.folder, stderr=subprocess.PIPE, text=True)
        self.assertEqual((second.returncode, second.stderr), (1, "run: another run is under way in this folder\n"))
        os.killpg(run.pid, signal.SIGKILL)
        run.wait()
        self.finish(self.start("--cores", "2"))
        self.assert_as_on_one_machine()
        self.assert_nothing_done_twice()
        before = self.begun()
        self.finish(self.start("--cores", "2"))
        self.assertEqual(self.begun(), before, "a second run must have nothing to do")


@unittest.skipIf(slurm.missing(), slurm.missing())
class Slurm(FarmTest):
    def setUp(self):
        super().setUp()
        cluster = slurm.cluster(self.folder / "slurm")
        cluster.__enter__()
        self.addCleanup(cluster.__exit__, None, None, None)

    def test_a_job_cancelled_and_snakemake_killed(self):
        run = self.start(*SLURM, delay=2)
        self.wait(run, lambda: len(self.ended()) >= 2 and slurm.jobs("RUNNING"))
        cancelled = slurm.jobs("RUNNING")[0]
        subprocess.run(["scancel", cancelled], check=True)
        ended = len(self.ended())
        self.wait(run, lambda: len(self.ended()) >= ended + 3 and len(slurm.jobs()) > 1)
        run.kill()
        run.wait()
        left = slurm.jobs()
        self.assertGreater(len(left), 0, "jobs must outlive Snakemake")
        began = time.monotonic()
        self.finish(self.start(*SLURM))
        print(f"Slurm: {len(left)} jobs were left by the killed run; the rest took {time.monotonic() - began:.0f} s")
        self.assertEqual(slurm.jobs(), [])
        self.assertIn("cancelling", (self.folder / "run.log").read_text())
        self.assert_as_on_one_machine()
        self.assert_nothing_done_twice(but=1)

    def test_a_plain_array(self):
        began = time.monotonic()
        subprocess.run([CLUSTER / "array", "512x800", "16", "grain.exr", "--scale=8", "--seed=3"], cwd=self.folder, check=True,
                       env=os.environ | {"GABOR": str(self.gabor)}, timeout=900)
        print(f"Slurm: an array of 16 strips and the join took {time.monotonic() - began:.1f} s")
        self.assertEqual(len(self.ended()), 17)
        self.assert_grain_as_on_one_machine()

    def test_a_plain_array_that_fails(self):
        failed = subprocess.run([CLUSTER / "array", "512x800", "2", "grain.exr", "--scale=1"], cwd=self.folder,
                                stderr=subprocess.PIPE, text=True, env=os.environ | {"GABOR": str(self.gabor)}, timeout=900)
        self.assertEqual(failed.returncode, 1)
        self.assertIn("scale", failed.stderr)
        self.assertFalse((self.folder / "grain.exr").exists())
        self.assertEqual(slurm.jobs(), [])


@unittest.skipUnless(OPENJD.exists(), "needs openjd in build/cluster: pip install openjd-cli")
class OpenJobDescription(FarmTest):
    def test_a_template(self):
        subprocess.run([OPENJD, "check", CLUSTER / "picture.openjd.yaml"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([OPENJD, "run", CLUSTER / "picture.openjd.yaml", "-p", "Size=512x800", "-p", "Output=grain.exr", "-p",
                        "Options=--scale=8 --seed=3", "-p", "Strips=4", "-p", f"Gabor={self.gabor}", "-p",
                        f"Folder={self.folder}"], check=True, stdout=subprocess.DEVNULL, timeout=900)
        self.assertEqual(len(self.ended()), 5)
        self.assert_grain_as_on_one_machine()


if __name__ == "__main__":
    unittest.main()

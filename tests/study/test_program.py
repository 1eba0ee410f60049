"""`gabor-lab study` and `tools/plot` from outside."""

import csv
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, gabor, start  # noqa: E402

PLOT = pathlib.Path(__file__).parents[2] / "tools" / "plot"
POINTS = {"poisson", "stratified", "jittered", "jittered_hex", "sobol", "scrambled_sobol"}


def interrupt(how, folder, journal, *arguments):
    """Starts the program and ends it once its journal has some rows. Returns its status, and what it had written."""
    process = start(*arguments, cwd=folder)
    path = folder / journal
    while process.poll() is None and (not path.exists() or path.read_text().count("\n") < 4):
        time.sleep(0.01)
    process.send_signal(how)
    process.communicate()
    return process.returncode, path.read_text()


class StudyTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """The study of the law, by a run that is interrupted and goes on."""
        folder = tempfile.TemporaryDirectory(prefix="gabor-")
        cls.addClassCleanup(folder.cleanup)
        cls.law = pathlib.Path(folder.name)
        cls.interrupted, cls.kept = interrupt(signal.SIGINT, cls.law, "study.part", "study", "law", "--quick", "-o", ".")
        cls.files_of_interrupted = {path.name for path in cls.law.iterdir()}
        result = gabor("study", "law", "--quick", "-o", ".", cwd=cls.law)
        assert (result.returncode, result.stderr) == (0, ""), result

    def table(self, name):
        with open(self.folder / f"{name}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_tables_have_the_promised_columns_and_the_papers_numbers(self):
        self.succeed("study", "figure3", "--quick", "-o", ".")
        rows = self.table("figure3")
        self.assertLessEqual({"points", "weights", "kernel", "envelope", "N", "samples", "cvm", "cvm_low", "cvm_high",
                              "n_star"}, set(rows[0]))
        self.assertEqual({row["points"] for row in rows}, POINTS)
        self.assertEqual({row["weights"] for row in rows}, {"uniform", "bernoulli"})
        seminal = {int(row["N"]): row for row in rows if (row["points"], row["weights"]) == ("poisson", "uniform")}
        self.assertLess(float(seminal[4]["cvm_low"]), 39.3)
        self.assertGreater(float(seminal[4]["cvm_high"]), 39.3)
        self.assertAlmostEqual(float(seminal[10]["n_star"]), 10, places=4)
        self.assertEqual(set(self.files()), {"figure3.csv"})

    def test_pictures_and_plots(self):
        for name in ("figure1", "figure6"):
            self.succeed("study", name, "--quick", "-o", ".")
        self.assertEqual(set(self.files()), {"figure1.csv", "figure6.csv", "figure6_pair.png", "figure6_seminal.exr",
                                             "figure6_recommended.exr"})
        subprocess.run([PLOT, self.folder], check=True, stdout=subprocess.DEVNULL, timeout=120)
        for name in ("figure1.png", "figure6.png"):
            self.assertGreater((self.folder / name).stat().st_size, 10000)

        # Its one row is measured in pieces by two parts; only times are never the same.
        for part in (1, 2):
            self.succeed("study", "figure6", "--quick", "-o", "parts", f"--part={part}/2")
            self.assertIn(" piece ", (self.folder / f"parts/study.{part}-of-2.rows").read_text())
        self.succeed("merge", "parts/study.1-of-2.rows", "parts/study.2-of-2.rows", "-o", "merged")
        one_run, merged = ({name: value for name, value in self.table(table)[0].items()
                            if not name.startswith(("seconds", "time"))} for table in ("figure6", "merged/figure6"))
        self.assertEqual(len(merged), 10)
        self.assertEqual(merged, one_run)

    def test_the_law_at_places_and_of_pairs(self):
        shutil.copytree(self.law, self.folder, dirs_exist_ok=True)
        noises = {"seminal", "advice", "paper", "one", "pure", "lattice_2", "lattice_3", "lattice_4"}
        counts = {"law_places": 64, "law": 1, "law_pairs": 10, "law_covariance": 9, "law_spectra": 1}
        for name, count in counts.items():
            rows = self.table(name)
            self.assertEqual({row["noise"] for row in rows}, noises)
            self.assertEqual(len(rows), count * len(noises))
        summaries = {row["noise"]: row for row in self.table("law")}
        for noise in noises:
            places = [float(row["cvm"]) for row in self.table("law_places") if row["noise"] == noise]
            self.assertAlmostEqual(float(summaries[noise]["cvm_worst"]), max(places), places=3)
        # What pooling hides: at places the sparse noise is far from normal, and the lattice is not.
        self.assertGreater(float(summaries["one"]["cvm_mean"]), 5)
        self.assertLess(float(summaries["lattice_3"]["cvm_mean"]), 5)
        # Theory's largest differences at these lags, and what the sparse noises have.
        theory = {noise: max(float(row["rms_theory"]) for row in self.table("law_covariance") if row["noise"] == noise)
                  for noise in noises}
        self.assertGreater(theory["lattice_2"], 0.15)
        self.assertAlmostEqual(theory["lattice_3"], 0.040, delta=0.004)
        self.assertAlmostEqual(theory["lattice_4"], 0.0103, delta=0.001)
        self.assertEqual(theory["one"], 0)
        spectra = {row["noise"]: row for row in self.table("law_spectra")}
        self.assertGreater(float(spectra["one"]["fourth_power"]), 5)
        self.assertLess(float(spectra["lattice_3"]["fourth_power"]), 2.5)
        self.assertEqual(set(self.files()), {"law_noises.png"} | {f"{name}.csv" for name in counts})
        subprocess.run([PLOT, self.folder], check=True, stdout=subprocess.DEVNULL, timeout=120)
        for name in counts:
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000)

    def test_an_interrupted_study_keeps_its_rows(self):
        self.assertEqual(self.interrupted, -signal.SIGINT)
        self.assertEqual(self.files_of_interrupted, {"study.part"})
        self.assertGreater(self.kept.count("\n"), 3)
        self.assertFalse((self.law / "study.part").exists())

    def test_parts_merge_into_the_tables_of_one_run(self):
        """Parts, of which one was killed and went on, as one run, which was interrupted and went on."""
        law_part = "study", "law", "--quick", "-o", "law.parts", "--part=3/3"
        _, kept = interrupt(signal.SIGKILL, self.folder, "law.parts/study.3-of-3.part", *law_part)
        self.succeed(*law_part)
        self.assertFalse((self.folder / "law.parts/study.3-of-3.part").exists())
        self.assertLess(set(kept.splitlines()[:3]), set((self.folder / "law.parts/study.3-of-3.rows").read_text().splitlines()))
        # law has tables whose last columns need all rows of themselves and of another; figure1 rows that cost nothing.
        shutil.copytree(self.law, self.folder / "law.whole")
        self.succeed("study", "figure1", "--quick", "-o", "figure1.whole")
        for name, count in (("law", 3), ("figure1", 7)):
            for part in range(count, 0, -1):
                self.succeed("study", name, "--quick", "-o", f"{name}.parts", f"--part={part}/{count}")
            parts = [f"{name}.parts/study.{part}-of-{count}.rows" for part in range(1, count + 1)]
            rows = [len((self.folder / part).read_text().splitlines()) - 1 for part in parts]
            self.assertGreater(min(rows), 0, "no part is idle")
            self.succeed("merge", *parts[1:], parts[0], "-o", f"{name}.merged")
            files = self.files()
            whole = [path for path in files if re.fullmatch(rf"{name}.whole/.*\.csv", path)]
            self.assertGreater(len(whole), 0)
            for path in whole:
                self.assertEqual(files[path.replace("whole", "merged")], files[path], path)

        part = self.folder / "figure1.parts" / "study.2-of-7.rows"
        before = part.stat().st_mtime_ns
        self.succeed("study", "figure1", "--quick", "-o", "figure1.parts", "--part=2/7")
        self.assertEqual(part.stat().st_mtime_ns, before, "a complete part is not measured again")
        shutil.copy(part, self.folder / "again.rows")
        self.assert_refused(["part 1 of 7 is missing"], "merge", *parts[1:], "-o", "new")
        self.assert_refused(["study.2-of-7.rows", "again.rows", "the same part"], "merge", *parts, "again.rows", "-o", "new")
        self.assert_refused(["law", "figure1"], "merge", *parts[1:], "law.parts/study.1-of-3.rows", "-o", "new")
        self.assert_refused(["nothing.rows", "no complete part"], "merge", "nothing.rows", "-o", "new")
        part.write_text(part.read_text().replace("llvmpipe", "another").replace("SwiftShader", "another"))
        self.assert_refused(["another"], "merge", *parts, "-o", "new")
        part.write_text("\n".join((self.folder / "again.rows").read_text().splitlines()[:-1]) + "\n")
        self.assert_refused(["no part has the row"], "merge", *parts, "-o", "figure1.merged")

    def test_wrong_requests(self):
        for part in ("0/4", "5/4", "1/0", "-1/4", "1", "1/", "/4", "1/4x", "a/b", "1/10000"):
            self.assert_refused(["--part", "K/N"], "study", "figure1", "-o", "new", f"--part={part}")
        self.assert_refused(["figure7", "figure1", "future", "all"], "study", "figure7", "-o", ".")
        self.assert_refused(["--output"], "study", "figure1")
        (self.folder / "file").write_text("")
        self.assert_refused(["'file/below'"], "study", "figure1", "-o", "file/below")
        plot = subprocess.run([PLOT, self.folder], stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual((plot.returncode, plot.stderr.count("\n")), (2, 1))


if __name__ == "__main__":
    unittest.main()

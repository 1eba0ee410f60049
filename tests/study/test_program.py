"""`gabor study` and `tools/plot` from outside."""

import csv
import os
import pathlib
import signal
import subprocess
import sys
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, start  # noqa: E402

PLOT = pathlib.Path(__file__).parents[2] / "tools" / "plot"
POINTS = {"poisson", "stratified", "jittered", "jittered_hex", "sobol", "scrambled_sobol"}


class StudyTest(ProgramTest):
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

    def test_the_law_at_places_and_of_pairs(self):
        self.succeed("study", "law", "--quick", "-o", ".")
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

    def test_an_interrupted_study_goes_on_where_it_was(self):
        self.succeed("study", "figure4", "--quick", "-o", "whole")
        process = start("study", "figure4", "--quick", "-o", "broken", cwd=self.folder)
        part = self.folder / "broken" / "study.part"
        while not part.exists() or part.read_text().count("\n") < 4:
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.communicate()
        self.assertEqual(process.returncode, -signal.SIGINT)
        self.assertFalse((self.folder / "broken" / "figure4.csv").exists())
        kept = part.read_text()
        self.succeed("study", "figure4", "--quick", "-o", "broken")
        files = self.files()
        self.assertGreater(kept.count("\n"), 3)
        self.assertEqual(files[os.path.join("broken", "figure4.csv")], files[os.path.join("whole", "figure4.csv")])
        self.assertNotIn(os.path.join("broken", "study.part"), files)

    def test_wrong_requests(self):
        self.assert_refused(["figure7", "figure1", "future", "all"], "study", "figure7", "-o", ".")
        self.assert_refused(["--output"], "study", "figure1")
        (self.folder / "file").write_text("")
        self.assert_refused(["'file/below'"], "study", "figure1", "-o", "file/below")
        plot = subprocess.run([PLOT, self.folder], stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual((plot.returncode, plot.stderr.count("\n")), (2, 1))


if __name__ == "__main__":
    unittest.main()

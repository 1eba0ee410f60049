"""Tests `gabor-lab study` and `tools/plot` from outside."""

import csv
import json
import pathlib
import shutil
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, gabor, start  # noqa: E402

PLOT = pathlib.Path(__file__).parents[2] / "tools" / "plot"
POINTS = {"poisson", "stratified", "jittered", "jittered_hex", "sobol", "scrambled_sobol"}


class StudyTest(ProgramTest):
    @classmethod
    def setUpClass(cls):
        """Runs the study `law` twice: the first run is interrupted after its first table, the second resumes it."""
        cls.law = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        process = start("study", "law", "--quick", "-o", ".", cwd=cls.law)
        while process.poll() is None and not (cls.law / "law_places.json").exists():
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        process.communicate()
        cls.interrupted = process.returncode
        cls.first_table = (cls.law / "law_places.csv").stat().st_mtime_ns
        result = gabor("study", "law", "--quick", "-o", ".", cwd=cls.law)
        assert (result.returncode, result.stderr) == (0, ""), result

    def table(self, name):
        with open(self.folder / f"{name}.csv", newline="") as file:
            return list(csv.DictReader(file))

    def test_tables_have_the_documented_columns_and_the_papers_numbers(self):
        self.assertIn("tools/plot . draws the tables", self.succeed("study", "figure3", "--quick", "-o", "."))
        rows = self.table("figure3")
        self.assertLessEqual({"points", "weights", "kernel", "envelope", "N", "samples", "cvm", "cvm_low", "cvm_high",
                              "n_star"}, set(rows[0]))
        self.assertEqual({row["points"] for row in rows}, POINTS)
        self.assertEqual({row["weights"] for row in rows}, {"uniform", "bernoulli"})
        seminal = {int(row["N"]): row for row in rows if (row["points"], row["weights"]) == ("poisson", "uniform")}
        self.assertLess(float(seminal[4]["cvm_low"]), 39.3)
        self.assertGreater(float(seminal[4]["cvm_high"]), 39.3)
        self.assertAlmostEqual(float(seminal[10]["n_star"]), 10, places=4)
        self.assertEqual(set(self.files()), {"figure3.csv", "figure3.json"})

    def test_figures_have_pictures_and_plots(self):
        for name in ("figure1", "figure6"):
            self.succeed("study", name, "--quick", "-o", ".")
        self.assertEqual(set(self.files()), {"figure1.csv", "figure1.json", "figure6.csv", "figure6.json", "figure6_pair.png",
                                             "figure6_seminal.exr", "figure6_recommended.exr"})
        shutil.copytree(self.law, self.folder, dirs_exist_ok=True)
        subprocess.run([PLOT, self.folder], check=True, stdout=subprocess.DEVNULL, timeout=120)
        for name in ("figure1", "figure6", "law_places", "law", "law_pairs", "law_covariance", "law_spectra"):
            self.assertGreater((self.folder / f"{name}.png").stat().st_size, 10000)

    def test_law_measures_places_pairs_covariance_and_spectra(self):
        shutil.copytree(self.law, self.folder, dirs_exist_ok=True)
        noises = {"seminal", "advice", "paper", "one", "pure", "lattice_2", "lattice_3", "lattice_4"}
        counts = {"law_places": 64, "law": 1, "law_pairs": 10, "law_covariance": 9, "law_spectra": 1}
        for name, count in counts.items():
            rows = self.table(name)
            self.assertEqual({row["noise"] for row in rows}, noises)
            self.assertEqual(len(rows), count * len(noises))
        # At some points of a cell, the sparse noise is far from normal, which averages hide. The lattice is normal everywhere.
        mean = {noise: statistics.mean(float(row["cvm"]) for row in self.table("law_places") if row["noise"] == noise)
                for noise in noises}
        self.assertGreater(mean["one"], 5)
        self.assertLess(mean["lattice_3"], 5)
        # By theory, the rms variation of the covariance over a cell, at the worst of these lags; 0 for the sparse noises.
        theory = {noise: max(float(row["rms_theory"]) for row in self.table("law_covariance") if row["noise"] == noise)
                  for noise in noises}
        self.assertGreater(theory["lattice_2"], 0.15)
        self.assertAlmostEqual(theory["lattice_3"], 0.040, delta=0.004)
        self.assertAlmostEqual(theory["lattice_4"], 0.0103, delta=0.001)
        self.assertEqual(theory["one"], 0)
        spectra = {row["noise"]: row for row in self.table("law_spectra")}
        # By chance, one of these peaks exceeds 2.5 in one run out of 2500.
        functions = ("value", "square", "magnitude", "fourth_power", "beyond_2.5")
        for function in functions:
            for noise in ("lattice_3", "lattice_4"):
                self.assertLess(float(spectra[noise][function]), 2.5, f"{noise}, {function}")
        for function in functions[2:]:
            self.assertGreater(float(spectra["one"][function]), 5, function)
        self.assertEqual(set(self.files()), {"law_noises.png"} | {f"{name}.{ending}" for name in counts for ending in ("csv", "json")})

    def test_a_finished_table_is_kept(self):
        self.assertEqual(self.interrupted, -signal.SIGINT)
        self.assertEqual((self.law / "law_places.csv").stat().st_mtime_ns, self.first_table)

    def test_a_table_of_another_version_device_or_driver_starts_again(self):
        self.succeed("study", "figure1", "--quick", "-o", ".")
        table, sidecar = self.folder / "figure1.csv", self.folder / "figure1.json"
        whole, conditions = table.read_bytes(), json.loads(sidecar.read_text())
        self.assertEqual(set(conditions), {"version", "device", "driver", "quick"})
        for name in conditions:
            table.write_text("kept\n")
            sidecar.write_text(json.dumps(conditions | {name: "another"}, indent=2) + "\n")
            self.succeed("study", "figure1", "--quick", "-o", ".")
            self.assertEqual(table.read_bytes(), whole, name)
        table.write_text("kept\n")
        self.succeed("study", "figure1", "--quick", "-o", ".")
        self.assertEqual(table.read_text(), "kept\n")

    def test_wrong_requests_are_refused(self):
        self.assert_refused(["figure7", "figure1", "future", "all"], "study", "figure7", "-o", ".")
        self.assert_refused(["--output"], "study", "figure1")
        (self.folder / "file").write_text("")
        self.assert_refused(["'file/below'"], "study", "figure1", "-o", "file/below")
        plot = subprocess.run([PLOT, self.folder], stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual((plot.returncode, plot.stderr.count("\n")), (2, 1))


if __name__ == "__main__":
    unittest.main()

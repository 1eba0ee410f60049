"""Compares gabor-lab.exe under Wine with gabor-lab on Linux: tables, pictures, and what an interrupted study leaves. GABOR_LAB runs
gabor-lab.exe in Wine, and GABOR_LINUX is the build for Linux."""

import csv
import json
import os
import pathlib
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from program import ProgramTest, gabor  # noqa: E402

LINUX, WINDOWS = os.environ["GABOR_LINUX"] + "/gabor-lab", os.environ["GABOR_LAB"]
STUDIES = "figure1", "figure2", "figure3", "figure4", "stationarity", "law", "frontier", "future"  # figures 5 and 6 have times
ROUNDING = 1e-5  # of six digits, besides the C library's


class Laboratory(ProgramTest):
    def setUp(self):
        super().setUp()
        self.folders = {LINUX: self.folder / "linux", WINDOWS: self.folder / "windows"}
        for folder in self.folders.values():
            folder.mkdir()

    def results(self, *arguments, status=0):
        """Returns what both programs print, each in its folder."""
        results = [gabor(*arguments, cwd=folder, command=(program,)) for program, folder in self.folders.items()]
        for result in results:
            self.assertEqual(result.returncode, status, result.stderr)
        return [(result.stdout, result.stderr) for result in results]

    def test_studies(self):
        for study in STUDIES:
            linux, windows = self.results("study", study, "--quick", "-o", ".")
            self.assertEqual(windows, linux)
        linux, windows = ({path.name: path for path in folder.iterdir()} for folder in self.folders.values())
        self.assertEqual(windows.keys(), linux.keys())
        self.assertGreater(len(linux), 20)
        equal = 0
        for name in linux:
            if linux[name].read_bytes() == windows[name].read_bytes():
                equal += 1
            else:
                with self.subTest(name):
                    self.assertEqual(pathlib.Path(name).suffix, ".csv")
                    print(f"  {name}: numbers differ by at most {self.apart(linux[name], windows[name]):.1e}")
        print(f"  {equal} of {len(linux)} files are equal, byte for byte")

    def apart(self, *paths):
        """Returns the largest relative difference of two tables' numbers; other cells must be equal."""
        here, there = (list(csv.reader(path.read_text().splitlines())) for path in paths)
        self.assertEqual([len(row) for row in there], [len(row) for row in here])
        largest = 0.0
        for one, other in zip(sum(here, []), sum(there, [])):
            if one != other:
                one, other = float(one), float(other)
                largest = max(largest, abs(one - other) / max(abs(one), 1e-3))
        self.assertLess(largest, ROUNDING)
        return largest

    def test_bench(self):
        self.results("bench", "--quick", "--json", "times.json")
        linux, windows = (json.loads((folder / "times.json").read_text()) for folder in self.folders.values())
        self.assertEqual(windows.keys(), linux.keys())

    def test_texts(self):
        for arguments in (["--help"], ["--version"], ["study", "--help"], ["bench", "--help"]):
            linux, windows = self.results(*arguments)
            self.assertEqual(windows, linux)
        linux, windows = self.results("study", "figure7", "-o", ".", status=2)
        self.assertEqual(windows, linux)


if __name__ == "__main__":
    unittest.main()

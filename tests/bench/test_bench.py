"""Checks the report of `gabor-lab bench`, not its timings."""

import datetime
import json
import os
import pathlib
import re
import subprocess
import unittest

from program import LAVAPIPE, PROGRAM, ProgramTest, environment

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Bench(ProgramTest):
    def test_a_quick_run_reports_everything(self):
        text = self.succeed("bench", "--quick", "--json", "bench.json")
        report = json.loads((self.folder / "bench.json").read_text())
        self.assertTrue(report["device"] and report["driver"] and report["peak_memory"] > 0)
        rows = {row["name"]: row for row in report["base"]}
        published = {"the paper's advice, 18 kernels": 0.50, "the seminal noise, 183 kernels": 1.37, "the seminal noise, 270 kernels": 0.59}
        for name in (*published, "gabor_noise, one", "gabor_noise, pure", "gabor_noise, paper",
                     "bake, one", "bake, pure", "bake, paper", "Perlin noise", "simplex noise"):
            row = rows[name]
            self.assertIn(name, text)
            self.assertGreater(row["seconds_low"], 0)
            self.assertLessEqual(row["seconds_low"], row["seconds"])
            self.assertLessEqual(row["seconds"], row["seconds_high"])
            self.assertGreater(row["pipeline_seconds"], 0)
            self.assertEqual(row["cvm"] is None, name in ("Perlin noise", "simplex noise"))
        # 2^20 samples tell good noises from bad. The published noises' cvm is measured with 16 times as many.
        for name, truth in published.items():
            cvm = rows[name]["cvm"]
            self.assertTrue(cvm["low"] < 1.1 * truth and cvm["high"] > 0.9 * truth, f"{name}: {cvm}")
        self.assertLess(rows["gabor_noise, one"]["cvm"]["high"], 0.3)
        self.assertEqual(len(report["trends"]), 16)
        self.assertRegex(text, r"(?m)^\| .* \| Vulkan \|( [\d.e+-]+ \|){6}$")  # docs/benchmark.html prints such a row
        self.check_page(report)

    def check_page(self, report):
        """Checks that tools/performance puts these figures and the cost of the code into a page without changing its prose."""
        page = self.folder / "page.md"
        page.write_text("before\n<!-- tools/performance -->\nold\n<!-- end -->\nafter\n")
        code = {"name": "gabor_noise, lattice", "instructions": 369.2, "inverse_throughput": 525.0, "registers": 32}
        (self.folder / "isa.json").write_text(json.dumps({"driver": "radv", "code": [code, code | {"name": "gabor_noise, one"}]}))
        subprocess.run([ROOT / "tools/performance", "--programs", pathlib.Path(PROGRAM).parent, "--quick", "--figures", self.folder, "--page",
                        page], check=True, env=environment())
        text = page.read_text()
        self.assertRegex(text, r"\Abefore\n<!-- tools/performance -->\n(?s:.*)<!-- end -->\nafter\n\Z")
        self.assertNotIn("old\n", text)
        render = subprocess.Popen([pathlib.Path(PROGRAM).parent / "gabor", "render", "-o", self.folder / "one.exr", "--size=128x128"],
                                  stdout=subprocess.DEVNULL, env=environment())
        memory = os.wait4(render.pid, 0)[2].ru_maxrss / 1024
        self.assertAlmostEqual(float(re.search(r"128 x 128 pixels in [\d.]+ s and (\d+) MiB", text)[1]), memory, delta=0.25 * memory)
        for words in (report["device"], report["driver"], datetime.date.today().isoformat(), "128 x 128"):
            self.assertIn(words, text)
        times = {row["name"]: f"{row['ns_per_pixel'] * 2.0736:.1f}" for row in report["base"]}
        shown = dict(re.findall(r"(?m)^\| ([^|]+) \| ([\d.]+) \|", text))
        for name, milliseconds in times.items():
            plain, _, recipe = name.rpartition(", ")
            listed = plain == "gabor_noise" or recipe not in ("one", "pure", "paper", "lattice-2", "lattice-4")
            self.assertEqual(shown.pop(plain if recipe == "lattice" and plain != "gabor_noise" else name, None),
                             milliseconds if listed else None, name)
        self.assertFalse(shown)
        for recipe in "lattice", "one":
            self.assertRegex(text, rf"(?m)^\| gabor_noise, {recipe} \|.*\| 525 \|")

    def test_an_unwritable_report_is_refused(self):
        self.assert_fails(2, ["nowhere"], "bench", "--quick", "--json", "nowhere/bench.json")

    @unittest.skipUnless(LAVAPIPE, "needs Mesa's lavapipe, a driver without statistics")
    def test_isa_needs_a_driver_with_statistics(self):
        self.assert_fails(2, ["VK_KHR_pipeline_executable_properties"], "bench", "--isa", "--json", "isa.json",
                          env={"VK_ICD_FILENAMES": LAVAPIPE, "VK_DRIVER_FILES": None})


if __name__ == "__main__":
    unittest.main()

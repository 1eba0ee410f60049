"""`gabor bench`: what it reports, not how fast it was."""

import json
import unittest

from program import LAVAPIPE, ProgramTest


class Bench(ProgramTest):
    def test_quick_run_reports_everything(self):
        text = self.succeed("bench", "--quick", "--json", "bench.json")
        report = json.loads((self.folder / "bench.json").read_text())
        self.assertTrue(report["device"] and report["driver"] and report["peak_memory"] > 0)
        rows = {row["name"]: row for row in report["base"]}
        published = ("seminal, N = 30", "seminal, N = 30, hoisted", "the paper's advice, N = 2, plain",
                     "the paper's advice, N = 2, hoisted")
        for name in (*published, "gabor_noise, one", "gabor_noise, pure", "gabor_noise, paper",
                     "bake, one", "bake, pure", "bake, paper", "gradient noise", "writing alone"):
            row = rows[name]
            self.assertIn(name, text)
            self.assertGreater(row["seconds_low"], 0)
            self.assertLessEqual(row["seconds_low"], row["seconds"])
            self.assertLessEqual(row["seconds"], row["seconds_high"])
            self.assertGreater(row["pipeline_seconds"], 0)
            self.assertEqual(row["cvm"] is None, name in ("gradient noise", "writing alone"))
        # 2^20 samples tell good from bad, and the published noises are as their authors made them.
        for name in published:
            cvm = rows[name]["cvm"]
            self.assertTrue(cvm["low"] < 0.5 < cvm["high"], f"{name}: {cvm}")
        self.assertLess(rows["gabor_noise, one"]["cvm"]["high"], 0.3)
        self.assertEqual(len(report["trends"]), 16)

    def test_unwritable_report(self):
        self.assert_fails(2, ["nowhere"], "bench", "--quick", "--json", "nowhere/bench.json")

    @unittest.skipUnless(LAVAPIPE, "needs Mesa's lavapipe, which does not tell")
    def test_isa_needs_a_driver_that_tells(self):
        self.assert_fails(2, ["VK_KHR_pipeline_executable_properties"], "bench", "--isa", "--json", "isa.json",
                          env={"VK_ICD_FILENAMES": LAVAPIPE, "VK_DRIVER_FILES": None})


if __name__ == "__main__":
    unittest.main()

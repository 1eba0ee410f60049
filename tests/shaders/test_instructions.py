"""Checks that no call has more SPIR-V instructions after inlining than instructions.txt says: drivers inline all functions before
they remove branches, and the time that they take grows faster than this number."""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import calls  # noqa: E402

INLINING = ["--merge-return", "--inline-entry-points-exhaustive", "--eliminate-dead-functions"]


def instructions(spirv):
    """Returns the number of instructions in the functions of a module."""
    words, at, count, inside = memoryview(spirv.read_bytes()).cast("I"), 5, 0, False
    while at < len(words):
        inside |= words[at] & 0xffff == 54  # OpFunction
        count += inside
        at += words[at] >> 16
    return count


class Instructions(unittest.TestCase):
    def test_every_noise_is_listed(self):
        noises = {name for text in calls.DROP_INS.values() for name in re.findall(r"^\w+ (gabor_(?:noise|field)\w*)\(", text, re.MULTILINE)}
        listed = " ".join(call for call, _ in calls.table())
        self.assertEqual(noises - set(re.findall(r"\w+", listed)), {"gabor_field_direction"})  # needs a map

    def test_arguments_differ(self):
        for language in "glsl", "wgsl":
            read = re.findall(r"\bvalues\[(\d+)\](?! =)", calls.shader("gabor_noise(p, frequency, orientation, seed)", language))
            self.assertEqual(list(map(int, read)), list(range(sum(calls.ARGUMENTS.values()))))

    def test_no_call_has_grown(self):
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            source, spirv = (pathlib.Path(folder) / f"call.{kind}" for kind in ("comp", "spv"))
            for call, most in calls.table():
                with self.subTest(call):
                    source.write_text(calls.shader(call, "glsl"))
                    subprocess.run([os.environ["GLSLANG_VALIDATOR"], "--quiet", "-V", source, "-o", spirv], check=True)
                    subprocess.run(["spirv-opt", *INLINING, spirv, "-o", spirv], check=True)
                    found = instructions(spirv)
                    print(f"{found} {call}")
                    self.assertLessEqual(found, most)
                    self.assertGreater(found, 0.8 * most, "the table is out of date")


if __name__ == "__main__":
    unittest.main()

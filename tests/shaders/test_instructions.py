"""Checks that no call has more SPIR-V instructions than instructions.txt says, if all functions are inlined: drivers inline them
before they remove branches, and the time that they take grows faster than this number."""

import functools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
import calls  # noqa: E402
import copies  # noqa: E402

NAME, FUNCTION, FUNCTION_CALL = 5, 54, 57  # SPIR-V's OpName, OpFunction and OpFunctionCall
MAIN = "void main() {"


def instructions(spirv):
    """Returns the number of instructions in each function of a module, by name, as if all calls were inlined."""
    words, at, names, functions = memoryview(spirv).cast("I"), 5, {}, {}
    while at < len(words):
        operation, size = words[at] & 0xffff, words[at] >> 16
        if operation == NAME:
            names[words[at + 1]] = bytes(words[at + 2:at + size]).decode().partition("(")[0]
        elif operation == FUNCTION:
            body = functions[words[at + 2]] = []
        if functions:
            body.append(words[at + 3] if operation == FUNCTION_CALL else None)
        at += size

    @functools.cache
    def count(function):
        return sum(count(called) if called else 1 for called in functions[function])
    return {names[function]: count(function) for function in functions}


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
        """Compiles one shader with a function for each call."""
        table, files = list(calls.table()), list(dict.fromkeys(each for path in calls.DROP_INS for each in [*copies.needed(path), path]))
        shaders = [calls.shader(call, "glsl") for call, _ in table]
        start = shaders[0].partition(calls.DROP_INS[files[0]])[0]
        buffer = re.search("^layout.*;\n", shaders[0].partition(MAIN)[0], re.MULTILINE | re.DOTALL)[0]
        functions = [f"void call_{number}() {{{shader.partition(MAIN)[2]}" for number, shader in enumerate(shaders)]
        text = "".join([start, *map(calls.DROP_INS.get, files), buffer, *functions, MAIN, *(f"call_{number}();" for number in range(len(table))), "}"])
        with tempfile.NamedTemporaryFile(suffix=".spv") as spirv:
            subprocess.run([os.environ["GLSLANG_VALIDATOR"], "--quiet", "--stdin", "-S", "comp", "-V", "-o", spirv.name], input=text, text=True, check=True)
            found = instructions(spirv.read())
        for number, (call, most) in enumerate(table):
            with self.subTest(call):
                count = found[f"call_{number}"]
                print(f"{count} {call}")
                self.assertLessEqual(count, most)
                self.assertGreater(count, 0.8 * most, "the table is out of date")


if __name__ == "__main__":
    unittest.main()

"""Runs tests of the programs for Windows, under Wine, and prints a line for each of these parts, what it skips and why, and what
failed: run.py [PART...]. tools/windows sets what they need."""

import contextlib
import importlib
import io
import pathlib
import sys
import time
import traceback
import unittest

TESTS = pathlib.Path(__file__).resolve().parents[1]
PARTS = ["windows/test_pictures", "windows/test_functions", "windows/test_laboratory", "windows/test_files", "windows/test_viewer",
         *(f"cli/test_{name}" for name in ("atomicity", "drivers", "erode", "errors", "golden", "heightmaps", "help", "join", "maps", "ocean",
                                           "pages", "render", "spectra", "stats", "terrain", "texture")), "fit/test_fit"]


def indented(text):
    return "".join(f"    {line}\n" for line in text.splitlines())


def run(part):
    """Prints a part's results. Returns how many of its tests passed, were skipped and failed."""
    started, said, result = time.monotonic(), io.StringIO(), unittest.TestResult()
    sys.path.insert(0, str((TESTS / part).parent))
    with contextlib.redirect_stdout(said):
        try:
            unittest.defaultTestLoader.loadTestsFromModule(importlib.import_module(pathlib.Path(part).name)).run(result)
        except Exception:
            result.errors.append((part, traceback.format_exc()))
    wrong = result.failures + result.errors
    failed = len({str(test).partition(" [")[0] for test, _ in wrong})  # a test with several wrong subtests is one
    passed = max(result.testsRun - failed - len(result.skipped), 0)
    if not passed and not failed and not result.skipped:
        wrong, failed = [(part, "It has no tests.")], 1
    print(f"{part}: {passed} passed, {len(result.skipped)} skipped, {failed} failed, {time.monotonic() - started:.0f} s")
    for test, reason in result.skipped:
        print(f"  skipped {str(test).split()[0]}: {reason}")
    for test, text in wrong:
        print(f"  FAILED {test}\n{indented(text)}", end="")
    print(indented(said.getvalue()), end="", flush=True)
    return passed, len(result.skipped), failed


parts = sys.argv[1:] or PARTS
if unknown := set(parts) - set(PARTS):
    print(f"{min(unknown)} is no part: expected {', '.join(PARTS)}", file=sys.stderr)
    sys.exit(2)
passed, skipped, failed = map(sum, zip(*map(run, parts)))
print(f"{len(parts)} parts: {passed} tests passed, {skipped} skipped, {failed} failed")
sys.exit(failed > 0 or passed == 0)

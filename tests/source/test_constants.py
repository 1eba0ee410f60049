"""Checks where the drop-ins' constants of five or more digits come from. Each has one of these in its function:
- a comment with a closed form, such as `2/3 pi^2` or `(4 pi^2 / 9.81)^2`;
- a comment that says what was chosen, such as `17.345 was chosen for its moire`;
- a fit in tools/constants.py, which a comment names.
Whole numbers, such as 65536.0, do not count."""

import importlib.util
import math
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).parents[2]
specification = importlib.util.spec_from_file_location("constants", ROOT / "tools/constants.py")
constants = importlib.util.module_from_spec(specification)
specification.loader.exec_module(constants)

NUMBER = r"\d+(?:\.\d+)?(?:e[+-]?\d+)?"
FORMULA = re.compile(rf"(?:(?<![\w.])(?:{NUMBER}|pi|sqrt|ln)(?!\w)|[-+*/^() ])+")
NAMES = {"__builtins__": {}, "pi": math.pi, "sqrt": math.sqrt, "ln": math.log}


def literals(code):
    """Each constant of some code with five or more digits."""
    found = [text for text in constants.LITERAL.findall(code) if len(text.split("e")[0].replace(".", "").strip("0")) >= 5]
    return list(dict.fromkeys(text for text in found if "e" in text or not float(text).is_integer()))


def formulas(comment):
    """The values of the formulas in a comment."""
    values = []
    for text in FORMULA.findall(comment):
        if re.fullmatch(rf"[ (]*(?:{NUMBER})?[ )]*", text):
            continue  # a number is not a formula
        text = re.sub(rf"ln ({NUMBER})", r"ln(\1)", text.strip()).replace("^", "**")
        text = re.sub(r"(?<=[\d)i]) *(?=\()|(?<=[\d)i]) +(?=[\da-z])", "*", text)  # i ends pi
        try:
            values.append(abs(eval(text, NAMES)))
        except (SyntaxError, TypeError, ValueError, ArithmeticError):
            pass  # a piece of a longer formula
    return values


def is_rounded(text, value):
    """Whether a literal is this value, rounded to its digits or to a float."""
    mantissa, _, exponent = text.partition("e")
    last_digit = 10.0 ** (int(exponent or 0) - len(mantissa.partition(".")[2]))
    return abs(float(text) - value) <= max(0.5001 * last_digit, 6e-8 * value)


def regions(text):
    """The text of a drop-in in pieces that end after a function or a struct: (first line, code, comments)."""
    code, comment, first = "", "", 1
    for number, line in enumerate(text.splitlines(), 1):
        before, _, after = line.partition("//")
        code += before + "\n"
        comment += after + "\n"
        if line.startswith("}"):
            yield first, code, comment
            code, comment, first = "", "", number + 1
    yield first, code, comment


def unexplained(text, fitted):
    """The constants of a drop-in that are neither closed forms nor choices nor fits."""
    missing = []
    for first, code, comment in regions(text):
        values = formulas(comment)
        missing += [f"line {first} and on: {literal}" for literal in literals(code) if not (literal in fitted and "tools/constants.py" in comment)
                    and not any(is_rounded(literal, value) for value in values)
                    and not re.search(rf"(?<![\d.]){re.escape(literal)}(?!\d)(?:[^.]|\.\d)*\bchosen\b", comment)]
    return missing


class Constants(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.fits = constants.fits()

    def test_fits_are_those_of_the_drop_ins(self):
        self.assertGreater(len(self.fits), 15)
        for fit in self.fits:
            with self.subTest(fit.name, about=fit.about):
                found = fit.found()
                self.assertEqual(len(set(found)), len(fit.numbers), found)
                for text, number, best in zip(found, fit.drop_in(), fit.numbers):
                    self.assertLessEqual(abs(number / best - 1), fit.tolerance, f"{text} is not {best:.8g}")
                if not math.isinf(fit.excess):  # rounding to floats adds up to 3e-8
                    self.assertLessEqual(fit.error(fit.drop_in()), (1 + fit.excess) * fit.error(fit.numbers) + 3e-8)

    def test_every_constant_has_an_origin(self):
        files = sorted((ROOT / "shaders").glob("gabor_*.glsl"))
        self.assertGreaterEqual(len(files), 11)
        checked = 0
        for path in files:
            fitted = {text for fit in self.fits if fit.file == path.name for text in fit.found()}
            text = path.read_text()
            checked += sum(len(literals(code)) for _, code, _ in regions(text))
            with self.subTest(path.name):
                self.assertEqual(unexplained(text, fitted), [])
        self.assertGreater(checked, 200)

    def test_finds_what_has_none(self):
        code = "float f(float x) {{\n    return 6.5797363 * x;{}\n}}\n"
        for comment in (" // 2/3 pi^2", " // the variance, 2/3 pi^2 of it", "\n    // 6.5797363 was chosen by eye",
                        " // (2 pi)^2 / 6"):
            self.assertEqual(unexplained(code.format(comment), set()), [], comment)
        for comment in ("", " // 6.5797363", " // 2/3 pi", " // chosen by eye", " // 6.5797363 is it. 1 was chosen"):
            self.assertEqual(unexplained(code.format(comment), set()), ["line 1 and on: 6.5797363"], comment)
        self.assertEqual(unexplained(code.format(" // fit: see tools/constants.py"), {"6.5797363"}), [])
        self.assertEqual(len(unexplained(code.format(""), {"6.5797363"})), 1)
        self.assertTrue(is_rounded("0.2967060", 17 / 180 * math.pi))
        self.assertFalse(is_rounded("0.2967061", 17 / 180 * math.pi))


if __name__ == "__main__":
    unittest.main()

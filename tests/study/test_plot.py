"""Checks what tools/plot draws of made-up tables, without matplotlib: digests of its calls must be those of tests/golden/plots.txt.
GABOR_GOLDEN=write rewrites that file; GABOR_GOLDEN=show prints the calls."""

import hashlib
import itertools
import os
import pathlib
import sys
import types
import unittest
import zlib

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
GOLDEN = ROOT / "tests" / "golden" / "plots.txt"
CHOICES = {"points": ["poisson", "stratified", "jittered", "jittered_hex", "sobol", "scrambled_sobol"], "weights": ["uniform", "bernoulli", "none"],
           "N": [1.0, 2.0, 4.0, 10.0, 30.0], "noise": ["seminal", "advice", "paper", "one", "pure", "lattice_2", "lattice_3", "lattice_4"],
           "frequency": [1.0, 4.0], "window": ["cosine 2", "hann 3"], "lattice": ["square", "brick"], "law": ["normal", "two_point", "rayleigh"],
           "jitter": [0.0, 1.0], "step": [0.0, 0.1, 0.3, 1.0], "lag_y": [0.0, 0.5]}
USED = {"law_places": ["noise", "N"], "law": ["noise"], "law_pairs": ["noise", "N"], "law_covariance": ["noise", "lag_y"], "law_spectra": ["noise"],
        "frontier": ["window", "lattice", "law"], "future_unweighted": ["points", "weights", "N", "frequency"], "future_grids": ["jitter", "law", "window"],
        "future_kernels": ["step", "N"]}


class Row(dict):
    """A row with the given choices, and a number in each other column: intervals of cvm contain it, and a few reach 0."""

    def __missing__(self, name):
        number = zlib.crc32(f"{name} {sorted(self.items())}".encode()) / 2**32
        if name in ("kernel", "envelope"):
            return name
        return number - 0.1 if name == "cvm_low" else 2 + number if name.endswith("_high") else 1 + number


class Recorder:
    def __init__(self, name, calls):
        self.name, self.calls = name, calls

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return Recorder(f"{self.name}.{name}", self.calls)

    def __getitem__(self, index):
        return Recorder(f"{self.name}[{index}]", self.calls)

    def __call__(self, *given, **named):
        def plain(value):
            if isinstance(value, Recorder):
                return value.name
            if isinstance(value, np.ndarray) and value.dtype != object:
                return f"array {value.shape}"
            if isinstance(value, (list, tuple, range, np.ndarray)):
                return [plain(each) for each in value]
            if isinstance(value, dict):
                return {key: plain(each) for key, each in value.items()}
            return f"{value:.5g}" if isinstance(value, float) else str(value).replace(str(ROOT), "")
        self.calls.append(f"{self.name} {plain(given)} {plain(named)}")
        last = self.name.rpartition(".")[2]
        if last == "subplots":
            sides = [each for each in given if isinstance(each, int)]
            axes = np.array([Recorder(f"axes {i}", self.calls) for i in range(int(np.prod(sides or [1])))], dtype=object)
            return Recorder("figure", self.calls), axes.reshape(sides)[0] if sides and sides[0] == 1 else axes.reshape(sides) if sides else axes[0]
        if last == "SymLogNorm":
            return types.SimpleNamespace(**named)
        return [Recorder("line", self.calls)] if last == "plot" else np.zeros((400, 800)) if last == "imread" else Recorder(f"{last}()", self.calls)


class Plot(unittest.TestCase):
    def test_drawings(self):
        calls = []
        plt = Recorder("plt", calls)
        matplotlib = Recorder("matplotlib", calls)
        vars(matplotlib)["pyplot"] = plt
        modules = {"matplotlib": matplotlib, "matplotlib.pyplot": plt, "matplotlib.lines": Recorder("lines", calls)}
        before = {name: sys.modules.get(name) for name in modules}
        sys.modules.update(modules)
        try:
            names = {"__name__": "plot"}
            exec((ROOT / "tools" / "plot").read_text(), names)
        finally:
            for name, module in before.items():
                sys.modules.pop(name)
                if module:
                    sys.modules[name] = module

        def read(_folder, name):
            used = USED.get(name, ["points", "weights", "N"])
            return [Row(zip(used, values)) for values in itertools.product(*(CHOICES[each] for each in used))]
        names["read"] = read
        lines = [f"style {hashlib.sha1(repr(calls).encode()).hexdigest()[:6]}"]
        for draw in names["DRAWINGS"]:
            calls.clear()
            draw(pathlib.Path("folder"))
            if os.environ.get("GABOR_GOLDEN") == "show":
                print("\n".join([draw.__name__, *calls]))
            lines.append(f"{draw.__name__} {hashlib.sha1(repr(calls).encode()).hexdigest()[:6]}")
        if os.environ.get("GABOR_GOLDEN") == "write":
            GOLDEN.write_text("\n".join(lines) + "\n")
        self.assertEqual(lines, GOLDEN.read_text().splitlines())


if __name__ == "__main__":
    unittest.main()

"""Checks what tools/plot draws of made-up tables without matplotlib, and Blender's examples without Blender: digests of their calls
must be those of tests/golden/plots.txt. GABOR_GOLDEN=write rewrites that file; GABOR_GOLDEN=show prints the calls. Also checks what
tools/performance writes of made-up figures."""

import hashlib
import itertools
import os
import pathlib
import sys
import tempfile
import types
import unittest
import unittest.mock
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

    def __setattr__(self, name, value):
        if name not in ("name", "calls"):
            self.calls.append(f"{self.name}.{name} = {getattr(value, 'name', value)}".replace(str(ROOT), ""))
        vars(self)[name] = value

    def __getitem__(self, index):
        return Recorder(f"{self.name}[{index}]", self.calls)

    def __call__(self, *given, **named):
        def plain(value):
            if isinstance(value, Recorder):
                return value.name
            if isinstance(value, types.FunctionType):
                return "function"
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
        if last == "resource_path":
            return "/nowhere"
        if last == "SymLogNorm":
            return types.SimpleNamespace(**named)
        return [Recorder("line", self.calls)] if last == "plot" else np.zeros((400, 800)) if last == "imread" else Recorder(f"{last}()", self.calls)


def executed(path, calls, *modules):
    """Returns the names of a script that was run with recorders in place of these modules."""
    recorders = {name: Recorder(name, calls) for name in modules}
    for name, recorder in recorders.items():
        if "." in name:
            vars(recorders[name.partition(".")[0]])[name.partition(".")[2]] = recorder
    with unittest.mock.patch.dict(sys.modules, recorders):
        names = {"__name__": "script", "__file__": str(path)}
        exec(path.read_text(), names)
    return names


class Plot(unittest.TestCase):
    def test_drawings(self):
        calls = []
        names = executed(ROOT / "tools" / "plot", calls, "matplotlib", "matplotlib.pyplot", "matplotlib.lines")
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            (pathlib.Path(folder) / "table.csv").write_text("points,N\npoisson,4\nsobol,0.5\n")
            self.assertEqual(names["read"](pathlib.Path(folder), "table"), [{"points": "poisson", "N": 4.0}, {"points": "sobol", "N": 0.5}])

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
        for example in "example.py", "terrain.py", "sea.py":
            calls.clear()
            with unittest.mock.patch.object(sys, "path", list(sys.path)):
                executed(ROOT / "shaders" / "nodes" / "blender" / example, calls, "bpy", "bpy.utils", "cycles", "cycles.osl", "gabor_noise")
            if os.environ.get("GABOR_GOLDEN") == "show":
                print("\n".join([example, *calls]))
            lines.append(f"{example} {hashlib.sha1(repr(calls).encode()).hexdigest()[:6]}")
        if os.environ.get("GABOR_GOLDEN") == "write":
            GOLDEN.write_text("\n".join(lines) + "\n")
        self.assertEqual(lines, GOLDEN.read_text().splitlines())


class Sea(unittest.TestCase):
    def test_a_box_floats_in_blender(self):
        """On water with one slope, the box lies flat, wherever it heads."""
        with unittest.mock.patch.object(sys, "path", list(sys.path)):
            names = executed(ROOT / "shaders" / "nodes" / "blender" / "sea.py", [], "bpy", "cycles", "cycles.osl", "gabor_noise")
        names["gabor_noise"].water_height = lambda x, y, seconds, **_: 0.3 * np.array(x) - 0.2 * np.array(y) + 4 * seconds
        names["float_box"](types.SimpleNamespace(frame_current=12))
        box, up = vars(names["box"]), np.array([0.0, 0.0, 1.0])
        for axis in map("XYZ".index, box.get("rotation_mode", "XYZ")):  # Blender turns about these axes, the first one first
            turn, parts = np.exp(1j * box["rotation_euler"][axis]), [(axis + 1) % 3, (axis + 2) % 3]
            turned = turn * complex(*up[parts])
            up[parts] = turned.real, turned.imag
        np.testing.assert_allclose(up / up[2], (-0.3, 0.2, 1), atol=0.01)
        self.assertEqual(box["location"], (0, 0, 2.5))


class Performance(unittest.TestCase):
    def test_writes_figures(self):
        names = {"__name__": "performance", "__file__": str(ROOT / "tools" / "performance")}
        exec((ROOT / "tools" / "performance").read_text(), names)
        lattice, one, perlin, seminal = "gabor_noise, lattice", "gabor_noise, one", "Perlin noise", "the seminal noise, 183 kernels"
        names["GPU"] = {"device": "GPU", "driver": "driver 2", "date": "2026-01-02", "side": 4096, "ns": {lattice: 0.0094, one: 0.01}}
        when = {"date": "2026-03-04", "processor": "2 cores of X", "load": 0.2, "version": "gabor 9.8.7"}
        base = [{"name": name, "seconds": seconds, "ns_per_pixel": ns, "cvm": {"value": 0.25} if name == one else None, "side": 1024, "scale": 32.0,
                 "frequency": 4.0} for name, seconds, ns in ((lattice, 0.02, 5.0), (one, 0.03, 7.0), (perlin, 0.008, 2.0), (seminal, 1.3, 311.0))]
        bench = {"device": "llvmpipe", "driver": "Mesa 22", "base": base}
        isa = {"driver": "radv", "code": [{"name": lattice, "instructions": 369.2, "inverse_throughput": 525.4, "registers": 32},
                                          {"name": one, "instructions": 400.0, "inverse_throughput": 600.0, "registers": 40}]}
        renders = [{"side": 4096, "wall": 1.234, "memory": 321}, {"side": 16384, "wall": 12.0, "memory": 400}]
        self.assertEqual(names["summary"](when, bench, isa, renders), """\
| 1920 x 1080 values | lavapipe, 2 cores of X | AMD Navi 21, per value, estimated |
| --- | --- | --- |
| `gabor_noise` | 10.4 ms | 525 cycles |
| Perlin noise | 4.1 ms |  |
| Gabor noise of 2009 | 645 ms |  |

`gabor_noise` takes 19.5 us on one GPU.
""")
        self.assertEqual(names["generated"](when | {"load": 0.7}, bench, isa, renders), """\
gabor 9.8.7 on llvmpipe, Mesa 22, 2 cores of X, 2026-03-04. Other work was running (a load of 0.7): only ratios within a table are meaningful.
Medians of one interleaved run of `gabor-lab bench`: CPU time per core for 1024^2 values, and the GPU's clock for 4096^2
(driver 2, 2026-01-02), 32 values per kernel radius, frequency 4, sixteen values per invocation. Cycles are
RADV's estimates (radv); cvm is from 2^24 values, with a standard error of 0.002 for normal ones and 6 % for 0.5.

|  | lavapipe: ms at 1920 x 1080 | times Perlin noise | GPU: ps per value | Navi 21: cycles | cvm |
| --- | --- | --- | --- | --- | --- |
| gabor_noise, lattice | 10.4 | 2.50 | 9.4 | 525 |  |
| gabor_noise, one | 14.5 | 3.75 | 10 | 600 | 0.250 |
| Perlin noise | 4.1 | 1.00 |  |  |  |
| the seminal noise, 183 kernels | 644.9 | 162.50 |  |  |  |

`gabor render` draws 4096 x 4096 pixels in 1.23 s and 321 MiB and 16384 x 16384 pixels in 12.00 s and 400 MiB.
""")
        self.assertEqual(names["code"](when, isa).splitlines()[1:], ["# throughput in cycles, vector registers, and the pipeline.", "radv",
                                                                      f"369 525 32 {lattice}", f"400 600 40 {one}"])
        self.assertEqual(names["with_cycles"]("| `lattice` | a -20 dB | 7 |\n| `one` | b -3 dB | 8 |\n", isa),
                         "| `lattice` | a -20 dB | 525 |\n| `one` | b -3 dB | 600 |\n")


if __name__ == "__main__":
    unittest.main()

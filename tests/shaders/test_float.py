"""Checks gabor_float.glsl: its text, its values, that its hash is exact, and that its nodes are independent. The reference follows the
equations, with whole numbers and double precision."""

import itertools
import math
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import numpy as np

SHADERS = pathlib.Path(os.environ.get("GABOR_SHADERS", pathlib.Path(__file__).parents[2] / "shaders"))
TEXT = (SHADERS / "gabor_float.glsl").read_text()
CODE = re.sub("//.*", "", TEXT)
PRIMES = 1021, 1019, 1013
DRAWS, FAR = int(os.environ.get("GABOR_DRAWS", 500_000)), 5.5
MAIN = """
uniform vec4 at;
void main() {{
    vec2 p = (gl_FragCoord.xy - 32.5) * at.x + at.y;
    vec2 period = vec2(4.0, 0.75);
    {output} = {value};
}}
"""
VALUES = "vec4(gabor_noise_gradient(p, 3.0, 0.7, at.z), gabor_noise_tiled(p, period, 3.0, 0.7, at.z))", \
         "vec4(gabor_stripes(p, vec2(2.5, -1.5), 2.0, at.z), gabor_noise(p, 3.0, 0.7, at.z))"


# ---- Reference -----------------------------------------------------------------------------------------------------


def line(index, salt):
    """The residues of columns or rows."""
    x = [(index + s) % q for s, q in zip(salt, PRIMES)]
    for _ in range(2):
        x = [(x[j] + x[j - 2] * x[j - 1]) % PRIMES[j] for j in range(3)]
    return [np.maximum(each, 1) for each in x]


def lines(column, row, seed):
    salt = line(seed, (17, 400, 811))
    return line(column, salt), line(row, salt[1:] + salt[:1])


def uniforms(columns, rows):
    """The two numbers of a node, uniform in [-1, 1]."""
    a, b, c = (x * y % q / q for x, y, q in zip(columns, rows, PRIMES))
    return (2 * np.mod(a + b, 1) - 1, 2 * np.mod(c + b, 1) - 1)


def amplitude(columns, rows):
    def shape(u):
        return (u - 0.89289313 * np.clip(u, -0.93687596, 0.93687596)) * (u * u + 1.6040536)
    x, w = np.polynomial.legendre.leggauss(8)
    halves = [(0, 0.93687596), (0.93687596, 1)]
    deviation = math.sqrt(sum((b - a) / 2 * (w * shape(a + (b - a) * (x + 1) / 2) ** 2).sum() for a, b in halves))
    real, imaginary = uniforms(columns, rows)
    return (shape(real) + 1j * shape(imaginary)) / deviation


def noise(x, y, wave, seed, period=(0, 0)):
    """The complex noise and its gradient at points or over seeds, with Hann's windows of one kernel radius."""
    radius = [max(round(1.5 * each), 3) / each if each else 1.5 for each in period]
    count = [round(r * each) for r, each in zip(radius, period)]
    total = 0
    x, y = x * radius[0], y * radius[1]
    for j, k in itertools.product((-1, 0, 1), repeat=2):
        column, row = np.floor(x + 0.5).astype(int) + j, np.floor(y + 0.5).astype(int) + k
        dx, dy = (x - column) / 1.5, (y - row) / 1.5  # as shares of a window
        h, g = (1 + np.cos(math.pi * dx)) / 2, (1 + np.cos(math.pi * dy)) / 2
        away = (x - column) / radius[0], (y - row) / radius[1]
        turns = np.exp(2j * math.pi * (wave[0] * away[0] + wave[1] * away[1]))
        a = amplitude(*lines(column % count[0] if count[0] else column, row % count[1] if count[1] else row, seed)) * turns / 1.125
        wide = -math.pi / 2 * np.sin(math.pi * dx) * g * radius[0] / 1.5, -math.pi / 2 * np.sin(math.pi * dy) * h * radius[1] / 1.5
        total = total + a * np.array([h * g, *(w + 2j * math.pi * f * h * g for w, f in zip(wide, wave))])
    return total


def chi_square(values, bins):
    counts = np.bincount(values, minlength=bins)
    freedom = bins - 1
    root = np.cbrt(((counts - counts.mean()) ** 2).sum() / counts.mean() / freedom)
    return (root - (1 - 2 / (9 * freedom))) / math.sqrt(2 / (9 * freedom))


# ---- Tests ---------------------------------------------------------------------------------------------------------


class Text(unittest.TestCase):
    def test_it_has_neither_directives_nor_integers(self):
        self.assertLessEqual(TEXT.count("\n"), 200)
        self.assertNotIn('"', TEXT)
        for pattern in ("#", r"\b[iu]?(int|[iu]vec\d|uint)\b", r"(?<![\w.])\d+(?![\w.])", "[&|^~%](?![&|])", "<<|>>",
                        r"\b(precision|[hm]igh?p|mediump|lowp|in|uniform)\b"):
            self.assertEqual(re.findall(pattern, CODE), [], pattern)

    def test_signatures_are_those_of_gabor_noise(self):
        def signatures(text):
            return {re.sub(r"\s+", " ", each).replace("uint", "float") for each in re.findall(r"^\w+ gabor_(?!impl)\w+\([^)]*\)", text, re.MULTILINE)}
        here = signatures(CODE)
        self.assertGreater(len(here), 6)
        self.assertEqual(here - signatures((SHADERS / "gabor_noise.glsl").read_text()), set())
        for name in here:
            self.assertIn(f"// {name}", TEXT)
        self.assertEqual([n for n in re.findall(r"^(?:const )?\w+ (\w+)(?= =|\(| \{)", CODE, re.MULTILINE) if not re.match("gabor_|Gabor", n)], [])

    def test_one_text_serves_every_version(self):
        validator = os.environ.get("GLSLANG_VALIDATOR", "glslangValidator")
        with tempfile.TemporaryDirectory() as folder:
            for version, before in (("100", "precision highp float;"), ("110", ""), ("120", ""), ("130", ""), ("300 es", "precision highp float;"), ("330", "")):
                for value in VALUES:
                    modern = version[0] == "3"
                    path = pathlib.Path(folder) / "a.frag"
                    path.write_text(f"#version {version}\n{before}\n{TEXT}" + "out vec4 color;\n" * modern
                                    + MAIN.format(output="color" if modern else "gl_FragColor", value=value))
                    result = subprocess.run([validator, path], capture_output=True, text=True)
                    self.assertEqual(result.returncode, 0, f"{version}: {result.stdout}")


class Values(unittest.TestCase):
    def draw(self, version, value, at):
        try:
            import moderngl
            context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")
        except Exception as error:
            self.skipTest(f"needs moderngl and EGL: {error}")
        old = version == "100"
        vertex = ("attribute" if old else "in") + " vec2 corner;\nvoid main() { gl_Position = vec4(corner, 0.0, 1.0); }\n"
        fragment = "precision highp float;\n" * old + TEXT + "out vec4 color;\n" * (not old) \
            + MAIN.format(output="gl_FragColor" if old else "color", value=value)
        program = context.program(vertex_shader=f"#version {version}\n{vertex}", fragment_shader=f"#version {version}\n{fragment}")
        program["at"] = (*at, 0.0)
        buffer = context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
        target = context.framebuffer([context.texture((64, 64), 4, dtype="f4")])
        target.use()
        context.vertex_array(program, buffer, "corner").render()
        data = np.frombuffer(target.read(components=4, dtype="f4"), "f4").reshape(64, 64, 4).astype(float)
        context.release()
        return data

    def test_values_are_those_of_the_reference(self):
        orientation, wide = (3 * math.cos(0.7), 3 * math.sin(0.7)), (2.5, -1.5)
        for version in ("100", "330"):
            for step, start, seed in ((0.125, 0.0625, 7), (0.125, -10.0, -900_000), (1.0, 400.0, 12345), (4.0, 0.0, 0), (2.0, -65536.0, 900_000)):
                x = (np.arange(64) - 32)[None, :] * step + start + np.zeros((64, 64))
                y = x.T
                first, second = noise(x, y, orientation, seed), noise(x, y, wide, seed)[0]
                # float rounding of p times the nodes per kernel radius would change a tiled value with large p
                tiled = noise(x, y, orientation, seed, (4, 0.75))[0].imag
                stripes = second / np.maximum(abs(second), 0.5)
                expected = [np.stack([*first.imag, tiled], -1), np.stack([stripes.real, stripes.imag, abs(second), first[0].imag], -1)]
                for value, wanted in zip(VALUES, expected):
                    found, scale = self.draw(version, value, (step, start, seed)), np.array([1, 20, 20, 1 + abs(start) * 4 + 1e3 * (step > 1)])
                    if value == VALUES[1]:
                        scale[:] = 1
                    error = abs(found - wanted) / scale
                    where = np.unravel_index(np.argmax(error), error.shape)
                    print(f"{version}, seed {seed}: largest difference {error.max():.3g} at {where}")
                    self.assertGreater(abs(found).max(), 1)
                    self.assertFalse(error.max() > 1e-5 or np.isnan(error).any(), f"{version} {step} {start} {seed} {where}")


    def test_skia_draws_it(self):
        try:
            import skia
        except ImportError as error:
            self.skipTest(f"needs skia-python: {error}")
        effect = skia.RuntimeEffect.MakeForShader(TEXT + """
            half4 main(float2 at) {
                float2 p = (at - 32.5) * 0.125;
                return half4(0.1 * gabor_noise_gradient(p, 3.0, 0.7, 7.0).xy, 0.1 * gabor_noise_tiled(p, float2(4.0), 3.0, 0.7, 7.0), 1.0);
            }""")
        surface = skia.Surface.MakeRaster(skia.ImageInfo.Make(64, 64, skia.kRGBA_F32_ColorType, skia.kPremul_AlphaType))
        surface.getCanvas().drawPaint(skia.Paint(Shader=effect.makeShader(skia.Data.MakeEmpty()), BlendMode=skia.BlendMode.kSrc))
        found = np.zeros((64, 64, 4), "f4")
        self.assertTrue(surface.readPixels(skia.Pixmap(surface.imageInfo(), found, 64 * 16)))
        x, wave = (np.arange(64) - 32)[None, :] * 0.125 + np.zeros((64, 64)), (3 * math.cos(0.7), 3 * math.sin(0.7))
        plain, tiled = noise(x, x.T, wave, 7).imag, noise(x, x.T, wave, 7, (4, 4))[0].imag
        error = abs(found[..., :3] - np.stack([plain[0], plain[1], tiled], -1) / 10) * (10, 0.5, 10)
        print(f"skia {skia.__version__}: largest difference {error.max():.3g} at {np.unravel_index(np.argmax(error), error.shape)}")
        self.assertGreater(abs(found[..., 0]).max(), 0.1)
        self.assertFalse(error.max() > 1e-5 or np.isnan(error).any())


class Exactness(unittest.TestCase):
    """With inverses off by an ulp, fused or not."""

    @staticmethod
    def inverses():
        literals = list(map(np.float32, re.findall(r"0\.\d+", re.search("inverses = .*", CODE)[0])))
        for off in (-1, 0, 1):
            yield [np.nextafter(each, np.float32(2 * each * (off > 0))) if off else each for each in literals]

    def test_residues_of_all_whole_numbers_are_exact(self):
        half = np.float32(re.search(r"inverses \+ ([\d.]+)", CODE)[1])
        x = np.arange(-1_050_000, 1_050_001)
        for inverses in self.inverses():
            self.assertEqual(len(inverses), 3)
            for inverse, prime in zip(inverses, PRIMES):
                self.assertIn(f"{prime}.0", CODE)
                plain = x.astype("f4") * inverse + half
                fused = (x.astype(float) * float(inverse) + float(half)).astype("f4")
                for quotient in (plain, fused):
                    np.testing.assert_array_equal(x - prime * np.floor(quotient).astype(int), x % prime)

    def test_sums_of_fractions_are_on_their_side_of_1(self):
        for inverses in self.inverses():
            for first in (0, 2):
                a, b = np.arange(1, PRIMES[first])[:, None], np.arange(1, PRIMES[1])[None, :]
                exact = a * PRIMES[1] + b * PRIMES[first] > PRIMES[first] * PRIMES[1]
                plain = a.astype("f4") * inverses[first] + b.astype("f4") * inverses[1]
                fused = (a * float(inverses[first]) + (b.astype("f4") * inverses[1]).astype(float)).astype("f4")
                for total in (plain, fused):
                    self.assertTrue(((total > 1) == exact).all() and (total != 1).all())


    def test_indices_wrap_exactly_where_division_does_not_round_well(self):
        index = np.arange(-900_000, 900_001)
        for period, off in itertools.product((3, 5, 6, 7, 1021, 65536, 299_993, 750_000), (-3, 0, 3)):
            quotient = (index / period).astype("f4") * np.float32(1 + off * 2.0**-23)
            found = index - period * np.floor(quotient).astype(int)
            found = found + np.where(found < 0, period, np.where(found < period, 0, -period))
            np.testing.assert_array_equal(found, index % period)


class Law(unittest.TestCase):
    def test_law_at_fixed_places_over_seeds(self):
        seeds = np.arange(-200_000, 200_000)
        for x, y in ((0.0, 0.0), (1 / 3, 1 / 3), (1 / 3, 0.0), (0.17, 100.1), (-5.3, 7.9)):
            z = np.concatenate([noise(np.full(100_000, x), np.full(100_000, y), (2.8, 2.8), part)[0] for part in seeds.reshape(4, -1)])
            for part in (z.real, z.imag):
                variance = (part ** 2).mean()
                rank = np.sort(1 / (1 + np.exp(-part * (1.5954352 + part**2 * (0.073597476 - part**2 * 0.00063190124)))))
                # Cramer-von Mises' integral over the law, in units of 1/1000
                cvm = 1000 * ((rank - (np.arange(len(rank)) + 0.5) / len(rank)) ** 2).mean()
                print(f"({x:.2f}, {y:.2f}): mean {part.mean():.4f}, variance {variance:.4f}, cvm {cvm:.4f}")
                self.assertLess(abs(part.mean()), 0.008)
                self.assertLess(abs(variance - 1), 0.01)
                self.assertLess(cvm, 0.01)
            self.assertLess(abs((z.real * z.imag).mean()), 0.009)


class Independence(unittest.TestCase):
    """The tests of tests/noise/test_lattice.cpp."""

    figures = [[(0, 0)], [(1, 0)], [(0, 1)], [(1, 1)], [(1, -1)], [(2, 0)], [(0, 2)], [(256, 0)], [(0, 256)], [(1021, 0)], [(0, 1019)],
               [(1, 0), (2, 0)], [(0, 1), (0, 2)], [(1, 0), (0, 1)], [(1, 0), (0, 1), (1, 1)], [(2, 0), (0, 1), (2, 1)],
               [(1, 0), (0, 3), (1, 3)], [(1, 0), (2, 0), (3, 0)], [(0, 1), (0, 2), (0, 3)], [(7, 0), (0, 5), (7, 5)],
               [(1021, 0), (1019, 0), (2040, 0)]]

    @classmethod
    def setUpClass(cls):
        """Words of lines by offset: a square, then one node over seeds."""
        k = np.arange(DRAWS)
        side = math.isqrt(DRAWS)
        cls.inputs = {"square": (k % side - side // 2, k // side - side // 2, 7), "seeds": (np.full(DRAWS, 3), np.full(DRAWS, -5), k)}
        cls.known = {}

    def lines(self, which, column, row, seed=0):
        x, y, s = self.inputs[which]
        found = []
        for axis, offset in ((0, column), (1, row)):
            if (which, axis, offset, seed) not in self.known:
                self.known[which, axis, offset, seed] = lines(x + column, y + row, s + seed)[axis]
            found.append(self.known[which, axis, offset, seed])
        return found

    def numbers(self, which, column, row, seed=0):
        a, b = uniforms(*self.lines(which, column, row, seed))
        return np.array([math.sqrt(3) * a, math.sqrt(3) * b, math.sqrt(45) / 2 * (a * a - 1 / 3), math.sqrt(45) / 2 * (b * b - 1 / 3)])

    def check(self, sums, about):
        largest = abs(sums).max() / math.sqrt(DRAWS)
        print(f"{largest:.2f} {about}")
        self.assertFalse(largest > FAR or math.isnan(largest), about)

    def test_nodes_are_independent(self):
        for which in self.inputs:
            first = self.numbers(which, 0, 0)
            for figure in self.figures:
                product = np.prod([self.numbers(which, *offset) for offset in figure], axis=0) if figure != [(0, 0)] else first
                self.check(np.triu(first @ first.T, 1) if figure == [(0, 0)] else first @ product.T, f"{which} {figure}")

    def test_seeds_are_independent(self):
        for which, other in itertools.product(self.inputs, (1, -1, 2, 1021, 100_000)):
            self.check(self.numbers(which, 0, 0) @ self.numbers(which, 0, 0, other).T, f"{which}, {other} seeds on")

    def test_corners_of_rectangles_are_independent(self):
        for which, (width, height) in itertools.product(self.inputs, ((1, 1), (2, 1), (1, 2), (2, 2), (7, 5))):
            a, b, c, d = (amplitude(*self.lines(which, *at)) for at in ((0, 0), (width, 0), (width, height), (0, height)))
            sums = np.array([(a * b.conj() * c * d.conj()).sum(), (a * b * c * d).sum()]) / math.sqrt(8)
            self.check(np.array([sums.real, sums.imag]), f"{which} {width} x {height}")

    def test_leading_bits_are_uniform(self):
        for which in [*self.inputs, "row", "column"]:
            k = np.arange(DRAWS)
            columns, rows = self.lines(which, 0, 0) if which in self.inputs else lines(*((k, -77) if which == "row" else (-77, k)), 7)
            for part in uniforms(columns, rows):
                sigma = chi_square(((part + 1) * 2048).astype(int), 4096)
                print(f"{sigma:.2f} {which}")
                self.assertLess(abs(sigma), FAR, which)

    def test_the_spectrum_of_a_square_is_flat(self):
        """A pattern would concentrate power in a few frequencies."""
        side = 1024
        columns, rows = lines(np.arange(side)[None, :], np.arange(side)[:, None], 7)
        for part in uniforms(columns, rows):
            power = abs(np.fft.fft2(part - part.mean())) ** 2 / (side * side / 3)
            print(f"largest power {power.max():.1f}, of a column or row {max(power.mean(0).max(), power.mean(1).max()):.2f}")
            self.assertLess(power.max(), math.log(side * side) + 9)  # an exponential law: exp(-9) by chance
            self.assertLess(max(power.mean(0).max(), power.mean(1).max()), 1 + 6 / 32)

    def test_lines_repeat_after_the_product_of_the_primes(self):
        whole, index, salt = math.prod(PRIMES), np.arange(-1000, 1000), (1, 20, 300)
        self.assertGreater(whole, 10**9)
        here = np.array(line(index, salt))
        np.testing.assert_array_equal(here, line(index + whole, salt))
        for prime in PRIMES:
            self.assertLess((here == line(index + whole // prime, salt)).all(0).mean(), 0.01)


if __name__ == "__main__":
    unittest.main()

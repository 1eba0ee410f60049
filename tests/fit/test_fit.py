"""gabor fit approximates photographs, and writes GLSL that draws what gabor render draws."""

import json
import os
import pathlib
import struct
import subprocess
import sys
import unittest

import numpy as np
import PIL.Image
import PIL.ImageCms
import PIL.ImageDraw

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "cli"), str(HERE.parent / "engines" / "moderngl")]
from exr import Exr, write_exr
from png import read_grey_png
from program import WINDOWS, ProgramTest
from textures import colour_noise, photograph, welch, without_trend, write_png
from tiff import write_tiff

SHADERS = pathlib.Path(os.environ["GABOR_SHADERS"])
DROP_INS = "".join((SHADERS / f"{name}.glsl").read_text() for name in ("gabor_noise", "gabor_filter"))
DIALECTS = ("450", "330 core", "300 es")


def rgb(exr):
    return np.stack([exr.channels[name] for name in "RGB"], -1).astype(float)


def relative_errors(found, expected):
    """Returns the L1 error of the total power and the L2 error of all cross-spectra."""
    total = lambda spectra: np.trace(spectra, axis1=2, axis2=3).real
    l1 = np.abs(total(found) - total(expected)).sum() / total(expected).sum()
    return l1, np.linalg.norm(found - expected) / np.linalg.norm(expected)


class FitTest(ProgramTest):
    def fit(self, image, *options):
        self.said = self.succeed("fit", image, "-o", "fit.json", *options)
        return json.loads((self.folder / "fit.json").read_text())

    def render(self, *options):
        self.succeed("render", "--preset", "fit.json", "-o", "fit.exr", *options)
        return Exr(self.folder / "fit.exr")

    def test_a_fit_has_the_recorded_values(self):
        """Compares every number in two presets, their GLSL and their reports with those in fits.txt."""
        colour = np.exp(3 * (colour_noise(300)[:224] - 1))  # one component is weak, and some pixels are transparent
        colour[..., 2] = 0.5 * colour[..., 0] + 0.4 * colour[..., 1] + 0.1 * colour[..., 2]
        alpha = np.hypot(*np.ogrid[-60:164, -200:100]) > 30
        grey = colour_noise(840)[:800, :, 0]
        grey = (0.2 + 0.3 * np.exp(4 * (grey - grey.mean()))) * np.linspace(0.4, 1.2, 840)  # unevenly lit
        y, x = np.fft.fftfreq(260)[:, None], np.fft.fftfreq(300)
        grain = np.random.default_rng(1).standard_normal((3, 260, 300))
        wave = np.fft.ifft2(np.fft.fft2(grain[0]) * np.exp(-2e4 * (x - 0.11)**2 - 1e4 * (y + 0.04)**2))  # a wide kernel
        wave /= wave.std()
        yellow, blue = 0.5 + 0.1 * wave.real + 0.05 * grain[1], 0.4 + 0.05 * wave.imag + 0.03 * grain[2]
        texts = []
        for values, lobes in ((np.dstack([colour, alpha]), "3"), (grey, "4"), (np.dstack([yellow, yellow, blue]), "3")):
            write_png(self.folder / "picture.png", values, bits=16)
            self.fit("picture.png", "--lobes", lobes, "--glsl", "sea.glsl")
            self.assertIn("of the photograph's\n", self.said)
            texts.append(self.said + (self.folder / "fit.json").read_text() + (self.folder / "sea.glsl").read_text())
        self.assert_numbers(HERE / "fits.txt", texts)

    def test_grey_photographs(self):
        for name, l1_most, l2_most in (("grass", 0.06, 0.05), ("brick", 0.06, 0.08)):
            try:
                path = photograph(name)
            except OSError as error:
                self.skipTest(str(error))
            fitted = self.fit(str(path))
            self.assertLessEqual(len(fitted["lobes"]), 16)
            self.assertIn("edges or objects", self.said) # blades, bricks
            exemplar = without_trend(read_grey_png(path)[..., None] / 255.0)
            fitted["colour"]["histogram"][0] = [0, 1, 0, 0, 0, 0] # no histogram: it changes the spectrum (brick: L1 0.03)
            (self.folder / "fit.json").write_text(json.dumps(fitted))
            noise = self.render("--size", "1024x1024").channels["G"][..., None].astype(float)
            noise -= noise.mean()
            expected = welch(exemplar)
            l1, l2 = relative_errors(welch(noise), expected)
            print(f"{name}: {len(fitted['lobes'])} lobes, L1 {l1:.3f}, L2 {l2:.3f} of a sample of 1024 x 1024")
            # In a sample of this size, chance alone causes an L1 error of 0.44 x 64 / 1024, and a larger L2 error.
            self.assertLess(l1, l1_most + 0.03)
            self.assertLess(l2, l2_most + 0.04)

    def test_colours(self):
        exemplar = colour_noise(512)
        write_png(self.folder / "colour.png", exemplar)
        fitted = self.fit("colour.png", "--lobes", "8", "--glsl", "sea.glsl")
        for words in ("edges or objects", "differs visibly", "repeats", "Large features"):
            self.assertNotIn(words, self.said)
        self.assertLessEqual((self.folder / "sea.glsl").read_text().count("\n"), 58)
        self.assertEqual(len(fitted["colour"]["weights"]), len(fitted["lobes"]))
        drawn = self.render("--size", "1024x1024")
        self.assertEqual(list(drawn.channels), ["B", "G", "R"])
        self.assertEqual(drawn.parameters["colour"], fitted["colour"])
        self.assertEqual(drawn.attributes["oiio:ColorSpace"][1], b"sRGB")
        values = rgb(drawn)
        flat = without_trend(exemplar)
        l1, l2 = relative_errors(welch(values - values.mean((0, 1))), welch(flat))
        variances, components = np.linalg.eigh(np.cov(flat.reshape(-1, 3).T))
        shares = np.cov((values.reshape(-1, 3) @ components).T).diagonal() / variances
        print(f"colour: L1 {l1:.3f}, L2 {l2:.3f}, mean {values.mean((0, 1))}, variances of components {shares}")
        self.assertLess(l2, 0.12)
        self.assertLess(np.abs(values.mean((0, 1)) - exemplar.mean((0, 1))).max(), 0.01)
        self.assertGreater(shares.min(), 0.85)
        self.assertLess(shares.max(), 1.15)
        fitted["lobes"].pop()
        (self.folder / "fit.json").write_text(json.dumps(fitted))
        self.assert_refused(["colour requires weights for each lobe"], "render", "--preset", "fit.json", "-o", "fit.exr")

    def drawn(self, main, width, height):
        """Returns the picture drawn by `main`, a main function that is compiled after the drop-ins and sea.glsl."""
        import draw
        values, _ = draw.drawn("#version 330 core\n", DROP_INS + (self.folder / "sea.glsl").read_text() + main, (width, height), 4)
        return np.frombuffer(values, "f4").reshape(height, width, 4)

    def test_glsl_draws_the_preset(self):
        name, quoted = ("a ~ü.png", "a ~ü.png") if WINDOWS else ("a ~\n\x7f\\.png", "a ~___.png") # names that systems accept
        write_png(self.folder / name, colour_noise(256))
        self.fit(name, "--lobes", "4", "--glsl", "sea.glsl")
        glsl = (self.folder / "sea.glsl").read_text()
        self.assertEqual(glsl.partition(", by gabor fit. ")[0], f"// sea.glsl: Gabor noise after {quoted}")
        main = """
out vec4 value;
void main()
{
    value = gl_FragCoord.y < 128.0 ? vec4(sea(gl_FragCoord.xy), 0.0)
          : sea_filtered(gl_FragCoord.xy - vec2(0.0, 128.0), vec2(1.0, 0.0), vec2(0.0, 1.0));
}
"""
        for dialect in DIALECTS:
            text = f"#version {dialect}\n" + "precision highp float;\n" * dialect.endswith("es") + DROP_INS + glsl + main
            path = self.folder / "shader.frag"
            path.write_text(text if dialect != "450" else text.replace("\nout vec4", "\nlayout(location = 0) out vec4"))
            subprocess.run([os.environ["GLSLANG_VALIDATOR"], "--quiet", path], check=True)

        values = self.drawn(main, 128, 256)

        drawn = rgb(self.render("--size", "128x128"))
        difference = np.abs(values[:128, :, :3] - drawn)
        print(f"glsl: largest difference {difference.max():.2g} at {np.unravel_index(difference.argmax(), difference.shape)}")
        self.assertLess(difference.max(), 1e-4)
        self.assertGreater(drawn.std(), 0.02)
        filtered = self.render("--size", "128x128", "--filter")
        difference = np.abs(values[128:, :, :3] - rgb(filtered))
        print(f"filtered: largest difference {difference.max():.2g}")
        self.assertLess(difference.max(), 1e-4)
        removed = values[128:, :, 3]
        self.assertGreater(removed.min(), 0)
        self.assertLess(removed.max(), 0.5)
        kept = rgb(filtered).var((0, 1)).sum() / drawn.var((0, 1)).sum()
        self.assertLess(abs(kept + removed.mean() - 1), 0.03)
        # A pixel that covers everything removes all of the variance: the shares of all components and degrees sum to 1.
        values = self.drawn("""
out vec4 value;
void main() { value = sea_filtered(gl_FragCoord.xy, vec2(1.0e5, 0.0), vec2(0.0, 1.0e5)); }
""", 2, 2)
        self.assertLess(np.abs(values[..., 3] - 1).max(), 1e-5)
        self.assertEqual(np.ptp(values[..., :3], (0, 1)).max(), 0)

    def test_readable_formats(self):
        exemplar = colour_noise(192)
        write_png(self.folder / "rgba.png", exemplar, alpha=True)
        write_png(self.folder / "deep.png", exemplar, bits=16)
        write_png(self.folder / "grey.png", np.repeat(exemplar[..., :1], 3, -1))
        write_png(self.folder / "faint.png", 0.5 + 0.01 * (exemplar - exemplar.mean((0, 1))), bits=16)
        self.assertIn("colour", self.fit("rgba.png", "--lobes", "2"))
        self.assertNotIn("transparent", self.said)
        sixteen = self.fit("deep.png", "--lobes", "2")["colour"]
        for kind, tile in (("u1", (64, 32)), ("<u2", None), (">u2", (16, 128))):
            most = np.iinfo(kind).max
            write_tiff(self.folder / "rgb.tif", np.rint(most * np.clip(exemplar, 0, 1)).astype(kind), tile, deflate=tile is None)
            colour = self.fit("rgb.tif", "--lobes", "2")["colour"]
            if kind == "u1":
                np.testing.assert_allclose(colour["mixing"], sixteen["mixing"], atol=2e-3)
            else:
                self.assertEqual(colour, sixteen)
        write_png(self.folder / "deep.png", exemplar, bits=16, interlaced=True)
        self.assertEqual(self.fit("deep.png", "--lobes", "2")["colour"], sixteen)
        grey = self.fit("grey.png", "--lobes", "2")
        self.assertIn("grey", self.said)
        write_png(self.folder / "one.png", exemplar[..., 0])
        self.assertEqual(self.fit("one.png", "--lobes", "2"), grey)
        for order in (0, 0, 1), (0, 1, 0):  # two channels are equal
            write_png(self.folder / "two.png", np.stack([0.5 * exemplar[..., 0], 1 - 0.5 * exemplar[..., 1]], -1)[..., order])
            self.fit("two.png", "--lobes", "1")
            self.assertIn("colour", self.said)
        # At a hundredth of the contrast, rounding 16 bits to 8 would show.
        faint = self.fit("faint.png", "--lobes", "2")["colour"]
        ratio = np.array(faint["mixing"]) / np.array(sixteen["mixing"])
        self.assertLess(np.abs(ratio - 0.01).max(), 0.0005)

    def test_jpeg(self):
        picture = PIL.Image.fromarray(np.rint(255 * np.clip(colour_noise(192), 0, 1)).astype("u1"))
        picture.save(self.folder / "good.jpg", quality=95)
        picture.convert("L").save(self.folder / "grey.jpg", progressive=True)
        picture.convert("CMYK").save(self.folder / "cmyk.jpg")
        whole = (self.folder / "good.jpg").read_bytes()
        (self.folder / "cut.jpg").write_bytes(whole[:len(whole) // 2])
        picture.save(self.folder / "good.png")
        by_png = self.fit("good.png", "--lobes", "2")["colour"]["mean"]
        by_jpeg = self.fit("good.jpg", "--lobes", "2")["colour"]["mean"]
        self.assertLess(np.abs(np.array(by_png) - by_jpeg).max(), 0.005)
        self.fit("grey.jpg", "--lobes", "2")
        self.assertIn("grey", self.said)
        (self.folder / "fit.json").unlink()
        self.assert_refused(["cmyk.jpg", "CMYK", "only grey and RGB"], "fit", "cmyk.jpg", "-o", "fit.json")
        self.assert_refused(["cut.jpg"], "fit", "cut.jpg", "-o", "fit.json")

    def assert_same_colours(self, found, expected, most):
        """Checks that the mean and the mixing differ by less than `most` times the first component's deviation."""
        first = np.linalg.norm(np.array(expected["mixing"])[:, 0])
        for name in ("mean", "mixing"):
            self.assertLess(np.abs(np.array(found[name]) - expected[name]).max(), most * first, name)

    def test_tagged_photographs(self):
        """EXIF data turn a photograph; an ICC profile other than sRGB is named."""
        picture = PIL.Image.fromarray(np.rint(255 * np.clip(colour_noise(160)[:144], 0, 1)).astype("u1"))
        srgb = PIL.ImageCms.ImageCmsProfile(PIL.ImageCms.createProfile("sRGB")).tobytes()
        picture.save(self.folder / "upright.png", icc_profile=srgb)
        expected = self.fit("upright.png", "--lobes", "2")
        self.assertNotIn("profile", self.said)
        exif = PIL.Image.Exif()
        exif[0x0112] = 6 # turn clockwise
        linear = srgb.replace(b"para\0\0\0\0\0\3\0\0\0\2\x66\x66", b"para\0\0\0\0\0\0\0\0\0\1\0\0")
        picture.transpose(PIL.Image.Transpose.ROTATE_90).save(self.folder / "turned.png", exif=exif, icc_profile=linear)
        self.assertEqual(self.fit("turned.png", "--lobes", "2"), expected)
        self.assertEqual(self.said.count("its ICC profile is 'sRGB built-in'"), 1)

    def test_tga(self):
        picture = PIL.Image.fromarray(np.rint(255 * np.clip(colour_noise(160), 0, 1)).astype("u1"))
        picture.save(self.folder / "noise.png")
        picture.save(self.folder / "noise.tga", compression="tga_rle")
        expected = self.fit("noise.png", "--lobes", "2")
        self.assertEqual(self.fit("noise.tga", "--lobes", "2"), expected)
        (self.folder / "cut.tga").write_bytes((self.folder / "noise.tga").read_bytes()[:9])
        self.assert_refused(["cut.tga", "TGA"], "fit", "cut.tga", "-o", "fit.json")
        (self.folder / "large.tga").write_bytes(struct.pack("<BBBHHBHHHHBB", 0, 0, 2, 0, 0, 0, 0, 0, 32768, 16384, 24, 0))
        self.assert_refused(["large.tga", "268 million pixels"], "fit", "large.tga", "-o", "fit.json")

    def test_transparent_pixels_do_not_count(self):
        picture = np.concatenate([colour_noise(256), np.ones((256, 256, 1))], -1)
        write_png(self.folder / "whole.png", picture[..., :3])
        y, x = np.mgrid[:256, :256]
        picture[(x - 200)**2 + (y - 60)**2 < 40**2] = (1, 0, 1, 0)
        PIL.Image.fromarray(np.rint(255 * np.clip(picture, 0, 1)).astype("u1")).save(self.folder / "hole.png")
        whole = self.fit("whole.png", "--lobes", "4")["colour"]
        hole = self.fit("hole.png", "--lobes", "4")["colour"]
        self.assertIn("7.65 % of the pixels: they are transparent", self.said)
        self.assert_same_colours(hole, whole, 0.05)
        picture[..., 3] = 0
        PIL.Image.fromarray(np.rint(255 * np.clip(picture, 0, 1)).astype("u1")).save(self.folder / "nothing.png")
        self.assert_refused(["nothing.png", "transparent"], "fit", "nothing.png", "-o", "fit.json")

    def test_fireflies_do_not_count(self):
        picture = 24 * colour_noise(256).astype("f4") - 14  # also negative
        write_exr(self.folder / "calm.exr", {name: picture[..., c] for c, name in enumerate("RGB")})
        generator = np.random.default_rng(1)
        picture[generator.integers(0, 256, 100), generator.integers(0, 256, 100)] = 1000
        write_exr(self.folder / "bright.exr", {name: picture[..., c] for c, name in enumerate("RGB")})
        calm = self.fit("calm.exr", "--lobes", "4")["colour"]
        self.assertNotIn("brighter", self.said)
        self.assertEqual(self.render("--size", "64x64").attributes["oiio:ColorSpace"][1], b"lin_rec709")
        bright = self.fit("bright.exr", "--lobes", "4")["colour"]
        self.assertIn("0.153 % of the pixels: they are far brighter", self.said)
        self.assert_same_colours(bright, calm, 0.02)
        # Pixels on either side of the limit; quantiles are rounded down to 8 bits.
        noise = colour_noise(160)
        noise /= np.ptp(np.quantile(noise.max(-1), (0.05, 0.95)))
        for low, high, apart in (-1.5, 6, 0.05), (-6, -1.5, 0.05), (0.3, 0.4, 0.005):
            picture = (high - low) * (noise - np.quantile(noise.max(-1), 0.05)) + low
            limit = max(high + 4 * (high - low), 1)
            picture[5:155:10, 3] = (1 - apart) * limit
            picture[5:155:10, 80] = (1 + apart) * limit
            write_exr(self.folder / "limit.exr", {name: picture[..., c].astype("f4") for c, name in enumerate("RGB")})
            self.fit("limit.exr", "--lobes", "1")
            self.assertIn("0.0586 % of the pixels: they are far brighter", self.said, (low, high))

    def test_uneven_lighting_does_not_count(self):
        even = 0.5 * colour_noise(256)[..., 0]
        light = np.linspace(0.4, 1.6, 256)
        square = np.linspace(-1, 1, 256) ** 2
        write_png(self.folder / "even.png", even, bits=16)
        write_png(self.folder / "lit.png", even * light * np.linspace(0.7, 1.3, 256)[:, None], bits=16)
        write_png(self.folder / "vignetted.png", even * (1.3 - 0.45 * np.add.outer(square, square)), bits=16)
        write_png(self.folder / "added.png", even + 0.2 * light, bits=16)
        expected = self.fit("even.png", "--lobes", "4")["colour"]
        # Uncorrected, light from 0.4 to 1.6 along one axis would multiply a normal texture's deviation by 1.06, and raise its kurtosis by 1.2.
        for name in ("lit", "vignetted", "added"):
            found = self.fit(f"{name}.png", "--lobes", "4")["colour"]
            self.assertLess(abs(found["mixing"][0][0] / expected["mixing"][0][0] - 1), 0.02, name)
            self.assertLess(np.abs(np.array(found["histogram"][0]) - expected["histogram"][0]).max(), 0.03, name)

    def test_a_noise_tiles_at_the_size_of_its_photograph(self):
        waves = 0.5 + 0.2 * np.sin(np.add.outer(0.7 * np.arange(128), 0.001 * np.arange(512)))
        for values in (waves, waves.T):
            write_png(self.folder / "waves.png", values, bits=16)
            self.fit("waves.png", "--lobes", "1")
            self.render("--tileable")

    def test_the_lobes_of_stripes_are_not_too_narrow_for_a_preset(self):
        stripes = np.broadcast_to(np.random.default_rng(1).uniform(0.2, 0.8, 256), (256, 256))
        for values in (stripes, stripes.T):
            write_png(self.folder / "stripes.png", values, bits=16)
            self.fit("stripes.png", "--lobes", "1")
            self.render("--size", "64x64")

    def test_a_grey_preset_has_the_histogram(self):
        values = colour_noise(256)[..., 0]
        values = 0.2 + 0.6 * np.exp(4 * (values - values.mean())) / 2
        write_png(self.folder / "skewed.png", values, bits=16)
        self.fit("skewed.png", "--lobes", "6")
        drawn = rgb(self.render("--size", "1024x1024"))
        self.assertEqual(np.ptp(drawn, -1).max(), 0)
        share = np.linspace(0.05, 0.95, 19)
        apart = np.quantile(drawn, share) - np.quantile(without_trend(values[..., None]) + values.mean(), share)
        print(f"grey histogram: quantiles within {np.abs(apart).max():.4f}, deviation {values.std():.4f}")
        self.assertLess(np.abs(apart).max(), 0.15 * values.std())

    def test_warnings(self):
        picture = PIL.Image.new("L", (256, 256), 255)
        draw = PIL.ImageDraw.Draw(picture)
        letters = np.random.default_rng(1).integers(0, (5, 9), (40, 4, 2))
        for y in range(0, 256, 14):  # each line says the same
            for column, letter in enumerate(letters):
                draw.line([(2 + 6 * column + int(right), y + int(down)) for right, down in letter], fill=0)
        picture.save(self.folder / "text.png")
        self.fit("text.png", "--lobes", "8")
        for words in ("differs visibly", "edges or objects", "Heitz and Neyret 2018, Deliot and Heitz 2019"):
            self.assertIn(words, self.said)
        bands = np.repeat(np.random.default_rng(2).permutation([0.2, 0.8] * 8), 16)[:, None] * np.ones(256)
        for name, values in ("rows.png", bands), ("columns.png", bands.T):
            write_png(self.folder / name, values)
            self.fit(name, "--lobes", "1")
            self.assertIn("edges or objects", self.said, name)
        write_png(self.folder / "sine.png", np.tile(0.5 + 0.3 * np.sin(np.arange(256) * 0.48), (256, 1)))
        self.fit("sine.png")
        self.assertNotIn("edges or objects", self.said)
        self.assertIn("repeats", self.said)
        self.assertNotIn("Large features", self.said)
        grain = np.random.default_rng(1).standard_normal((256, 256)) + 0.5 * np.sin(np.arange(256) * 2 * np.pi / 100)
        write_png(self.folder / "waves.png", 0.5 + 0.1 * grain, bits=16)
        self.fit("waves.png", "--lobes", "1")  # the only lobe fits the grain, not the long waves
        self.assertIn("Large features", self.said)
        self.assertNotIn("edges or objects", self.said)
        write_png(self.folder / "noise.png", colour_noise(256))
        self.assertNotIn("NaN", json.dumps(self.fit("noise.png", "--lobes", "1")))

    def test_a_tiff_is_read_as_a_png_is(self):
        values = np.round(255 * colour_noise(160)).astype("u1")
        wanted = self.same_fit("noise.png", PIL.Image.fromarray(values))
        for name, options in ("strips.tif", {}), ("lzw.tif", {"compression": "tiff_lzw", "tiffinfo": {317: 2}}):
            self.assertEqual(self.same_fit(name, PIL.Image.fromarray(values), **options), wanted)
        clear = np.full(values.shape[:2], 255, "u1")
        clear[20:50, 30:90] = 0
        covered = PIL.Image.fromarray(np.dstack([values, clear]))
        self.assertEqual(self.same_fit("alpha.tif", covered), self.same_fit("alpha.png", covered))
        self.assertIn("transparent", self.said)
        self.assertEqual(self.same_fit("grey.tif", PIL.Image.fromarray(values[..., 1])), self.same_fit("grey.png", PIL.Image.fromarray(values[..., 1])))
        PIL.Image.fromarray(values).quantize(200).save(self.folder / "palette.tif")
        self.assert_refused(["'palette.tif'", "neither grey, from black to white, nor RGB"], "fit", "palette.tif", "-o", "fit.json")

    def same_fit(self, name, picture, **options):
        picture.save(self.folder / name, **options)
        return self.fit(name, "--lobes", "2")

    def test_wrong_pictures_are_refused(self):
        write_png(self.folder / "narrow.png", colour_noise(160)[:, :96])
        write_png(self.folder / "constant.png", np.full((256, 256), 0.5))
        slope = np.linspace(0, 1, 256)
        write_png(self.folder / "trend.png", np.broadcast_to(0.2 + 0.5 * slope[:, None], (256, 256)), bits=16)
        write_png(self.folder / "good.png", colour_noise(160))
        (self.folder / "cut.png").write_bytes((self.folder / "good.png").read_bytes()[:20000])
        (self.folder / "video.mp4").write_bytes(b"\0\0\0\x20ftypisom" + bytes(200))
        (self.folder / "folder").mkdir()
        values = colour_noise(160).astype("f4")
        values[100, 50, 2] = np.nan
        write_exr(self.folder / "nan.exr", {name: values[..., c] for c, name in enumerate("RGB")})
        for words, image in ((["narrow.png", "96 x 160", "128 x 128"], "narrow.png"), (["constant.png", "no texture"], "constant.png"),
                             (["trend.png", "no texture"], "trend.png"), (["cut.png"], "cut.png"),
                             (["video.mp4", "PNG, JPEG, TGA, TIFF, OpenEXR, .npy or .asc"], "video.mp4"),
                             (["folder", "not a regular file"], "folder"), (["nan.exr", "not finite"], "nan.exr"), (["none.png", "No such file"], "none.png")):
            self.assert_refused(words, "fit", image, "-o", "fit.json")
        for words, options in ((["--lobes", "1 to 16"], ["--lobes", "17"]), (["--lobes", "1 to 16"], ["--lobes", "x"]),
                               (["--glsl", "texture.glsl"], ["--glsl", "texture.glsl"]),
                               *((["--glsl", "NAME.glsl"], ["--glsl", name]) for name in
                                 ("a-b.glsl", "a_.glsl", "a__b.glsl", "gl_a.glsl", "1a.glsl", "_a.glsl", ".glsl", "a.frag"))):
            self.assert_refused(words, "fit", "good.png", "-o", "fit.json", *options)
        self.assert_refused(["-o", ".json"], "fit", "good.png", "-o", "fit.txt")


if __name__ == "__main__":
    unittest.main()

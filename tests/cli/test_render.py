"""Tests what each option of `gabor render` does to the file."""

import contextlib
import json
import os
import pty
import re
import subprocess
import time
import unittest

import numpy as np

from exr import Exr, write_exr
from png import read_grey_png
from program import PROGRAM, WINDOWS, RenderTest, gabor, start

SMALL = {"size": "61x47", "scale": 9.0, "frequency": 3.0, "orientation": 30.0, "seed": 7}
DEFAULTS = {"recipe": "lattice", "frequency": 4, "orientation": 0, "seed": 0, "scale": 32, "width": 1024, "height": 1024,
            "tileable": False, "evolution": 0, "gradient": False, "frequency_spread": 0,
            "orientation_spread": 0, "filter": False, "view": "flat", "paint": "", "phasor": False,
            "material": "none", "fractal": "none"}
LOBES = [{"frequency": 3, "orientation": 20, "power": 2, "stretch": 2.5}, {"frequency": 5, "orientation": -70, "radius": 0.6},
         {"frequency": 1, "orientation_spread": 90, "power": 0.5, "radius": 1.7, "stretch": 0.7}]
# Parameters that only some requests have.
OF_SOME = {"lobes": None, "depth": 0, "solid": False, "yaw": 0, "pitch": 30, "zoom": 1, "light_azimuth": -135,
           "light_elevation": 38, "environment": "room", "boards": False, "coat": False, "finish": False}


class Materials(RenderTest):
    def test_parameters(self):
        plain = self.render("--material=wood", size="64x64", scale=16)
        self.assertEqual(plain.parameters["wood.rings"], 13)
        other = self.render("--material=wood", "--wood.earlywood-colour=#0b0A80", "--wood.latewood-colour=0.25,0.5,1", "--wood.rings=30", size="64x64",
                            scale=16)
        # The conversion to linear light is that of the sRGB standard, IEC 61966-2-1.
        np.testing.assert_allclose(other.parameters["wood.earlywood_colour"], [0.003346536, 0.003035270, 0.2158605], rtol=1e-6)
        self.assertEqual(other.parameters["wood.latewood_colour"], [0.25, 0.5, 1])
        self.assertEqual(other.parameters["wood.rings"], 30)
        self.assertFalse(np.allclose(other.channels["R"], plain.channels["R"]))
        again = self.render("--like=out.exr", output="again.exr")
        self.assertEqual(again.parameters, other.parameters)
        for name in other.channels:
            np.testing.assert_array_equal(again.channels[name], other.channels[name])


class Files(RenderTest):
    def test_header(self):
        exr = self.render(**SMALL)
        self.assertEqual(exr.types, {"Y": "<f4"})
        self.assertEqual(exr.box("displayWindow"), (0, 0, 60, 46))
        self.assertEqual(exr.box("dataWindow"), (0, 0, 60, 46))
        self.assertEqual(exr.attributes["gabor"][0], "string")
        self.assertEqual(exr.parameters, {**DEFAULTS, "frequency": 3, "orientation": 30, "seed": 7, "scale": 9,
                                          "width": 61, "height": 47})

    def test_defaults(self):
        exr = self.render()
        self.assertEqual(exr.pixels.shape, (1024, 1024))
        self.assertEqual(exr.parameters, DEFAULTS)

    def test_parameters_keep_every_digit(self):
        given = {"scale": 2.0000000000000004, "frequency": 0.1, "orientation": -12.345678901234567}
        exr = self.render(size="1x1", **given)
        self.assertEqual({name: exr.parameters[name] for name in given}, given)

    def test_the_same_request_gives_the_same_bytes(self):
        self.render(output="a.exr", **SMALL)
        self.render(output="b.exr", **SMALL)
        files = self.files()
        self.assertEqual(files["a.exr"], files["b.exr"])

    def test_it_replaces_an_older_file_and_writes_no_other(self):
        (self.folder / "out.exr").write_text("older")
        self.assertEqual(self.render(**SMALL).pixels.shape, (47, 61))
        self.assertEqual(list(self.files()), ["out.exr"])

    def test_png(self):
        exr = self.render(**SMALL, region="3,5,50,37", png="out.png")
        shown = read_grey_png(self.folder / "out.png")
        expected = 255 * np.clip(0.5 + 0.25 * exr.pixels.astype(float), 0, 1)
        self.assertEqual(shown.shape, expected.shape)
        self.assertLess(np.abs(shown - expected).max(), 0.501)
        self.assertGreater(np.ptp(shown), 200)


class Regions(RenderTest):
    def test_a_region_has_the_pixels_of_the_whole(self):
        """Compares every channel, including those of pictures with several bands of 16 MiB."""
        (self.folder / "lobes.json").write_text(json.dumps(LOBES))
        some, many = [(21, 13, 33, 17)], [(0, 0, 1, 1), (2499, 3999, 1, 1), (1, 1700, 2499, 333), (777, 13, 9, 3987)]
        wave = {"scale": 20, "frequency": 3, "orientation": 20}
        for size, regions, flags, options in (
                ("201x157", [(13, 7, 101, 33), (200, 156, 1, 1), (77, 0, 1, 157), (0, 99, 201, 1)],
                 [], {"scale": 9.3, "orientation": 20}),
                ("65536x1", [(65535, 0, 1, 1), (40001, 0, 999, 1)], [], {}),
                ("1x9999", [(0, 9998, 1, 1), (0, 4001, 1, 999)], [], {}),
                ("2500x4000", many, [], wave),
                *(("81x67", some, [], {"recipe": recipe, **wave}) for recipe in ("lattice-4", "one")),
                *(("81x67", some, flags, {"lobes": "lobes.json", "scale": 12}) for flags in ([], ["--phasor"], ["--filter"], ["--tileable"])),
                *(("61x47", some, ["--filter"], {"view": view}) for view in ("horizon", "slice", "sphere")),
                *(("61x47", some, [], options) for options in ({"recipe": "paper"}, {"material": "zebra"}, {"view": "terrain"},
                                                               {"view": "landscape"}))):
            whole = self.render(*flags, output="whole.exr", size=size, **options)
            width, height = map(int, size.split("x"))
            for x, y, w, h in regions:
                with self.subTest(size=size, region=(x, y, w, h), flags=flags, **options):
                    part = self.render(*flags, size=size, region=f"{x},{y},{w},{h}", **options)
                    for name, values in whole.channels.items():
                        self.assert_same_bits(part.channels[name], values[y:y + h, x:x + w])
                    self.assertEqual(part.box("dataWindow"), (x, y, x + w - 1, y + h - 1))
                    self.assertEqual(part.box("displayWindow"), (0, 0, width - 1, height - 1))
                    self.assertEqual(part.parameters, whole.parameters)

    def test_the_corner_of_the_largest_picture(self):
        part = self.render(size="65536x65536", region="65500,65500,36,36", scale=2, frequency=1)
        self.assertTrue(np.isfinite(part.pixels).all())
        self.assertGreater(part.pixels.std(), 0.5)


class Like(RenderTest):
    def test_it_reproduces_the_whole_and_a_region(self):
        for option in ({"recipe": "paper"}, {"region": "11,13,29,17"}):
            made = self.render(output="made.exr", **option, **SMALL)
            again = self.render(like="made.exr")
            self.assert_same_bits(again.pixels, made.pixels)
            self.assertEqual(again.attributes, made.attributes)

    def test_it_takes_every_parameter(self):
        """Between them, the requests set every parameter to a value other than its default."""
        write_exr(self.folder / "paint.exr", {"frequency": np.full((2, 2), 3, "<f4"),
                                              "orientation": np.full((2, 2), 40, "<f4")})
        (self.folder / "lobes.json").write_text(json.dumps(LOBES[:3]))
        every = [["--gradient", "--tileable", "--evolution=0.25", "--recipe=pure", "--phasor"],
                 ["--frequency-spread=0.25", "--orientation-spread=30", "--filter"],
                 ["--view=slice", "--depth=1.5"], ["--view=torus", "--solid", "--yaw=20", "--pitch=-10", "--zoom=1.5"], ["--paint=paint.exr"], ["--lobes=lobes.json"],
                 ["--material=zebra", "--light-azimuth=20", "--light-elevation=50", "--environment=dark", "--boards", "--boards.board-width=0.8", "--coat", "--coat.level=0.01", "--finish", "--finish.dust-amount=0.3"],
                 ["--fractal=ridged", "--fractal.octaves=3.5", "--fractal.basis=perlin", "--fractal.warp=0.2", "--evolution=0.3"]]
        unlike = set()
        for flags in every:
            options = [f"--{name}={value}" for name, value in SMALL.items()]
            if {"--lobes=lobes.json", "--paint=paint.exr", "--material=zebra", "--fractal=ridged"} & {*flags}:
                options = ["--size=61x47", "--scale=24"]
            made = self.render(*options, *flags, output="made.exr")
            again = self.render(like="made.exr")
            self.assertEqual(again.attributes, made.attributes)
            for channel, values in made.channels.items():
                self.assert_same_bits(again.channels[channel], values)
            unlike |= {name for name, value in made.parameters.items() if "." not in name and value != {**DEFAULTS, **OF_SOME}[name]}
        self.assertEqual(unlike, {*DEFAULTS, *OF_SOME})

    def test_options_override_it(self):
        self.render(output="made.exr", **SMALL)
        for change in ({"size": "30x20", "frequency": 2, "seed": 8}, {"scale": 10, "orientation": 31, "region": "1,2,3,4"},
                       {"recipe": "paper"}):
            with self.subTest(**change):
                changed = self.render(like="made.exr", **change)
                expected = self.render(output="expected.exr", **{**SMALL, **change})
                self.assert_same_bits(changed.pixels, expected.pixels)
                self.assertEqual(changed.attributes, expected.attributes)

    def test_options_override_a_region(self):
        self.render(output="made.exr", region="11,13,29,17", **SMALL)
        self.assertEqual(self.render(like="made.exr", region="1,2,3,4").box("dataWindow"), (1, 2, 3, 5))
        self.assertEqual(self.render(like="made.exr", size="40x30").box("dataWindow"), (0, 0, 39, 29))

    def test_it_may_name_the_output(self):
        made = self.render(region="11,13,29,17", **SMALL)
        self.assert_same_bits(self.render(like="out.exr").pixels, made.pixels)


class Flags(RenderTest):
    def test_a_flag_can_be_taken_back(self):
        made = self.render("--tileable", "--gradient", "--no-phasor", output="made.exr", size="80x80")
        self.assertEqual((made.parameters["tileable"], made.parameters["gradient"]), (True, True))
        self.succeed("render", "-o", "again.exr", "--like=made.exr", "--no-tileable", "--no-gradient")
        self.succeed("render", "-o", "plain.exr", "--size=80x80")
        files = self.files()
        self.assertEqual(files["again.exr"], files["plain.exr"])
        self.assert_fails(2, ["tileable"], "render", "-o", "out.exr", "--tileable=3")

    def test_angles_have_units(self):
        for text, degrees in (("45", 45), ("-45.5deg", -45.5), ("0.7853981633974483rad", 45)):
            self.assertAlmostEqual(self.render(size="8x8", orientation=text).parameters["orientation"], degrees, delta=1e-12)


class Channels(RenderTest):
    def test_more_channels_leave_the_noise_as_it_was(self):
        exr = self.render("--gradient", **SMALL)
        self.assertEqual(sorted(exr.channels), ["Y", "gradient.x", "gradient.y"])
        self.assert_same_bits(self.render(**SMALL).pixels, exr.pixels)


class Periods(RenderTest):
    def test_the_header_records_a_tile(self):
        tile = self.render("--tileable", evolution=0.3, **SMALL)
        self.assertEqual((tile.parameters["tileable"], tile.parameters["evolution"]), (True, 0.3))
        self.assert_same_bits(self.render(like="out.exr").pixels, tile.pixels)

    def test_a_tile_too_small_for_its_kernels(self):
        self.assert_fails(2, ["tileable", "63 x 64", "two kernel radii"], "render", "-o", "out.exr", "--tileable", "--size", "63x64")

    def shown_on_a_terminal(self, *arguments):
        """Runs the program with stderr on a terminal. Returns what it shows there, and the seconds from the start to the end of
        each line."""
        try:
            own, other = pty.openpty()
        except OSError as error:  # a system without /dev/pts, such as a bare chroot
            self.skipTest(f"no pseudo-terminal: {error}")
        started = time.monotonic()
        with open(own, newline="", errors="replace") as terminal:
            with os.fdopen(other, "w") as end:
                run = subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=end)
            shown, times = "", []
            with contextlib.suppress(OSError):  # at the end of the program
                while text := terminal.read(1):
                    shown += text
                    if text == "\r":
                        times.append(time.monotonic() - started)
        self.assertEqual(run.wait(), 0, shown)
        if time.monotonic() - started < 1:
            self.skipTest("the program ended before it shows progress, half a second after its start")
        return shown, times

    def assert_progress(self, label, shown):
        """Checks that each line has a share of the work, at most 100 %, and returns the shares and the seconds left."""
        lines = re.findall(r"\r([^\r\x1b]+)", shown)
        found = [re.fullmatch(rf"{label} (\d+) %, (\d+) s left", line) for line in lines]
        self.assertTrue(found and all(found), shown)
        shares, left = zip(*(map(int, each.groups()) for each in found))
        self.assertEqual(list(shares), sorted(shares))
        self.assertTrue(50 <= shares[-1] <= 100, shown)
        return shares, left

    @unittest.skipIf(WINDOWS, "needs a pseudo-terminal, which Wine does not pass on as a console")
    def test_a_terminal_shows_progress(self):
        for picture in ("--view=ocean", "--size=400x1000"), ("--material=strata", "--size=2600"):
            with self.subTest(picture):
                shown, times = self.shown_on_a_terminal("render", "-o", "out.exr", *picture)
                shares, left = self.assert_progress("rendering", shown)
                self.assertGreater(len(shares), 1, shown)
                for at, share, rest in zip(times, shares, left):
                    if share >= 3:  # at first too many, as the driver still compiles; too few only if the machine gets three times as slow
                        self.assertGreaterEqual(rest, (times[-1] - at) / 3 - 0.6, f"s left at {share} %")
                self.assertTrue(shown.endswith("\r\x1b[K"), shown)  # the line is cleared

    @unittest.skipIf(WINDOWS, "needs a pseudo-terminal, which Wine does not pass on as a console")
    def test_other_commands_show_progress(self):
        for label, *command in (("rendering", "maps", "--material=strata", "--size=2200", "-o", "set"),
                                ("rendering", "texture", "--material=strata", "--tileable", "--size=2048", "-o", "texture.exr"),
                                ("eroding", "erode", "set/height.png", "--extent=1000", "-o", "eroded.exr")):
            with self.subTest(command[0]):
                self.assert_progress(label, self.shown_on_a_terminal(*command)[0])

    def test_frames_loop(self):
        self.succeed("render", "-o", "out.exr", "--png", "out.png", "--frames", "3", "--size=20x20", "--evolution=0.25")
        self.assertEqual(sorted(self.files()), [f"out.000{i}.{kind}" for i in (1, 2, 3) for kind in ("exr", "png")])
        for frame in (1, 2, 3):
            exr = Exr(self.folder / f"out.000{frame}.exr")
            self.assertAlmostEqual(exr.parameters["evolution"], 0.25 + (frame - 1) / 3)
            self.assert_same_bits(self.render(output="one.exr", like=f"out.000{frame}.exr").pixels, exr.pixels)
        for count in ("0", "-1", "10000", "two", "1.5"):
            self.assert_fails(2, ["--frames", count, "1 to 9999"], "render", "-o", "out.exr", "--frames", count)

    def test_only_frequencies_above_half_a_cycle_per_pixel_are_warned_of(self):
        paint = np.full((2, 2), 20, "<f4")
        write_exr(self.folder / "paint.exr", {"frequency": paint, "orientation": paint})
        (self.folder / "lobes.json").write_text('[{"frequency": 2}, {"frequency": 30, "orientation": 60}, {"frequency": 9}]')
        fast = ["--scale=40", "--frequency=24"]
        for options, warned in ((["--scale=40", "--frequency=16", "--frequency-spread=0.5"], "0.6"), ([*fast, "--orientation=90"], "0.6"),
                                ([*fast, "--orientation=45"], None), ([*fast, "--orientation=45", "--orientation-spread=3"], "0.6"),
                                ([*fast, "--orientation=200"], "0.564"), (["--scale=40", "--frequency=20.5"], "0.512"), (["--scale=40", "--frequency=19.5"], None), (["--scale=40", "--lobes=lobes.json"], "0.65"), ([*fast, "--filter"], None),
                                ([*fast, "--view=slice"], None), (["--paint=paint.exr"], None)):
            result = gabor("render", "-o", "out.exr", "--size=8x8", *options, cwd=self.folder)
            self.assertEqual(result.returncode, 0)
            self.assertRegex(result.stderr, rf"\Agabor: warning: .* is {warned} cycles per pixel; above 0\.5, .*\n\Z" if warned else r"\A\Z", options)

    def test_time_is_periodic(self):
        at = {time: self.render(evolution=time, **SMALL).pixels for time in (0, 0.001, 0.5, 1, -3)}
        self.assert_same_bits(at[0], at[1])
        self.assert_same_bits(at[0], at[-3])
        self.assertLess(np.abs(at[0.001] - at[0]).max(), 0.1)
        self.assertGreater(np.abs(at[0.5] - at[0]).max(), 1)


class Noise(RenderTest):
    def test_extremes_are_finite(self):
        for scale, frequency, orientation in [(2, 0.001, -36000), (2, 1, 36000), (4096, 0.001, 36000), (4096, 1024, -36000)]:
            exr = self.render(size="64x64", scale=scale, frequency=frequency, orientation=orientation)
            self.assertLess(np.abs(exr.pixels).max(), 12) # also fails for NaN


class Compression(RenderTest):
    def test_pixels_are_those_of_an_uncompressed_file(self):
        """`join`, which writes without compression, reads back what other programs would."""
        write_exr(self.folder / "map.exr", {"Y": np.pad(np.random.default_rng(1).random((40, 40), "f4"), ((0, 80), (0, 80)))})
        every = [*enumerate(("none", "rle", "zips", "zip", "piz"))]
        for command, methods in ((["erode", "map.exr", "--extent=10", "--nodata=0"], every), (["render", "--view=horizon", "--size=96x64"], every[3:]),
                                 (["maps", "--material=scratches", "--size=64x64", "--float", "-o", "maps"], every[3:4])):
            output = [] if "maps" in command else ["-o", "plain.exr"]
            self.succeed(*command, *output, "--compression=none")
            path = self.folder / (output[1] if output else "maps/maps.exr")
            plain, size = Exr(path).channels, path.stat().st_size
            for number, name in methods:
                with self.subTest(command=command, compression=name):
                    self.succeed(*command, *output, f"--compression={name}")
                    data = path.read_bytes()
                    self.assertIn(b"compression\0compression\0\1\0\0\0" + bytes([number]), data)
                    self.assertLess(len(data), size if number else size + 1)
                    if output:
                        self.succeed("join", path.name, "-o", "joined.exr")
                        for channel, values in Exr(self.folder / "joined.exr").channels.items():
                            np.testing.assert_array_equal(values, plain[channel], channel)

    def test_only_lossless_methods_and_not_for_textures(self):
        self.assert_refused(["--compression 'dwaa'", "none, rle, zips, zip, piz"], "render", "-o", "out.exr", "--compression=dwaa")
        self.assert_refused(["unknown '--compression=zip'"], "texture", "-o", "out.exr", "--size=64x64", "--compression=zip")
        for command in (["render"], ["erode", "map.exr"]):
            self.assert_refused(["--compression requires an EXR"], *command, "-o", "out.png", "--compression=zip")
        self.assert_refused(["--compression 'piz'", "none or zip for a TIFF"], "erode", "map.exr", "-o", "out.tif", "--compression=piz")


class Messages(RenderTest):
    def devices(self):
        return re.findall(r"^(\d+)  (.+)$", self.succeed("devices"), re.MULTILINE)

    def test_a_device_by_index_and_by_name(self):
        for index, name in self.devices():
            unique = sum(name.lower() in other.lower() for _, other in self.devices()) == 1
            for selector in [index] + [name[1:].swapcase()] * unique:
                with self.subTest(selector):
                    stdout = self.succeed("render", "-o", "out.exr", "--size=8x8", "--device", selector)
                    self.assertIn(name, stdout)

    def test_one_line_reports_what_was_done(self):
        stdout = self.succeed("render", "-o", "out.exr", "--size=61x47", "--region=0,0,11,13", "--recipe=paper")
        self.assertRegex(stdout, r"\Aout\.exr: 11 x 13 pixels, recipe paper, on [^\n]+\n\Z")
        name = self.devices()[0][1]
        for options, said in ((["-o", "a.png", "--material=scratches"], "a.png: 12 x 8 pixels, material scratches"),
                              (["--write-heightmap=b.r16", "--view=terrain"], "b.r16: 12 x 8 pixels, terrain"),
                              (["--png=c.png", "--write-heightmap=d.png", "--view=terrain"], "c.png: 12 x 8 pixels, terrain"),
                              (["-o", "e.exr", "--png=f.png", "--view=slice"], "e.exr: 12 x 8 pixels, recipe lattice")):
            self.assertEqual(self.succeed("render", "--size=12x8", "--device=0", *options), f"{said}, on {name}\n")
        self.assertEqual(self.succeed("maps", "--size=12x8", "--device=0", "-o", "h", "--material=scratches"),
                         f"h: maps of 12 x 8 pixels, material scratches, on {name}\n")

    @unittest.skipIf(WINDOWS, "Wine's processes are not those that wait4 measures")
    @unittest.skipIf(os.environ.get("GABOR_SANITIZE"), "sanitizers keep freed memory")
    def test_a_large_picture_needs_little_memory(self):
        # 256 MiB of pixels pass through bands of 16 MiB; writing to /dev/null keeps them off the disk.
        process = start("render", "-o", "/dev/null", "--size=8192x8192", cwd=self.folder)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        self.assertEqual(process.communicate()[1], "")
        self.assertEqual(process.returncode, 0)
        self.assertLess(usage.ru_maxrss, 256 << 10)


if __name__ == "__main__":
    unittest.main()

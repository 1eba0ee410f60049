"""Checks that regions joined by `gabor join` equal, byte for byte, the picture rendered in one piece."""

import pathlib
import unittest

from exr import Exr, write_exr
from program import WINDOWS, ProgramTest

PICTURE = ["--size=96x75", "--scale=8", "--frequency=1.5", "--orientation=30"]
STRIPS = ["0,0,96,32", "0,32,96,32", "0,64,96,11"]
UNEVEN = ["0,0,96,13", "0,13,96,41", "0,54,96,21"]
TILES = ["0,0,50,20", "50,0,46,33", "0,20,50,55", "50,33,20,42", "70,33,26,42"]


class JoinTest(ProgramTest):
    rendered = {} # the bytes of each rendered file, by its options

    def render(self, name, *options):
        if options not in self.rendered:
            self.succeed("render", "-o", name, *options)
            self.rendered[options] = self.bytes(name)
        (self.folder / name).write_bytes(self.rendered[options])
        return name

    def regions(self, windows, *options):
        return [self.render(f"region{i}.exr", *PICTURE, f"--region={window}", *options)
                for i, window in enumerate(windows)]

    def bytes(self, name):
        return (self.folder / name).read_bytes()


class Joined(JoinTest):
    def test_every_tiling(self):
        self.render("whole.exr", *PICTURE)
        for windows in (STRIPS, UNEVEN, TILES, ["0,0,96,75"]):
            regions = self.regions(windows)
            self.succeed("join", *regions[1:], regions[0], "-o", "joined.exr")
            self.assertEqual(self.bytes("joined.exr"), self.bytes("whole.exr"), windows)

    def test_all_channels(self):
        more = ["--gradient", "--phasor"]
        self.render("whole.exr", *PICTURE, *more)
        for windows in (STRIPS, TILES):
            self.succeed("join", *self.regions(windows, *more), "-o", "joined.exr")
            self.assertEqual(self.bytes("joined.exr"), self.bytes("whole.exr"), windows)

    def test_strips_that_end_at_or_near_the_end_of_a_band(self):
        for rows in (63, 64, 65):  # at this width 64 rows fill a band
            wide = [f"--size=65536x{rows}", "--scale=8"]
            self.render("whole.exr", *wide)
            others = [[(0, 0, 65536, 1), (0, 1, 65536, rows - 1)], [(0, 0, 32768, rows), (32768, 0, 32768, rows)]]
            for tiling in [[(0, 0, 65536, rows - 1), (0, rows - 1, 65536, 1)], *(others if rows == 65 else [])]:
                regions = [self.render(f"region{i}.exr", *wide, f"--region={','.join(map(str, window))}")
                           for i, window in enumerate(tiling)]
                self.succeed("join", *regions, "-o", "joined.exr")
                self.assertEqual(self.bytes("joined.exr"), self.bytes("whole.exr"), tiling)

    def test_it_reports_what_it_wrote(self):
        said = self.succeed("join", *self.regions(STRIPS), "-o", "joined.exr")
        self.assertEqual(said, "joined.exr: 96 x 75 pixels, from 3 regions\n")
        self.assertEqual(self.succeed("join", "joined.exr", "-o", "again.exr"), "again.exr: 96 x 75 pixels, from 1 region\n")


class Refused(JoinTest):
    def refuse(self, words, *regions):
        (self.folder / "old.exr").write_text("older")
        for output in ("old.exr", "new.exr"):
            self.assert_refused(["cannot join", *words], "join", *regions, "-o", output)

    def test_gaps(self):
        for windows in (STRIPS, TILES):
            regions = self.regions(windows)
            for i, window in enumerate(windows):
                corner = ",".join(window.split(",")[:2])
                self.refuse([f"no region contains the pixel {corner};"], *regions[:i], *regions[i + 1:])
        self.refuse(["no region contains the pixel 94,74;"], *self.regions(["0,0,96,74", "0,74,94,1"]))

    def test_overlaps(self):
        for windows in (["0,0,96,32", "0,31,96,44"], [*TILES, "60,40,1,1"], [*STRIPS, STRIPS[1]],
                        ["0,0,50,75", "49,0,47,75"], ["0,10,96,65", "0,0,40,75", "40,0,56,10"]):
            self.refuse(["overlap"], *self.regions(windows))
        self.refuse(["'region0.exr' (0,0,96,32) and 'region1.exr' (0,31,96,44) overlap"],
                    *self.regions(["0,0,96,32", "0,31,96,44"]))

    def test_other_pictures(self):
        regions = self.regions(STRIPS)
        others = {"its parameters": ["--seed=8"], "its channels": ["--gradient"]}
        for words, options in others.items():
            self.render("other.exr", *PICTURE, f"--region={STRIPS[2]}", *options)
            self.refuse(["'other.exr' differs from 'region0.exr'", words], *regions[:2], "other.exr")
        self.render("other.exr", "--size=96x76", *PICTURE[1:], "--region=0,64,96,12")
        self.refuse(["the size of its picture"], *regions[:2], "other.exr")

    def test_another_driver(self):
        regions = self.regions(STRIPS)
        path = self.folder / regions[1]
        mine = Exr(path).attributes["software"][1]
        self.assertIn(self.succeed("--version").strip().encode() + b", ", mine)
        path.write_bytes(path.read_bytes().replace(mine, mine.upper()))
        self.refuse([f"'region1.exr' was rendered by {mine.decode().upper()}, 'region0.exr' by {mine.decode()}"],
                    *regions)

    def test_files_that_are_not_regions(self):
        regions = self.regions(STRIPS)
        write_exr(self.folder / "foreign.exr", {"Y": Exr(self.folder / regions[0]).pixels})
        self.refuse(["'foreign.exr' has no 'gabor' attribute"], "foreign.exr", *regions[1:])
        self.assert_refused(["missing.exr"], "join", *regions, "missing.exr", "-o", "new.exr")
        self.assert_refused(["region0.exr", "is one of the regions"], "join", *regions, "-o", regions[0])
        self.assert_refused(["-o"], "join", *regions)
        self.assert_refused(["REGION"], "join", "-o", "new.exr")
        self.assert_refused(["--half requires --texture"], "join", *regions, "--half", "-o", "new.exr")

    def test_damaged_regions(self):
        for windows in (STRIPS, TILES):
            regions = self.regions(windows)
            path = pathlib.Path(self.folder / regions[1])
            path.write_bytes(path.read_bytes()[:-20])
            self.assert_refused([regions[1], "truncated"], "join", *regions, "-o", "new.exr")

    def test_a_name_of_another_format(self):
        self.assert_refused(["-o 'whole.png'", "ends in .exr"], "join", *self.regions(STRIPS), "-o", "whole.png")

    @unittest.skipIf(WINDOWS, "Windows has no /dev/full; windows/test_files fills a disk")
    def test_a_full_disk(self):
        self.assert_fails(1, ["/dev/full"], "join", *self.regions(STRIPS), "-o", "/dev/full")


if __name__ == "__main__":
    unittest.main()

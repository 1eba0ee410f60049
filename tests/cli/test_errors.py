"""Invalid requests print one line that says what was wrong and what is accepted, exit with status 2 and write nothing."""

import itertools
import os
import shutil
import subprocess
import unittest

import numpy as np

from exr import Exr, write_exr
from program import LAVAPIPE, PROGRAM, WINDOWS, ProgramTest, gabor


class ErrorTest(ProgramTest):
    def refuse_render(self, words, *options, **settings):
        """Checks that an existing file stays as it was and that no other is written."""
        (self.folder / "old.exr").write_text("older")
        self.assert_refused(words, "render", "-o", "old.exr", *options, **settings)


class Values(ErrorTest):
    def test_size(self):
        for text in ("0", "65537", "0x1", "1x0", "0x0", "-1x5", "5x-1", "65537x1", "1x65537"):
            self.refuse_render(["--size", "1 to 65536"], f"--size={text}")
        for text in ("1024x", "x1024", "1024x1024x", "1024*1024", " 8x8", "8x8 ", "8X8", "8.0x8", "+8x8", "axb",
                     "x", "99999999999x1", "1x99999999999999999999999"):
            self.refuse_render(["--size", text, "WIDTHxHEIGHT"], f"--size={text}")

    def test_numbers(self):
        """Tries each text with one parameter only, since all parameters share one parser."""
        accepted = {"scale": "2 to 4096", "frequency": "0.001 to 1024", "orientation": "-36000 to 36000"}
        for (name, interval), text in zip(itertools.cycle(accepted.items()),
                                          ("nan", "-nan", "inf", "-inf", "1e6", "-1e6", "1e308", "0", "1e5", "-0", "-4", "-1e5")):
            self.refuse_render([name, interval], f"--{name}={text}")
        for name, text in zip(itertools.cycle(accepted), ("4abc", "4,5", "4 ", " 4", "four", "+4", "0x10", "1e999", "--4")):
            self.refuse_render([f"--{name}", text, "a number"], f"--{name}={text}")
        for text in ("45 deg", "rad", "deg", "45turns", "45radrad", "\u00b0", "45 \u00b0", "45\u00b0\u00b0"):
            self.refuse_render(["--orientation", text, "0.7854rad"], f"--orientation={text}")
        self.refuse_render(["--scale '45deg'"], "--scale=45deg")

    def test_negative_numbers_as_separate_arguments(self):
        self.refuse_render(["scale", "2 to 4096"], "--scale", "-4")
        self.refuse_render(["--seed", "-1"], "--seed", "-1")
        self.succeed("render", "-o", "out.exr", "--size=8x8", "--orientation", "-45")

    def test_seed(self):
        for text in ("-1", "4294967296", "1.5", "1e3", "0x7", "7u", " 7", "99999999999999999999999", "-"):
            self.refuse_render(["--seed", text, "0 to 4294967295"], f"--seed={text}")

    def test_empty_values(self):
        for name in ("size", "scale", "frequency", "orientation", "seed", "region"):
            for option in ([f"--{name}", ""], [f"--{name}="], [f"--{name}"]):
                self.refuse_render([name], *option)

    def test_names(self):
        self.refuse_render(["recipe", "'best'", "one", "paper"], "--recipe", "best")
        self.refuse_render(["recipe", "one", "paper"], "--recipe", "")

    def test_region(self):
        for text in ("-1,0,8,8", "0,-1,8,8", "0,0,0,8", "0,0,8,0", "0,0,-8,8",
                     "60,0,5,8", "0,60,8,5", "60,0,8,1", "0,60,1,8", "64,0,1,1",
                     "0,64,1,1", "2147483647,0,2147483647,1", "1,1,64,64"):
            self.refuse_render(["--region", text, "64 x 64"], "--size=64x64", f"--region={text}")
        for text in ("1,2,3", "1,2,3,", "1,2,3,4,5", "1 2 3 4", "a,b,c,d", "1.5,0,8,8", "0,0,8x8", ",,,",
                     "9999999999,0,1,1"):
            self.refuse_render(["--region", text, "X,Y,WIDTH,HEIGHT"], "--size=64x64", f"--region={text}")

    def test_an_option_given_twice(self):
        self.refuse_render(["--scale"], "--scale=8", "--scale=9")


class Arguments(ErrorTest):
    def test_unknown_arguments(self):
        self.assert_refused(["paint"], "paint")
        self.assert_refused(["--paint"], "--paint")
        self.refuse_render(["--paint"], "--paint")
        self.refuse_render(["paint"], "paint")
        self.assert_refused(["everything"], "devices", "everything")
        self.assert_refused(["'first'"], "devices", "first", "second")
        for option, likely in (("freq", "--frequency or --frequency-spread"), ("ring=4", "--wood.rings"), ("Scale", "--scale"), ("pngs", "--png"),
                               ("wood.r", "--wood.rings or --wood.roughness")):
            self.refuse_render([f"unknown '--{option.partition('=')[0]}"], f"--{option}")
            self.refuse_render([f": did you mean {likely}? gabor "], f"--{option}")
        self.assert_refused(["unknown 'oak': gabor render --help lists"], "render", "oak")
        self.assert_refused(["did you mean materials?"], "mat")
        self.assert_refused(["did you mean --frequency?"], "render", "-o", "out.exr", "--freqency=3")
        self.assert_refused(["did you mean --frequency?", "gabor render --help"], "render", "--freqency=3")
        self.assert_refused(["did you mean --frequency?"], "render", "-o", "out.exr", "--frequuuency=3")
        self.assert_refused(["did you mean render?"], "rendr")
        self.assert_refused(["did you mean --wood.rings?", "gabor materials wood lists"], "render", "--wood.rngs=3")

    def test_similar_names_come_first_and_few(self):
        """At most three names are suggested; all are listed only if they are few, in the order of the help."""
        materials = ", ".join(["none", *self.succeed("materials").split()])
        for option, said in (("--preset=oak", "unknown preset 'oak': did you mean oak-planks? `gabor render --help` lists"),
                             ("--preset=Copper", "did you mean brushed-copper or weathered-copper? "), ("--preset=mable", "did you mean marble? "),
                             ("--preset=nope", "unknown preset 'nope': `gabor render --help` lists the presets"),
                             ("--material=Wod", f"--material 'Wod': did you mean wood? Expected {materials}\n"),
                             ("--material=gold", f"--material 'gold': expected {materials}\n"),
                             ("--loop-seconds=10", "--loop-seconds '10': did you mean 8 or 16? Expected never, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096\n"),
                             ("--loop-seconds=5000", "did you mean 4096? Expected never, 8, "), ("--loop-seconds=nev", "did you mean never? Expected never, 8, "),
                             ("--compression=zpi", "--compression 'zpi': did you mean zip? Expected none, rle, zips, zip, piz\n"),
                             ("--recipe=lattice_2", "did you mean lattice-2? Expected lattice, ")):
            self.refuse_render([said], option)
        write_exr(self.folder / "map.exr", {"Y": np.zeros((4, 4), "f4")})
        self.assert_refused(["--preset 'Moon': expected alps, badlands, canyon, fjord, hills\n"], "erode", "map.exr", "-o", "out.exr", "--preset=Moon")
        listed = materials.partition(", ")[2]
        self.assert_refused([f"MATERIAL 'oak': expected {listed}, boards, coat, finish\n"], "materials", "oak")
        self.assert_refused([f"MATERIAL 'none': expected {listed}, boards, coat, finish\n"], "materials", "none")

    def test_names_may_have_any_case(self):
        alike = [(["--material=wood", "--view=sphere", "--environment=dark"], ["--material=Wood", "--view=SPHERE", "--environment=Dark"]),
                 (["--recipe=lattice-2", "--compression=zip"], ["--recipe=Lattice-2", "--compression=ZIP"]),
                 (["--preset=oak-planks"], ["--preset=Oak-Planks"]), (["--view=ocean", "--loop-seconds=never"], ["--view=Ocean", "--loop-seconds=Never"])]
        for named, shouted in alike:
            self.succeed("render", "--size=24x16", "-o", "a.exr", *named)
            self.succeed("render", "--size=24x16", "-o", "b.exr", *shouted)
            self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes(), shouted)
        self.assertEqual(self.succeed("materials", "Wood"), self.succeed("materials", "wood"))
        (self.folder / "map.r16").write_bytes(np.arange(24 * 24, dtype="<u2").tobytes())
        for name, preset in (("a", "hills"), ("b", "HILLS")):
            self.succeed("erode", "map.r16", "--size=24", "-o", f"{name}.exr", f"--preset={preset}")
        self.assertEqual((self.folder / "a.exr").read_bytes(), (self.folder / "b.exr").read_bytes())

    def test_a_degree_sign(self):
        for text in "45", "45\u00b0", "45deg":
            self.succeed("render", "--size=16", "-o", f"{text}.exr", f"--orientation={text}")
        self.assertEqual(len(set(self.files().values())), 1)

    def test_options_whose_channels_no_file_has(self):
        for option in "--gradient", "--phasor":
            self.assert_refused([f"{option} adds channels to an EXR", "-o NAME.exr"], "render", "--size=16", option, "-o", "out.png")
            self.succeed("render", "--size=16", option, "-o", "out.exr", "--png", "out.png")
            self.succeed("render", "--like=out.exr", "-o", "out.png")
            self.succeed("render", "--size=16", option, f"--no-{option[2:]}", "-o", "out.png")

    def test_conflicting_options(self):
        self.refuse_render(["--solid needs noise with --view sphere or torus\n"], "--solid")
        self.refuse_render(["--solid needs noise", ", not wood\n"], "--solid", "--view=sphere", "--material=wood")
        self.refuse_render(["--depth needs --view slice, not horizon\n"], "--depth=3", "--view=horizon")
        self.refuse_render(["--light-azimuth needs --material NAME, or --view terrain, landscape or ocean\n"], "--light-azimuth=3")
        self.refuse_render(["--swell-height needs --view ocean\n"], "--swell-height=2")
        self.refuse_render(["--extent needs --view terrain or landscape\n"], "--extent=2")
        self.refuse_render(["--octaves needs --view terrain or landscape, not ocean\n"], "--octaves=2", "--view=ocean")
        self.refuse_render(["--wood.rings needs --material wood\n"], "--wood.rings=12")
        self.refuse_render(["--boards needs --material NAME\n"], "--boards")
        self.refuse_render(["--boards.board-width needs --boards and --material NAME\n"], "--boards.board-width=2")
        self.refuse_render(["--seconds needs --view ocean\n"], "--seconds=0.5", "--material=wood")
        self.refuse_render(["--evolution needs noise, not wood\n"], "--evolution=0.5", "--material=wood")
        self.refuse_render(["--filter needs noise or a material, not terrain\n"], "--filter", "--view=terrain")
        (self.folder / "like.json").write_text('{"wood.rings": 9}')
        self.refuse_render(["'like.json': wood.rings needs material wood\n"], "--like=like.json")
        for options, other in ((["--material=wood"], "wood"), (["--view=terrain"], "terrain"), (["--view=sphere"], "sphere"),
                               (["--view=torus", "--solid"], "torus")):
            self.refuse_render([f"--recipe needs noise with --view flat or horizon, not {other}\n"], "--recipe=one", *options)
        self.refuse_render(["--wood.rings needs --material wood, not marble\n"], "--material=marble", "--wood.rings=9")
        self.refuse_render(["--boards.board-width needs --boards and --material NAME\n"], "--material=wood", "--boards.board-width=1")
        self.refuse_render(["--wood.rings '99'", "a number from 2 to 60"], "--material=wood", "--wood.rings=99")
        for colour in ("red", "#12345", "#1234567", "0.5,0.5", "0.5,0.5,0.5,0.5", "0.5,0.5,1.5", "#gg0000", "0.5,,0.5"):
            self.refuse_render([f"--wood.earlywood-colour '{colour}'", "expected #rrggbb"], "--material=wood", f"--wood.earlywood-colour={colour}")
        (self.folder / "lobes.json").write_text("[{}, {}, {}]")
        self.refuse_render(["--frequency needs noise of a single lobe, not 3 lobes\n"], "--lobes=lobes.json", "--frequency=8")
        (self.folder / "lobes.json").write_text('[{"freq": 3}]')
        self.refuse_render(["lobes.json", "unknown 'freq' in a lobe", "frequency, orientation"], "--lobes=lobes.json")

    def test_missing_channels(self):
        self.succeed("render", "-o", "plain.exr", "--size=16x16")
        self.refuse_render(["plain.exr", "there is no channel 'frequency'; the file has Y"], "--paint=plain.exr")
        self.assert_refused(["there is no channel 'Z'; the file has Y"], "stats", "plain.exr", "--channel=Z")

    def test_missing_arguments(self):
        self.assertEqual(self.succeed(), self.succeed("--help"))
        self.assert_refused(["--output"], "render")
        self.assert_refused(["--output"], "render", "-o")
        self.assert_refused(["FILE"], "stats")

    def test_a_name_with_a_line_break_stays_one_line(self):
        self.refuse_render(["recipe"], "--recipe", "a\nb")
        self.assert_refused(["cannot write"], "render", "-o", "no\nfolder/out.exr")
        self.assert_refused(["cannot read"], "stats", "no\nfile")


class Outputs(ErrorTest):
    def test_impossible_output_paths(self):
        (self.folder / "file").write_text("a regular file")
        (self.folder / "folder").mkdir()
        for output in ("missing/out.exr", "file/out.exr", "folder", "folder/", ".", "/", ""):
            self.assert_refused(["cannot write", output], "render", "-o", output)
        for output in ("missing/out.png", "file/out.png", "folder", "folder/", ".", "/", ""):
            self.assert_refused(["cannot write", output], "render", "-o", "out.exr", "--png", output)
        self.assert_refused(["cannot write"], "render", "-o", "x" * 256 + ".exr")

    def test_the_extension_decides_the_format(self):
        for output in ("out.jpg", "out.exr.4", "-"):
            self.assert_refused([f"-o '{output}'", ".exr or .png"], "render", "-o", output)
        for output in ([], ["-o", "out.exr"]):
            self.assert_refused(["--png 'out.jpg'", ".png"], "render", *output, "--png", "out.jpg")
        self.assert_refused(["-o and --png"], "render", "-o", "a.png", "--png", "b.png")
        self.succeed("render", "-o", "both.exr", "--png", "both.png", "--size=20x10")
        self.succeed("render", "-o", "alone.PNG", "--size=20x10")
        files = self.files()
        self.assertEqual(files["alone.PNG"], files["both.png"])
        self.assertEqual(sorted(files), ["alone.PNG", "both.exr", "both.png"])

    def test_one_name_for_two_files(self):
        for png in ("out.exr", "./out.exr", str(self.folder / "out.exr")):
            self.assert_refused(["--png", "-o"], "render", "-o", "out.exr", "--png", png)


class LikeFiles(ErrorTest):
    def refuse_like(self, words):
        self.refuse_render(["like.exr", *words], "--like", "like.exr")

    def test_no_picture(self):
        self.refuse_like(["No such file"])
        (self.folder / "like.exr").mkdir()
        self.refuse_like(["not a regular file"])

    def test_not_an_exr(self):
        for content in (b"", b"Not a picture.\n", b"v/1\x01", os.urandom(4096)):
            (self.folder / "like.exr").write_bytes(content)
            self.refuse_like(["cannot read"])

    def test_parameters(self):
        cases = [(None, ["no 'gabor' attribute"]), ("", ["no 'gabor' attribute"]), ("{", ["JSON"]), ("[1]", ["JSON"]),
                 ("7", ["JSON"]), ('{"material": "wood", "wood.ring": 3}', ["unknown parameter 'wood.ring'", "wood.rings"]),
                 ('{"material": "wood", "wood.earlywood_colour": [1, 2]}', ["wood.earlywood_colour '[1,2]'", "#rrggbb"]),
                 ('{"material": "wood", "wood.earlywood_colour": "blue"}', ["wood.earlywood_colour 'blue'", "#rrggbb"]),
                 ('{"size": 3}', ["unknown parameter 'size'", "gabor render --help"]),
                 ('{"values": 1, "sum": false}', ["unknown parameter 'values'"]), ('{"seed": 1, "lobes": []}', ["the list of lobes is empty"]),
                 ('{"depth": 0, "view": "flat"}', ["depth needs view slice\n"]),
                 ('{"seed": "7"}', ["seed"]), ('{"seed": -1}', ["seed"]), ('{"seed": 4294967296}', ["seed"]),
                 ('{"seed": 1.5}', ["seed"]), ('{"seed": 18446744073709551615}', ["seed"]),
                 ('{"scale": true}', ["scale"]), ('{"scale": 1}', ["scale", "2 to 4096"]), ('{"scale": null}', ["scale"]),
                 ('{"frequency": 1e999}', ["like.exr"]), ('{"recipe": 1}', ["recipe"]),
                 ('{"recipe": "best"}', ["best", "one", "paper"]), ('{"width": 0}', ["width", "1 to 65536"]),
                 ('{"width": 65537}', ["width", "1 to 65536"]), ('{"frequency": 0}', ["frequency", "0.001"]),
                 ('{"width": 2, "height": 2}', ["region"])]
        for parameters, words in cases:
            write_exr(self.folder / "like.exr", {"Y": np.zeros((4, 4), "f4")}, parameters)
            with self.subTest(parameters):
                self.refuse_like(words)

    def test_presets_that_are_no_json_files(self):
        for text in ("", " " * 2**21):
            (self.folder / "preset.json").write_text(text)
            with self.subTest(len(text)):
                self.refuse_render(["cannot read", "preset.json", "1 MiB"], "--preset", "preset.json")

    def test_missing_parameters_take_their_defaults(self):
        write_exr(self.folder / "like.exr", {"Y": np.zeros((4, 4), "f4")}, '{"seed": 7}')
        self.succeed("render", "-o", "of_like.exr", "--like", "like.exr")
        self.succeed("render", "-o", "plain.exr", "--seed=7", "--region=0,0,4,4")
        files = self.files()
        self.assertEqual(files["of_like.exr"], files["plain.exr"])


class Devices(ErrorTest):
    def test_no_such_device(self):
        for selector in ("99", "-1", "no such name", "4294967296"):
            self.refuse_render([f"--device '{selector}' matches no device: ", "0 ("], "--device", selector)

    def test_an_ambiguous_device_name(self):
        if not LAVAPIPE:
            self.skipTest("needs Mesa's lavapipe, to list it twice")
        shutil.copy(LAVAPIPE, self.folder / "again.json")
        twice = {"VK_ICD_FILENAMES": f"{LAVAPIPE}:{self.folder / 'again.json'}", "VK_DRIVER_FILES": None}
        self.refuse_render(["matches more than one device: ", "llvmpipe", "0 (", "1 ("], "--device=LLVMpipe", env=twice)
        self.succeed("render", "-o", "out.exr", "--size=8x8", "--device=1", env=twice)

    @unittest.skipIf(WINDOWS, "Wine has a loader of its own, whose drivers are Linux's")
    def test_no_driver(self):
        for name, other in [("VK_ICD_FILENAMES", "VK_DRIVER_FILES"), ("VK_DRIVER_FILES", "VK_ICD_FILENAMES")]:
            none = {name: "/nonexistent.json", other: None}
            for command in (["render", "-o", "out.exr"], ["devices"]):
                self.assert_refused(["no Vulkan", f"{name} is '/nonexistent.json'", "unset it"], *command, env=none)

    @unittest.skipIf(WINDOWS, "Wine has a loader of its own")
    def test_no_loader(self):
        # The program finds these empty files first, so they hide the real loader.
        for name in ("libvulkan.so", "libvulkan.so.1"):
            (self.folder / name).touch()
        hidden = {"LD_LIBRARY_PATH": str(self.folder)}
        self.refuse_render(["no Vulkan loader", "libvulkan1"], env=hidden)
        self.assert_refused(["no Vulkan loader", "libvulkan1"], "devices", env=hidden)


class Disk(ErrorTest):
    """If a valid request fails while it runs, the program exits with status 1."""

    @unittest.skipIf(WINDOWS, "Windows has no /dev/full; windows/test_files fills a disk")
    def test_a_full_device(self):
        self.assert_fails(1, ["/dev/full", "No space"], "render", "-o", "/dev/full", "--size=64x64")
        self.assert_fails(1, ["/dev/full", "No space"], "render", "-o", "out.exr", "--png=/dev/full", "--size=640x640")

    @unittest.skipIf(WINDOWS, "Windows has no ulimit; windows/test_files fills a disk")
    def test_a_file_that_grows_too_large(self):
        (self.folder / "old.exr").write_text("older")
        # In blocks of 512 or 1024 bytes. Mesa 25 keeps the device's memory, less than 64 MiB here, in a file as well.
        limited = ["sh", "-c", "ulimit -f 131072; exec \"$0\" \"$@\"", PROGRAM]
        for output in ("old.exr", "new.exr"):
            self.assert_fails(1, [output, "File too large"], "render", "-o", output, "--size=4096x9000",
                              command=limited)

    @unittest.skipIf(WINDOWS, "windows/test_files fills one")
    def test_a_full_disk(self):
        mount = ["unshare", "--user", "--map-root-user", "--mount", "sh", "-c"]
        small = "mount -t tmpfs -o size=1m tmpfs . && cd . && "
        if subprocess.run([*mount, small + ":"], cwd=self.folder, capture_output=True).returncode != 0:
            self.skipTest("not allowed to mount a small disk")
        script = small + 'echo older >old.exr; "$0" "$@"; status=$?; ls -A; cat old.exr; exit $status'
        for output in ("old.exr", "new.exr"):
            result = gabor("render", "-o", output, "--size=1024x1024", cwd=self.folder,
                           command=[*mount, script, PROGRAM])
            self.assertEqual((result.returncode, result.stdout), (1, "old.exr\nolder\n"))
            self.assertRegex(result.stderr, rf"\Agabor: cannot write {output}: No space [^\n]+\n\Z")

    @unittest.skipIf(WINDOWS, "Windows has no /dev/full")
    def test_a_full_standard_output(self):
        with open("/dev/full", "w") as full:
            for arguments in (["devices"], ["--version"], ["--help"], ["render", "--help"]):
                with self.subTest(arguments):
                    self.assert_fails(1, ["standard output"], *arguments, stdout=full)

    def test_a_square(self):
        for size in ("24", "24x24"):
            self.assertEqual(gabor("render", f"--size={size}", "-o", f"{size}.exr", cwd=self.folder).returncode, 0)
        self.assertEqual((self.folder / "24.exr").read_bytes(), (self.folder / "24x24.exr").read_bytes())

    def test_tga(self):
        """A cut file is refused at any length, and the origin may be on either side."""
        heights = np.random.default_rng(1).integers(0, 256, (16, 12), "u1")
        def tga(kind, values, origin, pixels):
            return bytes([0, 0, kind, *[0] * 9, 12, 0, 16, 0, 8 * values, origin]) + pixels
        runs = b"".join(b"\x05" + row[:6].tobytes() + bytes([0x85, row[6]]) for row in heights) # six pixels, and a run of six
        for name, content in (("grey", tga(3, 1, 0x20, heights.tobytes())), ("runs", tga(11, 1, 0x20, runs)),
                              ("colour", tga(2, 3, 0x20, np.repeat(heights, 3).tobytes()))):
            for length in (18, 19, 60, len(content) - 13, len(content) - 1):
                (self.folder / "cut.tga").write_bytes(content[:length])
                self.assert_refused(["cut.tga", "ends before"], "erode", "cut.tga", "-o", "out.exr")
            (self.folder / f"{name}.tga").write_bytes(content)
            self.assertEqual(gabor("erode", f"{name}.tga", "-o", f"{name}.exr", cwd=self.folder).returncode, 0)
        (self.folder / "left.tga").write_bytes(tga(3, 1, 0x30, heights[:, ::-1].tobytes()))
        for name in ("left", "colour"):
            gabor("erode", f"{name}.tga", "-o", f"{name}.exr", cwd=self.folder)
            np.testing.assert_array_equal(Exr(self.folder / f"{name}.exr").channels["Y"],
                                          Exr(self.folder / "grey.exr").channels["Y"])


if __name__ == "__main__":
    unittest.main()

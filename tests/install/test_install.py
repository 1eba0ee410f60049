"""Checks the files that `cmake --install` writes, and builds a separate project from these files alone."""

import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "cli"))
from exr import Exr  # noqa: E402

CMAKE = os.environ["CMAKE"]
SIDE = 256

VERSION = re.search(r"project\(gabor-noise VERSION (\d+\.\d+)", (pathlib.Path(__file__).parents[2] / "CMakeLists.txt").read_text())[1]
INSTALLED = {
    "bin/gabor",
    "lib/cmake/gabor-noise/gabor-noise-config-version.cmake",
    "lib/cmake/gabor-noise/gabor-noise-config.cmake",
    "lib/cmake/gabor-noise/gabor-noise-targets.cmake",
    "share/gabor-noise/LICENSE",
    "share/gabor-noise/shaders/gabor_float.glsl",
    "share/gabor-noise/shaders/translations/gabor_fractal_points.hpp",
    "share/gabor-noise/shaders/translations/gabor_noise_grid.hpp",
    "share/gabor-noise/shaders/translations/gabor_vectors.hpp",
    *(f"share/gabor-noise/shaders/passes/{name}"
      for name in ("bake.comp", "bake_colour.comp", "bake_interface.h", "colour.glsl", "colour.h", "constants.h", "interface.h",
                   "noise_channels.glsl", "recipe.glsl")),
    *(f"share/gabor-noise/shaders/{place}_{name}.{dialect}"
      for name in ("compose", "direction", "erosion", "filter", "filter_3d", "fractal", "materials", "noise", "noise_3d", "ocean", "sparse", "spectrum")
      for place, dialect in (("gabor", "glsl"), *(("translations/gabor", dialect)
                                                  for dialect in ("hlsl", "hpp", "wgsl")))),
}


def run(*command, **options):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=280, **options)
    if result.returncode != 0:
        raise AssertionError(f"{command} failed:\n{result.stdout}\n{result.stderr}")


class Install(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        cls.prefix = cls.folder / "a prefix"
        cls.build = cls.folder / "a build"
        run(CMAKE, "--install", os.environ["GABOR_BUILD"], "--prefix", cls.prefix)

    def configure(self, *options):
        run(CMAKE, "-S", pathlib.Path(__file__).parent / "consumer", "-B", self.build, "-G", os.environ["GENERATOR"],
            f"-DCMAKE_PREFIX_PATH={self.prefix}", *options)

    def test_the_tree_has_the_listed_files_and_no_others(self):
        files = {str(path.relative_to(self.prefix)) for path in self.prefix.rglob("*") if not path.is_dir()}
        self.assertEqual(files - {"bin/gabor-viewer"}, INSTALLED)  # the viewer needs packages that may be missing

    def test_the_installed_drop_in_equals_the_source(self):
        source = pathlib.Path(__file__).parents[2] / "shaders" / "gabor_sparse.glsl"
        self.assertEqual((self.prefix / "share/gabor-noise/shaders/gabor_sparse.glsl").read_bytes(), source.read_bytes())

    def test_another_version_is_refused(self):
        """Values may change with the major version, and functions are added with the minor one."""
        major, minor = map(int, VERSION.split("."))
        for wanted in (f"{major + 1}.0", f"{major - 1}.{minor}", f"{major}.{minor + 1}"):
            with self.subTest(wanted), self.assertRaisesRegex(AssertionError, "gabor-noise"):
                self.configure(f"-DWANTED_VERSION={wanted}")

    def test_targets_serve_an_installed_and_a_fetched_copy(self):
        """Builds a project with the code in shaders/nodes/cpp/README.md, once with find_package and once with FetchContent,
        which installs nothing."""
        main = "#include \"gabor_noise.hpp\"\nint main() { return gabor_noise({0.3f, 0.7f}, 4.0f, 0.0f, 7u) == 0.0f; }\n"
        ways = {"found": "find_package(gabor-noise CONFIG REQUIRED)",
                "fetched": "include(FetchContent)\n"
                           f"FetchContent_Declare(gabor_noise SOURCE_DIR [[{pathlib.Path(__file__).parents[2]}]])\n"
                           "FetchContent_MakeAvailable(gabor_noise)"}
        for way, lines in ways.items():
            with self.subTest(way):
                folder = self.folder / way
                folder.mkdir()
                (folder / "main.cpp").write_text(main)
                (folder / "CMakeLists.txt").write_text(
                    f"cmake_minimum_required(VERSION 3.25)\nproject(user LANGUAGES C CXX)\n{lines}\nadd_executable(user main.cpp)\n"
                    "target_link_libraries(user PRIVATE gabor_noise::cpp gabor_noise::shaders)\n")
                run(CMAKE, "-S", folder, "-B", folder / "b", "-G", os.environ["GENERATOR"], f"-DCMAKE_PREFIX_PATH={self.prefix}")
                run(CMAKE, "--build", folder / "b")
                run(folder / "b" / "user")
                run(CMAKE, "--install", folder / "b", "--prefix", folder / "prefix")
                self.assertFalse((folder / "prefix").exists())

    def test_a_consumer_renders_what_the_program_does(self):
        listed = subprocess.run([self.prefix / "bin/gabor", "recipes", "--json"], capture_output=True, check=True)
        recipes = {recipe["name"]: recipe["macros"] | ({"LATTICE": "1"} if recipe["file"] == "gabor_noise.glsl" else {})
                   for recipe in json.loads(listed.stdout)}
        self.assertGreaterEqual(len(recipes), 3)
        macros = [f"-D{name}=" + ";".join(f"-D{macro}={value.replace(' ', '')}" for macro, value in defined.items())
                  for name, defined in recipes.items()]
        self.configure(f"-DWANTED_VERSION={VERSION}", "-DRECIPES=" + ";".join(recipes), *macros)
        run(os.environ["SCENE"], SIDE, 1, *(f"{recipe}.{kind}" for recipe in recipes for kind in ("spv", "raw")), cwd=self.build)
        for recipe in recipes:
            with self.subTest(recipe):
                run(self.prefix / "bin/gabor", "render", "-o", f"{recipe}.exr", f"--recipe={recipe}",
                    f"--size={SIDE}x{SIDE}", "--scale=32", "--frequency=4", "--orientation=45", "--seed=7",
                    cwd=self.build)
                theirs = np.fromfile(self.build / f"{recipe}.raw", "<f4").reshape(SIDE, SIDE)
                ours = Exr(self.build / f"{recipe}.exr").pixels
                self.assertGreater(ours.std(), 0.5)
                # The program derives the kernel in double precision, the shader in single.
                difference = np.abs(theirs - ours)
                worst = np.unravel_index(difference.argmax(), difference.shape)
                self.assertLess(difference.max(), 2e-5, f"at row and column {worst}")


if __name__ == "__main__":
    unittest.main()

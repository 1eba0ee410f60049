"""Compares the packages of tools/package with the texts that they are made of, and uses them in an empty folder:
test_packages.py [-v] nodes|npm|module|pypi|vcpkg|benchmark|release"""

import ast
import functools
import hashlib
import json
import os
import pathlib
import re
import runpy
import shutil
import struct
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import unittest
import zipfile

import numpy as np
from PIL import Image

sys.path[:0] = [str(pathlib.Path(__file__).resolve().parents[2] / folder) for folder in ("tests/engines", "tools")]
import reference  # noqa: E402
from scene import ROOT, SHADERS, in_cpp, printed  # noqa: E402
from version import VERSION  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
MATERIALS = re.findall(r" gabor_(\w+)_default\(\) {", (ROOT / "shaders/gabor_materials.glsl").read_text())
DROP_INS = sorted(path for folder in ("", "translations") for path in (SHADERS / folder).glob("gabor_*"))
MXVALIDATE = ROOT / "build" / "venv" / "bin" / "mxvalidate"
LEFTOVERS = re.compile(r"\.(oso|pyc|o|so)$|__pycache__|node_modules")


def run(*command, timeout=500, **options):
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=timeout, **options)
    if result.returncode != 0:
        raise AssertionError(f"{command} failed:\n{result.stdout}\n{result.stderr}")
    return result.stdout


@functools.cache
def texts():
    """Returns the text of each drop-in and translation, by its path in shaders/."""
    made = [path for language in ("metal", "godot") for path in pathlib.Path(printed(language).name).iterdir()]
    return dict(sorted({**{str(path.relative_to(SHADERS)): path.read_text() for path in DROP_INS},
                        **{f"translations/{path.name}": path.read_text() for path in made}}.items()))


def guid(meta):
    return re.search(r"^guid: ([0-9a-f]{32})$", meta.read_text(), re.MULTILINE)[1]


def named(paths, folder):
    """Returns the names of the files among the paths, relative to the folder."""
    return {str(path.relative_to(folder)) for path in paths if path.is_file()}


def tracked(folder):
    """Returns the paths of a folder's files in the repository, relative to the folder."""
    listed = run("git", "-C", folder, "ls-files", "-z", "--cached", "--others", "--exclude-standard").split("\0")
    return named((folder / name for name in listed), folder)


def repository(folder, names):
    """Makes a repository of copies of these files."""
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, folder / name)
    run("git", "init", "-q", folder)


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))


class Package(Folder):
    tools, name, timeout = (), None, 500

    def setUp(self):
        super().setUp()
        if missing := [tool for tool in (*self.tools, "git") if not shutil.which(tool)]:
            self.skipTest(f"not installed: {', '.join(missing)}")
        name = self.name or type(self).__name__.lower()
        self.archives = [ROOT / line for line in run(sys.executable, "-B", ROOT / "tools" / "package", name, timeout=self.timeout).splitlines()]

    def assert_npm_accepts_it(self):
        """Runs npm's checks before publishing. They mend a bad package.json of an unpacked package, and say so."""
        if not shutil.which("npm"):
            self.skipTest("not installed: npm")
        self.unpack()
        said = subprocess.run(["npm", "publish", "--dry-run", "--offline", self.folder / "package"], capture_output=True, text=True, timeout=100)
        self.assertEqual(said.returncode, 0, said.stderr)
        self.assertNotRegex(said.stderr, "auto-corrected|warn package-json")

    def unpack(self):
        """Unpacks the archive below self.folder."""
        archive, = self.archives
        shutil.unpack_archive(archive, self.folder)
        files = named(self.folder.rglob("*"), self.folder)
        self.assertEqual([name for name in files if LEFTOVERS.search(name)], [])
        return files


class Npm(Package):
    """Installs the package without the registry, and imports its module. A substitute for three/tsl replaces three.js, as in
    tests/dialects/test_nodes.py."""

    tools = "node", "npm", "glslangValidator"

    def test_can_be_published(self):
        self.assert_npm_accepts_it()

    def test_installs_and_is_imported(self):
        three = self.folder / "three"  # a substitute for three.js
        (three / "src").mkdir(parents=True)
        (three / "package.json").write_text(json.dumps(
            {"name": "three", "version": "0.187.0", "type": "module", "exports": {"./tsl": "./src/tsl.mjs"}}))
        shutil.copy(ROOT / "tests" / "dialects" / "three_tsl.mjs", three / "src" / "tsl.mjs")
        run("npm", "pack", "--pack-destination", self.folder, three)
        project = self.folder / "project"
        project.mkdir()
        (project / "package.json").write_text('{"private": true}')
        run("npm", "install", "--offline", "--no-audit", "--no-fund", self.archives[0], self.folder / "three-0.187.0.tgz", cwd=project)
        installed = project / "node_modules" / "gabor-noise"
        carried = [SHADERS / "nodes" / name / file for name in ("three", "shims") for file in tracked(SHADERS / "nodes" / name)]
        self.assertEqual(named(installed.rglob("*"), installed), {"LICENSE", "README.md", "package.json", "index.js", "index.d.ts",
                                                                  *(f"shaders/{name}" for name in texts()),
                                                                  *named(carried, ROOT)})
        described = json.loads((installed / "package.json").read_text())
        self.assertEqual((described["version"], described["type"]), (VERSION, "module")) # Node.js 18 needs it to recognize modules

        # Reads each drop-in by its exported name, as bundlers and Node.js resolve it.
        (project / "sources.mjs").write_text("""
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
const texts = process.argv.slice(2).map(name =>
    readFileSync(fileURLToPath(import.meta.resolve(`gabor-noise/shaders/${name}`)), "utf8"));
console.log(JSON.stringify(texts));
""")
        self.assertEqual(json.loads(run("node", "sources.mjs", *texts(), cwd=project)), [*texts().values()])

        # The index has the texts, and the README's code makes a shader of one.
        exported = json.loads(run("node", "--input-type=module", "--eval",
                                  'import * as texts from "gabor-noise"; console.log(JSON.stringify(texts))', cwd=project))
        self.assertEqual(exported, {path.name.replace(".", "_"): path.read_text() for path in DROP_INS if path.suffix in (".glsl", ".wgsl")})
        typed = re.findall(r"^export declare const (\w+): string;$", (installed / "index.d.ts").read_text(), re.MULTILINE)
        self.assertEqual(sorted(typed), sorted(exported))
        readme = (installed / "README.md").read_text()
        self.assertEqual(set(re.findall(r"`(gabor_\w+_(?:glsl|wgsl))`", readme)), set(exported))
        code = re.search(r"(?s)    import \{.*?`;\n", readme)[0]
        shader = run("node", "--input-type=module", "--eval", f"{code}console.log(fragment)", cwd=project)
        run("glslangValidator", "--stdin", "-S", "frag", input=shader)

        (project / "noise.mjs").write_text("""
import * as gabor from "gabor-noise/shaders/nodes/three/gabor_noise.tsl.js";
console.log(typeof gabor.gabor_noise);
""")
        self.assertEqual(run("node", "noise.mjs", cwd=project), "function\n")


class Python(Folder):
    """Compares the Python module's values with the reference, and with the headers that it wraps: other tests compare those with it."""

    USE = """
import sys, numpy as np, gabor_noise
from gabor_noise import *
y, x = (np.mgrid[0:256, 0:256] + 0.5) / 32
common = dict(frequency=4.0, orientation=np.float32(0.7854), seed=7)
gradient = noise_gradient(x, y, **common)
pictures = {
    "noise": noise(x, y, **common),
    "complex": noise_quadrature(x, y, **common)[..., 1],
    "gradient": gradient @ np.float32([1, 1 / 32, 2 / 32]),
    "tiled": noise(x, y, period=(2, 1), **common),
    "animated": noise(x, y, evolution=0.3, **common),
    "stripes": stripes(x, y, 4 * np.cos(0.7854), 4 * np.sin(0.7854), seed=7) @ np.float32([0.25, 0.5, 0.75]),
}
assert all(each.dtype == np.float32 for each in pictures.values())
np.savez("pictures.npz", **pictures)
np.save("solid.npy", noise_3d(x, y, 0.3, frequency=4.0, direction=(1, 2, 3), seed=7))
for file in sys.argv[1:]:
    name, language = file.split(".")
    language = {"gdshaderinc": "godot", "hpp": "cpp"}.get(language, language)
    sys.stdout.write(source(name.removeprefix("gabor_"), language))
print(gabor_noise.__version__)
"""
    # Calls with each argument off its default, and the channels that they return, in C++.
    CALLS = {
        "noise(x, y, **wave, **place)": "field.noise",
        "noise_quadrature(x, y, **wave, **place)": "field.noise field.quadrature",
        "noise_gradient(x, y, **wave, **place)": "field.noise field.gradient.x field.gradient.y",
        "noise_filtered(x, y, (0.1, 0.3), **wave, **place)": "filtered.noise filtered.removed",
        "noise_isotropic(x, y, frequency=-2.5, **place)": "gabor_field_isotropic(place,-2.5f,seed).noise",
        "noise_spread(x, y, frequency_spread=0.3, orientation_spread=0.2, **wave, **place)":
            "gabor_field_spread(place,-2.5f,0.6f,0.3f,0.2f,seed).noise",
        "noise_lobes(x, y, [(2, 0.3, (1, 1.5), 2), Lobe(3, 1.1, 0.5)], **place)": "gabor_field_lobes(place,lobes,seed).noise",
        "stripes(x, y, 1.5, -0.7, sharpness=3, **place)": "along.x along.y along.z",
        "noise_3d(x, y, 0.3, frequency=-2.5, direction=(1, 2, -3), **space)": "gabor_field_3d(space,spatial,seed).noise",
        "noise_3d(x, y, 0.3, frequency=-2.5, **space)": "gabor_field_3d_isotropic(space,-2.5f,seed).noise",
        "fbm(x, y, seed=7)": "gabor_fbm(p,5.0f,0.5f,7u)",
        "fbm(x, y, shape='billow', **octaves, **place)": "billow.noise",
        "fbm(x, y, shape='ridged', seed=7)": "gabor_ridged(p,5.0f,0.5f,7u)",
        "fbm_gradient(x, y, **octaves, **place)": "fractal.noise fractal.gradient.x fractal.gradient.y",
        "fbm_gradient(x, y, **octaves)": "endless.noise endless.gradient.x endless.gradient.y",
        "fbm_filtered(x, y, (0.1, 0.3), **octaves, **place)": "pixels.noise pixels.removed",
        "fbm_3d(x, y, 0.3, **octaves, **space)": "gabor_fractal_noise_3d(space,octaves,seed).noise",
        "fbm_3d(x, y, 0.3, seed=7)": "gabor_fbm_3d({p.x,p.y,0.3f},5.0f,0.5f,7u)",
        "perlin(x, y, seed=-9)": "gabor_perlin(p,seed)",
        "np.stack(warp(x, y, strength=0.5, **octaves, **place), -1)": "moved.x moved.y",
        "uniform(noise(x, y, **wave, **place))": "gabor_uniform(field.noise)",
        "terrain(x, y, seed=7, octaves=0)": "hills.height hills.slope.x hills.slope.y hills.ridge",
        "terrain(x, y, seed=7)": "mountains.height mountains.slope.x mountains.slope.y mountains.ridge",
        "terrain(x, y, terrain(x, y, seed=7), seed=8, **rough)": "badlands.height badlands.slope.x badlands.slope.y badlands.ridge",
        "terrain(x, y, [0.1, 0.5, -0.3, 0.2, 0.1, 0.2, 0.3], seed=8, pixel_size=(0.1, 0.3), period=(8, 16), **rough)":
            "island.height island.slope.x island.slope.y island.ridge",
        "water(x, y, seconds=100.25, pixel_size=(0.1, 0.3), **sea)": "water.height water.slope.x water.slope.y water.shift.x water.shift.y "
                                                               "water.jacobian water.lost.x water.lost.y water.lost.z water.velocity.x water.velocity.y water.velocity.z",
        "water_height(x, y, seconds=100.25, **sea)": "gabor_water_height(p,100.25f,sea,seed)",
        **{f"material('{name.replace('_', '-')}', x, y, pixel_size=(0.1, 0.3), period=(6, 4), seed=-9)":
           " ".join(f"{name}.{part}" for part in ("colour.x", "colour.y", "colour.z", "height", "slope.x", "slope.y", "roughness", "metalness",
                                                  "lost.x", "lost.y", "lost.z")) for name in MATERIALS}}
    GIVEN = """
wave, place, space = dict(frequency=-2.5, orientation=0.6), dict(seed=-9, period=(6, 9), evolution=0.3), dict(seed=-9, period=(4, 5, 6), evolution=0.3)
octaves = dict(octaves=3.4, gain=0.6, lacunarity=1.9, turn=0.4, basis="perlin")
rough = dict(octaves=3, gully_frequency=2, strength=0.2, lacunarity=1.9, gain=0.6, onset_slope=0.4, detail=1.2, uniformity=3, ridge_rounding=0.2,
             crease_rounding=0.3, gully_weight=0.7, branching=0.8)
sea = dict(wind=8, direction=0.7, fetch=3e4, swell_height=1.5, swell_period=9, swell_direction=2.1, water_depth=14, loop_seconds=256, seed=-9)
def channels(made):
    if isinstance(made, dict):
        return [each for name, part in made.items()
                for each in channels(part if part.ndim == 3 else part[..., None])]
    return list(np.moveaxis(made, -1, 0)) if made.ndim == 3 else [made]
y, x = y[:64], x[:64]
np.save("calls.npy", [each for call in CALLS for each in channels(eval(call))])
"""
    CODE = """
        const std::uint32_t seed = std::uint32_t(-9);
        const gabor_vec2 dx(0.1f, 0.0f), dy(0.0f, 0.3f), wave = gabor_wave_vector(-2.5f, 0.6f);
        GaborPlace place = gabor_place_tiled(p, gabor_vec2(6.0f, 9.0f));
        GaborPlace3d space = gabor_place_3d_tiled(gabor_vec3(p, 0.3f), gabor_vec3(4.0f, 5.0f, 6.0f));
        place.evolution = space.evolution = 0.3f;
        const GaborField field = gabor_field(place, wave, seed), filtered = gabor_field_filtered(place, dx, dy, wave, seed);
        const gabor_vec3 along = gabor_stripes_of(gabor_field(place, gabor_vec2(1.5f, -0.7f), seed), 3.0f),
                         spatial = 2.5f * gabor_impl_unit(gabor_vec3(1.0f, 2.0f, -3.0f));
        const GaborFractal octaves{3.4f, 0.6f, 1.9f, 0.4f, GABOR_PERLIN, GABOR_FBM},
                           billows{3.4f, 0.6f, 1.9f, 0.4f, GABOR_PERLIN, GABOR_BILLOW};
        const GaborFractalNoise fractal = gabor_fractal_noise(place, octaves, seed), billow = gabor_fractal_noise(place, billows, seed),
                                endless = gabor_fractal_noise(gabor_place_at(p), octaves, 0u),
                                pixels = gabor_fractal_noise_filtered(place, dx, dy, octaves, seed);
        const GaborPlace warped = gabor_warp(place, 0.5f, octaves, seed).place;
        const gabor_vec2 moved = warped.local / warped.cells_per_radius;
        GaborLobes lobes{};
        lobes.lobe[0] = {2.0f, 0.3f, {1.0f, 1.5f}, 2.0f};
        lobes.lobe[1] = {3.0f, 1.1f, {0.5f, 0.5f}, 1.0f};
        lobes.count = 2;
        static const GaborOcean sea = gabor_ocean_of(GaborSea{8.0f, 3.0e4f, 1.5f, 9.0f, 2.1f, 14.0f, 0.7f, 256});
        const GaborWater water = gabor_water_filtered(p, dx, dy, 100.25f, sea, seed);
        const gabor_ivec2 cell(int(p.x), int(p.y));
        const gabor_vec2 none(0.0f), local = p - gabor_vec2(float(cell.x), float(cell.y));
        const GaborTerrainPlace ground{cell, local, none}, tile{cell, local, gabor_vec2(8.0f, 16.0f)};
        const GaborErosion erosion = gabor_erosion(), rough{3, 2, 0.2f, 1.9f, 0.6f, 0.4f, 1.2f, 3, 0.2f, 0.3f, 0.7f, 0.8f};
        const GaborTerrain hills = gabor_terrain_at(ground, none, none, 7u);
        const GaborTerrain mountains = gabor_eroded_at(ground, none, none, hills, erosion, 7u);
        GaborTerrain flat = mountains;
        flat.curvature = gabor_vec3(0.0f);
        const GaborTerrain badlands = gabor_eroded_at(ground, none, none, flat, rough, 8u);
        const GaborTerrain base{0.1f, {0.5f, -0.3f}, 0.2f, {0.1f, 0.2f, 0.3f}, {0.0f, 0.0f}};
        const GaborTerrain island = gabor_eroded_at(tile, dx, dy, base, rough, 8u);
""" + "".join(f"        const GaborMaterial {name} = gabor_{name}_filtered_at(p, dx, dy, {{6.0f, 4.0f}}, gabor_{name}_default(), seed);\n"
              for name in MATERIALS)

    def assert_close(self, name, values, expected, bound):
        difference = np.abs(values - expected)
        print(f"{name}: largest difference {difference.max():.2g} at {np.unravel_index(difference.argmax(), difference.shape)}")
        self.assertLess(difference.max(), bound)

    def assert_reference(self, *python):
        """Runs Python with these arguments."""
        (self.folder / "use.py").write_text(self.USE)
        said = run(*python, self.folder / "use.py", *(pathlib.Path(name).name for name in texts()), cwd=self.folder)
        self.assertEqual(said, "".join(texts().values()) + f"{VERSION}\n")
        with np.load(self.folder / "pictures.npz") as pictures:
            for function, values in pictures.items():
                with self.subTest(function):
                    error, place = reference.largest_difference(function, values)
                    print(f"{function}: largest difference {error:.2g} at row and column {place}")
                    self.assertLess(error, 1e-5)
        y, x = (np.mgrid[0:32, 0:256] + 0.5) / 32
        solid = reference.complex_lattice_3d(x, y, 0.3, (1, 2, 3)).imag
        self.assert_close("solid", np.load(self.folder / "solid.npy")[:32], solid, 1e-5)


class Module(Folder):
    """Checks what can be checked of the Python package without nanobind, which Debian 12 lacks: tools/test-engines python runs it."""

    def setUp(self):
        super().setUp()
        run(sys.executable, "-B", ROOT / "tools" / "package", "pypi", "--stage", self.folder)

    def test_sources_compile(self):
        for path in [*self.folder.rglob("*.py")]:
            compile(path.read_text(), path, "exec")
        sources = set(re.findall(r"native/\w+\.cpp", (self.folder / "CMakeLists.txt").read_text()))
        self.assertEqual(sources, {str(path.relative_to(self.folder)) for path in (self.folder / "native").glob("*.cpp")})
        run("c++", "-std=c++17", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-DGABOR_INLINE=inline", "-DGABOR_LOBES=16", "-I", self.folder / "gabor_noise/source",
            *(self.folder / name for name in sorted(sources - {"native/module.cpp"})))

    def test_python_calls_what_the_native_module_has(self):
        """Compares names of the module's members and of its kernels, and finds each input of a kernel among a function's arguments."""
        code = "".join(path.read_text() for path in (self.folder / "gabor_noise").glob("*.py"))
        native = "".join(path.read_text() for path in (self.folder / "native").glob("*.cpp"))
        self.assertEqual(set(re.findall(r"_native\.(\w+)", code)), set(re.findall(r'module\.(?:attr|def)\("(\w+)"', native)))
        kernels = re.findall(r'\{"(\w+)", ([^{}]*), \d+, fill_', native)
        self.assertEqual({name for name, _ in kernels}, set(re.findall(r'(?:evaluate\(|else )"(\w+)"(?: if|, )', code)))
        tree = ast.parse((self.folder / "gabor_noise" / "__init__.py").read_text())
        functions = [node for node in tree.body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")]
        arguments = {each.arg for function in functions for each in (*function.args.args, *function.args.kwonlyargs)}
        for name, inputs in kernels:
            self.assertLessEqual({each.partition(".")[0] for text in re.findall(r'"(.*?)"', inputs) for each in text.split()}, arguments, name)
        shown = next(ast.literal_eval(node.value) for node in tree.body if isinstance(node, ast.Assign) and node.targets[0].id == "__all__")
        self.assertEqual([function.name for function in functions if function.name not in shown or not ast.get_docstring(function)], [])


class Pypi(Package, Python):
    """Uses the wheel, which real nanobind binds, in a new virtual environment. tools/test-engines python runs this test."""

    timeout = 3600  # the wheel's code is compiled for several processors

    def test_wheel_has_the_shaders_values(self):
        run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", self.folder / "venv")
        python = self.folder / "venv" / "bin" / "python"
        wheel, = (path for path in self.archives if path.suffix == ".whl")
        run(ROOT / "build" / "package-venv" / "bin" / "python", "-m", "pip", "--python", python, "install", "-q",
            "--disable-pip-version-check", "--no-deps", wheel)
        self.assert_reference(python)
        (self.folder / "calls.py").write_text(f"{self.USE.partition('common')[0]}CALLS = {list(self.CALLS)}\n{self.GIVEN}")
        run(python, self.folder / "calls.py", cwd=self.folder)
        headers = "".join(f'#include "gabor_{name}.hpp"\n'
                          for name in ("noise", "spectrum", "filter", "fractal", "noise_3d", "materials", "erosion", "ocean"))
        outputs = [(call, output) for call, outputs in self.CALLS.items() for output in outputs.split()]
        expected = in_cpp(self.folder, headers, [output for _, output in outputs], "-std=c++17", "-O1", "-ffp-contract=off",
                          "-DGABOR_INLINE=inline", "-I", SHADERS / "translations", code=self.CODE, rows=64)
        made = np.load(self.folder / "calls.npy")
        self.assertEqual(made.shape, expected.shape)
        for (call, output), one, other in zip(outputs, made, expected):
            with self.subTest(call, output=output):
                self.assert_close(f"{call}: {output}", one, other, 3e-4 if "gradient" in output else 5e-5)
        run(python, HERE / "module_test.py", ROOT / "docs")


class Node(Package):
    """Compares a node's package with its folder, and with the texts that the folder includes from elsewhere."""

    part, place = "", ""  # the part of the folder that is packaged, and its place in the archive
    included = {}  # for each file, the texts that it must contain, as paths in shaders/
    copied = {}  # files that the folder lacks, and what they are copies of

    def test_has_the_folders_files_and_all_that_they_include(self):
        source = SHADERS / "nodes" / (self.name or type(self).__name__.lower()) / self.part
        self.unpack()
        root = self.folder / self.place
        files = named(root.rglob("*"), root)
        self.assertEqual(files, tracked(source) | set(self.copied) | {"LICENSE", "README.md"} | set(self.made(root)))
        self.assert_readme(root)
        self.assertLessEqual(set(self.included), files)
        for name, original in (self.copied | {"LICENSE": "../LICENSE"}).items():
            self.assertTrue((root / name).read_bytes() == (SHADERS / original).read_bytes(), name)
        for name in tracked(source) - {"README.md"}:
            wanted, packaged = (source / name).read_bytes().replace(b"@VERSION@", VERSION.encode()), (root / name).read_bytes()
            wanted = re.sub(b".*@REPOSITORY@.*\n", b"", wanted)
            for original in self.included.get(name, []):
                text = self.text(original)
                self.assertTrue(self.quoted(text) in packaged, f"{name} lacks {original}")
                packaged = packaged.replace(self.quoted(text), b"")
                path = os.path.relpath(SHADERS / original, (source / name).parent)
                wanted = wanted.replace(self.quoted(f'#include "{path}"\n'.encode()), b"")
            self.assertTrue(packaged == wanted, name)
            self.assertFalse(re.search(rb'#include "\.\.|@(VERSION|REPOSITORY)@', packaged), name)

    def assert_readme(self, root):
        """Checks that the README names its licence and authors, and that its links lead somewhere."""
        text = (root / "README.md").read_text()
        self.assertIn("MIT license, by the gabor-noise authors", text)
        for link in re.findall(r"\]\(([^)#]+)", text):
            self.assertTrue("://" in link or (root / link).exists(), link)

    def text(self, original):
        return (texts()[original] if original in texts() else (SHADERS / original).read_text()).encode()

    def quoted(self, text):
        return text

    def made(self, root):
        """Checks the files that are made for the package, and returns their names."""
        return []


class Bevy(Node):
    MODULES = {name: f"gabor_{name}" for name in ("noise", "spectrum", "filter", "noise_3d", "filter_3d", "fractal", "materials", "compose", "erosion",
                                                  "ocean", "direction")}
    DEFINED = re.compile(r"^(?:fn|struct|const) (\w+)", re.MULTILINE)

    def made(self, root):
        """Checks that each module is its translation, and imports what it uses from the modules that define it. Without
        imports, the modules together are one valid shader."""
        modules = {module: (root / "src" / f"{module}.wgsl").read_text() for module in self.MODULES}
        code = {}
        for module, text in modules.items():
            *head, code[module] = re.fullmatch(r"(#define_import_path gabor_noise::\w+\n)((?:#import .*\n)*)\n((?:.*\n)*)", text).groups()
            self.assertEqual(head[0], f"#define_import_path gabor_noise::{module}\n")
            original = (SHADERS / "translations" / f"{self.MODULES[module]}.wgsl").read_text()
            self.assertEqual(code[module], re.sub("// Paste it after .*\n", "", original))
            imported = {}
            for other, names in re.findall(r"#import gabor_noise::(\w+)::\{(.*)\}\n", head[1]):
                self.assertLessEqual(set(names.split(", ")), set(self.DEFINED.findall(modules[other])))
                imported |= dict.fromkeys(names.split(", "), other)
            used = set(re.findall(r"\b(?:gabor_|Gabor|GABOR_)\w+", re.sub("//.*", "", code[module])))
            elsewhere = used & {name for other in code if other != module for name in self.DEFINED.findall(code[other])}
            self.assertEqual(elsewhere - set(self.DEFINED.findall(code[module])), set(imported))
        if shutil.which("naga"):
            whole = self.folder / "whole.wgsl"
            whole.write_text("\n".join(code.values()))
            run("naga", whole)
        self.assertEqual(set(re.findall(r'load_shader_library!\(app, "(\w+).wgsl"\)', (root / "src" / "lib.rs").read_text())), set(modules))
        return [f"src/{module}.wgsl" for module in modules]

    def test_crate_can_be_published_and_loads_its_modules(self):
        if not shutil.which("cargo"):
            self.skipTest("not installed: cargo")
        self.unpack()
        if subprocess.run(["cargo", "fetch", "--offline"], cwd=self.folder, capture_output=True).returncode != 0:
            self.skipTest("Bevy's crates are not installed: cargo fetch in build/packages/staged/bevy")
        for command in ("package", "test"):  # cargo publish --dry-run is cargo package with a look into the registry
            run("cargo", command, "--offline", "--target-dir", ROOT / "build" / "bevy", cwd=self.folder)


class Blender(Node):
    part = "gabor_noise"

    def test_manifest_is_accepted_by_blender(self):
        self.unpack()
        manifest = tomllib.loads((self.folder / "blender_manifest.toml").read_text())
        self.assertEqual(manifest["version"], VERSION)
        self.assertEqual((manifest["schema_version"], manifest["type"]), ("1.0.0", "add-on"))
        self.assertRegex(manifest["id"], r"^[a-z]\w*$")
        self.assertLessEqual(len(manifest["tagline"]), 64)
        self.assertNotRegex(manifest["tagline"], r"[.!?]$")
        for name in ("name", "maintainer", "blender_version_min", "license"):
            self.assertTrue(manifest[name], name)
        compile((self.folder / "__init__.py").read_text(), "__init__.py", "exec")
        if not (validators := [*ROOT.glob("build/blender/lib/*/site-packages/bpy/*/scripts/addons_core/bl_pkg/cli/blender_ext.py")]):
            self.skipTest("Blender is not installed: tools/test-engines blender")
        run(sys.executable, "-B", validators[0], "validate", self.archives[0])


class Shims(Node):
    copied = {name: name for name in ("gabor_noise.glsl", "gabor_fractal.glsl")}


class Cpp(Node):
    copied = {path.name: f"translations/{path.name}" for path in DROP_INS if path.suffix == ".hpp"}

    def test_the_example_draws_its_picture(self):
        if not shutil.which("c++"):
            self.skipTest("no C++ compiler")
        self.unpack()
        run("c++", "-std=c++11", "-O1", "-DGABOR_INLINE=inline", self.folder / "relief.cpp", "-o", self.folder / "relief")
        drawn = subprocess.run([self.folder / "relief"], check=True, capture_output=True).stdout
        self.assertEqual(drawn[:15], b"P5 768 256 255\n")
        with Image.open(SHADERS / "nodes" / "cpp" / "relief.png") as kept:
            difference = np.abs(np.asarray(kept.convert("L"), float).ravel() - np.frombuffer(drawn[15:], "u1"))
        self.assertLess(difference.max(), 1.5)


class Godot(Node):
    part = place = "addons/gabor_noise"
    included = {f"gabor_{name}.gdshaderinc": [f"translations/gabor_{name}.gdshaderinc"] for name in ("noise", "fractal")}

    def test_unpacks_into_addons(self):
        files = self.unpack()
        self.assertEqual({pathlib.PurePath(name).parts[:2] for name in files}, {("addons", "gabor_noise")})
        root = self.folder / "addons" / "gabor_noise"
        for name in ("gabor_noise", "gabor_fractal"):
            for ending in ("gdshaderinc", "gd"):
                self.assertRegex((root / f"{name}.{ending}.uid").read_text(), r"^uid://[a-y0-8]+\n?$")
                for path in re.findall(r"res://([\w./]+)", (root / f"{name}.{ending}").read_text()):
                    self.assertIn(path, files)
        icon = (root / "icon.png").read_bytes()
        self.assertEqual((icon[:8], struct.unpack(">II", icon[16:24])), (b"\x89PNG\r\n\x1a\n", (128, 128)))


class MaterialMaker(Node):
    name = "material_maker"
    included = {"gabor_noise.mmg": ["translations/gabor_noise.gdshaderinc"],
                "gabor_fractal.mmg": ["translations/gabor_noise.gdshaderinc", "translations/gabor_fractal.gdshaderinc"]}

    def quoted(self, text):
        return json.dumps(text.decode())[1:-1].encode()


class MaterialX(Node):
    def made(self, root):
        """Checks that the translations to OSL and MDL have each function of the GLSL. tests/engines runs them."""
        library = root / "libraries" / "gabor"
        mdl, sources = library / "genmdl" / "mx_gabor.mdl", [*(library / "genglsl").rglob("*.glsl")]
        osl = [(library / "genosl" / path.relative_to(library / "genglsl")).with_suffix(".osl") for path in sources]
        functions = {path: set(re.findall(r"^(?:export )?\w+ (mx_gabor\w+)\(", path.read_text(), re.MULTILINE))
                     for path in (mdl, *osl, *sources)}
        for source, made in zip(sources, osl):
            self.assertLessEqual(functions[source], functions[made] & functions[mdl])
        documents = [library / f"gabor_{name}.mtlx" for name in ("defs", "ng")]
        documents += [library / target / f"gabor_{target}_impl.mtlx" for target in ("genglsl", "genosl", "genmdl")]
        return [str(path.relative_to(root)) for path in (mdl, *osl, *documents)]

    def test_library_is_valid(self):
        """Validates all files of the library as one document, since graphs name definitions of other files."""
        if not MXVALIDATE.exists():
            self.skipTest("mxvalidate is not installed: tools/test-engines materialx-glsl")
        files = [name for name in sorted(self.unpack()) if name.endswith(".mtlx")]
        whole = self.folder / "whole.mtlx"
        whole.write_text('<materialx version="1.39" xmlns:xi="http://www.w3.org/2001/XInclude">'
                         + "".join(f'<xi:include href="{name}"/>' for name in files) + "</materialx>")
        self.assertIn("is a valid MaterialX document", run(MXVALIDATE, whole))


class Osl(Node):
    library = "nodes/materialx/libraries/gabor/genosl/lib/mx_gabor"
    included = dict.fromkeys(("gabor_noise.osl", "gabor_erosion.osl", "gabor_ocean.osl"), [f"{library}.osl"])
    included["gabor_fractal.osl"] = [f"{library}.osl", f"{library}_fractal.osl"]

    def text(self, original):
        """Returns a file of MaterialX's package, which the repository lacks."""
        run(sys.executable, ROOT / "tools" / "package", "materialx", "--stage", self.folder / "materialx")
        return (self.folder / original.removeprefix("nodes/")).read_bytes()


HLSL = [path.stem for path in DROP_INS if path.suffix == ".hlsl"]
TITLES = ("Noise", "Stripes", "Fractal", "Fractal Filtered", *(name.replace("_", " ").title() for name in MATERIALS), "Terrain", "Sea")  # of nodes


class Unity(Node):
    place = "package"
    copied = {f"{name}.hlsl": f"translations/{name}.hlsl" for name in HLSL}

    def made(self, root):
        """Returns the names of the HLSL and the sub graphs, which tests/dialects/test_nodes.py checks, and of their ids."""
        files = [*(f"Gabor{name}.hlsl" for name in ("Noise", "Materials", "Terrain", "Sea")), *(f"Gabor {name}.shadersubgraph" for name in TITLES)]
        return [*files, *(f"{name}.meta" for name in [*files, *self.copied])]

    def test_each_file_has_an_id_of_its_own(self):
        """Checks the .meta files, since Unity ignores a package's files that have none."""
        files = self.unpack()
        root = self.folder / "package"
        described = json.loads((root / "package.json").read_text())
        self.assertEqual(described["name"], "com.gabor-noise.nodes")
        self.assertEqual(described["version"], VERSION)
        self.assertEqual({name for name in files if name.endswith(".meta")},
                         {f"{name}.meta" for name in files if not name.endswith(".meta")})
        ids = [guid(path) for path in root.glob("*.meta")]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLessEqual({("GaborNoise.hlsl", "f95faf149a677348e759cdb37a71f456"), ("Gabor Noise.shadersubgraph", "699a1602ebe4724af3c57261fd735070")},
                             {(path.stem, guid(path)) for path in root.glob("*.meta")})  # by which projects refer to them
        for path in root.glob("*.hlsl"):
            for include in re.findall(r'#include "([^"]+)"', path.read_text()):
                self.assertTrue((root / include).exists(), include)
        importers = {"shadersubgraph": "60072b568d64c40a485e0fc55012dc9f"}  # Unity's own id of its importer
        for path in root.glob("*.meta"):
            found = re.search("fileID: 11500000, guid: (\\w+), type: 3", path.read_text())
            self.assertEqual(found and found[1], importers.get(path.name.split(".")[-2]), path.name)
        self.assert_npm_accepts_it()


class Unreal(Node):
    def made(self, root):
        """Checks that a file has the texts that it needs, and includes nothing: Unreal looks for all files that are named."""
        for name in HLSL:
            text = (root / f"{name}.ush").read_text()
            self.assertNotIn("#include", text)
            guards = re.findall(r"^#define (GABOR_\w+_HLSL) 1$", text, re.MULTILINE)
            self.assertEqual((len(guards), guards[-1]), (len(set(guards)), f"{name.upper()}_HLSL"))
            self.assertLessEqual({f"GABOR_{each}_HLSL" for each in re.findall(r"#ifn?def GABOR_(\w+)_HLSL", text)} - {"GABOR_SPARSE_HLSL"}, {*guards, "GABOR_NOISE_HLSL"})
        for name in TITLES:
            self.assertTrue((root / re.search("Include File Paths: /Project/(.*)", (root / f"Gabor {name}.hlsl").read_text())[1]).exists(), name)
        return [*(f"{name}.ush" for name in HLSL), *(f"Gabor {name}.hlsl" for name in TITLES)]


class Pasted(Node):
    """A node whose files paste HLSL after the HLSL that it includes elsewhere."""

    def text(self, original):
        return re.sub(rb'#ifndef \w+\n#include "gabor_noise.hlsl"\n#endif\n', b"", super().text(original))


PLAIN = {  # nodes that need no more than Node checks: the texts that their files include
    "shadertoy": {"gabor_noise.frag": ["gabor_noise.glsl"], "gabor_erosion.frag": [
                      "gabor_noise.glsl", "gabor_erosion.glsl", "gabor_fractal.glsl",
                      *(f"passes/{name}.glsl" for name in ("ground", "ranges", "landscape", "srgb"))],
                  "gabor_ocean.frag": ["gabor_noise.glsl", "gabor_fractal.glsl", "gabor_ocean.glsl", "passes/srgb.glsl", "passes/seascape.glsl"],
                  "gabor_fractal.frag": ["gabor_noise.glsl", "gabor_fractal.glsl"]},
    "slang": {"gabor_noise.slang": ["translations/gabor_noise.hlsl"],
              "gabor_fractal.slang": ["translations/gabor_noise.hlsl", "translations/gabor_fractal.hlsl"]},
    "three": {},
}
NODES = [Bevy, Blender, Cpp, Godot, MaterialMaker, MaterialX, Osl, Shims, Unity, Unreal,
         *(type(name.title(), (Pasted if name == "slang" else Node,), {"included": included}) for name, included in PLAIN.items())]


AUTHORS, ADDRESS = "The gabor-noise authors", "@REPOSITORY@"
MANIFESTS = {  # what registries and engines read from each
    "package.json": {
        "name": "gabor-noise", "version": "@VERSION@", "license": "MIT", "author": AUTHORS, "homepage": f"{ADDRESS}#readme", "type": "module",
        "repository": {"type": "git", "url": f"git+{ADDRESS}.git"}, "bugs": f"{ADDRESS}/issues", "sideEffects": False,
        "files": ["index.js", "index.d.ts", "shaders/gabor_*.glsl", "shaders/translations", "shaders/nodes/three", "shaders/nodes/shims"],
        "exports": {".": "./index.js", "./shaders/*": "./shaders/*", "./package.json": "./package.json"},
        "peerDependencies": {"three": ">=" + json.loads((ROOT / "tests/engines/three/package.json").read_text())["dependencies"]["three"]},
        "peerDependenciesMeta": {"three": {"optional": True}}},
    "shaders/nodes/unity/package.json": {
        "name": "com.gabor-noise.nodes", "displayName": "Gabor noise", "version": "@VERSION@", "unity": "2021.3", "license": "MIT",
        "author": {"name": AUTHORS}, "documentationUrl": f"{ADDRESS}#readme", "changelogUrl": f"{ADDRESS}/blob/HEAD/CHANGELOG.md",
        "licensesUrl": f"{ADDRESS}/blob/HEAD/LICENSE", "repository": {"type": "git", "url": f"git+{ADDRESS}.git"}},
    "shaders/nodes/bevy/Cargo.toml": {
        "package": {"name": "bevy_gabor_noise", "version": "@VERSION@", "edition": "2024", "license": "MIT", "authors": [AUTHORS],
                    "repository": ADDRESS, "readme": "README.md", "categories": ["game-development", "graphics"]},
        "dependencies": {name: {"version": "0.19", "default-features": False} for name in ("bevy_app", "bevy_shader")},
        "dev-dependencies": {"bevy_asset": {"version": "0.19", "default-features": False}}},
    "shaders/nodes/blender/gabor_noise/blender_manifest.toml": {
        "schema_version": "1.0.0", "id": "gabor_noise", "version": "@VERSION@", "name": "Gabor Noise", "maintainer": AUTHORS, "website": ADDRESS,
        "type": "add-on", "tags": ["Material", "Node"], "blender_version_min": "4.2.0", "license": ["SPDX:MIT"], "copyright": [f"2026 {AUTHORS}"]},
    "packages/pypi/pyproject.toml": {
        "build-system": {"requires": ["scikit-build-core>=0.10", "nanobind>=2.4"], "build-backend": "scikit_build_core.build"},
        "project": {"name": "gabor-noise", "version": "@VERSION@", "readme": "README.md", "license": "MIT", "license-files": ["LICENSE"],
                    "authors": [{"name": AUTHORS}], "requires-python": ">=3.9", "dependencies": ["numpy"],
                    "urls": {"Paper": "https://doi.org/10.2312/egs.20191009", "Repository": ADDRESS, "Issues": f"{ADDRESS}/issues"}},
        "tool": {"scikit-build": {"minimum-version": "0.10", "wheel.packages": ["gabor_noise"], "wheel.py-api": "cp312",
                                  "build-dir": "build/{wheel_tag}", "cmake.build-type": "Release"},
                 "cibuildwheel": {"build": "cp3{9,10,11,12,13,14}-*", "archs": "auto64", "test-requires": "pillow",
                                  "test-command": "python {project}/tests/module_test.py"}}},
    "packages/vcpkg/vcpkg.json": {
        "name": "gabor-noise", "version": "@VERSION@", "homepage": ADDRESS, "license": "MIT",
        "dependencies": [{"name": name, "host": True} for name in ("vcpkg-cmake", "vcpkg-cmake-config")]},
}


class Manifests(unittest.TestCase):
    maxDiff = None

    def test_each_says_what_registries_read(self):
        def plain(value, name=""):
            """Returns the value without texts for people; TOML nests the names that the table joins."""
            if not isinstance(value, dict):
                return value
            made = {key: plain(each) for key, each in value.items() if key not in ("description", "keywords", "classifiers", "tagline")}
            return {f"{key}.{inner}" if key in ("wheel", "cmake") else key: each for key, given in made.items()
                    for inner, each in (given.items() if key in ("wheel", "cmake") else [("", given)])}
        for name, wanted in MANIFESTS.items():
            with self.subTest(name):
                text = (ROOT / name).read_text()
                found = plain(json.loads(text) if name.endswith(".json") else tomllib.loads(text))
                self.assertEqual(found, wanted)


class Folders(unittest.TestCase):
    def test_each_node_has_a_package(self):
        self.assertEqual({each.name or each.__name__.lower() for each in NODES},
                         {path.name for path in (SHADERS / "nodes").iterdir() if path.is_dir()})


class Vcpkg(Package):
    """Runs the port with stand-ins for vcpkg's functions, based on its manual, since vcpkg would have to be downloaded."""

    tools = "cmake",
    VCPKG = """
set(CURRENT_PACKAGES_DIR "${FOLDER}/installed")
function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()
function(vcpkg_cmake_configure)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "SOURCE_PATH" "OPTIONS")
    run(${CMAKE_COMMAND} -S "${given_SOURCE_PATH}" -B "${FOLDER}/b" "-DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR}" ${given_OPTIONS})
endfunction()
function(vcpkg_cmake_install)
    run(${CMAKE_COMMAND} --build "${FOLDER}/b" --target install)
endfunction()
function(vcpkg_cmake_config_fixup)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "CONFIG_PATH" "")
    file(MAKE_DIRECTORY "${CURRENT_PACKAGES_DIR}/share")
    file(COPY "${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH}/" DESTINATION "${CURRENT_PACKAGES_DIR}/share/gabor-noise")
    file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/${given_CONFIG_PATH}")
    # The real one also fixes the prefix that the targets derive from their own folder, now one level higher.
    file(GLOB scripts "${CURRENT_PACKAGES_DIR}/share/gabor-noise/*.cmake")
    foreach(script ${scripts})
        file(READ "${script}" text)
        string(REPLACE "/../../../" "/../../" text "${text}")
        set(up [[get_filename_component(_IMPORT_PREFIX "${_IMPORT_PREFIX}" PATH)]])
        string(REPLACE "${up}\\n${up}\\n${up}" "${up}\\n${up}" text "${text}")
        file(WRITE "${script}" "${text}")
    endforeach()
endfunction()
function(vcpkg_install_copyright)
    cmake_parse_arguments(PARSE_ARGV 0 given "" "" "FILE_LIST")
    configure_file("${given_FILE_LIST}" "${CURRENT_PACKAGES_DIR}/share/gabor-noise/copyright" COPYONLY)
endfunction()
include("${FOLDER}/gabor-noise/portfile.cmake")
"""

    def test_port_installs_and_is_found(self):
        self.unpack()
        manifest = json.loads((self.folder / "gabor-noise" / "vcpkg.json").read_text())
        self.assertEqual((manifest["name"], manifest["version"]), ("gabor-noise", VERSION))
        (self.folder / "vcpkg.cmake").write_text(self.VCPKG)
        run("cmake", f"-DFOLDER={self.folder}", "-P", self.folder / "vcpkg.cmake")
        installed = self.folder / "installed"
        self.assertEqual({path.name for path in installed.iterdir()}, {"share"})
        self.assertEqual((installed / "share/gabor-noise/copyright").read_text(), (ROOT / "LICENSE").read_text())
        user = self.folder / "user"
        user.mkdir()
        (user / "main.cpp").write_text(
            '#include "gabor_noise.hpp"\nint main() { return gabor_noise({0.3f, 0.7f}, 4.0f, 0.0f, 7u) == 0.0f; }\n')
        (user / "CMakeLists.txt").write_text(
            "cmake_minimum_required(VERSION 3.25)\nproject(user LANGUAGES CXX)\nfind_package(gabor-noise CONFIG REQUIRED)\n"
            "add_executable(user main.cpp)\ntarget_link_libraries(user PRIVATE gabor_noise::cpp)\n")
        run("cmake", "-S", user, "-B", user / "b", f"-DCMAKE_PREFIX_PATH={installed}")
        run("cmake", "--build", user / "b")
        run(user / "b" / "user")


class Benchmark(Package):
    def test_page_has_all_shaders(self):
        page, = self.archives
        self.assertEqual(page.suffix, ".html")
        text = page.read_text()
        self.assertNotRegex(text, r"<(?:script|link|img)[^>]* src=")
        shaders = dict(re.findall(r'<script type="text/plain" id="(.*)">\n((?:.*\n)*?)</script>\n', text))
        self.assertEqual(set(re.findall(r"\w+", " ".join(re.findall(r'(?m)^    \[".*?", \[(.*?)\], "', text)))), {name.partition(".")[0] for name in shaders})
        for name, shader in shaders.items():
            folder = "host/lab/passes/bench" if "yardsticks" in name else "shaders" if name.endswith(".glsl") else "shaders/translations"
            if name != "yardsticks.wgsl":
                self.assertEqual(shader, (ROOT / folder / name).read_text(), name)
        self.assertEqual(*(set(re.findall(r"(?m)^(?:fn|float) (\w+_noise)\(", shaders[f"yardsticks.{ending}"])) for ending in ("glsl", "wgsl")))
        subjects = re.findall(r'(?m)^    \["(.*?)", \[(.*?)\], "(.*?)"(?:, (\d))?\],$', text)
        self.assertGreater(len(subjects), 10)
        for name, files, call, taps in subjects:
            code = "".join(shaders[f"{file}.glsl"] for file in re.findall(r"\w+", files))
            run("glslangValidator", "--stdin", "-S", "frag", input=f"""#version 300 es
{f"#define GABOR_TAPS {taps}" if taps else ""}
precision highp float;
uniform uint seed;
uniform float frequency, orientation;
out vec4 result;
{code}void main() {{ vec2 p = gl_FragCoord.xy; result = vec4({call}); }}""")


class Repository(unittest.TestCase):
    def npm_with(self, remote, *more):
        """Returns package.json of npm's package in a repository with this remote."""
        self.root = root = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))
        repository(root, ("CMakeLists.txt", "package.json", "packages/npm/README.md", *(f"tools/{name}" for name in ("copies.py", "glsl.py", "hlsl_nodes.py", "index.py", "nodes.py", "package", "translate", "unity.py", "version.py", "wgsl.py")),
                          "shaders/translations/gabor_vectors.hpp", *more))
        (root / "shaders/nodes").mkdir(parents=True, exist_ok=True)
        if remote:
            run("git", "-C", root, "remote", "add", "origin", remote)
        run(sys.executable, "-B", root / "tools/package", "npm")
        return json.loads((root / "build/packages/staged/npm/package.json").read_text())

    def test_readmes_link_to_what_the_package_lacks(self):
        """Also, a package is the same whenever it is built."""
        folder, base = "shaders/nodes/slang", "https://example.org/somebody/gabor"
        self.npm_with(f"{base}.git", "shaders/nodes/LICENSE", "shaders/translations/gabor_noise.hlsl", f"{folder}/gabor_noise.slang", f"{folder}/README.md")
        text = "![seen](../../a.png) [page](../../../docs/b.md) [kept](gabor_noise.slang) [web](https://d) @VERSION@ @REPOSITORY@\n"
        (self.root / folder / "README.md").write_text(text)
        sums = []
        for _ in range(2):
            archives = [self.root / run(sys.executable, "-B", self.root / "tools/package", name).strip() for name in ("slang", "npm")]
            sums.append([(path.name, hashlib.sha256(path.read_bytes()).hexdigest()) for path in archives])
            made = (self.root / "build/packages/staged/slang/README.md").read_text()
            for path in (self.root / folder).iterdir():
                os.utime(path, (0, 0))
        with zipfile.ZipFile(archives[0]) as zipped, tarfile.open(archives[1]) as tarred:
            self.assertEqual({each.filename: each.date_time for each in zipped.infolist()},
                             dict.fromkeys(("LICENSE", "README.md", "gabor_noise.slang"), (2026, 1, 1, 0, 0, 0)))
            self.assertEqual({each.mtime for each in tarred.getmembers()}, {1767225600})
        self.assertEqual(archives[0].name, f"gabor-noise-slang-{VERSION}.zip")
        self.assertEqual(archives[1].read_bytes()[4:8], (1767225600).to_bytes(4, "little"))  # the time in gzip's header
        self.assertEqual(*sums)
        line, *_, last = made.splitlines()
        self.assertEqual(line, f"![seen]({base}/raw/HEAD/shaders/a.png) [page]({base}/blob/HEAD/docs/b.md) [kept](gabor_noise.slang) [web](https://d) {VERSION} {base}")
        self.assertEqual(last, f"[Repository and documentation]({base})")
        refused = subprocess.run([sys.executable, "-B", self.root / "tools/package", "all", "--stage", self.root], capture_output=True, text=True)
        self.assertIn("--stage needs one package's name", refused.stderr)

    def test_an_address_on_the_web_is_named(self):
        for remote in ("https://example.org/somebody/digit.git", "git@example.org:somebody/digit.git"):
            self.assertEqual(self.npm_with(remote)["repository"]["url"], "git+https://example.org/somebody/digit.git")

    def test_other_remotes_are_not(self):
        for remote in (None, "/a/folder"):
            self.assertNotIn("repository", self.npm_with(remote))


class Release(Folder):
    def setUp(self):
        super().setUp()
        repository(self.folder, filter(re.compile(
            "(?:CMakeLists.txt|CITATION.cff|CHANGELOG.md|README.md|shaders/|tools/|tests/golden/|docs/demo/|docs/benchmark.html|"
            "host/lab/passes/bench/|host/render/request/(?:struct|material)_rows|host/render/request/presets/)").match, tracked(ROOT)))

    def release(self, *arguments):
        return subprocess.run([sys.executable, "-B", self.folder / "tools/release", *arguments], capture_output=True, text=True)

    def assert_refused(self, reason, *arguments):
        refused = self.release(*arguments)
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertIn(reason, refused.stderr)

    def test_refuses_an_unfinished_tree(self):
        changes, citation = self.folder / "CHANGELOG.md", self.folder / "CITATION.cff"
        changes.write_text(f"# Changelog\n\n## {VERSION} (unreleased)\n")
        self.assert_refused(f"CHANGELOG.md begins with {VERSION} (unreleased), not {VERSION}")
        changes.write_text(f"# Changelog\n\n## {VERSION}\n")
        self.assert_refused("uncommitted changes")
        citation.write_text(re.sub("(?m)^version: .*", "version: 0.1.0", citation.read_text()))
        self.assert_refused("CITATION.cff names another version")
        self.assert_refused("three numbers such as", "--set", "two")

    def test_notes_are_the_newest_section_of_the_changelog(self):
        newest = runpy.run_path(str(ROOT / "tools" / "release"))["newest"]
        self.assertEqual(newest("# Changelog\n\n## 2.0.0\n\nNew.\n\n### Parts\n\n- a\n\n## 1.0.0\n\nOld.\n"), ("2.0.0", "\nNew.\n\n### Parts\n\n- a\n\n"))
        self.assertIn("\n### Documents\n", newest((ROOT / "CHANGELOG.md").read_text())[1])

    def test_sets_the_address_of_the_page(self):
        self.assert_refused("expected one such as https", "--page", "somewhere")
        for address in ("https://example.org/gabor/", "https://example.org/other/"):
            made = self.release("--page", address)
            self.assertEqual(made.returncode, 0, made.stderr)
            self.assertIn(f"[Live page]({address})", (self.folder / "README.md").read_text())
            self.assertIn(f'content="{address}card.jpg"', (self.folder / "docs/demo/index.html").read_text())

    def test_commands_publish_the_packages(self):
        commands = runpy.run_path(str(ROOT / "tools" / "release"))["PUBLISH"]
        named = set(re.findall(r"build/packages/\S+(?:\.tgz|\.zip|\.toml)", commands))
        for name in ("npm", "unity", "bevy", "blender", "godot", "materialx", "demo"):
            run(sys.executable, "-B", ROOT / "tools" / "package", name)
        self.assertEqual([path for path in named if not (ROOT / path).exists()], [])
        self.assertEqual(len(named), 7)

    def test_sets_the_version_everywhere(self):
        made = self.release("--set", "9.8.7")
        self.assertEqual(made.returncode, 0, made.stderr)
        changed = {name for name in tracked(self.folder) if (self.folder / name).read_bytes() != (ROOT / name).read_bytes()}
        naming = {str(path.relative_to(ROOT)) for path in [*DROP_INS, *(ROOT / "tests/golden").glob("*.txt")]
                  if re.search(r"GABOR_NOISE_VERSION|\Aversion ", path.read_text())}
        self.assertLessEqual({"CMakeLists.txt", "CITATION.cff", "docs/demo/texts.js", *naming}, changed)
        for name in changed:
            old, new = ((root / name).read_text().splitlines() for root in (ROOT, self.folder))
            differences = [line for before, line in zip(old, new, strict=True) if before != line]
            self.assertEqual([line for line in differences if not re.search(r"9\.8\.7|90807", line)], [], name)

# The classes of each test that CTest runs.
PACKAGES = {"nodes": [*NODES, Folders, Manifests], "npm": [Npm, Repository], "module": [Module], "pypi": [Pypi], "vcpkg": [Vcpkg], "benchmark": [Benchmark],
            "release": [Release]}


def main():
    names = [name for name in sys.argv[1:] if name != "-v"] or list(PACKAGES)
    os.environ["PIP_NO_INPUT"] = "1"
    suite = unittest.TestSuite(unittest.defaultTestLoader.loadTestsFromTestCase(each) for name in names for each in PACKAGES[name])
    result = unittest.TextTestRunner(verbosity=1 + ("-v" in sys.argv)).run(suite)
    if not result.wasSuccessful():
        return 1
    return 77 if len(result.skipped) == result.testsRun else 0


sys.exit(main())

"""Checks the source text: its format, its comments, and that it names one version everywhere."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]


def text(path):
    return (ROOT / path).read_text()


class Format(unittest.TestCase):
    def test_cpp_is_formatted(self):
        tool = shutil.which("clang-format-14") or "clang-format"
        if not shutil.which(tool) or " 14." not in subprocess.run([tool, "--version"], capture_output=True, text=True).stdout:
            self.skipTest("needs clang-format 14, because later versions break lines elsewhere")
        files = sorted(path for folder in ("host", "shaders", "tests") for pattern in ("*.cpp", "*.hpp", "*.h")
                       for path in (ROOT / folder).rglob(pattern))
        self.assertGreater(len(files), 100)
        result = subprocess.run([tool, "--dry-run", "--Werror", *files], capture_output=True, text=True)
        off = sorted(set(re.findall(r"^(.*?):\d+:\d+: error", result.stderr, re.MULTILINE)))
        self.assertEqual((off, result.returncode), ([], 0), result.stderr)


class Layers(unittest.TestCase):
    """Each library uses only those below it, so that no two include each other."""

    BELOW = {"noise": "", "statistics": "", "vulkan": "", "image": "", "render/request": "noise image",
             "render/plan": "noise image vulkan render/request",
             "render/output": "noise image vulkan render/request render/plan",
             "fit": "noise image statistics render/request",
             "cli": "noise image statistics vulkan render/request render/plan render/output fit",
             "viewer": "noise image vulkan render/request render/plan render/output fit",
             "lab": "noise image statistics vulkan render/request render/plan render/output cli"}

    def test_folders_include_only_those_below(self):
        host, seen, wrong = ROOT / "host", set(), []
        folder_of = lambda path: next((folder for folder in self.BELOW if path.startswith(f"{folder}/")), "")
        for path in sorted(path for path in host.rglob("*") if path.suffix in (".cpp", ".hpp", ".in")):
            name = path.relative_to(host).as_posix()
            folder = folder_of(name)
            for included in re.findall(r'^#include "(.*)"', path.read_text(), re.MULTILINE):
                other = folder_of(included)
                if other and other != folder:
                    seen.add(folder)
                    if other not in self.BELOW.get(folder, "").split():
                        wrong.append(f"{name} includes {included}")
        self.assertEqual(wrong, [])
        self.assertGreater(len(seen), 5)

    def test_folders_stand_in_order(self):
        order = list(self.BELOW)
        self.assertEqual([(folder, other) for folder, below in self.BELOW.items() for other in below.split()
                          if order.index(other) >= order.index(folder)], [])


class Setup(unittest.TestCase):
    """tools/setup where it cannot install packages."""

    def check_refuses(self, words, **tools):
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            for name, script in tools.items():
                path = pathlib.Path(folder) / name
                path.write_text(f"#!/bin/sh\n{script}\n")
                path.chmod(0o755)
            result = subprocess.run(["/bin/sh", ROOT / "tools/setup"], env={"PATH": folder}, capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (1, "", 1), result.stderr)
        self.assertIn(words, result.stderr)

    def test_names_what_to_run(self):
        for status in "", "unknown ok not-installed", "deinstall ok config-files":
            self.check_refuses("no sudo; run as root: apt-get install --no-install-recommends build-essential catch2 cmake",
                               **{"dpkg-query": f"echo '{status}'"}, grep='exec /bin/grep "$@"', id="echo 1000")
        for manager, words in {"dnf": "dnf install boost-devel", "pacman": "pacman -S base-devel", "brew": "brew install boost",
                               "other": "apt-get install build-essential"}.items():
            self.check_refuses(f"there is no c++ cmake glslangValidator ninja pkg-config; install what gabor needs: {words}",
                               **{manager: ""})


    @unittest.skipUnless(shutil.which("dpkg-query"), "needs dpkg")
    def test_installs_what_cmake_looks_for(self):
        """Looks up which package of this system owns the files that CMake finds."""
        wanted = set(re.findall(r'packages="([^"$]*)', text("tools/setup"))[0].split())
        installed = set(wanted)
        for _ in range(2):  # Ubuntu's libjpeg-dev needs libjpeg8-dev, which needs the package with the files
            of = [name for name in installed if name in wanted or name.endswith("-dev")]
            said = subprocess.run(["dpkg-query", "-W", "-f", "${Depends}\n", *of], capture_output=True, text=True).stdout
            installed |= set(re.findall(r"[a-z0-9.+-]+", said))
        plain = {"JPEG": "include/jpeglib.h", "PNG": "include/png.h", "TIFF": "include/*/tiffio.h", "PkgConfig": "bin/pkg-config",
                 "Vulkan": "lib/*/libvulkan.so", "X11": "include/X11/Xlib.h", "Catch2": "include/catch2"}
        lines = "".join(text(f"{folder}CMakeLists.txt") for folder in ("host/", "host/viewer/", "tests/", "tests/viewer/", "shaders/"))
        names = set(re.findall(r"find_package\((\S+?)[\s)]|pkg_check_modules\(.*GLOBAL ([\w-]+)|find_program\(\S+ (?!NAMES)(\w+)", lines))
        self.assertGreater(len(names), 15)
        for name in map("".join, names):
            places = [plain[name]] if name in plain else [f"{folder}/{file}" for folder in (
                "bin", "lib/*/cmake/*", "lib/cmake/*", "share/cmake/*", "share/*/cmake", "lib/*/pkgconfig", "share/pkgconfig", "lib/*/cmake")
                for file in (name, f"{name}Config.cmake", f"{name.lower()}-config.cmake", f"{name}.pc")]
            files = [file for place in places for file in pathlib.Path("/usr").glob(place) if file.is_file() or name in plain]
            owners = {line.split(":")[0] for file in files for line in
                      subprocess.run(["dpkg-query", "-S", file], capture_output=True, text=True).stdout.splitlines()}
            self.assertTrue(not files or owners & installed, f"{name}: {owners}")


class Comments(unittest.TestCase):
    """Headers must document functions and types with ///; for a type, documented members suffice. Other comments use //."""

    def test_declarations_in_headers_are_documented(self):
        missing = []
        for path in sorted((ROOT / "host").rglob("*.hpp")):
            before = ""
            lines = path.read_text().splitlines()
            for number, line in enumerate(lines, 1):
                # A comment also covers the declarations that follow without an empty line.
                if not before and re.match(r"(?!namespace|using|extern)[A-Za-z][^=]*[({]", line):
                    body = "\n".join(lines[number:]).split("\n}")[0]
                    if not (re.match("struct|class|enum", line) and "///" in body):
                        missing.append(f"{path.relative_to(ROOT)}:{number}: {line}")
                before = line.strip()
        self.assertEqual(missing, [])

    def test_comments_on_declarations_have_three_slashes(self):
        wrong = [f"{path.relative_to(ROOT)}: {comment}" for path in sorted((ROOT / "host").rglob("*.hpp"))
                 for comment in re.findall(r"^// .*(?=\n[A-Za-z])", path.read_text(), re.MULTILINE)]
        self.assertEqual(wrong, [])


def places_of(path, pattern, where=None):
    """Returns file:line of each match in a text, by default the file's."""
    where = text(path) if where is None else where
    return [f"{path}:{where.count(chr(10), 0, match.start()) + 1}" for match in re.finditer(pattern, where, re.MULTILINE)]


class Shaders(unittest.TestCase):
    """What parsers, minifiers and hosts of GLSL need of texts that users paste: docs/engines.md names those that
    tools/test-engines parsers runs."""

    drop_ins = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "shaders").glob("gabor_*.glsl"))
    # What "Copy code" adds to a user's shader: host/viewer/CMakeLists.txt lists it.
    pasted = [f"shaders/{name}" for name in re.findall(r"\w+/\w+\.glsl", text("host/viewer/CMakeLists.txt"))]
    shims = sorted(str(path.relative_to(ROOT)) for path in (ROOT / "shaders/nodes/shims").glob("*.glsl"))
    pasted += shims

    def none(self, pattern, files, of=text):
        """Checks that no line of these files matches."""
        self.assertGreater(len(files), 10)
        self.assertEqual([place for path in files for place in places_of(path, pattern, of(path))], [])

    def code(self, path):
        """Returns the text with spaces in place of comments."""
        return re.sub(r"//.*|/\*[\s\S]*?\*/", lambda match: re.sub(r"\S", " ", match[0]), text(path))

    def test_no_comment_shares_a_line_with_a_directive_or_ends_the_line_before_it(self):
        self.none(r"^ *#.*(//|/\*)", self.drop_ins + self.pasted)
        self.none(r"^ *[^/\s].*//.*\n *#", self.drop_ins + self.pasted)

    def test_no_comment_has_a_double_quote(self):
        self.none(r'^(?! *#include ).*"', self.drop_ins + self.pasted)

    def test_directives_stand_at_file_scope(self):
        def inside(path):
            """Returns the lines within braces and parentheses, and empty lines for all others."""
            depth, lines = 0, []
            for line in self.code(path).splitlines():
                lines.append(line if depth else "")
                depth += 0 if line.startswith("#") else sum(map(line.count, "({")) - sum(map(line.count, ")}"))
            self.assertEqual(depth, 0, path)
            return "\n".join(lines)
        self.none(r"^ *#", self.drop_ins + self.pasted, inside)

    def test_every_macro_has_a_value(self):
        self.none(r"^ *# *define +\w+ *$", self.drop_ins + self.pasted, self.code)

    def test_no_member_is_named_like_a_component(self):
        def members(path):
            """Returns the text with nothing but the bodies of structs."""
            code = self.code(path)
            kept = {i for match in re.finditer(r"^struct \w+ \{([^}]*)\}", code, re.MULTILINE) for i in range(*match.span(1))}
            return "".join(each if i in kept or each == "\n" else " " for i, each in enumerate(code))
        self.assertIn("vec2 gradient;", members("shaders/gabor_noise.glsl"))
        self.none(r" (?:[xyzw]{1,4}|[rgba]{1,4}|[stpq]{1,4})(?:\[.*\])?[;,]", self.drop_ins + self.pasted, members)

    def test_no_function_declares_two_loop_variables_of_one_name(self):
        """In HLSL, a loop's variable lives on after the loop: DXC and FXC warn."""
        def second(path):
            """Returns the text with "again" for each further loop variable of its name in a function."""
            def renamed(match):
                seen = set()
                return re.sub(r"\bfor \(\w+ (\w+)", lambda loop: "again" if loop[1] in seen else seen.add(loop[1]) or loop[0], match[0])
            return re.sub(r"^\w[^;{}]*\{$[\s\S]*?^\}", renamed, self.code(path), flags=re.MULTILINE)
        self.none(r"^.*\bagain\b", self.drop_ins + self.pasted, second)

    def test_edges_of_steps_rise(self):
        """GLSL leaves smoothstep undefined where its first edge is not below the second."""
        def steps(path):
            """Returns the text with "falls" for each step between two numbers that do not rise."""
            return re.sub(r"\bsmoothstep\((-?[\d.]+), (-?[\d.]+),", lambda step: step[0] if float(step[1]) < float(step[2]) else "falls", self.code(path))
        self.none(r"\bfalls\b", self.drop_ins + self.pasted + ["shaders/passes/landscape.glsl", "shaders/passes/seascape.glsl"], steps)

    def test_private_structs_say_so(self):
        def private(path):
            before, _, after = text(path).partition("// Private implementation\n")
            return before.replace("struct", "public") + after.replace("struct", "private")
        self.none(r"^public GaborImpl|^private Gabor(?!Impl)", self.drop_ins, private)
        self.assertIn("private GaborImplAxis", private("shaders/gabor_noise.glsl"))

    def test_lines_of_drop_ins_fit_into_120_columns(self):
        self.none(".{121}", self.drop_ins + self.shims)


class Golden(unittest.TestCase):
    def test_every_public_function_has_golden_values(self):
        called = set(re.findall(r"\b(gabor_\w+)", text("tests/golden/functions.glsl")))
        public = {name for path in (ROOT / "shaders").glob("gabor_*.glsl")
                  for name in re.findall(r"^\w+ (gabor_(?!impl_)\w+)\(", path.read_text(), re.MULTILINE)}
        self.assertGreater(len(public), 60)
        self.assertEqual(public - called, set())


class Version(unittest.TestCase):
    def test_every_place_names_the_same_version(self):
        version = re.search(r"project\(gabor-noise VERSION (\d+\.\d+\.\d+)", text("CMakeLists.txt"))[1]
        major, minor, patch = map(int, version.split("."))
        found = {"CITATION.cff": re.search(r"^version: (.*)", text("CITATION.cff"), re.MULTILINE)[1],
                 "CHANGELOG.md": re.search(r"^## (\S+)(?: \(unreleased\))?$", text("CHANGELOG.md"), re.MULTILINE)[1]}
        self.assertEqual(found, dict.fromkeys(found, version))
        for name in ("noise", "sparse"):  # tools/translate --check compares the translations with these
            number = re.search(r"#define GABOR_NOISE_VERSION (\d+)\n", text(f"shaders/gabor_{name}.glsl"))[1]
            self.assertEqual(int(number), 10000 * major + 100 * minor + patch, name)


if __name__ == "__main__":
    unittest.main()

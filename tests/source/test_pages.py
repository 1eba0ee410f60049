"""Checks README and docs: links have targets, code to paste compiles, scripts do what they say, and figures match their source page."""

import json
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / name for name in subprocess.run(["git", "-C", str(ROOT), "ls-files", "*.md"], capture_output=True, text=True,
                                                check=True).stdout.splitlines()]
DEMO = ROOT / "docs" / "demo" / "index.html"
README = (ROOT / "README.md").read_text()


def anchors(page):
    """Returns the anchors that GitHub derives from a page's headings."""
    headings = re.findall(r"(?m)^#+ (.*)", re.sub(r"(?ms)^```.*?^```", "", page.read_text()))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Pages(unittest.TestCase):
    def test_links_lead_somewhere(self):
        seen = 0
        for page in PAGES:
            for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
                if re.match(r"https?:|mailto:", target):
                    continue
                path, _, anchor = target.partition("#")
                file = (page.parent / path).resolve() if path else page
                self.assertTrue(file.exists(), f"{page.relative_to(ROOT)}: no {target}")
                if anchor and file.suffix == ".md":
                    self.assertIn(anchor, anchors(file), f"{page.relative_to(ROOT)}: no {target}")
                seen += 1
        self.assertGreater(seen, 100)

    def test_readme_is_short(self):
        self.assertLessEqual(len(README.split()), 800)

    def test_the_page_of_other_noises_is_short(self):
        self.assertLessEqual(len((ROOT / "docs" / "other-noises.md").read_text().split()), 700)

    def test_the_code_that_replaces_other_noises_compiles(self):
        """In docs/other-noises.md and docs/gallery.md: all blocks that call gabor_fractal.glsl."""
        blocks = re.findall(r"(?ms)^```glsl\n(.*?)^```", "".join((ROOT / "docs" / f"{name}.md").read_text() for name in ("other-noises", "gallery")))
        blocks = [block for block in blocks if re.search("gabor_(perlin|fractal|fbm)", block)]
        self.assertEqual(len(blocks), 3)
        drop_ins = "".join((ROOT / f"shaders/gabor_{name}.glsl").read_text() for name in ("noise", "fractal"))
        for block in blocks:
            self.compile(f"#version 450\n{drop_ins}layout(location = 0) in vec4 given;\nvoid main()\n{{\n"
                         "vec2 p = given.xy;\nfloat mean = 0.0, deviation = 0.3, k = 1.0, octaves = 5.0;\nuint seed = 7u;\n"
                         f"{block}}}\n")

    def test_the_code_to_paste_compiles(self):
        code = re.search(r"(?ms)^```glsl\n(.*?)^```", README)[1].replace('#include "gabor_noise.glsl"',
                                                                         (ROOT / "shaders/gabor_noise.glsl").read_text())
        code = re.sub(r"(?m)^(\w+ \w = .*)", r"    \1", code)
        body = re.search(r"(?ms)^    float n = gabor_noise.*", code)[0]
        self.compile("#version 450\nlayout(location = 0) in vec2 p;\nlayout(location = 1) in vec2 wave;\n"
                     "layout(location = 0) out vec4 colour;\n" + code.removesuffix(body)
                     + "void main()\n{\n" + body + "    colour = vec4(v, s.x, g.yz);\n}\n")

    def test_recipes_for_materials_compile(self):
        page = (ROOT / "docs" / "materials.md").read_text()
        recipes = dict(re.findall(r"(?ms)^\*\*(\w+).*?^```\w+\n(.*?)^```", page))
        self.assertEqual(list(recipes), ["GLSL", "three", "Godot", "Unity"])
        for name, code in recipes.items():
            self.assertLessEqual(code.count("\n"), 10, name)
            kind, folder = ("hlsl", "translations/") if name == "Unity" else ("glsl", "")
            drop_ins = "".join((ROOT / f"shaders/{folder}gabor_{each}.{kind}").read_text()
                               for each in ("noise", "spectrum", "filter", "materials"))
            if name == "three":
                code = ("vec2 vUv; vec3 normal; mat3 tbn; vec4 diffuseColor;\nvoid fragment() {\n"
                        + "\n".join(re.findall(r'>", [`"]([^`"]*;)[`"]\)', code)) + "\n}\n")
            inputs = "vec2 UV; vec3 ALBEDO, NORMAL_MAP; float ROUGHNESS, METALLIC;\n" if name == "Godot" else ""
            self.compile("#version 450\n" * (kind == "glsl") + drop_ins + inputs + code + "void main() {}\n",
                         *["-D", "-e", "main"] * (kind == "hlsl"))

    def compile(self, code, *options):
        with tempfile.TemporaryDirectory(prefix="gabor-") as folder:
            shader = pathlib.Path(folder) / "page.frag"
            shader.write_text(code)
            result = subprocess.run(["glslangValidator", "--quiet", "-V", *options, "-o", f"{folder}/out.spv", shader],
                                    capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout)

    def test_costs_match_the_performance_page(self):
        """Checks that the times and cycles in README's rows are those of the page's table."""
        page = (ROOT / "docs" / "performance.md").read_text()
        table = {name: (float(cpu), gpu, cycles) for name, cpu, gpu, cycles in
                 re.findall(r"(?m)^\| ([^|]+) \| ([\d.]+) \| [\d.]+ \| ([\d.]*) ?\| (\d*) ?\|", page)}
        rows = re.findall(r"(?m)^\| `?([^|`]+)`? \| ([\d.]+) ms \| (\d*)(?: cycles)? \|$", README)
        self.assertEqual(len(rows), 3)
        names = {"gabor_noise": "gabor_noise, lattice", "Gabor noise of 2009": "the seminal noise, 183 kernels"}
        for name, cpu, cycles in rows:
            found = table[names.get(name, name)]
            self.assertLessEqual(abs(found[0] - float(cpu)), 0.051 if found[0] < 100 else 0.51, name)
            self.assertEqual(found[2], cycles, name)
        gpu = float(re.search(r"`gabor_noise` takes ([\d.]+) us on", README)[1])
        self.assertLessEqual(abs(1920e-6 * 1080 * float(table["gabor_noise, lattice"][1]) - gpu), 0.051)


@unittest.skipUnless(shutil.which("node"), "node is not installed")
class Scripts(unittest.TestCase):
    """Checks what needs no browser: tools/test-engines demo and benchmark run the scripts in browsers. Embedded shaders are those
    that tools/translate --check wants."""

    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory(prefix="gabor-")))

    def assert_runs(self, *command):
        result = subprocess.run(list(map(str, command)), capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stdout[-2000:] + result.stderr[-2000:])
        return result.stdout

    def assert_parses(self, name, code):
        (self.folder / name).write_text(code)
        self.assert_runs("node", "--check", self.folder / name)

    def test_scripts_name_what_their_pages_have(self):
        for page in (DEMO, ROOT / "docs" / "benchmark.html"):
            text = page.read_text()
            script = re.search(r"(?s)<script>\n(.*?)</script>", text)[1]
            self.assert_parses("page.js", script)
            ids = re.findall(r' id="([\w.]+)"', text.replace(script, ""))
            self.assertEqual(len(ids), len(set(ids)))
            named = set(re.findall(r'(?:\$\("#|getElementById\("|embedded\("|\btext\(")([\w.]+)"', script))
            self.assertGreater(len(named), 5)
            self.assertEqual(named - set(ids), set())
        needed = re.findall(r'\w+', " ".join(re.findall(r'needs: \[(.*)\]', DEMO.read_text())))
        self.assertEqual({f"{name}.{ending}" for name in needed for ending in ("glsl", "wgsl")} - set(re.findall(r' id="([\w.]+)"', DEMO.read_text())), set())
        json.loads(re.search(r'(?s) id="materials.json">\n(.*?)</script>', DEMO.read_text())[1])

    def test_copied_code_compiles(self):
        before = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
        shadertoy = "uniform vec3 iResolution;\nuniform float iTime;\nout vec4 shown;\n"
        copies = json.loads(self.assert_runs("node", pathlib.Path(__file__).with_name("copied.mjs"), DEMO))
        shaders, modules = {}, {}
        for what, language, code in copies:
            if language == "Shadertoy":
                shaders[f"{before}{shadertoy}{code}\nvoid main() {{ mainImage(shown, gl_FragCoord.xy); }}\n"] = what
            elif language == "GLSL" and (what, "Shadertoy") not in [each[:2] for each in copies]:
                shaders[f"{before}{code}\nvoid main() {{}}\n"] = what
            elif language == "TSL":
                modules[code] = what
        self.assertGreater(min(len(shaders), 4 * len(modules)), 40)
        for shader, what in shaders.items():
            (self.folder / f"{what}.frag").write_text(shader)
        self.assert_runs("glslangValidator", *self.folder.glob("*.frag"))
        for code in modules:
            self.assert_parses("module.mjs", code)


if __name__ == "__main__":
    unittest.main()

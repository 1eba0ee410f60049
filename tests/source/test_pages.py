"""Checks README and docs: links have targets, code to paste compiles, scripts do what they say, and figures match their source page."""

import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [ROOT / name for name in subprocess.run(["git", "-C", str(ROOT), "ls-files", "*.md"], capture_output=True, text=True,
                                                check=True).stdout.splitlines()]
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

    def test_the_scripts_of_pages(self):
        if not shutil.which("node"):
            self.skipTest("node is not installed")
        result = subprocess.run(["node", pathlib.Path(__file__).with_name("page_scripts.mjs"), ROOT / "docs"], capture_output=True, text=True)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

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
        table = {name: (1920e-6 * 1080 * float(gpu), round(float(cpu)), cycles) for name, cpu, gpu, cycles in
                 re.findall(r"(?m)^\| ([^|]+) \| ([\d.]+) \| [\d.]+ \| ([\d.]+) \| [\d.]+ \| (\d*) ?\|", page)}
        rows = re.findall(r"(?m)^\| `?([^|`]+)`? \| (\d+) us \| (\d+) ms \| (\d*)(?: cycles)? \|$", README)
        self.assertEqual(len(rows), 3)
        names = {"gabor_noise": "gabor_noise, lattice", "Gabor noise of 2009": "the seminal noise, 270 kernels"}
        for name, gpu, cpu, cycles in rows:
            found = table[names.get(name, name)]
            self.assertEqual((round(found[0]), found[1:]), (int(gpu), (int(cpu), cycles)), name)


if __name__ == "__main__":
    unittest.main()

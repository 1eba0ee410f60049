"""Checks README and docs: links have targets, code to paste compiles, scripts do what they say, and figures match their source page."""

import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import copies  # noqa: E402
PAGES = [ROOT / name for name in subprocess.run(["git", "-C", str(ROOT), "ls-files", "*.md"], capture_output=True, text=True,
                                                check=True).stdout.splitlines()]
DEMO = ROOT / "docs" / "demo"
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
        self.assertLessEqual(len(README.split()), 1000)

    def test_the_index_has_all_functions(self):
        page, seen = (ROOT / "docs" / "functions.md").read_text(), 0
        for path in sorted((ROOT / "shaders").glob("gabor_*.glsl")):
            section = page.partition(f"## {path.name}\n")[2].partition("\n## ")[0]
            if path.stem == "gabor_float":  # a part of gabor_noise.glsl's
                continue
            text = path.read_text()
            for name in re.findall(r"(?m)^\w+ (gabor_(?!impl)\w+)\(", text):
                name = re.sub(r"(_filtered)?_(at|default|filtered)$", "", name) if path.stem == "gabor_materials" else name
                line = re.search(rf"\[`{name}`\]\(\.\./shaders/{path.name}#L(\d+)\)", section)
                self.assertTrue(line, f"docs/functions.md: {path.name} has {name}")
                self.assertTrue(text.splitlines()[int(line[1]) - 1].startswith("//"), f"docs/functions.md: {name}")
                seen += 1
        self.assertGreater(seen, 100)

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
        first, *examples = re.findall(r"(?ms)^```glsl\n(.*?)^```", README)
        self.assertEqual(len(examples), 4)
        for code, names in ((first.replace('#include "gabor_noise.glsl"', ""), ["fractal"]),
                            ("".join(examples).replace("GaborMaterial m", "GaborMaterial m1", 1), ["spectrum", "fractal", "materials", "erosion", "ocean"])):
            drop_ins = "".join((ROOT / f"shaders/gabor_{name}.glsl").read_text() for name in ("noise", *names))
            code = code.replace("m.slope", "m1.slope")
            self.compile(f"#version 450\n{drop_ins}layout(location = 0) in vec4 given;\nvoid main()\n{{\n"
                         f"vec2 p = given.xy, wave = given.zw;\nfloat time = given.x;\n{code}}}\n")

    def test_the_clouds_for_three_js_compile(self):
        code = re.search(r"(?s)gabor_noise_glsl \+ gabor_fractal_glsl \+ `(.*?)`,\n", (ROOT / "docs" / "engines.md").read_text())[1]
        for given, located in (("in vec2", "layout(location = 0) in vec2"), ("uniform float", "layout(location = 1) in float"),
                               ("out vec4", "layout(location = 0) out vec4")):
            self.assertEqual(code.count(given), 1)
            code = code.replace(given, located)
        self.compile("#version 450\n" + "".join((ROOT / f"shaders/gabor_{name}.glsl").read_text() for name in ("noise", "fractal")) + code)

    def test_the_files_to_paste_have_their_order(self):
        rows = re.findall(r"(?m)^\|[^|]*\| \[`gabor_(\w+)\.glsl`\].*\| (.*?) ?\|$", README)
        self.assertEqual({f"gabor_{name}" for name, _ in rows}, {path.stem for path in (ROOT / "shaders").glob("gabor_*.glsl")})
        for name, after in rows:
            always, _, sometimes = after.partition(";")
            after = [copies.ROOT / f"shaders/gabor_{other}.glsl" for other in re.findall(r"\w+", always) if other != "nothing"]
            path = ROOT / f"shaders/gabor_{name}.glsl"
            given = {each.stem for other in after for each in [*copies.required(other), other]}
            self.assertEqual(given, {each.stem for each in copies.required(path)}, name)
            more = {f"gabor_{other}" for other in re.findall(r"\w+", sometimes.partition(":")[2])}
            more |= {each.stem for other in after for each in [*copies.needed(other), other]}
            self.assertEqual(more, {each.stem for each in copies.needed(path)}, name)

    def test_the_number_of_engines_is_that_of_the_table(self):
        table = (ROOT / "docs" / "engine-results.md").read_text().partition("## The noise")[2].partition("\n## ")[0]
        rows = len(re.findall(r"(?m)^\| ", table)) - 2
        self.assertIn(f"; {rows} combinations of engine and language tested", README)

    def test_recipes_for_materials_compile(self):
        page = (ROOT / "docs" / "materials.md").read_text()
        recipes = dict(re.findall(r"(?ms)^\*\*(\w+).*?^```\w+\n(.*?)^```", page))
        self.assertEqual(list(recipes), ["GLSL", "three", "Godot", "Unity"])
        for name, code in recipes.items():
            self.assertLessEqual(code.count("\n"), 10, name)
            kind, folder = ("hlsl", "translations/") if name == "Unity" else ("glsl", "")
            drop_ins = "".join((ROOT / f"shaders/{folder}gabor_{each}.{kind}").read_text()
                               for each in ("noise", "spectrum", "fractal", "materials"))
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


PERFORMANCE = (ROOT / "docs" / "performance.md").read_text()
FIGURE = r"(?:\d[\d,]*(?:\.\d+)?|(?:twice|half|two|three|four|five|six|seven|eight|nine|ten|three quarters|a (?:third|quarter|fifth))\b)"
FIGURES = rf"{FIGURE}(?:(?:,| to|,? and|,? or) {FIGURE})*"
# What looks like a figure of cost: a ratio, a unit of time or cycles, and what follows "cost".
COST = [rf"{FIGURES} times (?:as (?:much|fast|long)|the (?:cost|time|CPU|\d)|that of `?gabor|faster|slower)",
        rf"{FIGURES} (?:cycles(?! per)|[pnu]s|Perlin noises|million values)\b", rf"{FIGURES} (?:as|more) (?:much|long) ",
        rf"\bcosts?(?: on [A-Z]\w+,| as much as| relative to \w+,| is| about| at most| less than)* {FIGURES}"]
WORDS = {"twice": 2, "half": 0.5, "a fifth": 0.2, "two": 2, "five": 5, "seven": 7}


def number(text):
    return WORDS[text] if text in WORDS else float(text.replace(",", ""))


def figures(patterns):
    """Returns a pattern with a group for each (N), in which any white space is a space."""
    return re.compile("|".join(patterns).replace("(N)", f"({FIGURE})").replace(" ", r"\s+"), re.DOTALL)


def sources():
    """Returns what an expression may name: columns of the first table of performance.md, the table of the filter, and `said`, the
    number of a pattern in a page."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in PERFORMANCE.splitlines() if line.startswith("| ")]
    rows = {row[0]: row[1:] for row in reversed(rows)}  # the first table wins
    short = {"": "gabor_noise, lattice", "perlin": "Perlin noise", "advice": "the paper's advice, 18 kernels",
             "seminal": "the seminal noise, 183 kernels", "seminal 30": "the seminal noise, 270 kernels", "splats": "erosion with 16 random splats, 5 octaves",
             "eroded": "gabor_eroded, 5 octaves, 3 taps", "isotropic": "gabor_noise_isotropic", "3d": "gabor_noise_3d",
             "all": "0.66 or more along all axes", "one": "0.66 or more along one axis"}

    def column(index):
        return lambda name: float(rows[short.get(name, name)][index])
    return {"ms": column(0), "ps": column(2), "cycles": column(3), "filter": column(1), "filter_cycles": column(0),
            "filter_3d": column(3), "filter_3d_cycles": column(2),
            "said": lambda page, pattern: number(figures([pattern]).search((ROOT / page).read_text())[1])}


# Figures of cost outside the tables: (page, pattern whose groups are numbers, what these are by their source, tolerance). A row
# without an expression is itself the source, and no other page may state the figure.
P, GLSL = "docs/performance.md", "shaders/gabor_"
COSTS = [
    ("README.md", "(N) to (N) times the cost of Perlin noise, and (N) to (N) times as fast", "ms('') / ms('perlin'), "
     "cycles('') / cycles('perlin'), said(P, '7100 for 183, without loops and random counts: (N) times'), ms('seminal') / ms('')", 0.08),
    ("README.md", r"\| `gabor_noise` \| (N) ms \| (N) cycles", "ms(''), cycles('')", 0.005),
    ("README.md", r"\| Perlin noise \| (N) ms \| (N) cycles", "ms('perlin'), cycles('perlin')", 0.005),
    ("README.md", r"\| Gabor noise of 2009 \| (N) ms", "ms('seminal')", 0.005),
    ("README.md", r"`gabor_noise` takes (N) us on", "ps('') * 2.0736", 0.005),
    ("README.md", r"ns per value: Perlin (N), the 2019 paper's advice (N), 72 kernels \(Blender\) (N), `gabor_noise` (N)\.",
     "*(ms(name) / 2.0736 for name in ('perlin', 'advice', 'Gabor noise of 72 kernels', ''))", 0.03),
    ("docs/lattice.md", "Navi 21, 3 taps cost (N) times as much as Perlin noise, and are (N) times as fast as the noise that the paper "
     "recommends and (N) times as fast", "cycles('') / cycles('perlin'), cycles('advice') / cycles(''), 7100 / cycles('')", 0.04),
    ("docs/lattice.md", "lavapipe they cost (N) times as much as Perlin noise, and are (N) and (N) times as fast",
     "ms('') / ms('perlin'), ms('advice') / ms(''), ms('seminal') / ms('')", 0.03),
    (P, "costs as much as (N) Perlin noises on lavapipe and (N) by RADV's cycles, or (N) and (N) simplex noises. It is (N) and (N) times as "
     r"fast as the paper's advice \(.*?\). On lavapipe, it is (N) times as fast as the seminal noise of 2009 with .*? and (N) times with",
     "ms('') / ms('perlin'), cycles('') / cycles('perlin'), ms('') / ms('simplex noise'), cycles('') / cycles('simplex noise'), "
     "ms('advice') / ms(''), cycles('advice') / cycles(''), ms('seminal') / ms(''), ms('seminal 30') / ms('')", 0.03),
    (P, "RADV estimates (N) cycles for an impulse of the seminal noise, so (N) for 183, without loops and random counts: (N) times `gabor_noise`",
     "7100 / 183, 183 * 37.5, 7100 / cycles('')", 0.05),
    (P, "`gabor_noise` takes (N) cycles there, `gabor_noise_3d` (N)",
     "filter_cycles('up to 0.18') / filter('up to 0.18'), filter_3d_cycles('up to 0.18') / filter_3d('up to 0.18')", 0.03),
    (P, r"cost 11,746 cycles, 13,186 filtered and 9974 for the height alone: (N), (N) and (N) times the (N) of",
     "11746 / cycles(''), 13186 / cycles(''), 9974 / cycles(''), cycles('')", 0.02),
    (P, "`gabor_foam` adds (N) % to its water", "100 * ms('gabor_water_filtered and gabor_foam') / ms('gabor_water_filtered') - 100", 0.03),
    (P, "On lavapipe `gabor_water` takes (N), (N) and (N) times as long",
     "ms('gabor_water') / ms(''), ms('gabor_water_filtered') / ms(''), ms('gabor_water, height alone') / ms('')", 0.03),
    (P, "takes 5320 cycles. The height alone takes 3310, which is (N) % of the cycles", "331000 / cycles('splats')", 0.02),
    (P, "erosion with two taps (N) less; on lavapipe `gabor_eroded` costs (N)",
     "1 - ps('gabor_eroded, 5 octaves, 2 taps') / ps('eroded'), ms('eroded') / ms('splats')", 0.15),
    (GLSL + "noise.glsl", "about (N) as much as gabor_noise", "cycles('gabor_noise_animated') / cycles('')", 0.1),
    (GLSL + "spectrum.glsl", "(N) to (N) times that of gabor_noise", "ps('isotropic') / ps(''), ms('isotropic') / ms('')", 0.1),
    (GLSL + "noise_3d.glsl", "about (N) times that of gabor_noise_3d[.]", "ms('gabor_noise_3d_isotropic') / ms('3d')", 0.1),
    (GLSL + "noise_3d.glsl", "about (N) times that of gabor_noise_3d,", "ms('gabor_field_surface_isotropic') / ms('3d')", 0.1),
    (GLSL + "erosion.glsl", "costs (N) gabor_noise_gradient", "ps('eroded') / 5 / ps('gabor_noise_gradient')", 0.1),
    (GLSL + "filter.glsl", "gabor_noise, is (N) for pixels up to 0.18 kernel radii .9 nodes., (N) from 0.2 .16 nodes., (N) from 0.66 "
     "along x or y .20 nodes., and (N) from 0.66 along both", "*map(filter, ('up to 0.18', '0.2 or more', 'one', 'all'))", 0.01),
    (GLSL + "filter.glsl", "the cost is (N) for small pixels and (N) for larger ones", f"said('{P}', 'takes (N) times as long as "
     f"`gabor_noise` for small pixels'), said('{P}', 'for small pixels and (N) times')", 0.1),
    (GLSL + "filter_3d.glsl", "a call costs (N) times as much as gabor_noise_3d for pixels up to 0.18 kernel radii .27 nodes., (N) times "
     "from 0.2 .64 nodes., and at most (N) times", "*map(filter_3d, ('up to 0.18', '0.2 or more', 'all'))", 0.01),
    ("docs/python.md", "draws (N) million values a second, which are (N) million octaves",
     f"said('{P}', 'Python, `fbm` . (N)') / 5, said('{P}', 'Python, `fbm` . (N)')", 0.05),
    ("shaders/nodes/cpp/README.md", "// (N) to (N) us; after", f"6 * said('{P}', 'takes (N) us for a point'), "
     f"6 * said('{P}', '; (N) us without `-march=native`')", 0.1),
    ("docs/study.md", "(N) times faster than the seminal noise with N = 2, and (N) times with N = 4", "said('docs/study.md', "
     r"'(N) times \\(N = 2\\)'), said('docs/study.md', '(N) times at N = 4')", 0),
    ("shaders/performance-notes.md", "takes (N) cycles with 25 nodes, (N) times `gabor_noise`", "filter_cycles('all'), filter('all')", 0.01),
    ("shaders/performance-notes.md", "of (N) cycles compared with random signs", "cycles('gabor_noise, paper')", 0),
    ("shaders/performance-notes.md", "Its GLSL takes (N) ns", "said('docs/by-example.md', 'takes (N) ns')", 0),
    *((page, pattern, "", 0) for page, pattern in (
        (P, "The H100 has only timed slower code of these noises: .*? 30 times as fast as that seminal noise"), (P, "takes 10 ps per value on"), (P, "materials take 25 to 350 ps"), (P, "costs 5 % more than `tests/bench"),
        (P, "3.1 times as long as `gabor_noise` for small"), (P, "costs three octaves"), (P, "0.9 us for a point"), (P, "2.1 us without"),
        (P, "Crest needs 28 us"), (P, "takes 3.9 times as long as plain"), (P, "up to eight times as long"), ("docs/by-example.md", "75 ns .*? 8368 cycles"),
        ("docs/engines.md", "14 kB, 7 us a height"), ("docs/engines.md", "1382 cycles a pixel"), ("shaders/nodes/shims/README.md", "1.3 to 1.7 times as long"), ("docs/farm.md", "1.4 to 1.75 times the CPU time"), ("docs/gallery.md", "costs ten noises, one"),
        ("docs/python.md", "draws 570 .*? 1.2 us"), ("docs/study.md", "17 times faster at the same quality"), ("docs/study.md", "20.7 times faster"),
        ("shaders/nodes/cpp/README.md", "on one core, GCC 12 reaches 33 .*? at 4[.]"), (GLSL + "compose.glsl", "cost three quarters of gabor_noise"),
        (GLSL + "direction.glsl", "1.5 to 1.7 times as much as gabor_noise, including"), (GLSL + "filter_3d.glsl", "less than twice as much as without"))),
]


class Costs(unittest.TestCase):
    """Figures of cost in prose are those of the tables in docs/performance.md, or have no other source than their page."""

    def setUp(self):
        """Reads the pages and the manuals of drop-ins, with each space as wide as the marks of comments that it replaces."""
        manuals = {f"shaders/{path.name}": path.read_text().split("// Private implementation")[0] for path in
                   sorted((ROOT / "shaders").glob("gabor_*.glsl"))}
        pages = {str(page.relative_to(ROOT)): page.read_text() for page in PAGES}
        self.texts = {name: re.sub(r"(?m)^//", "  ", text) for name, text in (pages | manuals).items()}

    def test_figures_are_those_of_the_tables(self):
        for page, pattern, values, tolerance in COSTS:
            found = figures([pattern]).findall(self.texts[page])
            self.assertEqual(len(found), 1, f"{page}: {pattern}")
            stated = [number(text) for text in (found[0] if isinstance(found[0], tuple) else found)] if values else []
            for text, value in zip(stated, eval(f"[{values}]", sources() | {"P": P}), strict=True):
                self.assertLessEqual(abs(text / value - 1), tolerance, f"{page}: {text} is {value:.4g} by its source: {pattern}")

    def test_ratios_in_the_table_are_those_of_its_rows(self):
        ms = sources()["ms"]
        rows = re.findall(r"(?m)^\| ([^|]+) \| [\d.]+ \| ([\d.]+) \|", PERFORMANCE.split("<!-- end -->")[0])
        self.assertGreater(len(rows), 30)
        for name, ratio in rows:
            self.assertLess(abs(float(ratio) / (ms(name) / ms("perlin")) - 1), 0.04, name)

    def test_every_figure_has_a_source(self):
        unknown, seen = [], 0
        for page, text in self.texts.items():
            if page in ("CHANGELOG.md", "shaders/performance-notes.md", "docs/functions.md"):  # of other versions and code; made from manuals
                continue
            known = {i for row in COSTS if row[0] == page for match in figures([row[1]]).finditer(text) for i in range(*match.span())}
            for match in figures(COST).finditer(text):
                seen += 1
                if not known.intersection(range(*match.span())):
                    unknown.append(f"{page}:{text.count(chr(10), 0, match.start()) + 1}: {' '.join(match[0].split())}")
        print(f"  {seen} figures of cost")
        self.assertGreater(seen, 40)
        self.assertEqual(unknown, [], "\n".join(unknown))


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

    def evaluated(self, *expression):
        """Returns the value of an expression of the live page, or else all that it copies."""
        return json.loads(self.assert_runs("node", pathlib.Path(__file__).with_name("copied.mjs"), DEMO, *expression))

    def assert_parses(self, name, code):
        (self.folder / name).write_text(code)
        self.assert_runs("node", "--check", self.folder / name)

    def test_scripts_name_what_their_pages_have(self):
        benchmark = (ROOT / "docs" / "benchmark.html").read_text()
        script = re.search(r"(?s)<script>\n(.*?)</script>", benchmark)[1]
        for page, script in ((benchmark.replace(script, ""), script), ((DEMO / "index.html").read_text(), (DEMO / "page.js").read_text())):
            self.assert_parses("page.js", script)
            ids = re.findall(r' id="([\w.]+)"', page)
            self.assertEqual(len(ids), len(set(ids)))
            named = set(re.findall(r'(?:\$\("#|getElementById\("|\btext\(")([\w.]+)"', script))
            self.assertGreater(len(named), 5)
            self.assertEqual(named - set(ids), set())
        texts = self.evaluated(";JSON.stringify(TEXTS)")
        json.loads(texts["presets.json"])
        needed = re.findall(r'\w+', " ".join(re.findall(r'needs: \[(.*)\]', script)))
        self.assertGreater(len(needed), 5)
        self.assertEqual({f"{name}.{ending}" for name in needed for ending in ("glsl", "wgsl", "hlsl")} - set(texts), set())
        named = re.findall(r'TEXTS\["(.*?)"\]', script)
        self.assertGreater(len(named), 1)
        self.assertEqual(set(named) - set(texts), set())

    def test_a_dragged_lobe_has_the_frequency_and_the_angle_of_its_place(self):
        places = [(3, 1), (-2, 2), (0.5, 4), (-5, 0.25)]
        dragged = self.evaluated(f""";(() => {{
            showTab(Object.keys(TABS).find(name => TABS[name].lobes));
            values().kind = "lobes";
            values().count = 3;
            state.language = "GLSL";
            return JSON.stringify({[list(place) for place in places]}.map((at, i) => {{
                dragged = i % 3;
                dragLobe(at);
                return [...lobesInPlane()[i % 3].slice(0, 2), copied()];
            }}));
        }})()""")
        for i, ((x, y), (shown_x, shown_y, code)) in enumerate(zip(places, dragged, strict=True)):
            frequency, angle = map(float, re.search(rf"lobe\[{i % 3}\] = gabor_lobe\((\S+), (\S+), ", code).groups())
            for value, of in ((shown_x, x), (shown_y, y), (frequency * math.cos(angle), x), (frequency * math.sin(angle), y)):
                self.assertAlmostEqual(value, of, delta=0.06, msg=f"{x}, {y}")

    def test_a_tab_opens_with_its_own_view(self):
        views = self.evaluated(""";(() =>
            JSON.stringify(Object.keys(TABS).map(name => {
                Object.assign(state, { x: 9, y: 8, zoom: 7, yaw: 6, pitch: 0.5, distance: 2 });
                showTab(name);
                return [Object.keys(START).map(each => state[each]), Object.keys(START).map(each => start()[each])];
            })))()""")
        for found, expected in views:
            self.assertEqual(found, expected)

    def test_an_address_opens_the_view_that_wrote_it(self):
        views = self.evaluated(""";(() => {
            setTimeout = run => run();
            history = { replaceState: (_, __, address) => location.hash = address };
            return JSON.stringify(Object.keys(TABS).map(name => {
                showTab(name);
                const seen = Object.assign(state, { x: -1234.567, y: 7.006543, zoom: 12.34567, yaw: 2.001234, pitch: 0.7654321, distance: 1.234567 });
                const before = { ...seen };
                writeAddress();
                Object.assign(state, START, { tab: Object.keys(TABS).find(other => other !== name) });
                readAddress();
                return [name, ...Object.keys(START)].map(each => each === name ? [name, state.tab] : [before[each], state[each]]);
            }));
        })()""")
        self.assertGreater(len(views), 3)
        for (name, tab), *numbers in views:
            self.assertEqual(tab, name)
            for before, after in numbers:
                self.assertAlmostEqual(after, before, delta=1e-6 * abs(before), msg=name)

    def test_copied_materials_have_the_members_of_their_preset(self):
        copies = self.evaluated(""";(() => {
            showTab("materials");
            return JSON.stringify(Object.entries(DATA.presets).map(([name, preset]) => {
                values().preset = name;
                usePreset();
                const own = TABS.materials.controls.filter(each => each.name in preset && each.name.startsWith(preset.material + "."));
                return [name, own.map(each => [each.name, preset[each.name], each.value]), copied()];
            }));
        })()""")
        seen = 0
        for preset, members, code in copies:
            for name, value, usual in members:
                if value != usual:
                    seen += 1
                    self.assertIn(f"{name.replace('-', '_')} = ", code, preset)
        self.assertGreater(seen, 100)

    def test_stripes_follow_the_edges_of_a_dropped_picture(self):
        angles = [10, 60, 120, 170]  # of the waves of the picture, from x towards y, which points down
        found = self.evaluated(f""";(async () => {{
            const side = PAINTED_SIDE, found = [];
            let pixels, painted;
            createImageBitmap = () => ({{ width: side, height: side }});
            document.createElement = () => ({{ getContext: () => ({{ fillRect() {{}}, drawImage() {{}}, getImageData: () => ({{ data: pixels }}) }}) }});
            setDirection = (i, direction) => painted[i] = direction;
            showTab = () => {{}};
            for (const angle of {angles}) {{
                painted = [];
                pixels = [...Array(4 * side * side).keys()].map(k => {{
                    const i = k >> 2, along = (i % side) * Math.cos(radians(angle)) + Math.floor(i / side) * Math.sin(radians(angle));
                    return 128 + 100 * Math.sin(0.5 * along);
                }});
                await paintPicture();
                const [x, y] = painted[side * side / 2 + side / 2];
                found.push(Math.atan2(y, x) * 90 / Math.PI);
            }}
            return JSON.stringify(found);
        }})()""")
        for angle, at in zip(angles, found, strict=True):
            self.assertAlmostEqual((at - angle + 90) % 180, 90, delta=2)

    def test_copied_code_compiles(self):
        before = "#version 300 es\nprecision highp float;\nprecision highp int;\n"
        shadertoy = "uniform vec3 iResolution;\nuniform float iTime;\nout vec4 shown;\n"
        copies = self.evaluated()
        shaders, hlsl, modules = {}, {}, {}
        for what, language, code in copies:
            if language == "Shadertoy":
                shaders[f"{before}{shadertoy}{code}\nvoid main() {{ mainImage(shown, gl_FragCoord.xy); }}\n"] = f"{what}, Shadertoy.frag"
            elif language == "GLSL":
                shaders[before + code] = f"{what}.frag"
            elif language == "HLSL":
                # HLSL takes longest, so copies that differ only in numbers or in the members that they set are compiled once:
                # the GLSL copies set the same members.
                hlsl.setdefault(re.sub(r"\n *[\w.]+ = [^\n]*;|\d[\d.e+-]*u?", "", code), (f"{what}.hlsl", code))
            elif language == "TSL":
                modules[code] = what
        self.assertGreater(min(len(shaders), 2 * len(hlsl), 4 * len(modules)), 40)
        for shader, what in [*shaders.items(), *((code, what) for what, code in hlsl.values())]:
            (self.folder / what).write_text(shader)
        self.assert_runs("glslangValidator", *self.folder.glob("*.frag"))
        for path in self.folder.glob("*.hlsl"):
            self.assert_runs("glslangValidator", "-D", "-V", "-S", "frag", "-e", "main", "-o", "/dev/null", path)
        for code in modules:
            self.assert_parses("module.mjs", code)


if __name__ == "__main__":
    unittest.main()

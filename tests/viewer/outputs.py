"""Compares copied code and exported files with the window, for every output."""

import json

import numpy as np

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from exr import Exr
from png import read_colour_png
from viewer import SHADERS

WIDTH, HEIGHT = 480, 320
OUTPUTS = ("value", "gradient", "phase", "intensity", "variance", "stripes", "lit", "lit stripes")
VALUE, GRADIENT, PHASE, INTENSITY, VARIANCE, STRIPES, LIT, LIT_STRIPES = range(8)
# What an output shows of the copied code's Noise, n.
PARTS = {VALUE: "vec4(n.complex.y)", GRADIENT: "vec4(n.slope, 0.0)", VARIANCE: "vec4(n.removed)", LIT: "vec4(n.slope, n.complex.y)",
         **{output: "vec4(n.complex, 0.0, 0.0)" for output in (PHASE, INTENSITY, STRIPES, LIT_STRIPES)}}
COLOURS = ("grey", "viridis", "cool to warm", "ember", "sea", "own")
RAMP = [[0.1, "#203060"], [0.4, "#a04020"], [0.45, "#ffffff"], [1, "#c0ff40"]]
LOBES = [{"frequency": 3, "orientation": 20, "radius": 1.5}, {"frequency": 5, "orientation": 100, "power": 0.5}]
TERRAIN = {"view": "terrain", "width": WIDTH, "height": HEIGHT, "scale": 40, "octaves": 2, "strength": 0.15, "seed": 3}
LANDSCAPE = {**TERRAIN, "view": "landscape", "pitch": 30, "yaw": 20}
# A noise of two lobes, coloured by two components.
COLOURED = {
    "lobes": [{"frequency": 2, "orientation": 20, "radius": 1.5}, {"frequency": 3, "orientation": 100}],
    "colour": {"weights": [[[0.6, 0.6], [0, 0.5], [0, 0]], [[0, 0.52915], [0.5, -0.7], [0, 0]]],
               "histogram": [[-0.2, 0.9, 0.2, 0.03, 0, 0], [0, 1, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0]],
               "mean": [0.5, 0.45, 0.4], "mixing": [[0.15, 0.05, 0], [0.1, -0.05, 0], [0.02, 0.12, 0]]}}


class OutputsTest(EventsTest):
    """Tests cases, each with parameters, an output, a colour map and a contrast."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        import moderngl
        cls.context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")

    def take(self, cases):
        """Copies, shows and exports each case in one viewer whose view has the picture's size."""
        script = []
        for number, (parameters, output, colours, contrast) in enumerate(cases.values()):
            shown = {"output": OUTPUTS[output], "colours": COLOURS[colours], "contrast": contrast, "ramp": RAMP}
            self.preset(f"{number}.json", **{"width": WIDTH, "height": HEIGHT, "scale": 24, **parameters,
                                             "viewer": {**shown, **parameters.get("viewer", {})}})
            script += [f"open {number}.json", "keys ctrl+c", f"copy {number}.glsl", f"screenshot {number}.png",
                       f"export {number}-out.exr", "exported"]
        self.play("\n".join(script), "0.json", "--window", f"{WIDTH}x{HEIGHT}", timeout=900)

    def check(self, cases, tolerances):
        self.take(cases)
        for number, (name, (parameters, output, _, _)) in enumerate(cases.items()):
            with self.subTest(name):
                seen = read_colour_png(self.folder / f"{number}.png") / 255
                exported = Exr(self.folder / f"{number}-out.exr")
                expected = quantity(exported.channels, output)
                covered = exported.channels.get("A", np.ones((HEIGHT, WIDTH))) == 1
                self.assertGreater(covered.mean(), 0.2)
                self.assertGreater(seen[covered].std(), 0.05)
                snippet = (self.folder / f"{number}.glsl").read_text()
                found, colours = self.draw(parameters, snippet, output)
                off = np.abs(found - expected)[covered]
                print(f"{name}: off by {off.max():.2g}, colours by {np.abs(colours - seen)[covered].max():.2g}")
                quantile, largest = tolerances.get(name, (2e-3, 1e-2))
                self.assertLess(np.quantile(off, 0.999), quantile * max(1, expected.std()))
                self.assertLess(off.max(), largest * max(1, expected.std()))
                shift = np.abs(colours - seen)[covered]
                if output in (PHASE, STRIPES, LIT_STRIPES): # phases wrap around, and are arbitrary where the intensity is 0
                    shift = shift[np.hypot(expected[..., 0], expected[..., 1])[covered] > 0.1]
                self.assertLess(np.quantile(shift, 0.99), quantile + 1 / 255)
                # The file shows the same as the window, except at the outline of a body.
                taken = read_colour_png(self.folder / f"{number}-out.png") / 255
                differing = np.abs(taken - seen).max(axis=2)
                self.assertLess((differing[covered] > 1.5 / 255).mean(), 1e-3)

    def draw(self, parameters, snippet, output):
        """Returns the output's value and colours, as the copied code computes them."""
        raise NotImplementedError

    def draw_colours(self, snippet, call, **textures):
        """Returns the output's value and colours for a coloured noise, whose value is the colour itself."""
        colours = self.run_code(snippet, f"colour = {call}; pixels = vec4(colour, 0.0);", **textures)[1]
        return colours, np.clip(colours, 0, 1)

    def run_code(self, snippet, main, **textures):
        """Runs copied code. `main` is GLSL that sets `pixels` and `colour` for the pixel at `at`."""
        for include in [line for line in snippet.splitlines() if line.startswith("#include")]:
            snippet = snippet.replace(include, (SHADERS / include.split('"')[1]).read_text())
        uniforms = "".join(f"uniform sampler2D {name};\n" for name in textures)
        fragment = ("#version 330 core\n" + uniforms + snippet
                    + "layout(location = 0) out vec4 pixels;\nlayout(location = 1) out vec3 colour;\n"
                    + "void main() { vec2 at = gl_FragCoord.xy;\n" + main + " }\n")
        vertex = "#version 330 core\nin vec2 corner;\nvoid main() { gl_Position = vec4(corner, 0.0, 1.0); }\n"
        program = self.context.program(vertex_shader=vertex, fragment_shader=fragment)
        for unit, (name, texels) in enumerate(textures.items()):
            if name in program: # otherwise it was optimized away
                texture = self.context.texture((WIDTH, HEIGHT), 3, texels.astype("f4").tobytes(), dtype="f4")
                texture.use(unit)
                program[name] = unit
        corners = self.context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
        target = self.context.framebuffer([self.context.texture((WIDTH, HEIGHT), size, dtype="f4") for size in (4, 3)])
        target.use()
        self.context.vertex_array(program, corners, "corner").render(vertices=3)
        return [np.frombuffer(target.read(components=size, dtype="f4", attachment=i), "f4").reshape(HEIGHT, WIDTH, size)
                for i, size in enumerate((4, 3))]


def quantity(channels, output):
    if "R" in channels:
        return np.stack([channels[name] for name in "RGB"], axis=-1)
    if output == GRADIENT:
        return np.stack([channels["gradient.x"], channels["gradient.y"]], axis=-1)
    if output == LIT:
        return np.stack([channels["gradient.x"], channels["gradient.y"], channels["Y"]], axis=-1)
    if output in (PHASE, INTENSITY, STRIPES, LIT_STRIPES):
        return np.stack([channels["quadrature"], channels["Y"]], axis=-1)
    return channels["removed" if output == VARIANCE else "Y"]

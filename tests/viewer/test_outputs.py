"""What is taken home is what is seen: the code that is copied and the files that are exported, of each output."""

import json
import math
import unittest

import numpy as np

from viewer import SHADERS, ViewerTest  # noqa: I001 (it finds the next two)
from exr import Exr
from png import read_colour_png

WIDTH, HEIGHT = 480, 320
VALUE, GRADIENT, PHASE, INTENSITY, VARIANCE = range(5)
NAMES = {VALUE: "noise", GRADIENT: "gradient", PHASE: "complex", INTENSITY: "complex", VARIANCE: "removed"}
LOBES = [{"frequency": 3, "orientation": 20, "radius": 1.5}, {"frequency": 5, "orientation": 100, "power": 0.5}]

# Parameters, the output, the colour map and the contrast.
PLANES = {
    "value": ({}, VALUE, 1, 3),
    "gradient of lobes": ({"lobes": LOBES, "seed": 5}, GRADIENT, 0, 1.5),
    "phase": ({"recipe": "one", "orientation": 40}, PHASE, 1, 2),
    "grey phase": ({"time": 0.3}, PHASE, 0, 2),
    "intensity": ({"recipe": "lattice-2", "tileable": True}, INTENSITY, 3, 2),
    "filtered intensity": ({"frequency": 7, "filter": True}, INTENSITY, 4, 1),
    "variance on a horizon": ({"frequency": 2, "orientation": 60, "filter": True, "view": "horizon"}, VARIANCE, 1, 2),
}
BODIES = {
    "sphere": ({"view": "sphere", "filter": False, "orientation": 30, "frequency": 2, "yaw": 20}, GRADIENT, 0, 2),
    "torus": ({"view": "torus", "filter": False, "solid": True, "frequency": 1.5, "pitch": 60}, PHASE, 1, 2),
    "slice": ({"view": "slice", "depth": 0.3, "orientation": 50, "lobes": LOBES}, INTENSITY, 0, 2),
}


class Outputs(ViewerTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        import moderngl
        cls.context = moderngl.create_context(standalone=True, backend="egl", libgl="libGL.so.1", libegl="libEGL.so.1")

    def take(self, cases):
        """Copies, shows and exports each case in one viewer whose view has the picture's size."""
        script = ["key h"]
        for number, (parameters, output, colours, contrast) in enumerate(cases.values()):
            (self.folder / f"{number}.json").write_text(
                json.dumps({"width": WIDTH, "height": HEIGHT, "scale": 24, **parameters}))
            script += [f"open {number}.json", f"set output {output}", f"set colours {colours}",
                       f"set contrast {contrast}", "wait 2", "key ctrl+c", f"copy {number}.glsl",
                       f"screenshot {number}.png", f"export {number}-out.exr", "exported"]
        self.play("\n".join(script + ["quit"]), "--window", f"{WIDTH}x{HEIGHT}", timeout=900)

    def check(self, cases, tolerances, draw):
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
                found, colours = draw(parameters, snippet, output)
                off = np.abs(found - expected)[covered]
                print(f"{name}: off by {off.max():.2g}, colours by {np.abs(colours - seen)[covered].max():.2g}")
                quantile, largest = tolerances.get(name, (2e-3, 1e-2))
                self.assertLess(np.quantile(off, 0.999), quantile * max(1, expected.std()))
                self.assertLess(off.max(), largest * max(1, expected.std()))
                shift = np.abs(colours - seen)[covered]
                if output == PHASE: # which ends where it begins, and is anything where the intensity is none
                    shift = shift[np.hypot(expected[..., 0], expected[..., 1])[covered] > 0.1]
                self.assertLess(np.quantile(shift, 0.99), quantile + 1 / 255)
                # The file shows the same as the window, but for the outline of a body.
                taken = read_colour_png(self.folder / f"{number}-out.png") / 255
                differing = np.abs(taken - seen).max(axis=2)
                self.assertLess((differing[covered] > 1.5 / 255).mean(), 1e-3)

    def test_planes(self):
        def draw(_, snippet, output):
            main = f"pixels = vec4({NAMES[output]}_of_view(at), 0.0, 0.0); colour = colour_of_view(at);"
            return self.draw(snippet, output, main)
        self.check(PLANES, {"variance on a horizon": (2e-3, 0.05)}, draw)

    def test_bodies(self):
        def draw(parameters, snippet, output):
            main = (f"vec3 p = texelFetch(places, ivec2(at), 0).xyz, n = texelFetch(normals, ivec2(at), 0).xyz;"
                    f"pixels = vec4({NAMES[output]}_of_body(p, n), 0.0, 0.0); colour = colour_of_body(p, n);")
            return self.draw(snippet, output, main, *places(parameters), parameters)
        # Rays that graze a torus meet it elsewhere for the smallest difference.
        self.check(BODIES, {"torus": (1e-2, 2)}, draw)

    def draw(self, snippet, output, main, points=None, normals=None, parameters=None):
        for include in [line for line in snippet.splitlines() if line.startswith("#include")]:
            snippet = snippet.replace(include, (SHADERS / include.split('"')[1]).read_text())
        space = points is not None
        wide = "0.0, 0.0" if output in (VALUE, VARIANCE) else "0.0"
        main = main.replace("), 0.0, 0.0)", f"), {wide}, 0.0)" if not (space and output == GRADIENT) else "), 0.0)")
        fragment = ("#version 330 core\nuniform sampler2D places, normals;\n" + snippet
                    + "layout(location = 0) out vec4 pixels;\nlayout(location = 1) out vec3 colour;\n"
                    + "void main() { vec2 at = gl_FragCoord.xy;\n" + main + " }\n")
        vertex = "#version 330 core\nin vec2 corner;\nvoid main() { gl_Position = vec4(corner, 0.0, 1.0); }\n"
        program = self.context.program(vertex_shader=vertex, fragment_shader=fragment)
        for unit, (name, texels) in enumerate((("places", points), ("normals", normals))):
            if texels is not None and name in program:
                texture = self.context.texture((WIDTH, HEIGHT), 3, texels.astype("f4").tobytes(), dtype="f4")
                texture.use(unit)
                program[name] = unit
        corners = self.context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
        target = self.context.framebuffer([self.context.texture((WIDTH, HEIGHT), size, dtype="f4") for size in (4, 3)])
        target.use()
        self.context.vertex_array(program, corners, "corner").render(vertices=3)
        value, colour = (np.frombuffer(target.read(components=size, dtype="f4", attachment=i), "f4")
                         .reshape(HEIGHT, WIDTH, size) for i, size in enumerate((4, 3)))
        if space and output == GRADIENT: # in the picture's plane
            right, up = axes(parameters)[:2]
            value = np.stack([value[..., :3] @ right, -value[..., :3] @ up], axis=-1)
        return value[..., 0] if output in (VALUE, VARIANCE) else value[..., :2], colour


def quantity(channels, output):
    if output == GRADIENT:
        return np.stack([channels["gradient.x"], channels["gradient.y"]], axis=-1)
    if output in (PHASE, INTENSITY):
        return np.stack([channels["quadrature"], channels["Y"]], axis=-1)
    return channels["removed" if output == VARIANCE else "Y"]


# ---- Bodies: in the unit of the sphere's radius, seen from a distance of 4 by a camera that looks at the centre ----

def axes(parameters):
    if parameters["view"] == "slice":
        return np.eye(3) * [[1], [-1], [1]]
    yaw, pitch = (math.radians(parameters.get(name, default)) for name, default in (("yaw", 0), ("pitch", 30)))
    right = np.array([math.cos(yaw), math.sin(yaw), 0])
    eye = np.array([math.sin(yaw) * math.cos(pitch), -math.cos(yaw) * math.cos(pitch), math.sin(pitch)])
    return right, np.cross(eye, right), eye


def places(parameters):
    """Where each pixel's ray meets the body, in kernel radii, and the normal there."""
    scale = parameters.get("scale", 24)
    y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    if parameters["view"] == "slice":
        points = np.stack([x / scale, y / scale, np.full_like(x, parameters["depth"])], axis=-1)
        return points, np.broadcast_to([0.0, 0.0, 1.0], points.shape)
    right, up, toward = axes(parameters)
    side = 2 * 1.05 * math.tan(math.asin(0.25)) / min(WIDTH, HEIGHT)
    unit = 1 / (3 * side * scale)
    ray = side * ((x - WIDTH / 2)[..., None] * right - (y - HEIGHT / 2)[..., None] * up) - toward
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    large, small = (0.68, 0.3) if parameters["view"] == "torus" else (0, 1)

    def gap(p):
        return np.hypot(np.linalg.norm(p[..., :2], axis=-1) - large if large else np.linalg.norm(p[..., :2], axis=-1),
                        p[..., 2]) - small

    # By steps that never reach past the surface.
    distance = np.full(x.shape, 2.9)
    for _ in range(400):
        distance = np.minimum(distance + gap(4 * toward + distance[..., None] * ray), 6)
    p = 4 * toward + distance[..., None] * ray
    ring = np.zeros_like(p)
    if large:
        ring[..., :2] = large * p[..., :2] / np.linalg.norm(p[..., :2], axis=-1, keepdims=True)
    normal = (p - ring) / np.linalg.norm(p - ring, axis=-1, keepdims=True)
    return unit * p, normal


if __name__ == "__main__":
    unittest.main()

"""Compares copied code and exported files with the window, for bodies, materials and terrain. Checks that noise on bodies keeps
its contrast while they turn."""

import json
import math
import unittest

import numpy as np

from events import EventsTest  # noqa: I001 (first: it adds tests/cli to sys.path)
from outputs import (COLOURED, GRADIENT, HEIGHT, INTENSITY, LANDSCAPE, LIT, LOBES, PARTS, PHASE, TERRAIN, VALUE, WIDTH, OutputsTest)
from png import read_colour_png
from viewer import SHADERS

BODIES = {
    "sphere": ({"view": "sphere", "filter": False, "orientation": 30, "frequency": 2, "yaw": 20}, GRADIENT, 0, 2),
    "torus": ({"view": "torus", "filter": False, "solid": True, "frequency": 1.5, "pitch": 60}, PHASE, 1, 2),
    "lit sphere": ({"view": "sphere", "filter": False, "frequency": 2, "yaw": 20, "viewer": {"light": [30, 50]}}, LIT, 3, 2),
    "colours": ({**COLOURED, "view": "sphere", "filter": False}, VALUE, 0, 2),
    "slice": ({"view": "slice", "depth": 0.3, "lobes": LOBES}, INTENSITY, 0, 2),
}
COLOUR_OF_BODY = "colour_of_body(texelFetch(places, ivec2(at), 0).xyz, texelFetch(normals, ivec2(at), 0).xyz)"


class Bodies(OutputsTest):
    def test_bodies(self):
        # Where a ray grazes a torus, the slightest change moves the point that it hits.
        self.check(BODIES, {"torus": (1e-2, 2)})

    def test_copied_code_includes_the_lighting(self):
        sphere = {"view": "sphere", "frequency": 2, "orientation": 30, "yaw": 20, "pitch": 40}
        metal = {"material": "brushed-metal", "seed": 3}
        cases = {
            "sphere": {"view": "sphere", "yaw": 20, "pitch": 40, "lobes": LOBES, "filter": False, "viewer": {"output": "lit", "colours": "ember"}},
            "solid torus": {"view": "torus", "solid": True, "frequency": 1.5, "viewer": {"output": "lit", "light": [30, 60]}},
            "slice": {"view": "slice", "depth": 0.3, "viewer": {"output": "lit", "colours": "sea"}},
            "stripes": {**sphere, "frequency": 1, "filter": False, "viewer": {"output": "lit stripes", "colours": "ember"}},
            "leather": {"material": "leather", "view": "sphere", "filter": True, "yaw": 20, "leather.cells": 4},
            "metal's colour": {**metal, "view": "torus", "viewer": {"look": "colour"}},
            "a tile of metal": {**metal, "tileable": True, "viewer": {"look": "normal", "normals": "DirectX"}},
            "leather's height": {"material": "leather", "viewer": {"look": "height", "contrast": 3}},
            "a horizon of metal": {**metal, "filter": True, "view": "horizon"},
            "wood under the sky": {"material": "wood", "filter": True, "view": "horizon", "environment": "overcast"},
            "metal under the sky": {**metal, "view": "torus", "environment": "overcast", "light_azimuth": 40, "light_elevation": 70},
            "noise under the sky": {"viewer": {"output": "lit", "environment": "overcast"}},
            "a sphere under the sky": {**sphere, "viewer": {"output": "lit", "environment": "overcast"}},
            "leather in the dark": {"material": "leather", "environment": "dark"},
            "terrain": TERRAIN,
            "landscape": LANDSCAPE,
            "ocean": {"view": "ocean", "wind": 14, "fetch": 90000, "swell_height": 6, "swell_period": 9, "swell_direction": 70, "seed": 3, "seconds": 8.5,
                      "light_azimuth": 60, "light_elevation": 15},
        }
        self.compare(cases)

    def test_copied_code_draws_presets_of_all_materials(self):
        presets = [(json.loads(path.read_text()), path.stem) for path in (SHADERS.parent / "host/render/request/presets").glob("*.json")]
        # For each material, the preset that sets the most parameters, such as corduroy for fabric.
        richest = {made["material"]: (made, name) for made, name in sorted(presets, key=lambda each: (len(each[0]), each[1]))
                   if "material" in made}
        self.assertEqual(len(richest), 11)
        self.compare({name: {**made, "width": WIDTH, "height": HEIGHT} for made, name in richest.values()})

    def compare(self, cases):
        """Compares the pictures that copied code draws with the window's. cases: parameters by name."""
        script = []
        for number, parameters in enumerate(cases.values()):
            shown = {"look": "lit", "contrast": 2, "normals": "OpenGL", "environment": "room", **parameters.get("viewer", {})}
            scale = {} if parameters.get("view") == "ocean" else {"scale": 24}
            self.preset(f"{number}.json", **{"width": WIDTH, "height": HEIGHT, **scale, **parameters, "viewer": shown})
            script += [f"open {number}.json", "keys ctrl+c", f"copy {number}.glsl", f"screenshot {number}.png"]
        self.play("\n".join(script), "0.json", "--window", f"{WIDTH}x{HEIGHT}", timeout=900)
        for number, (name, parameters) in enumerate(cases.items()):
            with self.subTest(name):
                seen = read_colour_png(self.folder / f"{number}.png")
                code = (self.folder / f"{number}.glsl").read_text()
                inside = np.ones((HEIGHT, WIDTH), bool)
                if parameters.get("view") in ("sphere", "torus", "slice"):
                    points, normals, found = places(parameters)
                    inside = found & (normals @ axes(parameters)[2] > 0.3) # away from the outline
                    colours = self.draw_colours(code, COLOUR_OF_BODY, places=points, normals=normals)[0]
                else:
                    colours = self.draw_colours(code, "colour_of_view(at)")[0]
                self.assertGreater(inside.mean(), 0.1)
                self.assertGreater(seen[inside].std(), 3)
                off = np.abs(seen - 255 * colours).max(axis=2)[inside]
                # On bodies, copied code takes the slopes of stripes and the pixels of filters from the quad's derivatives, and the
                # viewer from the next pixel.
                share, most = {"stripes": (0.98, 20), "leather": (0.95, 1.5)}.get(name, (0.99, 1.5))
                print(f"{name}: the copied code is off by {np.quantile(off, share):.2f} of 255 in {share:.0%}")
                self.assertLess(np.quantile(off, share), most)

    def draw(self, parameters, snippet, output):
        points, normals, _ = places(parameters)
        if "colour" in parameters:
            return self.draw_colours(snippet, COLOUR_OF_BODY, places=points, normals=normals)
        main = (f"vec3 p = texelFetch(places, ivec2(at), 0).xyz, normal = texelFetch(normals, ivec2(at), 0).xyz;"
                f"Noise n = noise_of_body(p, normal); pixels = {PARTS[output]}; colour = colour_of_body(p, normal);")
        pixels, colours = self.run_code(snippet, main, places=points, normals=normals)
        if output in (GRADIENT, LIT): # gradients are in the plane of the picture
            right, up = axes(parameters)[:2]
            pixels = np.stack([pixels[..., :3] @ right, -pixels[..., :3] @ up, pixels[..., 3]], axis=-1)
        return pixels[..., :3 if output == LIT else 2], colours


# The unit of length is the sphere's radius; the camera looks at the body's centre from a distance of 4.

def axes(parameters):
    if parameters["view"] == "slice":
        return np.eye(3) * [[1], [-1], [1]]
    yaw, pitch = (math.radians(parameters.get(name, default)) for name, default in (("yaw", 0), ("pitch", 30)))
    right = np.array([math.cos(yaw), math.sin(yaw), 0])
    eye = np.array([math.sin(yaw) * math.cos(pitch), -math.cos(yaw) * math.cos(pitch), math.sin(pitch)])
    return right, np.cross(eye, right), eye


def places(parameters):
    """Returns for each pixel where its ray hits the body, in kernel radii, the normal there, and whether it hits."""
    scale = parameters.get("scale", 24)
    y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    if parameters["view"] == "slice":
        points = np.stack([x / scale, y / scale, np.full_like(x, parameters["depth"])], axis=-1)
        return points, np.broadcast_to([0.0, 0.0, 1.0], points.shape), np.ones(x.shape, bool)
    right, up, toward = axes(parameters)
    side = 2 * 1.05 * math.tan(math.asin(0.25)) / min(WIDTH, HEIGHT)
    unit = 1 / (3 * side * scale)
    ray = side * ((x - WIDTH / 2)[..., None] * right - (y - HEIGHT / 2)[..., None] * up) - toward
    ray /= np.linalg.norm(ray, axis=-1, keepdims=True)
    large, small = (0.68, 0.3) if parameters["view"] == "torus" else (0, 1)

    def gap(p):
        return np.hypot(np.hypot(p[..., 0], p[..., 1]) - large, p[..., 2]) - small

    # Sphere tracing: no step crosses the surface.
    distance, moving = np.full(x.size, 2.9), np.arange(x.size)
    for _ in range(400):
        step = gap(4 * toward + distance[moving, None] * ray.reshape(-1, 3)[moving])
        distance[moving] = np.minimum(distance[moving] + step, 6)
        moving = moving[(step > 1e-9) & (distance[moving] < 6)]
    p = 4 * toward + distance.reshape(*x.shape, 1) * ray
    ring = np.zeros_like(p)
    if large:
        ring[..., :2] = large * p[..., :2] / np.linalg.norm(p[..., :2], axis=-1, keepdims=True)
    normal = (p - ring) / np.linalg.norm(p - ring, axis=-1, keepdims=True)
    return unit * p, normal, gap(p) < 1e-3


class Turning(EventsTest):
    def test_noise_keeps_its_contrast_while_a_body_turns(self):
        for view in ("sphere", "torus"):
            self.open("--window", "1280x800", self.preset(f"{view}.json", view=view, filter=True))
            still = self.shown(300, 450, 300, 200).std()
            self.point(400, 300)
            self.xdotool("mousedown", 1)
            self.frames(2)
            moving = []
            for x in range(410, 500, 30):
                self.point(x, 300)
                self.frames(1)
                moving.append(self.screen(300, 450, 300, 200).std())
            self.xdotool("mouseup", 1)
            self.wait_for(lambda state: state["fine"])
            print(f"{view}: standard deviation {still:.0f}, and {min(moving):.0f} or more while it turns")
            self.assertGreater(min(moving), 0.4 * still)
            self.close()


if __name__ == "__main__":
    unittest.main()

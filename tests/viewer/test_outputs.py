"""Compares copied code and exported files with the window, for noise in the plane."""

import unittest

from outputs import (COLOURED, GRADIENT, INTENSITY, LIT, LIT_STRIPES, LOBES, PARTS, PHASE, STRIPES, VALUE, VARIANCE, OutputsTest)

NOISES = {
    "lattice-2": {"recipe": "lattice-2", "frequency": 3, "orientation": 20},
    "lattice-4, later": {"recipe": "lattice-4", "frequency": 5, "orientation": -50, "evolution": 0.3},
    "lattice, tileable": {"orientation": 40, "tileable": True},
    "one": {"recipe": "one"},
    "paper": {"recipe": "paper", "frequency": 2.5, "orientation": 30, "seed": 9},
    "pure, later": {"recipe": "pure", "frequency": 6, "orientation": -77, "seed": 4000000000, "evolution": 0.3},
    "lobes": {"lobes": [{"frequency": 3, "orientation": 20}, {"frequency": 5, "orientation": 100, "power": 0.5}],
              "seed": 5},
    "radii": {"lobes": [{"frequency": 3, "frequency_spread": 0.3, "radius": 2},
                        {"frequency": 5, "orientation": 70, "power": 0.3, "radius": 0.6}], "tileable": True},
    "filtered radii": {"lobes": [{"frequency": 3, "frequency_spread": 0.2}, {"frequency": 8, "radius": 0.6}],
                       "filter": True},
    "spread": {"frequency": 3, "orientation": 10, "orientation_spread": 40, "frequency_spread": 0.2},
    "filtered": {"frequency": 9, "orientation": 25, "filter": True},
    "filtered, tileable": {"scale": 23, "frequency": 8, "filter": True, "tileable": True},  # nodes stretch to fit the tile
    "horizon": {"frequency": 2, "orientation": 60, "filter": True, "view": "horizon"},
    "tileable": {"recipe": "pure", "orientation": 40, "tileable": True},
}
PLANES = {
    **{name: (parameters, VALUE, 1, 2) for name, parameters in NOISES.items()},
    "value": ({}, VALUE, 1, 3),
    "gradient of lobes": ({"lobes": LOBES, "seed": 5}, GRADIENT, 0, 1.5),
    "lit": ({"orientation": 40}, LIT, 3, 2),
    "lit lobes": ({"lobes": LOBES, "seed": 5, "filter": True}, LIT, 1, 3),
    "phase": ({"recipe": "one", "orientation": 40}, PHASE, 1, 2),
    "grey phase": ({"evolution": 0.3}, PHASE, 0, 2),
    "intensity": ({"recipe": "lattice-2", "tileable": True}, INTENSITY, 3, 2),
    "filtered intensity": ({"frequency": 7, "filter": True}, INTENSITY, 4, 1),
    "own colours": ({"orientation": 40}, VALUE, 5, 2),
    **{f"stripes, {profile}": ({"frequency": 2, "orientation": 30, "viewer": {"profile": profile}}, STRIPES, 3, 2)
       for profile in ("sine", "triangle", "sawtooth", "bands", "ridges")},
    "lit stripes": ({"frequency": 2, "orientation": 30}, LIT_STRIPES, 5, 1),
    "lit ridges": ({"frequency": 2, "orientation": 30, "filter": True, "viewer": {"profile": "ridges"}}, LIT_STRIPES, 4, 2),
    "colours": ({**COLOURED, "tileable": True}, VALUE, 0, 2),
    "colours on a horizon": ({**COLOURED, "filter": True, "view": "horizon"}, VALUE, 0, 2),
    "fractal": ({"fractal": "fbm", "fractal.octaves": 4.5, "fractal.turn": 20, "evolution": 0.3}, VALUE, 1, 2),
    "filtered, warped ridges": ({"fractal": "ridged", "fractal.basis": "perlin", "fractal.warp": 0.2, "filter": True}, VALUE, 2, 1),
    "lit fractal tile": ({"fractal": "fbm", "fractal.gain": 0.4, "tileable": True}, LIT, 3, 2),
    "fractal on a horizon": ({"fractal": "billow", "filter": True, "view": "horizon"}, VALUE, 1, 2),
    "variance on a horizon": ({"frequency": 2, "orientation": 60, "filter": True, "view": "horizon"}, VARIANCE, 1, 2),
}


class Planes(OutputsTest):
    def test_planes(self):
        self.check(PLANES, {"variance on a horizon": (2e-3, 0.05)})

    def draw(self, parameters, snippet, output):
        if "colour" in parameters:
            return self.draw_colours(snippet, "colour_of_view(at)")
        pixels, colours = self.run_code(
            snippet, f"Noise n = noise_of_view(at); pixels = {PARTS[output]}; colour = colour_of_view(at);")
        # In the plane, there is no slope along z.
        found = (0,) if output in (VALUE, VARIANCE) else (0, 1, 3) if output == LIT else (0, 1)
        return pixels[..., found].squeeze(), colours


if __name__ == "__main__":
    unittest.main()

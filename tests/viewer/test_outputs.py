"""What is taken home is what is seen, in the plane."""

import unittest

from outputs import COLOURED, GRADIENT, INTENSITY, LOBES, NAMES, PHASE, VALUE, VARIANCE, OutputsTest, padded

PLANES = {
    "value": ({}, VALUE, 1, 3),
    "gradient of lobes": ({"lobes": LOBES, "seed": 5}, GRADIENT, 0, 1.5),
    "phase": ({"recipe": "one", "orientation": 40}, PHASE, 1, 2),
    "grey phase": ({"time": 0.3}, PHASE, 0, 2),
    "intensity": ({"recipe": "lattice-2", "tileable": True}, INTENSITY, 3, 2),
    "filtered intensity": ({"frequency": 7, "filter": True}, INTENSITY, 4, 1),
    "colours": ({**COLOURED, "tileable": True}, VALUE, 0, 2),
    "colours on a horizon": ({**COLOURED, "filter": True, "view": "horizon"}, VALUE, 0, 2),
    "variance on a horizon": ({"frequency": 2, "orientation": 60, "filter": True, "view": "horizon"}, VARIANCE, 1, 2),
}


class Planes(OutputsTest):
    def test_planes(self):
        self.check(PLANES, {"variance on a horizon": (2e-3, 0.05)})

    def draw(self, parameters, snippet, output):
        if "colour" in parameters:
            return self.draw_colours(snippet, "colour_of_view(at)")
        single = output in (VALUE, VARIANCE)
        value = padded(f"{NAMES[output]}_of_view(at)", 1 if single else 2)
        pixels, colours = self.run_code(snippet, f"pixels = {value}; colour = colour_of_view(at);")
        return pixels[..., 0] if single else pixels[..., :2], colours


if __name__ == "__main__":
    unittest.main()

"""Reads PNG files with Pillow: a second opinion on the program's files."""

import numpy as np
from PIL import Image


def read_png(path, *modes):
    """Returns the values of a PNG that Pillow opens in one of these modes."""
    with Image.open(path) as image:
        assert image.format == "PNG" and image.mode in modes, f"{image.format} {image.mode}"
        return np.array(image).astype(int)


def read_grey_png(path):
    """Returns the values, height x width, of an 8-bit grey PNG."""
    return read_png(path, "L")


def read_deep_png(path):
    """Returns the values, height x width, of a 16-bit grey PNG."""
    return read_png(path, "I", "I;16")  # before Pillow 11, and since


def read_colour_png(path):
    """Returns the values, height x width x 3, of an 8-bit RGB PNG."""
    return read_png(path, "RGB")

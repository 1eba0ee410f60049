"""Reads PNG files with Pillow: a second opinion on the program's files."""

import zlib

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


def read_deep_colour_png(path):
    """Returns the values, height x width x 3, of a 16-bit RGB PNG, whose low bytes Pillow drops. Expects differences from the
    row above, as the program writes them."""
    high, data = read_colour_png(path), path.read_bytes()
    at, body = 8, b""
    while at < len(data):
        end = at + 8 + int.from_bytes(data[at:at + 4], "big")
        body += data[at + 8:end] if data[at + 4:at + 8] == b"IDAT" else b""
        at = end + 4
    rows = np.frombuffer(zlib.decompress(body), "u1").reshape(len(high), -1)
    assert data[24] == 16 and (rows[:, 0] == 2).all(), f"{data[24]} bits"
    values = rows[:, 1:].cumsum(axis=0, dtype="u1").view(">u2").reshape(high.shape).astype(int)
    np.testing.assert_array_equal(values >> 8, high)
    return values

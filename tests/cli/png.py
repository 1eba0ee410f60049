"""Decodes the two kinds of PNG that the program writes: 8-bit grey for one channel and 8-bit RGB for three, not interlaced."""

import pathlib
import struct
import zlib

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def read_grey_png(path):
    """Returns height x width values."""
    return read(path, 0, 1)[..., 0]


def read_colour_png(path):
    """Returns height x width x 3 values."""
    return read(path, 2, 3)


def read(path, colour_type, channels):
    data = pathlib.Path(path).read_bytes()
    assert data.startswith(SIGNATURE), "not a PNG"
    chunks, at = [], len(SIGNATURE)
    while at < len(data):
        size, = struct.unpack_from(">I", data, at)
        kind, body = data[at + 4:at + 8], data[at + 8:at + 8 + size]
        assert struct.unpack_from(">I", data, at + 8 + size) == (zlib.crc32(kind + body),), "checksum"
        chunks.append((kind, body))
        at += 12 + size
    assert chunks[0][0] == b"IHDR" and chunks[-1] == (b"IEND", b"")
    width, height, *form = struct.unpack(">IIBBBBB", chunks[0][1])
    assert form == [8, colour_type, 0, 0, 0], f"not an 8-bit PNG with {channels} channels"
    rows = zlib.decompress(b"".join(body for kind, body in chunks if kind == b"IDAT"))
    rows = np.frombuffer(rows, np.uint8).reshape(height, 1 + width * channels)
    return np.dstack([unfilter(np.hstack([rows[:, :1], rows[:, 1 + channel::channels]])) for channel in range(channels)])


def unfilter(rows):
    if (rows[:, 0] == 2).all(): # each row minus the row above, as the program writes them
        return np.cumsum(rows[:, 1:], axis=0, dtype=np.uint8).astype(int)
    pixels = np.zeros((rows.shape[0] + 1, rows.shape[1]), int) # a border of zeros above and to the left
    for y, (kind, *row) in enumerate(rows.tolist(), 1):
        for x, value in enumerate(row, 1):
            left, up, corner = pixels[y, x - 1], pixels[y - 1, x], pixels[y - 1, x - 1]
            nearest = min((left, up, corner), key=lambda neighbour: abs(left + up - corner - neighbour))
            pixels[y, x] = (value + (0, left, up, (left + up) // 2, nearest)[kind]) & 255
    return pixels[1:, 1:]

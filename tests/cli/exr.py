"""Reads and writes uncompressed scanline OpenEXR files with numpy alone: a second opinion on the program's files.

The format is that of https://openexr.com/en/latest/OpenEXRFileLayout.html
"""

import json
import pathlib
import struct

import numpy as np

START = struct.pack("<ii", 20000630, 2)
PIXEL_TYPES = ("<u4", "<f2", "<f4")


class Exr:
    """A file whose values are all finite. attributes: name -> (type, bytes). channels: name -> array of height x width."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        assert data.startswith(START), "not a scanline OpenEXR file"
        self.attributes, at = read_attributes(data, len(START))
        assert self.attributes["compression"][1] == b"\0", "compressed"
        left, top, right, bottom = self.box("dataWindow")
        width, height = right - left + 1, bottom - top + 1
        self.types = read_channel_types(self.attributes["channels"][1])

        row = np.dtype([("y", "<i4"), ("size", "<i4")] + [(name, kind, (width,)) for name, kind in self.types.items()])
        offsets = np.frombuffer(data, "<u8", height, at)
        start = at + offsets.nbytes
        assert np.array_equal(offsets, start + row.itemsize * np.arange(height, dtype="u8")), "wrong offset table"
        assert len(data) == start + row.itemsize * height, "wrong file length"
        rows = np.frombuffer(data, row, height, start)
        assert np.array_equal(rows["y"], np.arange(top, bottom + 1)) and (rows["size"] == row.itemsize - 8).all()
        self.channels = {name: rows[name] for name in self.types}
        assert all(np.isfinite(values).all() for values in self.channels.values()), "not finite"

    def box(self, name):
        return struct.unpack("<4i", self.attributes[name][1])

    @property
    def parameters(self):
        return json.loads(self.attributes["gabor"][1])

    @property
    def pixels(self):
        return self.channels["Y"]


def header(path):
    """Returns the attributes, name -> (type, bytes), of a file with any compression."""
    return read_attributes(pathlib.Path(path).read_bytes(), len(START))[0]


class Texture:
    """An uncompressed tiled file with levels, each half as large as the one before, rounded down. levels: for each level,
    name -> array of height x width."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        assert data.startswith(struct.pack("<ii", 20000630, 2 | 0x200)), "not a tiled OpenEXR file"
        self.attributes, at = read_attributes(data, len(START))
        assert self.attributes["compression"][1] == b"\0", "compressed"
        side, other, mode = struct.unpack("<iiB", self.attributes["tiles"][1])
        assert (side, other, mode) == (64, 64, 1), "not mip-mapped tiles of 64 x 64, rounding down"
        left, top, right, bottom = struct.unpack("<4i", self.attributes["dataWindow"][1])
        self.window = left, top, right - left + 1, bottom - top + 1
        types = read_channel_types(self.attributes["channels"][1])
        _, _, width, height = self.window
        sizes = [(max(1, width >> level), max(1, height >> level)) for level in range(max(width, height).bit_length())]
        tiles = [(level, x, y) for level, (w, h) in enumerate(sizes) for y in range(-(-h // side)) for x in range(-(-w // side))]
        offsets = struct.unpack_from(f"<{len(tiles)}Q", data, at)
        assert sorted(offsets)[0] == at + 8 * len(tiles)
        self.levels = [{name: np.full((h, w), np.nan, kind) for name, kind in types.items()} for w, h in sizes]
        for (level, x, y), offset in zip(tiles, offsets):
            assert struct.unpack_from("<4i", data, offset) == (x, y, level, level)
            w, h = (min(side, length - side * i) for length, i in zip(sizes[level], (x, y)))
            row = np.dtype([(name, kind, (w,)) for name, kind in types.items()])
            assert struct.unpack_from("<i", data, offset + 16)[0] == h * row.itemsize
            rows = np.frombuffer(data, row, h, offset + 20)
            for name in types:
                self.levels[level][name][64 * y:64 * y + h, 64 * x:64 * x + w] = rows[name]
        assert all(np.isfinite(values).all() for level in self.levels for values in level.values()), "not finite"


def read_name(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode(), end + 1


def read_attributes(data, at):
    attributes = {}
    while data[at]:
        name, at = read_name(data, at)
        kind, at = read_name(data, at)
        end = at + 4 + struct.unpack_from("<i", data, at)[0]
        attributes[name] = (kind, data[at + 4:end])
        at = end
    return attributes, at + 1


def read_channel_types(data):
    types, at = {}, 0
    while data[at]:
        name, at = read_name(data, at)
        kind, _, x_sampling, y_sampling = struct.unpack_from("<4i", data, at)
        assert (x_sampling, y_sampling) == (1, 1)
        types[name] = PIXEL_TYPES[kind]
        at += 16
    return types


def write_exr(path, channels, parameters=None, window=None):
    """Writes a file. channels: name -> array of height x width, of a type in PIXEL_TYPES. parameters: the text of the `gabor`
    attribute. window: another data window for the header, to write a damaged file."""
    channels = {name: np.asarray(values) for name, values in sorted(channels.items())}
    height, width = next(iter(channels.values())).shape
    box = struct.pack("<4i", *(window or (0, 0, width - 1, height - 1)))
    described = b"".join(name.encode() + b"\0" + struct.pack("<4i", PIXEL_TYPES.index(values.dtype.str), 0, 1, 1)
                         for name, values in channels.items()) + b"\0"
    attributes = [("channels", "chlist", described), ("compression", "compression", b"\0"),
                  ("dataWindow", "box2i", box), ("displayWindow", "box2i", box), ("lineOrder", "lineOrder", b"\0"),
                  ("pixelAspectRatio", "float", struct.pack("<f", 1)),
                  ("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0)),
                  ("screenWindowWidth", "float", struct.pack("<f", 1))]
    if parameters is not None:
        attributes.append(("gabor", "string", parameters.encode()))
    header = START + b"".join(f"{name}\0{kind}\0".encode() + struct.pack("<i", len(value)) + value
                              for name, kind, value in attributes) + b"\0"
    rows = [b"".join(values[y].tobytes() for values in channels.values()) for y in range(height)]
    blocks = [struct.pack("<ii", y, len(row)) + row for y, row in enumerate(rows)]
    first = len(header) + 8 * height
    offsets = [first + y * len(blocks[0]) for y in range(height)]
    pathlib.Path(path).write_bytes(header + struct.pack(f"<{height}Q", *offsets) + b"".join(blocks))

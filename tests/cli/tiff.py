"""Writes TIFF files with numpy alone. The format is that of https://www.itu.int/itudoc/itu-t/com16/tiff-fx/docs/tiff6.pdf"""

import pathlib
import struct
import zlib

import numpy as np

FORMATS = {"u": 1, "i": 2, "f": 3}
TYPES = {"s": 2, "H": 3, "I": 4, "d": 12}


def write_tiff(path, values, tile=None, deflate=False, big=False, **tags):
    """Writes an array of height x width, or x 3 colours, in its own type and byte order. tile: the size of tiles as (height, width), in place of
    strips. big: writes a BigTIFF. tags: t33550=("d", 1, 2, 3) adds a tag with these numbers, and t42113=("s", b"-1") one with text."""
    (height, width, *channels), order = values.shape, "<>"[values.dtype.str[0] == ">"]
    rows, columns = tile or (40, width)
    if tile:
        values = np.pad(values, [(0, -height % rows), (0, -width % columns)] + [(0, 0)] * len(channels))
    blocks = [values[y:y + rows, x:x + columns].tobytes() for y in range(0, height, rows) for x in range(0, width, columns)]
    blocks = [zlib.compress(block) for block in blocks] if deflate else blocks
    sizes = [len(block) for block in blocks]
    begin, word = (16, "Q") if big else (8, "I")
    places = [begin + sum(sizes[:i]) for i in range(len(sizes))]
    layout = {322: ("I", columns), 323: ("I", rows), 324: ("I", *places), 325: ("I", *sizes)} if tile else {
        278: ("I", rows), 273: ("I", *places), 279: ("I", *sizes)}
    fields = {256: ("I", width), 257: ("I", height), 258: ("H", *[8 * values.itemsize] * (channels or [1])[0]), 259: ("H", 8 if deflate else 1),
              262: ("H", 2 if channels else 1), 277: ("H", *(channels or [1])), 339: ("H", *[FORMATS[values.dtype.kind]] * (channels or [1])[0]), **layout,
              **{int(name[1:]): tag for name, tag in tags.items()}}
    data = b"".join(blocks)
    entries = b""
    for tag, (kind, *numbers) in sorted(fields.items()):
        value = numbers[0] + b"\0" if kind == "s" else struct.pack(f"{order}{len(numbers)}{kind}", *numbers)
        count = len(value) if kind == "s" else len(numbers)
        place = value.ljust(begin // 2, b"\0")
        if len(value) > begin // 2:
            place = struct.pack(order + word, begin + len(data))
            data += value + b"\0" * (len(value) % 2)
        entries += struct.pack(order + "HH" + word, tag, TYPES[kind], count) + place
    start = {"<": b"II", ">": b"MM"}[order] + struct.pack(order + ("HHHQ" if big else "HI"),
                                                          *((43, 8, 0) if big else (42,)), begin + len(data))
    pathlib.Path(path).write_bytes(start + data + struct.pack(order + ("Q" if big else "H"), len(fields)) + entries + bytes(begin // 2))

"""Textures with known answers, and photographs from scikit-image's wheel."""

import os
import pathlib
import struct
import subprocess
import sys
import zipfile
import zlib

import numpy as np

WHEELS = pathlib.Path(os.environ.get("GABOR_WHEELS", ".")).resolve()
WHEEL = "scikit-image==0.25.2"


def photograph(name):
    """Returns the path of a photograph from scikit-image's wheel, which is downloaded once. Raises OSError if the download
    fails."""
    path = WHEELS / f"{name}.png"
    if not path.exists():
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--dest", WHEELS, WHEEL]
        result = subprocess.run(command, capture_output=True, text=True)
        wheels = sorted(WHEELS.glob("scikit_image-*.whl"))
        if not wheels:
            raise OSError(f"no wheel of {WHEEL}: {result.stderr.strip().splitlines()[-1:]}")
        with zipfile.ZipFile(wheels[0]) as wheel:
            path.write_bytes(wheel.read(f"skimage/data/{name}.png"))
    return path


ADAM7 = (0, 0, 8, 8), (0, 4, 8, 8), (4, 0, 8, 4), (0, 2, 4, 4), (2, 0, 4, 2), (0, 1, 2, 2), (1, 0, 2, 1) # y, x, and their steps


def write_png(path, values, bits=8, alpha=False, interlaced=False):
    """Writes grey values (height x width) or colours (height x width x 3) from 0 to 1 to a PNG."""
    values = values[..., None] if values.ndim == 2 else values
    if alpha:
        values = np.concatenate([values, np.ones_like(values[..., :1])], -1)
    height, width, channels = values.shape
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    numbers = np.rint(np.clip(values, 0, 1) * (2**bits - 1)).astype(">u2" if bits == 16 else "u1")
    passes = [numbers[y::down, x::right] for y, x, down, right in (ADAM7 if interlaced else [(0, 0, 1, 1)])]
    rows = b"".join(b"\0" + row.tobytes() for part in passes for row in part)

    def chunk(name, body):
        return struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))

    header = struct.pack(">IIBBBBB", width, height, bits, kind, 0, 0, interlaced)
    pathlib.Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1))
                                   + chunk(b"IEND", b""))


def colour_noise(side, seed=1):
    """Returns two lobes of normal noise as a picture, with different phases in red, green and blue."""
    generator = np.random.default_rng(seed)
    fx = np.fft.fftfreq(side)[None, :]
    fy = np.fft.fftfreq(side)[:, None]
    picture = np.zeros((side, side, 3))
    for (x, y), width, weights in (((0.06, 0.02), 0.012, (1, 0.8j, 0.5)), ((0.0, 0.17), 0.03, (0.3, 0.4 + 0.2j, 0.8))):
        lobe = np.exp(-((fx - x)**2 + (fy - y)**2) / (4 * width**2))
        wave = np.fft.ifft2(np.fft.fft2(generator.standard_normal((side, side))) * lobe)
        wave /= np.abs(wave).std() + np.abs(wave).mean()
        for c, weight in enumerate(weights):
            picture[..., c] += 0.12 * (weight * wave).real
    return picture + (0.5, 0.45, 0.4)


def welch(channels, side=64, hop=32):
    """Returns the cross-spectra (side x side x count x count) of channels (height x width x count) under Hann windows."""
    window = 0.5 - 0.5 * np.cos(2 * np.pi * np.arange(side) / side)
    window = np.outer(window, window)
    window /= np.sqrt((window**2).sum())
    height, width, count = channels.shape
    total = np.zeros((side, side, count, count), complex)
    begins = [(y, x) for y in range(0, height - side + 1, hop) for x in range(0, width - side + 1, hop)]
    for y, x in begins:
        values = np.fft.fft2(channels[y:y + side, x:x + side] * window[..., None], axes=(0, 1))
        total += values[..., :, None] * values[..., None, :].conj()
    return total / len(begins)


def without_trend(channels):
    """Returns each channel minus its best-fitting quadratic polynomial."""
    height, width, count = channels.shape
    y, x = np.meshgrid(np.linspace(-1, 1, height), np.linspace(-1, 1, width), indexing="ij")
    polynomials = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], -1).reshape(-1, 6)
    flat = channels.reshape(-1, count)
    return (flat - polynomials @ np.linalg.lstsq(polynomials, flat, rcond=None)[0]).reshape(channels.shape)

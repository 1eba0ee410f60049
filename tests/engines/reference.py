"""The scene that every engine draws, in double precision, from the equations and not from the shaders: the recipe `one`
of gabor_noise.glsl, and gabor_lattice.glsl.

A target of 256 x 257 floats, p = (pixel + 0.5) / 32 with the pixel's row and column counted from 0:
    rows 0 to 255   gabor_noise(p, 4.0, 0.7854, 7u)
    row 256         gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u)
"""

import functools

import numpy as np

WIDTH, HEIGHT = 256, 257
FREQUENCY, ORIENTATION, SEED = 4.0, float(np.float32(0.7854)), 7
WAVE = FREQUENCY * np.cos(ORIENTATION), FREQUENCY * np.sin(ORIENTATION)
FAR = 1000000000, -1000000000

SPREAD = 0x9e3779b1
WINDOW = np.polynomial.Polynomial([0, 0, 3.0, -4.5, 2.5])(np.polynomial.Polynomial([1, 0, -1]))  # q, in powers of x
FLOOR = 0.675


def words(numbers):
    """Integers modulo 2^32."""
    return np.asarray(numbers, np.int64).astype(np.uint32)


def mix(word, salt):
    word = (word ^ (word >> 16)) * np.uint32(0x21f0aaad) + salt
    word = (word ^ (word >> 15)) * np.uint32(0xd35a2d97)
    return word ^ (word >> 15)


def impulse_word(column, row, seed):
    seed_word = mix(words([seed * SPREAD & 0xffffffff]), np.uint32(0x2545f491))
    row_word = mix(words(row) * np.uint32(SPREAD) + seed_word, seed_word)
    return mix(words(column) * np.uint32(SPREAD) + row_word, row_word)


def one(cell, x, y):
    """The recipe `one` at cell + (x, y), in kernel radii, which are its cells."""
    energy = (WINDOW**2).integ()
    variance = (1 + FLOOR**2) / 2 * (energy(1) - energy(-1)) ** 2 / 2
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    total = np.zeros(np.broadcast(x, y).shape)
    for j in (-1, 0, 1):
        for i in (-1, 0, 1):
            word = impulse_word(cell[0] + column + i, cell[1] + row + j, SEED)
            dx = x - (column + i) - (word >> 8 & 0x7fffff) * 2.0**-23
            dy = y - (row + j) - (word & 0x7fffff) * 2.0**-23
            weight = np.where(word >> 31, 1.0, FLOOR) * ((abs(dx) < 1) & (abs(dy) < 1))
            total += weight * WINDOW(dx) * WINDOW(dy) * np.sin(2 * np.pi * (WAVE[0] * dx + WAVE[1] * dy + word % 256 / 256))
    return total / np.sqrt(variance)


def line_word(index, axis):
    """The word of a column (axis 0) or a row (axis 1) of the lattice."""
    salt = mix(words([SEED * SPREAD & 0xffffffff]), np.uint32(0x2545f491)) ^ np.uint32((0, 0x5bd1e995)[axis])
    word = words(index) * np.uint32(SPREAD) + salt
    return ((word ^ (word >> 15)) * np.uint32(0xd35a2d97) >> 8) | np.uint32(0x800001)


def law(u):
    """What makes u, uniform in [-1, 1], nearly normal."""
    return (u - 0.89289313 * np.clip(u, -0.93687596, 0.93687596)) * (1 + 0.62342056 * u**2)


def amplitude(word):
    """A node's amplitude, its parts from the whole word and from its low half, each of variance 1."""
    whole, half = word.view(np.int32) / 2.0**31, (word << 16).view(np.int32) / 2.0**31
    deviation = np.sqrt(np.mean(law((np.arange(2**20) + 0.5) / 2**20) ** 2))
    return (law(whole) + 1j * law(half)) / deviation


def window(d, taps):
    """It ends where d is 1 or -1. Hann's, but for two taps one whose square and its shift's sum to 1."""
    if taps > 2:
        return np.where(abs(d) < 1, (1 + np.cos(np.pi * d)) / 2, 0)
    x = np.minimum(abs(d), 1)
    s = x**2 * (3 - 2 * x)
    return (1 - s) / np.hypot(1 - s, s)


def lattice(cell, x, y, taps=3, period=2**32):
    """The lattice's noise at cell + (x, y), in node spacings; it may repeat after a whole number of them."""
    radius = taps / 2
    energy = 1 if taps == 2 else 3 / 8 * taps  # the sum of the squared windows of one axis
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    total = np.zeros(np.broadcast(x, y).shape, complex)
    for j in range(-1, 3):  # the nodes within two spacings
        for i in range(-1, 3):
            node = amplitude(line_word((cell[0] + column + i) % period, 0) * line_word((cell[1] + row + j) % period, 1))
            dx, dy = (x - (column + i)) / radius, (y - (row + j)) / radius
            total += node * window(dx, taps) * window(dy, taps) * np.exp(2j * np.pi * (WAVE[0] * dx + WAVE[1] * dy))
    return total.imag / energy


# Each scene: the drop-in, the macros before it, its noise, and its cells per kernel radius.
SCENES = {
    "one": ("gabor_noise", {}, one, 1),
    "lattice": ("gabor_lattice", {}, lattice, 1.5),
    "lattice 2": ("gabor_lattice", {"GABOR_TAPS": 2}, functools.partial(lattice, taps=2), 1),
    "lattice 4": ("gabor_lattice", {"GABOR_TAPS": 4}, functools.partial(lattice, taps=4), 2),
    "tiled": ("gabor_lattice", {}, functools.partial(lattice, period=12), 1.5),  # 8 kernel radii, for nodes that tile
}


@functools.cache
def values(scene):
    _, _, noise, cells = SCENES[scene]
    x, y = np.meshgrid((np.arange(WIDTH) + 0.5) / 32, (np.arange(HEIGHT) + 0.5) / 32)
    return np.vstack([noise((0, 0), cells * x[:-1], cells * y[:-1]), noise(FAR, x[-1:], y[-1:])])


def largest_difference(scene, drawn):
    """From the scene, with its row and column; a value that is no number is the largest of all. Where there is no
    gabor_noise_at its row may be left out."""
    drawn = np.asarray(drawn, np.float64).reshape(-1, WIDTH)
    if len(drawn) not in (HEIGHT - 1, HEIGHT):
        raise ValueError(f"{len(drawn)} rows")
    difference = np.abs(drawn - values(scene)[:len(drawn)])
    difference[np.isnan(difference)] = np.inf
    place = np.unravel_index(difference.argmax(), difference.shape)
    return difference[place], place

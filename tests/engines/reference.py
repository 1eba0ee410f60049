"""The scene that every engine draws, in double precision, from the equations and not from the shader: the recipe `one`.

A target of 256 x 257 floats, p = (pixel + 0.5) / 32 with the pixel's row and column counted from 0:
    rows 0 to 255   gabor_noise(p, 4.0, 0.7854, 7u)
    row 256         gabor_noise_at(ivec2(1000000000, -1000000000), p, gabor_kernel(4.0, 0.7854), 7u)
"""

import numpy as np

WIDTH, HEIGHT = 256, 257
FREQUENCY, ORIENTATION, SEED = 4.0, float(np.float32(0.7854)), 7
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


def noise(cell, x, y):
    """The noise at cell + (x, y), in kernel radii, which are cells in this recipe."""
    energy = (WINDOW**2).integ()
    variance = (1 + FLOOR**2) / 2 * (energy(1) - energy(-1)) ** 2 / 2
    wave_x, wave_y = FREQUENCY * np.cos(ORIENTATION), FREQUENCY * np.sin(ORIENTATION)
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    total = np.zeros(np.broadcast(x, y).shape)
    for j in (-1, 0, 1):
        for i in (-1, 0, 1):
            word = impulse_word(cell[0] + column + i, cell[1] + row + j, SEED)
            dx = x - (column + i) - (word >> 8 & 0x7fffff) * 2.0**-23
            dy = y - (row + j) - (word & 0x7fffff) * 2.0**-23
            weight = np.where(word >> 31, 1.0, FLOOR) * ((abs(dx) < 1) & (abs(dy) < 1))
            total += weight * WINDOW(dx) * WINDOW(dy) * np.sin(2 * np.pi * (wave_x * dx + wave_y * dy + word % 256 / 256))
    return total / np.sqrt(variance)


def scene():
    x, y = np.meshgrid((np.arange(WIDTH) + 0.5) / 32, (np.arange(HEIGHT) + 0.5) / 32)
    return np.vstack([noise((0, 0), x[:-1], y[:-1]), noise(FAR, x[-1:], y[-1:])])


def largest_difference(values):
    """From the scene, with its row and column; a value that is no number is the largest of all."""
    difference = np.abs(np.asarray(values, np.float64).reshape(HEIGHT, WIDTH) - scene())
    difference[np.isnan(difference)] = np.inf
    place = np.unravel_index(difference.argmax(), difference.shape)
    return difference[place], place

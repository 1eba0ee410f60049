"""The scene that every engine draws, computed in double precision from the equations, not from the shaders: the `one`
recipe of gabor_sparse.glsl, and gabor_noise.glsl.

The target has 256 x 257 floats, not a square, so that exchanged sides show: gabor_noise(p, 4.0, 0.7854, 7u) with
p = (pixel + 0.5) / 32, where the pixel's row and column count from 0.
"""

import functools

import numpy as np

WIDTH, HEIGHT = 256, 257
FREQUENCY, ORIENTATION, SEED = 4.0, float(np.float32(0.7854)), 7
WAVE = FREQUENCY * np.cos(ORIENTATION), FREQUENCY * np.sin(ORIENTATION)

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
    """Returns the `one` recipe at cell + (x, y), in kernel radii; a cell is one radius wide."""
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


def salt(seed):
    return mix(words([seed * SPREAD & 0xffffffff]), np.uint32(0x2545f491))


def derived_seed(seed, index):
    """Returns the seed of part `index` of a sum."""
    return int(mix(words([(seed + index * 0x85ebca6b) & 0xffffffff]), np.uint32(0x9e3779b1))[0])


def line_word(index, axis, seed=SEED):
    """Returns the hash word of a column (axis 0), a row (1) or a slice (2) of the lattice."""
    word = words(index) * np.uint32(SPREAD) + (salt(seed) ^ np.uint32((0, 0x5bd1e995, 0x27d4eb2f)[axis]))
    return (word * (word ^ (word >> 15)) >> 8) | np.uint32(0x800001)


def law(u):
    """Maps u, uniform in [-1, 1], to a nearly normal value."""
    return (u - 0.89289313 * np.clip(u, -0.93687596, 0.93687596)) * (1 + 0.62342056 * u**2)


DEVIATION = np.sqrt(np.mean(law((np.arange(2**20) + 0.5) / 2**20) ** 2))


def amplitude(word, time=0.0):
    """Returns a node's complex amplitude: the real part from the whole word, the imaginary part from its low 20 bits, each with
    variance 1; with time, a mix of three amplitudes."""
    if time:
        second = (word ^ (word >> 15)) * np.uint32(0xd35a2d97)
        third = (second ^ (second >> 15)) * np.uint32(0xd35a2d97)
        turn = np.exp(2j * np.pi * time)
        return ((1 + turn.real) * amplitude(word) + (1 - turn.real) * amplitude(second)
                + np.sqrt(2) * turn.imag * amplitude(third)) / 2
    whole, low = word.view(np.int32) / 2.0**31, (word << 12).view(np.int32) / 2.0**31
    return (law(whole) + 1j * law(low)) / DEVIATION


def window(d, taps):
    """Returns Hann's window or, for two taps, a window whose shifted squares sum to 1. It ends where d is 1 or -1."""
    if taps > 2:
        return np.where(abs(d) < 1, (1 + np.cos(np.pi * d)) / 2, 0)
    x = np.minimum(abs(d), 1)
    s = x**2 * (3 - 2 * x)
    return (1 - s) / np.hypot(1 - s, s)


def complex_lattice(cell, x, y, taps=3, period=(2**32, 2**32), seed=SEED, time=0.0, radius=(None, None),
                    wave=WAVE, amplitudes=None):
    """Returns the lattice's noise (imaginary part) and its quadrature (real part) at cell + (x, y), in node spacings. `radius`
    is the kernel radius in spacings, and `period` the number of spacings after which the noise repeats. `amplitudes`, a
    function of column and row, replaces the nodes' amplitudes."""
    reach = taps / 2
    energy = 1 if taps == 2 else 3 / 8 * taps  # the sum of the squared windows along one axis
    scale_x, scale_y = (each or reach for each in radius)
    column, row = np.floor(x).astype(np.int64), np.floor(y).astype(np.int64)
    total = np.zeros(np.broadcast(x, y).shape, complex)
    for j in range(-1, 3):  # the nodes within two spacings
        for i in range(-1, 3):
            node = amplitudes(column + i, row + j) if amplitudes else \
                amplitude(line_word((cell[0] + column + i) % period[0], 0, seed)
                          * line_word((cell[1] + row + j) % period[1], 1, seed), time)
            dx, dy = x - (column + i), y - (row + j)
            total += node * window(dx / reach, taps) * window(dy / reach, taps) \
                * np.exp(2j * np.pi * (wave[0] * dx / scale_x + wave[1] * dy / scale_y))
    return total / energy


def lattice(cell, x, y, taps=3, period=2**32):
    return complex_lattice(cell, x, y, taps, (period, period)).imag


def complex_lattice_3d(x, y, z, direction):
    """Returns the lattice's noise and quadrature in 3D, with three taps; x, y and z are in kernel radii."""
    wave = FREQUENCY * np.array(direction) / np.linalg.norm(direction)
    x, y, z = np.broadcast_arrays(1.5 * x, 1.5 * y, 1.5 * z)
    first = [np.floor(each).astype(np.int64) for each in (x, y, z)]
    total = np.zeros(x.shape, complex)
    for i, j, k in np.ndindex(4, 4, 4):
        column, row, slice_ = (corner + step - 1 for corner, step in zip(first, (i, j, k)))
        word = (line_word(row, 1) * line_word(slice_, 2) >> 8) | np.uint32(0x800001)
        dx, dy, dz = ((at - node) / 1.5 for at, node in zip((x, y, z), (column, row, slice_)))
        total += amplitude(line_word(column, 0) * word) * window(dx, 3) * window(dy, 3) * window(dz, 3) \
            * np.exp(2j * np.pi * (wave[0] * dx + wave[1] * dy + wave[2] * dz))
    return total / (9 / 8) ** 1.5


# ---- Other outputs of nodes ----------------------------------------------------------------------------------------

# Each function returns one number for each p = (x, y) in kernel radii: a weighted sum of the node's outputs.
STEP = 1e-5  # step for derivatives, which are then exact within 1e-6


def plane(x, y, **options):
    return complex_lattice((0, 0), 1.5 * x, 1.5 * y, **options)


def gradient(x, y):
    along_x = (plane(x + STEP, y) - plane(x - STEP, y)).imag
    along_y = (plane(x, y + STEP) - plane(x, y - STEP)).imag
    return plane(x, y).imag + (along_x + 2 * along_y) / (2 * STEP * 32)


def four(x, y):
    seeds = [SEED, *(derived_seed(SEED, -index) for index in (1, 2, 3))]
    return sum((index + 1) / 4 * plane(x, y, seed=seed).imag for index, seed in enumerate(seeds))


def tiled(x, y, time=0.0):
    """Returns noise with periods of 2 and 1 kernel radii. Each has 3 nodes, so the second has narrower windows."""
    return complex_lattice((0, 0), 1.5 * x, 3 * y, period=(3, 3), radius=(1.5, 3), time=time).imag


def solid(x, y):
    def noise(*steps):
        return complex_lattice_3d(*(place + STEP * step for place, step in zip((x, y, 0.3), steps)), (1, 2, 3)).imag
    slopes = [noise(*axis) - noise(*-axis) for axis in np.eye(3)]
    return noise(0, 0, 0) + (slopes[0] + 2 * slopes[1] + 3 * slopes[2]) / (2 * STEP * 64)


def stripes(x, y):
    """Stripes with sharpness 2."""
    value = plane(x, y)
    even = value * np.minimum(2, 1 / abs(value))
    return (even.real + 2 * even.imag + 3 * abs(value)) / 4


# The tones and heights of gabor_materials.glsl's brushed metal: sums over noises of frequency 0 in narrow kernels.
def brushed(x, y):
    tone = height = 0
    for part in range(5):
        fine = 2.0**part
        spots = complex_lattice((0, 0), 1.5 * (0.3 + 0.12 * fine) * x, 1.5 * 9 * fine * y, seed=derived_seed(SEED, part), wave=(0, 0))
        height = height + 0.0012 / fine * spots.real
        tone = tone + np.sqrt(0.2) * spots.imag
    return np.clip(0.55 * np.exp(0.09 * (tone - 0.045)), 0, 1) + 200 * height


def fbm(x, y, octaves=3.3, gain=0.5):
    """gabor_fbm of gabor_fractal.glsl: each octave is twice as fine as the one before it, turned by atan(3/4), and moved."""
    place, step = 1.5 * (x + 1j * y), np.round(8192 * np.exp(1j * np.arctan(0.75))) / 4096
    total, power = 0, 0
    for octave in range(int(np.ceil(octaves))):
        salt = mix(words([(SEED * SPREAD + octave * 0x85ebca6b) & 0xffffffff]), np.uint32(0xc2b2ae35))

        def amplitudes(column, row):
            lines = [words(index) * np.uint32(SPREAD) + (salt ^ np.uint32(mask)) for index, mask in ((column, 0), (row, 0x5bd1e995))]
            one, other = ((word * (word ^ (word >> 15)) >> 8) | np.uint32(0x800001) for word in lines)
            return amplitude(one * other)
        weight = gain**octave * min(octaves - octave, 1)
        total = total + weight * complex_lattice((0, 0), place.real, place.imag, wave=(0, 0), amplitudes=amplitudes).real
        power += weight**2
        place = step * place + 0.382 + 0.731j
    return total / np.sqrt(power)


FUNCTIONS = {
    "noise": lambda x, y: plane(x, y).imag,
    "far": lambda x, y: lattice((1000000000, -1000000000), x, y),
    "complex": lambda x, y: plane(x, y).real,
    "gradient": gradient,
    "four": four,
    "tiled": tiled,
    "tiled and animated": lambda x, y: tiled(x, y, 0.3),
    "stripes": stripes,
    "brushed metal": brushed,
    "animated": lambda x, y: plane(x, y, time=0.3).imag,
    "solid": solid,
    "fbm": fbm,
}


# Each scene: the drop-in, the macros before it, its noise, and its cells per kernel radius.
SCENES = {
    "one": ("gabor_sparse", {}, one, 1),
    "lattice": ("gabor_noise", {}, lattice, 1.5),
    "lattice 2": ("gabor_noise", {"GABOR_TAPS": 2}, functools.partial(lattice, taps=2), 1),
    "lattice 4": ("gabor_noise", {"GABOR_TAPS": 4}, functools.partial(lattice, taps=4), 2),
    "tile of 8": ("gabor_noise", {}, functools.partial(lattice, period=12), 1.5),  # 12 / 1.5 = 8 kernel radii
}


@functools.cache
def values(scene, rows=HEIGHT):
    x, y = np.meshgrid((np.arange(WIDTH) + 0.5) / 32, (np.arange(rows) + 0.5) / 32)
    if scene in FUNCTIONS:
        return FUNCTIONS[scene](x, y)
    _, _, noise, cells = SCENES[scene]
    return noise((0, 0), cells * x, cells * y)


def largest_difference(scene, drawn):
    """Returns the largest difference from the scene or the function, with its row and column; a NaN counts as the largest.
    The last row may be missing; a function needs only its first 32 rows."""
    drawn = np.asarray(drawn, np.float64).reshape(-1, WIDTH)
    if len(drawn) not in (HEIGHT - 1, HEIGHT) and not (scene in FUNCTIONS and 32 <= len(drawn) < HEIGHT):
        raise ValueError(f"unexpected number of rows: {len(drawn)}")
    difference = np.abs(drawn - values(scene, len(drawn)))
    difference[np.isnan(difference)] = np.inf
    place = np.unravel_index(difference.argmax(), difference.shape)
    return difference[place], place

#!/usr/bin/python3
"""Derives the fitted constants of the drop-ins. Needs numpy.

    tools/constants.py            # prints each fit's place, and numbers and errors of the drop-in and of the best fit
    tools/constants.py ocean      # prints only the fits of gabor_ocean.glsl

Errors are those of exact arithmetic; floats add about 1e-7. tests/source/test_constants.py compares the numbers, and checks that
all other constants of five or more digits are closed forms or choices.
"""

import dataclasses
import math
import pathlib
import re
import sys
from math import pi, sqrt
from statistics import NormalDist
from typing import Callable

import numpy as np

SHADERS = pathlib.Path(__file__).parents[1] / "shaders"
LITERAL = re.compile(r"(?<![\w.])\d+\.\d*(?:e[+-]?\d+)?(?![\w.])")


@dataclasses.dataclass
class Fit:
    file: str
    name: str  # of a function or a macro
    about: str
    numbers: np.ndarray
    error: Callable  # of numbers in this order
    tolerance: float = 1e-6  # the drop-in's numbers are these, within this share
    excess: float = 0.01  # the drop-in's error is at most this share larger than that of these numbers

    def found(self):
        """Returns the literals of the drop-in that are nearest to the numbers."""
        text = (SHADERS / self.file).read_text()
        definitions = re.findall(rf"^(?:#define {self.name} .*?$|\w+ {self.name}\(.*?^}})", text, re.MULTILINE | re.DOTALL)
        literals = LITERAL.findall(re.sub("//.*", "", "\n".join(definitions)))
        return [min(literals, key=lambda text: abs(float(text) - abs(number))) for number in self.numbers]

    def drop_in(self):
        return np.copysign([float(text) for text in self.found()], self.numbers)


# ---- Methods -------------------------------------------------------------------------------------------------------


def minimax(basis, target, weight=1.0):
    """Returns the coefficients c of the columns of `basis` that minimize the maximum of |weight (basis @ c - target)|,
    by Remez exchange."""
    rows, columns = basis.shape
    weight = np.broadcast_to(weight, rows)
    points = np.round((1 - np.cos(pi * (np.arange(columns + 1) + 0.5) / (columns + 1))) / 2 * (rows - 1)).astype(int)
    for _ in range(100):
        signs = (-1.0) ** np.arange(columns + 1)
        system = np.column_stack([basis[points] * weight[points, None], signs])
        best = np.linalg.solve(system, target[points] * weight[points])[:columns]
        error = weight * (target - basis @ best)
        runs = np.split(np.arange(rows), np.nonzero(np.diff(np.sign(error)))[0] + 1)
        peaks = [run[np.argmax(abs(error[run]))] for run in runs]
        while len(peaks) > columns + 1:
            del peaks[0 if abs(error[peaks[0]]) < abs(error[peaks[-1]]) else -1]
        if len(peaks) <= columns or (np.array(peaks) == points).all():
            break
        points = np.array(peaks)
    return best


def least_squares(basis, target):
    return np.linalg.lstsq(basis, target, rcond=None)[0]


def refine(model, start, target, solve, steps=20):
    """Fits a nonlinear model: solves for changes of its parameters along their derivatives."""
    p = np.array(start, dtype=float)
    for _ in range(steps):
        moves = 1e-5 * np.eye(len(p))
        p = p + solve(np.column_stack([(model(p + move) - model(p - move)) / 2e-5 for move in moves]), target - model(p))
    return p


def normal_below(x):
    return np.array([0.5 + 0.5 * math.erf(v / sqrt(2)) for v in x])


# ---- Fits ----------------------------------------------------------------------------------------------------------


def power_series(file, name, function, end, powers, about="", weight=lambda x: 1.0):
    """A polynomial of x from 0 to `end`."""
    x = np.linspace(0.0, end * (1 - 1e-9), 4001)[1:]
    basis, target = np.column_stack([x**k for k in powers]), function(x)
    return Fit(file, name, f"{about}, minimax up to {end:.4g}", minimax(basis, target, weight(x)),
               lambda c: abs(weight(x) * (basis @ c - target)).max())


def amplitude_fits():
    """Amplitudes f(u) = (u - a clamp(u, -b, b)) (u^2 + c) of words u, which are uniform."""
    u = (np.arange(4000) + 0.5) / 4000
    normal = np.array([NormalDist().inv_cdf(0.5 + 0.5 * v) for v in u])
    unit = 2.0 ** np.array([0, 31, 62])  # words are integers of 32 bits

    def shape(p, u=u):
        return (u - p[0] * np.minimum(u, p[1])) * (u * u + p[2])

    def deviation(p):  # f is a polynomial on each side of b
        x, w = np.polynomial.legendre.leggauss(8)
        sides = [(end - start, start + (end - start) * (0.5 + 0.5 * x)) for start, end in ((0.0, p[1]), (p[1], 1.0))]
        return sqrt(sum(0.5 * width * (w * shape(p, v) ** 2).sum() for width, v in sides))

    def quantiles(p):
        return shape(p) / deviation(p)

    best = refine(quantiles, [0.9, 0.9, 1.5], normal, least_squares, 50)
    law = Fit("gabor_noise.glsl", "gabor_impl_amplitude", "least squares of the differences from normal quantiles; the drop-in's "
              "rms difference is 5 % larger, for a Cramer-von Mises index that is 40 % smaller", best * unit,
              lambda p: sqrt(((quantiles(p / unit) - normal) ** 2).mean()), 0.2, 0.06)
    whole = 2.0**93 * deviation(law.drop_in() / unit)
    # gabor_float.glsl has the drop-in's numbers for u in [-1/2, 1/2].
    law_float = law.drop_in() * [1.0, 2.0**-32, 2.0**-64]
    scale = 8 / (1.125 * whole / 2.0**93)
    return [law, Fit("gabor_noise.glsl", "GABOR_IMPL_DEVIATION", "standard deviation of the drop-in's amplitudes",
                     np.array([whole]), lambda d: abs(d[0] / whole - 1)),
            Fit("gabor_float.glsl", "gabor_impl_amplitude", "those of gabor_noise.glsl", law_float, lambda p: abs(p / law_float - 1).max()),
            Fit("gabor_float.glsl", "gabor_impl_field", "1 / (9/8 times the standard deviation of the amplitudes)", np.array([scale]),
                lambda s: abs(s[0] / scale - 1))]


def filtered_window_fit():
    """H(q) / 2w at q = 1, 2, 3 times 1 / 2w, times 1, 2, 4, for w = (2 + t) / 1.5 kernel radii: see gabor_impl_filtered_axis. H is
    the transform of Hann's window. The polynomials are exact at t = 0."""
    t = np.linspace(0.0, 0.5, 4001)
    w, a = (2 + t[:, None]) / 1.5, np.array([1.0, 2.0, 3.0])
    target = np.array([1.0, 2.0, 4.0]) * np.sinc(a / w) / (1 - (a / w) ** 2) / (2 * w)
    basis = np.column_stack([t, t * t])
    rest = np.column_stack([minimax(basis[1:], column) for column in (target[1:] - target[0]).T])
    return Fit("gabor_filter.glsl", "gabor_impl_filtered_axis", "Fourier coefficients of Hann's window, minimax over t in [0, 1/2]",
               np.concatenate([target[0], *rest]), lambda c: abs(c[:3] + basis @ c[3:].reshape(2, 3) - target).max(), 3e-4)


def mean_fits():
    """Means of exp(-q u^2) as sqrt((1 + a q + b q^2) / (1 + c q + d q^2 + e q^3)). Such a mean is 1 - slope / 2 q near q = 0, hence
    c = a + slope, and sqrt(limit / q) at infinity, hence e = b / limit."""
    q = np.geomspace(1e-3, 1e4, 1001)
    turn = (np.arange(1000) + 0.5) * pi / 1000
    circle = np.exp(-q[:, None] * np.cos(turn) ** 2).mean(1)
    sphere = sqrt(pi) / 2 * (2 * normal_below(np.sqrt(2 * q)) - 1) / np.sqrt(q)

    def model(p):
        return np.sqrt((1 + q * (p[0] + p[1] * q)) / (1 + q * (p[2] + q * (p[3] + p[4] * q))))

    def fit(file, name, about, target, slope, limit, tolerance, excess):
        def complete(p):
            return np.array([p[0], p[1], p[0] + slope, p[2], p[1] / limit])
        best = complete(refine(lambda p: model(complete(p)), [0.3, 0.1, 0.5], target, minimax))
        return Fit(file, name, f"mean of exp(-q u^2), minimax over q; u: {about}", best, lambda p: abs(model(p) - target).max(),
                   tolerance, excess)

    return [fit("gabor_filter.glsl", "gabor_impl_mean_angle", "cosine of an angle", circle, 1.0, 1 / pi, 0.003, 0.02),
            fit("gabor_filter_3d.glsl", "gabor_impl_transmitted_isotropic", "coordinate on a sphere", sphere, 2 / 3, pi / 4, 0.012, 0.1)]


def below_fits():
    x = np.linspace(0.0, 4.0, 2001)[1:]
    target = normal_below(x)

    def model(p):
        return 1 / (1 + np.exp2(-x * (p[0] + x * x * (p[1] + p[2] * x * x))))
    best, about = refine(model, [2.3, 0.1, 0.0], target, minimax), "the normal distribution function, minimax"
    return [Fit("gabor_materials.glsl", "gabor_impl_below", about, best, lambda p: abs(model(p) - target).max(), 5e-4),
            Fit("gabor_float.glsl", "gabor_uniform", f"{about}, with exp instead of exp2", best * math.log(2),
                lambda p: abs(model(p / math.log(2)) - target).max(), 5e-4)]


def uniform_fit():
    x = np.linspace(0.0, 6.0, 2401)[1:]
    target = normal_below(x)

    def model(p):
        return 1 / (1 + np.exp(-x * (p[0] + x * x * (p[1] + p[2] * x * x))))
    return Fit("gabor_noise.glsl", "gabor_uniform", "the normal distribution function, minimax up to 6",
               refine(model, [1.6, 0.07, 0.0], target, minimax), lambda p: abs(model(p) - target).max(), 1e-3)


def fractal_fits():
    """Correlations of the filtered windows of gabor_fractal.glsl with exactly filtered ones, as a function of the pixel's variance."""
    step = 1 / 64
    d = np.arange(-2 + step / 2, 2, step)  # from the node, in node spacings
    variance = np.geomspace(1 / 64, 16, 49)

    def windows(perlin, variance, d):
        """u and v: a window and its derivative, over the roots of the sums of their squares at all nodes."""
        def at(d):
            if not perlin:
                width = min(1.5 * sqrt(1 + variance / 0.294), 2.0)
                return np.stack([np.cos(pi / 2 * np.clip(d / width, -1, 1)) ** 2] * 2)
            t, c, s = min(5.5 * variance, 2.0), np.cos(pi / 4 * np.clip(d, -2, 2)) ** 2, -pi / 4 * np.sin(pi / 2 * np.clip(d, -2, 2))
            return np.stack([c * c * (1 + t - t * c), s * c * (2 + 2 * t - 3 * t * c)])
        return at(d) / np.sqrt(sum(at(d - np.floor(d) + k) ** 2 for k in range(-4, 5)))

    def correlations(perlin):
        made = []
        for one in variance:
            deviation = sqrt(one)
            along = np.arange(-5, 5.001, min(0.125, 0.05 / deviation))
            weight = np.exp(-0.5 * along**2) / np.exp(-0.5 * along**2).sum()
            exact = np.tensordot(windows(perlin, 0.0, d[:, None] + along * deviation), weight, 1)
            made.append(step * (exact * windows(perlin, one, d)).sum(1))
        return np.array(made)

    smooth, perlin = correlations(False)[:, 0], correlations(True)

    def fit(name, power, targets, start, about):
        def model(p):
            return (1 + variance * (p[0] + p[1] * variance**2 / (variance + p[2]))) ** -power
        target = (targets.max(0) + targets.min(0)) / 2
        best = refine(model, start, target, minimax)
        return Fit("gabor_fractal.glsl", name, about, best, lambda p: abs(model(p) - targets).max(), 2e-3, 0.05)

    r = np.arange(2001) / 2000
    rest = 1 - r * r
    folded = 2 / pi * (np.sqrt(rest) + r * np.arcsin(r) - 1)
    basis = np.stack([r**2, -r**4, rest**1.5 - 1, rest**2.5 - 1], 1)

    def magnitude(p):  # the last number is the sum of the two before it
        return basis @ p[:4]
    best = minimax(basis, folded)
    about = "correlation of windows {}, minimax"
    return [Fit("gabor_fractal.glsl", "gabor_impl_kept_magnitude", "variance of |n|, minimax", np.array([*best, best[2] + best[3]]),
                lambda p: abs(magnitude(p) - folded).max(), 1e-3, 0.2),
            fit("gabor_impl_kept_even", 0.25, np.array([smooth, perlin[:, 0]]), [2.9, 1.4, 0.6], about.format("u")),
            fit("gabor_impl_kept_odd", 0.75, perlin[None, :, 1], [2.8, 1.2, 0.2], about.format("v"))]


def leather_fit():
    """The mean height: complex noises z_a and z_b, divided by sqrt(|z|^2 + 0.12), make cells, to which normal grain is added."""
    x, w = np.polynomial.legendre.leggauss(24)
    length, weight = 3 * (x + 1), 3 * w * 3 * (x + 1) * np.exp(-4.5 * (x + 1) ** 2)  # |z| and its probability
    length = length / np.sqrt(length**2 + 0.12)
    grain, density = np.polynomial.hermite_e.hermegauss(8)
    turn = np.arange(96) / 96 * 2 * pi

    def smoothstep(low, high, v):
        t = np.clip((v - low) / (high - low), 0.0, 1.0)
        return t * t * (3 - 2 * t)

    mean = 0.0
    for r, share in zip(length, weight):
        cells = (r * np.cos(turn)[:, None, None] + length * np.cos(turn)[:, None]
                 + r * length * np.cos(turn[:, None, None] + turn[:, None]))
        pebble = sum(d * smoothstep(-1.45, -0.55, cells + 0.1 * g) for g, d in zip(grain, density / density.sum()))
        mean += share * (weight * (0.016 * pebble + 0.013 * smoothstep(-1.0, 3.0, cells)).mean((0, 1))).sum()
    return Fit("gabor_materials.glsl", "gabor_impl_leather", "mean height; the drop-in's was measured", np.array([mean]),
               lambda c: abs(c[0] / mean - 1), 2e-3, math.inf)


def profile_fit():
    """The width w of a mean over phases, by y = 1 - sin(pi w) / (pi w): sqrt(y) (sqrt(6) / pi + ...)."""
    width = (np.arange(1000) + 0.5) / 1000
    y = 1 - np.sinc(width)
    basis, target = np.sqrt(y)[:, None] * y[:, None] ** [1, 2, 3], width - sqrt(6) / pi * np.sqrt(y)
    return Fit("gabor_spectrum.glsl", "gabor_impl_ends_at", "width of a mean over phases, least squares over widths up to 1",
               least_squares(basis, target), lambda c: sqrt(((basis @ c - target) ** 2).mean()), 0.004)


def sea_fit():
    """The energy e / (1 + 0.06 age) + n above which foam covers a share of the sea, by L = -ln(share). e is exponential, age uniform up
    to a turn, and n normal with the deviation of the noises that tear foam."""
    weights = 0.96, 0.72, *(sqrt(1 - 2 / pi) * w for w in (0.58, 0.44, 0.33)), 0.3
    noise = sqrt(sum(w * w for w in weights)) * np.linspace(-5, 5, 401)
    chance = np.exp(-np.linspace(-5, 5, 401) ** 2 / 2)
    rates = 1 + 0.06 * 2 * pi * (np.arange(400) + 0.5) / 400
    least = np.linspace(1.4, 12, 300)
    share = np.array([(chance @ np.exp(-np.outer(np.maximum(x - noise, 0), rates))).mean() / chance.sum() for x in least])
    seen = (share < 0.32) & (share > 3e-5)
    rare, least = -np.log(share[seen]), least[seen]
    basis = np.column_stack([rare**0, rare, np.log(rare), rare**2])
    return Fit("gabor_ocean.glsl", "gabor_foam", "least squares of the energy, for shares of 3e-5 to 0.32", least_squares(basis, least),
               lambda c: abs(basis @ c - least).max(), 1e-3, 0.1)


def polynomial_fits():
    noise, sparse = "gabor_noise.glsl", "gabor_sparse.glsl"
    turn, windows, direction = "gabor_impl_half_turn", "gabor_impl_windows", "gabor_impl_direction"
    cosine = power_series(noise, turn, lambda t: np.cos(2 * pi * t), 0.25, [0, 2, 4, 6, 8], "cos(2 pi t), with 1 for 0.99999995")
    with_constant, cosine.numbers = cosine.error, cosine.numbers[1:]
    cosine.error = lambda c: with_constant([1.0, *c])
    both = [cosine,
            power_series(noise, turn, lambda t: np.sin(2 * pi * t), 0.25, [1, 3, 5, 7, 9], "sin(2 pi t)"),
            power_series(noise, windows, lambda x: np.cos(2 / 3 * pi * x) / 2 - 0.5, 0.5, [2, 4, 6], "cos(2/3 pi x) / 2 - 1/2"),
            power_series(noise, windows, lambda x: sqrt(3) / 4 * np.sin(2 / 3 * pi * x), 0.5, [1, 3, 5, 7],
                         "sqrt(3)/4 sin(2/3 pi x)")]
    return [*both, *(dataclasses.replace(fit, file="gabor_float.glsl") for fit in both),
            power_series(noise, windows, lambda z: (np.cos(pi / 2 * z) - 1) / sqrt(8), 0.5, [2, 4, 6], "(cos(pi/2 z) - 1) / sqrt(8)"),
            power_series(noise, windows, lambda z: np.sin(pi / 2 * z) / sqrt(8), 0.5, [1, 3, 5, 7], "sin(pi/2 z) / sqrt(8)"),
            power_series(sparse, "gabor_impl_sine", lambda t: np.sin(2 * pi * t) / t / (0.25 - t * t), 0.5, [0, 2, 4, 6, 8],
                         "sin(2 pi t), divided by t (1/4 - t^2)", lambda t: t * (0.25 - t * t)),
            power_series(sparse, direction, lambda x: (np.sin(x) - x) / x**3, pi / 4, [0, 2, 4], "relative: sin(x)",
                         lambda x: x**3 / np.sin(x)),
            power_series(sparse, direction, lambda x: (np.cos(x) - 1 + x * x / 2) / x**4, pi / 4, [0, 2, 4], "relative: cos(x)",
                         lambda x: x**4 / np.cos(x))]


def fits():
    return [*amplitude_fits(), *polynomial_fits(), filtered_window_fit(), *mean_fits(), *below_fits(), uniform_fit(),
            *fractal_fits(), leather_fit(), profile_fit(), sea_fit()]


if __name__ == "__main__":
    for fit in fits():
        if all(word in fit.file for word in sys.argv[1:]):
            here, best = fit.error(fit.drop_in()), fit.error(fit.numbers)
            print(f"{fit.file}: {fit.name}: {fit.about}\n    error {here:.3g}; of the best fit {best:.3g}")
            for text, number, best in zip(fit.found(), fit.drop_in(), fit.numbers):
                print(f"    {text:>14}    {best:.8g}, {100 * (number / best - 1):+.2g} %")

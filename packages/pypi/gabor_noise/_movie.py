"""Movies of drifting noise with a stated spectrum, drift and contrast, for experiments on vision."""

from __future__ import annotations

import math
import operator
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray

from ._arguments import count, fill_lobes, number, refuse, seeds, sides, workers as cores_of

# A lobe's power has the standard deviation 1/sqrt(12) / radius along each axis.
_LOBE = 12**-0.5
# The full width at half height of a normal distribution, in standard deviations.
_WIDTH = math.sqrt(8 * math.log(2))


def _spread(deviation: float, lobe: float) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the centres and powers of lobes of one deviation, whose sum has another."""
    rest = math.sqrt(deviation**2 - lobe**2)
    pieces = math.ceil(4 * rest / (1.4 * lobe))
    centres = (np.arange(pieces) - (pieces - 1) / 2) * 1.4 * lobe
    powers = np.exp(-0.5 * (centres / rest) ** 2)
    return centres, powers / powers.sum()


class Movie(Sequence[NDArray[np.float32]]):
    """What `movie` returns: frames by index, or in a loop. `lobes` has their spectrum, in pixels, for `noise_lobes` and shaders."""

    def __init__(self, shape: Sequence[int], frames: int, lobes: Sequence[tuple[float, float, float, float]],
                 step: tuple[float, float], contrast: float, seed: int, cores: int) -> None:
        self.shape, self.lobes, self.step, self.contrast, self.seed = tuple(shape), list(lobes), step, contrast, seed
        self._frames, self._cores = frames, cores

    def __len__(self) -> int:
        return self._frames

    def __getitem__(self, index: Any) -> Any:
        if isinstance(index, slice):
            return [self[each] for each in range(*index.indices(self._frames))]
        at = operator.index(index)
        at += self._frames * (at < 0)
        if not 0 <= at < self._frames:
            raise IndexError(f"frame {index} of {self._frames}")
        first = 0.5 - at * self.step[0], 0.5 - at * self.step[1]
        return fill_lobes(self.shape, first, [(*lobe[:3], self.contrast * math.sqrt(lobe[3])) for lobe in self.lobes], self.seed,
                          self._cores)


def movie(shape: Sequence[int], frames: int, *, frequency: float = 0.05, bandwidth: float = 1.0, orientation: float = 0.0,
          orientation_bandwidth: float | None = 0.5, drift_per_frame: float = 1.0, contrast: float = 1.0, seed: int | np.random.Generator = 0,
          pixels_per_degree: float | None = None, workers: int | None = None) -> Movie:
    """Return a movie of noise that drifts along `orientation`: float32 arrays of this shape, by index or in a loop. At each pixel and
    frame, the values of all seeds are normally distributed with mean 0 and standard deviation `contrast`. Frames are computed when
    asked for, and are the same on every machine up to rounding.

    shape: (height, width) in pixels.
    frequency: cycles per pixel at the peak of the power per octave; at most 0.5 / 2^bandwidth.
    bandwidth: full width of the power spectrum at half its height, 0.01 to 4 octaves. It is normal over octaves.
    orientation: direction of waves and drift in radians, from +x to the right towards +y down.
    orientation_bandwidth: full width over directions in radians, 0.01 to 2; None for all directions.
    drift_per_frame: pixels that the pattern moves as a whole from frame to frame.
    contrast: rms contrast of the values. For luminances, multiply them by the mean luminance, then add the mean luminance.
    pixels_per_degree: if given, frequency is in cycles per degree of visual angle, and drift_per_frame in degrees.
    """
    unit = 1.0 if pixels_per_degree is None else number("pixels_per_degree", pixels_per_degree)
    octaves = number("bandwidth", bandwidth)
    highest = 0.5 / 2**octaves
    peak = number("frequency", frequency) / unit
    if not 1e-6 <= peak <= highest:
        raise refuse("frequency", frequency, f"a number from {1e-6 * unit:.3g} to {highest * unit:.3g} cycles per "
                     f"{'pixel' if pixels_per_degree is None else 'degree'}, half a cycle per pixel less the bandwidth")
    towards = number("orientation", orientation)
    along = octaves * math.log(2) / _WIDTH
    across = math.inf if orientation_bandwidth is None else number("orientation_bandwidth", orientation_bandwidth) / _WIDTH
    # A lobe's deviation divided by its frequency. With these constants, the sum's widths are within 1.1 % and its peak, which the last
    # moves by what a lobe is skewed over octaves, within 0.01 octaves.
    lobe = min(0.65 * min(along, across), 0.18)
    logarithms, shares = _spread(along, lobe)
    peak *= math.exp(-0.3 * lobe**2)
    if orientation_bandwidth is None:
        pieces = math.ceil(math.pi / (1.4 * lobe))
        angles, parts = np.arange(pieces) * math.pi / pieces, np.full(pieces, 1 / pieces)
    else:
        angles, parts = _spread(across, lobe)
    lobes = [(float(f), float(towards + angle), float(_LOBE / (lobe * f)), float(share * part))
             for f, share in zip(peak * np.exp(logarithms), shares) for angle, part in zip(angles, parts)]
    pixels = number("drift_per_frame", drift_per_frame) * unit
    drawn = seeds("seed", seed)
    if drawn.ndim:
        raise refuse("seed", seed, "an integer of 32 bits")
    return Movie(sides(shape, 2), count("frames", frames), lobes, (pixels * math.cos(towards), pixels * math.sin(towards)),
                 number("contrast", contrast), int(drawn), cores_of(workers))

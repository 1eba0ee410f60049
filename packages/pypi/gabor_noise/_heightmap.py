"""A heightmap smoothed by a cubic B-spline, as `gabor erode` smooths it: gullies follow its slope."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def _splines(pixels: int, spacing: float, tileable: bool) -> tuple[Array, Array, Array]:
    """Return the B-splines of the nodes at the pixels' centres, and their first and second derivatives per pixel: matrices with a
    row for each pixel and a column for each node."""
    intervals = int(np.clip(np.round(pixels / spacing), 3, max(3, pixels)))
    at = (np.arange(pixels) + 0.5) * intervals / pixels
    first = at.astype(int)
    t = at - first
    u = 1 - t
    value = np.array([u**3, 4 - 3 * t**2 * (1 + u), 4 - 3 * u**2 * (1 + t), t**3]) / 6
    slope = np.array([-u**2, t * (3 * t - 4), u * (4 - 3 * u), t**2]) / 2 * (intervals / pixels)
    curvature = np.array([u, 3 * t - 2, 3 * u - 2, t]) * (intervals / pixels) ** 2
    matrices = np.zeros((3, pixels, intervals if tileable else intervals + 3))
    for k in range(4):
        matrices[:, np.arange(pixels), (first + k) % matrices.shape[2]] += (value[k], slope[k], curvature[k])
    return matrices[0], matrices[1], matrices[2]


def smoothed(heights: Array, spacing: float, tall: float, tileable: bool) -> tuple[list[Array], float]:
    """Return the smoothed map's height, its derivatives d/dx, d/dy, xx, xy and yy per pixel, and its rms slope at the nodes. Pixels are
    `tall` times as high as they are wide; the spacing and the rms slope are in their widths."""
    down, across = (_splines(side, spacing / size, tileable) for side, size in zip(heights.shape, (tall, 1)))
    weights = np.outer(down[0].sum(0), across[0].sum(0))
    nodes = down[0].T @ heights @ across[0] / weights
    surface = [down[y] @ nodes @ across[x].T for x, y in ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))]
    # At a node, the splines of the nodes around it are 1/6, 4/6 and 1/6, and their derivatives -1/2, 0 and 1/2.
    around = np.pad(nodes, (0, 3), "wrap") if tileable else nodes
    blur, power = np.array([1, 4, 1]) / 6, 0.0
    for turned, side in ((around, heights.shape[1]), (around.T, heights.shape[0] * tall)):
        mean = sum(blur[k] * turned[k:turned.shape[0] - 2 + k] for k in range(3))
        intervals = turned.shape[1] - 3
        power += np.mean((0.5 * (mean[:, 2:] - mean[:, :-2]) * intervals / side) ** 2)
    return surface, float(np.sqrt(power))


def sobel(heights: Array, tileable: bool) -> tuple[Array, Array]:
    """Return the map's derivatives d/dx and d/dy per pixel, with the weights 1, 2, 1 across the direction."""
    wide = np.pad(heights, 1, "wrap" if tileable else "edge")
    along_x, along_y = (wide[:, 2:] - wide[:, :-2]) / 8, (wide[2:] - wide[:-2]) / 8
    return (along_x[:-2] + 2 * along_x[1:-1] + along_x[2:], along_y[:, :-2] + 2 * along_y[:, 1:-1] + along_y[:, 2:])

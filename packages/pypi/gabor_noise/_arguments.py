"""Checks arguments, and runs a kernel of the native module on them."""

from __future__ import annotations

import importlib
import math
import os
import reprlib
from typing import Any, Mapping, NamedTuple, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

_native: Any = importlib.import_module("._native", __package__)
if _native.HAS_AVX2:
    _native = importlib.import_module("._native_avx2", __package__)

Seed = Union[ArrayLike, np.random.Generator]

# The range of each argument that is a number, or an array of numbers.
_RANGES: dict[str, tuple[float, float]] = {
    **dict.fromkeys(("x", "y", "z"), (-1e9, 1e9)),
    **dict.fromkeys(("frequency", "cycles_per_unit", "wave_x", "wave_y"), (-1e6, 1e6)),
    "orientation": (-math.inf, math.inf),
    "evolution": (-math.inf, math.inf),
    "direction": (-1e15, 1e15),  # a vector in 3D, or an angle
    "frequency_spread": (0, 1),
    "orientation_spread": (0, 1.570797),  # pi/2, rounded up
    "octaves": (1, 16),
    "gain": (0, 4),
    "lacunarity": (1, 4),
    "turn": (-1e6, 1e6),
    "strength": (-1e6, 1e6),
    "noise": (-math.inf, math.inf),
    "seconds": (-2e9, 2e9),
    "pixel_size": (0, math.inf),
    "sharpness": (0, 1e6),
    "scale": (1e-9, 1e9),
    "extent": (1e-9, 1e9),
    "gully_width": (1e-9, 1e9),
    "gully_frequency": (0.001, 10000),
    "radius": (1e-9, 1e9),
    "power": (0, math.inf),
    "bandwidth": (0.01, 4),
    "orientation_bandwidth": (0.01, 2),
    "drift_per_frame": (-1e6, 1e6),
    "contrast": (0, 1e6),
    "pixels_per_degree": (1e-6, 1e6),
    "base": (-math.inf, math.inf),
    "heights": (-math.inf, math.inf),
}


class Member(NamedTuple):
    """A parameter of a material, of erosion or of the sea: a member of the drop-in's struct."""

    name: str
    kind: str  # "number", "integer", "angle" in radians, or "colour"
    low: float
    high: float
    default: Any
    about: str


def _members() -> dict[str, dict[str, Member]]:
    """Return the parameters of each kernel that has a struct."""
    members: dict[str, dict[str, Member]] = {}
    for row, kind, (low, high), about in _native.ROWS:
        owner, _, name = row.rpartition(".")
        kernel = {"": "terrain", "sea": "water"}.get(owner, owner.replace("-", "_"))
        if kernel not in _native.KERNELS:
            continue
        of = members.setdefault(kernel, {})
        first = sum(3 if each.kind == "colour" else 1 for each in of.values())
        values = _native.KERNELS[kernel][2][first:]
        shown = [float(f"{value:.7g}") for value in values[:3]]  # the decimal digits that the drop-in has
        default = tuple(shown) if kind == "colour" else int(shown[0]) if kind == "integer" else shown[0]
        if kind == "angle":
            low, high = math.radians(low), math.radians(high)
        of[name] = Member(name, kind, low, high, default, about)
    members["eroded"] = members["terrain"]
    members["water_height"] = members["water"]
    return members


MEMBERS = _members()


def refuse(name: str, value: object, expected: str) -> ValueError:
    shown = f"an array of shape {value.shape}" if isinstance(value, np.ndarray) and value.ndim else reprlib.repr(value)
    return ValueError(f"{name} is {shown}: expected {expected}")


def check_mask(name: str, value: object) -> None:
    """Refuse masked elements, whose mask the result would not have."""
    if any(np.ma.is_masked(each) for each in (value if isinstance(value, (list, tuple)) else [value])):
        raise ValueError(f"{name} has masked elements: expected none; fill them, and mask the result")


def numbers(name: str, value: ArrayLike, low: float | None = None, high: float | None = None) -> NDArray[np.float64]:
    """Return finite numbers within their range."""
    if low is None or high is None:
        low, high = _RANGES[name]
    span = ("a finite number" if math.isinf(low) else f"a number, {low:g} or more" if math.isinf(high)
            else f"a number from {low:.7g} to {high:.7g}")
    check_mask(name, value)
    try:
        array = np.asarray("" if value is None else value, np.float64)  # of None, NumPy would make a NaN
    except (TypeError, ValueError):
        raise refuse(name, value, f"{span}, or an array of such numbers") from None
    lowest, highest = max(low, -1.7e308), min(high, 1.7e308)
    if array.size == 0 or lowest <= array.min() and array.max() <= highest:  # a NaN is neither
        return array
    if array.ndim == 0:
        raise refuse(name, value, span)
    place = tuple(map(int, np.argwhere(~((lowest <= array) & (array <= highest)))[0]))
    raise refuse(f"{name}[{', '.join(map(str, place))}]", float(array[place]), span)


def seeds(name: str, value: Seed) -> NDArray[np.float64]:
    """Return integers of 32 bits, without their sign. A generator draws one."""
    check_mask(name, value)
    array = np.asarray(value.integers(2**32) if isinstance(value, np.random.Generator) else value)
    if array.dtype.kind not in "iu" or (array < -2**31).any() or (array >= 2**32).any():
        raise refuse(name, value, "an integer of 32 bits, an array of such integers, or a numpy.random.Generator")
    return (array.astype(np.int64) & 0xFFFFFFFF).astype(np.float64)


def count(name: str, value: object, unit: str = "") -> int:
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool) and value >= 1:
        return int(value)
    raise refuse(name, value, f"an integer, 1 or more{unit}")


def sides(shape: Sequence[int], *dimensions: int) -> tuple[int, ...]:
    """Return the sides of a picture or a volume, with one of these numbers of dimensions."""
    given = tuple(shape) if isinstance(shape, (tuple, list, np.ndarray)) else ()
    if len(given) not in dimensions:
        named = {2: "(height, width)", 3: "(depth, height, width)"}
        raise refuse("shape", shape, " or ".join(named[each] for each in dimensions))
    return tuple(count(f"shape[{axis}]", side) for axis, side in enumerate(given))


def choice(name: str, value: object, choices: Sequence[str]) -> NDArray[np.float64]:
    """Return the index of a word."""
    if isinstance(value, str) and value in choices:
        return np.asarray(choices.index(value), np.float64)
    raise refuse(name, value, f"one of {', '.join(choices)}")


def vector(name: str, value: ArrayLike, length: int) -> list[NDArray[np.float64]]:
    """Return the components along the last axis of an array. For a pair, one number serves for both."""
    array = numbers(name, value)
    if array.ndim == 0 and length == 2:
        return [array] * length
    if array.ndim == 0 or array.shape[-1] != length:
        raise refuse(name, value, f"{'one number, or ' if length == 2 else ''}{length} numbers along the last axis")
    return list(np.moveaxis(array, -1, 0))


def number(name: str, value: ArrayLike) -> float:
    array = numbers(name, value)
    if array.ndim:
        raise refuse(name, value, "one number")
    return float(array)


def periods(value: ArrayLike | None, length: int, least: float) -> list[NDArray[np.float64]]:
    """Return a period along each axis, 0 for none."""
    expected = f"a number or one for each axis, 0 for no repetition or {least:g} to 1e+09"
    check_mask("period", value)
    try:
        array = np.broadcast_to(np.asarray(0.0 if value is None else value, np.float64), length)
    except (TypeError, ValueError):
        raise refuse("period", value, expected) from None
    if not ((array == 0) | ((array >= least) & (array <= 1e9))).all():
        raise refuse("period", value, expected)
    return list(array)


def members(kernel: str, given: Mapping[str, ArrayLike], function: str) -> list[NDArray[np.float64]]:
    """Return the values of a struct's members, with the defaults of those that are not given."""
    of = MEMBERS[kernel]
    if unknown := given.keys() - of.keys():
        raise TypeError(f"{function} has no argument {min(unknown)!r}: expected {', '.join(of)}")
    values: list[NDArray[np.float64]] = []
    exact = iter(_native.KERNELS[kernel][2])
    for name, member in of.items():
        defaults = [np.asarray(next(exact), np.float64) for _ in range(3 if member.kind == "colour" else 1)]
        if name not in given:
            values += defaults
            continue
        array = numbers(name, given[name], member.low, member.high)
        if member.kind == "integer" and (array != np.floor(array)).any():
            raise refuse(name, given[name], f"an integer from {member.low:g} to {member.high:g}")
        if member.kind != "colour":
            values.append(array)
        elif array.ndim > 0 and array.shape[-1] == 3:
            values += list(np.moveaxis(array, -1, 0))
        else:
            raise refuse(name, given[name], "a linear colour: 3 numbers along its last axis")
    return values


def evaluate(kernel: str, given: Mapping[str, Any], more: Sequence[NDArray[np.float64]] = (),
             least_period: float = 2.0**-10) -> NDArray[Any]:
    """Run a kernel on the arguments that its inputs name, followed by `more`. Channels, if there are several, are the last axis of
    what it returns."""
    inputs, channels, _ = _native.KERNELS[kernel]
    groups: dict[str, int] = {}  # the number of inputs of each argument: "period.x period.y" are two of period
    for name in inputs.split():
        argument = name.partition(".")[0]
        groups[argument] = groups.get(argument, 0) + 1
    arrays: list[NDArray[np.float64]] = []
    shapes: dict[str, tuple[int, ...]] = {}
    for name, length in groups.items():
        value = given[name]
        if name == "period":
            found = periods(value, length, least_period)
        elif name == "seed":
            found = [seeds(name, value)]
        elif name == "loop_seconds":
            found = [numbers(name, value, -math.inf, math.inf)]
            if not np.isin(found[0], (0, *2.0 ** np.arange(3, 13))).all():
                raise refuse(name, value, "0 or a power of 2 from 8 to 4096")
        elif name == "evolution":
            found = [numbers(name, 0.0 if value is None else value)]
        else:
            found = [numbers(name, value)] if length == 1 else vector(name, value, length)
        arrays += found
        shapes[name] = found[0].shape
    arrays += more
    try:
        shape = np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        listed = ", ".join(f"{name} {size}" for name, size in shapes.items() if size)
        raise ValueError(f"the shapes of the arguments do not broadcast: {listed}") from None
    dtype = result_type(given["dtype"])
    cores = workers(given["workers"])
    out = np.empty((channels, *shape), dtype)
    if out.size > 0:
        _native.evaluate(kernel, [np.broadcast_to(array, shape) for array in arrays], out, cores)
    return out[0] if channels == 1 else np.moveaxis(out, 0, -1)


def result_type(value: DTypeLike) -> np.dtype[Any]:
    try:
        dtype = np.dtype(value)
    except TypeError:
        dtype = np.dtype(object)
    if dtype not in (np.float32, np.float64):
        raise refuse("dtype", value, "float32 or float64")
    return dtype


def fill_grid(shape: Sequence[int], given: Mapping[str, Any]) -> NDArray[Any] | None:
    """Return a picture of noise if none of its arguments is an array, else None."""
    names = "frequency", "orientation", "seed", "evolution"
    if any(np.ndim(given[name]) for name in names):
        return None
    wave = float(given["scale"]), *(float(numbers(name, given[name])) for name in names[:2]), 1.0
    evolution = 0.0 if given["evolution"] is None else float(numbers("evolution", given["evolution"]))
    period = [float(each) for each in periods(given["period"], 2, 2.0**-10)]
    out = np.empty(tuple(shape), np.float32)
    _native.fill_grid(out, (0.5, 0.5), [wave], [int(seeds("seed", given["seed"]))], period, evolution, workers(given["workers"]))
    return out.astype(result_type(given["dtype"]), copy=False)


def fill_lobes(shape: Sequence[int], first: tuple[float, float], lobes: Sequence[tuple[float, float, float, float]], seed: int,
               cores: int) -> NDArray[np.float32]:
    """Return a picture of `noise_lobes`, whose first pixel is at this position. Lobes have a frequency in cycles per pixel, an
    orientation, a radius in pixels and an amplitude."""
    waves = [(radius, frequency * radius, orientation, amplitude) for frequency, orientation, radius, amplitude in lobes]
    out = np.empty(tuple(shape), np.float32)
    _native.fill_grid(out, first, waves, [_native.derived_seed(seed, i) for i in range(len(waves))], (0.0, 0.0), 0.0, cores)
    return out


def workers(value: int | None) -> int:
    if value is None:
        return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return count("workers", value, ", or None for all cores")

"""Curves through few keys: time (or phase) in, value out; arrays of any shape."""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline, PchipInterpolator

Array = NDArray[np.float64]
Curve = Callable[[Array], Array]
Keys = Sequence[tuple[float, float]]


def constant(value: float) -> Curve:
    """The same value at all times."""
    return lambda t: np.full_like(t, value)


def through(keys: Keys, start_slope: float = 0.0, end_slope: float = 0.0) -> Curve:
    """A twice differentiable curve through the keys with given slopes at both ends; it holds its ends
    outside.
    """
    times, values = np.array(keys, float).T
    spline = CubicSpline(times, values, bc_type=((1, start_slope), (1, end_slope)))
    return lambda t: np.asarray(spline(np.clip(t, times[0], times[-1])))


def eased(keys: Keys) -> Curve:
    """A curve through the keys that never overshoots them and rests at the ends (Fritsch and Carlson
    1980).
    """
    times, values = np.array(keys, float).T
    lead, trail = times[0] - 1.0, times[-1] + 1.0
    spline = PchipInterpolator([lead, *times, trail], [values[0], *values, values[-1]])
    return lambda t: np.asarray(spline(np.clip(t, times[0], times[-1])))


def cyclic(values: Sequence[float]) -> Curve:
    """A twice differentiable closed curve of phase (one cycle = 1) through evenly spaced keys."""
    phases = np.linspace(0.0, 1.0, len(values) + 1)
    spline = CubicSpline(phases, [*values, values[0]], bc_type="periodic")
    return lambda phase: np.asarray(spline(np.mod(phase, 1.0)))


def cyclic_eased(keys: Keys) -> Curve:
    """A closed curve of phase through uneven keys that never overshoots them."""
    phases, values = np.array(keys, float).T
    spline = PchipInterpolator(np.concatenate([phases - 1, phases, phases + 1]), np.tile(values, 3))
    return lambda phase: np.asarray(spline(np.mod(phase, 1.0)))


def ramp(t: Array, start: float, end: float) -> Array:
    """0 before `start`, 1 after `end`, between them the quintic that leaves and arrives without speed or
    acceleration.
    """
    f = np.clip((t - start) / (end - start), 0.0, 1.0)
    return np.asarray(f * f * f * (f * (f * 6 - 15) + 10))

"""Filters for captured motion: low-pass without a shift of phase, and the removal of spikes (FAQ Q18).

They run when a file is read or a clip is made, never in a tick. SciPy is imported on first use, so that a
server that filters nothing does not load it.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat
from statwalk.maths.arrays import Bools, Floats

ORDER = 2
"""of the Butterworth filter; forwards and backwards make it 4"""
SPIKE_WINDOW = 7
MEDIAN_TO_DEVIATION = 1.4826


def low_pass(values: Floats, rate: float, cutoff: float) -> Floats:
    """Returns values (F, …), `rate` samples a second, without what moves faster than `cutoff` Hz.

    A Butterworth filter of order 2 runs forwards and backwards: nothing is delayed. At the cutoff half of the
    amplitude is left. Fewer than 3 samples, or a cutoff of half the rate or more, change nothing.

    :raises ValueError: when the cutoff is not positive.
    """
    if not cutoff > 0:
        raise ValueError(f"a cutoff must be more than 0 Hz, not {cutoff:g}")
    if len(values) < 3 or cutoff >= rate / 2:
        return values.copy()
    from scipy.signal import butter, filtfilt

    above, below = butter(ORDER, 2 * cutoff / rate)
    padded = min(len(values) - 1, int(3 * rate / cutoff))
    filtered: Floats = filtfilt(above, below, np.asarray(values, np.float64), axis=0, padlen=padded)
    return filtered


def low_pass_rotations(turns: Floats, rate: float, cutoff: float) -> Floats:
    """Returns unit quaternions (F, …, 4) without what turns faster than `cutoff` Hz.

    Signs are made continuous first; the components are filtered and brought to unit length, which for the
    small turns between two samples is the filter in the space of rotation vectors.
    """
    return quat.normalize(low_pass(continuous(np.asarray(turns, np.float64)), rate, cutoff))


def continuous(turns: Floats) -> Floats:
    """Returns rotations (F, …, 4) with the sign of each nearest to the one before: the short way round."""
    is_flipped = quat.dot(turns[1:], turns[:-1]) < 0
    signs = np.concatenate(
        [np.ones((1, *turns.shape[1:-1])), np.where(np.cumsum(is_flipped, 0) % 2, -1.0, 1.0)]
    )
    aligned: Floats = turns * signs[..., None]
    return aligned


def without_spikes(values: Floats, times_deviation: float = 4.0) -> Floats:
    """Returns values (F, n) with single wild samples replaced by the line between their neighbours.

    A sample is a spike if it is further from the median of 7 samples around it than `times_deviation` times
    the usual distance (1.4826 × the median of the distances of that window, Hampel), and than a thousandth
    of the whole range.
    """
    return _bridged(np.asarray(values, np.float64), _spikes(np.asarray(values, np.float64), times_deviation))


def without_rotation_spikes(turns: Floats, times_deviation: float = 4.0) -> Floats:
    """Returns unit quaternions (F, 4) with single wild samples replaced by the short way between their
    neighbours.
    """
    exact = continuous(np.asarray(turns, np.float64))
    spikes = _spikes(exact, times_deviation)
    if not spikes.any() or spikes.all():
        return exact
    kept = np.flatnonzero(~spikes)
    smooth = continuous(exact[kept])  # a spike may have flipped the signs of all that follow it
    return quat.normalize(_interpolated(len(exact), kept, smooth))


def _spikes(values: Floats, times_deviation: float) -> Bools:
    """Returns (F,) whether a sample is a spike."""
    if len(values) < SPIKE_WINDOW:
        return np.zeros(len(values), bool)
    half = SPIKE_WINDOW // 2
    padded = np.pad(values, ((half, half), (0, 0)), mode="reflect")
    windows = np.lib.stride_tricks.sliding_window_view(padded, SPIKE_WINDOW, axis=0)
    medians = np.median(windows, -1)
    away = np.sqrt(((values - medians) ** 2).sum(-1))
    spread = np.median(np.sqrt(((windows - medians[..., None]) ** 2).sum(1)), -1)
    floor = 1e-3 * np.sqrt((np.ptp(values, axis=0) ** 2).sum())
    spikes: Bools = away > np.maximum(times_deviation * MEDIAN_TO_DEVIATION * spread, floor)
    return spikes


def _bridged(values: Floats, spikes: Bools) -> Floats:
    if not spikes.any() or spikes.all():
        return values
    kept = np.flatnonzero(~spikes)
    return _interpolated(len(values), kept, values[kept])


def _interpolated(count: int, kept: np.ndarray, values: Floats) -> Floats:
    """Returns rows 0 … count − 1, linear between the rows `kept`; the ends hold."""
    rows = np.arange(count)
    return np.stack([np.interp(rows, kept, column) for column in values.T], -1)

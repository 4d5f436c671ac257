"""Arrays made by `locked` and `writable` are exactly what kernels typed by `columns` take, on each side."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
import pytest
from late_kernel import late_kernel
from numpy.typing import NDArray
from statwalk.maths.columns import columns, locked, writable
from statwalk.maths.compiling import LONG


class Poses(NamedTuple):
    values: Annotated[NDArray[np.float32], "block, channel, lane"]


class Motions(NamedTuple):
    duration: Annotated[NDArray[np.float64], "state"]
    first_key: Annotated[NDArray[np.int32], "state, channel"]
    is_loop: Annotated[NDArray[np.bool_], "state"]
    poses: Poses
    count: int


class Wrong(NamedTuple):
    duration: NDArray[np.float64]


@late_kernel(columns(Motions, readonly=True), columns(Motions), returns=LONG)
def moved(tables, state):
    """Writes one number of each array of the state, and adds up some of the tables."""
    state.duration[1] = 2.5
    state.poses.values[1, 2, 15] = 7
    return tables.first_key[1, 2] + tables.is_loop[0] + tables.count


def motions(poses=None):
    """Lists and other kinds of numbers, Fortran order, a view with steps: nothing that a kernel takes as it
    is.
    """
    keys = np.asfortranarray(np.arange(6, dtype=np.int64).reshape(2, 3))
    return Motions(
        [1, 2],
        keys,
        np.array([1, 0, 1, 0])[::2],
        Poses(np.zeros((2, 3, 32))[..., ::2]) if poses is None else poses,
        10,
    )


def test_a_kernel_takes_what_was_made_for_it():
    state = writable(motions())
    assert moved(locked(motions()), state) == 5 + 1 + 10
    assert (state.duration.tolist(), state.poses.values[1, 2, 15]) == ([1, 2.5], 7)


def test_a_kernel_writes_no_locked_table():
    with pytest.raises(TypeError, match="readonly"):
        moved(locked(motions()), locked(motions()))


@pytest.mark.parametrize(("made", "is_writable"), [(locked, False), (writable, True)])
def test_arrays_are_copies_contiguous_and_on_a_cache_line(made, is_writable):
    source = motions()
    for array in (*made(source)[:3], made(source).poses.values, made(source.first_key)):
        assert (array.flags.c_contiguous, array.flags.writeable, array.ctypes.data % 64) == (
            True,
            is_writable,
            0,
        )
        assert not np.shares_memory(array, source.first_key)


def test_empty_arrays_keep_their_axes():
    made = locked(Motions([], np.zeros((0, 3)), [], Poses(np.zeros((0, 3, 16))), 0))
    assert (made.first_key.shape, made.first_key.dtype, made.poses.values.shape) == (
        (0, 3),
        np.int32,
        (0, 3, 16),
    )


def test_a_wrong_number_of_axes_is_named():
    with pytest.raises(ValueError, match=r"Poses.values has 2 axes, not 3"):
        locked(motions(Poses(np.zeros((3, 16)))))


def test_a_field_without_axes_is_named():
    with pytest.raises(TypeError, match=r"Wrong.duration is .*Annotated"):
        columns(Wrong)

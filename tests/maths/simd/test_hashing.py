"""Hashes of rows of any type against the same in Python's own integers; every bit counts, and where it
stands.
"""

from typing import NamedTuple

import numpy as np
import pytest
from late_kernel import late_kernel
from numba import types
from statwalk.maths.compiling import write
from statwalk.maths.random import scrambled
from statwalk.maths.simd.hashing import hash_rows, hash_span

WORD = (1 << 64) - 1
RNG = np.random.default_rng(6)


class Columns(NamedTuple):
    state: np.ndarray
    time: np.ndarray
    waiting: np.ndarray
    held: np.ndarray
    goal: np.ndarray
    nothing: np.ndarray
    share: np.ndarray


REAL = types.float64
KINDS = (
    (types.int16, 2),
    (REAL, 2),
    (types.int64, 3),
    (types.boolean, 3),
    (types.uint8, 1),
    (REAL, 2),
    (types.float32, 2),
)
COLUMNS = types.BaseTuple.from_types([write(*kind) for kind in KINDS], Columns)


@late_kernel(write(types.uint64, 1), COLUMNS)
def hashed(hashes, columns):
    for row in range(hashes.shape[0]):
        hashes[row] = scrambled(hash_rows(hashes[row], columns, row))


@late_kernel(write(types.uint64, 1), write(types.int64, 3), types.int64, types.int64)
def spanned(hashes, array, first, count):
    hashes[0] = hash_span(hashes[0], array, first, count)


def columns(count=6):
    return Columns(
        RNG.integers(-5, 11, (count, 2)).astype(np.int16),
        RNG.normal(size=(count, 3)),
        RNG.integers(-(1 << 62), 1 << 62, (count, 2, 4)),
        RNG.integers(0, 2, (count, 2, 3)).astype(bool),
        RNG.integers(0, 256, count).astype(np.uint8),
        np.zeros((count, 0)),
        RNG.normal(size=(count, 2)).astype(np.float32),
    )


def hashes_of(values):
    out = np.arange(len(values.state), dtype=np.uint64)
    hashed(out, values)
    return out


def in_python(row, values):
    word = row
    for array in values:
        flat = np.ascontiguousarray(array[row]).reshape(-1)
        bits = flat.view(f"u{flat.itemsize}") if flat.dtype.kind == "f" else flat.astype(np.int64)
        for number in bits.tolist():
            word ^= number & WORD
            word = (((word << 29) | (word >> 35)) & WORD) * 0x9E3779B97F4A7C15 & WORD
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB), (31, 1)):
        word = (word ^ (word >> shift)) * factor & WORD
    return word


def test_rows_of_any_type_are_hashed_as_whole_numbers_say():
    values = columns()
    assert hashes_of(values).tolist() == [in_python(row, values) for row in range(6)]


@pytest.mark.parametrize("name", ["state", "time", "waiting", "goal", "share"])
def test_every_bit_of_a_row_counts_and_of_no_other_row(name):
    values = columns()
    before = hashes_of(values)
    array = getattr(values, name)
    bits = array[3:4].reshape(-1)[-1:].view(np.uint8)
    for bit in range(8 * len(bits)):
        bits[bit // 8] ^= 1 << bit % 8
        assert np.flatnonzero(hashes_of(values) != before).tolist() == [3]
        bits[bit // 8] ^= 1 << bit % 8


def test_only_the_places_of_a_span_count():
    array, found = RNG.integers(0, 9, (2, 2, 4)), []
    for changed in (None, 4, 6, 7):
        other, out = array.copy(), np.zeros(1, np.uint64)
        if changed is not None:
            other.reshape(-1)[changed] += 1
        spanned(out, other, 4, 3)
        found.append(int(out[0]))
    assert [found[0] == each for each in found] == [True, False, False, True]

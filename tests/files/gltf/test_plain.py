"""A reader finds an unusable number wherever it is."""

import numpy as np
import pytest
from statwalk.files.gltf import plain

CHANCE = np.random.default_rng(3)


def with_one(values, row, value):
    changed = values.copy()
    changed[row] = value
    return changed


@pytest.mark.parametrize("count", [1, 15, 16, 33, 100_000])
@pytest.mark.parametrize("value", [np.nan, np.inf, -np.inf, 2e24, -2e24])
def test_an_unusable_number_is_found(count, value):
    numbers = CHANCE.normal(size=count).astype(np.float32)
    assert plain.is_usable(numbers)
    assert not plain.is_usable(with_one(numbers, count // 2, value))


@pytest.mark.parametrize("value", [1e24, -1e24])
def test_the_largest_number_is_usable(value):
    assert plain.is_usable(np.full(20, value, np.float32))


def test_numbers_need_not_be_aligned():
    room = np.zeros(4 * 40 + 1, np.uint8)[1:].view(np.float32)
    assert not room.flags.aligned
    assert plain.is_usable(room)

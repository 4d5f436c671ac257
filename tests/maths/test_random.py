"""Counter-based random numbers: published words of splitmix64, the same in Python, NumPy and kernels, and the
same alone and in a crowd.
"""

import numpy as np
import pytest
from late_kernel import late_kernel
from numba import types
from statwalk.maths import random
from statwalk.maths.compiling import write

SEED = 1234567
PUBLISHED = (6457827717110365317, 3203168211198807973, 9817491932198370423, 4593380528125082431)
"""the first words after the seed, as in Vigna's splitmix64.c"""
STATES = [(SEED + (place + 1) * random.GOLDEN) & random.WORD for place in range(len(PUBLISHED))]


COUNTERS = np.array([(1, 0, 1, 0), (2, 0, 1, 0), (1, 1, 1, 0), (1, 0, 2, 0), (1, 0, 1, 1), (0, 1, 1, 0)])


@late_kernel(write(types.uint64, 1))
def mix_all(words):
    for row in range(words.shape[0]):
        words[row] = random.scrambled(int(words[row]))


@late_kernel(types.uint64, write(types.int64, 2), write(types.float64, 1))
def draw_all(key, counters, chances):
    for row in range(counters.shape[0]):
        tick, layer, event, draw = counters[row, 0], counters[row, 1], counters[row, 2], counters[row, 3]
        chances[row] = random.chance(key, tick, layer, event, draw)


def drawn(key):
    chances = np.zeros(len(COUNTERS))
    draw_all(key, COUNTERS, chances)
    return chances.tolist()


@pytest.mark.parametrize("place", range(len(PUBLISHED)))
def test_whole_numbers_are_mixed_as_published(place):
    assert random.splitmix64(STATES[place]) == PUBLISHED[place]


def test_arrays_are_mixed_as_published():
    assert random.splitmix64(np.array(STATES, np.uint64)).tolist() == list(PUBLISHED)


def test_kernels_mix_as_published():
    words = np.array(STATES, np.uint64)
    mix_all(words)
    assert words.tolist() == list(PUBLISHED)


@pytest.mark.parametrize("key", [7, random.WORD])
def test_a_chance_counts_in_words_of_splitmix64(key):
    for counters, chance in zip(COUNTERS.tolist(), drawn(key), strict=True):
        word = random.splitmix64(key)
        for counter in counters:
            word = random.splitmix64((word + (counter + 1) * random.GOLDEN) & random.WORD)
        assert chance == (word >> 11) / 2**53


def test_a_chance_differs_with_the_key_and_with_each_counter():
    assert len({*drawn(7), *drawn(8)}) == 2 * len(COUNTERS)


def test_the_key_of_an_actor_is_its_own_in_every_crowd():
    ids = np.arange(1, 2000)
    assert random.actor_keys(7, ids[500:501]) == random.actor_keys(7, ids)[500]


def test_neighbours_and_neighbouring_seeds_share_no_key():
    keys = np.concatenate([random.actor_keys(seed, np.arange(1, 500)) for seed in (0, 1, 2, -1)])
    assert len(set(keys.tolist())) == len(keys)


def test_signed_chances_fill_the_range_evenly():
    chances = random.signed_chances(random.actor_keys(3, np.arange(4000)), 9, 3)
    assert chances.shape == (4000, 3)
    assert np.histogram(chances, 8, (-1, 1))[0] == pytest.approx(1500, rel=0.1)

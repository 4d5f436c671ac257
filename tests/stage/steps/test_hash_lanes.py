"""Hashes of poses and offsets: the same alone and in a crowd, half of the bits change for any bit, empty
lanes count for nothing.
"""

import numpy as np
import pytest
from crowds import ACTORS, JOINTS, REST, WEIGHTS, lived
from lane_kernels import rehash
from statwalk.maths.pose_buffer import PoseBuffer

USED = 10 * JOINTS + WEIGHTS


def hashes_of(crowd, start=None, used=USED):
    out = (
        np.arange(1, crowd.shown.count + 1, dtype=np.uint64) * np.uint64(0x12345678901)
        if start is None
        else start.copy()
    )
    rehash(out, crowd.shown.values, used, crowd.offsets, crowd.scratch)
    return out


@pytest.fixture(scope="module")
def crowd():
    return lived(np.arange(ACTORS))


def in_python(word, floats):
    """Of an actor without offsets, in Python's own integers."""

    def stir(halves, value):
        steps = ((15, 0x9E3779B1), (11, 0x85EBCA77))
        mixed = [half ^ value for half in halves]
        return [
            ((m << r | m >> 32 - r) & 0xFFFFFFFF) * f & 0xFFFFFFFF
            for m, (r, f) in zip(mixed, steps, strict=True)
        ]

    words = floats.view(np.uint32).tolist()
    even = [word & 0xFFFFFFFF, word >> 32]
    odd = even[::-1]
    for value in words[0::2]:
        even = stir(even, value)
    for value in words[1::2]:
        odd = stir(odd, value)
    low, high = stir(stir(even, odd[0]), odd[1])
    word, last = high << 32 | low, (1 << 64) - 1
    for shift, factor in ((30, 0xBF58476D1CE4E5B9), (27, 0x94D049BB133111EB), (31, 1)):
        word = (word ^ (word >> shift)) * factor & last
    return word


@pytest.mark.parametrize("used", [USED, USED - 1])
def test_poses_are_hashed_as_whole_numbers_say(crowd, used):
    quiet = np.flatnonzero(~crowd.offsets.is_under_way.any(1)).tolist()
    start = np.random.default_rng(1).integers(0, 1 << 63, ACTORS).astype(np.uint64)
    found = hashes_of(crowd, start, used)
    assert quiet
    assert [int(found[row]) for row in quiet] == [
        in_python(int(start[row]), crowd.shown.rows()[row, :used]) for row in quiet
    ]


def test_each_bit_of_a_pose_changes_half_the_bits(crowd):
    before, changes = hashes_of(crowd), []
    words = crowd.shown.values.view(np.uint32)
    for channel in range(USED):
        for bit in range(0, 32, 5):
            words[1, channel, 3] ^= np.uint32(1 << bit)
            after = hashes_of(crowd)
            words[1, channel, 3] ^= np.uint32(1 << bit)
            assert np.flatnonzero(after != before).tolist() == [19]
            changes.append(int(before[19] ^ after[19]).bit_count())
    assert 31 < np.mean(changes) < 33
    assert min(changes) > 10


def test_two_signs_that_change_do_not_cancel(crowd):
    """The topmost bits of two channels are what sums and products lose first."""
    before = hashes_of(crowd)
    for other in range(1, USED):
        for channel in (0, other):
            crowd.shown.values[0, channel, 2] *= -1
        after = hashes_of(crowd)
        for channel in (0, other):
            crowd.shown.values[0, channel, 2] *= -1
        assert before[2] != after[2]


def test_the_place_of_a_number_counts(crowd):
    before, values = hashes_of(crowd), crowd.shown.values
    values[0, [4, 5], 2] = values[0, [5, 4], 2]
    after = hashes_of(crowd)
    values[0, [4, 5], 2] = values[0, [5, 4], 2]
    assert before[2] != after[2]


def test_it_runs_on_from_what_was(crowd):
    assert (
        len(
            {
                int(hashes_of(crowd, np.full(ACTORS, start, np.uint64))[0])
                for start in (0, 1, 1 << 32, 1 << 63)
            }
        )
        == 4
    )


def test_offsets_under_way_count_and_what_is_left_in_a_lane_does_not(crowd):
    under_way = crowd.offsets.is_under_way
    row, layer = np.argwhere(under_way)[0]
    block, lane, slot = row // 16, row % 16, crowd.offsets.slot[row // 16, layer]
    before = hashes_of(crowd)
    for array in (crowd.offsets.start, crowd.offsets.rate):
        kept = array[slot, 5, lane]
        array[slot, 5, lane] += 1
        assert np.flatnonzero(hashes_of(crowd) != before).tolist() == [row]
        array[slot, 5, lane] = kept
    others = [
        other
        for other in range(16)
        if 16 * block + other < ACTORS and not under_way[16 * block + other, layer]
    ]
    crowd.offsets.start[slot, :, others] = 77
    assert (hashes_of(crowd) == before).all()


def test_what_fills_empty_lanes_and_channels_counts_for_nothing(crowd):
    before = hashes_of(crowd)
    crowd.shown.values[1, :, ACTORS - 16 :] = 5
    crowd.shown.values[:, USED:] = 7
    assert (hashes_of(crowd) == before).all()


@pytest.mark.parametrize("rows", [[18], [3, 18, 7], list(range(20, -1, -1))])
def test_an_actor_hashes_alike_alone_and_in_a_crowd(rows):
    crowd, own = lived(np.arange(ACTORS)), lived(np.array(rows))
    start = np.arange(ACTORS, dtype=np.uint64)
    assert hashes_of(own, start[rows]).tolist() == hashes_of(crowd, start)[rows].tolist()


def test_one_actor_at_rest_is_a_block_of_its_own():
    crowd = lived(np.array([0]), ticks=0)
    crowd.shown = PoseBuffer.at_rest(REST, 1)
    assert hashes_of(crowd).tolist() == [in_python(0x12345678901, crowd.shown.rows()[0])]

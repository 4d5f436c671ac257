"""Hashes: exact, the same alone and in a crowd, different for every difference."""

import numpy as np
from statwalk.stage.state.hashing import combine, mix, text

RNG = np.random.default_rng(2)
POSES = RNG.normal(size=(50, 30, 4)).astype(np.float32)
STATES = RNG.integers(0, 11, size=(50, 1)).astype(np.int16)


def test_one_row_hashes_alike_alone_and_in_a_crowd():
    crowd = mix(np.arange(50, dtype=np.uint64), [POSES, STATES])
    alone = mix(np.array([17], np.uint64), [POSES[17:18], STATES[17:18]])
    assert alone[0] == crowd[17]


def test_every_bit_counts():
    other = POSES.copy()
    other[3, 29, 3] = np.nextafter(other[3, 29, 3], np.float32(9))
    before = np.zeros(50, np.uint64)
    assert np.flatnonzero(mix(before, [POSES]) != mix(before, [other])).tolist() == [3]


def test_two_joints_that_change_places_are_noticed():
    before = np.zeros(50, np.uint64)
    assert (mix(before, [POSES]) != mix(before, [POSES[:, ::-1]])).all()


def test_it_runs_on_from_what_was():
    assert mix(np.array([1], np.uint64), [POSES[:1]]) != mix(np.array([2], np.uint64), [POSES[:1]])


def test_no_two_of_a_thousand_neighbours_meet():
    words = np.arange(1000, dtype=np.int64)[:, None]
    assert len(set(mix(np.zeros(1000, np.uint64), [words]).tolist())) == 1000


def test_order_counts_when_hashes_are_combined():
    assert combine([1, 2]) != combine([2, 1])


def test_text_has_sixteen_digits():
    assert text(255) == "00000000000000ff"

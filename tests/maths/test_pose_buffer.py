"""The buffer of a crowd's poses: what goes in comes out, whatever the number of actors, and empty lanes
rest.
"""

import numpy as np
import pytest
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer

REST = rest(3, 2)


def poses(count, seed=0):
    chance = np.random.default_rng(seed)
    return Pose(*(chance.normal(size=(count, *array.shape)).astype(np.float32) for array in REST))


def equal(one, other):
    return all((a == b).all() for a, b in zip(one, other, strict=True))


@pytest.mark.parametrize("count", [1, 15, 16, 17, 40])
def test_poses_that_are_put_come_out_again(count):
    assert equal(PoseBuffer.of(REST, poses(count)).poses(), poses(count))


def test_an_actor_is_one_row():
    assert equal(PoseBuffer.of(REST, poses(20)).actor(17), poses(20).take(17))


def test_taken_rows_keep_their_order():
    rows = np.array([19, 3, 3])
    assert equal(PoseBuffer.of(REST, poses(20)).take(rows).poses(), poses(20).take(rows))


def test_appended_actors_follow():
    both = PoseBuffer.of(REST, poses(5)).append(PoseBuffer.of(REST, poses(14, 1)))
    assert equal(both.poses(), Pose(*map(np.concatenate, zip(poses(5), poses(14, 1), strict=True))))


def test_lanes_without_an_actor_hold_the_rest_pose():
    buffer = PoseBuffer.of(REST, poses(17))
    buffer.count = 32
    assert equal(buffer.actor(31), REST)


def test_blocks_lie_at_multiples_of_a_cache_line():
    assert all(PoseBuffer.at_rest(REST, count).values.ctypes.data % 64 == 0 for count in range(1, 40))


def test_rows_hold_every_number_and_nothing_else():
    rows = PoseBuffer.of(REST, poses(17)).rows()
    assert rows.shape == (17, 32)
    assert equal(PoseBuffer.of_rows(REST, rows).poses(), poses(17))

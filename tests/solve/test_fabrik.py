"""FABRIK: the distance that it reports is that of its pose, also where joints have been drawn into one point;
alone and in a crowd the bits are the same.
"""

import numpy as np
import pytest
from statwalk.maths import quat
from statwalk.maths.clamp_table import clamp_table
from statwalk.maths.pose import Pose, rest
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.solve.chains import Chain
from statwalk.solve.solve_poses import Goal, solve_poses

CHAINS = 2000
ALL = np.arange(CHAINS)


def goals(joints: int, nearest: float, farthest: float) -> np.ndarray:
    """Places between two distances from the start, as parts of the chain's length."""
    chance = np.random.default_rng(joints)
    way = chance.normal(size=(CHAINS, 3))
    way /= np.linalg.norm(way, axis=1, keepdims=True)
    return way * chance.uniform(nearest, farthest, (CHAINS, 1)) * (joints - 1)


def solved(
    goal: np.ndarray, joints: int, iterations: int, rows: np.ndarray = ALL
) -> tuple[np.ndarray, np.ndarray]:
    """The rotations and the reported distances of some chains of bones of a metre, bent at random."""
    chance, straight = np.random.default_rng(1), rest(joints)
    straight.translation[1:, 1] = 1
    parts = [np.repeat(part[None], len(rows), 0) for part in straight]
    bent = chance.normal(size=(CHAINS, joints, 4)) * 0.4 + (0, 0, 0, 1)
    parts[1] = quat.normalize(bent)[rows].astype(np.float32)
    buffer = PoseBuffer.of(rest(joints), Pose(*parts))
    chain = Chain("fabrik", tuple(range(joints)), iterations=iterations)
    wish = Goal(goal[rows], np.array(1.0), np.array([0.0, 0, -1]), np.array([0.0, 0, 0, 1]))
    above = np.arange(-1, joints - 1, dtype=np.int32)
    found = solve_poses(buffer, above, clamp_table({}, rest(joints)), chain, wish)
    return buffer.poses().rotation.astype(float), found.distance.astype(float)


@pytest.mark.parametrize("joints", [3, 10])
@pytest.mark.parametrize("iterations", [1, 10])
@pytest.mark.parametrize("span", [(0, 1e-6), (0, 1), (1, 1), (1.2, 2)])
def test_the_reported_distance_is_that_of_the_pose(
    joints: int, iterations: int, span: tuple[float, float]
) -> None:
    goal = goals(joints, *span)
    rotations, distance = solved(goal, joints, iterations)
    end, turn = np.zeros_like(goal), np.tile((0.0, 0, 0, 1), (CHAINS, 1))
    for place in range(joints - 1):
        turn = quat.mul(turn, rotations[:, place])
        end = end + quat.rotate(turn, np.tile((0.0, 1, 0), (CHAINS, 1)))
    np.testing.assert_allclose(distance, np.linalg.norm(end - goal, axis=1), atol=5e-5)


@pytest.mark.parametrize("iterations", [1, 10])
@pytest.mark.parametrize("rows", [ALL[::-1], np.roll(ALL, 8), ALL[-1:], ALL[-17:]])
def test_beside_other_chains_the_same_bits(rows: np.ndarray, iterations: int) -> None:
    goal = goals(10, 0, 1)
    crowd, _ = solved(goal, 10, iterations)
    others, _ = solved(goal, 10, iterations, rows)
    assert others.tobytes() == crowd[rows].tobytes()

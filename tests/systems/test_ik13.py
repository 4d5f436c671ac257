"""IK13 the force solver (RTCA 2.4 `solvejoint`): one step against the formula, travel, and all cases."""

import ik_cases
import numpy as np
import pytest
from ik_chains import points, random_poses, solved, turns
from paths import needs_assets
from scipy.spatial.transform import Rotation

POSES = random_poses(40, 4, 29)
WHOLE = np.linalg.norm(np.diff(points(POSES)[:, 1:], axis=1), axis=-1).sum(1)
AIM = Rotation.random(40, np.random.default_rng(4)).apply([0, 0, 1])
TARGETS = points(POSES)[:, 1] + AIM * (WHOLE * np.linspace(0.1, 0.9, 40))[:, None]
MOST_STEPS = 2000


def step_of_the_paper(poses, row, target, gain):
    """One step in float64, from the end back to the start, for each axis: `angle = |F| · sin∠(A,F) ·
    sin∠(B,F) · sign((A×B)·F)`, with |F| in lengths of the chain, at most 1, and the gain shared by the bones.
    """
    places, axes = points(poses)[row], turns(poses)[row]
    axes = axes / np.linalg.norm(axes, axis=-2, keepdims=True)
    whole = np.linalg.norm(np.diff(places[1:], axis=0), axis=1).sum()
    for joint in range(len(places) - 2, 0, -1):
        for axis in range(3):
            a, b, f = axes[joint][:, axis], places[joint + 1] - places[joint], target - places[-1]
            size = min(np.linalg.norm(f) / whole, 1)
            b, f = b / np.linalg.norm(b), f / np.linalg.norm(f)
            sines = np.linalg.norm(np.cross(a, f)) * np.linalg.norm(np.cross(b, f))
            angle = min(size * sines * gain / (len(places) - 2), 0.25) * np.sign(np.cross(a, b) @ f)
            # an angle small enough: the tangent of its half for its half, as the solver's turns have it
            turn = Rotation.from_rotvec(a * 2 * np.arctan(angle / 2))
            places[joint + 1 :] = places[joint] + turn.apply(places[joint + 1 :] - places[joint])
            axes[joint:] = turn.as_matrix() @ axes[joint:]
    return places


def test_a_step_is_that_of_the_paper():
    after = points(solved(POSES, TARGETS, "force", iterations=1)[0])
    before = points(POSES)
    far = np.linalg.norm(before[:, -1] - TARGETS, axis=1)
    compared = 0
    for row in range(len(TARGETS)):
        expected = step_of_the_paper(POSES, row, TARGETS[row], gain=1.0)
        if np.linalg.norm(expected[-1] - TARGETS[row]) < far[row]:  # otherwise the pose before is better
            np.testing.assert_allclose(after[row, 1:], expected[1:], atol=3e-5)
            compared += 1
    assert compared > 30


def test_the_effector_travels_and_does_not_snap():
    places = [points(solved(POSES, TARGETS, "force", iterations=steps)[0])[:, -1] for steps in range(1, 12)]
    assert (np.linalg.norm(np.diff(places, axis=0), axis=-1) / WHOLE).max() < 0.5
    far = np.linalg.norm(places - TARGETS, axis=-1)
    assert (np.diff(far, axis=0) <= 1e-5).all()


@pytest.mark.parametrize("times", [1.0, 1.5, 1000.0])
def test_out_of_reach_it_points_at_the_target(times):
    start = points(POSES)[:, 1]
    whole = WHOLE[:, None]
    after = points(solved(POSES, start + AIM * whole * times, "force", iterations=MOST_STEPS)[0])
    np.testing.assert_allclose((after[:, -1] - start) / whole, AIM, atol=5e-4)


@needs_assets
def test_all_cases():
    faults, most = ik_cases.judged("force")
    assert faults == []
    print(most)

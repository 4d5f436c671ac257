"""Two-bone IK: the target is reached, the bones keep their lengths, the knee is on its side."""

import numpy as np
import pytest
from ik_chains import points, random_poses, solved, straight_pose
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import Pose
from statwalk.solve.chains import POLE_DIRECTION, POLE_POINT

ACTORS = 500
POSES = random_poses(ACTORS, 3, 17)
PLACES = points(POSES)
ROOT, MID, END = (PLACES[:, joint] for joint in (1, 2, 3))
CHANCE = np.random.default_rng(3)
POLE, AIM = CHANCE.normal(size=(2, ACTORS, 3))
AIM /= np.linalg.norm(AIM, axis=1, keepdims=True)
UPPER, LOWER = np.linalg.norm(MID - ROOT, axis=1), np.linalg.norm(END - MID, axis=1)
NEAREST, FURTHEST = np.abs(UPPER - LOWER), UPPER + LOWER
WITHIN = ROOT + AIM * (NEAREST + (FURTHEST - NEAREST) * CHANCE.uniform(0.05, 0.95, ACTORS))[:, None]
LIMB = straight_pose(3)  # hip at the origin, knee at (0, 1, 0), ankle at (0, 2, 0)


def places(target, poses=POSES, **options):
    """Start, middle and end afterwards."""
    return points(solved(poses, target, **options)[0])[:, 1:].transpose(1, 0, 2)


def bent(degrees):
    """The limb with its knee bent about X."""
    pose = LIMB.copy()
    pose.rotation[0, 2] = Rotation.from_euler("x", degrees, degrees=True).as_quat()
    return pose


def test_reaches_the_target():
    np.testing.assert_allclose(places(WITHIN, pole=POLE, pole_kind=POLE_DIRECTION)[2], WITHIN, atol=1e-5)


def test_tells_the_remaining_distance():
    _, outcome = solved(POSES, ROOT + AIM * FURTHEST[:, None] * 1.5)
    np.testing.assert_allclose(outcome.distance, FURTHEST * 0.5, atol=2e-5)


def test_bones_keep_their_lengths():
    _, mid, end = places(WITHIN)
    np.testing.assert_allclose(np.linalg.norm(mid - ROOT, axis=1), UPPER, atol=5e-6)
    np.testing.assert_allclose(np.linalg.norm(end - mid, axis=1), LOWER, atol=5e-6)


def test_the_knee_is_on_the_side_of_the_pole():
    mid = places(WITHIN, pole=POLE, pole_kind=POLE_DIRECTION)[1]
    aside = POLE - AIM * (POLE * AIM).sum(1, keepdims=True)
    assert ((mid - ROOT) * aside).sum(1).min() > 0


def test_a_pole_can_be_a_point():
    options = {"pole_kind": POLE_POINT}
    np.testing.assert_allclose(
        places(WITHIN, pole=ROOT + POLE, **options),
        places(WITHIN, pole=POLE, pole_kind=POLE_DIRECTION),
        atol=2e-5,
    )


def test_without_a_pole_the_knee_stays_in_its_plane():
    mid = places(WITHIN)[1]
    aside = (MID - ROOT) - AIM * ((MID - ROOT) * AIM).sum(1, keepdims=True)
    np.testing.assert_allclose(np.cross(mid - ROOT, AIM) @ np.zeros(3), 0)
    assert ((mid - ROOT) * aside).sum(1).min() > 0


@pytest.mark.parametrize("times", [1.0, 1.5, 100.0, 1e6])
def test_out_of_reach_it_points_at_the_target(times):
    _, mid, end = places(ROOT + AIM * FURTHEST[:, None] * times)
    np.testing.assert_allclose(end, ROOT + AIM * FURTHEST[:, None], atol=1e-5)
    np.testing.assert_allclose(mid, ROOT + AIM * UPPER[:, None], atol=5e-3)


def test_too_near_it_folds_towards_the_target():
    end = places(ROOT + AIM * NEAREST[:, None] * 0.5)[2]
    np.testing.assert_allclose(end, ROOT + AIM * NEAREST[:, None], atol=1e-4)


def test_a_right_angle_worked_out_by_hand():
    poses, _ = solved(LIMB, (0, 1, 1), pole=(0, 0, 1), pole_kind=POLE_DIRECTION)
    np.testing.assert_allclose(points(poses)[0, 1:], [[0, 0, 0], [0, 0, 1], [0, 1, 1]], atol=1e-6)
    np.testing.assert_allclose(
        np.abs((poses.rotation[0, 1] * Rotation.from_euler("x", 90, degrees=True).as_quat()).sum()),
        1,
        atol=1e-6,
    )


def test_the_plane_of_the_limb_turns_with_it():
    """The knee bends about the same axis of the thigh before and after."""
    before = bent(40)
    after, _ = solved(before, (1.2, 0.4, -0.3))
    axis = Rotation.from_quat(after.rotation[0, 2]).as_rotvec()
    np.testing.assert_allclose(np.cross(axis, [1, 0, 0]), 0, atol=1e-5)
    assert axis[0] > 0


def test_at_the_target_nothing_moves():
    poses, outcome = solved(POSES, END)
    np.testing.assert_allclose(np.abs((poses.rotation * POSES.rotation).sum(-1)), 1, atol=1e-5)
    assert outcome.distance.max() < 1e-5


@pytest.mark.parametrize(
    "target", [[0.0, 0, 0], [0.0, 2, 0], [0.0, 5, 0], [0, -2, 0], [0, -1, 0], [1e-9, 0, 0]]
)
@pytest.mark.parametrize("pole", [[0.0, 0, 0], [0.0, -1, 0], [0.0, 1e-12, 0]])
def test_degenerate_targets_and_poles_give_rotations(target, pole):
    for limb in (LIMB, bent(1e-4), bent(180), bent(179.99)):
        poses, _ = solved(limb, target, pole=pole, pole_kind=POLE_DIRECTION)
        np.testing.assert_allclose(np.linalg.norm(poses.rotation, axis=-1), 1, atol=1e-5)


def test_weight_0_keeps_the_bits_and_half_is_half_way():
    whole, _ = solved(POSES, WITHIN)
    half, _ = solved(POSES, WITHIN, weight=np.where(np.arange(ACTORS) % 2, 0.5, 0.0))
    assert half.rotation[::2].tobytes() == POSES.rotation[::2].tobytes()
    expected = POSES.blend(whole, np.full(ACTORS, 0.5)).rotation[1::2]
    np.testing.assert_allclose(np.abs((half.rotation[1::2] * expected).sum(-1)), 1, atol=1e-5)


def test_softening_eases_towards_full_stretch():
    """1 − 1/(1 + x/4)⁴ of the zone, by hand for x = 0, 1 and 4; out of the zone nothing changes."""
    for distance, expected in ((1.2, 1.2), (1.6, 1.6), (2.0, 2 - 0.4 / 1.25**4), (3.2, 2 - 0.4 / 16)):
        end = places((0.0, 0, distance), bent(30), softening=0.4)[2]
        np.testing.assert_allclose(end, [[0, 0, expected]], atol=1e-5)


def test_the_end_can_be_given_a_rotation():
    poses, _ = solved(bent(30), (0, 1, 1), rotation=(0.6, 0, 0, 0.8), turns_end=True)
    sum_of_turns = Rotation.from_quat(poses.rotation[0, 1])
    for joint in (2, 3):
        sum_of_turns = sum_of_turns * Rotation.from_quat(poses.rotation[0, joint])
    np.testing.assert_allclose(np.abs((sum_of_turns.as_quat() * [0.6, 0, 0, 0.8]).sum()), 1, atol=1e-6)


@pytest.mark.parametrize("rows", [[7], [20, 3, 400], list(range(16, 40))])
def test_alone_and_in_a_crowd_the_same_bits(rows):
    crowd, outcome = solved(POSES, WITHIN)
    alone, alone_outcome = solved(Pose(*(part[rows] for part in POSES)), WITHIN[rows])
    assert alone.rotation.tobytes() == crowd.rotation[rows].tobytes()
    assert alone_outcome.distance.tobytes() == outcome.distance[rows].tobytes()

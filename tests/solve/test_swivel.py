"""A limb turns about the line to its target until its limits allow it, against a search over the circle."""

import numpy as np
import pytest
from ik_chains import points, solved, straight_pose
from statwalk.maths import clamp, quat
from statwalk.maths.clamp_kinds import CONE, EULER, HINGE
from statwalk.maths.clamp_table import JointLimit, clamp_table
from statwalk.maths.pose import Pose, rest
from statwalk.solve.chains import POLE_DIRECTION

LIMBS, WIDE = 640, np.radians(60)
POLE = np.array([0.0, 0, -1])
ROUND = JointLimit(CONE, twist=(-WIDE, WIDE), swing=((-WIDE, WIDE),) * 2)
OVAL = JointLimit(CONE, twist=(-0.7, 0.7), swing=((-0.5, 1.7), (-0.9, 1.0)))
ANGLES = JointLimit(EULER, angles=((-0.5, 1.7), (-0.7, 0.7), (-0.9, 1.0)))
ELBOW = JointLimit(EULER, angles=((0, 2.6), (0, 0), (0, 0)))
KNEE = JointLimit(HINGE, twist=(-2.6, 0), frame=quat.from_axis_angle([0.0, 0, 1], np.pi / 2))
BALL = JointLimit(CONE, twist=(-1.5, 1.5), swing=((-1.4, 1.4),) * 2)


def limbs(count, start, middle):
    """Limbs along +Y from the origin with bones of a metre, turned at their start and middle joint."""
    poses = Pose(*(np.repeat(part, count, 0) for part in straight_pose(3)))
    poses.rotation[:, 1], poses.rotation[:, 2] = start, middle
    return poses


def bent(count):
    return limbs(count, (0, 0, 0, 1), quat.from_axis_angle([1.0, 0, 0], 0.3))


def allowed(limits, chance):
    """Random turns of start and middle joint (N, 2): anywhere within their limits."""
    table = clamp_table(limits, rest(4))
    ends = clamp.clamp_rotation(table, np.arange(2), quat.normalize(chance.normal(size=(LIMBS, 2, 4))))
    part = quat.to_rotation_vector(ends) * np.sqrt(chance.uniform(size=(LIMBS, 2, 1)))
    return clamp.clamp_rotation(table, np.arange(2), quat.from_rotation_vector(part))


def reach(target, limits, poses=None, **options):
    poses = bent(len(target)) if poses is None else poses
    return solved(poses, target, limits=limits, pole=POLE, pole_kind=POLE_DIRECTION, **options)


def targets(limits):
    turns = allowed(limits, np.random.default_rng(4))
    return points(limbs(LIMBS, turns[:, 0], turns[:, 1]))[:, -1]


@pytest.mark.parametrize("middle", [ELBOW, KNEE, BALL], ids=["elbow", "knee", "ball"])
@pytest.mark.parametrize("start", [ROUND, OVAL], ids=["round", "oval"])
def test_what_cones_allow_is_reached_at_once(start, middle):
    limits = {1: start, 2: middle}
    outcome = reach(targets(limits), limits, iterations=1)[1]
    assert np.mean(outcome.distance < 1e-3) > 0.95


def test_what_angles_allow_is_mostly_reached_at_once():
    limits = {1: ANGLES, 2: ELBOW}
    once, outcome = (reach(targets(limits), limits, iterations=count)[1] for count in (1, 16))
    assert np.mean(once.distance < 1e-3) > 0.85
    assert np.mean(outcome.distance < 1e-3) > 0.9


def test_a_limb_stops_where_its_limits_leave_little_to_gain():
    way = np.random.default_rng(6).normal(size=(LIMBS, 3))
    goal = way / np.linalg.norm(way, axis=1, keepdims=True) * np.linspace(0.3, 1.9, LIMBS)[:, None]
    outcome = reach(goal, {1: ROUND, 2: BALL})[1]
    missed = outcome.distance > 0.1
    assert 100 < missed.sum() < LIMBS - 100
    assert outcome.iterations[missed].mean() < 4


def test_limits_hold_wherever_the_limb_turns():
    limits = {1: ROUND, 2: ELBOW}
    poses, _ = reach(targets(limits), limits, iterations=1)
    turns = poses.rotation[:, 1:3].astype(float)
    clamped = clamp.clamp_rotation(clamp_table(limits, rest(4)), np.arange(2), turns)
    assert np.abs(quat.to_rotation_vector(quat.mul(quat.conjugate(clamped), turns))).max() < 1e-4


def nearest_elbow(target):
    """The place of the middle joint nearest to the pole's, of 20,000 on its circle, that ROUND allows."""
    distance = np.linalg.norm(target)
    onward = target / distance
    aside = POLE - onward * (POLE @ onward)
    aside /= np.linalg.norm(aside)
    turn = np.linspace(0, np.pi, 10_000)
    turn = np.stack([turn, -turn], 1).ravel()
    way = np.cos(turn)[:, None] * aside + np.sin(turn)[:, None] * np.cross(onward, aside)
    places = onward * distance / 2 + way * np.sqrt(1 - distance**2 / 4)
    inside = places[:, 1] >= np.cos(WIDE)
    return places[inside.argmax()]


def test_the_elbow_goes_as_near_to_the_pole_as_a_search_finds():
    limits = {1: ROUND, 2: BALL}
    goal = targets(limits)
    poses, _ = reach(goal, limits)
    elbows, expected = points(poses)[:, 2], np.array([nearest_elbow(target) for target in goal])
    apart, is_cut = np.linalg.norm(elbows - expected, axis=1), expected[:, 1] < np.cos(WIDE) + 1e-3
    assert apart[~is_cut].max() < 2e-3
    assert np.quantile(apart[is_cut], 0.9) < 0.02


def test_a_limb_that_its_cone_cuts_follows_its_target_without_jumps():
    way = np.linspace(0, np.pi, 1440)
    goal = np.stack([0.8 + 0.3 * np.cos(way), 0.3 + 0.2 * np.sin(way), 0.6 + 0 * way], -1)
    poses, outcome = reach(goal, {1: ROUND, 2: ELBOW})
    turns = np.abs((poses.rotation[1:, 1:3] * poses.rotation[:-1, 1:3]).sum(-1))
    is_cut = points(poses)[:, 2, 1] < np.cos(WIDE) + 1e-3
    assert is_cut.any()
    assert outcome.distance.max() < 1e-4
    assert np.degrees(2 * np.arccos(np.minimum(turns, 1))).max() < 0.5


@pytest.mark.parametrize("rows", [[7], [20, 3, 400], list(range(16, 40))])
@pytest.mark.parametrize("start", [OVAL, ANGLES], ids=["oval", "angles"])
def test_alone_and_in_a_crowd_the_same_bits(start, rows):
    limits = {1: start, 2: ELBOW}
    goal = targets(limits)
    crowd, _ = reach(goal, limits)
    alone, _ = reach(goal[rows], limits, bent(len(rows)))
    assert alone.rotation.tobytes() == crowd.rotation[rows].tobytes()


def test_within_the_limits_the_limb_is_as_one_without():
    goal = np.random.default_rng(5).normal(size=(LIMBS, 3)) * 0.2 + [0, 1.7, 0.4]
    wide = JointLimit(CONE, twist=(-3.1, 3.1), swing=((-3.1, 3.1),) * 2)
    within, free = (reach(goal, limits)[0] for limits in ({1: wide}, {}))
    np.testing.assert_allclose(within.rotation, free.rotation, atol=2e-6)

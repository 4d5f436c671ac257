"""IK14 chains, weights, limits: limits hold in every iteration; the best pose is kept; names make a chain."""

from dataclasses import replace

import numpy as np
import pytest
import statwalk
from ik_chains import points, random_poses, solved
from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths import clamp, quat
from statwalk.maths.clamp_kinds import CONE, EULER, HINGE
from statwalk.maths.clamp_table import JointLimit, clamp_table
from statwalk.maths.pose import Pose, rest

JOINTS, ACTORS = 6, 50
SOLVERS = ("ccd", "fabrik", "force")
NARROW = JointLimit(CONE, twist=(-0.4, 0.4), swing=((-0.5, 0.5), (-0.3, 0.3)))
HINGED = JointLimit(HINGE, twist=(-1.2, 0.2))
AXES = JointLimit(EULER, angles=((-0.6, 0.3), (-0.2, 0.9), (-0.4, 0.4)))
LIMITS = {
    1: NARROW,
    2: HINGED,
    3: NARROW,
    4: AXES,
    5: JointLimit(CONE, twist=(0, 0), swing=((-1, 1), (-1, 1))),
}
AT_REST = Pose(*(np.repeat(part[None], ACTORS, 0) for part in rest(JOINTS + 1)))
AT_REST.translation[:, 2:] = np.random.default_rng(8).normal(size=(ACTORS, JOINTS - 1, 3))
TARGETS = np.random.default_rng(9).normal(size=(ACTORS, 3)) * 2
RANDOM = random_poses(ACTORS, JOINTS, 31)


def excess(poses):
    """The largest angle, in radians, by which a joint leaves its limits, as NumPy clamps."""
    return turned_back(LIMITS, JOINTS + 1, poses).max()


def turned_back(limits, joints, poses):
    """By how much NumPy turns the limited joints back, radians."""
    table = clamp_table(limits, rest(joints))
    rotation = poses.rotation[:, table.joint].astype(float)
    clamped = clamp.clamp_rotation(table, np.arange(len(table.joint)), rotation)
    return np.linalg.norm(quat.to_rotation_vector(quat.mul(quat.conjugate(clamped), rotation)), axis=-1)


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("iterations", [1, 2, 3, 7, 30])
def test_limits_hold_in_every_iteration(solver, iterations):
    poses, outcome = solved(AT_REST, TARGETS, solver, iterations=iterations, limits=LIMITS)
    assert excess(poses) < 1e-4
    far = np.linalg.norm(points(poses)[:, -1] - TARGETS, axis=1)
    np.testing.assert_allclose(outcome.distance, far, atol=1e-5)
    assert (far < np.linalg.norm(points(AT_REST)[:, -1] - TARGETS, axis=1) + 1e-5).all()


def test_limits_of_a_limb_hold_and_it_still_reaches_what_it_may():
    limits = {1: JointLimit(CONE, twist=(-1, 1), swing=((-1.5, 1.5), (-1.5, 1.5))), 2: HINGED}
    limb = Pose(*(part[:, :4].copy() for part in AT_REST[:3]), AT_REST.weights)
    limb.translation[:, 2:] = 0, 1, 0
    limb.rotation[:, 2] = quat.from_axis_angle([0.0, 1, 0], -0.5)
    allowed = limb.copy()
    chance = np.random.default_rng(2)
    allowed.rotation[:, 1] = quat.from_rotation_vector(chance.uniform(-0.4, 0.4, (ACTORS, 3)))
    poses, outcome = solved(limb, points(allowed)[:, -1], limits=limits, iterations=60)
    assert turned_back(limits, 4, poses).max() < 1e-4
    assert np.median(outcome.distance) < 2e-3


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("limits", [None, LIMITS])
def test_more_iterations_are_never_worse(solver, limits):
    far = [
        solved(AT_REST, TARGETS, solver, iterations=count, limits=limits)[1].distance
        for count in range(1, 20)
    ]
    assert (np.diff(far, axis=0) <= 2e-6).all()


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_joint_of_sensitivity_0_keeps_its_bits_and_half_turns_less(solver):
    def angles(sensitivity):
        poses, _ = solved(RANDOM, TARGETS, solver, iterations=1, sensitivity=sensitivity)
        return 2 * np.arccos(np.minimum(np.abs((poses.rotation * RANDOM.rotation).sum(-1)), 1)), poses

    whole, _ = angles((1.0,) * JOINTS)
    part, poses = angles((1.0, 0.0, 1.0, 0.5, 0.2, 1.0))
    assert poses.rotation[:, 2].tobytes() == RANDOM.rotation[:, 2].tobytes()
    moved = (part.max(1) > 1e-3) & (whole.max(1) > 1e-3)
    assert part[moved, 5].mean() < 0.5 * whole[moved, 5].mean()


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("limits", [None, LIMITS])
def test_alone_and_in_a_crowd_the_same_bits(solver, limits):
    crowd, outcome = solved(AT_REST, TARGETS, solver, limits=limits)
    for row in (0, 17, 49):
        alone, one = solved(Pose(*(part[[row]] for part in AT_REST)), TARGETS[[row]], solver, limits=limits)
        assert alone.rotation.tobytes() == crowd.rotation[[row]].tobytes()
        assert (one.distance[0], one.iterations[0]) == (outcome.distance[row], outcome.iterations[row])


@pytest.mark.parametrize("solver", SOLVERS)
def test_weight_0_keeps_the_bits_and_makes_no_iteration(solver):
    weight = np.where(np.arange(ACTORS) % 3 == 0, 0.0, 1.0)
    poses, outcome = solved(RANDOM, TARGETS, solver, weight=weight)
    whole, _ = solved(RANDOM, TARGETS, solver)
    assert poses.rotation[::3].tobytes() == RANDOM.rotation[::3].tobytes()
    assert (outcome.iterations[::3], outcome.distance[::3]) == (pytest.approx(0), pytest.approx(0))
    assert poses.rotation[1::3].tobytes() == whole.rotation[1::3].tobytes()


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("distance", [0.0, 0.5, 2.5, 4.999, 5.0, 5.001, 1e5])
def test_a_straight_chain_in_line_with_its_target_bends(solver, distance):
    straight = Pose(*(part[:1] for part in AT_REST))
    straight.translation[:, 2:] = 0, 1, 0
    poses, outcome = solved(straight, (0, distance, 0), solver, iterations=3000)
    assert np.isfinite(poses.rotation).all()
    assert outcome.distance[0] == pytest.approx(max(distance - 5, 0), abs=5e-3 * max(1, distance / 5))


def test_the_limits_of_a_character_hold_unless_others_are_given():
    walker = statwalk.load("faq-walker").character
    limited = replace(walker, limits={"Right.lowerarm": JointLimit(HINGE, twist=(0.0, 0.0))})
    elbow, chain = walker.skeleton.index("Right.lowerarm"), ("Right.upperarm", "Right.hand")
    asked = (walker.bind_pose, chain, (-0.3, 1.2, 0.25), "ccd")
    straight, bent = limited.solve(*asked), limited.solve(*asked, limits={})
    np.testing.assert_allclose(straight.pose.rotation[elbow], walker.bind_pose.rotation[elbow], atol=1e-6)
    assert bent.pose.rotation[elbow].tobytes() == walker.solve(*asked).pose.rotation[elbow].tobytes()
    assert (bent.reached, straight.reached) == (True, False)


KNIGHT_LIKE = ("Right.upperarm", "Right.hand")


def test_start_and_end_name_a_chain():
    character = statwalk.load("faq-walker").character
    pose, target = character.bind_pose, (-0.3, 1.2, 0.25)
    two = character.solve(pose, KNIGHT_LIKE, target, "ccd")
    three = character.solve(pose, ("Right.upperarm", "Right.lowerarm", "Right.hand"), target, "ccd")
    assert two.reached
    assert two.pose.rotation.tobytes() == three.pose.rotation.tobytes()


def test_joints_that_a_chain_passes_over_stay():
    character = statwalk.load("faq-walker").character
    names = ("Lowerback", "Right.upperarm", "Right.hand")
    answer = character.solve(character.bind_pose, names, (-0.3, 1.2, 0.25), "fabrik")
    turned = (answer.pose.rotation != character.bind_pose.rotation).any(-1)
    changed = {character.skeleton.names[joint] for joint in np.flatnonzero(turned)}
    assert changed <= {"Lowerback", "Right.upperarm"}
    start = character.world(character.bind_pose)[character.skeleton.index("Right.hand"), :3, 3]
    assert answer.distance < np.linalg.norm(start - (-0.3, 1.2, 0.25))


@pytest.mark.parametrize(
    ("changed", "error", "says"),
    [
        ({"chain": ("Right.hand", "Right.upperarm")}, ContentError, "Right.upperarm is not below Right.hand"),
        ({"chain": ("Right.upperarm", "Left.hand")}, ContentError, "Left.hand is not below"),
        ({"chain": ("Right.hand",)}, ContentError, "needs 2 to 256 joints"),
        ({"chain": ("Arm", "Right.hand")}, UnknownNameError, "Arm"),
        ({"solver": "jacobian"}, UnknownNameError, "two-bone"),
        ({"solver": "two-bone"}, ContentError, "three joints"),
        ({"solver": "two-bone", "chain": ("Right.hand",)}, ContentError, "three joints"),
        ({"target": (0, np.nan, 0)}, ContentError, "target"),
        ({"target": np.zeros((3, 3))}, ContentError, "target"),
        ({"weight": -0.1}, ContentError, "weight"),
        ({"softening": -1}, ContentError, "softening"),
        ({"tolerance": 0}, ContentError, "tolerance"),
        ({"iterations": 10_001}, ContentError, "iterations"),
        ({"iterations": 0}, ContentError, "iterations: 0 is outside 1…10000"),
        ({"sensitivity": {"Head": 0.5}}, UnknownNameError, "Head"),
        ({"sensitivity": {"Right.hand": 1.5}}, ContentError, "Right.hand is 1.5"),
        ({"forward": (0, 0, 0)}, ContentError, "forward"),
        ({"pose": None}, ContentError, "pose: a pose is needed, not NoneType"),
        ({"chain": None}, ContentError, "chain: the name of a chain, or the names of its joints"),
        ({"chain": (1, 2)}, ContentError, "chain: the name of a chain, or the names of its joints"),
        ({"solver": None}, UnknownNameError, "two-bone"),
        ({"iterations": 2.5}, ContentError, "iterations: a whole number is needed, not 2.5"),
        ({"softening": "soft"}, ContentError, "softening: a number is needed, not 'soft'"),
        ({"tolerance": None}, ContentError, "tolerance: a number is needed, not None"),
        ({"sensitivity": [0.5]}, ContentError, "sensitivity: {joint: 0…1} is needed, not list"),
        ({"sensitivity": {"Right.hand": "low"}}, ContentError, "Right.hand is 'low'"),
        ({"anchor": 5}, ContentError, "anchor: the name of a joint is needed, not 5"),
        ({"limits": None}, ContentError, "limits: {joint: limit} is needed, not NoneType"),
        ({"limits": {"Right.hand": 3}}, ContentError, "limits.Right.hand: a JointLimit is needed, not 3"),
    ],
)
def test_a_wrong_chain_is_refused_by_name(changed, error, says):
    character = statwalk.load("faq-walker").character
    right = {
        "pose": character.bind_pose,
        "chain": KNIGHT_LIKE,
        "target": (0, 1, 0),
        "solver": "ccd",
    }
    with pytest.raises(error, match=says):
        character.solve(**right | changed)

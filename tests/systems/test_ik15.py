"""IK15 what users expect today: two-bone, CCD, FABRIK on all cases; CCD against three.js; look-at.

The solver of limbs in detail: `tests/solve/test_two_bone.py`; limits and sensitivities: `test_ik14.py`.
"""

import json
import subprocess

import ik_cases
import khronos
import numpy as np
import pytest
import slow_hierarchy
import statwalk
from ik_chains import points, random_poses, solved, straight_pose, turns
from paths import ASSETS, ROOT, needs_assets
from scipy.spatial.transform import Rotation
from statwalk.maths.clamp_kinds import CONE
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.pose import Pose
from statwalk.solve.chains import SOLVERS

LIMIT = JointLimit(CONE, twist=(-1, 1), swing=((-2, 2), (-2, 2)))
PACKAGES = ROOT / "static" / "node_modules"


@needs_assets
@pytest.mark.parametrize(("solver", "count"), [("two-bone", 3), ("ccd", None), ("fabrik", None)])
def test_all_cases(solver, count):
    faults, most = ik_cases.judged(solver, count)
    assert faults == []
    assert set(most) == {case["kind"] for case in ik_cases.cases()}
    print(solver, most)


@needs_assets
@pytest.mark.parametrize("solver", ["ccd", "fabrik", "force"])
def test_every_target_within_reach_is_reached_with_the_defaults(solver):
    within = [case for case in ik_cases.cases() if case["expect_end_error"] == 0]
    assert len(within) >= 70
    assert [case["target"] for case in within if not ik_cases.answer(case, solver).reached] == []


@pytest.mark.parametrize("iterations", [1, 4])
def test_ccd_turns_each_joint_as_three_js_does(iterations):
    actors, joints = 30, 8
    poses = random_poses(actors, joints, 41)
    poses.scale[:] = 1  # CCDIKSolver knows no scale
    whole = np.linalg.norm(np.diff(points(poses)[:, 1:], axis=1), axis=-1).sum(1)
    aim = Rotation.random(actors, np.random.default_rng(6)).apply([0, 0, 1])
    targets = points(poses)[:, 1] + aim * (0.4 * whole)[:, None]
    given = {
        "translation": poses.translation.tolist(),
        "rotation": poses.rotation.tolist(),
        "target": targets.tolist(),
        "iteration": iterations,
    }
    command = [khronos.node(), ROOT / "tests" / "support" / "threeccd.mjs", PACKAGES]
    run = subprocess.run(command, input=json.dumps(given), capture_output=True, text=True, check=True)
    ours, outcome = solved(poses, targets, "ccd", iterations=iterations, tolerance=1e-9)
    theirs = np.array(json.loads(run.stdout))
    after = points(poses._replace(rotation=theirs.astype(np.float32)))
    better = np.linalg.norm(after[:, -1] - targets, axis=1) < np.linalg.norm(
        points(poses)[:, -1] - targets, axis=1
    )
    alike = np.abs((ours.rotation * theirs).sum(-1))
    np.testing.assert_allclose(alike[better], 1, atol=2e-6)
    assert better.sum() > 20
    assert (outcome.iterations[better] == iterations).all()


def degenerate(poses):
    """Sixteen targets: at the end, at the start, on all joints, at full stretch, a little and far out of
    reach, in line.
    """
    places = points(poses)[0, 1:]
    start, end, whole = places[0], places[-1], np.linalg.norm(np.diff(places, axis=0), axis=1).sum()
    aim = (places[1] - start) / np.linalg.norm(places[1] - start)
    far = [start + aim * whole * times for times in (1, 1 - 1e-7, 1 + 1e-7, 1000, -1, -1e5, 1e-12)]
    middles = [places[1], (places[0] + places[1]) / 2, (start + end) / 2, 2 * end - start, end + 1e-9]
    return np.array([end, start, *far, *middles, start + 1e-6, (0, 0, 0)])


BENT, STRAIGHT = random_poses(1, 3, 61), straight_pose(3)
FOLDED = STRAIGHT._replace(rotation=STRAIGHT.rotation.copy())
FOLDED.rotation[0, 2] = 1, 0, 0, 0


@pytest.mark.parametrize("solver", SOLVERS)
@pytest.mark.parametrize("limits", [{}, {1: LIMIT, 2: LIMIT}], ids=["free", "limited"])
@pytest.mark.parametrize("start", [BENT, STRAIGHT, FOLDED], ids=["bent", "straight", "folded"])
def test_degenerate_targets_are_finite_in_every_lane(solver, limits, start):
    targets, first = degenerate(start), None
    for shift in (0, 5, 11):  # beside other targets, in other lanes
        order = np.roll(np.arange(len(targets)), shift)
        crowd = Pose(*(np.repeat(part, len(targets), 0) for part in start))
        poses, outcome = solved(crowd, targets[order], solver, limits=limits, pole=(0, 0, 1), pole_kind=1)
        np.testing.assert_allclose(np.linalg.norm(poses.rotation, axis=-1), 1, atol=2e-6)
        assert np.isfinite(outcome.distance).all()
        first = first or poses
        assert poses.rotation.tobytes() == first.rotation[order].tobytes()
        if solver != "look-at":
            far = np.linalg.norm(points(poses)[:, -1] - targets[order], axis=1)
            np.testing.assert_allclose(outcome.distance, far, atol=1e-5, rtol=1e-4)
            before = np.linalg.norm(points(crowd)[:, -1] - targets[order], axis=1)
            if not limits:  # a pose beyond its limits is brought inside, and may then be farther
                assert (outcome.distance <= before * (1 + 1e-5) + 5e-5).all()


NECK = random_poses(60, 3, 51, bone=0.1)
FORWARD = (0.0, 0.6, 0.8)


def sight(poses):
    """The line of sight of the last joint: its origin and its unit direction."""
    way = turns(poses)[:, -1] @ FORWARD
    return points(poses)[:, -1], way / np.linalg.norm(way, axis=1, keepdims=True)


def test_look_at_meets_the_target():
    targets = np.random.default_rng(5).normal(size=(60, 3)) * 3
    poses, outcome = solved(NECK, targets, "look-at", forward=FORWARD, iterations=30)
    eye, way = sight(poses)
    passed = np.linalg.norm(np.cross(targets - eye, way), axis=1)
    assert passed.max() < 2e-4
    assert ((targets - eye) * way).sum(1).min() > 0
    np.testing.assert_allclose(outcome.distance, passed, atol=1e-5)


def test_look_at_of_one_joint_needs_one_iteration_and_turns_the_shortest_way():
    head = random_poses(20, 1, 52)
    targets = np.random.default_rng(5).normal(size=(20, 3)) * 3
    (eye, old), (poses, outcome) = sight(head), solved(head, targets, "look-at", forward=FORWARD)
    wanted = (targets - eye) / np.linalg.norm(targets - eye, axis=1, keepdims=True)
    angle = np.arccos((old * wanted).sum(1))
    turned = 2 * np.arccos(np.minimum(np.abs((poses.rotation * head.rotation).sum(-1)[:, 1]), 1))
    np.testing.assert_allclose(turned, angle, atol=2e-3)
    assert set(outcome.iterations) == {1}


def test_look_at_keeps_limits_and_looks_as_far_as_they_allow():
    limits = {
        joint: JointLimit(CONE, twist=(-0.3, 0.3), swing=((-0.2, 0.2), (-0.2, 0.2))) for joint in (1, 2, 3)
    }
    neck = NECK._replace(rotation=np.zeros_like(NECK.rotation) + np.float32([0, 0, 0, 1]))
    targets = np.random.default_rng(5).normal(size=(60, 3)) * 3
    poses, outcome = solved(neck, targets, "look-at", forward=FORWARD, limits=limits)
    angles = 2 * np.arccos(np.minimum(np.abs(poses.rotation[..., 3]), 1))
    assert angles.max() < np.hypot(0.3, 0.2) + 1e-3
    before = solved(neck, targets, "look-at", forward=FORWARD, weight=0.0)[0]
    (eye, way), (old_eye, old_way) = sight(poses), sight(before)
    nearer = ((targets - eye) * way).sum(1) / np.linalg.norm(targets - eye, axis=1)
    assert (
        nearer >= ((targets - old_eye) * old_way).sum(1) / np.linalg.norm(targets - old_eye, axis=1) - 1e-5
    ).all()
    assert np.isfinite(outcome.distance).all()


def test_look_at_the_eye_itself_changes_nothing():
    poses, outcome = solved(NECK, points(NECK)[:, -1], "look-at", forward=FORWARD)
    np.testing.assert_allclose(np.abs((poses.rotation * NECK.rotation).sum(-1)), 1, atol=1e-5)
    assert outcome.distance.max() < 1e-6


def test_poses_of_a_clip_are_solved_together_and_one_by_one_alike():
    character = statwalk.load("faq-walker").character
    poses = character.clips["walk"].sample(np.linspace(0, 0.9, 40))
    names = ("Left.upperleg", "Left.lowerleg", "Left.foot")
    asked = {"target": (0.1, 0.2, 0.1), "pole": (0, 0, 1), "softening": 0.02}
    together = character.solve(poses, names, **asked)
    for row in (0, 21, 39):
        alone = character.solve(poses.take(row), names, **asked)
        assert alone.pose.rotation.tobytes() == together.pose.rotation[row].tobytes()
        assert alone.distance == together.distance[row]


def test_an_answer_prints_on_one_line():
    """The leg is 0.85 m long, its hip a metre up: a target three metres below is out of reach."""
    character = statwalk.load("faq-walker").character
    names = ("Left.upperleg", "Left.lowerleg", "Left.foot")
    answer = character.solve(character.bind_pose, names, target=(0.1, -3, 0))
    assert repr(answer).startswith("SolveAnswer(0 of 1 reached, at most 3.")
    assert "\n" not in repr(answer)


@needs_assets
@pytest.mark.parametrize("solver", ["two-bone", "fabrik", "ccd", "force"])
def test_a_first_script_solves_an_arm(solver):
    """NumPy puts the wrist where the target is; bones keep their lengths."""
    knight = statwalk.load(ASSETS / "gltf" / "KayKit_Knight.glb")
    names, target = ("upperarm.r", "lowerarm.r", "wrist.r"), (-0.2886, 1.2364, 0.35035)
    answer = knight.solve(knight.bind_pose, chain=names, target=target, solver=solver)
    poses = Pose(*(np.asarray(part)[None] for part in answer.pose))
    worlds = slow_hierarchy.worlds(knight.skeleton.parent, poses)[0, :, :3, 3]
    wrist = worlds[knight.skeleton.index("wrist.r")]
    assert answer.reached
    assert np.linalg.norm(wrist - target) == pytest.approx(float(answer.distance), abs=2e-6)
    assert np.linalg.norm(wrist - target) <= 1e-4 + 2e-6

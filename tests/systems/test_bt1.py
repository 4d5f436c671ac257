"""BT1 the tentacle: a closed soft skin of two influences; sway, forward and inverse kinematics; all mixed."""

from itertools import pairwise

import numpy as np
import pytest
import statwalk
from scipy.spatial.transform import Rotation
from statwalk.stage.replay import replay

ROLE = statwalk.load("tentacle")
BODY = ROLE.character
NAMES = list(BODY.skeleton.names)
BONES = [f"b{number}" for number in range(1, 16)]
ROWS = [NAMES.index(bone) for bone in BONES]
TIP = NAMES.index("tip")
HEIGHTS = BODY.world(BODY.bind_pose)[: TIP + 1, 1, 3]
"""of the joints of the straight tentacle: stone, b1 … b15, tip"""
SKINNED = [part for part in BODY.parts if part.skin is not None]
TUBE = SKINNED[0]
TRAVEL_S, REACHED = 0.7, 6.6383521
"""of the machine file; ωt at which a critically damped spring has come within a hundredth"""
OMEGA = REACHED / TRAVEL_S


def placed(events="", **parameters):
    """A stage and its tentacle after these events and two seconds."""
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    for name, value in parameters.items():
        stage.set(actor, name, value)
    for event in events.split():
        stage.send(actor, event)
        stage.step(10)
    stage.step(120)
    return stage, actor


def tip(actor):
    return actor.world[TIP, :3, 3]


def turns(actor):
    """The rotations of the bones."""
    return Rotation.from_quat(actor.pose.rotation[ROWS].astype(float))


def played(stage, actor, ticks, look):
    """What `look` sees before and after each of some ticks."""
    seen = [look(actor)]
    for _ in range(ticks):
        stage.step(1)
        seen.append(look(actor))
    return seen


# the skin


@pytest.mark.parametrize("part", SKINNED, ids=["tube", "suckers"])
def test_each_vertex_has_two_influences_of_neighbouring_bones(part):
    joints = BODY.skins[part.skin].joints[part.joints]
    assert joints.shape == (len(part.positions), 2)
    assert (part.weights > 0).all()
    np.testing.assert_allclose(part.weights.sum(1), 1, atol=1e-6)
    assert (np.abs(np.diff(joints, axis=1)) == 1).all()  # the joints stand in the order of the chain


@pytest.mark.parametrize("part", SKINNED, ids=["tube", "suckers"])
def test_weights_go_over_smoothly_at_each_joint(part):
    """Worked out from the heights of the joints: between the middles of two bones, 3x² − 2x³."""
    beyond = [2 * HEIGHTS[1] - HEIGHTS[2], *HEIGHTS[1:], 2 * HEIGHTS[-1] - HEIGHTS[-2]]
    middles = (np.array(beyond[1:]) + beyond[:-1]) / 2
    joints = BODY.skins[part.skin].joints[part.joints]
    upper = joints.argmax(1)
    rows, height = joints.max(1), part.positions[:, 1]
    x = (height - middles[rows - 1]) / (middles[rows] - middles[rows - 1])
    assert ((x > 0) & (x < 1)).all()
    np.testing.assert_allclose(part.weights[np.arange(len(x)), upper], 3 * x**2 - 2 * x**3, atol=1e-4)


def welded(positions, indices):
    """Triangles between places: points at the same place are one."""
    _, same = np.unique(np.round(positions, 5), axis=0, return_inverse=True)
    faces = same.ravel()[indices.reshape(-1, 3)]
    return faces[(faces != np.roll(faces, 1, axis=1)).all(1)]


def test_the_tube_is_closed():
    faces = welded(TUBE.positions, TUBE.indices)
    edges = np.concatenate([faces[:, [a, (a + 1) % 3]] for a in range(3)])
    there, back = ({tuple(edge) for edge in rows.tolist()} for rows in (edges, edges[:, ::-1]))
    assert len(there) == len(edges)  # each edge once in each direction
    assert there == back
    assert len(np.unique(faces)) - len(edges) // 2 + len(faces) == 2  # Euler: a ball


def face_normals(part):
    corners = part.positions[TUBE.indices.reshape(-1, 3)].astype(float)
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-12)


def girths(part):
    """The length of each ring of the tube around the bones."""
    rings = part.positions.reshape(-1, 28, 3).astype(float)
    return np.linalg.norm(rings - np.roll(rings, 1, axis=1), axis=-1).sum(1)


@pytest.mark.parametrize("angle", [0.0, 60.0, 120.0])
def test_the_skin_stays_smooth_and_does_not_collapse(angle):
    """All bones bent by as much as a key can bend them: no ring loses an eighth, no face turns inside out."""
    bent = {f"{part}_bend": sign * angle for part, sign in (("root", 1), ("middle", 1), ("tip", -1))}
    _, actor = placed("PAUSE FORWARD", **bent)
    part = next(part for part in actor.vertices() if part.node == TUBE.node)
    assert (girths(part)[2:-8] / girths(TUBE)[2:-8]).min() > 0.875
    corners = part.normals[TUBE.indices.reshape(-1, 3)]
    above = TUBE.positions[TUBE.indices.reshape(-1, 3), 1].min(1) > HEIGHTS[1]  # the rest is in the stone
    whole = above & (np.linalg.norm(face_normals(part), axis=1) > 0.5)
    assert np.einsum("fcx,fx->fc", corners, face_normals(part))[whole].min() > 0.3


# the sway, and its pause


def test_the_sway_is_seamless_and_alive():
    clip = BODY.clips["sway"]
    ends = clip.sample(np.array([0.0, 1e-3, clip.duration - 1e-3, clip.duration])).rotation
    np.testing.assert_allclose(ends[0], ends[3], atol=1e-6)
    np.testing.assert_allclose(ends[1] - ends[0], ends[3] - ends[2], atol=1e-4)  # the same speed
    tips = np.array([BODY.world(clip.sample(t))[TIP, :3, 3] for t in np.linspace(0, clip.duration, 97)])
    speeds = np.linalg.norm(np.diff(tips, axis=0), axis=1) * 96 / clip.duration
    assert speeds.min() > 0.03  # it never stands still
    assert np.ptp(tips, axis=0)[[0, 2]].min() > 0.6


def test_the_wave_runs_from_the_foot_to_the_tip():
    """The slow turn of a bone (one a lap) comes later than that of the bone below."""
    clip = BODY.clips["sway"]
    poses = clip.sample(np.arange(0, clip.duration, 1 / 30)).rotation[:, ROWS].astype(float)
    angles = Rotation.from_quat(poses.reshape(-1, 4)).as_rotvec().reshape(len(poses), -1, 3)[..., 2]
    phases = np.unwrap(np.angle(np.fft.rfft(angles, axis=0)[1]))
    assert (np.diff(phases) < 0).all()


def test_a_pause_holds_the_pose_and_the_sway_goes_on_from_there():
    stage, actor = placed("PAUSE")
    held = actor.pose.rotation.copy()
    stage.step(200)
    assert actor.state == "STILL"
    assert (actor.pose.rotation == held).all()
    stage.send(actor, "PAUSE")
    moved = [(turns(actor).inv() * Rotation.from_quat(held[ROWS])).magnitude().max()]
    for _ in range(5):
        stage.step(1)
        moved.append((turns(actor).inv() * Rotation.from_quat(held[ROWS])).magnitude().max())
    assert np.degrees(np.diff(moved)).max() < 0.5
    assert actor.state == "SWAY"
    assert moved[-1] > 0


def test_a_toggle_that_is_held_does_not_flicker_and_a_second_press_is_not_lost():
    stage, actor = placed("")
    stage.hold(actor, "PAUSE")
    states = played(stage, actor, 30, lambda actor: actor.state)
    changes = sum(one != other for one, other in pairwise(states))
    assert 1 <= changes <= 5
    stage.release(actor, "PAUSE")
    stage.step(30)
    before = actor.state
    stage.send(actor, "PAUSE")
    stage.send(actor, "PAUSE")
    stage.step(15)
    assert actor.state == before


# forward kinematics


def test_angles_arrive_as_worked_out_by_hand():
    angles = {"root_bend": 40.0, "middle_side": -60.0, "tip_twist": 75.0, "tip_bend": 30.0}
    _, swaying = placed("PAUSE")
    _, turned = placed("PAUSE FORWARD", **angles)
    # the second is paused in the same tick; each of five bones takes a fifth: about X, then Y, then Z
    wanted = [[8, 0, 0]] * 5 + [[0, 0, -12]] * 5 + [[6, 15, 0]] * 5
    delta = turns(swaying).inv() * turns(turned)
    np.testing.assert_allclose(delta.as_euler("xyz", degrees=True), wanted, atol=2e-3)


def test_a_key_that_is_off_changes_nothing():
    bare, swaying = placed("")
    stage, other = placed("", root_bend=100.0, pull=0.5)
    assert (swaying.pose.rotation == other.pose.rotation).all()
    stage.send(other, "FORWARD")
    stage.step(60)
    bare.step(60)
    assert other.states == ("SWAY", "ON", "ROOT")
    assert np.degrees((turns(swaying).inv() * turns(other)).magnitude()).max() > 15
    stage.send(other, "FORWARD")
    stage.step(60)
    bare.step(60)
    np.testing.assert_allclose(swaying.pose.rotation, other.pose.rotation, atol=1e-5)


def test_parts_are_chosen():
    stage, actor = placed("")
    seen = []
    for event in ("MIDDLE", "TIP", "ROOT", "FORWARD", "FORWARD"):
        stage.send(actor, event)
        stage.step(10)
        seen.append(actor.states[1:])
    assert seen == [("ON", "MIDDLE"), ("ON", "TIP"), ("ON", "ROOT"), ("OFF", "NONE"), ("ON", "ROOT")]


# inverse kinematics

TARGETS = [(-0.7, 0.9, 0.5), (0.5, 0.4, -0.6), (0.9, 1.1, 0.0), (0.0, 1.2, 0.8)]


@pytest.mark.parametrize("target", TARGETS)
def test_the_effector_travels_and_does_not_snap(target):
    """Critically damped: a way d is made with at most ω·d/e metres a second, without turning back."""
    stage, actor = placed("PAUSE INVERSE")
    stage.set(actor, "target", target)
    ends = np.array(played(stage, actor, 120, tip))
    far = np.linalg.norm(ends - target, axis=1)
    steps = np.linalg.norm(np.diff(ends, axis=0), axis=1) * 60
    assert far[0] > 0.3
    assert far[-1] < 2e-4
    assert np.diff(far).max() < 2e-4  # the tolerance of the solver
    assert steps.max() < OMEGA * far[0] / np.e + 0.03
    assert far[6] > 0.75 * far[0]  # a tenth of a second later it has hardly left
    assert actor.reached["reach"].reached


def test_no_bone_jumps_while_the_target_is_thrown_about():
    """The greatest change of a bone's angular velocity from tick to tick, degrees a tick."""
    stage, actor = placed("INVERSE")
    worst, before, speed = 0.0, turns(actor), None
    for tick in range(300):
        if tick % 40 == 0:
            stage.set(actor, "target", TARGETS[tick // 40 % 4])
        stage.step(1)
        now = turns(actor)
        moved = np.degrees((before.inv() * now).as_rotvec())
        if speed is not None:
            worst = max(worst, np.linalg.norm(moved - speed, axis=1).max())
        before, speed = now, moved
    assert worst < 4


def test_out_of_reach_it_points_at_the_target():
    target = np.array([2.5, 2.0, 1.0])
    stage, actor = placed("PAUSE INVERSE", target=tuple(target))
    stage.step(240)
    start = actor.world[ROWS[0], :3, 3]
    aim, arm = target - start, tip(actor) - start
    length = np.diff(HEIGHTS[1:]).sum()
    assert np.linalg.norm(arm) > 0.99 * length
    assert arm @ aim / np.linalg.norm(arm) / np.linalg.norm(aim) > 0.999
    assert not actor.reached["reach"].reached


@pytest.mark.parametrize("target", [(0.1, 0.1, 0.0), (0.0, 0.2, -0.3), (-3.0, -2.0, 1.0)])
def test_limits_hold(target):
    """±30 degrees about X and Z, ±26 about Y, in every tick."""
    bent = {
        f"{part}_{turn}": 120.0 for part in ("root", "middle", "tip") for turn in ("bend", "side", "twist")
    }
    stage, actor = placed("FORWARD INVERSE", target=target, **bent)
    most = np.zeros(3)
    for _ in range(90):
        stage.step(1)
        most = np.maximum(most, np.abs(turns(actor).as_euler("xyz", degrees=True)).max(0))
    assert (most < np.array([30, 26, 30]) + 0.01).all()
    assert most[0] > 29  # they are needed


def test_it_reaches_while_it_sways():
    stage, actor = placed("INVERSE", target=TARGETS[0])
    stage.step(60)
    ends, poses = [], []
    for _ in range(120):
        stage.step(1)
        ends.append(tip(actor))
        poses.append(turns(actor)[7].as_quat())
    assert np.linalg.norm(np.array(ends) - TARGETS[0], axis=1).max() < 2e-4
    assert np.ptp(poses, axis=0).max() > 0.01  # the body lives on


def test_half_a_pull_is_half_way():
    """On the shortest way between the sway and the solution, bone by bone."""
    q = [turns(placed("PAUSE INVERSE", target=TARGETS[0], pull=pull)[1]) for pull in (0.0, 0.5, 1.0)]
    half = q[0] * Rotation.from_rotvec(0.5 * (q[0].inv() * q[2]).as_rotvec())
    assert np.degrees((half.inv() * q[1]).magnitude()).max() < 0.05
    assert np.degrees((q[0].inv() * q[2]).magnitude()).max() > 5


def test_all_three_mix():
    """Forward kinematics works under the target: the tip is there, the body bends elsewhere."""
    _, one = placed("INVERSE", target=TARGETS[0])
    _, other = placed("INVERSE FORWARD", target=TARGETS[0], root_side=-90.0)
    for actor in (one, other):
        assert np.linalg.norm(tip(actor) - TARGETS[0]) < 2e-4
    assert np.degrees((turns(one).inv() * turns(other)).magnitude()).max() > 5


# everything is logged


def test_a_log_is_replayed_bit_for_bit_and_others_stay_as_they_are():
    stage, actor = placed("FORWARD MIDDLE INVERSE", target=TARGETS[1], middle_bend=50.0)
    other = stage.add(ROLE, (2.0, 0.0, 0.0))
    for tick in range(60):
        stage.set(actor, "target", (0.5 * np.cos(tick / 9), 0.9, 0.5 * np.sin(tick / 9)))
        stage.step(1)
    stage.send(actor, "PAUSE")
    stage.step(30)
    again = replay(stage.dump(), lambda *_: ROLE)
    assert again.hash == stage.hash
    alone = statwalk.Stage(seed=1)
    alone.add(ROLE)
    alone.step(stage.tick - 90)
    untouched = alone.add(ROLE, (2.0, 0.0, 0.0))
    alone.step(90)
    assert untouched.hash == other.hash
    assert actor.parameters["middle_bend"] == 50
    assert len(actor.parameters["target"]) == 3


def test_the_keys_of_the_paper():
    """B, R and T are the page's; the others are in the file."""
    keys = ROLE.definition.keys
    assert {key: keys[key].press for key in "fip"} == {"f": "FORWARD", "i": "INVERSE", "p": "PAUSE"}
    assert not {"b", "r", "t"} & set(keys)
    for key, turn, axis in (
        ("ArrowLeft", "side", "x"),
        ("ArrowRight", "side", "x"),
        ("ArrowUp", "bend", "y"),
        ("ArrowDown", "bend", "y"),
        ("PageUp", "twist", "z"),
        ("PageDown", "twist", "z"),
    ):
        change = keys[key].change
        assert list(change) == ["ROOT", "MIDDLE", "TIP", "REACH", "POINT"]
        assert [*change["TIP"]] == [f"tip_{turn}"]
        assert [*change["REACH"]] == [*change["POINT"]] == [f"target.{axis}"]

"""KF8 retargeting on real bodies: every human capture maps onto every human body; the issue's lines run."""

from pathlib import Path

import numpy as np
import pytest
import statwalk
from bone_places import directions, places
from paths import ASSETS, GLTF, MACHINES, needs_assets
from sole_points import slides
from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.errors import ContentError
from statwalk.files.faq.skeleton_text import shipped_skeleton
from statwalk.rig.evaluate import world_from_local

WALK = ASSETS / "bvh" / "cmu_12_01_walk.bvh"
SOURCES = ("01_01", "bvh_test1", "cmu_12_01_walk", "dab", "standard_skeleton", "zombie")
BODIES = {
    "KayKit_Knight.glb": GLTF,
    "KayKit_Med_MovementBasic.glb": GLTF,
    "M2M_rig_human.glb": GLTF,
    "Quaternius_PlatformerCharacter.glb": GLTF,
    "RobotExpressive.glb": GLTF,
    "kaykit_manny/manny_med_mod.gltf": GLTF,
    "faq-walker/walker.glb": MACHINES,
    "faq-printed/character.yaml": MACHINES,
}


@needs_assets
@pytest.mark.parametrize("source", SOURCES)
@pytest.mark.parametrize("body", BODIES)
def test_every_human_motion_maps_onto_every_human_body(source: str, body: str) -> None:
    motion, target = statwalk.load(ASSETS / "bvh" / f"{source}.bvh"), statwalk.load(BODIES[body] / body)
    assert isinstance(motion, Character)
    assert isinstance(target, Character)
    clip, report = statwalk.retarget(next(iter(motion.clips.values())), motion, target, end=3)
    assert report.missing == ()
    assert {"Head", "LeftUpperArm", "RightHand", "LeftFoot", "RightLowerLeg"} <= report.bones.keys()
    at = {
        bone: places(target, clip, np.linspace(0, clip.duration, 25))[joint]
        for bone, (_, joint) in report.bones.items()
    }
    rest = world_from_local(target.skeleton, target.bind_pose)[..., 3]
    height = rest[target.skeleton.index(report.bones["Head"][1]), 1]
    left = directions(at["RightUpperLeg"], at["LeftUpperLeg"])
    forward = np.cross(left, [0, 1, 0])
    assert forward[:8, 2].mean() > 0.9  # it faces +Z
    assert (((at["LeftFoot"] - at["RightFoot"]) * left).sum(-1) > 0).all()  # no leg crosses the other
    for side in ("Left", "Right"):
        hip, knee, ankle = (at[side + bone] for bone in ("UpperLeg", "LowerLeg", "Foot"))
        bend = (directions(hip, knee) * directions(knee, ankle)).sum(-1)
        ahead = ((knee - (hip + ankle) / 2) * forward).sum(-1)
        assert (ahead[bend < 0.8] > -0.03 * height).all()  # a bent knee bends forward
    ankles = np.minimum(at["LeftFoot"][:, 1], at["RightFoot"][:, 1])
    standing = rest[target.skeleton.index(report.bones["LeftFoot"][1]), 1]
    assert (ankles > standing - 0.02 * height).all()
    assert np.median(ankles) < standing + 0.15 * height


@needs_assets
def test_a_long_foot_on_a_short_leg_is_levelled_and_not_lifted() -> None:
    """RobotExpressive's feet are as long as its shins: its own walk lifts the ankle 0.58 m."""
    walk, robot = statwalk.load(WALK), statwalk.load(GLTF / "RobotExpressive.glb")
    assert isinstance(walk, Character)
    assert isinstance(robot, Character)
    clip, report = statwalk.retarget(next(iter(walk.clips.values())), walk, robot)
    ankle = places(robot, clip, np.linspace(0, clip.duration, 200))[report.bones["LeftFoot"][1]][:, 1]
    own = robot.clip("Walking")
    usual = places(robot, own, np.linspace(0, own.duration, 50))[report.bones["LeftFoot"][1]][:, 1]
    assert ankle.max() < 1.05 * usual.max()
    feet = [row for row, part in enumerate(robot.parts) if "Foot" in robot.skeleton.names[part.joint]]
    lowest = [
        robot.vertices(clip.sample(time))[row].positions[:, 1].min()
        for time in np.linspace(0, clip.duration, 40)
        for row in feet
    ]
    assert min(lowest) > -0.03


@needs_assets
@pytest.mark.parametrize("name", ["faq-walker/walker.glb", "RobotExpressive.glb", "KayKit_Knight.glb"])
def test_soles_do_not_slide_where_the_captured_feet_stand(name: str) -> None:
    """RobotExpressive dragged a foot through its whole step: 1.9 m."""
    walk, target = statwalk.load(WALK), statwalk.load(BODIES[name] / name)
    assert isinstance(walk, Character)
    assert isinstance(target, Character)
    clip, _ = statwalk.retarget(next(iter(walk.clips.values())), walk, target)
    frames = world_from_local(target.skeleton, clip.sample(np.linspace(0, clip.duration, 500))).astype(float)
    rest = world_from_local(target.skeleton, target.bind_pose).astype(float)
    feet = feet_of(target)
    ground = np.array([0, min(foot.skin.heights(rest).min() for foot in feet), 0])
    contacts = [slides(foot.skin.at(frames) - ground) for foot in feet]
    assert max(map(max, contacts)) < 0.02  # metres; 0.06, 0.17 and 0.13 with the ankles as captured
    assert min(map(len, contacts)) >= 3


@needs_assets
def test_a_body_with_legs_of_one_joint_and_an_animal_say_what_they_lack() -> None:
    walk = statwalk.load(WALK)
    assert isinstance(walk, Character)
    clip = next(iter(walk.clips.values()))
    toy, fox = (statwalk.load(GLTF / name) for name in ("Kenney_character.glb", "Khronos_Fox.glb"))
    assert isinstance(toy, Character)
    assert isinstance(fox, Character)
    carried, report = statwalk.retarget(clip, walk, toy)
    assert report.bones["LeftUpperLeg"] == ("LeftUpLeg", "leg-left")
    assert set(report.missing) == {"LeftLowerLeg", "LeftFoot", "RightLowerLeg", "RightFoot"}
    swing = carried.sample(np.linspace(0.5, 2, 60)).rotation[:, toy.skeleton.index("leg-left")]
    assert np.ptp(swing, axis=0).max() > 0.3
    with pytest.raises(ContentError, match="do not tell Hips"):
        statwalk.retarget(clip, walk, fox)


AS_PRINTED = """
knight = statwalk.load("KayKit_Knight.glb")
arm = ("upperarm.r", "lowerarm.r", "wrist.r")
answer = knight.solve(pose, chain=arm, target=(x, y, z), solver="two-bone")
answer.pose, answer.reached, answer.distance, answer.iterations
walk = statwalk.load("walk.bvh", position="replace")
clip, report = statwalk.retarget(next(iter(walk.clips.values())), walk, knight)
found = statwalk.deduce(bones, known)
"""


@needs_assets
def test_the_lines_of_python_run_as_they_are_printed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "KayKit_Knight.glb").write_bytes((GLTF / "KayKit_Knight.glb").read_bytes())
    (tmp_path / "walk.bvh").write_bytes(WALK.read_bytes())
    knight = statwalk.load("KayKit_Knight.glb")
    assert isinstance(knight, Character)
    hand = places(knight, knight.clip("Idle"), np.zeros(1))["wrist.r"][0] + [0.05, 0.05, 0.05]
    bones = shipped_skeleton("mammal")
    known = {"Left.upperarm": {"SP": [2, 10, 0]}, "Left.lowerarm": {"EP": [5, 8, 0], "bend": [0, 0, -1]}}
    names = {"statwalk": statwalk, "pose": knight.clip("Idle").sample(0), "bones": bones, "known": known}
    names |= dict(zip("xyz", hand.tolist(), strict=True))
    exec(compile(AS_PRINTED, "the issue", "exec"), names)
    assert names["answer"].reached
    assert names["walk"].skeleton.names[:2] == ("Hips", "LHipJoint")
    assert list(names["walk"].clips) == ["walk"]
    assert names["report"].missing == ()
    assert names["found"]["Left.upperarm"]["EP"].source == "rule 12" or names["found"].unknown

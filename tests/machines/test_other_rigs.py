"""Feet of other rigs, made by hand: four legs, one leg, tiny and huge characters, feet without legs."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.stage import Stage

FILE = """
semantics: 1
character: a.glb
initial: STAND
defaults: {{blend: 0.3}}
states:
  STAND: {{motion: stand, loop: true}}
  LEAN: {{motion: lean, loop: true}}
table: |
  state | GO
  STAND | LEAN
  LEAN  | STAND
foot_lock: true
{more}
"""
FOUR = {
    f"{end}_Leg_{{}}_{side}": (x, z)
    for end, z in (("Front", 0.5), ("Hind", -0.5))
    for side, x in (("L", 0.2), ("R", -0.2))
}
TWO = {"{}_L": (0.1, 0.0), "{}_R": (-0.1, 0.0)}
NAMES = {"Upper": "UpperLeg", "Lower": "LowerLeg", "Ankle": "Foot"}
LEAN = 0.02
"""metres that the whole character is farther to the side in one of its clips"""


def character(legs: dict[str, tuple[float, float]], scale: float) -> Character:
    """Legs of two bones of 0.4 m, a little bent, below a trunk; two clips in which nothing moves."""
    four = len(legs) == 4
    joints, parents, places = ["trunk"], [None], [[0.0, 0.79, 0.0]]
    for pattern, (x, z) in legs.items():
        upper, lower, ankle = (
            pattern.format(part if four else NAMES[part]) for part in ("Upper", "Lower", "Ankle")
        )
        joints += [upper, lower, ankle, f"{ankle} end"]
        parents += ["trunk", upper, lower, ankle]
        places += [[x, 0.0, z], [0.0, -0.39, 0.08], [0.0, -0.38, -0.08], [0.0, -0.02, 0.1]]
    skeleton, _ = Skeleton.sorted(joints, parents)
    pose = rest(len(joints))
    pose.translation[[skeleton.index(joint) for joint in joints]] = np.array(places) * scale
    times, trunk = np.array([0, 1], np.float32), pose.translation[0]
    clips = {
        name: Clip(
            name,
            (Channel(0, "translation", times, np.tile(trunk + away, (2, 1)).astype(np.float32)),),
            1.0,
            pose,
        )
        for name, away in (("stand", np.zeros(3)), ("lean", np.array([LEAN * scale, 0, 0])))
    }
    return Character("rig", skeleton, np.arange(len(joints), dtype=np.int32), pose, clips)


@cache
def played(count: int, scale: float, more: str = "") -> np.ndarray:
    """(T, J, 3) the joints of a rig with `count` legs that begins to lean, in units of its scale."""
    legs = dict(list((FOUR if count == 4 else TWO).items())[:count])
    role = Role.build("rig", character(legs, scale), read_machine(FILE.format(more=more)), None)
    stage, shots = Stage(seed=1), []
    actor = stage.add(role)
    for tick in range(60):
        if tick == 10:
            stage.send(actor, "GO")
        stage.step()
        shots.append(np.asarray(actor.world)[:, :3, 3] / scale)
    return np.array(shots)


def ankles(count: int) -> list[int]:
    legs = dict(list((FOUR if count == 4 else TWO).items())[:count])
    return [foot.ankle for foot in feet_of(character(legs, 1.0))]


@pytest.mark.parametrize("count", [1, 2, 4])
def test_every_leg_holds_its_foot_while_the_trunk_leans(count: int) -> None:
    track = played(count, 1.0)
    assert len(ankles(count)) == count
    assert track[-1, 0, 0] - track[0, 0, 0] == pytest.approx(LEAN, abs=1e-4)
    assert np.abs(track[:, ankles(count)] - track[0, ankles(count)]).max() < 0.001


def test_four_feet_are_told_apart() -> None:
    feet = feet_of(character(FOUR, 1.0))
    assert sorted(foot.name for foot in feet) == ["back-left", "back-right", "front-left", "front-right"]
    role = Role.build("rig", character(FOUR, 1.0), read_machine(FILE.format(more="")), None)
    names = [foot.name for foot in feet]
    partners = {names[k]: names[other] for k, other in enumerate(role.solvers.legs.other)}
    assert partners == {
        "front-left": "front-right", "front-right": "front-left",
        "back-left": "back-right", "back-right": "back-left",
    }  # fmt: skip


@pytest.mark.parametrize("scale", [1 / 64, 128.0])
def test_a_tiny_or_huge_character_moves_as_one_of_usual_size(scale: float) -> None:
    step = "ground: [{{from: [{0}, {0}], to: [{1}, {1}], height: {2}}}]"
    usual = played(2, 1.0, step.format(0.0, 0.5, 0.05))
    other = played(2, scale, step.format(0.0, 0.5 * scale, 0.05 * scale))
    assert np.abs(usual - other).max() < 1e-4


def test_four_feet_stand_on_a_slope() -> None:
    slope = "ground: [{from: [-2, -2], to: [2, 2], height: [0, 0.4]}]"
    track = played(4, 1.0, slope)
    soles = track[5, [ankle + 1 for ankle in ankles(4)]]
    assert soles[:, 1] == pytest.approx(0.2 + 0.1 * soles[:, 2], abs=0.012)


def refused(legs: dict[str, tuple[float, float]], more: str = "", change: str = "") -> str:
    text = FILE.format(more=more).replace("foot_lock: true", change or "foot_lock: true")
    with pytest.raises(MachineError) as error:
        Role.build("rig", character(legs, 1.0), read_machine(text), None).solvers  # noqa: B018
    return str(error.value)


def test_a_foot_lock_without_legs_says_how_to_name_them() -> None:
    assert "name them in the file: `feet:" in refused({})


def test_a_foot_that_hangs_on_no_knee_is_named() -> None:
    said = refused(
        {"thing{}_R": (0.3, 0.0)}, "feet: {left: {hip: trunk, knee: thingUpperLeg_R, ankle: thingFoot_R}}"
    )
    assert "'thingFoot_R' hangs on 'thingLowerLeg_R'" in said


def test_ground_without_a_foot_lock_is_refused_with_its_line() -> None:
    said = refused(TWO, "ground: [{from: [0, 0], to: [1, 1], height: 0.2}]", "foot_lock: false")
    assert "ground: only feet find it" in said
    assert "line" in said

"""The dummy with two arms: muscle bones on the left, a digital skin that bulges on the right."""

import khronos
import numpy as np
import pytest
import statwalk
from statwalk.stage.actor import Actor
from statwalk.stage.stage import Stage

CHARACTER = statwalk.load("biceps").character
RIGHT = CHARACTER.parts[-1]
"""the digital skin"""


def at(angle: float) -> list[np.ndarray]:
    """The vertices of all parts with the left elbow at an angle in degrees."""
    turned = statwalk.express(CHARACTER, f"left_forearm.rotate_z = {angle}").pose
    posed = statwalk.express(CHARACTER, pose=turned).pose
    return [part.positions for part in CHARACTER.vertices(posed)]


def test_the_model_is_valid() -> None:
    assert khronos.errors(CHARACTER.model_glb) == []


@pytest.mark.parametrize("angle", [0, 45, 90, 125])
def test_the_digital_biceps_has_the_size_of_its_cubic(angle: float) -> None:
    """Each vertex of the upper arm, from the formula of the file."""
    factor = 1 + 0.0001344 * angle**2 - 0.0000007168 * angle**3
    shoulder = np.array([-0.15, 0.56, 0])
    upper = RIGHT.joints[:, 0] == 0
    own = RIGHT.positions[upper].astype(float) - shoulder - [-0.155, -0.01, 0]
    out = ((own / [0.11, 0.1, 0.1]) ** 2).sum(1)
    share = np.where(out < 1, (1 - out) ** 2, 0)[:, None]
    expected = RIGHT.positions[upper] + (factor - 1) * share * own * [0, 1, 1]
    assert at(angle)[-1][upper] == pytest.approx(expected, abs=2e-6)


def test_both_upper_arms_are_thicker_where_the_biceps_is_short() -> None:
    straight, bent = at(0), at(125)
    left = next(row for row, part in enumerate(CHARACTER.parts) if part.skin == 0)
    for row in (left, len(CHARACTER.parts) - 1):
        middle = np.abs(np.abs(straight[row][:, 0]) - 0.3) < 0.015
        before, after = (np.ptp(points[middle, 1]) for points in (straight[row], bent[row]))
        assert 1.1 < after / before < 1.6


def test_the_muscle_bones_stand_where_their_expressions_say() -> None:
    turned = statwalk.express(CHARACTER, "left_forearm.rotate_z = 62.5").pose
    posed = statwalk.express(CHARACTER, pose=turned).pose
    row = CHARACTER.skeleton.index("left_biceps")
    assert posed.translation[row] == pytest.approx([0.165 - 0.01, 0.024 + 0.008, 0], abs=1e-6)
    assert posed.scale[row] == pytest.approx([1 - 0.075, 1 + 0.45, 1 + 0.06], abs=1e-6)


def test_glue_triangles_join_the_three_bones_of_the_digital_skin() -> None:
    """Two rings of 16 quads: at the elbow and at the wrist."""
    glue = CHARACTER.glue_triangles[-1]
    assert len(glue) == 2 * 16 * 2
    pairs = {tuple(sorted(set(RIGHT.joints[corners, 0].tolist()))) for corners in glue}
    assert pairs == {(0, 1), (1, 2)}


def test_the_right_arm_mirrors_the_left_in_every_state() -> None:
    stage = Stage(seed=1)
    actor = stage.add(statwalk.load("biceps"))
    for event, angle in (("BEND", 125.0), ("SLIDE", 70.0), ("STRETCH", 0.0)):
        stage.send(actor, event)
        stage.step(150)
        assert actor.channels["right_forearm.rotate_z"] == pytest.approx(-angle, abs=1e-3)
        assert turn(actor, "left_forearm") == pytest.approx(angle, abs=1e-3)


def turn(actor: Actor, joint: str) -> float:
    """The angle of a joint about Z, degrees."""
    _x, _y, z, w = actor.pose.rotation[CHARACTER.skeleton.index(joint)].tolist()
    return float(np.degrees(2 * np.arctan2(z, w)))

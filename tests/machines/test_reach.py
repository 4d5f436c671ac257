"""The walker whose hands reach: they come to what shoulders and elbows allow, and no farther."""

import numpy as np
import pytest
import statwalk
from scipy.spatial.transform import Rotation

ROLE = statwalk.load("reach")
NAMES = list(ROLE.character.skeleton.names)
ELBOWS = [NAMES.index(f"{side}.lowerarm") for side in ("Left", "Right")]


def reaching(left, right, ticks=90):
    """The actor when its hands have had time to come to two points (x, y, z)."""
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.send(actor, "REACH")
    stage.set(actor, "left", left)
    stage.set(actor, "right", right)
    stage.step(ticks)
    return actor


def hands(actor):
    worlds = ROLE.character.world(actor.pose)
    return [worlds[NAMES.index(f"{side}.hand"), :3, 3] for side in ("Left", "Right")]


@pytest.mark.parametrize(
    "points",
    [
        [(0.3, 1.25, 0.4), (-0.3, 1.25, 0.4)],
        [(-0.1, 1.3, 0.4), (0.1, 1.3, 0.4)],
        [(0.45, 1.5, 0.25), (-0.35, 1.05, 0.3)],
        [(0.6, 1.35, 0.1), (-0.1, 1.0, 0.35)],
    ],
    ids=["in front", "crossed", "high and low", "aside"],
)
def test_hands_come_to_what_the_joints_allow(points):
    np.testing.assert_allclose(hands(reaching(*points)), points, atol=0.012)  # softened by 3 cm


@pytest.mark.parametrize(
    "points", [[(0.2, 1.2, -0.4), (-0.3, 1.9, 0.1)], [(0.0, 0.6, 0.4), (-0.2, 0.5, -0.3)]]
)
def test_elbows_bend_one_way_wherever_the_hands_shall_go(points):
    actor = reaching(*points)
    rest = Rotation.from_quat(ROLE.character.bind_pose.rotation[ELBOWS])
    turned = (rest.inv() * Rotation.from_quat(actor.pose.rotation[ELBOWS])).as_rotvec(degrees=True)
    np.testing.assert_allclose(turned[:, 1:], 0, atol=0.1)
    assert turned[:, 0].min() > -140.1
    assert turned[:, 0].max() < 8.1


FACES = {
    "aside": ((0.6, 0, 0.8), (0.6, 0, 0.8)),
    "down": ((0, -0.6, 0.8), (0, -0.6, 0.8)),
    "beyond the cone of 80 degrees": ((1, 0, 0), (0.985, 0, 0.174)),
}


@pytest.mark.parametrize(("face", "wanted"), FACES.values(), ids=FACES)
def test_the_head_turns_where_the_face_shall_look(face, wanted):
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.send(actor, "REACH")
    stage.set(actor, "face", face)
    stage.step(120)
    sight = ROLE.character.world(actor.pose)[NAMES.index("Head"), :3, 2]
    np.testing.assert_allclose(sight, wanted, atol=2e-3)


def test_arms_come_down_again():
    stage = statwalk.Stage(seed=1)
    actor = stage.add(ROLE)
    stage.step(60)
    before = np.array(hands(actor))
    stage.send(actor, "REACH")
    stage.step(60)
    stage.send(actor, "LOWER")
    stage.step(120)
    assert np.abs(np.array(hands(actor)) - before).max() < 0.02

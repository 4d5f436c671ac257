"""How far a sole is under its ankle, with toes that turn by themselves: angles by hand, and real bodies."""

import builders
import numpy as np
import pytest
import statwalk
from paths import ASSETS, GLTF, needs_assets
from statwalk.character.body import Body
from statwalk.character.carried_soles import Sole
from statwalk.character.character import Character
from statwalk.character.feet import feet_of
from statwalk.maths import quat
from statwalk.rig.evaluate import world_from_local

STILL = np.array([0.0, 0, 0, 1])
BODY = Body(
    builders.character(), {"LeftFoot": 0, "LeftToes": 1}, np.zeros((3, 3)), np.tile(STILL, (3, 1)), STILL
)
HEEL, BALL, TIP = [0, -0.1, -0.05], [0, -0.08, 0.15], [0, -0.02, 0.05]
SOLE = Sole("LeftFoot", "LeftToes", np.array([HEEL]), np.array([TIP]), np.array(BALL), 0.0)


def pitched(degrees: float) -> np.ndarray:
    """A turn of the toes downward."""
    return quat.from_axis_angle((1, 0, 0), np.radians([degrees]))


@pytest.mark.parametrize(
    ("foot", "toes", "lowest"),
    [
        (0, 0, 0.1),  # the ball and its tip, 0.08 + 0.02, are as low as the heel
        (0, 90, 0.13),  # the tip points down: 0.08 + 0.05
        (0, -90, 0.1),
        (90, 90, 0.2),  # both point down: 0.15 + 0.05
        (90, 0, 0.17),  # the foot points down, the toes are level: 0.15 + 0.02
    ],
)
def test_the_lowest_point_of_heel_and_toes(foot: float, toes: float, lowest: float) -> None:
    under = SOLE.under(BODY, {"LeftFoot": pitched(foot), "LeftToes": pitched(toes)})
    assert under == pytest.approx([lowest])


def test_toes_without_a_turn_of_their_own_turn_with_the_foot() -> None:
    rigid = Sole("LeftFoot", "", np.add([HEEL, BALL], 0), np.zeros((0, 3)), np.zeros(3), 0.0)
    assert rigid.under(BODY, {"LeftFoot": pitched(90)}) == pytest.approx([0.15])


def test_a_foot_that_rolls_over_its_ball_leaves_the_ball_where_it_is() -> None:
    """The ball is 0.15 ahead and 0.08 down; the toes stay level while the heel rises by 30°."""
    foot = quat.from_axis_angle((1, 0, 0), np.radians(np.linspace(0, 30, 31)))
    way = SOLE.rolled(BODY, {"LeftFoot": foot, "LeftToes": np.tile(STILL, (31, 1))}).sum(0)
    angle = np.radians(30)  # the tip of the level toes goes along with the ball, which turns about the ankle
    down = 0.08 * np.cos(angle) + 0.15 * np.sin(angle) - 0.08
    back = 0.15 * (np.cos(angle) - 1) - 0.08 * np.sin(angle)
    assert way == pytest.approx([0, -down, back], abs=1e-6)


@needs_assets
@pytest.mark.parametrize("model", ["KayKit_Knight.glb", "RobotExpressive.glb"])
def test_no_sole_of_a_real_body_is_below_the_ground(model: str) -> None:
    walk, target = statwalk.load(ASSETS / "bvh" / "cmu_12_01_walk.bvh"), statwalk.load(GLTF / model)
    assert isinstance(walk, Character)
    assert isinstance(target, Character)
    clip, _ = statwalk.retarget(next(iter(walk.clips.values())), walk, target)
    frames = world_from_local(target.skeleton, clip.sample(np.linspace(0, clip.duration, 90))).astype(float)
    rest = world_from_local(target.skeleton, target.bind_pose).astype(float)
    feet = feet_of(target)
    ground = min(foot.skin.heights(rest).min() for foot in feet)
    assert min(foot.skin.heights(frames).min() for foot in feet) > ground - 0.01  # metres; the Knight has 2.5

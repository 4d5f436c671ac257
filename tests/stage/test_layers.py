"""Layers and blends on a stage: what they move, and what they leave alone."""

from dataclasses import replace

import gaits
import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

LEGS = [gaits.HIPS, gaits.LEFT, gaits.RIGHT]


def stage_of(rate=60, *changes):
    stage = Stage(seed=2, rate=rate)
    return stage, stage.add(gaits.role(*changes))


def angles(pose, joint):
    return Rotation.from_quat(pose.rotation[joint]).as_euler("xyz", degrees=True)


def standing(seconds):
    return gaits.role().motions[0].clip.sample(seconds)


def test_an_upper_layer_moves_its_joints():
    stage, actor = stage_of()
    stage.send(actor, "WAVE")
    stage.step(13)  # 0.2 s, and the tick in which it began
    assert actor.states == ("STAND", "WAVE", "CALM")
    assert actor.pose.rotation[gaits.ARM] == pytest.approx(
        gaits.WAVE.sample(0.2, loop=True).rotation[gaits.ARM], abs=1e-6
    )


def test_and_no_others_to_the_bit():
    stage, actor = stage_of()
    other = stage.add(gaits.role())
    stage.send(actor, "GO")
    stage.send(other, "GO")
    stage.step(20)
    stage.send(actor, "WAVE")
    stage.step(5)
    for one, two in zip(actor.pose[:3], other.pose[:3], strict=True):
        assert one[[*LEGS, gaits.CHEST]].tobytes() == two[[*LEGS, gaits.CHEST]].tobytes()


def test_none_leaves_what_is_below():
    stage, actor = stage_of()
    stage.send(actor, "WAVE")
    stage.step(30)
    stage.send(actor, "REST")
    stage.step(13)
    assert actor.pose.rotation[gaits.ARM] == pytest.approx(gaits.REST.rotation[gaits.ARM], abs=1e-6)


def test_an_additive_layer_adds_to_what_is_below():
    """The nod starts from 10 degrees: at 0.25 s it is 20 degrees on, beside what standing does."""
    stage, actor = stage_of(60, ("weight: force", "weight: 1"))
    stage.send(actor, "NOD")
    stage.step(16)
    below = standing(16 / 60).rotation[gaits.CHEST]
    expected = Rotation.from_quat(below) * Rotation.from_euler("x", 20, degrees=True)
    assert abs((expected.as_quat() * actor.pose.rotation[gaits.CHEST]).sum()) == pytest.approx(1, abs=1e-6)


def test_a_difference_of_nothing_changes_nothing():
    stage, actor = stage_of()
    other = stage.add(gaits.role())
    stage.send(actor, "STILL")
    stage.step(40)
    assert actor.pose.rotation == pytest.approx(other.pose.rotation, abs=1e-6)


def test_the_weight_of_a_layer_is_a_parameter():
    stage, actor = stage_of()
    stage.set(actor, "force", 0.5)
    stage.send(actor, "NOD")
    stage.step(16)
    bent = angles(actor.pose, gaits.CHEST)[0] - angles(standing(16 / 60), gaits.CHEST)[0]
    assert bent == pytest.approx(10, abs=0.01)


def test_a_foot_is_down_when_its_marker_says():
    stage, actor = stage_of()
    stage.set(actor, "speed", 3.0)
    stage.send(actor, "GO")
    stage.step(60)
    heights, phases = [], []
    for _ in range(45):
        stage.step()
        heights.append(actor.pose.translation[gaits.RIGHT, 1])
        phases.append(stage.frame.casts[0].phase[0, 0])
    lap = gaits.WALK.duration + (gaits.RUN.duration - gaits.WALK.duration) * (3.0 - 1.2) / 2.8
    late = (phases[int(np.argmin(heights))] - 0.5) * lap
    assert abs(late) < 1 / 60


@pytest.mark.parametrize(("speed", "metres_per_second"), [(1.2, 1.2), (4.0, 4.0), (2.6, 1.8 / 0.8)])
def test_a_blend_goes_its_mean_stride_in_its_mean_lap(speed, metres_per_second):
    stage, actor = stage_of()
    stage.set(actor, "speed", speed)
    stage.send(actor, "GO")
    stage.step(60)
    start = actor.root.position[2]
    stage.step(48 if speed == 2.6 else 60)
    assert actor.root.position[2] - start == pytest.approx(
        metres_per_second * (0.8 if speed == 2.6 else 1), abs=2e-3
    )


def test_layers_do_not_move_the_root():
    stage, actor = stage_of(60, ("WAVE: {motion: wave, loop: true}", "WAVE: {motion: walk, loop: true}"))
    stage.send(actor, "WAVE")
    stage.step(60)
    assert not actor.root.position.any()


def life(stage, actor, others=()):
    """Everything at once, for two seconds."""
    for tick, events in enumerate(
        [["GO"], ["WAVE"], ["NOD"], ["BOTH"], ["STILL"], ["GO", "REST"], ["CALM"], ["WAVE", "NOD"]]
    ):
        for event in events:
            stage.send(actor, event)
        stage.set(actor, "speed", (tick * 1.7) % 5)
        for number, other in enumerate(others[tick::3]):
            stage.send(other, ("GO", "WAVE", "NOD", "BOTH", "STOP")[(number + tick) % 5])
            stage.set(other, "speed", number % 5)
        stage.step(15)
    return stage


def test_one_actor_is_the_same_alone_and_in_a_crowd():
    alone, crowd = Stage(seed=1), Stage(seed=1)
    one = alone.add(gaits.role())
    many = [crowd.add(gaits.role()) for _ in range(60)]
    life(alone, one)
    life(crowd, many[0], many[1:])
    assert all(a.tobytes() == b.tobytes() for a, b in zip(one.pose, many[0].pose, strict=True))
    assert one.hash == many[0].hash


def test_a_replay_is_the_same_to_the_bit():
    stage, actor = stage_of()
    life(stage, actor, [stage.add(gaits.role()) for _ in range(5)])
    assert replay(stage.dump(), {"gaits": gaits.role()}.__getitem__).hash == stage.hash


def test_a_joint_that_is_not_there_is_named_with_its_line():
    with pytest.raises(MachineError, match=r"line 22: mask: .*'amr'; did you mean arm"):
        gaits.role(("mask: [arm]", "mask: [amr]"))


def test_clips_at_one_place_are_named_with_their_line():
    with pytest.raises(MachineError, match=r"line 1\d: .*walk.* run"):
        gaits.role(("{walk: 1.2, run: 4}", "{walk: 1.2, run: 1.2}"))


def test_the_base_needs_a_motion():
    definition = gaits.role().definition
    states = definition.states | {"STAND": replace(definition.states["STAND"], motion="")}
    with pytest.raises(MachineError, match=r"line \d+: the state STAND needs a motion"):
        Role.build("gaits", gaits.character(), replace(definition, states=states), "hips")


def test_a_blend_over_two_parameters():
    plane = (
        ("over: speed\n", "over: [speed, force]\n"),
        ("{walk: 1.2, run: 4}", "{walk: [1.2, 0], run: [4, 0], nod: [1.2, 1]}"),
    )
    stage, actor = stage_of(60, *plane, ("weight: force", "weight: 1"))
    stage.send(actor, "GO")
    stage.set(actor, "force", 1.0)
    stage.step(40)
    phase = stage.frame.casts[0].phase[0, 0]
    assert actor.pose.rotation[gaits.CHEST] == pytest.approx(
        replace(gaits.NOD, loop=True).sample(phase * 0.5).rotation[gaits.CHEST], abs=1e-5
    )

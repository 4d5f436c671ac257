"""Weights of solvers that are channels of the pose: clips key them, expressions set them."""

import numpy as np
import pytest
from builders import CLIPS, character
from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.stage.stage import Stage

TEXT = """\
character: tiny
initial: STAND
defaults: {{blend: 0}}
parameters:
  aim: {{kind: point, default: [2, 1.5, 0.3]}}
expressions: |
  {line}
states:
  STAND: {{motion: stand, loop: true}}
  HOP: {{motion: hop, loop: true}}
solvers:
  watch: {{solver: look-at, chain: [arm], target: aim, weight: {weight}}}
table: |
  state | HOP
  STAND | HOP
  HOP   |
"""


def playing(weight, line="free = 1"):
    role = Role.build("watcher", character(), read_machine(TEXT.format(weight=weight, line=line)), "hips")
    stage = Stage()
    return stage, stage.add(role)


def weights(weight, line="free = 1", ticks=120, event_at=None):
    stage, actor = playing(weight, line)
    found = []
    for tick in range(ticks):
        if tick == event_at:
            stage.send(actor, "HOP")
        stage.step()
        found.append(actor.reached["watch"].weight)
    return np.array(found)


def keyed(name, ticks):
    """What the clip keys, sampled by NumPy at the ticks of 1/60 s."""
    channel = next(channel for channel in CLIPS[name].channels if channel.path == "weights")
    seconds = np.arange(1, ticks + 1) / 60 % CLIPS[name].duration
    return np.interp(seconds, channel.times, channel.values[:, 0])


def test_a_clip_keys_the_weight_of_a_solver():
    np.testing.assert_allclose(weights("target_0.weight"), keyed("stand", 120), atol=2e-3)


def test_the_joint_turns_by_as_much_as_the_clip_keys():
    stage, actor = playing("target_0.weight")
    bare, other = playing(0)
    stage.step(30)  # the clip keys 1 at a quarter of its 2 s, 0 at three quarters
    bare.step(30)
    partly = np.abs(actor.pose.rotation[2] - other.pose.rotation[2]).max()
    stage.step(60)
    bare.step(60)
    assert partly > 0.05
    np.testing.assert_allclose(actor.pose.rotation[2], other.pose.rotation[2], atol=5e-3)


def test_a_translation_that_an_expression_sets_is_a_weight_within_0_and_1():
    found = weights("chest.trans_x", "chest.trans_x = time - 0.5", 120)
    np.testing.assert_allclose(found, np.clip(np.arange(1, 121) / 60 - 0.5, 0, 1), atol=1e-6)


def test_a_state_may_have_a_channel_as_its_weight():
    found = weights("{STAND: 0.25, HOP: chest.scale_y}", "chest.scale_y = 0.75", 60, event_at=10)
    assert found[5] == 0.25
    assert found[-1] == pytest.approx(0.75, abs=1e-3)


@pytest.mark.parametrize(
    ("weight", "says"),
    [
        ("neck.scale_x", "watch: weight: .*neck"),
        ("Smile.weight", "Smile"),
        ("chest.rotate_x", "is an angle"),
        ("chest.turn", "chest.turn"),
    ],
)
def test_a_channel_that_is_not_there_is_refused_with_its_line(weight, says):
    with pytest.raises(MachineError, match=says) as error:
        playing(weight)
    assert error.value.place == "line 12"


def test_the_handle_cannot_hold_a_weight_that_is_a_channel():
    with pytest.raises(MachineError, match="grab"):
        playing("chest.scale_x, grab: true")

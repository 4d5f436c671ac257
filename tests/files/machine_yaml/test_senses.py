"""Senses and colliders: thresholds, touches, spheres and planes; their events are columns."""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.sense_definition import ColliderDefinition, SenseDefinition, TouchDefinition

TEXT = """character: c.glb
initial: A
states: {A: {motion: a}}
table: |
  state | HIT
  A     | A!
senses:
  RUN: {when: speed > 2.0, release: speed < 1.6}
  HIT: {touch: [body, monster]}
  NEAR: {touch: [body, body], on: leave}
colliders:
  body: {sphere: 0.4, joint: Hips, at: [0, 0.5, 0]}
  door: {plane: [0, 3, -4], at: [0, 1, 0], radius: 1}
"""


def test_senses_by_the_events_that_they_raise():
    assert read_machine(TEXT).senses == {
        "RUN": SenseDefinition("speed > 2.0", "speed < 1.6", 8),
        "HIT": TouchDefinition("body", "monster", "enter", 9),
        "NEAR": TouchDefinition("body", "body", "leave", 10),
    }


def test_their_events_follow_the_columns():
    assert list(read_machine(TEXT).events) == ["HIT", "RUN", "NEAR"]


def test_colliders():
    assert read_machine(TEXT).colliders == {
        "body": ColliderDefinition("sphere", 12, "Hips", (0, 0.5, 0), 0.4),
        "door": ColliderDefinition("plane", 13, "", (0, 1, 0), 1, (0, 0.6, -0.8)),
    }


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("RUN:", "END:", "line 8: the end of a motion raises END; a sense cannot"),
        ("when: speed > 2.0, ", "", "line 8: a sense needs a condition"),
        ("[body, monster]", "[boddy, monster]", "line 9: no collider is called 'boddy'; did you mean body?"),
        ("[body, monster]", "[body]", "line 9: a touch needs two colliders"),
        ("on: leave", "on: leaves", "line 10: no kind of touch is called 'leaves'; did you mean leave?"),
        ("release: speed < 1.6", "on: enter", "line 8: `on` is for a touch"),
        ("sphere: 0.4, ", "", "line 12: a collider is either a `sphere: RADIUS` or a `plane: [x, y, z]`"),
        ("sphere: 0.4", "sphere: 0.4, radius: 1", "line 12: `radius` is for a plane"),
        ("[0, 3, -4]", "[0, 0]", "line 13: three numbers are needed, [x, y, z], not 2"),
        ("[0, 3, -4]", "[0, 0, 0]", "line 13: a plane needs a normal"),
        ("body: {sphere", "bo dy: {sphere", "line 12: 'bo dy' is no name for the collider"),
    ],
)
def test_what_is_wrong_with_a_sense(old, new, message):
    assert old in TEXT
    with pytest.raises(MachineError) as caught:
        read_machine(TEXT.replace(old, new, 1))
    assert message in str(caught.value)

"""Parameters of machine files: numbers, flags, points, directions, rotations."""

from __future__ import annotations

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.parameter_definition import ParameterDefinition

FILE = """
semantics: 1
character: a.glb
initial: A
states: {A: {motion: a}}
table: |
  state | GO
  A     | A
parameters:
  p: PARAMETER
"""


def read(text: str) -> dict[str, ParameterDefinition]:
    return dict(read_machine(FILE.replace("PARAMETER", text)).parameters)


def test_a_point_is_stored_as_three_numbers() -> None:
    found = read("{kind: point, default: [0, 1.5, 2], smooth: 0.1}")
    assert {name: part.default for name, part in found.items()} == {"p.x": 0, "p.y": 1.5, "p.z": 2}
    assert {(part.kind, part.vector, part.smooth) for part in found.values()} == {("point", "p", 0.1)}


def test_a_direction_has_unit_length() -> None:
    assert [part.default for part in read("{kind: direction, default: [0, 3, 4]}").values()] == [0, 0.6, 0.8]


def test_a_rotation_is_a_quaternion_and_by_default_none() -> None:
    found = read("{kind: rotation}")
    assert {name: part.default for name, part in found.items()} == {"p.x": 0, "p.y": 0, "p.z": 0, "p.w": 1}


def test_a_flag_is_one_number() -> None:
    assert read("{kind: flag, default: 1}") == {"p": ParameterDefinition(1, 0, 1, 10, kind="flag")}


def test_a_flag_is_0_by_default() -> None:
    assert read("{kind: flag}")["p"].default == 0


def test_a_number_may_have_a_handle_at_a_joint() -> None:
    (part,) = read("{default: 0, min: -9, max: 9, handle: {joint: Left.knee, freedom: angle}}").values()
    assert (part.joint, part.freedom, part.event) == ("Left.knee", "angle", "")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("{kind: point, handle: {joint: A, freedom: angle}}", "a handle at a joint is for numbers"),
        ("{default: 0, min: 0, max: 1, handle: {joint: A}}", "`freedom` is missing"),
        ("{kind: colour}", "colour"),
        ("{kind: point, default: 1}", "list of 3 numbers"),
        ("{kind: point, default: [1, 2]}", "list of 3 numbers"),
        ("{kind: point, min: 1, max: 2}", "needs a `default`"),
        ("{kind: point, min: 2, max: 1}", "min 2 is more than max 1"),
        ("{kind: direction, default: [0, 0, 0]}", "its length must be more than 0"),
        ("{kind: direction, min: 0}", "has no `min`"),
        ("{kind: flag, default: 0.5}", "0 or 1"),
        ("{kind: flag, default: 1, smooth: 1}", "smooth"),
        ("{kind: rotation, default: [0, 0, 1]}", "list of 4 numbers"),
        ("{kind: point, default: [0, .inf, 0]}", "number"),
    ],
)
def test_refused_with_the_line(text: str, message: str) -> None:
    with pytest.raises(MachineError) as refused:
        read(text)
    assert message in str(refused.value)
    assert "line 10" in str(refused.value)

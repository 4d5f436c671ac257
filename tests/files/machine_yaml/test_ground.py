"""`foot_lock` and `ground` of machine files."""

from __future__ import annotations

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine

FILE = """
semantics: 1
character: a.glb
initial: A
states: {A: {motion: a}}
parameters: {hold: {default: 1, min: 0, max: 1}}
table: |
  state | GO
  A     | A
LINE
"""


@pytest.mark.parametrize(
    ("text", "weight"), [("true", 1), ("false", 0), ("0.5", 0.5), ("hold", "hold"), ("on", 1)]
)
def test_a_foot_lock_is_on_off_a_share_or_a_parameter(text: str, weight: float | str) -> None:
    assert read_machine(FILE.replace("LINE", f"foot_lock: {text}")).foot_lock == weight


def test_a_step_has_one_height_everywhere() -> None:
    (step,) = read_machine(FILE.replace("LINE", "ground: [{from: [1, 2], to: [-1, 3], height: 0.2}]")).ground
    assert (step.corner, step.opposite) == ((-1, 2), (1, 3))
    assert step.heights == pytest.approx([0.2, 0.2, 0.2, 0.2])


@pytest.mark.parametrize(("axis", "heights"), [("z", [0, 0, 0.6, 0.6]), ("x", [0, 0.6, 0.6, 0])])
def test_a_slope_rises_along_its_axis(axis: str, heights: list[float]) -> None:
    text = f"ground: [{{from: [1, 2], to: [4, 5], height: [0, 0.6], along: {axis}}}]"
    (slope,) = read_machine(FILE.replace("LINE", text)).ground
    assert slope.heights == pytest.approx(heights)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("foot_lock: 2", "from 0 to 1"),
        ("foot_lock: holt", "no number"),
        ("ground: {from: [0, 0]}", "a list is needed"),
        ("ground: [{from: [0, 0], to: [1, 1]}]", "height"),
        ("ground: [{from: [0, 0], to: [0, 1], height: 1}]", "opposite corners"),
        ("ground: [{from: [0, 0], to: [1, 1, 2], height: 1}]", "two numbers"),
        ("ground: [{from: [0, 0], to: [1, 1], height: [0, 1, 2]}]", "two heights"),
        ("ground: [{from: [0, 0], to: [1, 1], height: .nan}]", "no number"),
        ("ground: [{from: [0, 0], to: [1, 1], height: 1, along: y}]", "axis"),
        ("ground: [{from: [0, 0], to: [1, 1], height: 1, hight: 2}]", "hight"),
    ],
)
def test_refused_with_the_line(text: str, message: str) -> None:
    with pytest.raises(MachineError) as refused:
        read_machine(FILE.replace("LINE", text))
    assert message in str(refused.value)
    assert "line 10" in str(refused.value)


def test_too_many_pieces_are_refused() -> None:
    pieces = "\n".join(["  - {from: [0, 0], to: [1, 1], height: 1}"] * 257)
    with pytest.raises(MachineError, match="257 pieces"):
        read_machine(FILE.replace("LINE", f"ground:\n{pieces}"))

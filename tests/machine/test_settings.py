"""Values of parameters, numbers and vectors, through a stage: what you set is what the machine reads."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.definition.parameter_definition import ParameterDefinition
from statwalk.stage.stage import Stage
from support.builders import role

POINT = {f"reach.{axis}": ParameterDefinition(0, -5, 5, 1, 0, "point", "reach") for axis in "xyz"}
AIM = {f"aim.{axis}": ParameterDefinition(0, -1, 1, 1, 0, "direction", "aim") for axis in "xyz"}
FLAG = {"open": ParameterDefinition(0, 0, 1, 1, 0, "flag")}


def after(name: str, value: float | Sequence[float]) -> dict[str, float]:
    stage = Stage(seed=1)
    actor = stage.add(role(parameters=POINT | AIM | FLAG | {"pace": ParameterDefinition(1, 0.5, 2, 1)}))
    stage.set(actor, name, value)
    stage.step()
    cast = next(iter(stage.state.casts.values()))
    names = [part.name for part in actor.role.machine.parameters]
    return dict(zip(names, cast.machine.parameters[0].tolist(), strict=True))


def test_a_point_sets_its_three_numbers() -> None:
    values = after("reach", (1, 2, -3))
    assert [values[f"reach.{axis}"] for axis in "xyz"] == [1, 2, -3]


def test_one_component_can_be_set() -> None:
    values = after("reach.y", 2.5)
    assert [values[f"reach.{axis}"] for axis in "xyz"] == [0, 2.5, 0]


def test_a_direction_is_stored_at_unit_length() -> None:
    values = after("aim", (0, 3, 4))
    assert [values[f"aim.{axis}"] for axis in "xyz"] == pytest.approx([0, 0.6, 0.8])


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("reach", 1.0, "list of 3 numbers"),
        ("reach", (1, 2), "list of 3 numbers"),
        ("reach", (0, 9, 0), "reach.y must lie in -5 … 5"),
        ("aim", (0, 0, 0), "length must be more than 0"),
        ("open", 0.5, "0 or 1"),
        ("pace", (1, 2, 3), "one number"),
        ("reach", (0, float("nan"), 0), "must lie"),
    ],
)
def test_a_value_that_does_not_fit_is_refused(name: str, value: float, message: str) -> None:
    with pytest.raises(StageError, match=message):
        after(name, value)


def test_an_unknown_name_lists_vectors_by_their_name() -> None:
    with pytest.raises(UnknownNameError, match="reach"):
        after("raech", 1)

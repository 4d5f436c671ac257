"""What a machine says of itself: title, defaults, initial states, properties, view."""

import pytest
from edit_texts import DOOR, after, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import (
    AddProperty,
    MoveProperty,
    SetDefaults,
    SetExpressions,
    SetInitial,
    SetMachine,
    SetProperty,
    SetView,
)


def test_a_title_keeps_its_comment():
    assert lines(SetMachine({"title": "The gate: a door"})) == [
        "- title: A door      # for people",
        '+ title: "The gate: a door"      # for people',
    ]


def test_settings_come_and_go():
    assert edited(DOOR, [SetMachine({"idle": "PUSH"}), SetMachine({"idle": None})]) == DOOR
    with pytest.raises(MachineError, match="'states' is no setting"):
        edited(DOOR, [SetMachine({"states": "x"})])


def test_defaults():
    blend = {"seconds": 0.1, "curve": "quintic"}
    assert came(SetDefaults({"blend": blend, "when": "end"})) == [
        "defaults: {blend: {seconds: 0.1, curve: quintic}, buffer: 0, when: end}"
    ]


def test_initial_states():
    assert came(SetInitial("OPEN")) == ["initial: OPEN"]
    assert came(SetInitial("GUARD.BOW")) == ["      initial: BOW"]
    assert came(SetInitial("LIT", layer="lamp")) == ["    initial: LIT"]


def test_properties_come_change_move_and_go():
    assert came(AddProperty("never OPEN -> GUARD")) == ["  - never OPEN -> GUARD"]
    first = "OPEN only after OPENING"
    assert came(SetProperty(first, "never OPEN -> OPENING")) == ["  - never OPEN -> OPENING"]
    assert lines(SetProperty(first, None)) == [f"-   - {first}"]
    assert after([MoveProperty(first)]).index("from SHUT") < after([MoveProperty(first)]).index(first)


@pytest.mark.parametrize(
    "operation", [AddProperty("OPEN only after OPENING"), SetProperty("x", None), MoveProperty("x")]
)
def test_a_property_that_is_there_or_not(operation):
    with pytest.raises(MachineError, match="property"):
        edited(DOOR, [operation])


def test_expressions():
    assert came(SetExpressions("Hinge.rotate_y = 3")) == ["  Hinge.rotate_y = 3"]
    assert "expressions" not in after([SetExpressions("")])


def test_places_in_the_graph():
    assert came(SetView({"SHUT": (1.5, -2), "GUARD.BOW": (0, 0)})) == [
        "    SHUT: [1.5, -2]",
        "    GUARD.BOW: [0, 0]",
    ]
    assert "view" not in after([SetView({"OPEN": None})])
    with pytest.raises(MachineError, match="did you mean OPEN"):
        edited(DOOR, [SetView({"OPNE": (0, 0)})])

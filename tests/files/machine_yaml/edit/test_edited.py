"""Operations for a text that has become another one: what they touch must be as it was."""

import pytest
from edit_texts import DOOR
from statwalk.files.machine_yaml.edit.edited import conflict, edited
from statwalk.files.machine_yaml.edit.operations import (
    AddEvent,
    AddProperty,
    AddState,
    DeleteEvent,
    DeleteState,
    EditOperation,
    MoveState,
    RenameEvent,
    RenameState,
    SetCell,
    SetEntry,
    SetState,
    SetView,
)

CELL = SetCell("SHUT", "HAIL", "OPEN")
APART = [
    (CELL, SetCell("SHUT", "PULL", "OPEN")),
    (CELL, SetCell("SHUT", "HAIL", fields={"blend": 0.5})),
    (CELL, AddState("AJAR")),
    (CELL, RenameState("GUARD", "PORTER"))
    and (SetState("OPEN", {"loop": None}), RenameState("SHUT", "CLOSED")),
    (SetState("OPEN", {"loop": None}), SetState("OPEN", {"motion": "still"})),
    (SetEntry("parameters", "pace", {"max": 3}), SetEntry("parameters", "pace", {"min": 0.5})),
    (RenameState("SHUT", "CLOSED"), SetCell("SHUT", "PUSH", "GUARD")),
    (AddState("AJAR"), AddState("LOCKED")),
    (MoveState("OPEN"), MoveState("SHUT")),
    (SetView({"OPEN": (1, 2)}), SetView({"OPEN": (3, 4)})),
    (DeleteState("LIT", also_cells=True, layer="lamp"), CELL),
]
TOGETHER = [
    (CELL, SetCell("SHUT", "HAIL", "-"), ("cell", "base", "SHUT", "HAIL", "to")),
    (CELL, RenameState("SHUT", "CLOSED"), ("name", "state", "base", "SHUT")),
    (SetCell("OPEN", "PULL", "-"), RenameEvent("PULL", "DRAW"), ("name", "event", "PULL")),
    (AddState("AJAR"), AddState("AJAR", {"motion": "x"}), ("name", "state", "base", "AJAR")),
    (RenameState("OPEN", "AJAR"), AddState("AJAR"), ("name", "state", "base", "AJAR")),
    (SetState("OPEN", {"loop": None}), SetState("OPEN", {"loop": False}), ("state", "base", "OPEN", "loop")),
    (DeleteState("OPEN", True), SetCell("SHUT", "PULL", "OPEN"), ("cell", "base", "SHUT", "PULL", "to")),
    (DeleteState("OPEN", True), AddProperty("never OPEN -> GUARD"), ("property", "never OPEN -> GUARD")),
    (DeleteEvent("PULL", True), SetCell("GUARD", "PULL", "-"), ("cell", "base", "GUARD", "PULL", "to")),
    (AddEvent("KNOCK"), AddEvent("KNOCK", before="END"), ("column", "base", "", "KNOCK")),
    (
        SetCell("SHUT", "PUSH", ""),
        SetCell("SHUT", "PUSH", fields={"blend": 1}),
        ("cell", "base", "SHUT", "PUSH", "blend"),
    ),
]


@pytest.mark.parametrize(("mine", "other"), APART)
def test_two_edits_that_do_not_touch_the_same(mine: EditOperation, other: EditOperation) -> None:
    newest = edited(DOOR, [other])
    assert conflict(DOOR, newest, [mine]) is None
    assert edited(newest, [mine]) != newest


@pytest.mark.parametrize(("mine", "other", "part"), TOGETHER)
def test_two_edits_of_the_same(mine: EditOperation, other: EditOperation, part: tuple[str, ...]) -> None:
    assert conflict(DOOR, edited(DOOR, [other]), [mine]) == part

"""What differs between two versions of a machine: names, cells, other parts."""

from edit_texts import DOOR
from statwalk.files.machine_yaml.edit.differences import (
    CellDifference,
    Differences,
    NameDifference,
    PartDifference,
    differences,
)
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import (
    AddState,
    DeleteEvent,
    EditOperation,
    RenameEvent,
    RenameState,
    SetCell,
    SetEntry,
)


def found(*operations: EditOperation) -> Differences:
    return differences(DOOR, edited(DOOR, operations))


def test_the_same_text_differs_in_nothing() -> None:
    assert differences(DOOR, DOOR.replace("# of the draught", "# another comment")) == Differences([], [], [])


def test_cells_with_their_fields() -> None:
    assert found(SetCell("SHUT", "PUSH", "GUARD"), SetCell("OPEN", "PULL", "")).cells == [
        CellDifference(
            "base",
            "SHUT",
            "PUSH",
            "OPENING {blend: 0.5, action: raise(PULL, all)}",
            "GUARD {blend: 0.5, action: raise(PULL, all)}",
        ),
        CellDifference("base", "OPEN", "PULL", "SHUT", None),
    ]


def test_a_renamed_state_is_one_difference() -> None:
    assert found(RenameState("OPEN", "AJAR"), SetCell("AJAR", "PULL", "-")) == Differences(
        [NameDifference("state", "base", "OPEN", "AJAR")],
        [CellDifference("base", "AJAR", "PULL", "SHUT", "-")],
        [],
    )


def test_new_and_gone_names_and_other_parts() -> None:
    shown = found(
        AddState("AJAR", {"motion": "still"}),
        RenameEvent("HAIL", "GREET"),
        DeleteEvent("PULL", True),
        SetEntry("parameters", "pace", {"max": 3}),
    )
    assert sorted(shown.names, key=str) == [
        NameDifference("event", "", "HAIL", "GREET"),
        NameDifference("event", "", "PULL", None),
        NameDifference("state", "base", None, "AJAR"),
    ]
    assert PartDifference(("parameter", "pace", "max"), "2", "3") in shown.parts
    assert PartDifference(("key", "ArrowUp", "release"), "PULL", None) in shown.parts

"""The clips of a blend, and markers."""

import pytest
from edit_texts import DOOR, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import (
    DeleteBlendClip,
    MoveBlendClip,
    SetBlendClip,
    SetContacts,
    SetMarker,
)
from statwalk.files.machine_yaml.edit.parts import parts_of
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.files.machine_yaml.machine_text import MachineText


def test_a_clip_moves_on_the_pad_and_another_comes():
    assert came(SetBlendClip("OPEN", "swing", 0.75)) == ["      clips: {still: 0, swing: 0.75}"]
    assert came(SetBlendClip("OPEN", "slam", 0.5)) == ["      clips: {still: 0, swing: 1, slam: 0.5}"]


def test_a_clip_goes_with_its_markers():
    marked = edited(DOOR, [SetBlendClip("OPEN", "slam", 0.5), SetMarker("OPEN", "shut", 0.9, "slam")])
    assert "      markers: {slam: {shut: 0.9}}" in marked
    assert edited(marked, [DeleteBlendClip("OPEN", "slam")]) == DOOR


def test_another_clip_comes_first_and_last_again():
    assert came(MoveBlendClip("OPEN", "swing", "still")) == ["      clips: {swing: 1, still: 0}"]
    there = edited(DOOR, [MoveBlendClip("OPEN", "swing", "still")])
    assert edited(there, [MoveBlendClip("OPEN", "swing")]) == DOOR


def test_a_marker_comes_moves_and_goes():
    assert came(SetMarker("SHUT", "click", 0.1)) == [
        "  SHUT:    {motion: shut, loop: true, markers: {click: 0.1}}"
    ]
    assert came(SetMarker("OPENING", "half", 0.4)) == [
        "  OPENING: {motion: open, markers: {half: 0.4}}     # slowly"
    ]
    assert edited(DOOR, [SetMarker("SHUT", "click", 0.1), SetMarker("SHUT", "click", None)]) == DOOR


def test_the_only_marker_takes_the_member_along():
    text = edited(DOOR, [SetMarker("SHUT", "click", 0.1)])
    assert lines(SetMarker("SHUT", "click", None), text=text)[1] == "+   SHUT:    {motion: shut, loop: true}"


LEFT = SetContacts("swing", "left", [(0, 0.6), (0.9, 1.1)])


def test_contacts_come_change_and_go():
    assert came(LEFT) == ["", "contacts:", "  swing: {left: [[0, 0.6], [0.9, 1.1]]}"]
    other = edited(
        DOOR, [LEFT, SetContacts("swing", "right", []), SetContacts("swing", "left", [(0.2, 0.3)])]
    )
    contacts = {name: spans.spans for name, spans in read_machine(other).contacts["swing"].items()}
    assert contacts == {"left": ((0.2, 0.3),), "right": ()}
    assert edited(DOOR, [LEFT, SetContacts("swing", "left", None)]) == DOOR


def test_contacts_of_two_feet_are_two_parts():
    assert set(LEFT.touched()) == {("contacts", "swing", "left")}
    parts = parts_of(MachineText(edited(DOOR, [LEFT, SetContacts("swing", "right", [])]), {}))
    assert {part for part in parts if part[0] == "contacts"} == {
        ("contacts", "swing", "left"),
        ("contacts", "swing", "right"),
    }


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (SetBlendClip("SHUT", "swing", 0), "SHUT plays no blend"),
        (DeleteBlendClip("OPEN", "swnig"), "did you mean swing"),
        (MoveBlendClip("OPEN", "swing", "stil"), "did you mean still"),
        (SetMarker("OPENING", "hlaf", None), "did you mean half"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])

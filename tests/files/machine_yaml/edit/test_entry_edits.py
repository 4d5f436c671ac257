"""Parameters, senses, keys and colliders: entries that are added, changed, moved and deleted."""

import pytest
from edit_texts import DOOR, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import AddEntry, DeleteEntry, MoveEntry, SetEntry

PACE = {"default": 1, "min": 0, "max": 3}


def test_a_new_entry_comes_last_or_before_another():
    assert came(AddEntry("parameters", "heat", PACE)) == ["  heat: {default: 1, min: 0, max: 3}"]
    text = edited(DOOR, [AddEntry("parameters", "heat", PACE, before="pace")])
    assert text.index("heat:") < text.index("pace:")


def test_the_first_entry_makes_the_section():
    collider = {"sphere": 0.4, "joint": "Hips", "at": [0, 0, 0]}
    assert came(AddEntry("colliders", "body", collider)) == [
        "",
        "colliders:",
        "  body: {sphere: 0.4, joint: Hips, at: [0, 0, 0]}",
    ]


def test_none_takes_nothing_away_from_a_new_entry():
    assert came(AddEntry("keys", "s", {"press": "PULL", "hold": None})) == ["  s:       {press: PULL}"]


def test_values_stay_in_their_column():
    assert came(AddEntry("keys", "s", {"press": "PULL"})) == ["  s:       {press: PULL}"]


def test_members_change_and_the_comment_stays():
    assert lines(SetEntry("parameters", "wind", {"max": 0.5, "smooth": None})) == [
        "-   wind: {default: 0, min: 0, max: 1, smooth: 0.2}   # of the draught",
        "+   wind: {default: 0, min: 0, max: 0.5}   # of the draught",
    ]


def test_the_last_entry_takes_its_section_along():
    assert [line for line in lines(DeleteEntry("senses", "HAIL")) if line[0] == "+"] == []
    assert "senses:" not in edited(DOOR, [DeleteEntry("senses", "HAIL")])


def test_an_entry_moves():
    text = edited(DOOR, [MoveEntry("parameters", "wind", "pace")])
    assert text.index("wind: {") < text.index("pace: {")
    assert edited(text, [MoveEntry("parameters", "wind")]) == DOOR


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (AddEntry("parameters", "pace", PACE), "there is a parameter pace already"),
        (AddEntry("parameters", "a b", PACE), "no name for the parameter"),
        (AddEntry("keys", "s", {}, before="x"), "no key is called 'x'"),
        (SetEntry("parameters", "pcae", PACE), "did you mean pace"),
        (DeleteEntry("senses", "X"), "no sense is called 'X'"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])

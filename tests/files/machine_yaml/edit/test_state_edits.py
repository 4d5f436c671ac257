"""States that are added, changed, renamed and moved: the lines that go and come, and no other."""

import pytest
from edit_texts import DOOR, after, came, lines
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.operations import AddState, MoveState, RenameState, SetState


def test_a_new_state_gets_a_row():
    assert came(AddState("AJAR", {"motion": "still", "loop": True}, before="OPEN")) == [
        "  AJAR:    {motion: still, loop: true}",
        "  AJAR    |         |      |       |      |",
    ]


def test_it_stands_before_the_state_that_it_names():
    text = after([AddState("AJAR", before="OPEN")])
    assert text.index("AJAR:") < text.index("  OPEN:\n") < text.index("AJAR    |") < text.index("OPEN    |")


def test_without_a_motion_it_is_at_rest():
    assert came(AddState("AJAR"))[0] == '  AJAR:    {motion: {expressions: ""}}'
    assert came(AddState("DIM", layer="lamp"))[0].endswith("DIM: {motion: none}}")


def test_in_a_sub_machine():
    assert came(AddState("GUARD.NAP", {"motion": "nap"})) == [
        "      states: {STAND: {motion: stand}, BOW: {motion: bow, final: true}, NAP: {motion: nap}}",
        "        NAP   |",
    ]


def test_members_change_and_go():
    assert lines(SetState("SHUT", {"motion": "closed", "loop": None, "speed": "pace"})) == [
        "-   SHUT:    {motion: shut, loop: true}",
        "+   SHUT:    {motion: closed, speed: pace}",
    ]


def test_a_motion_in_several_lines_becomes_a_clip():
    assert lines(SetState("OPEN", {"motion": "swing"})) == [
        "-     motion:                                         # it swings",
        "+     motion: swing                                         # it swings",
        "-       over: wind",
        "-       clips: {still: 0, swing: 1}",
    ]


def test_a_clip_becomes_a_blend():
    blend = {"over": ["pace", "wind"], "clips": {"a": [0, 0], "b": [1, 1]}}
    assert came(SetState("SHUT", {"motion": blend})) == [
        "  SHUT:    {motion: {over: [pace, wind], clips: {a: [0, 0], b: [1, 1]}}, loop: true}"
    ]


def test_a_name_goes_with_all_that_speaks_of_it():
    assert lines(RenameState("OPEN", "AJAR")) == [
        "-   OPEN:",
        "+   AJAR:",
        "-         BOW   | OPEN at end",
        "+         BOW   | AJAR at end",
        "-   OPENING | SHUT at half |      |       | SHUT | OPEN",
        "+   OPENING | SHUT at half |      |       | SHUT | AJAR",
        "-   OPEN    |         | SHUT |       |      |",
        "+   AJAR    |         | SHUT |       |      |",
        "-   OPEN/PUSH:  [{if: wind > 0.5, to: SHUT}, {to: OPEN}]",
        "+   AJAR/PUSH:  [{if: wind > 0.5, to: SHUT}, {to: AJAR}]",
        "-   OPEN/HAIL:  {SHUT: 4, OPENING: 1}",
        "+   AJAR/HAIL:  {SHUT: 4, OPENING: 1}",
        "-   w:       {change: {OPEN: {wind: 1}}}",
        "+   w:       {change: {AJAR: {wind: 1}}}",
        "-   - OPEN only after OPENING",
        "+   - AJAR only after OPENING",
        "-   - from SHUT, PUSH reaches OPEN within 2 s",
        "+   - from SHUT, PUSH reaches AJAR within 2 s",
        "-     OPEN: [10, 20]",
        "+     AJAR: [10, 20]",
    ]


def test_a_longer_name_widens_its_column():
    text = after([RenameState("SHUT", "SHUT_TIGHT", layer="base")])
    assert "  state      | PUSH    " in text
    assert "  SHUT_TIGHT | OPENING " in text


def test_a_composite_state_and_a_state_within():
    assert '  "*/PULL":   {to: PORTER.BOW, when: marker half}' in came(RenameState("GUARD", "PORTER"))
    assert '  "*/PULL":   {to: GUARD.NOD, when: marker half}' in came(RenameState("GUARD.BOW", "NOD"))


def test_another_layer_keeps_its_names():
    assert came(RenameState("OFF", "DARK", layer="lamp")) == [
        "    initial: DARK",
        "    states: {DARK: {motion: none}, LIT: {motion: glow}}",
        "      DARK  | LIT",
    ]


@pytest.mark.parametrize(
    ("operation", "words"),
    [
        (RenameState("OPEN", "SHUT"), "there is a state SHUT already"),
        (RenameState("OPEN", "a b"), "no name for the state"),
        (RenameState("OPNE", "X"), "did you mean OPEN"),
        (RenameState("OPEN", "BOW"), "would be taken for another state in GUARD"),
        (RenameState("GUARD.STAND", "OPEN"), "would be taken for another state in GUARD"),
        (AddState("OPEN"), "there is a state OPEN already"),
        (AddState("X", before="Y"), "no state is called 'Y'"),
        (AddState("ATTIC.X"), "no sub-machine is called 'ATTIC'"),
        (MoveState("SHUT", "GUARD.BOW"), "no state is called 'GUARD.BOW'"),
    ],
)
def test_refused(operation, words):
    with pytest.raises(MachineError, match=words):
        edited(DOOR, [operation])


def test_a_state_moves_with_its_row():
    text = after([MoveState("OPEN", "SHUT")])
    assert (
        text.index("  OPEN:\n") < text.index("  SHUT: ") < text.index("OPEN    |") < text.index("SHUT    |")
    )


def test_moved_there_and_back_it_is_the_same_text():
    assert edited(DOOR, [MoveState("OPEN", "SHUT"), MoveState("OPEN", "GUARD")]) == DOOR

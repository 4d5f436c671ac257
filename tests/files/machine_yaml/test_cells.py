"""What a cell may say beyond the next state: moments, blends, phases to enter at, actions, alternatives,
weights, off.
"""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.cell_definition import ActionDefinition, AlternativeDefinition, CellTiming

TABLE = """character: c.glb
initial: A
parameters: {stamina: {default: 5, min: 0, max: 20}}
states:
  A: {motion: a}
  B: {motion: b}
  C: {motion: c}
table: |
  state | GO           | HIT
  A     | B at left-up | -
cells:
"""


def cell(said: str, place: str = "A/GO"):
    state, event = place.split("/")
    return read_machine(f"{TABLE}  {place}: {said}\n").cells[state, event]


@pytest.mark.parametrize(
    ("said", "moment"),
    [
        ("now", CellTiming("now")),
        ("end", CellTiming("end")),
        ("marker left-down", CellTiming("marker", marker="left-down")),
        ("window 0.2..0.6", CellTiming("window", first=0.2, last=0.6)),
        ("window .9..0.1", CellTiming("window", first=0.9, last=0.1)),
    ],
)
def test_when(said, moment):
    assert cell(f"{{when: {said}}}").when == moment


def test_the_table_itself_may_name_a_marker():
    found = cell("{blend: 0.1}")
    assert (found.to, str(found.when), found.blend, found.curve) == ("B", "marker left-up", 0.1, None)


def test_blend_with_its_curve():
    found = cell("{blend: {seconds: 0.1, curve: quintic}}")
    assert (found.blend, found.curve) == (0.1, "quintic")
    assert (cell("{blend: {curve: quintic}}").blend, cell("{blend: 0}").blend) == (None, 0)


def test_enter_is_a_phase_or_a_match():
    assert (cell("{enter: 0.15}").enter, cell("{enter: match}").enter, cell("{blend: 0}").enter) == (
        0.15,
        "match",
        None,
    )


@pytest.mark.parametrize(
    ("said", "name", "arguments"),
    [
        ("scream", "scream", ()),
        ("drop()", "drop", ()),
        ('"drop(coins, 3)"', "drop", ("coins", 3.0)),
        ('"raise(HIT, other)"', "raise", ("HIT", "other")),
        ('"say(1_0, nan)"', "say", ("1_0", "nan")),
    ],
)
def test_actions_have_arguments(said, name, arguments):
    assert cell(f"{{action: {said}}}").action == ActionDefinition(name, arguments)


def test_off_keeps_what_the_cell_says():
    found = cell("{off: true}")
    assert (found.off, found.to, str(found.when)) == (True, "B", "marker left-up")
    assert cell("{off: true}", "B/GO").off
    assert not cell("{off: false}").off


def test_what_a_dash_says_is_not_changed_by_more_words():
    assert cell("{blend: 0.1}", "A/HIT").off


def test_alternatives():
    found = cell("[{if: stamina > 10, to: C!, blend: 0.5, enter: match, action: cheer}, {to: A}]")
    assert (found.to, found.line) == ("", 12)
    assert found.alternatives == (
        AlternativeDefinition(
            "C", 12, True, "stamina > 10", None, 0.5, None, "match", ActionDefinition("cheer")
        ),
        AlternativeDefinition("A", 12),
    )


def test_alternatives_beside_what_they_share():
    found = cell("{to: [{if: stamina > 10, to: C}], when: end, blend: 0.4}")
    assert (str(found.when), found.blend, [one.to for one in found.alternatives]) == ("end", 0.4, ["C"])


@pytest.mark.parametrize("said", ["{B: 4, C!: 1}", "{to: {B: 4, C!: 1}}"])
def test_weights(said):
    assert [(one.to, one.restart, one.weight) for one in cell(said).alternatives] == [
        ("B", False, 4.0),
        ("C", True, 1.0),
    ]


def test_a_name_in_alternatives_that_does_not_exist_is_kept_for_the_verifier():
    assert [one.to for one in cell("{B: 4, D: 1}").alternatives] == ["B", "D"]


def test_names_that_are_no_states_have_a_limit():
    rows = "".join(f"  A/E{number}: {{to: X{number}}}\n" for number in range(101))
    columns = " | ".join(f"E{number}" for number in range(101))
    text = (
        TABLE.replace("state | GO           | HIT\n  A     | B at left-up | -", f"state | {columns}") + rows
    )
    with pytest.raises(MachineError, match=r"line 11: 101 names in the cells are no states, for example X0"):
        read_machine(text)

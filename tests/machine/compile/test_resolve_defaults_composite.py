"""Defaults of sub-machines: from inside out, exact before default; END of the outer state only where a final
one ends.
"""

import pytest
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.resolve_defaults import landings, resolve_defaults

TEXT = """character: c.glb
initial: WALK
states:
  WALK: {motion: walk, loop: true}
  FIGHT:
    RESUME
    machine:
      initial: GUARD
      states:
        GUARD: {motion: guard, loop: true}
        HIT: {motion: hit, final: true}
        COMBO:
          machine:
            initial: LEFT
            states: {LEFT: {motion: left}, RIGHT: {motion: right, final: true}}
            cells: {LEFT/END: {to: RIGHT}}
          FINAL
      cells: {CELLS}
events: {A: {}, B: {}, C: {}}
table: |
  state | A
  WALK  | FIGHT
cells: {OUTSIDE}
"""


def definition(cells="", outside="", resume="", final=""):
    text = (
        TEXT.replace("CELLS", cells).replace("OUTSIDE", outside).replace("RESUME", resume or "resume: false")
    )
    return read_machine(text.replace("FINAL", final or "resume: false"))


def to(state, event, **said):
    cell = resolve_defaults(definition(**said)).get((state, event))
    return (cell.to, cell.source) if cell else None


ORDER = [
    ("cells", "GUARD/A: {to: HIT}", ("FIGHT.HIT", "cell")),
    ("cells", "GUARD/*: {to: COMBO}", ("FIGHT.COMBO.LEFT", "row default")),
    ("cells", '"*/A": {to: WALK}', ("WALK", "column default in FIGHT")),
    ("cells", '"*/*": {to: COMBO.RIGHT}', ("FIGHT.COMBO.RIGHT", "table default in FIGHT")),
    ("outside", "FIGHT/A: {to: FIGHT.HIT}", ("FIGHT.HIT", "cell of FIGHT")),
    ("outside", "FIGHT/*: {to: WALK}", ("WALK", "row default of FIGHT")),
    ("outside", '"*/A": {to: FIGHT.COMBO.RIGHT}', ("FIGHT.COMBO.RIGHT", "column default")),
    ("outside", '"*/*": {to: WALK}', ("WALK", "table default")),
]


@pytest.mark.parametrize("first", range(len(ORDER)))
def test_the_first_that_exists_counts(first):
    said = {
        where: ", ".join(text for place, text, _ in ORDER[first:] if place == where)
        for where in ("cells", "outside")
    }
    assert to("FIGHT.GUARD", "A", **said) == ORDER[first][2]


def test_defaults_reach_through_two_outer_states():
    assert to("FIGHT.COMBO.LEFT", "A", cells="COMBO/A: {to: GUARD}") == ("FIGHT.GUARD", "cell of FIGHT.COMBO")
    assert to("FIGHT.COMBO.LEFT", "A", outside="FIGHT/A: {to: WALK}") == ("WALK", "cell of FIGHT")
    assert to("WALK", "B", cells='"*/B": {to: GUARD}') is None


def test_end_of_the_outer_state_comes_when_a_final_one_ends():
    outside = "FIGHT/END: {to: WALK}"
    assert to("FIGHT.HIT", "END", outside=outside) == ("WALK", "cell of FIGHT")
    assert to("FIGHT.GUARD", "END", outside=outside) is None


def test_end_reaches_outwards_only_through_what_is_final():
    outside = "FIGHT/END: {to: WALK}"
    assert to("FIGHT.COMBO.RIGHT", "END", outside=outside) is None
    assert to("FIGHT.COMBO.RIGHT", "END", outside=outside, final="final: true") == ("WALK", "cell of FIGHT")
    assert to("FIGHT.COMBO.RIGHT", "END", cells="COMBO/END: {to: GUARD}") == (
        "FIGHT.GUARD",
        "cell of FIGHT.COMBO",
    )


def test_a_star_as_a_row_is_for_every_end_but_as_an_event_for_none():
    assert to("FIGHT.GUARD", "END", outside='"*/END": {to: WALK}') == ("WALK", "column default")
    assert to("FIGHT.GUARD", "END", cells='"*/END": {to: HIT}') == ("FIGHT.HIT", "column default in FIGHT")
    assert (
        to("FIGHT.HIT", "END", cells='"*/*": {to: GUARD}', outside='"*/*": {to: WALK}, FIGHT/*: {to: WALK}')
        is None
    )


def test_an_outer_state_as_target_is_its_initial_inner_one():
    cell = resolve_defaults(definition())["WALK", "A"]
    assert (cell.to, cell.resume) == ("FIGHT.GUARD", "")


def test_with_resume_it_is_the_one_left_last():
    machine = definition(resume="resume: true")
    cell = resolve_defaults(machine)["WALK", "A"]
    assert (cell.to, cell.resume) == ("FIGHT.GUARD", "FIGHT")
    assert landings(machine, cell.choices[0]) == (
        "FIGHT.GUARD",
        "FIGHT.HIT",
        "FIGHT.COMBO.LEFT",
        "FIGHT.COMBO.RIGHT",
    )


def test_of_two_that_resume_the_outer_one_counts():
    text = (
        TEXT.replace("initial: GUARD", "initial: COMBO")
        .replace("RESUME", "resume: true")
        .replace("FINAL", "resume: true")
    )
    cells = resolve_defaults(
        read_machine(text.replace("CELLS", "GUARD/B: {to: COMBO}").replace("OUTSIDE", ""))
    )
    assert (cells["WALK", "A"].to, cells["WALK", "A"].resume) == ("FIGHT.COMBO.LEFT", "FIGHT")
    assert (cells["FIGHT.GUARD", "B"].to, cells["FIGHT.GUARD", "B"].resume) == (
        "FIGHT.COMBO.LEFT",
        "FIGHT.COMBO",
    )


def test_begin_anew_does_not_resume():
    cell = resolve_defaults(definition(resume="resume: true", outside="WALK/B: {to: FIGHT!}"))["WALK", "B"]
    assert (cell.to, cell.resume, cell.restart) == ("FIGHT.GUARD", "", True)


def test_an_outer_state_that_names_itself_stays_where_it_is():
    assert to("FIGHT.HIT", "B", outside="FIGHT/B: {to: FIGHT}")[0] == "FIGHT.HIT"
    assert to("FIGHT.HIT", "B", outside="FIGHT/B: {to: FIGHT!}")[0] == "FIGHT.GUARD"
    assert to("FIGHT.HIT", "B", cells="HIT/B: {to: FIGHT}")[0] == "FIGHT.GUARD"


def test_alternatives_take_from_their_cell_what_they_leave_out():
    said = (
        "WALK/B: {to: [{if: speed > 1, to: FIGHT, blend: 0.5}, {to: WALK!, enter: 0.3, action: shout}], MORE}"
    )
    said = said.replace("MORE", "blend: 0.1, action: hop, enter: match")
    first, second = resolve_defaults(definition(outside=said))["WALK", "B"].alternatives
    assert (first.to, first.condition, first.blend, str(first.action), first.enter) == (
        "FIGHT.GUARD",
        "speed > 1",
        0.5,
        "hop",
        "match",
    )
    assert (second.to, second.restart, second.blend, str(second.action), second.enter) == (
        "WALK",
        True,
        0.1,
        "shout",
        0.3,
    )


def test_a_star_does_not_stand_for_markers():
    machine = definition(outside='"*/*": {to: WALK}, "*/C": {to: WALK}')
    assert ("WALK", "B") in resolve_defaults(machine)
    assert ("WALK", "B") not in resolve_defaults(machine, markers=("B", "C"))
    assert ("WALK", "C") in resolve_defaults(machine, markers=("B", "C"))

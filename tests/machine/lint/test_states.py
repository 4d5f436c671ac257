"""Faults of states: unknown names, what cannot be reached or left, cycles that take no time."""

from lint_findings import found
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.verify import verify


def test_undefined_states_are_named_once_with_all_their_cells():
    assert found("state | GO | X | END\nALFA | BETA | BET |\nBETA | BET | | ALFA", "ALFA BETA") == [
        (
            "undefined state",
            "BET is no state; did you mean BETA? It stands in ALFA/X (line 8), BETA/GO (line 9)",
        )
    ]


def test_an_undefined_state_that_no_name_is_like():
    assert found("state | GO | END\nALFA | BETA | XYZ\nBETA | | ALFA", "ALFA BETA") == [
        ("undefined state", "XYZ is no state. It stands in ALFA/END (line 8)")
    ]


def test_unreachable_and_states_without_exit():
    assert found("state | GO\nA | B\nB | B\nC | A", "A B C") == [
        ("unreachable state", "C cannot be reached from A"),
        ("no exit", "B cannot be left (A -GO-> B)"),
    ]


def test_a_held_input_that_swings():
    assert found("state | GO | END\nA | B | B\nB | A | A") == [
        ("cycle without time", "GO held down changes the state in every tick: A -> B -> A")
    ]
    assert found("state | GO | END\nA | B | B\nB | A at end | A") == []


def test_cycles_of_motions_that_take_no_time():
    table = "state | GO | END\nA | | B\nB | | A"
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 0})] == [
        "cycle without time",
        "unused event",
    ]
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 1})] == ["unused event"]


def test_a_dash_under_end_is_no_cycle_whatever_is_idle():
    """The idle event takes the place of an END that is blank, not of one that is `-`."""
    for end, times in (("", 2), ("-", 1)):  # once for STOP held down, which swings as well
        table = f"state | STOP | END\nA | B | {end}\nB | A | {end}"
        assert [kind for kind, _ in found(table, more="idle: STOP\n", motions={"A": 0, "B": 0})] == [
            "cycle without time"
        ] * times


def test_alternatives_lead_to_all_their_states():
    assert (
        found(
            "state | GO | END\nA | |\nB | | A\nC | | A",
            "A B C",
            "cells: {A/GO: [{if: speed > 1, to: B}, {to: C}]}\n",
        )
        == []
    )


def test_an_undefined_state_among_alternatives():
    kinds = found(
        "state | GO | END\nALFA | |\nBETA | | ALFA",
        "ALFA BETA",
        "cells: {ALFA/GO: [{if: speed > 1, to: BET}, {to: BETA}]}\n",
    )
    assert kinds == [
        ("undefined state", "BET is no state; did you mean BETA? It stands in ALFA/GO (line 10)")
    ]


OUTER = """character: c.glb
initial: A
states: {A: {motion: m}, B: {machine: {initial: IN, states: {IN: {motion: m}, OUT: {motion: m%s}}}}}
table: |
  state | GO | END
  A     | B  |
  B     | A  | A
cells:
  B.IN/END: {to: B.IN}
"""


def test_an_outer_state_that_never_ends():
    first, second = (
        [(one.kind, one.message) for one in verify(read_machine(OUTER % final))]
        for final in ("", ", final: true")
    )
    assert ("cell never fires", "B never ends: none of its states is marked `final`") in first
    assert ("cell never fires", "B never ends: B.OUT cannot be reached") in second

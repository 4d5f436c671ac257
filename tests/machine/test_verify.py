"""What is found in a table without running it."""

from dataclasses import replace

from statwalk.files.machinefile import read_machine
from statwalk.machine.built.build import MotionFacts
from statwalk.machine.checking.verify import verify
from ticking import text_of


def found(table, states="A B", more="", motions=None):
    """(kind, message) of each finding."""
    ticks = dict.fromkeys(states.split(), 60)
    facts = None if motions is None else {name: MotionFacts(seconds) for name, seconds in motions.items()}
    return [(one.kind, one.message) for one in verify(read_machine(text_of(table, ticks, more)), facts)]


def test_nothing_is_wrong_with_a_table_where_nothing_is_wrong():
    assert found("state | GO | END\nA | B | \nB | | A") == []


def test_undefined_states_are_named_once_with_all_their_cells():
    assert found("state | GO | X | END\nALFA | BETA | BET |\nBETA | BET | | ALFA", "ALFA BETA") == [
        ("undefined state", "BET is no state; did you mean BETA? It stands in ALFA/X (line 8), BETA/GO (line 9)")
    ]


def test_unreachable_and_states_without_exit():
    assert found("state | GO\nA | B\nB | B\nC | A", "A B C") == [
        ("unreachable state", "C cannot be reached from A"),
        ("no exit", "B cannot be left (A -GO-> B)"),
    ]


def test_events_that_no_cell_answers():
    assert found("state | GO | NEVER | END\nA | B | - |\nB | | | A") == [("unused event", "no cell answers NEVER")]


def test_defaults_that_never_count():
    assert found("state | GO\nA | B\nB | A at end", more='cells: {"*/GO": {to: A}}') == [
        ("cell never fires", "*/GO never counts: other cells come before it")
    ]


def test_a_held_input_that_swings():
    assert found("state | GO | END\nA | B | B\nB | A | A") == [
        ("cycle without time", "GO held down changes the state in every tick: A -> B -> A")
    ]
    assert found("state | GO | END\nA | B | B\nB | A at end | A") == []


def test_cycles_of_motions_that_take_no_time():
    table = "state | GO | END\nA | | B\nB | | A"
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 0})] == ["cycle without time", "unused event"]
    assert [kind for kind, _ in found(table, motions={"A": 0, "B": 1})] == ["unused event"]


def test_a_dash_under_end_is_no_cycle_whatever_is_idle():
    """The idle event takes the place of an END that is blank, not of one that is `-`."""
    for end, times in (("", 2), ("-", 1)):  # once for STOP held down, which swings as well
        table = f"state | STOP | END\nA | B | {end}\nB | A | {end}"
        assert [kind for kind, _ in found(table, more="idle: STOP\n", motions={"A": 0, "B": 0})] == ["cycle without time"] * times


def test_motions_unknown_and_unused():
    assert found("state | GO | END\nA | B |\nB | | A", motions={"A": 1, "BB": 1}) == [
        ("unknown motion", "B has no motion 'B'; did you mean BB?"),
        ("unused motion", "no state uses the motion 'BB'"),
    ]


def test_parameters_unknown_and_unused():
    text = text_of("state | GO\nA | A", {"A": 60}, "parameters: {pace: {default: 1, min: 0, max: 2}}\n")
    assert [(one.kind, one.message) for one in verify(read_machine(text.replace("loop: false", "speed: pase")))] == [
        ("unknown parameter", "the speed of A is 'pase', which is no parameter; did you mean pace?"),
        ("unused parameter", "nobody uses the parameter pace"),
    ]


PARAMETERS = "parameters: {pace: {default: 1, min: 0, max: 2}}\n"


def test_a_condition_uses_a_parameter():
    assert found("state | GO | END\nA | | B\nB | | A", more=PARAMETERS + "cells: {A/GO: [{if: pace > 1, to: B}]}\n") == []


def test_conditions_that_are_always_true():
    more = "cells: {A/GO: [{if: 2 > 1, to: B}, {to: A}]}\n"
    assert found("state | GO | END\nA | | B\nB | | A", more=more) == [("condition", "A/GO: '2 > 1' is always true")]


def test_a_condition_that_cannot_be_read():
    definition = read_machine(text_of("state | GO | END\nA | | B\nB | | A", {"A": 1, "B": 1}, "senses: {GO: {when: speed > 1}}\n"))
    broken = replace(definition, senses={"GO": replace(definition.senses["GO"], when="sped > 1")})
    assert "no name is called 'sped'; did you mean speed?" in next(one.message for one in verify(broken) if one.kind == "condition")


def test_a_weight_of_nothing_is_never_drawn():
    assert found("state | GO | END\nA | | B\nB | | A\nC | A | A", "A B C", "cells: {A/GO: {to: {B: 1, C: 0}}}\n") == [
        ("unreachable state", "C cannot be reached from A"),
        ("outcome never chosen", "A/GO: C is never chosen, its weight is 0"),
    ]


def test_nothing_is_chosen_after_what_is_always_true():
    definition = read_machine(
        text_of("state | GO | END\nA | | B\nB | | A", {"A": 1, "B": 1}, "cells: {A/GO: [{if: speed > 1, to: A}, {to: B}]}\n")
    )
    cell = definition.cells["A", "GO"]
    cells = {**definition.cells, ("A", "GO"): replace(cell, alternatives=cell.alternatives[::-1])}
    assert [one.message for one in verify(replace(definition, cells=cells))] == ["A/GO: A is never chosen, B before it has no condition"]


def test_alternatives_lead_to_all_their_states():
    assert found("state | GO | END\nA | |\nB | | A\nC | | A", "A B C", "cells: {A/GO: [{if: speed > 1, to: B}, {to: C}]}\n") == []


def test_an_undefined_state_among_alternatives():
    kinds = found("state | GO | END\nALFA | |\nBETA | | ALFA", "ALFA BETA", "cells: {ALFA/GO: [{if: speed > 1, to: BET}, {to: BETA}]}\n")
    assert kinds == [("undefined state", "BET is no state; did you mean BETA? It stands in ALFA/GO (line 10)")]


def test_markers_unknown_unused_and_missing():
    text = text_of("state | GO | END\nA | B at foot | B\nB | A at hand | A", {"A": 60, "B": 60})
    text = text.replace("{motion: A, loop: false}", "{motion: A, markers: {foot: 0.5, toe: 0.6}}")
    said = [(one.kind, one.severity, one.message) for one in verify(read_machine(text), {"A": MotionFacts(1), "B": MotionFacts(1)})]
    assert said == [
        ("cell never fires", "error", "B/GO never fires: the motion of B has no marker 'hand'"),
        ("unknown marker", "error", "B/GO waits for the marker hand, which no motion has"),
        ("unused marker", "warning", "nobody uses the marker toe of A"),
    ]


def test_a_default_that_waits_for_a_marker_of_some_states_only():
    text = text_of("state | GO | END\nA | | B\nB | | A", {"A": 60, "B": 60}, 'cells: {"*/GO": {to: B, when: marker foot}}\n')
    text = text.replace("{motion: A, loop: false}", "{motion: A, markers: {foot: 0.5}}")
    assert verify(read_machine(text), {"A": MotionFacts(1), "B": MotionFacts(1)}) == []


def test_senses_that_nobody_answers():
    more = "colliders: {body: {sphere: 1}}\nsenses: {HIT: {touch: [body, wall]}}\n"
    assert found("state | GO | END\nA | B |\nB | | A", more=more) == [("unused sense", "no cell answers HIT, which is sensed")]


def test_a_touch_with_no_collider():
    text = text_of("state | HIT\nA | A", {"A": 60}, "colliders: {body: {sphere: 1}}\nsenses: {HIT: {touch: [body, wall]}}\n")
    broken = replace(read_machine(text), colliders={})
    assert [one.message for one in verify(broken)] == ["HIT touches with 'body', which is no collider"]


def test_an_event_that_is_raised_on_others_and_nearly_one_of_its_own():
    cells = 'cells: {A/SHOOT: {to: B, action: "raise(SHOOOT, other)"}, A/END: {to: B, action: "raise(BARK, dog)"}}\n'
    assert found("state | SHOOT | END\nA | |\nB | | A", more=cells) == [
        ("unknown event", "raise(SHOOOT, other) raises what is no event here; did you mean SHOOT?")
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
    first, second = ([(one.kind, one.message) for one in verify(read_machine(OUTER % final))] for final in ("", ", final: true"))
    assert ("cell never fires", "B never ends: none of its states is marked `final`") in first
    assert ("cell never fires", "B never ends: B.OUT cannot be reached") in second


LAYERS = """character: c.glb
initial: A
states: {A: {motion: a}}
table: |
  state | WAVE | NOD
  A     |      |
parameters: {arm: {default: 1, min: 0, max: 1}}
layers:
  arms:
    weight: arm
    initial: REST
    states: {REST: {motion: none}, WAVE: {motion: wave}, LOST: {motion: wave}}
    table: |
      state | WAVE | END
      REST  | WAVE | WAVE
      WAVE  |      | REST
      LOST  |      | REST
"""


def test_layers_have_findings_of_their_own():
    findings = verify(read_machine(LAYERS), {"a": MotionFacts(1), "wave": MotionFacts(1)})
    assert [(one.kind, one.layer, one.message) for one in findings] == [
        ("unreachable state", "arms", "layer arms: LOST cannot be reached from REST"),
        ("cell never fires", "arms", "layer arms: REST/END never fires: REST has no motion, so it has no end"),
        ("unused event", "", "no cell answers NOD"),
    ]

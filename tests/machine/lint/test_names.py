"""Unknown and unused names: events, motions, parameters, conditions, markers, senses and colliders."""

from dataclasses import replace

from lint_findings import found
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify
from ticking import text_of


def test_events_that_no_cell_answers():
    assert found("state | GO | NEVER | END\nA | B | - |\nB | | | A") == [
        ("unused event", "no cell answers NEVER")
    ]


def test_motions_unknown_and_unused():
    assert found("state | GO | END\nA | B |\nB | | A", motions={"A": 1, "BB": 1}) == [
        ("unknown motion", "B has no motion 'B'; did you mean BB?"),
        ("unused motion", "motions that no state uses: BB"),
    ]


def test_many_unused_motions_are_one_finding():
    motions = {"A": 1, "B": 1} | {f"M{number}": 1 for number in range(100)}
    (finding,) = found("state | GO | END\nA | B |\nB | | A", motions=motions)
    assert finding[1].startswith("motions that no state uses: M0, M1, ")
    assert finding[1].endswith("more")


def test_parameters_unknown_and_unused():
    text = text_of("state | GO\nA | A", {"A": 60}, "parameters: {pace: {default: 1, min: 0, max: 2}}\n")
    assert [
        (one.kind, one.message) for one in verify(read_machine(text.replace("loop: false", "speed: pase")))
    ] == [
        ("unknown parameter", "the speed of A is 'pase', which is no parameter; did you mean pace?"),
        ("unused parameter", "the parameter pace is unused"),
    ]


PARAMETERS = "parameters: {pace: {default: 1, min: 0, max: 2}}\n"


def test_a_condition_uses_a_parameter():
    assert (
        found(
            "state | GO | END\nA | | B\nB | | A", more=PARAMETERS + "cells: {A/GO: [{if: pace > 1, to: B}]}\n"
        )
        == []
    )


def test_conditions_that_are_always_true():
    more = "cells: {A/GO: [{if: 2 > 1, to: B}, {to: A}]}\n"
    assert found("state | GO | END\nA | | B\nB | | A", more=more) == [
        ("condition", "A/GO: '2 > 1' is always true")
    ]


def test_a_condition_that_cannot_be_read():
    definition = read_machine(
        text_of("state | GO | END\nA | | B\nB | | A", {"A": 1, "B": 1}, "senses: {GO: {when: speed > 1}}\n")
    )
    broken = replace(definition, senses={"GO": replace(definition.senses["GO"], when="sped > 1")})
    assert "no name is called 'sped'; did you mean speed?" in next(
        one.message for one in verify(broken) if one.kind == "condition"
    )


def test_markers_unknown_unused_and_missing():
    text = text_of("state | GO | END\nA | B at foot | B\nB | A at hand | A", {"A": 60, "B": 60})
    text = text.replace("{motion: A, loop: false}", "{motion: A, markers: {foot: 0.5, toe: 0.6}}")
    said = [
        (one.kind, one.severity, one.message)
        for one in verify(read_machine(text), {"A": MotionFacts(1), "B": MotionFacts(1)})
    ]
    assert said == [
        ("cell never fires", "error", "B/GO never fires: the motion of B has no marker 'hand'"),
        ("unknown marker", "error", "B/GO waits for the marker hand, which no motion has"),
        ("unused marker", "warning", "the marker toe of A is unused"),
    ]


def test_a_default_that_waits_for_a_marker_of_some_states_only():
    text = text_of(
        "state | GO | END\nA | | B\nB | | A",
        {"A": 60, "B": 60},
        'cells: {"*/GO": {to: B, when: marker foot}}\n',
    )
    text = text.replace("{motion: A, loop: false}", "{motion: A, markers: {foot: 0.5}}")
    assert verify(read_machine(text), {"A": MotionFacts(1), "B": MotionFacts(1)}) == []


def test_senses_that_nobody_answers():
    more = "colliders: {body: {sphere: 1}}\nsenses: {HIT: {touch: [body, wall]}}\n"
    assert found("state | GO | END\nA | B |\nB | | A", more=more) == [
        ("unused sense", "no cell answers HIT, which is sensed")
    ]


def test_a_touch_with_no_collider():
    text = text_of(
        "state | HIT\nA | A",
        {"A": 60},
        "colliders: {body: {sphere: 1}}\nsenses: {HIT: {touch: [body, wall]}}\n",
    )
    broken = replace(read_machine(text), colliders={})
    assert [one.message for one in verify(broken)] == ["HIT touches with 'body', which is no collider"]


def test_an_event_that_is_raised_on_others_and_nearly_one_of_its_own():
    shot, end = '{to: B, action: "raise(SHOOOT, other)"}', '{to: B, action: "raise(BARK, dog)"}'
    cells = f"cells: {{A/SHOOT: {shot}, A/END: {end}}}\n"
    assert found("state | SHOOT | END\nA | |\nB | | A", more=cells) == [
        ("unknown event", "raise(SHOOOT, other) raises what is no event here; did you mean SHOOT?")
    ]

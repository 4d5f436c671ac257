"""Solvers of a machine file: what is read, and what is refused where."""

import pytest
from reaching import ARM, text_of
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.verify import verify

LINE = "line 12"


def read(*solvers):
    return read_machine(text_of(*solvers)).solvers


def test_all_fields():
    written = read(
        "reach: {solver: force, chain: {from: A, to: B}, target: grip, space: model, pole: [0, 0, -1], "
        "weight: {STAT: 1, WALK: 0.25}, ease: 0.5, travel: 0.1, softening: 0.01, tolerance: 0.001, "
        "iterations: 9, sensitivity: {A: 0.5}, rotation: [0, 0, 0.6, 0.8]}"
    )["reach"]
    assert (written.solver, written.chain, written.target, written.space) == (
        "force",
        ("A", "B"),
        "grip",
        "model",
    )
    assert (written.pole, written.weight) == ((0, 0, -1), {"STAT": 1, "WALK": 0.25})
    assert (written.ease, written.travel, written.softening) == (0.5, 0.1, 0.01)
    assert (written.tolerance, written.iterations, written.sensitivity) == (0.001, 9, {"A": 0.5})
    assert written.rotation == (0, 0, 0.6, 0.8)
    assert written.line == 12


def test_a_weight_by_state_may_be_a_parameter():
    written = read("reach: {solver: ccd, chain: [A, B], target: grip, weight: {STAT: 1, WALK: part}}")[
        "reach"
    ]
    assert written.weight == {"STAT": 1, "WALK": "part"}
    assert written.parameters == ("grip", "part")


def test_the_order_is_that_of_the_file():
    assert list(
        read(
            f"b: {{solver: ccd, chain: {ARM}, target: grip}}",
            "a: {solver: look-at, chain: [Head], target: grip}",
        )
    ) == ["b", "a"]


@pytest.mark.parametrize(
    ("fields", "words"),
    [
        ("solver: two-bones, chain: [A, B], target: grip", "two-bone"),
        ("solver: ccd, target: grip", "`chain` is missing"),
        ("solver: ccd, chain: [A, B]", "`target` is missing"),
        ("solver: ccd, chain: [A, B], target: grib", "grip"),
        ("solver: ccd, chain: [A, B], target: part", "part is a number"),
        ("solver: ccd, chain: [A, B], target: grip.x", "grip"),
        ("solver: ccd, chain: [A, B], target: side", "side is a direction; a parameter of kind point"),
        ("solver: look-at, chain: [A], target: part", "kind point or direction"),
        ("solver: look-at, chain: [A], target: grip, rotation: [0, 0, 0, 1]", "for two-bone, ccd"),
        ("solver: ccd, chain: [A, B], target: grip, rotation: side", "of kind rotation"),
        ("solver: ccd, chain: [A, B], target: grip, rotation: [0, 0, 1]", "list of 4 numbers"),
        ("solver: ccd, chain: [A, B], target: grip, rotation: [0, 0, 0, 0]", "length"),
        ("solver: ccd, chain: [A, B], target: grip, weight: 2", "2"),
        ("solver: ccd, chain: [A, B], target: grip, weight: side", "side"),
        ("solver: ccd, chain: [A, B], target: grip, weight: {STAY: 1}", "STAT"),
        ("solver: ccd, chain: [A, B], target: grip, weight: {STAT: 2}", "2"),
        ("solver: ccd, chain: [A, B], target: grip, weight: {STAT: side}", "side"),
        ("solver: ccd, chain: [A, B], target: grip, weight: {STAT: prat}", "part"),
        ("solver: ccd, chain: [A, B], target: grip, ease: 1", "weight by state"),
        ("solver: look-at, chain: [A], target: grip, travel: 1", "for force, two-bone, ccd, fabrik"),
        ("solver: ccd, chain: [A, B], target: grip, cone_deg: 1", "for look-at"),
        ("solver: ccd, chain: [], target: grip", "1 to 256"),
        ("solver: ccd, chain: [A, B], target: grip, pole: [0, 0, 0]", "length"),
        ("solver: ccd, chain: [A, B], target: grip, iterations: 1.5", "whole"),
        ("solver: ccd, chain: [A, B], target: grip, tolerance: 0", "0"),
        ("solver: ccd, chain: [A, B], target: grip, speed: 1", "speed"),
    ],
)
def test_what_is_refused(fields, words):
    with pytest.raises(MachineError, match=words) as caught:
        read(f"reach: {{{fields}}}")
    assert LINE in str(caught.value)


def test_a_solvers_parameters_are_in_use():
    text = text_of(f"reach: {{solver: two-bone, chain: {ARM}, target: grip, pole: side, weight: part}}")
    messages = [finding.message for finding in verify(read_machine(text))]
    assert not any("parameter" in message for message in messages)
    bare = text_of(f"reach: {{solver: two-bone, chain: {ARM}, target: grip}}")
    unused = {finding.message for finding in verify(read_machine(bare)) if "unused" in finding.kind}
    assert unused == {"the parameter part is unused", "the parameter side is unused"}

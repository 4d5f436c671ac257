"""Faults of cells: cells that never count or never fire, and alternatives that are never chosen."""

from dataclasses import replace

from lint_findings import found
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.verify import verify
from ticking import text_of


def test_defaults_that_never_count():
    assert found("state | GO\nA | B\nB | A at end", more='cells: {"*/GO": {to: A}}') == [
        ("cell never fires", "*/GO never counts: other cells come before it")
    ]


def test_a_weight_of_nothing_is_never_drawn():
    assert found(
        "state | GO | END\nA | | B\nB | | A\nC | A | A", "A B C", "cells: {A/GO: {to: {B: 1, C: 0}}}\n"
    ) == [
        ("unreachable state", "C cannot be reached from A"),
        ("alternative never chosen", "A/GO: C is never chosen, its weight is 0"),
    ]


def test_nothing_is_chosen_after_what_is_always_true():
    definition = read_machine(
        text_of(
            "state | GO | END\nA | | B\nB | | A",
            {"A": 1, "B": 1},
            "cells: {A/GO: [{if: speed > 1, to: A}, {to: B}]}\n",
        )
    )
    cell = definition.cells["A", "GO"]
    cells = {**definition.cells, ("A", "GO"): replace(cell, alternatives=cell.alternatives[::-1])}
    assert [one.message for one in verify(replace(definition, cells=cells))] == [
        "A/GO: A is never chosen, B before it has no condition"
    ]

"""The table as text: cells, rows, rules of dashes, CSV; what is wrong is refused with its line."""

import pytest
from statwalk.errors import MachineError
from statwalk.machine.definition.state_table import check_rows, read_cell, read_csv, read_table

TEXT = """state | GO | STOP
A | B! at end | -
B |  | A
"""


def test_cells_say_state_restart_and_moment():
    cell = read_cell("WALK! at end", "t", 3)
    assert (cell.to, cell.restart, cell.off, str(cell.when), cell.line) == ("WALK", True, False, "end", 3)
    assert read_cell("-", "t", 1).off
    assert read_cell("WALK", "t", 1).when is None


@pytest.mark.parametrize(
    "text",
    ["A B", "A!!", "at end", "A at", "--", "A/B", "!", "A at end now", "*", "A at left/down", "- at end"],
)
def test_other_cells_are_refused(text):
    with pytest.raises(MachineError, match="t, line 7"):
        read_cell(text, "t", 7)


def test_a_cell_may_wait_for_a_marker():
    assert str(read_cell("JUMP! at left-down", "t", 1).when) == "marker left-down"


def test_rows_and_columns():
    table = read_table(TEXT, "t", first_line=11)
    assert (list(table.events), table.states) == (["GO", "STOP"], {"A": 12, "B": 13})
    assert {place: cell.to for place, cell in table.cells.items()} == {
        ("A", "GO"): "B",
        ("A", "STOP"): "",
        ("B", "STOP"): "A",
    }
    assert table.rows[1] == ("A", "B! at end", "-")


def test_bars_around_and_a_rule_of_dashes_make_no_difference():
    drawn = "| state | GO | STOP |\n|---|:-:|---|\n| A | B! at end | - |\n| B |  | A |\n"
    assert {place: cell.to for place, cell in read_table(drawn, "t").cells.items()} == {
        place: cell.to for place, cell in read_table(TEXT, "t").cells.items()
    }


def test_csv_says_the_same():
    assert read_csv("state,GO,STOP\nA,B! at end,-\nB,,A\n", "t") == read_table(TEXT, "t")


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the table is empty"),
        ("state | GO\nA | B | C", "line 2: the row A has 3 cells, the header 2"),
        ("state | GO\nA | B\nA | B", "line 3: the row A was already given in line 2"),
        ("state | GO | GO\nA | B | B", "line 1: the event GO is defined twice"),
        ("state | G O\nA | B", "'G O' is no name for the event"),
        ("state | GO\n? | B", "line 2: '\\?' is no name for the state"),
    ],
)
def test_wrong_tables_are_refused_with_their_line(text, message):
    with pytest.raises(MachineError, match=message):
        read_table(text, "t")


TOO_LARGE = {
    "rows": ("state\n" + "A\n" * 10_001, "t, line 10001: the table has more than 10,000 rows"),
    "columns": ("state | " + " | ".join("ABCD" * 1_001), "t, line 1: the table has more than 4,000 columns"),
    "bars": ("|" * 120_000, "t, line 1: the table has more than 100,000 cells"),
    "cells": ("state" + " | ?" * 20 + "\n?" * 5_000, "t, line 1: the table has more than 100,000 cells"),
}
"""each is wrong in other ways, too: its size is looked at before anything else"""


@pytest.mark.parametrize(("text", "message"), TOO_LARGE.values(), ids=TOO_LARGE)
def test_tables_that_are_too_large_are_refused_first(text, message):
    with pytest.raises(MachineError, match=message):
        read_table(text, "t")


def test_what_is_wrong_in_the_last_row_is_found_before_any_cell_is_made():
    lines = [(number, ["A" + str(number), "B"]) for number in range(1, 50)]
    with pytest.raises(MachineError, match="t, line 50: 'no cell' is no cell"):
        check_rows([(0, ["state", "GO"]), *lines, (50, ["C", "no cell"])], "t")


def test_a_csv_field_that_is_too_large_is_refused():
    with pytest.raises(MachineError, match="this is not CSV"):
        read_csv("state,GO\nA," + "x" * 200_000, "t")

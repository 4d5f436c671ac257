"""What a picture of the machine needs."""

from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.resolved_table import resolved_tables
from statwalk.machine.graph import edges, full_table
from ticking import text_of

TABLE = "state | GO | RUN | END\nA | B | B | NONE\nB | B | B! | A"


def base_of(text):
    return resolved_tables(read_machine(text), None)[0]


def table():
    return base_of(
        text_of(TABLE, {"A": 1, "B": 1}, 'cells: {"*/GO": {to: A}, B/END: {blend: 0, action: bow}}\n')
    )


def test_edges_join_states_once_with_all_their_events():
    assert edges(table()) == [
        {"from": "A", "to": "B", "events": ["GO", "RUN"]},
        {"from": "B", "to": "B", "events": ["RUN"]},  # a restart; the stay is no edge
        {"from": "B", "to": "A", "events": ["END"]},
    ]


def test_the_full_table_says_where_each_cell_comes_from():
    cell = full_table(table())["B"]["END"]
    assert (cell["to"], cell["when"], cell["blend"], cell["restart"], cell["action"]) == (
        "A",
        "now",
        0.0,
        False,
        "bow",
    )
    assert (cell["source"], cell["line"], cell["written"]) == ("cell", 9, ["B", "END"])
    assert full_table(table())["A"]["GO"]["source"] == "cell"


def test_the_full_table_lists_what_an_event_may_lead_to():
    text = text_of(
        "state | GO\nA | ",
        {"A": 1, "B": 1},
        "cells: {A/GO: {to: [{if: speed > 1, to: B!}, {to: A}], enter: match}}\n",
    )
    cell = full_table(base_of(text))["A"]["GO"]
    assert [(one["to"], one["condition"], one["restart"], one["enter"]) for one in cell["alternatives"]] == [
        ("B", "speed > 1", True, "match"),
        ("A", "", False, "match"),
    ]


def test_a_cell_with_alternatives_has_its_own_blend_and_action():
    text = text_of(
        "state | GO\nA | ",
        {"A": 1, "B": 1},
        "cells: {A/GO: {to: [{if: speed > 1, to: B, blend: 0.1, action: run}, {to: A}], blend: 0.5}}\n",
    )
    cell = full_table(base_of(text))["A"]["GO"]
    assert (cell["to"], cell["blend"], cell["action"]) == ("B", 0.5, None)
    assert [(one["blend"], one["action"]) for one in cell["alternatives"]] == [(0.1, "run"), (0.5, None)]

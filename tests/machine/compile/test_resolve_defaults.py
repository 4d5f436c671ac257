"""Defaults of rows and columns: the first that exists of exact cell, STATE/*, */EVENT, */*; `*` is never
END.
"""

from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.resolve_defaults import resolve_defaults
from ticking import text_of

TABLE = """state | GO | HIT | RUN | END
A | B | - |  |
B |  |  |  | """
DEFAULTS = 'cells:\n  "B/*": {to: C}\n  "*/RUN": {to: A, blend: 0.5}\n  "*/*": {to: B}\n'


def cells(more=DEFAULTS):
    return resolve_defaults(read_machine(text_of(TABLE, {"A": 1, "B": 1, "C": 1}, more)))


def test_the_exact_cell_comes_first():
    assert (cells()["A", "GO"].to, cells()["A", "GO"].source) == ("B", "cell")


def test_then_the_row_then_the_column_then_the_table():
    found = cells()
    assert (found["B", "RUN"].to, found["B", "RUN"].source) == ("C", "row default")
    assert (found["A", "RUN"].to, found["A", "RUN"].source, found["A", "RUN"].blend) == (
        "A",
        "column default",
        0.5,
    )
    assert (found["C", "HIT"].to, found["C", "HIT"].source) == ("B", "table default")


def test_a_dash_has_no_default():
    assert cells()["A", "HIT"].off


def test_a_star_is_never_end():
    assert not [place for place in cells() if place[1] == "END"]
    assert cells('cells: {"*/END": {to: A}}')["C", "END"].to == "A"


def test_what_a_cell_leaves_out_follows_the_defaults():
    cell = cells("defaults: {when: end, blend: 0.7}")["A", "GO"]
    assert (str(cell.when), cell.blend, cell.action) == ("end", 0.7, None)


def test_rows_and_columns_of_defaults_may_stand_in_the_table():
    found = resolve_defaults(
        read_machine(text_of("state | GO | * \nA | | C\n* | B |", {"A": 1, "B": 1, "C": 1}))
    )
    assert {place: cell.to for place, cell in found.items()} == {
        ("A", "GO"): "C",
        ("B", "GO"): "B",
        ("C", "GO"): "B",
    }

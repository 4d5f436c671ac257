"""A table as it is written: lines that are no rows, bars around lines, values with commas."""

import pytest
from statwalk.files.machine_yaml.edit.raw_table import RawTable, table_of_csv, table_with_bars

PLAIN = "  state | GO   | END\n\n  A     | B!   |\n  LONG  | A at end | A\n"
BARRED = "| state | GO | END |\n|:------|----|-----|\n| A     | -  |     |\n"
CSV = 'state,GO,END\r\n\r\n"A",B,\r\nLONG, A ,"A"\r\n'


@pytest.mark.parametrize("text", [PLAIN, BARRED, PLAIN.rstrip("\n"), PLAIN.replace("\n", "\r\n")])
def test_a_table_with_bars_prints_as_it_was_read(text: str) -> None:
    assert table_with_bars(text).text() == text


def test_a_csv_prints_as_it_was_read() -> None:
    assert table_of_csv(CSV).text() == CSV


def told(table: RawTable) -> tuple[list[str], list[str], list[tuple[str, str, str]]]:
    return table.columns(), table.names(), list(table.cells())


def test_both_say_the_same() -> None:
    cells = [("A", "GO", "B"), ("LONG", "GO", "A"), ("LONG", "END", "A")]
    assert told(table_of_csv(CSV)) == (["GO", "END"], ["A", "LONG"], cells)
    bars = table_with_bars(PLAIN.replace("B!", "B ").replace("A at end", "A"))
    assert told(bars) == told(table_of_csv(CSV))


def test_a_row_in_a_file_without_a_last_line_end() -> None:
    table = table_of_csv("state,GO\r\nA,")
    table.add_row("B")
    assert table.text() == "state,GO\r\nA,\r\nB,\r\n"
    table = table_with_bars("state | GO\nA     |")
    table.add_row("B")
    assert table.text() == "state | GO\nA     |\nB     |\n"


def test_a_table_that_is_not_even_keeps_its_other_lines() -> None:
    table = table_with_bars("state | GO\nA | B\nLONGER   | A\n")
    table.rename_row("A", "AJAR")
    assert table.text() == "state | GO\nAJAR | B\nLONGER   | A\n"


def test_columns_and_rows_of_a_csv() -> None:
    table = table_of_csv(CSV)
    table.add_column("HIT", "END")
    table.rename_column("GO", "RUN")
    table.move_row("LONG", "A")
    table.set_cell("A", "HIT", "LONG at end")
    assert table.text() == 'state,RUN,HIT,END\r\n\r\nLONG, A ,,"A"\r\n"A",B,LONG at end,\r\n'
    table.remove_column("HIT")
    table.remove_row("LONG")
    assert table.text() == 'state,RUN,END\r\n\r\n"A",B,\r\n'

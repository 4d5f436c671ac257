"""Prepares a sub-machine for its end, when its last state is taken out."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.files.machine_yaml.edit.moved_state import level_at
from statwalk.files.machine_yaml.edit.table_levels import TableLevel, levels_of, raw_table, read, with_table
from statwalk.files.machine_yaml.machine_text import MachineText
from statwalk.files.yaml.yaml_edit import without
from statwalk.machine.definition.machine_definition import ANY, END


def without_uses(text: MachineText, outer: TableLevel, level: TableLevel) -> MachineText:
    """Returns the text in which nothing is left that only the sub-machine has: its columns are in the table
    around it (`outer`), and it has no row there and no place in the graph.

    :raises MachineError: when it has cells of its own.
    """
    own = list(_own_cells(text, level))
    if own:
        some = ", ".join(own[:5]) + (f" and {len(own) - 5} more" if len(own) > 5 else "")
        raise level.node.refuse(
            f"{level.composite} would be without states, and has cells of its own: {some}; make these cells "
            f"blank, or delete {level.composite}"
        )
    row = level.composite.removeprefix(f"{outer.composite}.") if outer.composite else level.composite
    table, inner = raw_table(text, outer), raw_table(text, level)
    if table is not None:
        if row in table.names():
            table.remove_row(row)
        for column in inner.columns() if inner is not None else ():
            if column not in (*table.columns(), ANY):
                table.add_column(column, END if END in table.columns() else None)
        text = with_table(text, level_at(text, outer.layer, outer.composite), table)
    return text._replace(yaml=without(text.yaml, ("view", level.layer, level.composite)))


def _own_cells(text: MachineText, level: TableLevel) -> Iterator[str]:
    """The cells of the rows of a composite state, and of `*` within, as STATE/EVENT."""
    own = (level.composite, level.full(ANY))
    for at in levels_of(read(text), level.layer):
        table = raw_table(text, at)
        rows = [(row, event) for row, event, _ in table.cells()] if table is not None else []
        rows += [(row, event) for row, _, event in (key.partition("/") for key in at.cells())]
        yield from (f"{at.full(row)}/{event}" for row, event in rows if at.full(row) in own)

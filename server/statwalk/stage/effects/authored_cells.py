"""The cells of a role as authored, which explanations quote."""

from __future__ import annotations

from collections.abc import Mapping
from weakref import WeakKeyDictionary

from statwalk.character.role import Role
from statwalk.machine.compile.resolve_defaults import Cell

_CELLS: WeakKeyDictionary[Role, Mapping[tuple[int, str, str], Cell]] = WeakKeyDictionary()


def cells_of(role: Role) -> Mapping[tuple[int, str, str], Cell]:
    """Returns the authored cells of a role by layer number, state and event; computed once for each role."""
    if role not in _CELLS:
        _CELLS[role] = {
            (layer, *place): cell
            for layer, table in enumerate(role.resolved)
            for place, cell in table.cells.items()
        }
    return _CELLS[role]

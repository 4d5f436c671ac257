"""The cells of a role as authored, for whoever explains what they did."""

from __future__ import annotations

from collections.abc import Mapping
from weakref import WeakKeyDictionary

from statwalk.machine.authored.expand import Cell, expand
from statwalk.stage.role import Role

_CELLS: WeakKeyDictionary[Role, Mapping[tuple[int, str, str], Cell]] = WeakKeyDictionary()


def cells_of(role: Role) -> Mapping[tuple[int, str, str], Cell]:
    """The cell under each layer (its number), state and event that has one; made once for each role."""
    if role not in _CELLS:
        markers = {name for some in role.machine.markers for name, _ in some}
        tables = role.definition.tables().values()
        _CELLS[role] = {(layer, *place): cell for layer, table in enumerate(tables) for place, cell in expand(table, markers).items()}
    return _CELLS[role]

"""Measures machines for several clients: each version of a machine once."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.stage.measure.measure import Measured, measure_cells, measure_motions
from statwalk.stage.measure.subject import Subject

MOST_CELLS = 1_000
_known: WeakKeyDictionary[Role, tuple[Measured, ...]] = WeakKeyDictionary()


def measured(role: Role, cell: str = "", checkpoint: Checkpoint = go_on) -> tuple[Measured, ...]:
    """Returns the figures of all motions and cells of a role, or of one cell (`STATE/EVENT`); `checkpoint` is
    called between the pieces of the work, and ends it by raising.

    :raises UnknownNameError: when no cell that changes the state has this name.
    :raises MachineError: when a machine has more than MOST_CELLS such cells, and none is named.
    """
    subject = Subject(role, checkpoint)
    if cell:
        return tuple(measure_cells(subject, [subject.cell(cell)]))
    if len(subject.cells) > MOST_CELLS:
        message = (
            f"{len(subject.cells):,} cells change the state; at most {MOST_CELLS:,} are measured at once"
        )
        raise MachineError(f"{message}: name one cell, STATE/EVENT")
    if role not in _known:
        motions = measure_motions(subject, subject.motions)
        _known[role] = (*motions, *measure_cells(subject, subject.cells))
    return _known[role]

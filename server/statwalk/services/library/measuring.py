"""Verifies and measures machines for several clients: each version of a machine once."""

from __future__ import annotations

from weakref import WeakKeyDictionary

from statwalk.character.role import Role
from statwalk.errors import MachineError
from statwalk.machine.lint.findings import Finding
from statwalk.machine.model_checker.work import Checkpoint, go_on
from statwalk.services.cancel import NEVER, CancelToken
from statwalk.services.work.job import DoJob, do_here
from statwalk.stage.measure.measure import Measured, measure_cells, measure_motions
from statwalk.stage.measure.subject import Subject
from statwalk.stage.verified import verified

MOST_CELLS = 1_000
_found: WeakKeyDictionary[Role, tuple[Finding, ...]] = WeakKeyDictionary()
_known: WeakKeyDictionary[Role, tuple[Measured, ...]] = WeakKeyDictionary()


def findings_of(role: Role, work: DoJob = do_here, token: CancelToken = NEVER) -> tuple[Finding, ...]:
    """Returns the verifier's findings about a role; `work` does the verifying, `token` cancels it."""
    if role not in _found:
        _found[role] = work(role.name, verified, role, token=token)
    return _found[role]


def measured(
    role: Role, cell: str = "", work: DoJob = do_here, token: CancelToken = NEVER
) -> tuple[Measured, ...]:
    """Returns the figures of all motions and cells of a role, or of one cell (`STATE/EVENT`); `work` does the
    measuring, `token` cancels it.

    :raises UnknownNameError: when no cell that changes the state has this name.
    :raises MachineError: when a machine has more than MOST_CELLS such cells, and none is named.
    """
    if cell:
        return work(role.name, measure, role, cell, token=token)
    if role not in _known:
        _known[role] = work(role.name, measure, role, cell, token=token)
    return _known[role]


def measure(role: Role, cell: str, checkpoint: Checkpoint = go_on) -> tuple[Measured, ...]:
    """Does the work of `measured`; `checkpoint` is called between its pieces, and ends it by raising."""
    subject = Subject(role, checkpoint)
    if cell:
        return tuple(measure_cells(subject, [subject.cell(cell)]))
    if len(subject.cells) > MOST_CELLS:
        message = (
            f"{len(subject.cells):,} cells change the state; at most {MOST_CELLS:,} are measured at once"
        )
        raise MachineError(f"{message}: name one cell, STATE/EVENT")
    return (
        *measure_motions(subject, subject.motions),
        *measure_cells(subject, subject.cells),
    )

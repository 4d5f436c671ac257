"""What is wrong with a table, and what can be proved of it, without running it (SM3)."""

from __future__ import annotations

from collections.abc import Iterator

from statwalk.machine.authored.definition import MachineDefinition
from statwalk.machine.checking import cells, names, states
from statwalk.machine.checking.findings import Finding
from statwalk.machine.checking.firing import Motions
from statwalk.machine.checking.sheet import Sheet, sheets
from statwalk.machine.proof.properties import answers


def verify(definition: MachineDefinition, motions: Motions = None) -> list[Finding]:
    """All findings, by the kind of fault; with `motions` (by name) those about motions and time as well. Nothing is raised.

    Errors make the machine something else than its author meant; warnings may be meant; info says what was proved.
    """
    every = sheets(definition, motions)
    found = [one for sheet in every for one in sheet.placed(of_table(sheet))]
    found += [*names.unused_events(definition, every), *names.raised_on_nobody(definition, every), *names.parameters(definition, every)]
    found += [*names.conditions(definition, every), *names.markers(definition, every, motions), *names.colliders(definition)]
    found += [*names.unknown_motions(every, motions), *names.unused_motions(every, motions)]
    return found + answers(definition, every[0].graph, motions)


def of_table(sheet: Sheet) -> Iterator[Finding]:
    """The findings about one layer's table."""
    yield from states.undefined_states(sheet)
    yield from states.unreachable(sheet)
    yield from states.without_exit(sheet)
    yield from cells.shadowed(sheet)
    yield from cells.never_firing(sheet)
    yield from cells.unchosen(sheet)
    yield from states.endless(sheet)
    yield from states.swinging(sheet)
    yield from states.timeless(sheet)

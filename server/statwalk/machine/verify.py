"""What is wrong with a table, and what can be proved of it, without running it (SM3)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from statwalk.machine.compile.machine import Machine
from statwalk.machine.compile.resolved_table import Motions, ResolvedTable, resolved_tables
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.machine.lint import cells, names, states
from statwalk.machine.lint.findings import Finding
from statwalk.machine.lint.lint_context import LintContext, contexts
from statwalk.machine.model_checker.played import Play
from statwalk.machine.model_checker.properties import answers
from statwalk.machine.model_checker.work import Checkpoint, go_on


def verify(
    definition: MachineDefinition,
    motions: Motions = None,
    resolved: Sequence[ResolvedTable] | None = None,
    machine: Machine | None = None,
    checkpoint: Checkpoint = go_on,
    play: Play | None = None,
) -> list[Finding]:
    """Returns all findings, by the kind of fault; with `motions` (by name) the findings about motions and
    time as well. Raises only what `checkpoint` raises.

    `resolved`, `machine`: the tables of this definition with these motions, and the machine compiled from
    them, where they were made before. Errors make the machine something else than its author meant; warnings
    may be meant; info says what was proved. `checkpoint` is called between the pieces of the work.
    `play` plays the inputs of a counterexample on a stage, so that what is said to happen does happen there.
    """
    tables = resolved_tables(definition, motions) if resolved is None else resolved
    every = contexts(tables, motions)
    found: list[Finding] = []
    for context in every:
        checkpoint()
        found += context.placed(_of_table(context))
    found += [
        *names.unused_events(definition, every),
        *names.raised_on_nobody(definition, every),
        *names.parameters(definition, every),
    ]
    found += [
        *names.conditions(definition, every),
        *names.markers(definition, every, motions),
        *names.colliders(definition),
    ]
    found += [*names.unknown_motions(every, motions), *names.unused_motions(every, motions)]
    return found + answers(definition, every[0].graph, motions, tables, machine, checkpoint, play)


def _of_table(context: LintContext) -> Iterator[Finding]:
    """The findings about one layer's table."""
    yield from states.undefined_states(context)
    yield from states.unreachable(context)
    yield from states.without_exit(context)
    yield from cells.shadowed(context)
    yield from cells.never_firing(context)
    yield from cells.unchosen(context)
    yield from states.endless(context)
    yield from states.swinging(context)
    yield from states.timeless(context)

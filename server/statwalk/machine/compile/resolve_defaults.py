"""Resolves defaults: from the cells as written to one cell for every state and event, with nothing left to
look up.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace

from statwalk.machine.definition.cell_definition import (
    ActionDefinition,
    AlternativeDefinition,
    CellDefinition,
    CellTiming,
    Curve,
    Enter,
)
from statwalk.machine.definition.machine_definition import ANY, END, MachineDefinition


@dataclass(frozen=True)
class Choice:
    """One alternative of a cell, with all defaults filled in."""

    to: str
    """a state of this table (or an unknown name); for a composite state, its initial inner state"""
    restart: bool
    blend: float
    """seconds"""
    curve: Curve
    enter: Enter
    """phase 0…1 at which the new motion begins, or `match`"""
    action: ActionDefinition | None
    line: int
    resume: str = ""
    """the composite state whose inner state left last replaces `to`, if one was left"""
    resumed: tuple[str, ...] = ()
    """the inner states of `resume`"""
    condition: str = ""
    """what must be true, as text for `conditions.parse`; empty: always"""
    weight: float | None = None
    """its share, if the choices are drawn"""


@dataclass(frozen=True)
class Cell:
    """A cell of the full table; `written` is its row and column in the file, `source` the same in words.

    If a cell has `alternatives`, they decide and `to` is empty; the first true one counts, or all have
    weights and one is drawn.
    """

    written: tuple[str, str]
    """row and column; the row is a state, a composite state, `*`, or `OUTER.*` for the `*` of a
    sub-machine
    """
    source: str
    to: str
    restart: bool
    off: bool
    """the event means nothing in this state; `to` and `alternatives` keep the rest of the cell"""
    when: CellTiming
    blend: float
    """seconds"""
    curve: Curve
    enter: Enter
    action: ActionDefinition | None
    line: int
    resume: str = ""
    resumed: tuple[str, ...] = ()
    alternatives: tuple[Choice, ...] = ()

    @property
    def choices(self) -> tuple[Choice, ...]:
        """Returns the alternatives of the cell in order, or its only choice; none if it is
        off.
        """
        if self.off:
            return ()
        only = Choice(
            self.to,
            self.restart,
            self.blend,
            self.curve,
            self.enter,
            self.action,
            self.line,
            self.resume,
            self.resumed,
        )
        return self.alternatives or (only,)


def resolve_defaults(
    definition: MachineDefinition, markers: Collection[str] = ()
) -> dict[tuple[str, str], Cell]:
    """Returns the cell for each (state, event) of one table (see `definition.tables()`); pairs without a cell
    or default are missing.

    `*` as an event stands for inputs, senses and touches; never for END, nor for `markers` of the clips and
    states.
    """
    marker_names = {
        *markers,
        *(name for state in definition.states.values() for name in state.markers),
    } - set(definition.senses)
    inner = _inner_states(definition)
    cells = {
        (state, event): _find(definition, state, event, event not in marker_names, inner)
        for state in definition.states
        for event in definition.columns
    }
    return {place: cell for place, cell in cells.items() if cell is not None}


Inner = Mapping[str, tuple[str, ...]]
"""the states inside each composite state"""


def _inner_states(definition: MachineDefinition) -> Inner:
    inner: dict[str, list[str]] = {composite: [] for composite in definition.composites}
    for state in definition.states:
        for composite in enclosing(definition, state):
            inner[composite].append(state)
    return {composite: tuple(states) for composite, states in inner.items()}


def _find(definition: MachineDefinition, state: str, event: str, starred: bool, inner: Inner) -> Cell | None:
    """The cell of one state and event; None: blank, no default. `starred`: `*` stands for it, too."""
    places = _of_end(definition, state) if event == END else _of_input(definition, state, event)
    for row, column, source in places:
        written = definition.cells.get((row, column))
        if written is not None and (starred or column != ANY):
            return _filled(definition, state, written, (row, column), source, inner)
    return None


def _of_input(definition: MachineDefinition, state: str, event: str) -> Iterator[tuple[str, str, str]]:
    """Row, column and source of the cells that may define an event in a state: from inside out, exact cells
    before defaults.
    """
    yield state, event, "cell"
    yield state, ANY, "row default"
    for composite in enclosing(definition, state):
        yield f"{composite}.{ANY}", event, f"column default in {composite}"
        yield f"{composite}.{ANY}", ANY, f"table default in {composite}"
        yield composite, event, f"cell of {composite}"
        yield composite, ANY, f"row default of {composite}"
    yield ANY, event, "column default"
    yield ANY, ANY, "table default"


def _of_end(definition: MachineDefinition, state: str) -> Iterator[tuple[str, str, str]]:
    """Row, column and source for END; a composite state's END comes only from an inner state marked
    `final`.
    """
    yield state, END, "cell"
    final = definition.states[state].final
    for composite in enclosing(definition, state):
        yield f"{composite}.{ANY}", END, f"column default in {composite}"
        if final:
            yield composite, END, f"cell of {composite}"
        final = final and definition.composites[composite].final
    yield ANY, END, "column default"


def enclosing(definition: MachineDefinition, state: str) -> Iterator[str]:
    """Yields the composite states around a state, from inside out."""
    composite = definition.states[state].composite
    while composite:
        yield composite
        composite = definition.composites[composite].composite


def _filled(
    definition: MachineDefinition,
    state: str,
    written: CellDefinition,
    place: tuple[str, str],
    source: str,
    inner: Inner,
) -> Cell:
    defaults = definition.defaults
    to, resume = _landing(definition, state, place[0], written)
    cell = Cell(
        written=place,
        source=source,
        to=to,
        restart=written.restart,
        off=written.off,
        when=written.when or defaults.when,
        blend=defaults.blend if written.blend is None else written.blend,
        curve=written.curve or defaults.curve,
        enter=0.0 if written.enter is None else written.enter,
        action=written.action,
        line=written.line,
        resume=resume,
        resumed=inner.get(resume, ()),
    )
    alternatives = tuple(_choice(definition, state, part, cell, inner) for part in written.alternatives)
    return replace(cell, alternatives=alternatives) if alternatives else cell


def _choice(
    definition: MachineDefinition, state: str, written: AlternativeDefinition, cell: Cell, inner: Inner
) -> Choice:
    to, resume = _landing(definition, state, cell.written[0], written)
    return Choice(
        to=to,
        restart=written.restart,
        blend=cell.blend if written.blend is None else written.blend,
        curve=written.curve or cell.curve,
        enter=cell.enter if written.enter is None else written.enter,
        action=written.action or cell.action,
        line=written.line,
        resume=resume,
        resumed=inner.get(resume, ()),
        condition=written.condition,
        weight=written.weight,
    )


def _landing(
    definition: MachineDefinition, state: str, row: str, written: CellDefinition | AlternativeDefinition
) -> tuple[str, str]:
    """The state that `written`, in `row`, leads to from a state, and the composite state that it
    resumes (empty: none).

    If a cell outside a composite state names it while the actor is inside, the actor stays in its inner
    state, unless the cell has a `!`.
    """
    to, resume = written.to, ""
    if (
        to in definition.composites
        and not written.restart
        and to in enclosing(definition, state)
        and not row.startswith(f"{to}.")
    ):
        return state, ""
    while to in definition.composites:
        if definition.composites[to].resume and not written.restart:
            resume = resume or to
        to = definition.composites[to].initial
    return to, resume


def landings(definition: MachineDefinition, choice: Choice) -> tuple[str, ...]:
    """Returns every state that a choice may lead to: several if it resumes; none if its name is no state."""
    others = (name for name in choice.resumed if name != choice.to)
    return (choice.to, *others) if choice.to in definition.states else ()

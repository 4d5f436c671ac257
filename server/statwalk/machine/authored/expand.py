"""Defaults written out: from the authored cells of a table to one cell for every state and event, with nothing left to look up."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, replace

from statwalk.machine.authored.celldefinition import ActionDefinition, Alternative, CellDefinition, Curve, Enter, Moment
from statwalk.machine.authored.definition import ANY, END, MachineDefinition


@dataclass(frozen=True)
class Choice:
    """One outcome of a cell, with what it left out filled in."""

    to: str
    """a state of this table (or a name that is none); where the file names an outer state, the inner one that it begins with"""
    restart: bool
    blend: float
    """seconds"""
    curve: Curve
    enter: Enter
    """phase 0…1 at which the new motion begins, or `match`"""
    action: ActionDefinition | None
    line: int
    resume: str = ""
    """an outer state of which the inner one left last is meant rather than `to`, once one was left"""
    resumed: tuple[str, ...] = ()
    """its inner states"""
    condition: str = ""
    """what must be true, as text for `conditions.parse`; empty: always"""
    weight: float | None = None
    """its share, where the choices are drawn"""


@dataclass(frozen=True)
class Cell:
    """A cell of the full table; `written` is where it stands in the file, `source` says so in words.

    Where there are `alternatives`, they decide, and `to` is empty; the first that is true counts, or all have weights and one is drawn.
    """

    written: tuple[str, str]
    """row and column; the row is a state, an outer state, `*`, or `OUTER.*` for the `*` of a sub-machine"""
    source: str
    to: str
    restart: bool
    off: bool
    """it means nothing here; `to` and `alternatives` keep what else the cell says"""
    when: Moment
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
        """All that it can lead to, in order: the alternatives, or the only outcome; none where it is off."""
        if self.off:
            return ()
        only = Choice(self.to, self.restart, self.blend, self.curve, self.enter, self.action, self.line, self.resume, self.resumed)
        return self.alternatives or (only,)


def expand(definition: MachineDefinition, markers: Collection[str] = ()) -> dict[tuple[str, str], Cell]:
    """The cell under each (state, event) of one table (see `definition.tables()`) that has one; the first that exists counts.

    `*` as an event stands for inputs, senses and touches; never for END, nor for `markers` of the clips and states.
    """
    named = {*markers, *(name for state in definition.states.values() for name in state.markers)} - set(definition.senses)
    inner = inner_states(definition)
    found = {
        (state, event): find(definition, state, event, event not in named, inner)
        for state in definition.states
        for event in definition.columns
    }
    return {place: cell for place, cell in found.items() if cell is not None}


Inner = Mapping[str, tuple[str, ...]]
"""the states inside each outer one"""


def inner_states(definition: MachineDefinition) -> Inner:
    """The states inside each outer one, in the order of the table."""
    found: dict[str, list[str]] = {outer: [] for outer in definition.outers}
    for state in definition.states:
        for outer in enclosing(definition, state):
            found[outer].append(state)
    return {outer: tuple(states) for outer, states in found.items()}


def find(definition: MachineDefinition, state: str, event: str, starred: bool, inner: Inner) -> Cell | None:
    """The cell that counts for one state and event; None: blank, without a default. `starred`: `*` stands for this event, too."""
    places = of_end(definition, state) if event == END else of_input(definition, state, event)
    for row, column, source in places:
        written = definition.cells.get((row, column))
        if written is not None and (starred or column != ANY):
            return filled(definition, state, written, (row, column), source, inner)
    return None


def of_input(definition: MachineDefinition, state: str, event: str) -> Iterator[tuple[str, str, str]]:
    """Row, column and source of all that may say what an event means in a state: from inside out, exact before default."""
    yield state, event, "cell"
    yield state, ANY, "row default"
    for outer in enclosing(definition, state):
        yield f"{outer}.{ANY}", event, f"column default in {outer}"
        yield f"{outer}.{ANY}", ANY, f"table default in {outer}"
        yield outer, event, f"cell of {outer}"
        yield outer, ANY, f"row default of {outer}"
    yield ANY, event, "column default"
    yield ANY, ANY, "table default"


def of_end(definition: MachineDefinition, state: str) -> Iterator[tuple[str, str, str]]:
    """The same for END: that of an outer state comes only when an inner one marked `final` ends."""
    yield state, END, "cell"
    final = definition.states[state].final
    for outer in enclosing(definition, state):
        yield f"{outer}.{ANY}", END, f"column default in {outer}"
        if final:
            yield outer, END, f"cell of {outer}"
        final = final and definition.outers[outer].final
    yield ANY, END, "column default"


def enclosing(definition: MachineDefinition, state: str) -> Iterator[str]:
    """The outer states that a state is part of, from inside out."""
    outer = definition.states[state].outer
    while outer:
        yield outer
        outer = definition.outers[outer].outer


def filled(definition: MachineDefinition, state: str, written: CellDefinition, place: tuple[str, str], source: str, inner: Inner) -> Cell:
    """The cell as it counts in a state, with the machine's defaults where it says nothing itself."""
    defaults = definition.defaults
    to, resume = landing(definition, state, place[0], written)
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
    alternatives = tuple(chosen(definition, state, one, cell, inner) for one in written.alternatives)
    return replace(cell, alternatives=alternatives) if alternatives else cell


def chosen(definition: MachineDefinition, state: str, one: Alternative, cell: Cell, inner: Inner) -> Choice:
    """An alternative with what it leaves to its cell."""
    to, resume = landing(definition, state, cell.written[0], one)
    return Choice(
        to=to,
        restart=one.restart,
        blend=cell.blend if one.blend is None else one.blend,
        curve=one.curve or cell.curve,
        enter=cell.enter if one.enter is None else one.enter,
        action=one.action or cell.action,
        line=one.line,
        resume=resume,
        resumed=inner.get(resume, ()),
        condition=one.condition,
        weight=one.weight,
    )


def landing(definition: MachineDefinition, state: str, row: str, outcome: CellDefinition | Alternative) -> tuple[str, str]:
    """Where `outcome`, written in a row, leads from a state: the state, and the outer one that is resumed there (empty: none).

    A cell outside an outer state that names it finds its inner states at home: they stay, unless it says `!`.
    """
    to, resume = outcome.to, ""
    if to in definition.outers and not outcome.restart and to in enclosing(definition, state) and not row.startswith(f"{to}."):
        return state, ""
    while to in definition.outers:
        if definition.outers[to].resume and not outcome.restart:
            resume = resume or to
        to = definition.outers[to].initial
    return to, resume


def landings(definition: MachineDefinition, choice: Choice) -> tuple[str, ...]:
    """Every state that a choice may lead to: several where it resumes; none where its name is no state."""
    others = (name for name in choice.resumed if name != choice.to)
    return (choice.to, *others) if choice.to in definition.states else ()

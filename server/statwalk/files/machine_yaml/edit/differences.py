"""What differs between two texts of a machine: cells, states, events, and other parts by name."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from statwalk.errors import ContentError
from statwalk.files.machine_yaml.edit.edited import edited
from statwalk.files.machine_yaml.edit.event_edits import RenameEvent
from statwalk.files.machine_yaml.edit.operation import EditOperation, Part, Parts
from statwalk.files.machine_yaml.edit.parts import parts_of
from statwalk.files.machine_yaml.edit.state_edits import RenameState
from statwalk.files.machine_yaml.machine_text import MachineText

MOST_PAIRS = 64
"""of a removed and a new name, of which each is tried as a renaming"""
CELL, STATE, EVENT = "cell", "state", "event"


@dataclass(frozen=True)
class CellDifference:
    """A cell as both texts have it, as in the table and with its fields; None: it is blank."""

    layer: str
    state: str
    event: str
    before: str | None
    after: str | None


@dataclass(frozen=True)
class NameDifference:
    """A state of a layer, or an event (without layer); `before` None: it is new, `after` None: it is gone."""

    kind: str
    layer: str
    before: str | None
    after: str | None


@dataclass(frozen=True)
class PartDifference:
    """Another part of the machine; `part` is its name, from the general to the special."""

    part: Part
    before: str | None
    after: str | None


@dataclass(frozen=True)
class Differences:
    """All that differs; cells and parts by the names that they have in the newer text."""

    names: list[NameDifference]
    cells: list[CellDifference]
    parts: list[PartDifference]


def differences(older: str, newer: str) -> Differences:
    """Returns what differs between two whole texts of a machine.

    :raises ContentError: when one of them cannot be read.
    """
    after = parts_of(MachineText.of(newer))
    renamed: list[NameDifference] = []
    text = older
    while (step := _renaming(text, after)) is not None:
        text = edited(text, [step[1]])
        renamed.append(step[0])
    before = parts_of(MachineText.of(text))
    return Differences(
        [*renamed, *_new_and_gone(before, after)], list(_cells(before, after)), list(_others(before, after))
    )


def _renaming(text: str, after: Parts) -> tuple[NameDifference, EditOperation] | None:
    """The renaming that makes an older text most like the newer one; None if none does."""
    before = parts_of(MachineText.of(text))
    gone = [part for part in before if part[:2] in NAMED and part not in after]
    new = [part for part in after if part[:2] in NAMED and part not in before]
    pairs = [(old, name) for old in gone for name in new if old[:-1] == name[:-1]][:MOST_PAIRS]
    # a renaming says more than that one name is gone and another has come
    best, fewest = None, len(_different(before, after)) - 2
    for old, name in pairs:
        operation = _operation(old, name)
        left = _left(text, operation, after) if operation else fewest
        if operation and left < fewest:
            layer = old[2] if old[1] == STATE else ""
            best, fewest = (NameDifference(old[1], layer, old[-1], name[-1]), operation), left
    return best


NAMED = ("name", STATE), ("name", EVENT)


def _operation(old: Part, new: Part) -> EditOperation | None:
    """The renaming of one name to the other, if both stand in the same place."""
    if old[1] == EVENT:
        return RenameEvent(old[2], new[2])
    outer, _, name = new[3].rpartition(".")
    return RenameState(old[3], name, old[2]) if old[3].rpartition(".")[0] == outer else None


def _left(text: str, operation: EditOperation, after: Parts) -> int:
    """How many parts differ after an operation; all, if it is not possible."""
    try:
        return len(_different(parts_of(MachineText.of(edited(text, [operation]))), after))
    except ContentError:
        return len(after) + len(text)


def _different(before: Parts, after: Parts) -> list[Part]:
    return [part for part in dict.fromkeys((*before, *after)) if before.get(part) != after.get(part)]


def _new_and_gone(before: Parts, after: Parts) -> Iterator[NameDifference]:
    for part in _different(before, after):
        if part[:2] in NAMED:
            layer = part[2] if part[1] == STATE else ""
            is_new = part in after
            yield NameDifference(part[1], layer, None if is_new else part[-1], part[-1] if is_new else None)


def _cells(before: Parts, after: Parts) -> Iterator[CellDifference]:
    places = dict.fromkeys(part[:4] for part in _different(before, after) if part[0] == CELL)
    old, new = _cell_texts(before), _cell_texts(after)
    for place in places:
        _, layer, state, event = place
        yield CellDifference(layer, state, event, old.get(place), new.get(place))


def _cell_texts(parts: Parts) -> dict[Part, str]:
    """What each cell says: the cell of the table, and its fields in braces."""
    fields: dict[Part, dict[str, str]] = {}
    for part, value in parts.items():
        if part[0] == CELL:
            fields.setdefault(part[:4], {})[part[4]] = value
    return {place: _cell_text(cell) for place, cell in fields.items()}


def _cell_text(cell: dict[str, str]) -> str:
    rest = ", ".join(f"{key}: {value}" for key, value in cell.items() if key != "to")
    return " ".join([cell.get("to", ""), *([f"{{{rest}}}"] if rest else [])]).strip()


def _others(before: Parts, after: Parts) -> Iterator[PartDifference]:
    for part in _different(before, after):
        if part[0] != CELL and part[:2] not in NAMED and part[0] != "column":
            yield PartDifference(part, before.get(part), after.get(part))

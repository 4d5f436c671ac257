"""What stands under `cells`: more about a cell of the table, or one that the table has not; alternatives and weights."""

from __future__ import annotations

from collections.abc import Collection, Container
from dataclasses import dataclass, replace
from itertools import pairwise

from statwalk.files.machine import conditions, fields, outcomes
from statwalk.files.yamltext import Node
from statwalk.machine.authored.celldefinition import Alternative, CellDefinition
from statwalk.machine.authored.definition import ANY, END
from statwalk.machine.authored.table import NAME, read_cell

CELL_KEYS = ("to", "when", "blend", "enter", "action", "off")
CHOICE_KEYS = ("if", "to", "blend", "enter", "action")
MOST_CHOICES = 32
LARGEST_WEIGHT = 1e6


@dataclass(frozen=True)
class Known:
    """The names that cells may use: states (outer ones among them), events without END, and variables of conditions."""

    states: Container[str]
    events: Collection[str]
    variables: tuple[str, ...]


def place(node: Node, name: str) -> tuple[str, str]:
    """Row and column of `STATE/EVENT`, either perhaps `*`; raises MachineError for what is no such thing."""
    row, slash, column = name.partition("/")
    if not slash:
        raise node.refuse(f"{name[:40]!r} is no cell; it is written STATE/EVENT, with * for any", node.key_lines[name])
    return row, column


def check_event(node: Node, name: str, column: str, known: Known) -> None:
    """Raises MachineError where the column of a cell is no event."""
    if column not in (ANY, END) and column not in known.events:
        raise node.unknown("event", column, (*known.events, END), node.key_lines[name])


def cell(node: Node, written: CellDefinition | None, name: str, known: Known) -> CellDefinition:
    """The cell of the table (`written`) with more said about it, or one that the table has not."""
    if isinstance(node.value, list):
        return CellDefinition("", node.line, alternatives=choices(node, known))
    if is_weights(node, known):
        return CellDefinition("", node.line, alternatives=weights(node))
    entries = checked(node, CELL_KEYS)
    base = target(entries["to"], known) if "to" in entries else written
    off = fields.truth(entries, "off")
    if base is None and off:
        base = CellDefinition("", node.line, off=True)
    if base is None:
        raise node.refuse(f"the cell {name[:80]} has no next state, neither in the table nor here (`to: STATE`)")
    return more(replace(base, off=base.off or off), entries)


def checked(node: Node, known: tuple[str, ...]) -> dict[str, Node]:
    """The entries; raises MachineError for unknown keys, with advice where a comma cut an action in two."""
    for key in node.entries():
        if key not in known and key.endswith(")"):
            line = node.key_lines[key]
            raise node.refuse('an action with a comma is written in quotes here, as in {action: "drop(coins, 3)"}', line)
    return node.entries(*known)


def more(cell: CellDefinition, entries: dict[str, Node]) -> CellDefinition:
    """A cell with what its entries say of the way to the next state."""
    if "when" in entries:
        cell = replace(cell, when=outcomes.when(entries["when"]))
    if "blend" in entries:
        blend, curve = outcomes.blend(entries["blend"])
        cell = replace(cell, blend=cell.blend if blend is None else blend, curve=curve or cell.curve)
    if "enter" in entries:
        cell = replace(cell, enter=outcomes.enter(entries["enter"]))
    if "action" in entries:
        cell = replace(cell, action=outcomes.action(entries["action"]))
    return cell


def target(node: Node, known: Known) -> CellDefinition:
    """What `to` says: a cell as in the table, alternatives, or weights."""
    if isinstance(node.value, str):
        return read_cell(node.value, node.file, node.line)
    alternatives = weights(node) if isinstance(node.value, dict) else choices(node, known)
    return CellDefinition("", node.line, alternatives=alternatives)


def is_weights(node: Node, known: Known) -> bool:
    """Whether a mapping is one of states and weights rather than of what a cell says: it has a state, and no key of a cell."""
    keys = node.entries()
    return not any(key in CELL_KEYS for key in keys) and any(key.removesuffix("!") in known.states for key in keys)


def weights(node: Node) -> tuple[Alternative, ...]:
    """`{STAT: 4, SCRATCH: 1}`: one of them is drawn, each by its share of the sum."""
    check_count(node)
    found = tuple(drawn(one, name) for name, one in node.entries().items())
    if not any(one.weight for one in found):
        raise node.refuse("one of the weights must be more than 0")
    return found


def drawn(node: Node, name: str) -> Alternative:
    """One of the states that may be drawn."""
    to, restart = named_state(node, name)
    return Alternative(to, node.line, restart, weight=node.number(0, LARGEST_WEIGHT))


def choices(node: Node, known: Known) -> tuple[Alternative, ...]:
    """`[{if: stamina > 10, to: JUMP}, {to: STUP}]`: the first that is true counts."""
    check_count(node)
    found = tuple(choice(one, known) for one in node.items())
    for one, after in pairwise(found):
        if not one.condition:
            raise node.refuse("this alternative never counts: the one before it has no `if`", after.line)
    return found


def choice(node: Node, known: Known) -> Alternative:
    """One alternative; what it does not say follows the cell."""
    entries = checked(node, CHOICE_KEYS)
    where = fields.required(node, "to")
    to, restart = named_state(where, where.text())
    found = Alternative(to, node.line, restart)
    if "if" in entries:
        found = replace(found, condition=conditions.condition(entries["if"], known.variables))
    if "blend" in entries:
        blend, curve = outcomes.blend(entries["blend"])
        found = replace(found, blend=blend, curve=curve)
    if "enter" in entries:
        found = replace(found, enter=outcomes.enter(entries["enter"]))
    if "action" in entries:
        found = replace(found, action=outcomes.action(entries["action"]))
    return found


def named_state(node: Node, text: str) -> tuple[str, bool]:
    """`STATE` or `STATE!`: its name, and whether it begins anew."""
    name = text.removesuffix("!")
    if not NAME.fullmatch(name):
        raise node.refuse(
            f"{text[:40]!r} is no outcome: an alternative leads to STATE or STATE!; when it counts stands beside `to` of the cell"
        )
    return name, name != text


def check_count(node: Node) -> None:
    """Raises MachineError where there are no alternatives, or too many."""
    count = len(node.value)
    if not 1 <= count <= MOST_CHOICES:
        raise node.refuse(f"a cell has 1 to {MOST_CHOICES} alternatives, not {count:,}")

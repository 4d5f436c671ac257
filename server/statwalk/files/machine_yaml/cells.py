"""Reads `cells`: further fields of a cell of the table, or a cell that the table does not have; alternatives
and weights.
"""

from __future__ import annotations

from collections.abc import Collection, Container
from dataclasses import dataclass, replace
from itertools import pairwise

from statwalk.files.machine_yaml import cell_fields, conditions, fields
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.cell_definition import AlternativeDefinition, CellDefinition
from statwalk.machine.definition.machine_definition import ANY, END
from statwalk.machine.definition.name_rule import NAME
from statwalk.machine.definition.state_table import read_cell

CELL_KEYS = ("to", "when", "blend", "enter", "action", "off")
CHOICE_KEYS = ("if", "to", "blend", "enter", "action")
MOST_CHOICES = 32
LARGEST_WEIGHT = 1e6


@dataclass(frozen=True)
class CellNames:
    """The names that cells may use: states (also composite states), events without END, and variables of
    conditions.
    """

    states: Container[str]
    events: Collection[str]
    variables: tuple[str, ...]


def row_and_column(node: Node, name: str) -> tuple[str, str]:
    """Returns row and column of `STATE/EVENT`; either may be `*`.

    :raises MachineError: when the name has no `/`.
    """
    row, slash, column = name.partition("/")
    if not slash:
        raise node.refuse(
            f"{name[:40]!r} is no cell; it is written STATE/EVENT, with * for any", node.key_lines[name]
        )
    return row, column


def check_event(node: Node, name: str, column: str, names: CellNames) -> None:
    """Checks that the column of a cell is an event.

    :raises MachineError: when the column is no event; the message has the most similar event.
    """
    if column not in (ANY, END) and column not in names.events:
        raise node.unknown("event", column, (*names.events, END), node.key_lines[name])


def cell(node: Node, table_cell: CellDefinition | None, name: str, names: CellNames) -> CellDefinition:
    """Returns the cell of the table (`table_cell`) with the fields that the node sets, or a new cell if the
    table has none.
    """
    if isinstance(node.value, list):
        return CellDefinition("", node.line, alternatives=choices(node, names))
    if _is_weights(node, names):
        return CellDefinition("", node.line, alternatives=weights(node))
    entries = _checked(node, CELL_KEYS)
    base = target(entries["to"], names) if "to" in entries else table_cell
    off = fields.truth(entries, "off")
    if base is None and off:
        base = CellDefinition("", node.line, off=True)
    if base is None:
        raise node.refuse(
            f"the cell {name[:80]} has no next state; set it in the table or here (`to: STATE`)"
        )
    return with_fields(replace(base, off=base.off or off), entries)


def _checked(node: Node, allowed: tuple[str, ...]) -> dict[str, Node]:
    """Returns the entries; if a comma cut an action in two, the error about the unknown key says so."""
    for key in node.entries():
        if key not in allowed and key.endswith(")"):
            line = node.key_lines[key]
            raise node.refuse(
                'an action with a comma is written in quotes here, as in {action: "drop(coins, 3)"}', line
            )
    return node.entries(*allowed)


def with_fields(cell: CellDefinition, entries: dict[str, Node]) -> CellDefinition:
    """Returns the cell with the fields that its entries set."""
    if "when" in entries:
        cell = replace(cell, when=cell_fields.when(entries["when"]))
    if "blend" in entries:
        blend, curve = cell_fields.blend(entries["blend"])
        cell = replace(cell, blend=cell.blend if blend is None else blend, curve=curve or cell.curve)
    if "enter" in entries:
        cell = replace(cell, enter=cell_fields.enter(entries["enter"]))
    if "action" in entries:
        cell = replace(cell, action=cell_fields.action(entries["action"]))
    return cell


def target(node: Node, names: CellNames) -> CellDefinition:
    """Reads `to`: a cell as in the table, alternatives, or weights."""
    if isinstance(node.value, str):
        return read_cell(node.value, node.file, node.line)
    alternatives = weights(node) if isinstance(node.value, dict) else choices(node, names)
    return CellDefinition("", node.line, alternatives=alternatives)


def _is_weights(node: Node, names: CellNames) -> bool:
    """Returns whether a mapping holds states and weights rather than fields: it has a state as key, and no
    field.
    """
    keys = node.entries()
    return not any(key in CELL_KEYS for key in keys) and any(
        key.removesuffix("!") in names.states for key in keys
    )


def weights(node: Node) -> tuple[AlternativeDefinition, ...]:
    """Reads `{STAT: 4, SCRATCH: 1}`: one of the states is drawn, each by its share of the sum.

    :raises MachineError: when no weight is more than 0, or there are too many alternatives.
    """
    _check_count(node)
    alternatives = tuple(
        weighted_alternative(alternative, name) for name, alternative in node.entries().items()
    )
    if not any(alternative.weight for alternative in alternatives):
        raise node.refuse("at least one weight must be more than 0")
    return alternatives


def weighted_alternative(node: Node, name: str) -> AlternativeDefinition:
    """Reads one state of a mapping of weights."""
    to, restart = _named_state(node, name)
    return AlternativeDefinition(to, node.line, restart, weight=node.number(0, LARGEST_WEIGHT))


def choices(node: Node, names: CellNames) -> tuple[AlternativeDefinition, ...]:
    """Reads `[{if: stamina > 10, to: JUMP}, {to: STUP}]`: the first alternative whose condition is true
    counts.

    :raises MachineError: when an alternative has no `if` and is not the last, or there are too many
        alternatives.
    """
    _check_count(node)
    alternatives = tuple(_choice(alternative, names) for alternative in node.items())
    for alternative, next_alternative in pairwise(alternatives):
        if not alternative.condition:
            raise node.refuse(
                "this alternative never counts: the alternative before it has no `if`", next_alternative.line
            )
    return alternatives


def _choice(node: Node, names: CellNames) -> AlternativeDefinition:
    """Reads one alternative; fields that it does not set follow the cell."""
    entries = _checked(node, CHOICE_KEYS)
    to_node = fields.required(node, "to")
    to, restart = _named_state(to_node, to_node.text())
    alternative = AlternativeDefinition(to, node.line, restart)
    if "if" in entries:
        alternative = replace(alternative, condition=conditions.condition(entries["if"], names.variables))
    if "blend" in entries:
        blend, curve = cell_fields.blend(entries["blend"])
        alternative = replace(alternative, blend=blend, curve=curve)
    if "enter" in entries:
        alternative = replace(alternative, enter=cell_fields.enter(entries["enter"]))
    if "action" in entries:
        alternative = replace(alternative, action=cell_fields.action(entries["action"]))
    return alternative


def _named_state(node: Node, text: str) -> tuple[str, bool]:
    """Reads `STATE` or `STATE!`: the name, and whether the state restarts."""
    name = text.removesuffix("!")
    if not NAME.fullmatch(name):
        raise node.refuse(
            f"{text[:40]!r} is no next state: an alternative leads to STATE or STATE!; its moment (`when`) "
            "is a field of the cell"
        )
    return name, name != text


def _check_count(node: Node) -> None:
    count = len(node.value)
    if not 1 <= count <= MOST_CHOICES:
        raise node.refuse(f"a cell has 1 to {MOST_CHOICES} alternatives, not {count:,}")

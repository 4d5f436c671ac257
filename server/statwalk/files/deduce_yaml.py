"""A question to the twelve rules in text: bones, what is known of them, and expressions (IK1 to IK12).

    bones:                        # or `mammal` or `hand`, which statwalk ships
      upper: {length: 5, direction: [0, -1, 0]}
      fore: {parent: upper, length: 5, direction: [0, -1, 0]}
    known:
      upper: {SP: [0, 0, 0]}
      fore: {EP: [0, -8, 0], bend: [0, 0, 1]}
    expressions: |
      fore.rotate_x = 0.5 * upper.rotate_x      # degrees

Known are RA_deg (degrees, about X first, then Y, then Z), RM (three rows), SP, EP, TR, DIR and LEN; `unknown`
takes a value of the bones away. `path`: two points of a motion path; `bend`: the direction in which the joint
at the bone's start bends.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from statwalk.character.bone_sets import bone_set, bone_set_of
from statwalk.character.deduce import Deduction, deduce
from statwalk.errors import ContentError, TextError, UnknownNameError
from statwalk.files.faq.skeleton_text import SHIPPED, shipped_skeleton
from statwalk.files.yaml.yaml_text import Node, parse
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.bone_values import DATA, SHAPES, BoneSet

KEYS = ("bones", "known", "expressions")
ANGLES = "RA_deg"
QUANTITIES = (ANGLES, *(name for name in SHAPES if name != "RA"), *DATA)
UNKNOWN = "unknown"
MOST_BONES = 1_000
_LARGEST = 1e9


class DeduceFile(NamedTuple):
    """The question of a file."""

    bones: BoneSet
    known: Mapping[str, Mapping[str, ArrayLike | None]]
    expressions: tuple[tuple[int, str], ...]
    """with their lines"""
    lines: Mapping[str, int]
    """the line of each known value, by `bone.quantity`"""
    file: str

    def answer(self) -> Deduction:
        """Returns what follows from the file.

        :raises TextError: when its values contradict each other, or an expression is wrong; with the line.
        """
        try:
            return deduce(self.bones, self.known, self.expressions)
        except UnknownNameError as error:
            raise TextError(f"expressions: {error}", file=self.file) from None
        except ContentError as error:
            line = self.lines.get(error.place)
            place = f"line {line}, {error.place}" if line else error.place
            raise TextError(error.message, file=self.file, place=place) from None


def read_deduce(text: str, file: str = "") -> DeduceFile:
    """Reads a question.

    :raises TextError: when the text is wrong, with the line.
    """
    root = parse(text, file, TextError, KEYS)
    entries = root.entries(*KEYS)
    if "bones" not in entries:
        raise root.refuse(
            "bones are needed: `bones: mammal`, or {NAME: {parent: …, length: …, direction: …}}"
        )
    bones = _bones(entries["bones"])
    known, lines = _known(entries.get("known"), bones)
    return DeduceFile(bones, known, _expressions(entries.get("expressions")), lines, file)


def _bones(node: Node) -> BoneSet:
    if node.is_text:
        names = sorted(path.stem for path in SHIPPED.glob("*.txt"))
        if node.text() not in names:
            raise node.unknown("skeleton", node.text(), names)
        return bone_set_of(shipped_skeleton(node.text()))
    rows = node.entries()
    if not 1 <= len(rows) <= MOST_BONES:
        raise node.refuse(f"1 to {MOST_BONES:,} bones are needed, not {len(rows):,}")
    return _bone_set(rows, node)


def _bone_set(rows: Mapping[str, Node], node: Node) -> BoneSet:
    parts = {name: row.entries("parent", "length", "direction") for name, row in rows.items()}
    parents = [entry["parent"].text() if "parent" in entry else None for entry in parts.values()]
    try:
        skeleton, order = Skeleton.sorted(list(rows), parents, [f"line {row.line}" for row in rows.values()])
    except TextError as error:
        raise TextError(error.message, file=node.file, place=error.place) from None
    lengths = np.array([_number(entry.get("length"), 0) for entry in parts.values()])
    directions = np.array([_direction(entry.get("direction")) for entry in parts.values()])
    return bone_set(skeleton, lengths[order], directions[order])


def _number(node: Node | None, lowest: float = -_LARGEST) -> float:
    """A number; NaN if the key is missing."""
    return np.nan if node is None else node.number(lowest, _LARGEST)


def _numbers(node: Node, shape: tuple[int, ...]) -> Any:
    if not shape:
        return node.number(-_LARGEST, _LARGEST)
    parts = node.items()
    if len(parts) != shape[0]:
        raise node.refuse(f"{' x '.join(map(str, shape))} numbers are needed, not {len(parts)} values")
    return [_numbers(part, shape[1:]) for part in parts]


def _direction(node: Node | None) -> ArrayLike:
    if node is None:
        return [np.nan] * 3
    return np.array(_numbers(node, (3,)))


def _known(
    node: Node | None, bones: BoneSet
) -> tuple[dict[str, dict[str, ArrayLike | None]], dict[str, int]]:
    known: dict[str, dict[str, ArrayLike | None]] = {}
    lines: dict[str, int] = {}
    if node is None or node.value == "":
        return known, lines
    for bone, row in node.entries().items():
        if bone not in bones.names:
            raise node.unknown("bone", bone, bones.names, node.key_lines[bone])
        known[bone] = {}
        for name, value in row.entries(*QUANTITIES).items():
            quantity = "RA" if name == ANGLES else name
            known[bone][quantity] = _value(value, quantity)
            lines[f"{bone}.{quantity}"] = value.line
    return known, lines


def _value(node: Node, quantity: str) -> ArrayLike | None:
    if node.is_text and node.text() == UNKNOWN:
        return None
    numbers = np.array(_numbers(node, (SHAPES | DATA)[quantity]))
    return np.radians(numbers) if quantity == "RA" else numbers


def _expressions(node: Node | None) -> tuple[tuple[int, str], ...]:
    """The lines of a text, or the items of a list."""
    if node is None:
        return ()
    if node.is_text:
        return tuple(enumerate(node.text().split("\n"), node.first_line))
    return tuple((item.line, item.text()) for item in node.items())

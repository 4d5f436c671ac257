"""The skeleton: names and parents of joints in flat arrays, parents first, so that evaluation is one pass
without recursion.

SK1; FAQ Q2 and Q11; RTCA Listing 10.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ContentError, TextError, UnknownNameError
from statwalk.maths.arrays import Ints
from statwalk.maths.columns import lock_fields


@dataclass(frozen=True, eq=False)
class Skeleton:
    """J joints, each after its parent; `Skeleton.sorted` sorts rows of any order."""

    names: tuple[str, ...]
    parent: NDArray[np.int32]
    """(J,) index of the parent; -1 for a root"""
    muscle_bones: frozenset[str] = frozenset()
    """the joints that only deform the skin (DS6, RTCA 2.3.2): no bones of the body"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @classmethod
    def sorted(
        cls, names: Sequence[str], parents: Sequence[str | None], places: Sequence[str] | None = None
    ) -> tuple[Skeleton, Ints]:
        """Returns the skeleton of rows (name, parent's name or None) in any order, and the row of each of its
        joints.

        Rows keep their order as far as parents-first allows. `places` names the rows in errors (default "row
        3").

        :raises TextError: when a name occurs twice, a parent does not exist, or joints are each other's
            ancestors; with the row's place.
        """
        where = places or [f"row {row + 1}" for row in range(len(names))]
        row_of = _rows_by_name(names, where)
        parent_row = np.array(
            [_parent_row(parent, row_of, where[row]) for row, parent in enumerate(parents)], np.int64
        )
        order = _parents_first(parent_row)
        if len(order) < len(names):
            _refuse_cycle(names, parent_row, set(order), where)
        place = np.empty(len(order), np.int32)
        place[order] = np.arange(len(order), dtype=np.int32)
        sorted_parents = parent_row[order]
        parent = np.where(sorted_parents < 0, np.int32(-1), place[sorted_parents]).astype(np.int32)
        return cls(tuple(names[row] for row in order), parent), np.array(order, np.int64)

    def __len__(self) -> int:
        return len(self.names)

    @cached_property
    def _index(self) -> dict[str, int]:
        return {name: joint for joint, name in reversed(tuple(enumerate(self.names)))}

    def with_muscle_bones(self, names: Iterable[str]) -> Skeleton:
        """Returns the skeleton in which these joints are the muscle bones.

        :raises ContentError: when another joint hangs on a muscle bone.
        :raises UnknownNameError: when the skeleton has no joint of a name.
        """
        muscles = frozenset(names)
        rows = {self.index(name) for name in muscles}
        for joint, parent in enumerate(self.parent.tolist()):
            if parent in rows and joint not in rows:
                name, muscle = self.names[joint], self.names[parent]
                raise ContentError(f"{name} hangs on {muscle}: only muscle bones hang on a muscle bone")
        return replace(self, muscle_bones=muscles)

    def index(self, name: str) -> int:
        """Returns the joint of that name (the first, if a file repeats a name).

        :raises UnknownNameError: when the skeleton has no joint of that name.
        """
        if name not in self._index:
            raise UnknownNameError("joint", name, self.names)
        return self._index[name]


def _rows_by_name(names: Sequence[str], where: Sequence[str]) -> dict[str, int]:
    rows: dict[str, int] = {}
    for row, name in enumerate(names):
        if name in rows:
            raise TextError(
                f"{name} is defined twice, first at {where[rows[name]]}; names must differ", place=where[row]
            )
        rows[name] = row
    return rows


def _parent_row(parent: str | None, row_of: dict[str, int], place: str) -> int:
    if parent is None:
        return -1
    if parent not in row_of:
        raise TextError(str(UnknownNameError("bone", parent, row_of)), place=place)
    return row_of[parent]


def _parents_first(parent_row: Ints) -> list[int]:
    """Rows, each after its parent; rows of a cycle, and their descendants, are left out."""
    waiting: dict[int, list[int]] = {}
    for row, parent in enumerate(parent_row.tolist()):
        waiting.setdefault(parent, []).append(row)
    order: list[int] = []
    ready = waiting.pop(-1, [])[::-1]
    while ready:
        row = ready.pop()
        order.append(row)
        ready += waiting.pop(row, [])[::-1]
    return order


def _refuse_cycle(
    names: Sequence[str], parent_row: Ints, sorted_rows: set[int], where: Sequence[str]
) -> NoReturn:
    """Names the cycle: follows the parents of an unsorted row until a row repeats."""
    row = next(row for row in range(len(names)) if row not in sorted_rows)
    path: list[int] = []
    seen: set[int] = set()
    while row not in seen:
        seen.add(row)
        path.append(row)
        row = int(parent_row[row])
    circle = path[path.index(row) :]
    chain = " -> ".join(names[member] for member in [*circle, row])
    raise TextError(f"bones form a cycle: {chain}", place=where[min(circle)])

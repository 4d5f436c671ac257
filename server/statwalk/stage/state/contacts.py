"""The touches that a stage remembers, and how they change in a tick: arrays over all touches."""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.world.collide import Bodies, Touches

Pair = tuple[str, str]
"""names of an actor's own collider and of the other actor's collider"""


@dataclass(frozen=True, eq=False)
class Contacts:
    """The touches at a tick. Immutable."""

    pairs: tuple[Pair, ...] = ()
    """the pairs of colliders that senses name"""
    touching: NDArray[np.int64] = field(default_factory=lambda: np.zeros((0, 3), np.int64))
    """(T, 3) actor, row of `pairs`, other actor"""
    bodies: Bodies | None = None
    """the colliders at that tick; their kinds are rows of `names`"""

    @classmethod
    @lru_cache(maxsize=256)
    def of(cls, pairs: tuple[Pair, ...]) -> Contacts:
        """Returns contacts of these pairs without touches. The object is cached by its pairs, so that names
        and rows are computed once.
        """
        return cls(pairs)

    @cached_property
    def names(self) -> tuple[str, ...]:
        """The names of all colliders in `pairs`."""
        return tuple(dict.fromkeys(name for pair in self.pairs for name in pair))

    @cached_property
    def row_of_pair(self) -> NDArray[np.int64]:
        """(K, K) row of `pairs` by the kinds of an actor's own collider and of the other's
        collider, -1 none.
        """
        names = self.names
        table = np.full((len(names), len(names)), -1)
        for row, (own, other) in enumerate(self.pairs):
            table[names.index(own), names.index(other)] = row
        return table

    def since(self, before: Contacts, bodies: Bodies) -> Bodies:
        """Returns the present colliders with their places at the tick before; a new collider has
        not moved.
        """
        old = before.bodies
        if old is None or not len(old.owner):
            return bodies
        is_same = _is_same(old.owner, bodies.owner) and _is_same(old.kind, bodies.kind)
        if before.pairs == self.pairs and is_same:
            return bodies._replace(before=old.now, normal_before=old.normal)
        kinds = _numbers(before.names, self.names)[old.kind]
        row = _rows_of(_keys(old.owner, kinds), _keys(bodies.owner, bodies.kind))
        was_there = (row >= 0)[:, None]
        center, normal = old.now[row], old.normal[row]
        return bodies._replace(
            before=np.where(was_there, center, bodies.now),
            normal_before=np.where(was_there, normal, bodies.normal),
        )

    def remembered(self, before: Contacts) -> NDArray[np.int64]:
        """Returns (T, 3) the touches of the tick before, with rows of this tick's pairs."""
        pair = _numbers(before.pairs, self.pairs)[before.touching[:, 1]]
        renumbered = np.stack([before.touching[:, 0], pair, before.touching[:, 2]], -1)
        return renumbered[pair >= 0]


NO_CONTACTS = Contacts()


class ContactChanges(NamedTuple):
    """Touches from the side of each actor that has a sense for them, (M,) each."""

    contact: NDArray[np.int64]
    """(M, 3) actor, row of the pairs, other actor"""
    start: Floats
    """0…1 within the tick"""
    end: Floats
    """0…1 within the tick"""
    lasts: Bools
    """whether they still touch at the end of the tick"""
    at_start: Floats
    """(M, 3) metres; NaN if the other actor is gone"""
    at_end: Floats
    was: Bools
    """whether they touched at the beginning of the tick"""

    def take(self, rows: Ints | Bools) -> ContactChanges:
        """Returns the rows at indices or under a mask."""
        return ContactChanges._make(array[rows] for array in self)


def contact_changes(
    hits: Touches, bodies: Bodies, row_of_pair: Ints, before: NDArray[np.int64]
) -> ContactChanges:
    """Returns how the touches `before` (T, 3) and the touches `hits` of the `bodies` of this tick change."""
    sides = [_side(hits, bodies, row_of_pair, first, second) for first, second in ((0, 1), (1, 0))]
    both = ContactChanges._make(np.concatenate(arrays) for arrays in zip(*sides, strict=True))
    ids, number = np.unique(np.concatenate([both.contact[:, ::2], before[:, ::2]]), return_inverse=True)
    actor, other = number.reshape(-1, 2).T
    keys = (
        actor * (row_of_pair.max(initial=0) + 1) + np.concatenate([both.contact[:, 1], before[:, 1]])
    ) * len(ids) + other
    now, then = keys[: len(both.contact)], keys[len(both.contact) :]
    gone = before[_rows_of(now, then) < 0]
    return _joined(both._replace(was=_rows_of(then, now) >= 0), _gone(gone))


def _side(hits: Touches, bodies: Bodies, row_of_pair: Ints, first: int, second: int) -> ContactChanges:
    """The touches for which the colliders in one column of the pairs have a sense."""
    own, other = hits[first], hits[second]
    pair = row_of_pair[bodies.kind[own], bodies.kind[other]]
    contact = np.stack([bodies.owner[own], pair, bodies.owner[other]], -1)
    times = ContactChanges(
        contact,
        hits.start,
        hits.end,
        hits.lasts,
        hits.point_at_start,
        hits.point_at_end,
        np.zeros(len(contact), bool),
    )
    return times.take(pair >= 0)


def _gone(contact: NDArray[np.int64]) -> ContactChanges:
    """Touches that end because the other collider is gone."""
    zero, nowhere, no = (
        np.zeros(len(contact)),
        np.full((len(contact), 3), np.nan),
        np.zeros(len(contact), bool),
    )
    return ContactChanges(contact, zero, zero, no, nowhere, nowhere, ~no)


def _joined(first: ContactChanges, second: ContactChanges) -> ContactChanges:
    return (
        ContactChanges._make(np.concatenate(pair) for pair in zip(first, second, strict=True))
        if len(second.contact)
        else first
    )


def _is_same(first: Ints, second: Ints) -> bool:
    return len(first) == len(second) and bool((first == second).all())


def _numbers(old: tuple[object, ...], new: tuple[object, ...]) -> NDArray[np.int64]:
    """The place of each of `old` among `new`, or -1."""
    return np.array([new.index(name) if name in new else -1 for name in old] or [-1], np.int64)


def _keys(owner: Ints, kind: Ints) -> NDArray[np.int64]:
    """A unique number for each actor's collider."""
    keys: NDArray[np.int64] = (owner.astype(np.int64) << 16) + kind
    return keys


def _rows_of(keys: NDArray[np.int64], wanted: NDArray[np.int64]) -> NDArray[np.int64]:
    """The row of the unique `keys` at which each of `wanted` stands, -1 none."""
    if not len(keys):
        return np.full(len(wanted), -1)
    order = keys.argsort(kind="stable")
    row = order[keys[order].searchsorted(wanted).clip(max=len(keys) - 1)]
    return np.where(keys[row] == wanted, row, -1)

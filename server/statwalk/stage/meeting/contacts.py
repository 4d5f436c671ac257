"""What a stage remembers of touches, and what has become of them in a tick: arrays over all who touch, without a look at a single one."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.world.collide import Bodies, Touches

Pair = tuple[str, str]
"""names of an actor's own collider and of the other's"""


@dataclass(frozen=True, eq=False)
class Contacts:
    """Who touched whom at a tick. Never changed."""

    pairs: tuple[Pair, ...] = ()
    """that somebody's senses name"""
    touching: NDArray[np.int64] = field(default_factory=lambda: np.zeros((0, 3), np.int64))
    """(T, 3) actor, row of `pairs`, other actor"""
    bodies: Bodies | None = None
    """where the colliders were; their kinds are rows of `names`"""

    @property
    def names(self) -> tuple[str, ...]:
        """The colliders that matter."""
        return tuple(dict.fromkeys(name for pair in self.pairs for name in pair))

    @property
    def row_of_pair(self) -> NDArray[np.int64]:
        """(K, K) for the kinds of an actor's own collider and of the other's the row of `pairs`, or -1."""
        names = self.names
        table = np.full((len(names), len(names)), -1)
        for row, (own, other) in enumerate(self.pairs):
            table[names.index(own), names.index(other)] = row
        return table

    def since(self, before: Contacts, bodies: Bodies) -> Bodies:
        """The colliders of now with where they were before; who was not there then has not moved."""
        if before.bodies is None or not len(before.bodies.owner):
            return bodies
        kinds = _numbers(before.names, self.names)[before.bodies.kind]
        row = _found(_keys(before.bodies.owner, kinds), _keys(bodies.owner, bodies.kind))
        known = (row >= 0)[:, None]
        center, normal = before.bodies.now[row], before.bodies.normal[row]
        return bodies._replace(before=np.where(known, center, bodies.now), normal_before=np.where(known, normal, bodies.normal))

    def remembered(self, before: Contacts) -> NDArray[np.int64]:
        """Who touched whom before, in rows of this tick's pairs."""
        pair = _numbers(before.pairs, self.pairs)[before.touching[:, 1]]
        renumbered = np.stack([before.touching[:, 0], pair, before.touching[:, 2]], -1)
        return renumbered[pair >= 0]


class Meetings(NamedTuple):
    """Touches as an actor has them, (M,) each: one for each side that has a sense for it."""

    who: NDArray[np.int64]
    """(M, 3) actor, row of the pairs, other actor"""
    start: Floats
    end: Floats
    lasts: Bools
    at_start: Floats
    """(M, 3) metres; not a number where the other is gone"""
    at_end: Floats
    was: Bools
    """they touched when the tick began"""

    def take(self, rows: Ints | Bools) -> Meetings:
        """Some of them."""
        return Meetings._make(array[rows] for array in self)


def meetings(found: Touches, bodies: Bodies, row_of_pair: Ints, before: NDArray[np.int64]) -> Meetings:
    """What has become of the touches `before` (T, 3), and of those `found` among the `bodies` of this tick."""
    sides = [_side(found, bodies, row_of_pair, first, second) for first, second in ((0, 1), (1, 0))]
    both = Meetings._make(np.concatenate(arrays) for arrays in zip(*sides, strict=True))
    ids, number = np.unique(np.concatenate([both.who[:, ::2], before[:, ::2]]), return_inverse=True)
    actor, other = number.reshape(-1, 2).T
    keys = (actor * (row_of_pair.max(initial=0) + 1) + np.concatenate([both.who[:, 1], before[:, 1]])) * len(ids) + other
    now, then = keys[: len(both.who)], keys[len(both.who) :]
    gone = before[_found(now, then) < 0]
    return _joined(both._replace(was=_found(then, now) >= 0), _gone(gone))


def _side(found: Touches, bodies: Bodies, row_of_pair: Ints, first: int, second: int) -> Meetings:
    """Those that the colliders in one column of the pairs have a sense for."""
    own, other = found[first], found[second]
    pair = row_of_pair[bodies.kind[own], bodies.kind[other]]
    who = np.stack([bodies.owner[own], pair, bodies.owner[other]], -1)
    times = Meetings(who, found.start, found.end, found.lasts, found.point_at_start, found.point_at_end, np.zeros(len(who), bool))
    return times.take(pair >= 0)


def _gone(who: NDArray[np.int64]) -> Meetings:
    """Touches that are over because there is nothing left to touch."""
    zero, nowhere, no = np.zeros(len(who)), np.full((len(who), 3), np.nan), np.zeros(len(who), bool)
    return Meetings(who, zero, zero, no, nowhere, nowhere, ~no)


def _joined(first: Meetings, second: Meetings) -> Meetings:
    return Meetings._make(np.concatenate(pair) for pair in zip(first, second, strict=True)) if len(second.who) else first


def _numbers(old: tuple[object, ...], new: tuple[object, ...]) -> NDArray[np.int64]:
    """The place of each of `old` among `new`, or -1."""
    return np.array([new.index(one) if one in new else -1 for one in old] or [-1], np.int64)


def _keys(owner: Ints, kind: Ints) -> NDArray[np.int64]:
    """One number for an actor's collider."""
    keys: NDArray[np.int64] = (owner.astype(np.int64) << 16) + kind
    return keys


def _found(keys: NDArray[np.int64], wanted: NDArray[np.int64]) -> NDArray[np.int64]:
    """The row of `keys`, which differ, at which each of `wanted` stands, or -1."""
    if not len(keys):
        return np.full(len(wanted), -1)
    order = keys.argsort(kind="stable")
    row = order[keys[order].searchsorted(wanted).clip(max=len(keys) - 1)]
    return np.where(keys[row] == wanted, row, -1)

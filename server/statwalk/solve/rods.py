"""Gives the rods of hanging chains their lengths back: Newton's method for all rods at once.

Rod j goes from point j to point j + 1 with d = x(j+1) − x(j), and shall have the length l. A round solves
(w(j) + w(j+1)) |d|² p(j) − w(j) d(j−1)·d(j) p(j−1) − w(j+1) d(j)·d(j+1) p(j+1) = (|d|² − l²) / 2 for the
pulls p, a tridiagonal system, and moves each point by w (d(j) p(j) − d(j−1) p(j−1)); w: the inverse of its
mass.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.lane_elementary import of
from statwalk.maths.simd.lane_functions import least, most
from statwalk.maths.simd.lane_quat import minus, vector_square
from statwalk.maths.simd.lane_vector import added, dot
from statwalk.maths.simd.lanes import broadcast, load, store
from statwalk.maths.simd.pose_lanes import load3, store3
from statwalk.solve.chain_lanes import JOINT, LENGTH
from statwalk.solve.hanging import FREE, LINK, NEW, PULL, ROD, UPPER

ZERO, ONE = np.float32(0), np.float32(1)
ROUNDS = 5
SOFTNESS = 1e-4
"""of a rod's square: it keeps the system solvable where both ends of a straight chain are held"""
STRONGEST = 64.0
"""pull in lengths of a rod: no round moves a point further"""


@called
def fit_rods(count: int, first: int, scratch: Any, work: Any) -> None:
    """Moves the points at NEW of `count` joints, the first of which is at `first` in `work`, until the rods
    between them have the lengths at LENGTH in `scratch`.
    """
    for _ in range(ROUNDS):
        _eliminate(count, first, scratch, work)
        _pull(count, first, work)


@inlined
def _eliminate(count: int, first: int, scratch: Any, work: Any) -> None:
    """Solves the system; the pulls are at PULL."""
    zero, one = broadcast(ZERO), broadcast(ONE)
    before, per_before, pull = (zero, zero, zero), zero, zero
    for place in range(count - 1):
        at = first + place * LINK
        rod = minus(load3(work, at + LINK + NEW), load3(work, at + NEW))
        store3(work, at + ROD, rod)
        square, bone = vector_square(rod), load(scratch, (place + 1) * JOINT + LENGTH)
        wanted = bone * bone
        free = load(work, at + FREE)
        beside = -free * dot(before, rod)
        upper = beside * per_before
        if place > 0:
            store(work, at - LINK + UPPER, upper)
        whole = (free + load(work, at + LINK + FREE)) * square + of(SOFTNESS) * wanted - beside * upper
        per_before = one / most(whole, of(1e-20))
        pull = (of(0.5) * (square - wanted) - beside * pull) * per_before
        store(work, at + PULL, pull)
        before = rod
    pull = zero
    for step in range(count - 1):
        at = first + (count - 2 - step) * LINK
        upper = load(work, at + UPPER) if step > 0 else zero
        pull = load(work, at + PULL) - upper * pull
        pull = least(most(pull, of(-STRONGEST)), of(STRONGEST))
        store(work, at + PULL, pull)


@inlined
def _pull(count: int, first: int, work: Any) -> None:
    """Moves the points along their rods."""
    for place in range(count - 1):
        at = first + place * LINK
        rod, pull = load3(work, at + ROD), load(work, at + PULL)
        here, there = load3(work, at + NEW), load3(work, at + LINK + NEW)
        store3(work, at + NEW, added(here, rod, load(work, at + FREE) * pull))
        store3(work, at + LINK + NEW, added(there, rod, -load(work, at + LINK + FREE) * pull))

"""The order in which vertices collapse (DS10; RTCA 3.1, LODD), as a model stores it.

Every collapse moves a vertex onto another vertex of the same primitive; no vertex is new. So a coarser skin
has some of the full skin's vertices, and their weights, morph targets and texture coordinates stay right.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.columns import lock_fields

MOST_LEVELS = 1_000


class DetailLevel(NamedTuple):
    """A coarser surface: all collapses of the steps below `steps` are made; its distance from the full
    surface is at most `error`, metres, in the poses in which it was measured.
    """

    steps: int
    error: float


@dataclass(frozen=True, eq=False)
class Collapses:
    """The collapses of a primitive, first to last: `vertices` (K,) move onto `onto` (K,) at the steps (K,).

    No vertex collapses twice, none onto a vertex that is gone, and steps never fall. Vertices at one place
    of the surface, in all primitives of a character, have the same step: a surface stays closed.
    """

    vertices: NDArray[np.uint32]
    onto: NDArray[np.uint32]
    steps: NDArray[np.uint32]

    def __post_init__(self) -> None:
        lock_fields(self)

    def count(self, steps: int) -> int:
        """Returns the number of collapses of the steps below `steps`."""
        return int(np.searchsorted(self.steps, steps))

    def moved(self, steps: int, vertices: int) -> Ints:
        """Returns (V,) the vertex that stands for each of so many vertices after the steps below `steps`."""
        stands_for = np.arange(vertices)
        count = self.count(steps)
        stands_for[self.vertices[:count]] = self.onto[:count]
        while True:
            further = stands_for[stands_for]
            if np.array_equal(further, stands_for):
                return stands_for
            stands_for = further


def fault(collapses: Collapses, vertices: int) -> str:
    """Returns what is wrong with collapses of a primitive with so many vertices; empty if nothing is."""
    order, onto, steps = collapses.vertices, collapses.onto, collapses.steps
    if not len(order) == len(onto) == len(steps):
        return f"it has {len(order)} vertices, {len(onto)} that they move onto, and {len(steps)} steps"
    if len(order) and max(int(order.max()), int(onto.max())) >= vertices:
        return f"it names vertex {max(int(order.max()), int(onto.max()))} of {vertices}"
    when = np.full(vertices, len(order), np.int64)
    when[order] = np.arange(len(order))
    if len(np.unique(order)) < len(order):
        return "a vertex collapses twice"
    if (when[onto] <= np.arange(len(order))).any():
        return "a vertex moves onto one that is gone"
    if (np.diff(steps.astype(np.int64)) < 0).any():
        return "its steps fall"
    return ""


def level_fault(levels: Sequence[DetailLevel]) -> str:
    """Returns what is wrong with levels; empty if nothing is."""
    if len(levels) > MOST_LEVELS:
        return f"it has {len(levels)} levels; at most {MOST_LEVELS} are read"
    finer = DetailLevel(0, 0.0)
    for level in levels:
        if level.steps <= finer.steps or not level.error >= finer.error:
            return "every level has more steps than the one before, and no smaller error"
        finer = level
    return ""


def same_rows(values: Floats) -> Ints:
    """Returns (V,) a number for each row of (V,n), the same for rows that are equal as 32-bit floats."""
    rows = np.ascontiguousarray(values, np.float32) + np.float32(0)  # -0 becomes 0
    bits = rows.view(f"V{rows.shape[1] * 4}")[:, 0]
    return np.unique(bits, return_inverse=True)[1].reshape(-1)


def remaining(faces: Ints, stands_for: Ints, places: Ints | None = None) -> Ints:
    """Returns the faces (T,3) with other vertices, without the faces that have no area left: two corners at
    one vertex, or at one of the `places` (V,).
    """
    moved: Ints = stands_for[faces]
    corners = moved if places is None else places[moved]
    flat = (corners == np.roll(corners, 1, axis=1)).any(axis=1)
    left: Ints = moved[~flat]
    return left

"""Muscles of a face (FAQ Q35): each has a contraction 0…1, and moves the vertices around its insertion along
a path that is a polynomial of the contraction, of the third degree at most.

    displacement of a vertex = share · (a1·c + a2·c² + a3·c³)

so a muscle is up to three morph targets, NAME, NAME.2 and NAME.3, whose weights are c, c² and c³: every glTF
viewer shows it. Muscles add up.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats, Ints

Point = tuple[float, float, float]
POWERS = ("", ".2", ".3")
"""what follows a muscle's name in the name of the target of each power"""
NONE = -1


@dataclass(frozen=True)
class Muscle:
    """A muscle, in metres, in the space of the mesh.

    to        the insertion: a point of the skin, or a line through points; () with `vertices` alone
    radius    how far from the insertion vertices still move; their share falls smoothly from 1 to 0. None:
              the chosen vertices move by the whole path
    path      the control points, after the origin, of the Bézier curve on which the insertion moves: 1 to 3
    joint     only vertices that follow this joint, as far as they follow it; "" all
    material  only vertices of this material; "" all
    vertices  only these vertices, counted from 0 through all parts of the character; None all
    """

    to: tuple[Point, ...]
    radius: float | None
    path: tuple[Point, ...]
    joint: str = ""
    material: str = ""
    vertices: frozenset[int] | None = None

    @property
    def powers(self) -> int:
        """Returns the number of the muscle's morph targets."""
        return len(self.path)


def target_names(name: str, muscle: Muscle) -> tuple[str, ...]:
    """Returns the names of a muscle's morph targets."""
    return tuple(name + power for power in POWERS[: muscle.powers])


def coefficients(path: Sequence[Point]) -> Floats:
    """Returns (n, 3) what the powers 1 … n of the contraction are multiplied by, for a Bézier curve from the
    origin with n control points more.
    """
    p = np.array(path, np.float64)
    match len(p):
        case 1:
            return p
        case 2:
            return np.stack([2 * p[0], p[1] - 2 * p[0]])
        case _:
            return np.stack([3 * p[0], 3 * p[1] - 6 * p[0], p[2] - 3 * p[1] + 3 * p[0]])


def shares(points: Floats, muscle: Muscle) -> Floats:
    """Returns (V,) how far points (V, 3) move with a muscle: 1 at its insertion, 0 from its radius on, smooth
    at both; 1 everywhere without a radius.
    """
    if muscle.radius is None:
        return np.ones(len(points))
    part = np.minimum(distance_to_line(points, np.array(muscle.to, np.float64)) / muscle.radius, 1.0)
    return np.asarray((1 - part * part) ** 2)


def distance_to_line(points: Floats, line: Floats) -> Floats:
    """Returns (V,) the distances of points (V, 3) from the line through the points (K, 3)."""
    nearest = np.linalg.norm(points - line[0], axis=-1)
    for start, end in pairwise(line):
        way = end - start
        along = np.clip((points - start) @ way / max(float(way @ way), 1e-30), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(points - start - along[:, None] * way, axis=-1))
    return np.asarray(nearest)


def contractions_of(
    muscles: Mapping[str, Muscle], columns: Mapping[str, tuple[int, ...]]
) -> list[tuple[int, int, int]]:
    """Returns, for each muscle and each mesh that it moves, the columns of a pose's weights for contraction,
    square and cube, NONE where it has none; `columns` by the names of the morph targets.
    """
    rows: list[tuple[int, int, int]] = []
    for name, muscle in muscles.items():
        first, second, third = (
            columns[name + power] if number < muscle.powers else () for number, power in enumerate(POWERS)
        )
        for number, column in enumerate(first):
            rows.append((column, second[number] if second else NONE, third[number] if third else NONE))
    return rows


def contracted(weights: Floats, rows: Sequence[tuple[int, int, int]]) -> Floats:
    """Returns weights (…, W) whose contractions are within 0…1, with the squares and cubes that follow;
    `rows` is what `contractions_of` returned.
    """
    if not rows:
        return weights
    table: Ints = np.array(rows)
    out = weights.copy()
    once = np.clip(out[..., table[:, 0]], 0, 1)
    out[..., table[:, 0]] = once
    for power, column in enumerate((1, 2), 2):
        has = table[:, column] != NONE
        values: NDArray[np.floating] = once * once if power == 2 else once * once * once
        out[..., table[has, column]] = values[..., has]
    return out

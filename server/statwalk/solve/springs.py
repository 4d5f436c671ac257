"""Springs on joints: what a tick reads, and what it keeps.

The far end of a joint's bone hangs on a damped spring at the place where the motion puts it. Its distance e
from there obeys e″ = −2 λ e′ − (λ² + ω²) e − g″, where g is the place in the motion, λ = ln 2 / half-life and
ω = 2π · frequency. Even travel leaves no lag: only a change of velocity swings the bone. Between two ticks
the equation is solved in closed form, so that no step is too long and no spring too stiff.
"""

from __future__ import annotations

from math import log, pi
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Ints
from statwalk.maths.columns import locked

SWING, SPEED, PLACE, VELOCITY, AGE = 0, 3, 6, 9, 12
"""of the numbers that a spring keeps: e and e′, place and velocity of g a tick ago, and the ticks so far, at
most 2; in the actor's frame of that tick, metres and seconds
"""
KEPT = 13
"""numbers that a spring keeps"""
FARTHEST = 0.9
"""of the bone's length, that its end may be away from its place: the bone never turns over"""


class Springs(NamedTuple):
    """S springs; n joints: the joints with a spring and their ancestors, parents first."""

    joint: Annotated[NDArray[np.int32], "joint"]
    parent: Annotated[NDArray[np.int32], "joint"]
    """the index of each joint's parent in the list, -1 a root"""
    row: Annotated[NDArray[np.int32], "joint"]
    """the row of each joint's spring, -1 none"""
    numbers: Annotated[NDArray[np.float64], "spring, 6"]
    """x, y, z of the bone's end in the joint's frame; λ (1/s), ω (rad/s), the weight"""
    column: Annotated[NDArray[np.int64], "spring"]
    """of its first number in the memory of solvers"""


class Spring(NamedTuple):
    """The spring of a joint, as a file gives it."""

    end: tuple[float, float, float]
    """metres in the joint's frame"""
    half_life: float
    frequency: float
    weight: float


def springs_of(springs: dict[int, Spring], columns: dict[int, int], parent: Ints) -> Springs:
    """Returns the tables of springs by joint; `columns`: the first number that each keeps; parent (J,)."""
    needed: set[int] = set()
    for joint in springs:
        while joint >= 0:
            needed.add(joint)
            joint = int(parent[joint])
    order = sorted(needed)
    index = {joint: number for number, joint in enumerate(order)}
    rows = {joint: row for row, joint in enumerate(springs)}
    numbers = [
        (*spring.end, log(2) / spring.half_life, 2 * pi * spring.frequency, spring.weight)
        for spring in springs.values()
    ]
    return locked(
        Springs(
            np.array(order, np.int32),
            np.array([index.get(int(parent[joint]), -1) for joint in order], np.int32),
            np.array([rows.get(joint, -1) for joint in order], np.int32),
            np.array(numbers, np.float64).reshape(-1, 6),
            np.array([columns[joint] for joint in springs], np.int64),
        )
    )

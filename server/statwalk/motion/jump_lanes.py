"""The offset at the start of a new motion, sixteen actors at a time: the shown pose less the new motion (see
`motion.inertialize`).

The new motion is extrapolated two ticks back at its present velocity; offsets are taken at the tick before
this one.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from statwalk.maths.compiling import inlined
from statwalk.maths.simd.lane_functions import any_above, most, root, where_below
from statwalk.maths.simd.lane_quat import (
    conjugate,
    minus,
    mul,
    plus,
    renormalized,
    scaled,
    to_rotation_vector,
    vector_square,
)
from statwalk.maths.simd.lanes import broadcast

ONE = np.float32(1)
TURN = np.float32(2 * np.pi)
APART = np.float32(9.8)
"""slightly less than the square of half a turn"""
SMALLEST = np.float32(1e-6)


@inlined
def number_jump(before: Any, shown: Any, new: Any, following: Any, per_second: Any) -> Any:
    """Returns the offset of numbers, and its velocity per second."""
    step = following - new
    start = shown - (new - step)
    earlier = before - (new - (step + step))
    return start, (start - earlier) * per_second


@inlined
def vector_jump(before: Any, shown: Any, new: Any, following: Any, per_second: Any) -> Any:
    """Returns the offset of vectors, and its velocity per second."""
    step = minus(following, new)
    start = minus(shown, minus(new, step))
    earlier = minus(before, minus(new, plus(step, step)))
    return start, scaled(minus(start, earlier), per_second)


@inlined
def _turn_between(to: Any, of: Any) -> Any:
    """The rotation vector from `of` to `to`, along the shorter arc."""
    return to_rotation_vector(mul(to, conjugate(of)))


@inlined
def _on_the_branch_of(turn: Any, near: Any) -> Any:
    """The rotation vector of the same rotation that is nearer to `near`: of its two ways round."""
    distance = vector_square(minus(turn, near))
    if any_above(distance, broadcast(APART)):  # else the other way, a whole turn off, is farther
        length = most(root(vector_square(turn)), broadcast(SMALLEST))
        opposite = scaled(turn, broadcast(ONE) - broadcast(TURN) / length)
        opposite_distance = vector_square(minus(opposite, near))
        x, y = (
            where_below(opposite_distance, distance, opposite[0], turn[0]),
            where_below(opposite_distance, distance, opposite[1], turn[1]),
        )
        return x, y, where_below(opposite_distance, distance, opposite[2], turn[2])
    return turn


@inlined
def rotation_jump(before: Any, shown: Any, new: Any, following: Any, per_second: Any) -> Any:
    """Returns the offset of rotations as rotation vectors, and its velocity per second."""
    back = renormalized(mul(new, conjugate(following)))
    came = renormalized(mul(back, new))
    start = _turn_between(shown, came)
    earlier = _turn_between(before, renormalized(mul(back, came)))
    return start, scaled(minus(start, _on_the_branch_of(earlier, start)), per_second)

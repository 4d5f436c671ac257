"""How feet lie on uneven ground, called from Python."""

import math
from typing import Any

from late_kernel import late_kernel
from numba import types
from statwalk.maths.compiling import LONG, write
from statwalk.maths.reference import by_reference
from statwalk.solve.chains import POLE
from statwalk.solve.foot_aside import way_out
from statwalk.solve.foot_height import come_down_gently, floor_of
from statwalk.solve.foot_knee import write_pole
from statwalk.solve.foot_lock import step_foot
from statwalk.solve.foot_path import along_path, choose_landing, stretch_path
from statwalk.solve.foot_points import ankle_of
from statwalk.solve.foot_stretch import beyond_softening
from statwalk.solve.foot_tables import FEET, TO_X, TO_Z
from statwalk.solve.footing import height_over, points_supported, slope_under

DOUBLE = types.float64


@late_kernel(FEET, LONG, DOUBLE, DOUBLE, DOUBLE, DOUBLE, write(DOUBLE, 1))
def lie(feet: Any, foot: int, x: float, z: float, sine: float, cosine: float, out: Any) -> None:
    """Writes slope along x and z, height and supported points of a foot there."""
    f = by_reference(feet)
    out[0], out[1] = slope_under(f, foot, x, z, sine, cosine)
    out[2] = height_over(f, foot, x, z, sine, cosine, out[0], out[1], 0.0, 0.0, 0.0)
    out[3] = points_supported(f, foot, x, z, sine, cosine)


@late_kernel(FEET, LONG, DOUBLE, DOUBLE, write(DOUBLE, 2), write(DOUBLE, 1), write(DOUBLE, 2))
def land(feet: Any, foot: int, x: float, z: float, keep: Any, place: Any, path: Any) -> None:
    """Writes where a foot lands whose motion lands at x, z, and the shares of the way and the heights (N, 2)
    of its path from x = 0, z = 0 and the height that `keep` has; it points along +Z.
    """
    f = by_reference(feet)
    choose_landing(f, keep, 0, foot, 0, x, z, 0.0, 1.0)
    stretch_path(f, keep, 0, foot, 0, 0.0)
    place[0], place[1] = keep[0, TO_X], keep[0, TO_Z]
    size = math.sqrt(place[0] * place[0] + place[1] * place[1])
    for part in range(path.shape[0]):
        path[part, 0], path[part, 1] = along_path(keep, 0, 0, part / (path.shape[0] - 1.0), size)


@late_kernel(FEET, types.Array(types.float32, 4, "C", readonly=True), write(DOUBLE, 1))
def aside(feet: Any, legs: Any, out: Any) -> None:
    """Writes the way out of steps, x and z, of foot 0 of an actor at the origin."""
    out[0], out[1] = way_out(by_reference(feet), legs, 0, 0, (0.0, 0.0, 0.0, 0.0, 1.0), 0.0, 0.0, 0.0)


@late_kernel(
    FEET, types.Array(types.float32, 4, "C", readonly=True), DOUBLE, DOUBLE, DOUBLE, DOUBLE, returns=DOUBLE
)
def stretched(feet: Any, legs: Any, animated: float, drop: float, left: float, wanted: float) -> Any:
    """Returns how far below its hip the target of foot 0 is put that shall come `wanted` below it; it is
    `animated` below it in its motion, before the pelvis is lowered by `drop`, and the part `left` of the
    pose offset is left.
    """
    f, root = by_reference(feet), (0.0, 0.0, 0.0, 0.0, 1.0)
    ankle = (0.0, -animated, 0.0, 0.0)
    _, y, _ = beyond_softening(f, legs, 0, 0, root, ankle, drop, left, (0.0, -drop - wanted, 0.0))
    return -drop - y


@late_kernel(
    FEET, types.Array(types.float32, 4, "C", readonly=True), write(DOUBLE, 2), DOUBLE, returns=DOUBLE
)
def raised(feet: Any, legs: Any, keep: Any, shown: float) -> Any:
    """Returns by how much foot 0 of an actor at the origin is at least above its animated one; `shown`: by
    how much foot 0 would be above it, had foot 0 not come down since the tick before.
    """
    f, root = by_reference(feet), (0.0, 0.0, 0.0, 0.0, 1.0)
    return floor_of(f, legs, keep, 0, 0, 0, (0.0, 0.0, 0.0, 0.0), (0, 0.0, 0.0, 0.0), root, shown, 1 / 60)


@late_kernel(FEET, types.Array(types.float32, 4, "C", readonly=True), write(DOUBLE, 2))
def stepped(feet: Any, legs: Any, keep: Any) -> None:
    """Moves the numbers of the only foot of an actor at the origin on by a tick; its motion plants it."""
    root = 0.0, 0.0, 0.0, 0.0, 1.0
    step_foot(by_reference(feet), legs, keep, 0, 0, 0, -1, root, True, False, 1 / 60)


@late_kernel(FEET, types.Array(types.float32, 4, "C", readonly=True), returns=DOUBLE)
def yaw(feet: Any, legs: Any) -> Any:
    """Returns the yaw of foot 0 of an actor at the origin."""
    return ankle_of(by_reference(feet), legs, 0, 0, (0.0, 0.0, 0.0, 0.0, 1.0))[3]


@late_kernel(write(DOUBLE, 2), DOUBLE, DOUBLE, DOUBLE, DOUBLE)
def gently(keep: Any, old: float, rate: float, shown: float, floor: float) -> None:
    """Slows down the foot that `keep` has."""
    come_down_gently(keep, 0, 0, old, rate, shown, floor, 1 / 60)


@late_kernel(
    FEET,
    types.Array(types.float32, 4, "C", readonly=True),
    types.Array(types.float32, 2, "C"),
    write(DOUBLE, 1),
)
def bend_knee(feet: Any, legs: Any, inputs: Any, pole: Any) -> None:
    """Writes the direction in which the knee of foot 0 bends, whose target `inputs` has."""
    write_pole(by_reference(feet), legs, inputs, 0, 0, 0, 0.0)
    for axis in range(3):
        pole[axis] = inputs[POLE + axis, 0]

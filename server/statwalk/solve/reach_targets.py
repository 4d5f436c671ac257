"""The inputs of the chains of a machine file's solvers: targets and poles from parameters to model space.

`r` ReachTables; `smoothed` the parameters, a row for each actor; `joints` the model matrices of `r.joints`;
`keep` the solvers' memory; `root` x, y, z of the actor, sine and cosine of its heading.
"""

from __future__ import annotations

import math
from typing import Any

from statwalk.maths.compiling import inlined
from statwalk.maths.reference import called
from statwalk.maths.simd.pose_layout import place_of
from statwalk.maths.springs import settled
from statwalk.solve.chains import LOOK_AT, POLE, POLE_POINT, ROTATION, TARGET
from statwalk.solve.foot_points import on_stage
from statwalk.solve.reach_tables import FAR, X_RATE, X

SHORTEST = 1e-6
"""length of a smoothed direction or rotation that has none: its old value and its new one are opposite"""


@called
def write_inputs(
    r: Any, chains: Any, smoothed: Any, joints: Any, keep: Any, rows: Any, row: int, k: int, root: Any,
    weight: float, dt: float,
) -> None:  # fmt: skip
    """Writes target, pole and rotation of a solver's chain for one actor; an end that travels goes on."""
    _, lane = place_of(row)
    x, y, z = _target(r, smoothed, joints, row, k, root, FAR)
    if r.travel[k] >= 0.0:
        x, y, z = _travelled(r, joints, keep, row, k, root, (x, y, z), weight, dt)
    if r.cone[k, 0] > -1.0:
        x, y, z = _in_cone(_joint(joints, row, r.end[k]), (x, y, z), r.cone[k, 0], r.cone[k, 1])
    rows[TARGET, lane], rows[TARGET + 1, lane], rows[TARGET + 2, lane] = x, y, z
    x, y, z = _pole(r, chains, smoothed, row, k, root)
    rows[POLE, lane], rows[POLE + 1, lane], rows[POLE + 2, lane] = x, y, z
    if chains.turns_end[r.first_chain[0] + k]:
        x, y, z, w = _rotation(r, smoothed, row, k, root)
        rows[ROTATION, lane], rows[ROTATION + 1, lane], rows[ROTATION + 2, lane] = x, y, z
        rows[ROTATION + 3, lane] = w


@called
def distance_left(r: Any, chains: Any, smoothed: Any, joints: Any, row: int, k: int, root: Any) -> Any:
    """Returns the metres from the end of a solver's chain to its target; look-at: by which the line of sight
    passes it, or from the eye if the target is behind. A direction is a target one metre away.
    """
    x, y, z = _target(r, smoothed, joints, row, k, root, 1.0)
    a, b, c = _joint(joints, row, r.end[k])
    x, y, z = x - a, y - b, z - c
    number = r.first_chain[0] + k
    if chains.solver[number] == LOOK_AT:
        a, b, c = _sight(chains, joints, row, r.end[k], number)
        if x * a + y * b + z * c > 0.0:  # else the target is behind
            size = math.sqrt(max(a * a + b * b + c * c, 1e-12))
            x, y, z = (y * c - z * b) / size, (z * a - x * c) / size, (x * b - y * a) / size
    return math.sqrt(x * x + y * y + z * z)


@inlined
def _sight(chains: Any, joints: Any, row: int, place: int, number: int) -> Any:
    """The direction in which a joint looks."""
    block, lane = place_of(row)
    x, y, z = chains.forward[number, 0], chains.forward[number, 1], chains.forward[number, 2]
    a = joints[block, place, 0, lane] * x + joints[block, place, 1, lane] * y
    b = joints[block, place, 4, lane] * x + joints[block, place, 5, lane] * y
    c = joints[block, place, 8, lane] * x + joints[block, place, 9, lane] * y
    a, b = a + joints[block, place, 2, lane] * z, b + joints[block, place, 6, lane] * z
    return a, b, c + joints[block, place, 10, lane] * z


@inlined
def _in_model(x: float, y: float, z: float, root: Any) -> Any:
    """A point of the stage in model space."""
    return _turned_back(x - root[0], y - root[1], z - root[2], root)


@inlined
def _turned_back(x: float, y: float, z: float, root: Any) -> Any:
    """A direction of the stage in model space."""
    return x * root[4] - z * root[3], y, z * root[4] + x * root[3]


@inlined
def _target(r: Any, smoothed: Any, joints: Any, row: int, k: int, root: Any, away: float) -> Any:
    """The target in model space; of a direction: the point that is `away` metres from the chain's end."""
    x, y = smoothed[row, r.target[k, 0]], smoothed[row, r.target[k, 1]]
    z = smoothed[row, r.target[k, 2]]
    if r.is_direction[k]:
        if r.in_stage[k]:
            x, y, z = _turned_back(x, y, z, root)
        a, b, c = _joint(joints, row, r.end[k])
        part = away / max(math.sqrt(x * x + y * y + z * z), SHORTEST)
        return a + part * x, b + part * y, c + part * z
    if r.in_stage[k]:
        return _in_model(x, y, z, root)
    return x, y, z


@inlined
def _pole(r: Any, chains: Any, smoothed: Any, row: int, k: int, root: Any) -> Any:
    """The pole, a point or a direction, in model space."""
    if r.pole_parameter[k, 0] < 0:
        return r.pole[k, 0], r.pole[k, 1], r.pole[k, 2]
    x, y = smoothed[row, r.pole_parameter[k, 0]], smoothed[row, r.pole_parameter[k, 1]]
    z = smoothed[row, r.pole_parameter[k, 2]]
    if not r.in_stage[k]:
        return x, y, z
    if chains.pole_kind[r.first_chain[0] + k] == POLE_POINT:
        return _in_model(x, y, z, root)
    return _turned_back(x, y, z, root)


@inlined
def _rotation(r: Any, smoothed: Any, row: int, k: int, root: Any) -> Any:
    """The rotation x y z w of the end in model space, unit length."""
    if r.rotation_parameter[k, 0] < 0:
        return r.rotation[k, 0], r.rotation[k, 1], r.rotation[k, 2], r.rotation[k, 3]
    x, y = smoothed[row, r.rotation_parameter[k, 0]], smoothed[row, r.rotation_parameter[k, 1]]
    z, w = smoothed[row, r.rotation_parameter[k, 2]], smoothed[row, r.rotation_parameter[k, 3]]
    size = math.sqrt(x * x + y * y + z * z + w * w)
    if size < SHORTEST:
        return 0.0, 0.0, 0.0, 1.0
    x, y, z, w = x / size, y / size, z / size, w / size
    if not r.in_stage[k]:
        return x, y, z, w
    sine, cosine = _half(root[3], root[4])
    return cosine * x - sine * z, cosine * y - sine * w, cosine * z + sine * x, cosine * w + sine * y


@inlined
def _half(sine: float, cosine: float) -> Any:
    """Sine and cosine of half an angle within half a turn."""
    half = math.sqrt(max(0.5 - 0.5 * cosine, 0.0))
    return (-half if sine < 0.0 else half), math.sqrt(max(0.5 + 0.5 * cosine, 0.0))


@inlined
def _joint(joints: Any, row: int, place: int) -> Any:
    block, lane = place_of(row)
    return joints[block, place, 3, lane], joints[block, place, 7, lane], joints[block, place, 11, lane]


@inlined
def _travelled(
    r: Any, joints: Any, keep: Any, row: int, k: int, root: Any, target: Any, weight: float, dt: float
) -> Any:
    """Where the end of a chain has got to on its way to the target; without weight: where it is."""
    start, at = _joint(joints, row, r.start[k]), r.memory[k]
    if weight <= 0.0:
        end = _joint(joints, row, r.end[k])
        if r.in_stage[k]:
            end = on_stage(end[0], end[1], end[2], root)
        for axis in range(3):
            keep[row, at + X + axis], keep[row, at + X_RATE + axis] = end[axis], 0.0
        return target
    goal = _within_reach(start, target, r.length[k])
    if r.in_stage[k]:
        goal = on_stage(goal[0], goal[1], goal[2], root)
    for axis in range(3):
        place, rate = goal[axis], 0.0
        if r.travel[k] > 0.0:
            left = keep[row, at + X + axis] - goal[axis]
            left, rate = settled(left, keep[row, at + X_RATE + axis], r.travel[k], dt)
            place += left
        keep[row, at + X + axis], keep[row, at + X_RATE + axis] = place, rate
    x, y, z = keep[row, at + X], keep[row, at + X + 1], keep[row, at + X + 2]
    if r.in_stage[k]:
        return _in_model(x, y, z, root)
    return x, y, z


@inlined
def _in_cone(eye: Any, target: Any, cosine: float, sine: float) -> Any:
    """The target, or the nearest direction to it in a cone about +Z, as far from the eye."""
    x, y, z = target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]
    across, away = math.sqrt(x * x + y * y), math.sqrt(x * x + y * y + z * z)
    if z >= cosine * away:
        return target
    if across < 1e-6 * away:
        x, y, across = 1.0, 0.0, 1.0
    part = away * sine / across
    return eye[0] + part * x, eye[1] + part * y, eye[2] + away * cosine


@inlined
def _within_reach(start: Any, target: Any, length: float) -> Any:
    """The target, or the point of the way there at which the chain is at full stretch."""
    x, y, z = target[0] - start[0], target[1] - start[1], target[2] - start[2]
    part = min(1.0, length / max(math.sqrt(x * x + y * y + z * z), 1e-9))
    return start[0] + part * x, start[1] + part * y, start[2] + part * z

"""Why nothing jumps: the difference between what was shown and what comes next becomes an offset that dies out (SM4).

After Bollo, *Inertialization* (GDC 2018): only the new motion is evaluated, and the offset is taken from the poses that were
*shown*, so an interrupted transition is no special case. An offset is a row of D = 9J + W numbers for each actor: translations
(metres), rotations (rotation vectors in the parent's space, radians), scales, morph weights.

The offset keeps the velocity it had and comes to rest after `duration` seconds with the least peak acceleration there is: full
acceleration one way, then the other (Bollo's quintic needs half as much again; what the eye would take for a jump is acceleration).
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose


def size(pose: Pose) -> int:
    """How many numbers an offset of such a pose has."""
    joints, weights = pose.translation.shape[-2], pose.weights.shape[-1]
    return int(9 * joints + weights)


def difference(to: Pose, of: Pose) -> Floats:
    """What must be added to poses `of` (N, …) to get `to`: offsets (N, D), along the shorter arc."""
    turn = quat.to_rotation_vector(quat.mul(to.rotation, quat.conjugate(of.rotation)))
    return _flat(to.translation - of.translation, turn, to.scale - of.scale, to.weights - of.weights)


def add(pose: Pose, offset: Floats) -> Pose:
    """The poses (N, …) with offsets (N, D) on top."""
    move, turn, stretch, weights = _parts(offset, pose)
    rotation = quat.normalize(quat.mul(quat.from_rotation_vector(turn), pose.rotation))
    return Pose(pose.translation + move, rotation, pose.scale + stretch, pose.weights + weights)


def transition(before: Pose, shown: Pose, new: Pose, following: Pose, dt: float) -> tuple[Floats, Floats]:
    """Offset (N, D) and its velocity (N, D) per second at the tick before this one, when `shown` was shown and `before` before that.

    `new` is the new motion now, `following` a tick later. It is thought to have come at that velocity for two ticks; what
    was shown, less that, is the offset: on this tick it carries on as it was, and so do position and velocity.
    """
    step = difference(following, new)
    start = difference(shown, add(new, -step))
    earlier = difference(before, add(new, -2 * step))
    rate: Floats = (start - _on_the_branch_of(earlier, start, new)) / np.float32(dt)
    return start, rate


def decay(start: Floats, rate: Floats, elapsed: Floats, duration: Floats) -> Floats:
    """The offsets (N, D), `elapsed` (N,) seconds after they were `start` and changed by `rate` per second; 0 from `duration` (N,) on.

    With acceleration a until u and −a after it: x(T) = x'(T) = 0 gives T²a² + 4(x₀ + v₀T/2)a − v₀² = 0, of whose roots the larger counts.
    """
    total = duration.astype(np.float32)[:, None]
    passed = np.minimum(elapsed.astype(np.float32)[:, None], total)
    drift = rate * total
    reach = 2 * start + drift
    acceleration = -(reach + np.copysign(np.sqrt(reach * reach + drift * drift), reach)) / (total * total)
    is_still = acceleration == 0
    switch = 0.5 * (total - rate / np.where(is_still, 1, acceleration))
    left = total - passed
    braking: Floats = -0.5 * acceleration * left * left
    speeding: Floats = start + (rate + 0.5 * acceleration * passed) * passed
    return np.where(passed < switch, speeding, braking)


def _on_the_branch_of(offset: Floats, near: Floats, pose: Pose) -> Floats:
    """`offset` with every rotation vector written, of its two ways round, in the one nearer to `near`."""
    move, turn, stretch, weights = _parts(offset, pose)
    angle = vector.length(turn)[..., None]
    other = turn * (1 - 2 * np.pi / np.maximum(angle, 1e-6)).astype(turn.dtype)
    wanted = _parts(near, pose)[1]
    is_other = vector.length(other - wanted) < vector.length(turn - wanted)
    return _flat(move, np.where(is_other[..., None], other, turn), stretch, weights)


def _flat(translation: Floats, turn: Floats, scale: Floats, weights: Floats) -> Floats:
    """The parts (N, J, 3) ×3 and (N, W) as one row for each actor."""
    rows = len(translation)
    return np.concatenate([translation.reshape(rows, -1), turn.reshape(rows, -1), scale.reshape(rows, -1), weights], -1)


def _parts(offset: Floats, pose: Pose) -> tuple[Floats, Floats, Floats, Floats]:
    """An offset's rows as views: translations, rotation vectors, scales (N, J, 3), weights (N, W)."""
    joints = pose.translation.shape[-2]
    shape, width = (len(offset), joints, 3), 3 * joints
    move, turn, stretch = (offset[:, i * width : (i + 1) * width].reshape(shape) for i in range(3))
    return move, turn, stretch, offset[:, 3 * width :]

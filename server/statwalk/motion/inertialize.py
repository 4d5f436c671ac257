"""Why nothing jumps: the difference between what was shown and what comes next becomes an offset that dies out (SM4).

After Bollo, *Inertialization* (GDC 2018): only the new motion is evaluated, and the offset is taken from the poses that were
*shown*, so an interrupted transition is no special case. An offset is a row of D = 9J + W numbers for each actor: translations
(metres), rotations (rotation vectors in the parent's space, radians), scales, morph weights.

The offset keeps the velocity it had and comes to rest after `duration` seconds along a cubic: of all ways to do so, the one with
the least acceleration (∫a² dt). Measured over every transition of faq-walker it changes position and velocity less from tick to
tick than Bollo's quintic (whose peak speed is 1.875 x₀/T, against 1.5) and than the least peak acceleration (full one way, then the other).
The quintic is there for those who ask for it: it comes to rest without force, and is nearly gone by half its time.
"""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Bools, Floats
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


def decay(start: Floats, rate: Floats, elapsed: Floats, duration: Floats, quintic: Bools | None = None) -> Floats:
    """The offsets (N, D), `elapsed` (N,) seconds after they were `start` and changed by `rate` per second; 0 from `duration` (N,) on.

    They die out along a cubic; where `quintic` (N,), along a polynomial that ends without acceleration and jerk (Bollo's).
    """
    total = duration.astype(np.float32)[:, None]
    left = 1 - np.minimum(elapsed.astype(np.float32)[:, None] / total, 1)
    drift = rate * (total * (1 - left))
    offset: Floats = (start * (3 - 2 * left) + drift) * (left * left)
    if quintic is not None and quintic.any():
        fourth = left * left * (left * left)
        offset = np.where(quintic[:, None], (start * (5 - 4 * left) + drift) * fourth, offset)
    return offset


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

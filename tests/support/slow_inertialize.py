"""Pose offsets with NumPy, as `motion.inertialize` says: what the kernels of pose offsets are held
against.
"""

import numpy as np
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.pose import Pose
from statwalk.motion.inertialize import difference

__all__ = ["add", "decay", "difference", "size", "transition"]


def size(pose: Pose) -> int:
    """How many numbers an offset of such a pose has."""
    joints, weights = pose.translation.shape[-2], pose.weights.shape[-1]
    return int(9 * joints + weights)


def add(pose: Pose, offset: Floats) -> Pose:
    """The poses (N, …) with offsets (N, D) on top."""
    move, turn, stretch, weights = _parts(offset, pose)
    rotation = quat.normalize(quat.mul(quat.from_rotation_vector(turn), pose.rotation))
    return Pose(pose.translation + move, rotation, pose.scale + stretch, pose.weights + weights)


def transition(before: Pose, shown: Pose, new: Pose, following: Pose, dt: float) -> tuple[Floats, Floats]:
    """Offset (N, D) and its velocity (N, D) per second at the tick before this one, when `shown` was shown
    and `before` before that.

    `new` is the new motion now, `following` a tick later. It is thought to have come at that velocity for two
    ticks; what was shown, less that, is the offset: on this tick it carries on as it was, and so do position
    and velocity.
    """
    step = difference(following, new)
    start = difference(shown, add(new, -step))
    earlier = difference(before, add(new, -2 * step))
    rate: Floats = (start - _on_the_branch_of(earlier, start, new)) / np.float32(dt)
    return start, rate


def decay(
    start: Floats, rate: Floats, elapsed: Floats, duration: Floats, quintic: Bools | None = None
) -> Floats:
    """The offsets (N, D), `elapsed` (N,) seconds after they were `start` and changed by `rate` per second; 0
    from `duration` (N,) on.

    They die out along a cubic; where `quintic` (N,), along a polynomial that ends without acceleration and
    jerk (Bollo's).
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


def _parts(offset: Floats, pose: Pose) -> tuple[Floats, Floats, Floats, Floats]:
    """An offset's rows as views: translations, rotation vectors, scales (N, J, 3), weights (N, W)."""
    joints = pose.translation.shape[-2]
    shape, width = (len(offset), joints, 3), 3 * joints
    move, turn, stretch = (offset[:, i * width : (i + 1) * width].reshape(shape) for i in range(3))
    return move, turn, stretch, offset[:, 3 * width :]


def _flat(translation: Floats, turn: Floats, scale: Floats, weights: Floats) -> Floats:
    """The parts (N, J, 3) ×3 and (N, W) as one row for each actor."""
    rows = len(translation)
    return np.concatenate(
        [translation.reshape(rows, -1), turn.reshape(rows, -1), scale.reshape(rows, -1), weights], -1
    )

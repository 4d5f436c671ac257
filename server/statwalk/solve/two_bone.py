"""Analytic two-bone inverse kinematics: hip, knee, ankle; shoulder, elbow, wrist (IK15)."""

from __future__ import annotations

import numpy as np

from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats


def two_bone(root: Floats, mid: Floats, end: Floats, target: Floats, pole: Floats) -> tuple[Floats, Floats]:
    """Returns the turns (…, 4) that bring `end` to `target`: world(root) becomes turn_root · world(root),
    world(mid) becomes turn_mid · world(mid).

    Points (…, 3) are in one world space, metres; `pole` (…, 3) is the direction, from the root, in which the
    middle joint bends. Bone lengths stay. For a target out of reach the limb is straight and points at it (or
    folded, if the target is too near). The new end is root + turn_root·(mid − root) + turn_mid·(end − mid).
    """
    upper, lower, aim = mid - root, end - mid, target - root
    onward = _direction(aim, end - root, upper)
    sideways = _sideways(pole, upper, onward)
    along, aside, reach = _triangle(vector.length(upper), vector.length(lower), vector.length(aim))
    new_upper = onward * along[..., None] + sideways * aside[..., None]
    new_lower = onward * reach[..., None] - new_upper
    hinge = vector.cross(sideways, onward)
    return _turn(upper, new_upper, vector.cross(upper, lower), hinge), _turn(
        lower, new_lower, vector.cross(upper, lower), hinge
    )


def _triangle(upper: Floats, lower: Floats, distance: Floats) -> tuple[Floats, Floats, Floats]:
    """The middle joint's distance along the line to the target, its distance aside from it, and the reach of
    the end.
    """
    reach = np.minimum(np.maximum(distance, np.abs(upper - lower)), upper + lower)
    along = (upper * upper - lower * lower + reach * reach) / np.where(reach > 0, 2 * reach, 1)
    return along, np.sqrt(np.maximum(upper * upper - along * along, 0)), reach


def _direction(*choices: Floats) -> Floats:
    """The unit vector along the first vector that has a length."""
    chosen = choices[0]
    for choice in choices[1:]:
        chosen = np.where(vector.length(chosen)[..., None] > 0, chosen, choice)
    return vector.unit(chosen)


def _sideways(pole: Floats, bend: Floats, onward: Floats) -> Floats:
    """The unit vector at right angles to `onward` on the side of the pole, or of the present bend if the pole
    is parallel to `onward`.
    """

    def aside(v: Floats) -> Floats:
        direction = vector.unit(v)
        rest = direction - onward * vector.dot(direction, onward)[..., None]
        return np.where(vector.length(rest)[..., None] > _straight(v), rest, 0)

    return _direction(aside(pole), aside(bend), np.broadcast_to(vector.perpendicular(onward), bend.shape))


def _straight(v: Floats) -> float:
    """The sine of the largest angle that counts as zero, in v's precision."""
    return float(np.sqrt(np.finfo(v.dtype).eps))


def _turn(old: Floats, new: Floats, old_hinge: Floats, new_hinge: Floats) -> Floats:
    """The turn that takes the bone `old` to `new` and its hinge axis along; a straight limb has no hinge, and
    gets the shortest turn.
    """
    old_x, new_x = vector.unit(old), vector.unit(new)
    is_bent = vector.length(old_hinge) > _straight(old) * vector.dot(old, old)
    shortest = quat.between(new_x, old_x)
    old_z = np.where(is_bent[..., None], vector.unit(old_hinge), quat.rotate(shortest, new_hinge))
    old_frame = np.stack([old_x, vector.cross(old_z, old_x), old_z], -1)
    new_frame = np.stack([new_x, vector.cross(new_hinge, new_x), new_hinge], -1)
    return quat.from_matrix(_times_transposed(new_frame, old_frame))


def _times_transposed(a: Floats, b: Floats) -> Floats:
    """a · bᵀ of matrices (…, 3, 3), written out."""
    terms = a[..., :, None, :] * b[..., None, :, :]
    return terms[..., 0] + terms[..., 1] + terms[..., 2]

"""From controls, the handles an animator moves, to local rotations of the skeleton; all angles in degrees,
all arrays over frames.
"""

from dataclasses import dataclass, field

import numpy as np
from curves import Array
from moves.feet import Track
from skeleton import HIP, NAMES, SHIN, SIDES, THIGH
from statwalk.maths import quat

X, Y, Z = np.eye(3)
STRAIGHT = 0.9995  # no leg is longer than this share of its bones
SLOPE = np.radians(6.0)  # shoulders hang a little
REACH, SOFTNESS = (
    0.8485,
    0.003,
)  # metres: the pelvis comes down before a leg gets longer than this, so no knee locks or snaps


@dataclass
class Controls:
    """Values by handle (F,), degrees or metres, 0 where nobody set them.

    The body's: x, y, z, yaw, lean and list of the pelvis; `pelvis_yaw`, which turns the hips and not the
    path; pitch, yaw and roll of `low` and `up` (the back) and of `head` (against the path, so that it stays
    level). Each side's, as `Left.swing`: swing, abduct, twist, elbow, forearm, wrist, wrist_side, raise and
    reach of the shoulder, knee_out.
    """

    values: dict[str, Array]
    feet: dict[str, Track] = field(default_factory=dict)

    def get(self, name: str) -> Array:
        """Radians (or metres) of a handle over the frames, 0 where nobody set it."""
        value = self.values.get(name)
        if value is None:
            return np.zeros_like(self.values["y"])
        return value if name in ("x", "y", "z") else np.radians(value)


def turn(axis: Array, angle: Array) -> Array:
    """Quaternions (F, 4) about one axis."""
    return quat.from_axis_angle(np.broadcast_to(axis, (*angle.shape, 3)), angle)


def product(*factors: Array) -> Array:
    """Quaternion product from left to right."""
    result = factors[0]
    for factor in factors[1:]:
        result = quat.mul(result, factor)
    return result


def _unit(v: Array) -> Array:
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def _bone_turn(hinge: Array, along: Array) -> Array:
    """The world rotation that points a bone's -Y along `along` with its X on `hinge`."""
    return quat.from_matrix(np.stack([hinge, -along, np.cross(hinge, -along)], axis=-1))


def _hip(side: str, pelvis: Array, root: Array) -> Array:
    return root + quat.rotate(pelvis, np.broadcast_to(np.array([SIDES[side] * HIP, 0.0, 0.0]), root.shape))


def _lowered(c: Controls, pelvis: Array, root: Array) -> Array:
    """The root, where a leg would have to stretch brought down (a smooth minimum of the wish and what each
    leg allows).
    """
    heights = [np.zeros(len(root))]
    for side in SIDES:
        hip, ankle = _hip(side, pelvis, root), c.feet[side].ankle
        level = (hip[:, 0] - ankle[:, 0]) ** 2 + (hip[:, 2] - ankle[:, 2]) ** 2
        heights.append(ankle[:, 1] + np.sqrt(np.maximum(REACH**2 - level, 0.01)) - hip[:, 1])
    down = -SOFTNESS * np.log(np.exp(-np.array(heights) / SOFTNESS).sum(0))
    return root + np.stack([np.zeros_like(down), down, np.zeros_like(down)], axis=-1)


def _leg(c: Controls, side: str, pelvis: Array, root: Array, out: dict[str, Array]) -> None:
    sign, foot = SIDES[side], c.feet[side]
    way = foot.ankle - _hip(side, pelvis, root)
    reach = np.minimum(np.linalg.norm(way, axis=-1), STRAIGHT * (THIGH + SHIN))[:, None]
    along = _unit(way)
    outward = sign * (c.get(f"{side}.knee_out") + np.radians(3.0))
    pole_yaw = (
        c.get("yaw")
        + 0.5 * c.get("pelvis_yaw")
        + 0.65 * (foot.yaw - c.get("yaw") - 0.5 * c.get("pelvis_yaw"))
        + 0.5 * outward
    )
    # the knee points where pelvis and toes agree; with a raised thigh forward is no longer across the leg, so
    # add up
    pole = np.stack([np.sin(pole_yaw), np.full_like(pole_yaw, 0.35), np.cos(pole_yaw)], axis=-1)
    ahead = _unit(pole - (pole * along).sum(-1, keepdims=True) * along)
    hinge = np.cross(-along, ahead)
    cosine = (THIGH**2 + reach**2 - SHIN**2) / (2 * THIGH * reach)
    thigh = along * cosine + ahead * np.sqrt(1 - cosine**2)
    shin = _unit(along * reach - thigh * THIGH)
    thigh_turn, shin_turn = _bone_turn(hinge, thigh), _bone_turn(hinge, shin)
    foot_turn = product(turn(Y, foot.yaw), turn(X, -foot.pitch))
    out[f"{side}.upperleg"] = quat.mul(quat.conjugate(pelvis), thigh_turn)
    out[f"{side}.lowerleg"] = quat.mul(quat.conjugate(thigh_turn), shin_turn)
    out[f"{side}.foot"] = quat.mul(quat.conjugate(shin_turn), foot_turn)


def _arm(c: Controls, side: str, out: dict[str, Array]) -> None:
    sign = SIDES[side]
    out[f"{side}.shoulder"] = product(
        turn(Y, -sign * c.get(f"{side}.reach")), turn(Z, sign * (c.get(f"{side}.raise") - SLOPE))
    )
    lift = product(turn(X, -c.get(f"{side}.swing")), turn(Z, sign * (c.get(f"{side}.abduct") + SLOPE)))
    out[f"{side}.upperarm"] = quat.mul(lift, turn(Y, -sign * c.get(f"{side}.twist")))
    out[f"{side}.lowerarm"] = product(
        turn(X, -c.get(f"{side}.elbow")), turn(Y, -sign * c.get(f"{side}.forearm"))
    )
    out[f"{side}.hand"] = product(
        turn(X, -c.get(f"{side}.wrist")), turn(Z, sign * c.get(f"{side}.wrist_side"))
    )


def _spine(c: Controls, name: str) -> Array:
    return product(
        turn(Y, c.get(f"{name}_yaw")), turn(X, c.get(f"{name}_pitch")), turn(Z, c.get(f"{name}_roll"))
    )


def solve(c: Controls) -> tuple[Array, Array]:
    """Local rotations (F, J, 4) and the root's translation (F, 3) of the controlled poses."""
    out: dict[str, Array] = {}
    path = turn(Y, c.get("yaw"))
    out["Root"] = product(path, turn(X, c.get("lean")), turn(Z, c.get("list")))
    hips = turn(Y, c.get("pelvis_yaw"))
    out["Left.butt"] = out["Right.butt"] = hips
    out["Lowerback"], out["Upperback"] = quat.mul(hips, _spine(c, "low")), _spine(c, "up")
    chest = product(out["Root"], out["Lowerback"], out["Upperback"])
    out["Head"] = product(quat.conjugate(chest), path, _spine(c, "head"))
    root = np.stack([c.get("x"), c.get("y"), c.get("z")], axis=-1)
    pelvis = quat.mul(out["Root"], hips)
    root = _lowered(c, pelvis, root)
    for side in SIDES:
        _leg(c, side, pelvis, root, out)
        _arm(c, side, out)
    return np.stack([_steady(out[name]) for name in NAMES], axis=1), root


def _steady(q: Array) -> Array:
    """The same rotations with signs that do not flip from frame to frame."""
    dots = (q[1:] * q[:-1]).sum(-1)
    signs = np.cumprod(np.where(dots < 0, -1.0, 1.0))
    return np.concatenate([q[:1], q[1:] * signs[:, None]])

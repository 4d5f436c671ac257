"""Crouching with the hands on the thighs, and getting up again with a small overshoot."""

import numpy as np
from curves import Array, Curve, eased, ramp, through
from moves.feet import walk_track
from moves.motion import Body, Feet, Motion, TrackOf, added, held, mixed, replaced, sides, value
from moves.stand import stand_body, stand_plant

LOW, BACK = 0.715, -0.070  # pelvis height, and how far behind its standing place it is
DOWN, RISE = 0.45, 0.70

POSE = {
    "x": 0.01,
    "y": LOW,
    "z": BACK,
    "lean": 25.0,
    "list": 2.2,
    "pelvis_yaw": 3.0,
    "low_pitch": 9.0,
    "low_yaw": -2.0,
    "low_roll": -1.0,
    "up_pitch": 9.0,
    "up_yaw": -3.5,
    "up_roll": -2.5,
    "head_pitch": 6.0,
    "head_yaw": 2.0,
    "head_roll": 1.0,
    "Left.swing": -1.6,
    "Right.swing": -4.7,
    "Left.abduct": 21.9,
    "Right.abduct": 20.2,
    "Left.twist": 24.5,
    "Right.twist": 28.4,
    "Left.elbow": 79.0,
    "Right.elbow": 81.8,
    "Left.forearm": 52.3,
    "Right.forearm": 54.7,
    "Left.wrist": -20.1,
    "Right.wrist": -20.5,
    "Left.wrist_side": 10.4,
    "Right.wrist_side": 11.2,
    "Left.reach": 6.0,
    "Right.reach": 6.0,
    "Left.knee_out": 10.0,
    "Right.knee_out": 11.0,
}  # the hands rest on the thighs, the left one nearer to the knee; the weight is on the left foot


def crouch_body(t: Array) -> dict[str, Array]:
    """The low pose, at all times."""
    return {name: np.full_like(t, value) for name, value in POSE.items()}


def standing_feet(pitch: Curve) -> Feet:
    """Feet on their standing places with the same pitch (radians)."""

    def make(_: str, sign: float) -> TrackOf:
        return lambda t: walk_track(t, [stand_plant(sign)], [], pitch)

    return sides(make)


def down_body() -> Body:
    """The pelvis sinks back first, then the trunk bends, and the hands reach the thighs last."""
    high, low = held(stand_body, 0.0), crouch_body
    trunk = mixed(high, low, lambda t: ramp(t, 0.0, 0.40))
    arms = mixed(high, low, lambda t: ramp(t, 0.05, DOWN))

    def whole(t: Array) -> dict[str, Array]:
        return {**trunk(t), **{name: curve for name, curve in arms(t).items() if "." in name}}

    top = value(stand_body, "y", 0)
    y = through([(0, top), (0.10, top - 0.035), (0.32, LOW - 0.010), (DOWN, LOW)])
    z = through([(0, 0), (0.10, -0.012), (0.30, BACK + 0.002), (DOWN, BACK)])
    over = {
        "lean": eased([(0.0, 0.0), (0.16, 3.0), (0.34, 1.0), (DOWN, 0.0)]),
        "head_pitch": eased([(0.0, 0.0), (0.14, 5.0), (0.30, 2.0), (DOWN, 0.0)]),
        "Left.swing": eased([(0.0, 0.0), (0.18, 16.0), (0.36, 4.0), (DOWN, 0.0)]),
        "Right.swing": eased([(0.0, 0.0), (0.20, 14.0), (0.38, 4.0), (DOWN, 0.0)]),
    }
    return replaced(added(whole, over), {"y": y, "z": z})


def rise_body() -> Body:
    """Hips first, then the chest, the arms last; up on the toes a little too far, and down."""
    weight = {"body": (0.0, 0.46), "arms": (0.08, 0.56)}
    low, high = crouch_body, held(stand_body, 0.0)
    over = {
        "lean": eased([(0.0, 0.0), (0.10, 4.0), (0.26, 0.0), (0.46, -1.8), (0.66, 0.0)]),
        "low_pitch": eased([(0.16, 0.0), (0.46, -2.0), (0.68, 0.0)]),
        "up_pitch": eased([(0.08, 0.0), (0.24, 4.0), (0.50, -2.5), (0.69, 0.0)]),
        "head_pitch": eased([(0.04, 0.0), (0.20, 4.0), (0.50, -2.0), (0.70, 0.0)]),
        "Left.swing": eased([(0.0, 0.0), (0.16, 8.0), (0.42, -10.0), (0.58, -2.0), (0.70, 0.0)]),
        "Right.swing": eased([(0.0, 0.0), (0.18, 7.0), (0.45, -9.0), (0.60, -2.0), (0.70, 0.0)]),
        "Left.raise": eased([(0.10, 0.0), (0.42, 3.0), (0.66, 0.0)]),
        "Right.raise": eased([(0.12, 0.0), (0.44, 3.0), (0.68, 0.0)]),
    }
    trunk = mixed(low, high, lambda t: ramp(t, *weight["body"]))
    arms = mixed(low, high, lambda t: ramp(t, *weight["arms"]))

    def whole(t: Array) -> dict[str, Array]:
        return {**trunk(t), **{name: curve for name, curve in arms(t).items() if "." in name}}

    top = value(stand_body, "y", 0)
    y = through(
        [
            (0, LOW),
            (0.06, LOW - 0.006),
            (0.22, 0.847),
            (0.36, top + 0.002),
            (0.44, top + 0.011),
            (0.56, top + 0.002),
            (RISE, top),
        ]
    )
    z = through([(0, BACK), (0.20, -0.030), (0.40, 0.010), (0.56, 0.002), (RISE, 0)])
    return replaced(added(whole, over), {"y": y, "z": z})


def _tiptoe(t: Array) -> Array:
    return np.radians(eased([(0.24, 0.0), (0.42, -9.0), (0.58, 0.0)])(t))


CROUCH = Motion("crouch", DOWN, down_body(), standing_feet(np.zeros_like), blinks=(0.2,))
STAND_UP = Motion("stand-up", RISE, rise_body(), standing_feet(_tiptoe))

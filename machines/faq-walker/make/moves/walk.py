"""The walk cycle: eight keys, the last four the mirror image of the first, and feet that roll over the
ground.

Phase 0 is the left heel touching the ground. Legs follow from the feet and the pelvis; the arms follow the
table of clinical gait averages.
"""

import numpy as np
from curves import Array, Curve, cyclic, cyclic_eased
from moves.feet import Arc, Plant, Track, walk_track
from moves.motion import Feet, Motion, TrackOf, sides

CYCLE, STRIDE = 1.05, 1.34  # seconds, metres (two steps)
SPEED = STRIDE / CYCLE
HEIGHT, RISE = 0.932, 0.038  # pelvis: mean, lowest to highest
AHEAD = 0.318  # how far before the pelvis the left foot's place lies when its heel touches
FOOT_X, TOES_OUT = 0.072, np.radians(7.0)
OFF = 0.625  # phase at which the toes leave the ground

# eight keys of one cycle, degrees (this side's heel touches at the first)
SHOULDER = (-22, -18, -6, 6, 12, 10, 0, -14)
ELBOW = (12, 14, 20, 28, 32, 28, 20, 14)
SHOULDER_CURVE, ELBOW_CURVE = cyclic(SHOULDER), cyclic(ELBOW)

# toes up +, degrees; uneven keys since a foot lies flat for a quarter of the cycle
PITCH = cyclic_eased(
    [
        (0.0, 20),
        (0.05, 9),
        (0.115, 0),
        (0.36, 0),
        (0.44, -3),
        (0.52, -15),
        (0.62, -50),
        (0.68, -63),
        (0.77, -40),
        (0.87, 4),
        (0.95, 20),
    ]
)
SWING = [
    Arc(0.16, 0.12, 0.232),
    Arc(0.42, 0.415, 0.216, -0.004),
    Arc(0.70, 0.815, 0.138),
    Arc(0.87, 0.963, 0.1255),
]


def walk_body(t: Array) -> dict[str, Array]:
    """Handles at time t (seconds from a left heel strike); z goes on with the path."""
    p = t / CYCLE
    once, twice = 2 * np.pi * p, 4 * np.pi * p
    drop = np.sin(once + 0.25)
    body = {
        "x": 0.020 * np.sin(once - 0.20),
        "y": HEIGHT - RISE / 2 * np.cos(twice - 0.30),
        "z": SPEED * t + 0.010 * np.sin(twice),
        "yaw": np.zeros_like(t),
        "lean": 3.0 + 0.8 * np.cos(twice - 0.5),
        "list": 3.4 * drop,
        "pelvis_yaw": -4.5 * np.cos(once - 0.1),
        "low_pitch": -0.5 - 0.8 * np.cos(twice - 1.0),
        "low_yaw": 3.5 * np.cos(once - 0.2),
        "low_roll": -2.2 * drop,
        "up_pitch": 1.0 - 0.8 * np.cos(twice - 1.5),
        "up_yaw": 6.5 * np.cos(once - 0.35),
        "up_roll": -2.4 * np.sin(once + 0.1),
        "head_pitch": 1.5 + 0.9 * np.cos(twice - 1.6),
        "head_yaw": 0.8 * np.cos(once - 0.5),
        "head_roll": 0.7 * np.sin(once - 0.3),
    }
    body.update(_arm("Left", p, 1.0))
    body.update(_arm("Right", p - 0.5 - 0.016, 0.94))
    return body


def _arm(side: str, p: Array, size: float) -> dict[str, Array]:
    swing = SHOULDER_CURVE(p)
    ahead = (swing + 5.0) / 17.0  # about -1 behind, +1 in front
    handles = {
        "raise": -1.0 + 0.6 * np.cos(4 * np.pi * p),
        "reach": 1.0 + 4.0 * (SHOULDER_CURVE(p + 0.02) + 5) / 17,
        "swing": -4.5 + 1.15 * size * (swing + 3.0),
        "abduct": 7.0 - 1.2 * ahead,
        "twist": 10.0 + 6.0 * ahead,
        "elbow": 2.0 + size * ELBOW_CURVE(p - 0.03),
        "forearm": 14.0 + 5.0 * ahead,
        "wrist": 6.0 + 5.0 * (SHOULDER_CURVE(p - 0.13) + 5) / 17,
        "wrist_side": -3.0 + 0.0 * p,
    }
    return {f"{side}.{name}": value for name, value in handles.items()}


def walk_plant(sign: float, step: int) -> Plant:
    """The step-th place of a foot: the left one's 0th begins at t = 0, the right one's half a cycle later."""
    later = step + (0.0 if sign > 0 else 0.5)
    return Plant(later * CYCLE, (later + OFF) * CYCLE, sign * FOOT_X, AHEAD + later * STRIDE, sign * TOES_OUT)


def pitch_of(sign: float) -> Curve:
    """Foot pitch (radians) over time."""
    later = 0.0 if sign > 0 else 0.5
    return lambda t: np.radians(PITCH(t / CYCLE - later))


def arcs_of(sign: float) -> list[Arc]:
    """A swing's points; the foot passes the other one closely, on the outside."""
    return [arc._replace(side=-sign * arc.side) for arc in SWING]


def walk_feet() -> Feet:
    """Feet for times from one cycle before to two cycles after t = 0."""

    def make(_: str, sign: float) -> TrackOf:
        plants = [walk_plant(sign, step) for step in range(-2, 4)]

        def track(t: Array) -> Track:
            return walk_track(t, plants, [arcs_of(sign)] * 5, pitch_of(sign))

        return track

    return sides(make)


WALK = Motion("walk", CYCLE, walk_body, walk_feet(), loop=True)

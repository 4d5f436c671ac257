"""Standing is not frozen: breathing (4 s), weight that goes from foot to foot (8 s), a look around."""

import numpy as np
from curves import Array
from moves.feet import Plant, Track, walk_track
from moves.motion import Feet, Motion, TrackOf, sides
from skeleton import SIDES

SPAN = 8.0  # seconds: one shift of weight and back, two breaths
BREATH = 4.0
HEIGHT = 0.9575
FOOT_X, FOOT_Z, TOES_OUT = 0.105, -0.032, np.radians(7.0)
FOREVER = 1e3


def stand_body(t: Array) -> dict[str, Array]:
    """Handles of the standing pose; everything rests at t = 0, where all other motions leave and arrive."""
    turn = 2 * np.pi * t / SPAN
    weight = np.tanh(1.5 * np.cos(turn)) / np.tanh(1.5)  # +1 on the left foot
    breath = (1 - np.cos(2 * np.pi * t / BREATH)) / 2
    look = np.cos(turn) - np.cos(2 * turn)
    zero = np.zeros_like(t)
    body = {
        "x": 0.013 * weight,
        "y": HEIGHT + 0.0025 * weight**2 - 0.0025 + 0.002 * breath,
        "z": -0.003 * breath,
        "yaw": zero,
        "lean": zero + 1.0,
        "list": 1.6 * weight,
        "pelvis_yaw": -1.2 * weight,
        "low_pitch": -1.0 - 0.5 * breath,
        "low_roll": -1.2 * weight,
        "up_pitch": 1.5 - 1.4 * breath,
        "up_yaw": 1.5 * weight,
        "up_roll": -1.2 * weight,
        "head_pitch": 1.5 - 1.0 * breath,
        "head_yaw": 3.2 * look,
        "head_roll": 0.8 * weight,
    }
    for side, sign in SIDES.items():
        body.update(_arm(side, sign * weight, (1 - np.cos(2 * np.pi * (t - 0.12) / BREATH)) / 2))
    return body


def _arm(side: str, loaded: Array, breath: Array) -> dict[str, Array]:
    handles = {
        "raise": -1.0 + 1.2 * breath,
        "reach": 2.0 - 1.0 * breath,
        "swing": 2.0 + 0.8 * loaded - 0.7 * breath,
        "abduct": 7.0 + 0.8 * breath - 0.8 * loaded,
        "twist": 16.0 + 0.0 * breath,
        "elbow": 13.0 - 1.5 * loaded + 1.0 * breath,
        "forearm": 14.0 + 0.0 * breath,
        "wrist": 6.0 + 1.5 * breath,
        "wrist_side": -3.0 + 0.0 * breath,
    }
    return {f"{side}.{name}": value for name, value in handles.items()}


def stand_plant(sign: float, start: float = -FOREVER, end: float = FOREVER) -> Plant:
    """Where a foot stands; sign +1 is the left one."""
    return Plant(start, end, sign * FOOT_X, FOOT_Z, sign * TOES_OUT)


def stand_feet() -> Feet:
    """Both feet stay where they are."""

    def make(_: str, sign: float) -> TrackOf:
        def track(t: Array) -> Track:
            return walk_track(t, [stand_plant(sign)], [], np.zeros_like)

        return track

    return sides(make)


STAND = Motion("stand", SPAN, stand_body, stand_feet(), loop=True, rate=30, blinks=(1.7, 5.2))

"""The run cycle: 0.72 s, two flights, feet that land under a bent knee and roll off over the toes.

Phase 0 is the left foot touching the ground, as in the walk, so that the two blend in step.
"""

import numpy as np
from curves import Array, Curve, cyclic_eased
from moves.feet import Arc, Plant, Track, walk_track
from moves.motion import Feet, Motion, TrackOf, sides

CYCLE, STRIDE = 0.72, 2.02  # seconds, metres (two steps)
SPEED = STRIDE / CYCLE
HEIGHT, RISE = 0.895, 0.062  # pelvis: mean, lowest to highest
AHEAD = 0.235  # how far before the pelvis the left foot's place lies when it touches
FOOT_X, TOES_OUT = 0.050, np.radians(5.0)
OFF = 0.38  # phase at which the toes leave the ground
MIDDLE = OFF / 2  # of the stance, where the pelvis is lowest

# toes up +, degrees
PITCH = cyclic_eased(
    [
        (0.0, 7),
        (0.05, 0),
        (0.17, 0),
        (0.24, -10),
        (0.31, -34),
        (0.38, -60),
        (0.47, -78),
        (0.57, -76),
        (0.70, -34),
        (0.83, 2),
        (0.93, 9),
    ]
)
SWING = [
    Arc(0.14, 0.075, 0.36),
    Arc(0.28, 0.235, 0.45),
    Arc(0.47, 0.48, 0.43),
    Arc(0.70, 0.815, 0.275),
    Arc(0.88, 0.975, 0.17),
]


def run_body(t: Array) -> dict[str, Array]:
    """Handles at time t (seconds from a left foot's touch); z goes on with the path."""
    p = t / CYCLE
    once, twice = 2 * np.pi * p, 4 * np.pi * p
    fall = twice - 4 * np.pi * MIDDLE  # 0 where the pelvis is lowest
    body = {
        "x": 0.010 * np.sin(once - 0.3),
        "y": HEIGHT - RISE / 2 * np.cos(fall),
        "z": SPEED * t + 0.008 * np.sin(fall + 0.5),
        "yaw": np.zeros_like(t),
        "lean": 9.0 + 1.2 * np.cos(fall - 0.6),
        "list": 3.0 * np.sin(once + 0.1),
        "pelvis_yaw": -6.5 * np.cos(once + 0.1),
        "low_pitch": 1.0 + 1.4 * np.cos(fall - 0.7),
        "low_yaw": 6.0 * np.cos(once - 0.1),
        "low_roll": -2.0 * np.sin(once + 0.1),
        "up_pitch": 2.0 + 1.0 * np.cos(fall - 1.0),
        "up_yaw": 9.5 * np.cos(once - 0.25),
        "up_roll": -2.0 * np.sin(once),
        "head_pitch": 2.0 + 1.6 * np.cos(fall - 1.2),
        "head_yaw": 1.0 * np.cos(once - 0.5),
        "head_roll": 0.8 * np.sin(once - 0.3),
    }
    body.update(_arm("Left", p, 1.0))
    body.update(_arm("Right", p - 0.5 - 0.012, 0.95))
    return body


def _arm(side: str, p: Array, size: float) -> dict[str, Array]:
    """An arm swings against its leg; the elbow opens behind and closes in front, the hand comes towards the
    middle.
    """
    ahead = -np.cos(2 * np.pi * p - 0.25) + 0.12 * np.cos(4 * np.pi * p)  # -1 behind, +1 in front
    follows = -np.cos(2 * np.pi * p - 0.65)
    handles = {
        "raise": 2.0 + 1.5 * np.cos(4 * np.pi * (p - MIDDLE)),
        "reach": 1.0 + 5.0 * ahead,
        "swing": -7.0 + 31.0 * size * ahead,
        "abduct": 12.0 - 3.0 * ahead,
        "twist": 24.0 + 12.0 * ahead,
        "elbow": 84.0 + 13.0 * size * follows,
        "forearm": 20.0 + 6.0 * ahead,
        "wrist": 2.0 + 5.0 * follows,
        "wrist_side": -2.0 + 0.0 * p,
    }
    return {f"{side}.{name}": value for name, value in handles.items()}


def run_plant(sign: float, step: int) -> Plant:
    """The step-th place of a foot: the left one's 0th begins at t = 0, the right one's half a cycle later."""
    later = step + (0.0 if sign > 0 else 0.5)
    return Plant(later * CYCLE, (later + OFF) * CYCLE, sign * FOOT_X, AHEAD + later * STRIDE, sign * TOES_OUT)


def pitch_of(sign: float) -> Curve:
    """Foot pitch (radians) over time."""
    later = 0.0 if sign > 0 else 0.5
    return lambda t: np.radians(PITCH(t / CYCLE - later))


def run_feet() -> Feet:
    """Feet for times from one cycle before to two cycles after t = 0."""

    def make(_: str, sign: float) -> TrackOf:
        plants = [run_plant(sign, step) for step in range(-2, 4)]

        def track(t: Array) -> Track:
            return walk_track(t, plants, [SWING] * 5, pitch_of(sign))

        return track

    return sides(make)


RUN = Motion("run", CYCLE, run_body, run_feet(), loop=True, rate=75)

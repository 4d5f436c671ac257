"""One leap, written as a whole and cut into jump, fly, land and crouch, so that positions and speeds meet at
the cuts.

It begins with the walk's left heel strike: the right foot comes beside the left, the body sinks with the arms
behind it, pushes off, flies as a stone flies, touches down with the toes and sinks into the crouch.
"""

import numpy as np
from curves import Array, Keys, eased, ramp, through
from moves.crouch import LOW, POSE
from moves.leap import (
    ABSORB,
    END,
    FAR,
    FLIGHT,
    FORWARD,
    GRAVITY,
    HIGH,
    HOLD,
    STOP_FAR,
    TAKE_OFF,
    TOUCH,
    TOUCH_FAR,
    TOUCH_HEIGHT,
    UP,
)
from moves.leapfeet import leap_feet
from moves.motion import Body, Motion, added, body_of, mixed, replaced, slope, value
from moves.walk import walk_body

DOWN: Keys = [(0.12, 0.893), (0.26, 0.800), (0.395, 0.752), (0.47, 0.796), (TAKE_OFF, HIGH)]
RUN: Keys = [(0.18, 0.218), (0.36, 0.412), (TAKE_OFF, FAR)]
SINKING: Keys = [
    (TOUCH, TOUCH_HEIGHT),
    (TOUCH + 0.05, TOUCH_HEIGHT - 0.1),
    (TOUCH + ABSORB, 0.730),
    (TOUCH + 0.24, LOW - 0.022),
    (END, LOW),
]
BRAKING: Keys = [
    (0.0, 0.0),
    (0.09, 0.098),
    (0.16, STOP_FAR - TOUCH_FAR - 0.004),
    (0.28, STOP_FAR - TOUCH_FAR),
]  # after touch-down

# degrees over the whole leap; every curve ends in the crouch
ANGLES: dict[str, Keys] = {
    "lean": [(0, 3), (0.34, 32), (0.46, 20), (0.55, 5), (0.68, 4), (0.86, 16), (1.02, 15), (1.20, 33)],
    "list": [(0, 0), (0.3, 0.5), (0.7, -1.0), (1.1, 0.0)],
    "low_pitch": [(0, 0), (0.33, 10), (0.55, -4), (0.66, -5), (0.90, 6), (1.06, 4), (1.26, 11)],
    "up_pitch": [(0, 0), (0.32, 12), (0.54, -4), (0.68, -7), (0.92, 7), (1.08, 3), (1.28, 12)],
    "head_pitch": [(0, 2), (0.28, 12), (0.50, -6), (0.66, -6), (0.90, 10), (1.06, 12), (1.28, 9)],
    "Left.swing": [
        (0, -20),
        (0.1, -26),
        (0.29, -44),
        (0.36, -34),
        (0.46, 20),
        (0.55, 74),
        (0.68, 116),
        (0.86, 78),
        (1.06, 36),
        (1.24, 22),
    ],
    "Right.swing": [
        (0, 15),
        (0.1, -8),
        (0.31, -40),
        (0.38, -29),
        (0.48, 20),
        (0.57, 68),
        (0.70, 106),
        (0.88, 70),
        (1.08, 30),
        (1.26, 14),
    ],
    "Left.abduct": [(0, 7), (0.30, 14), (0.55, 14), (0.75, 30), (0.95, 40), (1.10, 30), (1.26, 19)],
    "Right.abduct": [(0, 7), (0.32, 15), (0.57, 16), (0.77, 34), (0.97, 46), (1.12, 34), (1.28, 22)],
    "Left.elbow": [
        (0, 14),
        (0.20, 30),
        (0.33, 34),
        (0.47, 56),
        (0.60, 30),
        (0.74, 22),
        (0.95, 28),
        (1.12, 34),
        (1.26, 44),
    ],
    "Right.elbow": [
        (0, 32),
        (0.20, 30),
        (0.34, 36),
        (0.49, 60),
        (0.62, 34),
        (0.76, 24),
        (0.97, 28),
        (1.14, 30),
        (1.28, 38),
    ],
    "Left.raise": [(0, 0), (0.30, -2), (0.55, 10), (0.68, 13), (0.95, 4), (1.15, 2), (1.3, 0)],
    "Right.raise": [(0, 0), (0.30, -2), (0.56, 9), (0.70, 12), (0.96, 4), (1.17, 2), (1.3, 0)],
    "Left.wrist": [(0, 6), (0.36, 14), (0.52, -10), (0.66, 6), (0.95, -8), (1.15, 8)],
    "Right.wrist": [(0, 6), (0.37, 14), (0.53, -10), (0.67, 8), (0.96, -6), (1.16, 10)],
    "Left.knee_out": [(0, 0), (0.34, 6), (0.55, 1), (0.85, 4), (1.0, 3)],
    "Right.knee_out": [(0, 0), (0.34, 7), (0.55, 1), (0.83, 5), (1.0, 3)],
}


def _flown(t: Array) -> Array:
    return np.clip(t - TAKE_OFF, 0, FLIGHT)


def _height(t: Array) -> Array:
    down = through([(0, value(walk_body, "y", 0)), *DOWN], slope(walk_body, "y", 0), UP)
    sink = through(SINKING, UP - GRAVITY * FLIGHT)
    flying = HIGH + UP * _flown(t) - GRAVITY / 2 * _flown(t) ** 2
    return np.where(t < TAKE_OFF, down(t), np.where(t < TOUCH, flying, sink(t)))


def _way(t: Array) -> Array:
    run = through([(0, 0), *RUN], slope(walk_body, "z", 0), FORWARD)
    brake = through([(TOUCH + time, TOUCH_FAR + way) for time, way in BRAKING], FORWARD)
    return np.where(t < TAKE_OFF, run(t), np.where(t < TOUCH, FAR + FORWARD * _flown(t), brake(t)))


def leap_body() -> Body:
    """Handles from the walk's heel strike to the crouch."""
    moving = {name: through([*keys, (END, POSE.get(name, 0.0))]) for name, keys in ANGLES.items()}
    resting = {name: eased([(0.0, end), (END, end)]) for name, end in POSE.items() if name not in ANGLES}
    whole = mixed(walk_body, body_of({**resting, **moving}), lambda t: ramp(t, -0.01, 0.24))
    return replaced(whole, {"y": _height, "z": _way})


def _breathing(body: Body) -> Body:
    """The crouch breathes while it lasts, and rests at its end."""

    def breath(t: Array) -> Array:
        return ramp(t, END - 0.10, END + 0.12) - ramp(t, END + 0.12, TOUCH + HOLD)

    return added(
        body,
        {
            "y": lambda t: -0.005 * breath(t),
            "up_pitch": lambda t: 1.2 * breath(t),
            "Left.elbow": lambda t: 2.0 * breath(t),
        },
    )


_BODY, _FEET = _breathing(leap_body()), leap_feet(_height, _way)
JUMP = Motion("jump", TAKE_OFF, _BODY, _FEET)
FLY = Motion("fly", FLIGHT, _BODY, _FEET, start=TAKE_OFF)
LAND = Motion("land", ABSORB, _BODY, _FEET, start=TOUCH)
CROUCH = Motion("crouch", HOLD - ABSORB, _BODY, _FEET, start=TOUCH + ABSORB)

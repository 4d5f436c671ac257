"""One leap, written as a whole and cut into jump, fly, land, absorb and rise, so that positions and speeds
meet at the cuts.

It begins near a heel strike of the walk: the other foot comes beside that one, the body sinks with the arms
behind it, pushes off, flies as a stone flies, touches down with the toes, sinks and stands up at once.
"""

import numpy as np
from curves import Array, Curve, Keys, constant, ramp, through
from moves.leap import (
    ABSORBED,
    END,
    FAR,
    FLIGHT,
    FORWARD,
    GRAVITY,
    HIGH,
    LANDED,
    STOOD,
    TAKE_OFF,
    TOUCH,
    TOUCH_FAR,
    TOUCH_HEIGHT,
    UP,
)
from moves.leapfeet import FIRST, Approach, leap_feet
from moves.motion import Body, Feet, Motion, body_of, later, mixed, replaced, slope, value
from moves.stand import stand_body
from moves.walk import CYCLE, walk_body

DOWN: Keys = [(0.12, 0.893), (0.26, 0.800), (0.395, 0.752), (0.47, 0.796), (TAKE_OFF, HIGH)]
RUN: Keys = [(0.18, 0.218), (0.36, 0.412), (TAKE_OFF, FAR)]
SINKING: Keys = [
    (TOUCH, TOUCH_HEIGHT),
    (TOUCH + 0.05, TOUCH_HEIGHT - 0.1),
    (TOUCH + LANDED, 0.735),
    (TOUCH + 0.165, 0.706),
    (TOUCH + 0.27, 0.785),
    (TOUCH + 0.38, 0.922),
    (TOUCH + 0.44, value(stand_body, "y", 0) + 0.003),
    (END, value(stand_body, "y", 0)),
]
BRAKING: Keys = [
    (0.0, 0.0),
    (0.09, 0.098),
    (0.16, 0.128),
    (0.28, 0.160),
    (0.40, 0.204),
    (STOOD, 0.200),
]  # after touch-down

# degrees over the whole leap; every curve ends as one stands
ANGLES: dict[str, Keys] = {
    "lean": [
        (0, 3),
        (0.34, 32),
        (0.46, 20),
        (0.55, 5),
        (0.68, 4),
        (0.86, 16),
        (1.02, 15),
        (1.22, 27),
        (1.36, 16),
        (1.50, 0.0),
    ],
    "list": [(0, 0), (0.3, 0.5), (0.7, -1.0), (1.1, 0.0)],
    "low_pitch": [(0, 0), (0.33, 10), (0.55, -4), (0.66, -5), (0.90, 6), (1.06, 4), (1.24, 10), (1.38, 4)],
    "up_pitch": [(0, 0), (0.32, 12), (0.54, -4), (0.68, -7), (0.92, 7), (1.08, 3), (1.26, 11), (1.40, 6)],
    "head_pitch": [(0, 2), (0.28, 12), (0.50, -6), (0.66, -6), (0.90, 10), (1.06, 12), (1.28, 3), (1.42, -1)],
    "Left.swing": [
        (0, -18),
        (0.1, -22),
        (0.24, -29),
        (0.36, -20),
        (0.50, 12),
        (0.62, 44),
        (0.76, 68),
        (0.92, 62),
        (1.06, 42),
        (1.24, 16),
        (1.40, 4),
    ],
    "Right.swing": [
        (0, 13),
        (0.13, -4),
        (0.28, -24),
        (0.38, -17),
        (0.52, 12),
        (0.64, 41),
        (0.78, 62),
        (0.94, 55),
        (1.08, 36),
        (1.26, 12),
        (1.42, 3),
    ],
    "Left.abduct": [
        (0, 7),
        (0.30, 12),
        (0.55, 14),
        (0.75, 24),
        (0.95, 34),
        (1.10, 30),
        (1.26, 18),
        (1.42, 9),
    ],
    "Right.abduct": [
        (0, 7),
        (0.32, 13),
        (0.57, 16),
        (0.77, 28),
        (0.97, 39),
        (1.12, 33),
        (1.28, 20),
        (1.44, 9),
    ],
    "Left.elbow": [
        (0, 14),
        (0.18, 32),
        (0.33, 52),
        (0.46, 71),
        (0.60, 60),
        (0.76, 42),
        (0.95, 32),
        (1.12, 34),
        (1.26, 36),
        (1.42, 22),
    ],
    "Right.elbow": [
        (0, 34),
        (0.18, 38),
        (0.34, 55),
        (0.48, 73),
        (0.62, 62),
        (0.78, 44),
        (0.97, 32),
        (1.14, 33),
        (1.28, 33),
        (1.44, 20),
    ],
    "Left.raise": [(0, 0), (0.30, -2), (0.55, 10), (0.68, 13), (0.95, 4), (1.15, 2), (1.3, 0)],
    "Right.raise": [(0, 0), (0.30, -2), (0.56, 9), (0.70, 12), (0.96, 4), (1.17, 2), (1.3, 0)],
    "Left.wrist": [(0, 6), (0.36, 10), (0.52, -6), (0.66, 4), (0.95, -4), (1.15, 6)],
    "Right.wrist": [(0, 6), (0.37, 10), (0.53, -6), (0.67, 5), (0.96, -3), (1.16, 7)],
    "Left.knee_out": [(0, 0), (0.34, 6), (0.55, 1), (0.85, 4), (1.0, 3), (1.2, 6)],
    "Right.knee_out": [(0, 0), (0.34, 7), (0.55, 1), (0.83, 5), (1.0, 3), (1.2, 7)],
}


def _flown(t: Array) -> Array:
    return np.clip(t - TAKE_OFF, 0, FLIGHT)


def _walking(approach: Approach) -> Body:
    return later(walk_body, -approach.walked, -approach.way)


def _height_of(approach: Approach) -> Curve:
    walking = _walking(approach)
    down = through([(0, value(walking, "y", 0)), *DOWN], slope(walking, "y", 0), UP)
    sink = through(SINKING, UP - GRAVITY * FLIGHT)

    def height(t: Array) -> Array:
        flying = HIGH + UP * _flown(t) - GRAVITY / 2 * _flown(t) ** 2
        return np.where(t < TAKE_OFF, down(t), np.where(t < TOUCH, flying, sink(t)))

    return height


def _way_of(approach: Approach) -> Curve:
    walking = _walking(approach)
    start = value(walking, "z", 0)
    run = through([(0, 0), *RUN], slope(walking, "z", 0), FORWARD)
    brake = through([(TOUCH + time, TOUCH_FAR + way) for time, way in BRAKING], FORWARD)

    def way(t: Array) -> Array:
        running = run(t) + start * (1 - ramp(t, 0.0, 0.52))
        return np.where(t < TAKE_OFF, running, np.where(t < TOUCH, FAR + FORWARD * _flown(t), brake(t)))

    return way


def leap(approach: Approach) -> tuple[Body, Feet]:
    """Handles and feet from the walk until he stands."""
    stands = {name: float(curve[0]) for name, curve in stand_body(np.zeros(1)).items()}
    moving = {name: through([*keys, (END, stands.get(name, 0.0))]) for name, keys in ANGLES.items()}
    resting = {name: constant(end) for name, end in stands.items() if name not in ANGLES}
    whole = mixed(_walking(approach), body_of({**resting, **moving}), lambda t: ramp(t, -0.01, 0.24))
    height, way = _height_of(approach), _way_of(approach)
    return replaced(whole, {"y": height, "z": way}), leap_feet(height, way, approach)


SINCE = (-0.12, -0.05, 0.03, 0.065)
"""after the heel strike of the foot that stands, parts of a cycle"""
JUMPS = [
    Motion(f"jump-{side}-{number}", TAKE_OFF, *leap(Approach(sign, part * CYCLE)))
    for side, sign in (("left", 1.0), ("right", -1.0))
    for number, part in enumerate(SINCE, 1)
]
_BODY, _FEET = leap(FIRST)
FLY = Motion("fly", FLIGHT, _BODY, _FEET, start=TAKE_OFF)
LAND = Motion("land", LANDED, _BODY, _FEET, start=TOUCH)
ABSORB = Motion("absorb", ABSORBED - LANDED, _BODY, _FEET, start=TOUCH + LANDED)
GET_UP = Motion("rise", STOOD - ABSORBED, _BODY, _FEET, start=TOUCH + ABSORBED)

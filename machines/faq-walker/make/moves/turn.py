"""Turning on the spot by 60 degrees: the head leads, then the chest, then the pelvis, then the foot on the
inside steps.
"""

import numpy as np
from curves import Curve, eased, ramp, through
from moves.feet import Arc, Plant, walk_track
from moves.motion import Body, Feet, Motion, TrackOf, added, held, sides, value
from moves.stand import FOOT_X, FOOT_Z, TOES_OUT, stand_body, stand_plant

SPAN = 1.0
ANGLE = 60.0
INSIDE, OUTSIDE = (0.20, 0.47), (0.51, 0.80)  # the seconds in which each foot is in the air


def _turned(plant: Plant, angle: float) -> Plant:
    """The same place after the figure has turned about the vertical axis."""
    c, s = np.cos(angle), np.sin(angle)
    return plant._replace(x=plant.x * c + plant.z * s, z=plant.z * c - plant.x * s, yaw=plant.yaw + angle)


def turn_feet(way: float) -> Feet:
    """First the inside foot, then the other; `way` is +1 for a turn to the left."""

    def make(_: str, sign: float) -> TrackOf:
        up, down = INSIDE if sign == way else OUTSIDE
        first = stand_plant(sign, end=up)
        second = _turned(stand_plant(sign), way * np.radians(ANGLE))._replace(start=down)
        degrees = eased(
            [
                (up - 0.12, 0.0),
                (up, -15.0),
                (up + 0.07, -17.0),
                (down - 0.08, 2.0),
                (down, 3.0),
                (down + 0.06, 0.0),
            ]
        )
        arcs = [Arc(0.30, 0.22, 0.172), Arc(0.62, 0.70, 0.160)]
        return lambda t: walk_track(t, [first, second], [arcs], lambda moment: np.radians(degrees(moment)))

    return sides(make)


def _twist(way: float) -> dict[str, Curve]:
    def part(start: float, end: float, pelvis_share: float) -> Curve:
        return lambda t: way * ANGLE * pelvis_share * (ramp(t, start, end) - ramp(t, 0.10, 0.86))

    return {
        "yaw": lambda t: way * ANGLE * ramp(t, 0.10, 0.86),
        "low_yaw": part(0.05, 0.78, 0.35),
        "up_yaw": part(0.04, 0.72, 0.65),
        "head_yaw": part(-0.04, 0.60, 1.0),
    }


def _arms(way: float) -> dict[str, Curve]:
    inside, outside = ("Left", "Right") if way > 0 else ("Right", "Left")
    return {
        f"{inside}.swing": eased([(0.04, 0.0), (0.30, -15.0), (0.62, 7.0), (0.82, 3.0), (0.99, 0.0)]),
        f"{outside}.swing": eased([(0.02, 0.0), (0.34, 19.0), (0.68, -8.0), (0.86, -2.0), (1.0, 0.0)]),
        f"{inside}.abduct": eased([(0.05, 0.0), (0.40, 5.0), (0.80, 1.5), (1.0, 0.0)]),
        f"{outside}.abduct": eased([(0.08, 0.0), (0.48, 6.0), (0.84, 1.0), (1.0, 0.0)]),
        f"{inside}.elbow": eased([(0.08, 0.0), (0.40, 13.0), (0.76, -3.0), (1.0, 0.0)]),
        f"{outside}.elbow": eased([(0.10, 0.0), (0.44, 20.0), (0.80, -3.0), (1.0, 0.0)]),
    }


def turn_body(way: float) -> Body:
    """Weight goes to the outside foot, over to the inside foot, and back between both."""
    angle = way * np.radians(ANGLE)
    start, c, s = value(stand_body, "x", 0), np.cos(angle), np.sin(angle)
    inner = _turned(Plant(0, 0, way * FOOT_X, FOOT_Z, way * TOES_OUT), angle)
    moves = {
        "x": through(
            [
                (0, 0),
                (0.22, -way * 0.058 - start),
                (0.36, -way * 0.050 - start),
                (0.62, inner.x * 0.62 - start),
                (SPAN, start * c - start),
            ]
        ),
        "z": through([(0, 0), (0.22, 0.004), (0.36, 0.0), (0.62, inner.z * 0.55), (SPAN, -start * s)]),
        "y": eased(
            [
                (0.0, 0.0),
                (0.18, -0.006),
                (0.34, -0.014),
                (0.50, -0.020),
                (0.66, -0.010),
                (0.86, 0.001),
                (0.98, 0.0),
            ]
        ),
        "list": eased([(0.0, 0.0), (0.30, -way * 4.0), (0.64, way * 2.5), (0.95, 0.0)]),
        "low_roll": eased([(0.02, 0.0), (0.32, way * 3.0), (0.66, -way * 2.0), (0.98, 0.0)]),
        "lean": eased([(0.0, 0.0), (0.28, 1.6), (0.66, 1.0), (0.92, -0.3), (1.0, 0.0)]),
        "head_pitch": eased([(0.0, 0.0), (0.22, 3.0), (0.60, 0.5), (0.95, 0.0)]),
        "head_roll": eased([(0.0, 0.0), (0.28, way * 3.0), (0.75, -way * 0.6), (1.0, 0.0)]),
    }
    return added(held(stand_body, 0.0), {**moves, **_twist(way), **_arms(way)})


def _turn(name: str, way: float) -> Motion:
    return Motion(name, SPAN, turn_body(way), turn_feet(way), blinks=(0.3,))


TURN_LEFT, TURN_RIGHT = _turn("turn-left", 1.0), _turn("turn-right", -1.0)

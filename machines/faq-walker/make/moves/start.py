"""From standing to walking: weight shifts, then the first step is 70 % of a full one."""

import numpy as np
from curves import Array, Curve, eased, ramp, through
from moves.feet import Arc, Plant, walk_track
from moves.motion import Body, Feet, Motion, TrackOf, added, held, later, mixed, replaced, sides, slope, value
from moves.stand import FOOT_Z, stand_body, stand_plant
from moves.walk import AHEAD, CYCLE, STRIDE, arcs_of, pitch_of, walk_body, walk_plant

STAND_POSE: Body = held(stand_body, 0.0)

# start-walk: weight to the left foot, the right foot steps, then the left one; it ends as the left heel
# touches
START = 1.10
FIRST_STEP = 0.70 * STRIDE / 2
WAY = FOOT_Z + FIRST_STEP + STRIDE / 2 - AHEAD  # metres walked by then
LIFT = 0.22


def _moved(plant: Plant, time: float, z: float, x: float = 0.0) -> Plant:
    return plant._replace(start=plant.start + time, end=plant.end + time, z=plant.z + z, x=plant.x + x)


def _mixed_pitch(first: Curve, second: Curve, start: float, end: float) -> Curve:
    def pitch(t: Array) -> Array:
        weight = ramp(t, start, end)
        return np.radians(first(t)) * (1 - weight) + second(t) * weight

    return pitch


def start_feet() -> Feet:
    """Right foot 70 % of a step, left foot into the walk's first plant."""

    def make(side: str, sign: float) -> TrackOf:
        walk_pitch = pitch_of(sign)
        ahead = walk_plant(sign, 0 if side == "Left" else -1)
        landing = _moved(ahead, START, WAY)
        if side == "Left":
            lift, keys = START - 0.375 * CYCLE, [(0.40, 0.0), (0.55, -10.0), (0.71, -46.0), (0.80, -46.0)]
            arcs, meet = arcs_of(sign), (0.60, 0.74)
        else:
            lift, keys = LIFT, [(0.06, 0.0), (LIFT, -26.0), (0.30, -30.0), (0.44, 2.0), (0.60, 12.0)]
            arcs, meet = (
                [Arc(0.13, 0.04, 0.176), Arc(0.36, 0.30, 0.186, -0.01), Arc(0.68, 0.73, 0.152)],
                (0.42, START - 0.52),
            )
        pitch = _mixed_pitch(eased(keys), lambda t: walk_pitch(t - START), *meet)
        plants = [stand_plant(sign, end=lift), landing]
        return lambda t: walk_track(t, plants, [arcs], pitch)

    return sides(make)


def start_body() -> Body:
    """Lean and shift first, then everything flows into the walk."""
    walking = later(walk_body, START, WAY)
    lean = {
        "lean": eased([(0.0, 0.0), (0.24, 3.6), (0.55, 2.0), (0.95, 0.0)]),
        "up_pitch": eased([(0.04, 0.0), (0.28, 2.0), (0.80, 0.0)]),
        "list": eased([(0.0, 0.0), (0.30, 2.0), (0.60, 0.0)]),
        "head_pitch": eased([(0.05, 0.0), (0.25, -1.5), (0.70, 0.0)]),
        "Left.elbow": eased([(0.05, 0.0), (0.35, 6.0), (0.80, 0.0)]),
        "Right.elbow": eased([(0.10, 0.0), (0.40, 5.0), (0.85, 0.0)]),
    }
    whole = mixed(added(STAND_POSE, lean), walking, lambda t: ramp(t, 0.12, 0.82))
    shift = replaced(
        whole,
        {
            "x": through(
                [
                    (0, value(stand_body, "x", 0)),
                    (0.26, 0.046),
                    (0.40, 0.038),
                    (0.62, -0.006),
                    (0.80, -0.018),
                    (1.2, -0.004),
                ]
            ),
            "y": through(
                [
                    (0, value(stand_body, "y", 0)),
                    (0.14, 0.947),
                    (0.32, 0.943),
                    (0.56, 0.914),
                    (0.72, 0.930),
                    (0.84, 0.948),
                    (1.2, 0.93),
                ]
            ),
            "z": through(
                [
                    (0, 0),
                    (0.10, 0.006),
                    (0.22, 0.037),
                    (0.38, 0.105),
                    (0.57, 0.222),
                    (0.71, 0.350),
                    (0.86, 0.530),
                    (START, WAY),
                ],
                end_slope=slope(walk_body, "z", 0),
            ),
        },
    )
    return mixed(shift, walking, lambda t: ramp(t, 0.62, 1.0))


START_WALK = Motion("start-walk", START, start_body(), start_feet(), blinks=(0.6,))

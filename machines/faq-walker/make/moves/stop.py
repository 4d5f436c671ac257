"""Coming to a stop from any phase of the walk: the foot that swings takes a last, shorter step, the other one
comes beside it, and the body catches up and settles.

One motion for each of a few phases; what lies between them is blended. `ahead` is the part of a cycle until
the heel of the last foot touches; the shorter it is, the less is left of the step that can be shortened.
"""

import numpy as np
from curves import Array, Curve, eased, ramp, through
from moves.feet import Arc, Plant, Track, rolled, walk_track
from moves.motion import Body, Feet, Motion, TrackOf, added, held, mixed, replaced, sides, slope, value
from moves.stand import FOOT_X, TOES_OUT, stand_body, stand_plant
from moves.stopping import STOP, Stop, stop_of_start, stop_of_walk

CATCH = {
    "lean": [(0.10, 0.0), (0.38, -2.5), (0.62, 1.2), (0.92, 0.0)],
    "low_pitch": [(0.15, 0.0), (0.50, 2.5), (0.72, -0.8), (0.96, 0.0)],
    "up_pitch": [(0.18, 0.0), (0.54, 3.0), (0.76, -1.0), (0.98, 0.0)],
    "head_pitch": [(0.20, 0.0), (0.56, 2.5), (0.80, -0.6), (0.99, 0.0)],
    "near.swing": [(0.25, 0.0), (0.50, 7.0), (0.74, -2.0), (0.98, 0.0)],
    "far.swing": [(0.28, 0.0), (0.55, 5.0), (0.80, -1.5), (1.0, 0.0)],
    "near.elbow": [(0.25, 0.0), (0.55, 6.0), (0.80, -1.0), (1.0, 0.0)],
    "far.elbow": [(0.25, 0.0), (0.52, 4.0), (0.78, -1.0), (1.0, 0.0)],
}  # seconds after the heel strike, degrees

PITCH = (
    [(0.0, -30.0), (0.20, -44.0), (0.32, -22.0), (0.44, 5.0), (0.50, 6.0), (0.58, 0.0)],
    [(0.0, 0.0), (0.131, -18.0), (0.22, -21.0), (0.40, 3.0), (0.50, 4.0), (0.58, 0.0)],
)  # of the foot that closes, toes up: after a step, after a short one


def stop_feet(stop: Stop) -> Feet:
    """The last foot's step is shortened, and it rolls flat and stays; the other one comes beside it."""

    def make(side: str, sign: float) -> TrackOf:
        return _last_foot(stop, side) if sign == stop.sign else _closing_foot(stop, side, sign)

    return sides(make)


def _last_foot(stop: Stop, side: str) -> TrackOf:
    def track(t: Array) -> Track:
        step = stop.feet(stop.going(t))[side]
        pitch = stop.feet(np.minimum(stop.going(t), stop.strike + 0.3))[side].pitch
        back = stop.short * ramp(t, stop.off, max(stop.touch, 1e-3))
        ankle = step.ankle - np.stack([0 * t, 0 * t, back], -1)
        down = t >= stop.touch
        ankle[down] = rolled(stop.place, pitch[down])
        return Track(ankle, step.yaw[:1] + 0 * t, pitch)

    return track


def _closing_foot(stop: Stop, side: str, sign: float) -> TrackOf:
    span, is_short = (stop.closed - stop.lift) / 0.369, stop.place.z - stop.stands.z < 0.4
    own = eased([(stop.lift + (time - 0.131) * span, degrees) for time, degrees in PITCH[is_short]])

    def pitch(t: Array) -> Array:
        weight = ramp(t, stop.lift + 0.17 * span, stop.lift - 0.011) * (not is_short)
        return np.radians(own(t)) * (1 - weight) + stop.feet(stop.going(t))[side].pitch * weight

    stands = stop.stands._replace(start=-9.0, end=stop.lift)
    beside = Plant(stop.closed, 9.0, stop.middle + sign * FOOT_X, stop.place.z, sign * TOES_OUT)
    arcs = [Arc(0.11, 0.05, 0.226), Arc(0.27, 0.23, 0.226), Arc(0.52, 0.58, 0.186), Arc(0.78, 0.90, 0.137)]
    if is_short:
        arcs = [Arc(0.15, 0.08, 0.170), Arc(0.42, 0.42, 0.176), Arc(0.72, 0.82, 0.142)]
    return lambda t: walk_track(t, [stands, beside], [arcs], pitch)


def stop_body(stop: Stop) -> Body:
    """The body holds back at once, catches up with the feet, goes a little too far and settles."""
    rest = held(stand_body, 0.0)

    def walking(t: Array) -> dict[str, Array]:
        return stop.body(stop.going(t))

    near, far = ("Left", "Right") if stop.sign > 0 else ("Right", "Left")
    catch = {
        name.replace("near", near).replace("far", far): eased(
            [(stop.shifted(time), degrees) for time, degrees in keys]
        )
        for name, keys in CATCH.items()
    }
    settled = mixed(walking, added(rest, catch), lambda t: ramp(t, 0.0, stop.shifted(0.62)))
    return replaced(added(settled, _held_back(stop)), _path(stop, walking))


def _held_back(stop: Stop) -> dict[str, Curve]:
    """The first that is seen: the trunk leans back against the step."""
    if stop.touch < 0.1:
        return {}
    late = stop.touch + 0.15
    return {
        "lean": eased([(0.0, 0.0), (0.6 * late, -2.5), (late + 0.2, 0.0)]),
        "up_pitch": eased([(0.0, 0.0), (0.55 * late, -2.0), (late + 0.2, 0.0)]),
        "head_pitch": eased([(0.0, 0.0), (0.5 * late, 2.5), (late + 0.2, 0.0)]),
    }


def _path(stop: Stop, walking: Body) -> dict[str, Curve]:
    end_x, end_y = stop.middle + value(stand_body, "x", 0), value(stand_body, "y", 0)
    later = stop.shifted
    over = mixed(
        walking,
        lambda t: {"x": np.full_like(t, end_x), "y": np.full_like(t, end_y)},
        lambda t: ramp(t, max(0.0, later(0.05)), later(0.66)),
    )
    keys = [(0.0, value(walking, "z", 0)), (0.95 * stop.closed, stop.end + 0.010), (STOP, stop.end)]
    z = through(keys, slope(walking, "z", 0))
    return {"z": z, "x": lambda t: over(t)["x"], "y": lambda t: over(t)["y"]}


def stopped(name: str, sign: float, ahead: float) -> Motion:
    """A stop that begins this part of a cycle before the last foot's heel touches."""
    return _motion(name, stop_of_walk(sign, ahead))


def _motion(name: str, stop: Stop) -> Motion:
    return Motion(name, STOP, stop_body(stop), stop_feet(stop), blinks=(0.7,))


def rest_feet() -> Feet:
    """Both feet stay."""
    return sides(lambda _, sign: lambda t: walk_track(t, [stand_plant(sign)], [], np.zeros_like))


def rest_body() -> Body:
    """The body of a start that is taken back before the first step: the lean goes back, a little too far."""
    return added(
        held(stand_body, 0.0),
        {
            "lean": eased([(0.0, 0.0), (0.30, -0.9), (0.62, 0.3), (0.95, 0.0)]),
            "up_pitch": eased([(0.05, 0.0), (0.36, 1.2), (0.70, -0.3), (0.98, 0.0)]),
            "y": eased([(0.0, 0.0), (0.26, -0.006), (0.56, 0.0)]),
            "Left.elbow": eased([(0.05, 0.0), (0.38, 3.0), (0.9, 0.0)]),
            "Right.elbow": eased([(0.09, 0.0), (0.44, 2.5), (0.95, 0.0)]),
        },
    )


AHEADS = {"left": (0.445, 0.375, 0.26, 0.14, 0.02, -0.025), "right": (0.445, 0.375, 0.26, 0.14, 0.03, -0.05)}
"""before the heel strike, parts of a cycle"""
STOPS = [
    stopped(f"come-to-stop-{side}-{number}", 1.0 if side == "left" else -1.0, ahead)
    for side, parts in AHEADS.items()
    for number, ahead in enumerate(parts, 1)
]
SHORT_STOPS = [
    _motion("come-to-stop-short-1", stop_of_start(0.30, 0.17)),
    _motion("come-to-stop-short-2", stop_of_start(0.42, 0.32)),
]
NOT_GONE = Motion("come-to-rest", STOP, rest_body(), rest_feet())

"""The feet of the leap: planted side by side, pushed off over the toes, tucked up, down on the toes."""

from typing import NamedTuple

import numpy as np
from curves import Array, Curve, Keys, eased, ramp
from moves.feet import STEP, Plant, Track, rolled
from moves.leap import END, LANDING_Z, TAKE_OFF, TOUCH
from moves.motion import Feet, TrackOf, sides
from moves.stand import FOOT_X, TOES_OUT
from moves.walk import AHEAD, CYCLE, STRIDE, pitch_of, walk_feet, walk_plant
from scipy.interpolate import CubicSpline

# a foot in the air: seconds after take-off, ankle ahead of the pelvis and above it
TUCK = [(0.06, -0.26, -0.795), (0.16, -0.20, -0.70), (0.28, 0.0, -0.63), (0.41, 0.10, -0.78)]
CLOSE = [
    (0.152, -0.20, 0.222),
    (0.20, 0.03, 0.214),
    (0.26, 0.225, 0.182),
]  # the right foot on its way beside the left: seconds, z, height
LAG = 0.012  # seconds by which the right foot comes later

# degrees, toes up +
STANDS: Keys = [(0.0, 0.0), (0.25, 0.0)]
STEPS: Keys = [(0.0, -30.0), (0.17, -48.0), (0.28, -6.0), (0.33, 3.0), (0.37, 0.0)]


class Approach(NamedTuple):
    """How the walk goes over into the leap: `sign` +1 if the left foot stands, `since` seconds after its heel
    has touched.
    """

    sign: float
    since: float

    @property
    def walked(self) -> float:
        """The walk's time when the leap begins."""
        return self.since + (0.0 if self.sign > 0 else CYCLE / 2)

    @property
    def way(self) -> float:
        """The walk's z from which the leap counts."""
        return 0.0 if self.sign > 0 else STRIDE / 2

    @property
    def lift(self) -> float:
        """Seconds until the other foot leaves the ground."""
        return 0.131 - self.since

    @property
    def closed(self) -> float:
        """Seconds until it stands beside the first."""
        return 0.33 - 0.85 * self.since

    def moment(self, seconds: float) -> float:
        """When the other foot does what it does so many seconds after the heel strike, in a leap that begins
        there.
        """
        if seconds <= 0.131:
            return max(seconds - self.since, 0.001 * seconds)
        return self.lift + (seconds - 0.131) * (self.closed - self.lift) / 0.199


FIRST = Approach(1.0, 0.0)


def _pitch(approach: Approach, sign: float, late: float) -> Curve:
    push: Keys = [(0.40, 0), (0.46, -6), (TAKE_OFF, -40), (0.60 + late, -62)]
    land: Keys = [
        (0.78 + late, -38),
        (0.95, -24),
        (TOUCH - 0.05, -40),
        (TOUCH + 0.08, -22),
        (TOUCH + 0.165, 0),
        (END, 0),
    ]
    stands = sign == approach.sign
    step = STANDS if stands else [(approach.moment(time), degrees) for time, degrees in STEPS]
    keyed = eased([*step, *(key for key in push if key[0] > step[-1][0] + 0.01), *land])
    walking, since = pitch_of(sign), approach.since
    start, end = (0.30 - since, 0.12 - since) if stands else (approach.lift, max(approach.lift - 0.11, 0.0))

    def pitch(t: Array) -> Array:
        weight = ramp(t, max(start, end + 0.06), end)  # 1 before `end`: still the walk
        going = walking(np.minimum(t + since, 0.3) + approach.walked - since)
        return np.radians(keyed(t)) * (1 - weight) + going * weight

    return pitch


def _between(
    t: Array, off: Plant, on: Plant, pitch: Curve, points: list[tuple[float, float, float]]
) -> Array:
    """Ankle (F, 3) from one plant to the next through (time, z, height), leaving and arriving with the speeds
    of the rolling foot.
    """
    ends = np.array([off.end - STEP, off.end, on.start, on.start + STEP])
    leave, touch = rolled(off, pitch(ends)[:2]), rolled(on, pitch(ends)[2:])
    speeds = [(leave[1] - leave[0]) / STEP, (touch[1] - touch[0]) / STEP]
    times = [off.end, *(time for time, _, _ in points), on.start]
    share = [(time - off.end) / (on.start - off.end) for time, _, _ in points]
    across = [leave[1][0] + f * (touch[0][0] - leave[1][0]) for f in share]
    middle = [(x, height, z) for x, (_, z, height) in zip(across, points, strict=True)]
    spline = CubicSpline(times, [leave[1], *middle, touch[0]], bc_type=((1, speeds[0]), (1, speeds[1])))
    return np.asarray(spline(t))


def leap_feet(height: Curve, way: Curve, approach: Approach = FIRST) -> Feet:
    """Both feet through the leap; `height` and `way` are those of the pelvis."""
    walking = walk_feet()

    def make(side: str, sign: float) -> TrackOf:
        late = 0.0 if side == "Left" else LAG
        pitch, stands = _pitch(approach, sign, late), sign == approach.sign
        first = walk_plant(sign, 0 if stands or sign > 0 else -1)
        first = first._replace(z=first.z - approach.way, end=approach.lift)
        push = Plant(approach.closed, TAKE_OFF, first.x, AHEAD, sign * TOES_OUT)
        landing = Plant(TOUCH, 9.0, sign * FOOT_X, LANDING_Z, sign * TOES_OUT)
        when = TAKE_OFF + np.array([time for time, _, _ in TUCK]) + late
        tuck = [
            (float(t), z + ahead, y + below)
            for t, z, y, (_, ahead, below) in zip(when, way(when), height(when), TUCK, strict=True)
        ]
        close = [(approach.moment(time), z, high) for time, z, high in CLOSE]

        def track(t: Array) -> Track:
            pitched = pitch(t)
            ankle = rolled(push, pitched)
            going = walking(np.minimum(t, 0.5) + approach.walked)[side].ankle - (0.0, 0.0, approach.way)
            if stands:
                ankle[t < -approach.since] = going[t < -approach.since]
            else:
                closing = (t > first.end) & (t < push.start)
                ankle[t <= first.end] = rolled(first, pitched[t <= first.end])
                ankle[closing] = _between(t[closing], first, push, pitch, close)
            flying = (t > TAKE_OFF) & (t < TOUCH)
            ankle[flying] = _between(t[flying], push, landing, pitch, tuck)
            ankle[t >= TOUCH] = rolled(landing, pitched[t >= TOUCH])
            return Track(ankle, np.full_like(t, sign * TOES_OUT), pitched)

        return track

    return sides(make)

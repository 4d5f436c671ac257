"""One leap, written as a whole and cut into jump, fly, land and crouch, so that positions and speeds meet at the cuts.

It begins with the walk's left heel strike: the right foot comes beside the left, the body sinks with the arms behind it,
pushes off, flies as a stone flies, touches down with the toes and sinks into the crouch.
"""

import numpy as np
from curves import Array, eased, ramp, through
from crouch import BACK, LOW, POSE
from feet import STEP, Plant, Track, rolled
from motion import Body, Feet, Motion, added, mixed, replaced, sides, slope, value
from scipy.interpolate import CubicSpline
from stand import FOOT_X, FOOT_Z, TOES_OUT
from walk import AHEAD, OFF, CYCLE, pitch_of, walk_body, walk_plant

GRAVITY = 9.81
TAKE_OFF, FLIGHT, ABSORB, SINK, HOLD = 0.55, 30 / 60, 6 / 60, 0.42, 0.75  # seconds; the last three from touch-down
TOUCH, END = TAKE_OFF + FLIGHT, TAKE_OFF + FLIGHT + SINK
UP, FORWARD = 2.45, 1.45  # metres a second at take-off
HIGH, FAR = 0.940, 0.665  # pelvis at take-off
TOUCH_HEIGHT = HIGH + UP * FLIGHT - GRAVITY / 2 * FLIGHT**2
TOUCH_FAR = FAR + FORWARD * FLIGHT
STOP_FAR = TOUCH_FAR + 0.130  # pelvis at the end
LANDING_Z = STOP_FAR - BACK + FOOT_Z


def _height() -> Body:
    down = through(
        [(0, value(walk_body, "y", 0)), (0.12, 0.893), (0.26, 0.800), (0.395, 0.752), (0.47, 0.796), (TAKE_OFF, HIGH)],
        slope(walk_body, "y", 0),
        UP,
    )
    sink = through(
        [(TOUCH, TOUCH_HEIGHT), (TOUCH + 0.05, TOUCH_HEIGHT - 0.105), (TOUCH + ABSORB, 0.768), (TOUCH + 0.27, LOW - 0.018), (END, LOW)], UP - GRAVITY * FLIGHT
    )

    def height(t: Array) -> Array:
        flown = np.clip(t - TAKE_OFF, 0, FLIGHT)
        flying = HIGH + UP * flown - GRAVITY / 2 * flown**2
        return np.where(t < TAKE_OFF, down(t), np.where(t < TOUCH, flying, sink(t)))

    return lambda t: {"y": height(t)}


def _way() -> Body:
    run = through([(0, 0), (0.18, 0.218), (0.36, 0.412), (TAKE_OFF, FAR)], slope(walk_body, "z", 0), FORWARD)
    brake = through([(TOUCH, TOUCH_FAR), (TOUCH + 0.09, TOUCH_FAR + 0.098), (TOUCH + 0.16, STOP_FAR - 0.004), (TOUCH + 0.28, STOP_FAR), (END, STOP_FAR)], FORWARD)

    def way(t: Array) -> Array:
        flying = FAR + FORWARD * (t - TAKE_OFF)
        return np.where(t < TAKE_OFF, run(t), np.where(t < TOUCH, flying, brake(t)))

    return lambda t: {"z": way(t)}


# a foot in the air: seconds after take-off, ankle ahead of the pelvis and above it
TUCK = [(0.06, -0.26, -0.795), (0.16, -0.20, -0.70), (0.28, 0.0, -0.61), (0.40, 0.125, -0.720)]

# keys over the whole leap; the last is the crouch
ANGLES: dict[str, list[tuple[float, float]]] = {
    "lean": [(0, 3), (0.34, 32), (0.46, 20), (0.55, 5), (0.68, 4), (0.86, 16), (1.02, 15), (1.20, 33)],
    "list": [(0, 0), (0.3, 0.5), (0.7, -1.0), (1.1, 0.0)],
    "low_pitch": [(0, 0), (0.33, 10), (0.55, -4), (0.66, -5), (0.90, 6), (1.06, 4), (1.26, 11)],
    "up_pitch": [(0, 0), (0.32, 12), (0.54, -4), (0.68, -7), (0.92, 7), (1.08, 3), (1.28, 12)],
    "head_pitch": [(0, 2), (0.28, 12), (0.50, -6), (0.66, -6), (0.90, 10), (1.06, 12), (1.28, 9)],
    "Left.swing": [(0, -20), (0.10, -26), (0.29, -44), (0.36, -34), (0.46, 20), (0.55, 74), (0.68, 116), (0.86, 78), (1.06, 36), (1.24, 22)],
    "Right.swing": [(0, 15), (0.10, -8), (0.31, -40), (0.38, -29), (0.48, 20), (0.57, 68), (0.70, 106), (0.88, 70), (1.08, 30), (1.26, 14)],
    "Left.abduct": [(0, 7), (0.30, 14), (0.55, 14), (0.75, 30), (0.95, 40), (1.10, 30), (1.26, 19)],
    "Right.abduct": [(0, 7), (0.32, 15), (0.57, 16), (0.77, 34), (0.97, 46), (1.12, 34), (1.28, 22)],
    "Left.elbow": [(0, 14), (0.20, 30), (0.33, 34), (0.47, 56), (0.60, 30), (0.74, 22), (0.95, 28), (1.12, 34), (1.26, 44)],
    "Right.elbow": [(0, 32), (0.20, 30), (0.34, 36), (0.49, 60), (0.62, 34), (0.76, 24), (0.97, 28), (1.14, 30), (1.28, 38)],
    "Left.raise": [(0, 0), (0.30, -2), (0.55, 10), (0.68, 13), (0.95, 4), (1.15, 2), (1.3, 0)],
    "Right.raise": [(0, 0), (0.30, -2), (0.56, 9), (0.70, 12), (0.96, 4), (1.17, 2), (1.3, 0)],
    "Left.wrist": [(0, 6), (0.36, 14), (0.52, -10), (0.66, 6), (0.95, -8), (1.15, 8)],
    "Right.wrist": [(0, 6), (0.37, 14), (0.53, -10), (0.67, 8), (0.96, -6), (1.16, 10)],
    "Left.knee_out": [(0, 0), (0.34, 6), (0.55, 1), (0.85, 4), (1.0, 3)],
    "Right.knee_out": [(0, 0), (0.34, 7), (0.55, 1), (0.83, 5), (1.0, 3)],
}


def leap_body() -> Body:
    """Handles from the walk's heel strike to the crouch."""
    names = sorted({*ANGLES, *POSE} - {"y", "z"})
    curves = {}
    for name in names:
        end = POSE.get(name, 0.0)
        keys = ANGLES.get(name, [(0.0, end)])
        curves[name] = through([*keys, (END, end)]) if name in ANGLES else eased([*keys, (END, end)])
    keyed = lambda t: {name: curve(t) for name, curve in curves.items()}  # noqa: E731
    whole = mixed(walk_body, keyed, lambda t: ramp(t, -0.01, 0.24))
    height, way = _height(), _way()
    return replaced(whole, {"y": lambda t: height(t)["y"], "z": lambda t: way(t)["z"]})


class Flight:
    """One foot's way through the leap."""

    def __init__(self, side: str, sign: float) -> None:
        self.walk_pitch, self.late = pitch_of(sign), 0.0 if side == "Left" else 0.012
        self.first = walk_plant(sign, 0 if side == "Left" else -1)
        self.push = Plant(0.29, TAKE_OFF, sign * 0.088, AHEAD + 0.035, sign * TOES_OUT)
        if side == "Left":
            self.push = self.first._replace(end=TAKE_OFF)
        self.landing = Plant(TOUCH, 9.0, sign * FOOT_X, LANDING_Z, sign * TOES_OUT)
        self.off = (OFF - 0.5) * CYCLE
        late = self.late
        steps = [(0.0, 0.0), (0.25, 0.0)] if side == "Left" else [(0.0, -30.0), (0.15, -42.0), (0.25, -6.0), (0.29, 3.0), (0.33, 0.0)]
        leap = [(0.40, 0), (0.46, -6), (TAKE_OFF, -40), (0.60 + late, -62), (0.78 + late, -38), (0.95, -24), (TOUCH - 0.05, -36), (TOUCH + 0.10, 0)]
        self.keys = eased([*steps, *leap, (END, 0.0)])

    def pitch(self, t: Array) -> Array:
        """Radians, toes up positive."""
        weight = ramp(t, 0.12, 0.02) if self.push is not self.first and self.first.start < 0 else ramp(t, 0.30, 0.12)
        return np.radians(self.keys(t)) * (1 - weight) + self.walk_pitch(np.minimum(t, 0.3)) * weight

    def _between(self, t: Array, off: Plant, on: Plant, points: list[tuple[float, float, float]]) -> Array:
        """Ankle (F, 3) from one plant to the next through (time, z, height)."""
        ends = np.array([off.end - STEP, off.end, on.start, on.start + STEP])
        pitch = self.pitch(ends)
        leave, touch = rolled(off, pitch[:2]), rolled(on, pitch[2:])
        speeds = [(leave[1] - leave[0]) / STEP, (touch[1] - touch[0]) / STEP]
        times = [off.end, *(time for time, _, _ in points), on.start]
        share = [(time - off.end) / (on.start - off.end) for time, _, _ in points]
        mids = [(leave[1][0] + f * (touch[0][0] - leave[1][0]), high, z) for f, (_, z, high) in zip(share, points, strict=True)]
        spline = CubicSpline(times, [leave[1], *mids, touch[0]], bc_type=((1, speeds[0]), (1, speeds[1])))
        return np.asarray(spline(t))

    def __call__(self, t: Array) -> Track:
        pitch = self.pitch(t)
        ankle = rolled(self.push, pitch)
        if self.first.start < 0:
            before, step = t <= self.off, (t > self.off) & (t < self.push.start)
            ankle[before] = rolled(self.first, pitch[before])
            ankle[step] = self._between(t[step], self.first, self.push, [(0.21, 0.12, 0.185)])
        flying, landed = (t > TAKE_OFF) & (t < TOUCH), t >= TOUCH
        late = self.late
        way, height = _way(), _height()
        tucked = []
        for after, ahead, below in TUCK:
            time = np.array([TAKE_OFF + after + (late if after < 0.4 else 0.0)])
            tucked.append((float(time[0]), float(way(time)["z"][0]) + ahead, float(height(time)["y"][0]) + below))
        ankle[flying] = self._between(t[flying], self.push, self.landing, tucked)
        ankle[landed] = rolled(self.landing, pitch[landed])
        yaw = self.first.yaw + (self.landing.yaw - self.first.yaw) * ramp(t, TAKE_OFF, TOUCH)
        return Track(ankle, yaw, pitch)


def leap_feet() -> Feet:
    """Both feet through the leap."""
    return sides(Flight)


def _breathing(body: Body) -> Body:
    """The crouch breathes while it lasts, and rests at its end."""

    def breath(t: Array) -> Array:
        return (ramp(t, END - 0.10, END + 0.12) - ramp(t, END + 0.12, TOUCH + HOLD)) * (t > END - 0.10)

    return added(body, {"y": lambda t: -0.005 * breath(t), "up_pitch": lambda t: 1.2 * breath(t), "Left.elbow": lambda t: 2.0 * breath(t)})


_BODY, _FEET = _breathing(leap_body()), leap_feet()
JUMP = Motion("jump", TAKE_OFF, _BODY, _FEET)
FLY = Motion("fly", FLIGHT, _BODY, _FEET, start=TAKE_OFF)
LAND = Motion("land", ABSORB, _BODY, _FEET, start=TOUCH)
CROUCH = Motion("crouch", HOLD - ABSORB, _BODY, _FEET, start=TOUCH + ABSORB)

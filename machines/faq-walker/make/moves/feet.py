"""Feet that do not slide: a planted foot rolls over its sole, between two plants it swings on an arc.

The sole, seen from the side, is a flat piece with a circle at the heel and a larger one, the rocker, at the
toes. A foot that pitches while planted rolls on one of them without slipping, so that the point that touches
stands still.
"""

from typing import NamedTuple

import numpy as np
from curves import Array, Curve, ramp
from scipy.interpolate import CubicSpline
from skeleton import ANKLE_HEIGHT

HEEL_Z, HEEL_RADIUS = -0.030, 0.040  # where the flat piece ends behind the ankle, and the heel's circle
TOE_Z, TOE_RADIUS = 0.115, 0.100  # the same in front: the rocker
STEP = 1e-4  # seconds, for velocities by difference


class Plant(NamedTuple):
    """The ankle's place over the flat foot (metres), the foot's yaw (radians), from `start` to `end`
    (seconds).
    """

    start: float
    end: float
    x: float
    z: float
    yaw: float


class Arc(NamedTuple):
    """One point of a swing: at this fraction of its time, this fraction of its way, at this ankle height
    (metres), moved sideways.
    """

    time: float
    way: float
    height: float
    side: float = 0.0


class Track(NamedTuple):
    """A foot over time: ankle (F, 3), yaw and pitch (F,), toes up positive."""

    ankle: Array
    yaw: Array
    pitch: Array


def rolled(plant: Plant, pitch: Array) -> Array:
    """Ankle (F, 3) over a planted foot of this pitch (F,), rolled without slip."""
    heel = pitch > 0
    centre = np.where(heel, HEEL_Z, TOE_Z)
    radius = np.where(heel, HEEL_RADIUS, TOE_RADIUS)
    back, high = -centre, ANKLE_HEIGHT - radius
    along = centre - radius * pitch + back * np.cos(pitch) - high * np.sin(pitch)
    height = radius + high * np.cos(pitch) + back * np.sin(pitch)
    return np.stack(
        [plant.x + along * np.sin(plant.yaw), height, plant.z + along * np.cos(plant.yaw)], axis=-1
    )


def _swing(t: Array, off: Plant, on: Plant, arcs: list[Arc], pitch: Curve) -> Array:
    ends = np.array([off.end, on.start])
    places = np.stack([rolled(off, pitch(ends[:1]))[0], rolled(on, pitch(ends[1:]))[0]])
    before, after = rolled(off, pitch(ends[:1] - STEP))[0], rolled(on, pitch(ends[1:] + STEP))[0]
    speeds = [(places[0] - before) / STEP, (after - places[1]) / STEP]
    times = [ends[0], *(ends[0] + arc.time * (ends[1] - ends[0]) for arc in arcs), ends[1]]
    points = [places[0] + arc.way * (places[1] - places[0]) for arc in arcs]
    points = [
        np.array([point[0] + arc.side, arc.height, point[2]]) for point, arc in zip(points, arcs, strict=True)
    ]
    spline = CubicSpline(times, [places[0], *points, places[1]], bc_type=((1, speeds[0]), (1, speeds[1])))
    return np.asarray(spline(t))


def walk_track(t: Array, plants: list[Plant], arcs: list[list[Arc]], pitch: Curve) -> Track:
    """The whole way of a foot over plants in order of time, with one list of arc points per swing between
    them.
    """
    pitched = pitch(t)
    ankle, yaw = rolled(plants[0], pitched), np.full_like(t, plants[0].yaw)
    for off, on, points in zip(plants, plants[1:], arcs, strict=False):
        planted, swinging = t >= on.start, (t > off.end) & (t < on.start)
        ankle[planted] = rolled(on, pitched[planted])
        ankle[swinging] = _swing(t[swinging], off, on, points, pitch)
        yaw += (on.yaw - off.yaw) * ramp(t, off.end, on.start)
    return Track(ankle, yaw, pitched)

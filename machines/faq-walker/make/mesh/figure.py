"""The figure under and over its clothes, as fields, in its binding pose: arms and legs a little apart, so
that nothing touches.
"""

from functools import cached_property

import numpy as np
from curves import Array
from mesh.build import Build
from mesh.patches import cast
from mesh.shapes import Field, ellipsoid, limb, mirrored, rod, union
from skeleton import ANKLE_HEIGHT, HIP, ROOT_HEIGHT, SHIN, SHOULDER, THIGH

ARM_SPREAD, LEG_SPREAD = np.radians(21.0), np.radians(5.0)  # binding pose
SHOULDER_Y, NECK_TOP = 1.45, 1.522
UP, FRONT = np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0])
ARM_WAY = np.array([np.sin(ARM_SPREAD), -np.cos(ARM_SPREAD), 0.0])
LEG_WAY = np.array([np.sin(LEG_SPREAD), -np.cos(LEG_SPREAD), 0.0])
SHOULDER_AT = np.array([SHOULDER, SHOULDER_Y, 0.0])
HIP_AT = np.array([HIP, ROOT_HEIGHT, 0.0])
ANKLE_AT = HIP_AT + (THIGH + SHIN) * LEG_WAY
SOLE_Y = ANKLE_AT[1] - ANKLE_HEIGHT
HAND_SIDE = np.cross(FRONT, ARM_WAY)  # away from the palm
LEG_SIDE = np.cross(FRONT, LEG_WAY)  # outwards

# distance along, half width, front, back, axis to the front
LEG_ROWS = [
    (-0.02, 0.052, 0.070, 0.082, -0.006),
    (0.06, 0.070, 0.080, 0.090, -0.006),
    (0.16, 0.077, 0.085, 0.086, -0.002),
    (0.28, 0.071, 0.076, 0.072, 0.002),
    (0.38, 0.060, 0.064, 0.061, 0.004),
    (0.43, 0.056, 0.062, 0.056, 0.004),
    (0.49, 0.053, 0.056, 0.060, 0.000),
    (0.56, 0.054, 0.051, 0.067, -0.003),
    (0.65, 0.048, 0.047, 0.059, -0.004),
    (0.75, 0.043, 0.047, 0.052, -0.004),
    (0.83, 0.043, 0.051, 0.055, -0.004),
    (0.92, 0.045, 0.056, 0.060, -0.004),
]
ARM_ROWS = [
    (-0.03, 0.018, 0.028, 0.030, -0.004),
    (0.00, 0.026, 0.037, 0.039, -0.004),
    (0.03, 0.034, 0.044, 0.046, -0.004),
    (0.07, 0.040, 0.048, 0.050, -0.003),
    (0.14, 0.042, 0.046, 0.046, -0.001),
    (0.22, 0.039, 0.043, 0.040, 0.000),
    (0.29, 0.036, 0.037, 0.038, 0.000),
    (0.35, 0.038, 0.039, 0.039, 0.002),
    (0.43, 0.033, 0.034, 0.034, 0.001),
    (0.51, 0.025, 0.029, 0.029, 0.000),
    (0.58, 0.020, 0.027, 0.027, 0.000),
]


def wider(rows: list[tuple[float, ...]], by: float, more: float = 0.0) -> list[tuple[float, ...]]:
    """Keys of a limb, `by` times as thick and `more` metres thicker."""
    return [(at, *(by * part + more for part in thick), shift) for at, *thick, shift in rows]


class Figure:
    """The fields of a build."""

    def __init__(self, build: Build) -> None:
        self.build = build

    @cached_property
    def chest(self) -> Field:
        """The shirt's trunk."""
        slope = rod((0.02, self.build.slope, -0.024), (0.152, 1.437, -0.010), 0.040, 0.038)
        neck = rod((0, 1.44, -0.024), (0, 1.54, -0.014), self.build.neck + 0.009, self.build.neck + 0.004)
        trunk = limb(np.zeros(3), UP, FRONT, self.build.chest, power=2.3)
        return lambda points: union(union(trunk(points), mirrored(slope)(points), 0.05), neck(points), 0.022)

    @cached_property
    def arm(self) -> Field:
        """The left arm down to the wrist."""
        return limb(SHOULDER_AT, ARM_WAY, FRONT, wider(ARM_ROWS, self.build.arm))

    @cached_property
    def sleeve(self) -> Field:
        """The left sleeve."""
        rows = wider(ARM_ROWS, self.build.arm, self.build.sleeve_loose)
        first = [(at, *(part - 0.006 for part in thick), shift) for at, *thick, shift in rows[:3]]
        return limb(SHOULDER_AT, ARM_WAY, FRONT, first + rows[3:])

    @cached_property
    def shirt(self) -> Field:
        """The whole shirt."""
        sleeve = mirrored(self.sleeve)
        return lambda points: union(self.trunk(points), sleeve(points), 0.035)

    @cached_property
    def trunk(self) -> Field:
        """The shirt without its sleeves: over the trousers where it hangs over them."""
        clear, soft = (-0.006, 0.012) if self.build.tucked else (0.009, 0.03)
        return lambda points: union(self.chest(points), self.trousers(points) - clear, soft)

    @cached_property
    def leg(self) -> Field:
        """The left trouser leg with its buttock."""
        x = 0.075
        leg = limb(HIP_AT, LEG_WAY, FRONT, wider(LEG_ROWS, self.build.leg, self.build.trouser_loose - 0.006))
        seat = ellipsoid((x, 0.925, -0.058), self.build.seat)
        return lambda points: union(leg(points), seat(points), 0.05)

    @cached_property
    def trousers(self) -> Field:
        """The whole trousers."""
        hips = limb(np.zeros(3), UP, FRONT, self.build.hips, power=2.3)

        def field(points: Array) -> Array:
            legs = union(self.leg(points), self.leg(points * (-1.0, 1.0, 1.0)), 0.06)
            return union(hips(points), legs, 0.05)

        return field

    def neckline(self, turn: Array) -> Array:
        """Points (K, 3) of the shirt's upper edge, evenly round the neck from the front over the left."""
        count = len(turn)
        deep = self.build.neckline * np.maximum(np.cos(turn), 0) ** 0.8
        way = np.stack([np.sin(turn), np.zeros(count), np.cos(turn)], -1)
        origin = np.stack([np.zeros(count), NECK_TOP - deep, np.full(count, -0.016)], -1)
        reach = np.linalg.norm(cast(self.chest, origin, way, 0.10) - origin, axis=1)
        reach = np.minimum(reach, self.build.neck + 0.013 + 0.020 * np.maximum(np.cos(turn), 0))
        return np.asarray(origin + reach[:, None] * way)

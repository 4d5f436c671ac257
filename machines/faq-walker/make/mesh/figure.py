"""The figure: a slim, dressed mannequin in its binding pose (arms and legs a little apart, so that nothing
touches).
"""

import numpy as np
from curves import Array
from mesh.shapes import Field, common, ellipsoid, limb, mirrored, rod, union
from moves.feet import HEEL_RADIUS, HEEL_Z, TOE_RADIUS, TOE_Z
from skeleton import ANKLE_HEIGHT, HIP, ROOT_HEIGHT, SHIN, SHOULDER, THIGH, WRIST

ARM_SPREAD, LEG_SPREAD = np.radians(32.0), np.radians(5.0)  # binding pose
SHOULDER_Y = 1.45
FRONT = np.array([0.0, 0.0, 1.0])
ARM_WAY = np.array([np.sin(ARM_SPREAD), -np.cos(ARM_SPREAD), 0.0])
LEG_WAY = np.array([np.sin(LEG_SPREAD), -np.cos(LEG_SPREAD), 0.0])
SHOULDER_AT = np.array([SHOULDER, SHOULDER_Y, 0.0])
HIP_AT = np.array([HIP, ROOT_HEIGHT, 0.0])
ANKLE_AT = HIP_AT + (THIGH + SHIN) * LEG_WAY
SOLE_Y = ANKLE_AT[1] - ANKLE_HEIGHT

# distance along, half width, front, back, axis to the front
TORSO = limb(
    np.array([0.0, 0.0, 0.0]),
    np.array([0.0, 1.0, 0.0]),
    FRONT,
    [
        (0.885, 0.105, 0.070, 0.085, -0.005),
        (0.930, 0.146, 0.088, 0.106, -0.008),
        (0.980, 0.149, 0.094, 0.106, -0.004),
        (1.040, 0.141, 0.094, 0.092, 0.004),
        (1.110, 0.134, 0.092, 0.082, 0.009),
        (1.190, 0.140, 0.097, 0.086, 0.007),
        (1.270, 0.154, 0.105, 0.098, 0.002),
        (1.340, 0.164, 0.106, 0.106, -0.004),
        (1.395, 0.160, 0.092, 0.100, -0.010),
        (1.435, 0.125, 0.066, 0.082, -0.016),
        (1.470, 0.070, 0.050, 0.060, -0.018),
    ],
    power=2.3,
)
LEG = limb(
    HIP_AT,
    LEG_WAY,
    FRONT,
    [
        (-0.02, 0.070, 0.075, 0.085, -0.006),
        (0.06, 0.084, 0.084, 0.094, -0.006),
        (0.16, 0.079, 0.083, 0.084, -0.002),
        (0.28, 0.067, 0.072, 0.068, 0.002),
        (0.38, 0.055, 0.058, 0.056, 0.004),
        (0.43, 0.051, 0.056, 0.051, 0.004),
        (0.49, 0.049, 0.050, 0.056, 0.000),
        (0.56, 0.051, 0.046, 0.065, -0.003),
        (0.65, 0.046, 0.043, 0.057, -0.004),
        (0.75, 0.040, 0.041, 0.046, -0.004),
        (0.80, 0.041, 0.044, 0.046, -0.004),
    ],
)
ARM = limb(
    SHOULDER_AT,
    ARM_WAY,
    FRONT,
    [
        (0.000, 0.039, 0.050, 0.053, -0.004),
        (0.05, 0.047, 0.053, 0.055, -0.003),
        (0.13, 0.045, 0.049, 0.048, -0.001),
        (0.22, 0.042, 0.045, 0.042, 0.000),
        (0.29, 0.038, 0.039, 0.039, 0.000),
        (0.35, 0.040, 0.040, 0.040, 0.002),
        (0.44, 0.033, 0.034, 0.034, 0.001),
        (0.52, 0.025, 0.028, 0.028, 0.000),
        (0.56, 0.021, 0.027, 0.027, 0.000),
    ],
)
NECK = rod((0, 1.43, -0.026), (0, 1.57, -0.006), 0.060, 0.047)
SKULL = ellipsoid((0, 1.660, -0.004), (0.077, 0.086, 0.097))
JAW = ellipsoid((0, 1.600, 0.024), (0.057, 0.074, 0.066))
CHIN = ellipsoid((0, 1.548, 0.064), (0.030, 0.024, 0.026))
NOSE = rod((0, 1.646, 0.088), (0, 1.612, 0.101), 0.008, 0.013)
EAR = ellipsoid((0.076, 1.628, -0.006), (0.011, 0.028, 0.019))
BROW = ellipsoid((0, 1.668, 0.076), (0.052, 0.014, 0.018))
SEAT = ellipsoid((0.075, 0.925, -0.060), (0.078, 0.085, 0.068))
SLOPE = rod((0.03, 1.474, -0.022), (0.176, 1.436, -0.006), 0.044, 0.042)
HAIR = ellipsoid((0, 1.668, -0.010), (0.085, 0.092, 0.103))
QUIFF = ellipsoid((0.012, 1.735, 0.045), (0.060, 0.030, 0.048))
HAND_SIDE = np.cross(FRONT, ARM_WAY)  # away from the palm


def _on_arm(t: float, out: float, ahead: float) -> Array:
    return np.asarray(SHOULDER_AT + t * ARM_WAY + out * HAND_SIDE + ahead * FRONT)


def _flat(t: float, out: float, ahead: float, length: float, thick: float, wide: float, bend: float) -> Field:
    """A flat ellipsoid on the hand, turned towards the palm by `bend` radians."""
    centre = _on_arm(t, out, ahead)
    along = ARM_WAY * np.cos(bend) - HAND_SIDE * np.sin(bend)
    axes = np.stack([along / length, np.cross(FRONT, along) / thick, FRONT / wide])

    def field(points: Array) -> Array:
        scaled = (points - centre) @ axes.T
        radius = (np.abs(scaled) ** 2.6).sum(-1) ** (1 / 2.6)
        return np.asarray((radius - 1) * np.sqrt(thick * wide))

    return field


PALM = _flat(WRIST + 0.050, 0.000, 0.002, 0.058, 0.0165, 0.040, 0.05)
FINGERS = _flat(WRIST + 0.122, -0.008, 0.000, 0.058, 0.0135, 0.036, 0.28)
THUMB = rod(_on_arm(WRIST + 0.030, -0.006, 0.030), _on_arm(WRIST + 0.092, -0.020, 0.056), 0.0155, 0.0115)


def sole(z: Array) -> Array:
    """Height of the sole over the ground under a flat foot, z from the ankle."""
    toe = np.clip(z - TOE_Z, 0, 0.98 * TOE_RADIUS)
    heel = np.clip(HEEL_Z - z, 0, 0.98 * HEEL_RADIUS)
    return np.asarray(
        TOE_RADIUS - np.sqrt(TOE_RADIUS**2 - toe**2) + HEEL_RADIUS - np.sqrt(HEEL_RADIUS**2 - heel**2)
    )


SHOE_BODY = limb(
    np.array([ANKLE_AT[0], SOLE_Y + 0.030, 0.0]),
    FRONT,
    np.array([0.0, 1.0, 0.0]),
    [
        (-0.040, 0.033, 0.060, 0.050, 0.0),
        (0.000, 0.038, 0.072, 0.050, 0.0),
        (0.045, 0.040, 0.060, 0.050, 0.0),
        (0.090, 0.045, 0.042, 0.050, 0.0),
        (0.130, 0.047, 0.031, 0.050, 0.002),
        (0.165, 0.043, 0.022, 0.045, 0.006),
        (0.180, 0.036, 0.017, 0.040, 0.010),
    ],
    power=2.6,
)
COLLAR = rod((ANKLE_AT[0], SOLE_Y + 0.075, -0.010), (ANKLE_AT[0], SOLE_Y + 0.125, -0.012), 0.044, 0.041)


def _shoe(points: Array) -> Array:
    upper = union(SHOE_BODY(points), COLLAR(points), 0.04)
    return common(upper, SOLE_Y + sole(points[..., 2]) - points[..., 1], 0.014)


def _hand(points: Array) -> Array:
    return union(union(PALM(points), FINGERS(points), 0.020), THUMB(points), 0.016)


def _side(points: Array) -> Array:
    """Arm, leg and what belongs to them, on the left."""
    leg = union(union(LEG(points), SEAT(points), 0.05), _shoe(points), 0.022)
    return np.minimum(leg, arm_field(points))


def hairline(points: Array) -> Array:
    """Positive above and behind the line where the hair begins (metres)."""
    x, y, z = points[..., 0], points[..., 1], points[..., 2]
    front = (
        0.80 * (y - 1.716)
        - 0.60 * (z - 0.072)
        - 0.9 * np.maximum(np.abs(x) - 0.045, 0.0) * np.clip(z / 0.03, 0, 1)
    )
    return union(front, y - 1.585 + 0.2 * np.abs(x), 0.02)


def _head(points: Array) -> Array:
    face = union(union(SKULL(points), union(JAW(points), CHIN(points), 0.03), 0.05), NOSE(points), 0.022)
    face = union(union(face, BROW(points), 0.03), mirrored(EAR)(points), 0.012)
    hair = common(union(HAIR(points), QUIFF(points), 0.03), -hairline(points), 0.016)
    return union(face, hair, 0.008)


def arm_field(points: Array) -> Array:
    """The left arm's field, for the weights."""
    return union(ARM(points), _hand(points), 0.022)


def trunk_field(points: Array) -> Array:
    """The field of chest, back and shoulder slopes."""
    return union(TORSO(points), mirrored(SLOPE)(points), 0.05)


def figure(points: Array) -> Array:
    """The whole body's field."""
    trunk = union(trunk_field(points), union(NECK(points), _head(points), 0.020), 0.045)
    return union(trunk, mirrored(_side)(points), 0.055)

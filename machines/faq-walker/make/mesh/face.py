"""The head as a field, and where its features are (metres, in the binding pose)."""

from functools import cached_property

import numpy as np
from curves import Array
from mesh.build import Build
from mesh.shapes import Field, common, ellipsoid, mirrored, rod, union

MIDDLE = np.array([0.0, 1.632, 0.0])
"""the point from which every place of the head is seen"""
EYE_RADIUS = 0.0200
EYE_AT = np.array([0.0355, 1.648, 0.0700])
JAW_AT = np.array([0.0, 1.612, 0.010])
MOUTH_Y, MOUTH_HALF = 1.5735, 0.0265


class Face:
    """The head of a build."""

    def __init__(self, build: Build) -> None:
        self.build = build

    @property
    def eye(self) -> float:
        """The radius of an eyeball."""
        return EYE_RADIUS * self.build.eye

    @cached_property
    def skull(self) -> Field:
        """The head without its features."""
        b = self.build
        skull = ellipsoid((0, 1.680, -0.010), (0.0820, 0.0900, 0.1040))
        jaw = ellipsoid((0, 1.609, 0.028), (0.0640 * b.jaw, 0.080, 0.0700))
        chin = ellipsoid((0, 1.543, 0.071), (0.0270 * b.jaw, 0.0210, 0.0230))
        cheek = mirrored(ellipsoid((0.0400, 1.612, 0.0610), (0.0250, 0.0240, 0.0260)))
        angle = mirrored(ellipsoid((0.0470 * b.jaw, 1.575, 0.020), (0.0140, 0.0260, 0.0300)))
        neck = rod((0, 1.43, -0.026), (0, 1.58, -0.014), b.neck + 0.006, b.neck - 0.003)

        def field(points: Array) -> Array:
            lower = union(union(jaw(points), chin(points), 0.03), angle(points), 0.03)
            whole = union(union(skull(points), lower, 0.045), cheek(points), 0.03)
            return union(whole, neck(points), 0.028)

        return field

    @cached_property
    def skin(self) -> Field:
        """The head with brows, sockets, lids, nose and lips."""
        b = self.build
        n = b.nose
        brow = mirrored(rod((0.012, 1.6785, 0.0850), (0.0540, 1.6785, 0.0660), 0.0085, 0.0080))
        socket = mirrored(ellipsoid((0.0360, 1.6500, 0.1040), (0.0300, 0.0220, 0.0200)))
        lid = mirrored(ellipsoid(tuple(EYE_AT), (self.eye + 0.0022,) * 3))
        bridge = rod((0, 1.668, 0.0850), (0, 1.614, 0.1130), 0.0058, 0.0080 * n)
        tip = ellipsoid((0, 1.6075, 0.1150), (0.0115 * n, 0.0100 * n, 0.0130))
        wings = mirrored(ellipsoid((0.0122 * n, 1.6040, 0.1030), (0.0075 * n, 0.0075, 0.0110)))
        upper = mirrored(ellipsoid((0.0085, MOUTH_Y + 0.0042, 0.0915), (0.0225, 0.0058 * b.lips, 0.0110)))
        lower = ellipsoid((0, MOUTH_Y - 0.0058, 0.0905), (0.0290, 0.0072 * b.lips, 0.0115))

        def field(points: Array) -> Array:
            face = union(self.skull(points), brow(points), 0.022)
            face = common(face, -socket(points), 0.016)
            face = union(face, lid(points), 0.006)
            nose = union(union(bridge(points), tip(points), 0.014), wings(points), 0.005)
            face = union(face, nose, 0.010)
            return union(face, union(upper(points), lower(points), 0.003), 0.009)

        return field

"""Signed fields (metres, negative inside) of which the body is made: tapered limbs, ellipsoids, smooth
unions.
"""

from collections.abc import Callable, Sequence

import numpy as np
from curves import Array
from scipy.interpolate import PchipInterpolator

Field = Callable[[Array], Array]


def limb(
    start: Array, along: Array, front: Array, keys: Sequence[tuple[float, ...]], power: float = 2.0
) -> Field:
    """A tapered limb.

    Keys: distance along the axis, radius sideways, in front, behind, and how far the axis lies to the front.
    """
    rows = np.array(keys, float)
    shape = PchipInterpolator(rows[:, 0], rows[:, 1:])
    side = np.cross(front, along)

    def field(points: Array) -> Array:
        local = points - start
        t = local @ along
        inside = np.clip(t, rows[0, 0], rows[-1, 0])
        width, ahead, behind, shift = np.moveaxis(shape(inside), -1, 0)
        z = local @ front - shift
        depth = np.where(z > 0, ahead, behind)
        cap = 0.7 * np.minimum(width, depth)
        terms = (np.abs(local @ side) / width, np.abs(z) / depth, np.abs(t - inside) / cap)
        radius = sum(term**power for term in terms) ** (1 / power)
        return np.asarray((radius - 1) * np.sqrt(width * depth))

    return field


def ellipsoid(centre: Sequence[float], radii: Sequence[float]) -> Field:
    """An ellipsoid along the world's axes."""
    middle, size = np.array(centre), np.array(radii)

    def field(points: Array) -> Array:
        scaled = (points - middle) / size
        length = np.sqrt((scaled**2).sum(-1))
        slope = np.sqrt(((scaled / size) ** 2).sum(-1))
        return np.asarray(length * (length - 1) / np.maximum(slope, 1e-9))

    return field


def rod(start: Sequence[float], end: Sequence[float], first: float, last: float) -> Field:
    """A rod with round ends whose radius goes from `first` to `last`."""
    a, way = np.array(start), np.subtract(end, start)

    def field(points: Array) -> Array:
        f = np.clip((points - a) @ way / (way @ way), 0, 1)
        return np.asarray(
            np.linalg.norm(points - a - f[..., None] * way, axis=-1) - (first + (last - first) * f)
        )

    return field


def union(a: Array, b: Array, softness: float) -> Array:
    """The union of two fields, rounded where they meet."""
    near = np.maximum(softness - np.abs(a - b), 0) / softness
    return np.asarray(np.minimum(a, b) - near * near * softness / 4)


def common(a: Array, b: Array, softness: float) -> Array:
    """What two fields have in common, its edge rounded."""
    return -union(-a, -b, softness)


def mirrored(field: Field) -> Field:
    """A field made for the left side, for both sides."""
    return lambda points: field(np.stack([np.abs(points[..., 0]), points[..., 1], points[..., 2]], axis=-1))

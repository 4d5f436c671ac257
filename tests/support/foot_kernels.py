"""How feet lie on uneven ground, called from Python."""

from typing import Any

from numba import types
from statwalk.maths.compiling import LONG, kernel, write
from statwalk.maths.reference import by_reference
from statwalk.solve.foot_path import choose_landing, path_height, stretch_path
from statwalk.solve.foot_tables import FEET, TO_X, TO_Z
from statwalk.solve.footing import height_over, points_supported, slope_under

DOUBLE = types.float64


@kernel(FEET, LONG, DOUBLE, DOUBLE, DOUBLE, DOUBLE, write(DOUBLE, 1))
def lie(feet: Any, foot: int, x: float, z: float, sine: float, cosine: float, out: Any) -> None:
    """Writes slope along x and z, height and supported points of a foot there."""
    f = by_reference(feet)
    out[0], out[1] = slope_under(f, foot, x, z, sine, cosine)
    out[2] = height_over(f, foot, x, z, sine, cosine, out[0], out[1], 0.0, 0.0, 0.0)
    out[3] = points_supported(f, foot, x, z, sine, cosine)


@kernel(FEET, LONG, DOUBLE, DOUBLE, write(DOUBLE, 2), write(DOUBLE, 1), write(DOUBLE, 1))
def land(feet: Any, foot: int, x: float, z: float, keep: Any, place: Any, heights: Any) -> None:
    """Writes where a foot lands whose motion lands at x, z, and the heights of its path from where `keep` has
    it; it points along +Z.
    """
    f = by_reference(feet)
    choose_landing(f, keep, 0, foot, 0, x, z, 0.0, 1.0)
    stretch_path(f, keep, 0, foot, 0, 0.0, 1.0)
    place[0], place[1] = keep[0, TO_X], keep[0, TO_Z]
    for part in range(heights.shape[0]):
        heights[part] = path_height(keep, 0, 0, part / (heights.shape[0] - 1.0))

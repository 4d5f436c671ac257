"""Inbetweening: whole meshes with equal vertex counts are blended (RTCA 2.2; morph targets, glTF 2.0,
3.7.2.2).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.skin import _kernels

FLOAT32 = np.dtype(np.float32)
IN_ORDER = 0x101
"""NumPy's flags of a contiguous and aligned array"""


def inbetween(start: Floats, end: Floats, fraction: float, out: Floats | None = None) -> Floats:
    """Returns the mesh at `fraction` 0…1 between `start` and `end`: s[k] + t·(s[k+1] - s[k]) (RTCA Listing 1,
    corrected).

    The mesh is written into `out`, if `out` is not None; it must have the same shape and type.
    """
    mesh = np.empty_like(start) if out is None else out
    alike = start.shape == end.shape == mesh.shape and start.dtype == end.dtype == mesh.dtype == FLOAT32
    if alike and start.flags.num & end.flags.num & mesh.flags.num & IN_ORDER == IN_ORDER:
        _kernels.inbetween(start.ravel(), end.ravel(), fraction, mesh.ravel())
        return mesh
    np.subtract(end, start, out=mesh)
    np.multiply(mesh, start.dtype.type(fraction), out=mesh)
    return np.add(mesh, start, out=mesh)


class Morph(NamedTuple):
    """The morph targets of some vertices: displacements (M,3,v) of the vertices of `span`, weighted by the
    pose's weights from column `first` on.
    """

    span: slice
    first: int
    displacements: NDArray[np.float32]

"""Inbetweening: whole meshes with equal vertex counts are blended (RTCA 2.2; morph targets, glTF 2.0, 3.7.2.2)."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.maths.kernels.choose import kernels

FLOAT32 = np.dtype(np.float32)
IN_ORDER = 0x101
"""NumPy's flags of an array that is contiguous and aligned"""


def inbetween(start: Floats, end: Floats, fraction: float, out: Floats | None = None) -> Floats:
    """The mesh at `fraction` 0…1 of the way from `start` to `end`: s[k] + t·(s[k+1] - s[k]) (RTCA Listing 1, corrected).

    It is written into `out` where one is given, of the same shape and kind.
    """
    found = np.empty_like(start) if out is None else out
    compiled = kernels()
    alike = start.shape == end.shape == found.shape and start.dtype == end.dtype == found.dtype == FLOAT32
    if compiled is not None and alike and start.flags.num & end.flags.num & found.flags.num & IN_ORDER == IN_ORDER:
        compiled.inbetween(start.ravel(), end.ravel(), fraction, found.ravel())
        return found
    np.subtract(end, start, out=found)
    np.multiply(found, start.dtype.type(fraction), out=found)
    return np.add(found, start, out=found)


class Morph(NamedTuple):
    """The morph targets of some vertices: displacements (M,3,v) for the vertices of `span`, by the pose's weights from column `first`."""

    span: slice
    first: int
    displacements: NDArray[np.float32]

    def add(self, base: Floats, weights: Floats) -> None:
        """Add the weighted displacements to `base` (3,V), in place. Targets without weight cost nothing."""
        for target, displacement in enumerate(self.displacements):
            weight = weights[self.first + target]
            if weight != 0:
                base[:, self.span] += displacement * base.dtype.type(weight)


def morphed(base: Floats, morphs: tuple[Morph, ...], weights: Floats) -> Floats:
    """Base (3,V) with all displacements added; `base` itself where there are none."""
    if not morphs:
        return base
    out = np.array(base)
    for morph in morphs:
        morph.add(out, weights)
    return out

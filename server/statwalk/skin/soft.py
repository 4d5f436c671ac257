"""Soft skin: every vertex follows several bones, v' = Σ wᵢ · Mᵢ · v with Mᵢ = world · inverse bind (RTCA 2.3.2, Listings 4 and 5).

A rigid skin (RTCA 2.3.1) is the same with one influence of weight 1; a rigid part (RTCA 2.1, FAQ Q20) is a rigid skin whose
inverse bind is the identity.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.skin.rows import rows_of


class Palette(NamedTuple):
    """The bones that vertices follow: `joints` (K,) of the skeleton, `inverse_bind` (K,3,4)."""

    joints: NDArray[np.int32]
    inverse_bind: NDArray[np.float32]

    def rows(self, world: Floats) -> Floats:
        """Rows (12,K) of the matrices world · inverse bind, for world matrices (J,3,4)."""
        return rows_of(transform.mul(world[self.joints], self.inverse_bind))


class Influence(NamedTuple):
    """One bone per vertex: `bone` (v,) of the palette and `weight` (v,), for the vertices listed, or for all of them (None)."""

    bone: NDArray[np.intp]
    weight: NDArray[np.float32]
    vertices: NDArray[np.intp] | None = None


def influences(bones: NDArray[np.intp], weights: NDArray[np.float32]) -> tuple[Influence, ...]:
    """Bones and weights (V,I), largest first, as influences; those that few vertices have list their vertices."""
    out = [Influence(np.ascontiguousarray(bones[:, 0]), np.ascontiguousarray(weights[:, 0]))]
    for column in range(1, bones.shape[1]):
        vertices = np.flatnonzero(weights[:, column])
        if len(vertices) * 2 > len(bones):
            out.append(Influence(np.ascontiguousarray(bones[:, column]), np.ascontiguousarray(weights[:, column])))
        elif len(vertices):
            out.append(Influence(bones[vertices, column], weights[vertices, column], vertices))
    return tuple(out)


def blended_rows(rows: Floats, found: Sequence[Influence]) -> Floats:
    """Rows (12,V): for every vertex the weighted sum of its bones' rows (12,K)."""
    blended = rows.take(found[0].bone, axis=1)
    if len(found) > 1:
        blended *= found[0].weight
    for influence in found[1:]:
        share = rows.take(influence.bone, axis=1)
        share *= influence.weight
        if influence.vertices is None:
            blended += share
        else:
            blended[:, influence.vertices] += share
    return blended

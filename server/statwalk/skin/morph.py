"""Inbetweening: whole meshes with equal vertex counts are blended (RTCA 2.2; morph targets, glTF 2.0, 3.7.2.2)."""

from __future__ import annotations

import numpy as np

from statwalk.maths.arrays import Floats


def inbetween(start: Floats, end: Floats, fraction: float) -> Floats:
    """The mesh (V,3) at `fraction` 0…1 of the way from `start` to `end`: s[k] + t·(s[k+1] - s[k]) (RTCA Listing 1, corrected)."""
    return start + (end - start) * start.dtype.type(fraction)


def morphed(base: Floats, targets: Floats, weights: Floats) -> Floats:
    """Base (V,3) plus weighted displacements (M,V,3): (…,V,3) for weights (…,M). Targets without weight cost nothing."""
    out = np.broadcast_to(base, (*weights.shape[:-1], *base.shape))
    for target in range(len(targets)):
        weight = weights[..., target]
        if weight.any():
            out = out + targets[target] * weight[..., None, None]
    return out

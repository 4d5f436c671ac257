"""Puts weights into a body: every part gets one skin with the same joints."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.character.autorig.bind_space import BindSpace, RigBody
from statwalk.maths import transform
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.binding.influences import strongest
from statwalk.skin.primitive import Skin


def with_skin(body: RigBody, space: BindSpace, joints: Ints, bound: Floats, weights: Floats) -> RigBody:
    """Returns the body with a skin of `joints` (K,), which stand at `bound` (K,3,4) when they are bound, and
    weights (V,K) of all vertices of all parts.

    Parts in the same space share a skin.
    """
    chosen, shares = strongest(weights)
    skins: list[Skin] = []
    row_of: dict[bytes, int] = {}
    parts = []
    first = 0
    inverse = transform.invert(bound)
    for part, placed in zip(body.parts, space.placed, strict=True):
        rows = slice(first, first + len(part.positions))
        first += len(part.positions)
        key = placed.astype(np.float32).tobytes()
        if key not in row_of:
            row_of[key] = len(skins)
            matrices = transform.mul(inverse, np.broadcast_to(placed, inverse.shape))
            skins.append(Skin(f"skin {len(skins)}", joints.astype(np.int32), matrices.astype(np.float32)))
        parts.append(replace(part, skin=row_of[key], joints=chosen[rows].copy(), weights=shares[rows].copy()))
    return replace(body, skins=tuple(skins), parts=tuple(parts))

"""Rigid parts: a mesh per bone, drawn with that bone's matrix, gaps and all (RTCA 2.1, FAQ Q20)."""

from __future__ import annotations

from statwalk.maths.arrays import Floats
from statwalk.skin.rows import rows_of


def rigid_rows(world: Floats, joint: int) -> Floats:
    """Rows (…,12,1) that move every vertex of a part with its joint; `world` (…,J,3,4)."""
    return rows_of(world[..., joint : joint + 1, :, :])

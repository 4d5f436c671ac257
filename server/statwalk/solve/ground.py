"""The ground on which feet stand: level and sloping rectangles over a floor at height 0."""

from __future__ import annotations

from typing import Any

from statwalk.maths.compiling import inlined


@inlined
def ground_at(ground: Any, x: float, z: float, root_height: float) -> Any:
    """Returns the height of the ground (metres) at a place on the stage; `ground` (G, 7) as in `FootTables`.
    Without any, the ground is where the root is.
    """
    height = 0.0 if ground.shape[0] > 0 else root_height
    for piece in range(ground.shape[0]):
        inside = ground[piece, 0] <= x <= ground[piece, 2] and ground[piece, 1] <= z <= ground[piece, 3]
        if inside:
            height = max(height, ground[piece, 4] + ground[piece, 5] * x + ground[piece, 6] * z)
    return height

"""The part of a frame that shows one cast."""

from __future__ import annotations

from statwalk.stage.state.cast import Cast
from statwalk.stage.state.frame import CastFrame


def cast_frame(cast: Cast) -> CastFrame:
    """Returns the poses and places of a cast, which the next tick does not change."""
    place, state = (cast.position.copy(), cast.heading.copy()), cast.machine.state.copy()
    return CastFrame(cast.role, cast.ids, cast.shown.poses(), *place, state, cast.phase, cast.offsets.left)

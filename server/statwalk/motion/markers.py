"""Named moments of a motion, found as time passes over them."""

from __future__ import annotations

from collections.abc import Sequence

from statwalk.motion.channel import Marker


def crossed(markers: Sequence[Marker], start: float, end: float, wraps: int = 0) -> list[str]:
    """The names of the markers after `start` up to and with `end` seconds, in the order of time, through `wraps` repeats."""
    in_order = sorted(markers, key=lambda marker: marker.time)
    if not wraps:
        return [marker.name for marker in in_order if start < marker.time <= end]
    rest = [marker.name for marker in in_order if marker.time > start]
    begun = [marker.name for marker in in_order if marker.time <= end]
    return rest + [marker.name for marker in in_order] * (wraps - 1) + begun

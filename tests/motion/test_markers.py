"""Markers are crossed once, whether time runs over them or wraps."""

import pytest
from statwalk.motion.channel import Marker
from statwalk.motion.markers import crossed

MARKERS = (Marker("right", 0.75), Marker("left", 0.25))


@pytest.mark.parametrize(
    ("start", "end", "wraps", "names"),
    [
        (0.0, 0.2, 0, []),
        (0.2, 0.25, 0, ["left"]),
        (0.25, 0.3, 0, []),
        (0.0, 1.0, 0, ["left", "right"]),
        (0.7, 0.3, 1, ["right", "left"]),
        (0.8, 0.1, 1, []),
        (0.8, 0.1, 2, ["left", "right"]),
    ],
)
def test_crossed(start, end, wraps, names):
    assert crossed(MARKERS, start, end, wraps) == names

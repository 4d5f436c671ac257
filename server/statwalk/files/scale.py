"""The scale by which a reader multiplies the lengths of a file whose unit is not the metre."""

from statwalk.errors import ContentError

SMALLEST_SCALE = 1e-6
LARGEST_SCALE = 1e6


def check_scale(scale: float) -> None:
    """Checks a scale that a user gave.

    :raises ContentError: when it is not between the smallest and the largest.
    """
    if not SMALLEST_SCALE <= scale <= LARGEST_SCALE:
        raise ContentError(f"a scale is a number from {SMALLEST_SCALE:g} to {LARGEST_SCALE:g}, not {scale:g}")

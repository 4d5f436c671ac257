"""The kinds of segments between two key frames, as numbers for compiled code."""

from __future__ import annotations

HOLD, LINE, CUBIC, ARC, CUBIC_TURN, SPLINE_TURN = range(6)
"""for numbers: STEP, LINEAR, all cubics; for rotations: slerp, a cubic of the components, the cumulative
B-spline. A later kind of numbers can represent an earlier one. STEP of rotations is HOLD as well.
"""
IS_TURN = (False, False, False, True, True, True)
VECTORS = (1, 2, 4, 9, 16, 13)
"""the number of vectors of sixteen numbers in a row, for each kind"""
OWN_CLOCKS, IN_STEP, LOOSE = range(3)
"""what sixteen lanes share: the edges of all lanes together; edges that are edges of every lane; nothing,
each lane is searched
"""

"""The kinds of segments between two key frames, as numbers for compiled code."""

from __future__ import annotations

HOLD, LINE, CUBIC, RATIONAL, ARC, CUBIC_TURN, SPLINE_TURN, RATIONAL_TURN = range(8)
"""for numbers: STEP, LINEAR, all cubics, NURBS; for rotations: slerp, a cubic of the components, the
cumulative B-spline, the cumulative NURBS. A later kind of numbers can represent an earlier one. STEP of
rotations is HOLD as well.
"""
IS_TURN = (False, False, False, False, True, True, True, True)
VECTORS = (1, 2, 4, 8, 9, 16, 13, 29)
"""the number of vectors of sixteen numbers in a row, for each kind"""
DIVISOR = {RATIONAL: 4, RATIONAL_TURN: 13}
"""for kinds that divide by a cubic: the vector of its constant; it is 1 in lanes without such a curve"""
OWN_CLOCKS, IN_STEP, LOOSE = range(3)
"""what sixteen lanes share: the edges of all lanes together; edges that are edges of every lane; nothing,
each lane is searched
"""

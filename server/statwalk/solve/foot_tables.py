"""What the foot lock knows of the feet of a role: legs, points of the soles, and contacts in the clips."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import columns


class FootTables(NamedTuple):
    """F feet, n joints of the legs and above, K points of all soles, M members of motions."""

    joints: Annotated[NDArray[np.int32], "joint"]
    """hips, knees, ankles, carriers of the soles, and all above them, parents first"""
    parents: Annotated[NDArray[np.int32], "joint"]
    """the index of each joint's parent in `joints`, -1 a root"""
    pelvis: Annotated[NDArray[np.int32], "1"]
    """the joint that carries all legs, and gives way to them"""
    above_pelvis: Annotated[NDArray[np.int32], "1"]
    """the index in `joints` of the pelvis's parent, -1 none"""
    unit: Annotated[NDArray[np.float64], "1"]
    """metres: a power of two, 1 for a leg of 0.6 to 1.2 metres; the foot lock's lengths are in units"""
    hip: Annotated[NDArray[np.int32], "foot"]
    """index in `joints`"""
    ankle: Annotated[NDArray[np.int32], "foot"]
    """index in `joints`"""
    left: Annotated[NDArray[np.float64], "foot, xyz"]
    """the direction to the left of the foot, in the frame of the ankle: the foot's yaw is computed from it,
    since it stays level however steep the foot is
    """
    bend: Annotated[NDArray[np.float64], "foot, xyz"]
    """the direction in which the knee bends, in the frame of the hip"""
    across: Annotated[NDArray[np.float64], "foot, xyz"]
    """the direction at right angles to `bend` on the side of the thigh, in the frame of the hip"""
    length: Annotated[NDArray[np.float64], "foot"]
    """units from hip to knee to ankle"""
    other: Annotated[NDArray[np.int32], "foot"]
    """the foot beside it, -1 none: of two feet each waits for the other"""
    first_point: Annotated[NDArray[np.int32], "foot + 1"]
    lowest: Annotated[NDArray[np.int32], "foot"]
    """how many of a foot's points lie lowest: the first; on uneven ground more follow, all over the sole"""
    spread: Annotated[NDArray[np.int32], "foot"]
    """how many of a foot's points are all over the sole; the last ones are outermost in a steep foot"""
    carrier: Annotated[NDArray[np.int32], "point"]
    """the index in `joints` of the joint that carries a point"""
    point: Annotated[NDArray[np.float64], "point, xyz"]
    """metres, in the frame of its carrier"""
    on_print: Annotated[NDArray[np.float64], "point, 2"]
    """units from the middle of the sole at rest to a point, forward and to the left"""
    first_span: Annotated[NDArray[np.int32], "member · foot + 1"]
    """for each member of `MotionTables` and foot"""
    span: Annotated[NDArray[np.float64], "span, 2"]
    """phases at which a foot comes down and at which it leaves the ground; the second may be beyond 1"""
    weight: Annotated[NDArray[np.float64], "1"]
    """0…1, if `weight_parameter` is -1"""
    weight_parameter: Annotated[NDArray[np.int64], "1"]
    ground: Annotated[NDArray[np.float64], "piece, 7"]
    """in units: x and z of two corners of a level or sloping rectangle, and a, b, c of its height
    a + b·x + c·z on the stage; where rectangles overlap the highest counts, beside them the height is 0
    """
    memory: Annotated[NDArray[np.int64], "1"]
    """the first column of the foot lock in the solvers' memory"""
    fit: Annotated[NDArray[np.int64], "1"]
    """the first column of what feet need on uneven ground in the solvers' memory, -1 on a level floor"""
    print: Annotated[NDArray[np.float64], "foot, 4"]
    """of the sole at rest, units: ALONG, ACROSS from the ankle to its middle, forward and to the left;
    HALF_LENGTH, HALF_WIDTH
    """
    first_below: Annotated[NDArray[np.int32], "foot + 1"]
    below: Annotated[NDArray[np.int32], "joint of a foot"]
    """the indices in `joints` of each ankle and the joints below it"""
    landing: Annotated[NDArray[np.float64], "span, 3"]
    """where the middle of the sole will lie of a foot that comes down, once it is flat: x and z (metres, in
    the actor's frame), and the foot's yaw
    """


FEET = columns(FootTables, readonly=True)
"""the numba type of FootTables"""
OF_ACTOR = 3
"""numbers of an actor in the solvers' memory, before the numbers of the feet"""
DROP, DROP_RATE, LIFT_RATE = range(OF_ACTOR)
"""metres by which the pelvis is lowered; m/s at which it gives way, and at which the ground lifts the root"""
OF_FOOT = 20
"""numbers of a foot"""
(
    PLANTED, PIVOT, PIVOT_X, PIVOT_Z, YAW, SINCE, EAGER, X, Z, TURN, Y, X_RATE, Z_RATE, TURN_RATE, Y_RATE,
    LOWEST, LOWEST_X, LOWEST_Y, LOWEST_Z, TOO_SHORT,
) = range(OF_FOOT)  # fmt: skip
"""STANDING, LEAVING or 0, on its way; the point of the sole that it stands on, and where that point is shown
on the stage; the foot's yaw; seconds since it was planted or released (below 0: a new actor); how fast it
goes back to its motion (1/s); the shown foot relative to the animated one, in metres and radians, and the
rates; the lowest animated point, and where it was; 1 if the foot stands and the leg is too short for it
"""
LEAVING, STANDING = 1.0, 2.0
"""a foot that leaves has been released, and keeps its place until it is clear of the ground"""

ALONG, ACROSS, HALF_LENGTH, HALF_WIDTH = range(4)
"""columns of `print`"""
FIT, PATH_PARTS = 5, 16
"""numbers of a fit; parts of a foot's path through the air"""
SHIFT_X, SHIFT_Z, TILT_X, TILT_Z, LIFT = range(FIT)
"""a foot's fit to uneven ground: metres from its motion, slope, metres above the root's floor"""
TOOK = FIT
"""the fit when the last motion began: the pose offset has taken it over"""
(
    TILT_X_RATE, TILT_Z_RATE, SLOPE_X, SLOPE_Z, PLAN, HEIGHT, SLIP, SLIP_RATE, AT_X, AT_Z, FROM_X, FROM_Z,
    TO_X, TO_Z, AIM_X, AIM_Z, OLD_X, OLD_Z, SHIFTED, PROGRESS, CLIMB, ASIDE_X, ASIDE_Z, ASIDE_X_RATE,
    ASIDE_Z_RATE, SHIFT_X_RATE, SHIFT_Z_RATE, BENT, PATH,
) = range(2 * FIT, 2 * FIT + 29)  # fmt: skip
"""how fast the slope changes; the slope that is wanted; STANDS, FLIES, SEARCHES or 0, a new foot; the height
that is wanted, and how far above it the foot still is (metres), with the rate; where the middle of the sole
lies once it is flat, on the stage; where it set off and where it lands; where its motion lands; SHIFT as it
set off, and the share 0…1 of the way to its new SHIFT; the share of its path that is behind it; how fast it
rises (m/s); the part of SHIFT that keeps it out of steps and from haste, and how fast that changes; how fast
the rest of SHIFT changes; how much its leg was bent in the tick before (0: straight, 1: folded); the first of
PATH_PARTS + 1 heights along it
"""
SAG, OF_GROUND = 0, 1
"""the number of an actor on uneven ground, before its feet: metres by which its pelvis is lowered"""
OF_FIT = PATH + PATH_PARTS + 1
"""numbers of a foot on uneven ground"""
STANDS, FLIES, SEARCHES = 1.0, 2.0, 3.0
"""a foot that searches is on its way, and its motion does not say where it lands"""

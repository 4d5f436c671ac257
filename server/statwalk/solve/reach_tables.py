"""What the solvers of a machine file read in a tick: their targets, weights and memory."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import columns


class ReachTables(NamedTuple):
    """K solvers, n joints, P parameters, S states, L layers; parameters are columns of the smoothed ones."""

    first_chain: Annotated[NDArray[np.int32], "1"]
    """the chain of the first solver: the chains of feet come before it"""
    target: Annotated[NDArray[np.int32], "solver, xyz"]
    """parameters"""
    in_stage: Annotated[NDArray[np.bool_], "solver"]
    """whether target, pole and rotation parameters are in stage space, else in model space"""
    is_direction: Annotated[NDArray[np.bool_], "solver"]
    """whether the target is a direction from the end, else a point"""
    pole: Annotated[NDArray[np.float64], "solver, xyz"]
    """a direction in model space, if `pole_parameter` is -1"""
    pole_parameter: Annotated[NDArray[np.int32], "solver, xyz"]
    rotation: Annotated[NDArray[np.float64], "solver, xyzw"]
    """of the end, in model space, if `rotation_parameter` is -1; chains with `turns_end` read it"""
    rotation_parameter: Annotated[NDArray[np.int32], "solver, xyzw"]
    weight_parameter: Annotated[NDArray[np.int32], "solver, state"]
    """the parameter that gives the weight in a state; -1: a channel or `weight` gives it"""
    weight_channel: Annotated[NDArray[np.int32], "solver, state"]
    """the channel of a pose that gives the weight in a state; -1: a parameter or `weight` gives it"""
    weight: Annotated[NDArray[np.float64], "solver, state"]
    eagerness: Annotated[NDArray[np.float64], "solver"]
    """1/s with which a weight by state is reached; 0: immediately"""
    travel: Annotated[NDArray[np.float64], "solver"]
    """1/s with which the end travels; 0: immediately; below 0: it does not travel"""
    cone: Annotated[NDArray[np.float64], "solver, 2"]
    """cosine and sine of the angle from +Z within which a look-at solver looks; -1, 0: everywhere"""
    is_measured: Annotated[NDArray[np.bool_], "solver"]
    """whether the distance from its target is measured at last: its chain aims elsewhere, on the way, at the
    edge of a cone or far away, or there are chains that hang
    """
    length: Annotated[NDArray[np.float64], "solver"]
    """metres: of the chain at rest"""
    joints: Annotated[NDArray[np.int32], "joint"]
    """the starts and ends of the chains whose distance is measured, and all above them, parents first"""
    parents: Annotated[NDArray[np.int32], "joint"]
    """the index of each joint's parent in `joints`, -1 a root"""
    start: Annotated[NDArray[np.int32], "solver"]
    """the index in `joints` of a chain's anchor, 0 if it is not there"""
    end: Annotated[NDArray[np.int32], "solver"]
    """of the joint that comes to the target"""
    covers: Annotated[NDArray[np.bool_], "solver, layer"]
    """whether a layer moves joints of the chain"""
    memory: Annotated[NDArray[np.int32], "solver"]
    """a solver's first column in the solvers' memory"""
    turned: Annotated[NDArray[np.int32], "solver"]
    """joints whose turns a force solver carries from tick to tick, x y z w each after its other numbers"""


REACH = columns(ReachTables, readonly=True)
"""the numba type of ReachTables"""
FAR = 1e5
"""metres from the end at which a direction is aimed: what moves the end turns the direction by nothing"""
OF_SOLVER = 13
"""numbers of a solver in the solvers' memory"""
(
    SINCE, WEIGHT, WEIGHT_RATE, SHOWN, CARRIED, LAYER, DISTANCE, X, Y, Z, X_RATE, Y_RATE, Z_RATE,
) = range(OF_SOLVER)  # fmt: skip
"""0 in a new actor; the weight by state, and its rate; the weight that was shown; the part of it that is in
the pose offset of a transition when it began, and the layer of that transition; metres from the end to the
target; where the end of a chain that travels is on its way, and its velocity (in the space of the target)
"""

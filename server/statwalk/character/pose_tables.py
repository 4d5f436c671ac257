"""The data about poses that a tick reads beside the motions: the layers' modes and weights, the frame of the
root joint, and the joints that colliders ride on.
"""

from __future__ import annotations

from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.machine.compile.alternatives import Layer
from statwalk.maths.arrays import Floats
from statwalk.maths.columns import columns, locked
from statwalk.rig.model_buffer import JointList
from statwalk.solve.expression_tables import ExpressionTables
from statwalk.solve.springs import Springs


class PoseTables(NamedTuple):
    """L layers, S states."""

    is_additive: Annotated[NDArray[np.bool_], "layer"]
    weight: Annotated[NDArray[np.float64], "layer"]
    """if `weight_parameter` is -1"""
    weight_parameter: Annotated[NDArray[np.int64], "layer"]
    plays: Annotated[NDArray[np.bool_], "state"]
    """whether a state has a motion"""
    root: Annotated[NDArray[np.int64], "1"]
    """the root joint, -1 none"""
    root_frame: Annotated[NDArray[np.float64], "row, column"]
    """(3, 4) the transform of the root joint's parent in the character's space"""
    model_joints: Annotated[NDArray[np.int32], "joint"]
    """the joints that colliders ride on, and their ancestors, parents first"""
    model_parents: Annotated[NDArray[np.int32], "joint"]
    """the index of each joint's parent in `model_joints`, -1 a root"""
    joint: Annotated[NDArray[np.int32], "joint"]
    """the joints with springs and their ancestors; `solve.springs.Springs` explains this and the following"""
    parent: Annotated[NDArray[np.int32], "joint"]
    row: Annotated[NDArray[np.int32], "joint"]
    numbers: Annotated[NDArray[np.float64], "spring, 6"]
    column: Annotated[NDArray[np.int64], "spring"]
    expressions: ExpressionTables


def pose_tables(
    layers: tuple[Layer, ...],
    plays: NDArray[np.bool_],
    root: int,
    root_frame: Floats | None,
    model_joints: JointList,
    springs: Springs,
    expressions: ExpressionTables,
) -> PoseTables:
    """Returns the tables of a role; `root_frame` None: the root joint has no parent."""
    return locked(
        PoseTables(
            is_additive=np.array([layer.mode == "additive" for layer in layers]),
            weight=np.array([layer.weight for layer in layers]),
            weight_parameter=np.array([layer.weight_parameter for layer in layers]),
            plays=plays,
            root=np.array([root]),
            root_frame=np.eye(4)[:3] if root_frame is None else np.asarray(root_frame, np.float64),
            model_joints=model_joints.joints,
            model_parents=model_joints.parents,
            **springs._asdict(),
            expressions=expressions,
        )
    )


POSES = columns(PoseTables, readonly=True)
"""the numba type of PoseTables"""

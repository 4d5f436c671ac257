"""The data of a role that a tick reads, packed."""

from __future__ import annotations

from typing import Any, NamedTuple

from statwalk.character.pose_tables import PoseTables
from statwalk.machine.compile.program import Program
from statwalk.maths.clamp_table import ClampTable
from statwalk.maths.packed import PackedColumns
from statwalk.motion.layer_lanes import LayerMasks
from statwalk.motion.tables.motion_tables import MotionTables
from statwalk.solve.chains import Chains
from statwalk.solve.foot_tables import FootTables
from statwalk.solve.hanging import HangingTables
from statwalk.solve.reach_tables import ReachTables


class PackedRole(NamedTuple):
    """The data of a role that a tick reads, packed."""

    program: PackedColumns[Program]
    motions: PackedColumns[MotionTables]
    poses: PackedColumns[PoseTables]
    masks: PackedColumns[LayerMasks]
    feet: PackedColumns[FootTables]
    chains: PackedColumns[Chains]
    clamps: PackedColumns[ClampTable]
    reach: PackedColumns[ReachTables]
    hanging: PackedColumns[HangingTables]

    @property
    def solvers(self) -> tuple[Any, Any, Any, Any, Any]:
        """Returns the tables of the solvers as arguments of kernels."""
        return (
            self.feet.argument,
            self.chains.argument,
            self.clamps.argument,
            self.reach.argument,
            self.hanging.argument,
        )

    @property
    def arguments(self) -> tuple[Any, Any, Any, Any]:
        """Returns all tables as arguments of kernels."""
        return self.program.argument, self.motions.argument, self.poses.argument, self.masks.argument

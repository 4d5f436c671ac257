"""New actors stand: from the first picture on, their feet are on the ground and in reach of the hips."""

from __future__ import annotations

from typing import Any

from numba import types

from statwalk.machine.runtime.state import STATE
from statwalk.maths.clamp_table import CLAMP_TABLE
from statwalk.maths.compiling import FLOAT, kernel, write
from statwalk.maths.packed import ADDRESSES, opened
from statwalk.motion.tables.motion_tables import MOTIONS
from statwalk.solve.chains import CHAINS
from statwalk.solve.foot_tables import FEET
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.pose_offsets import OFFSETS
from statwalk.stage.steps._kernels import NONE
from statwalk.stage.steps.memory import MEMORY, memory_of
from statwalk.stage.steps.plant_feet import plant_feet

A_WHILE = 10.0
"""seconds for which new actors have stood: pelvis and ankles have long settled"""

_motions, _state, _offsets, _memory = opened(MOTIONS), opened(STATE), opened(OFFSETS), opened(MEMORY)
_feet, _chains, _clamps = opened(FEET), opened(CHAINS), opened(CLAMP_TABLE)


def stand(cast: Cast) -> None:
    """Puts the feet of new actors on the ground, as the foot lock has them after a while: changes the poses
    shown, the positions and the solvers' memory in place.
    """
    role = cast.role
    if not len(role.solvers.legs.hip):
        return
    memory = memory_of(role, len(cast.ids))
    memory.poses.values.seconds[:] = NONE  # no transition begins
    _, motions, *_ = role.packed.arguments
    feet, chains, limits, *_ = role.packed.solvers
    machine, offsets = memory.machine(cast.machine).argument, memory.offsets(cast.offsets).argument
    places = cast.position, cast.heading, cast.solver_memory
    changing = machine, offsets, memory.poses.argument, cast.shown.values
    _stand_blocks(motions, feet, chains, limits, *changing, *places)


@kernel(
    ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, ADDRESSES, write(FLOAT, 3),
    write(types.float64, 2), write(types.float64, 1), write(types.float64, 2),
)  # fmt: skip
def _stand_blocks(
    motions: Any, feet: Any, links: Any, limits: Any, machine: Any, offsets: Any, memory: Any, shown: Any,
    position: Any, heading: Any, solver_memory: Any,
) -> None:  # fmt: skip
    """Plants the feet of all blocks."""
    m, f, chains, clamps = _motions(motions), _feet(feet), _chains(links), _clamps(limits)
    s, o, mem = _state(machine), _offsets(offsets), _memory(memory)
    for block in range(shown.shape[0]):
        plant_feet(
            f, chains, clamps, m, s, o, mem, shown, position, heading, solver_memory, block, A_WHILE
        )  # fmt: skip

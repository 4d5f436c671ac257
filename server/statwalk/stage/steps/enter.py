"""New actors: the cast in which they start."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.runtime.state import fresh
from statwalk.maths.arrays import Floats
from statwalk.stage.state.cast import CastState
from statwalk.stage.state.hashing import mix
from statwalk.stage.state.pose_offsets import PoseOffsets, offset_size
from statwalk.stage.steps.sample import poses_ahead


def enter(role: Role, ids: Sequence[int], position: Floats, heading: Floats) -> CastState:
    """Returns N new actors (`ids` ascending) in the initial state of the machine, at places (N, 3) with
    headings (N,).
    """
    count, rest = len(ids), role.character.bind_pose
    machine = fresh(role.machine.program, count)
    shown = poses_ahead(role, machine, is_limited=True)
    size = offset_size(len(role.character.skeleton), rest.weights.shape[-1])
    places = np.array(position, np.float64), np.array(heading, np.float64)
    return CastState(
        ids=np.array(ids, np.int64),
        machine=machine,
        shown=shown,
        previous=shown.copy(),
        offsets=PoseOffsets.none(count, machine.state.shape[1], size),
        position=places[0],
        heading=places[1],
        root_delta=np.zeros((count, 3)),
        solver_memory=role.solver_memory.fresh(count),
        hash=mix(np.zeros(count, np.uint64), [shown.rows(), *places]),
    )

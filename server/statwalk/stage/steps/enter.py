"""New actors: the cast in which they start."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.runtime.state import fresh
from statwalk.maths.arrays import Floats
from statwalk.stage.state.cast import Cast, CastState
from statwalk.stage.state.hashing import mix
from statwalk.stage.state.pose_offsets import PoseOffsets, offset_size
from statwalk.stage.steps.sample import poses_ahead
from statwalk.stage.steps.stand import stand


def enter(
    role: Role, ids: Sequence[int], position: Floats, heading: Floats, clock: tuple[int, float] = (0, 0.0)
) -> CastState:
    """Returns N new actors (`ids` ascending) in the initial state of the machine, at places (N, 3) with
    headings (N,), with feet on the ground if the machine locks them; `clock`: the number of the tick, and the
    seconds of a tick.
    """
    count, rest = len(ids), role.character.bind_pose
    machine = fresh(role.machine.program, count)
    shown = poses_ahead(role, machine, is_limited=True, clock=clock)
    size = offset_size(len(role.character.skeleton), rest.weights.shape[-1])
    cast = Cast(
        ids=np.array(ids, np.int64),
        machine=machine,
        shown=shown,
        previous=shown,
        offsets=PoseOffsets.none(count, machine.state.shape[1], size),
        position=np.array(position, np.float64),
        heading=np.array(heading, np.float64),
        root_delta=np.zeros((count, 3)),
        solver_memory=role.solver_memory.fresh(count),
        hash=np.zeros(count, np.uint64),
        role=role,
    )
    stand(cast)
    word = mix(cast.hash, [shown.rows(), cast.position, cast.heading])
    return replace(cast.state, previous=shown.copy(), hash=word)

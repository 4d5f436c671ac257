"""Working memory of the steps of a tick.

It carries no state from one tick to the next.
"""

from __future__ import annotations

import threading
from typing import Annotated, NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from statwalk.character.role import Role
from statwalk.machine.runtime.effects import EFFECTS, effects_for
from statwalk.machine.runtime.state import STATE, MachineState
from statwalk.machine.runtime.surroundings import SURROUNDINGS, Measurements
from statwalk.maths.columns import columns
from statwalk.maths.packed import PackedColumns, packed
from statwalk.maths.pose_buffer import channels
from statwalk.maths.random import actor_keys
from statwalk.maths.simd.aligned import zeros
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import blocks, zero_blocks
from statwalk.rig.hierarchy import MATRIX
from statwalk.rig.model_buffer import ModelBuffer
from statwalk.solve.chain_lanes import scratch_floats
from statwalk.solve.chains import input_rows
from statwalk.solve.hanging import hanging_scratch
from statwalk.solve.spring_lanes import spring_scratch
from statwalk.stage.state.pose_offsets import OFFSETS, PoseOffsets
from statwalk.stage.steps.offset_lanes import scratch_size


class PoseMemory(NamedTuple):
    """Working memory for N actors in L layers; poses of one block of sixteen actors."""

    coming: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses of this tick"""
    following: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses of the motions a tick later"""
    over: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses of an upper layer"""
    first: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses at the beginning of an upper layer's motions"""
    rows: Annotated[NDArray[np.float32], "number"]
    """packed rows of the sampler"""
    weights: Annotated[NDArray[np.float64], "member"]
    """weights of the clips of a blend space"""
    scratch: Annotated[NDArray[np.float32], "row, lane"]
    """working rows of pose offsets"""
    springs: Annotated[NDArray[np.float32], "number"]
    """working rows of springs"""
    layer_weight: Annotated[NDArray[np.float64], "actor, layer"]
    ahead: Annotated[NDArray[np.float64], "actor, layer"]
    """seconds into the motions a tick later"""
    model: Annotated[NDArray[np.float32], "block, joint, number, lane"]
    """the joints of colliders in model space, of all actors (`rig.model_buffer`)"""
    legs: Annotated[NDArray[np.float32], "block, joint, number, lane"]
    """the joints of legs in model space, before feet are planted"""
    leg_rows: Annotated[NDArray[np.float32], "foot, row, lane"]
    """inputs and outputs of the legs' chains (`solve.chains`)"""
    reach_rows: Annotated[NDArray[np.float32], "solver, row, lane"]
    """inputs and outputs of the chains of a machine file's solvers"""
    reach_joints: Annotated[NDArray[np.float32], "block, joint, number, lane"]
    """the starts and ends of force solvers in model space"""
    hanging: Annotated[NDArray[np.float32], "number"]
    """working rows of hanging chains"""
    chain: Annotated[NDArray[np.float32], "number"]
    """memory of the solver of chains"""
    old_state: Annotated[NDArray[np.int64], "actor, layer"]
    """at the tick before"""
    part_before: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses that the jump of one layer is taken from (see `offset_apart`): two ticks before this one"""
    part_shown: Annotated[NDArray[np.float32], "1, channel, lane"]
    """one tick before"""
    part_coming: Annotated[NDArray[np.float32], "1, channel, lane"]
    """in this tick"""
    part_following: Annotated[NDArray[np.float32], "1, channel, lane"]
    """a tick later"""
    uncut_before: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses two ticks before, as if the motions of layers that cut in this tick had played then"""
    uncut_shown: Annotated[NDArray[np.float32], "1, channel, lane"]
    """the poses one tick before, in the same way"""
    mixed_state: Annotated[NDArray[np.int64], "actor, layer"]
    """old motions of some layers beside new motions of others"""
    mixed_time: Annotated[NDArray[np.float64], "actor, layer"]
    seconds: Annotated[NDArray[np.float64], "actor, layer"]
    """duration of the transitions that begin; below 0: none begins"""
    quintic: Annotated[NDArray[np.bool_], "actor, layer"]
    clock: Annotated[NDArray[np.float64], "2"]
    """the number of this tick, and the seconds of a tick"""
    express_values: Annotated[NDArray[np.float64], "slot"]
    """the values of expressions, of one actor at a time"""
    express_stack: Annotated[NDArray[np.float64], "number"]


MEMORY = columns(PoseMemory)
"""the type of PoseMemory in kernels"""
BLOCKS = (
    *("coming", "following", "over", "first"),
    *("part_before", "part_shown", "part_coming", "part_following", "uncut_before", "uncut_shown"),
)
"""the fields that hold poses of one block"""


class Memory:
    """The packed memory of one role in one thread."""

    def __init__(self, role: Role, actors: int) -> None:
        layers, program = len(role.machine.layers), role.machine.program
        self.actors = actors
        self.model = ModelBuffer.room(role.colliders.joints, actors)
        self.poses = packed(_pose_memory(role, actors, layers, self.model), MEMORY)
        self.effects = packed(effects_for(program, actors), EFFECTS)
        self.surroundings = packed(Measurements.none(actors), SURROUNDINGS)
        self._keyed: tuple[NDArray[np.int64], int] | None = None
        self._machine: PackedColumns[MachineState] | None = None
        self._offsets: PackedColumns[PoseOffsets] | None = None

    def key(self, ids: NDArray[np.int64], seed: int) -> None:
        """Writes the random keys of the actors, if the actors or the seed have changed."""
        if self._keyed is None or self._keyed[0] is not ids or self._keyed[1] != seed:
            self.surroundings.values.key[:] = actor_keys(seed, ids)
            self._keyed = ids, seed

    def machine(self, state: MachineState) -> PackedColumns[MachineState]:
        """Returns the packed state; packs only a new state."""
        if self._machine is None or self._machine.values is not state:
            self._machine = packed(state, STATE)
        return self._machine

    def offsets(self, offsets: PoseOffsets) -> PackedColumns[PoseOffsets]:
        """Returns the packed pose offsets; packs only new offsets."""
        if self._offsets is None or self._offsets.values is not offsets:
            self._offsets = packed(offsets, OFFSETS)
        return self._offsets


def _pose_memory(role: Role, actors: int, layers: int, model: ModelBuffer) -> PoseMemory:
    room, motions = channels(role.character.bind_pose), role.tables
    poses = {name: zero_blocks(1, room) for name in BLOCKS}
    return PoseMemory(
        **poses,
        rows=zeros(motions.memory),
        weights=np.zeros(motions.most_members),
        scratch=zeros(scratch_size(layers) * LANES).reshape(-1, LANES),
        springs=zeros(spring_scratch(len(role.solvers.springs.joint))),
        layer_weight=np.zeros((actors, layers)),
        ahead=np.zeros((actors, layers)),
        legs=_matrices(actors, len(role.solvers.legs.joints)),
        leg_rows=input_rows(1, len(role.solvers.legs.hip))[0],
        reach_rows=input_rows(1, len(role.solvers.reach.memory))[0],
        reach_joints=_matrices(actors, len(role.solvers.reach.joints)),
        hanging=zeros(hanging_scratch(_most_joints(role) if len(role.solvers.hanging.chain) else 0)),
        chain=zeros(scratch_floats(_most_joints(role))),
        old_state=np.zeros((actors, layers), np.int64),
        mixed_state=np.zeros((actors, layers), np.int64),
        mixed_time=np.zeros((actors, layers)),
        model=model.values,
        seconds=np.zeros((actors, layers)),
        quintic=np.zeros((actors, layers), bool),
        clock=np.zeros(2),
        express_values=np.zeros(role.expressions.values),
        express_stack=np.zeros(role.expressions.deepest),
    )


def _most_joints(role: Role) -> int:
    """The most joints of a chain."""
    return int(np.diff(role.solvers.chains.first).max(initial=0))


def _matrices(actors: int, joints: int) -> NDArray[np.float32]:
    shape = blocks(actors), joints, MATRIX, LANES
    return zeros(int(np.prod(shape))).reshape(shape)


_KEPT = threading.local()


def memory_of(role: Role, actors: int) -> Memory:
    """Returns the memory for a cast of a role: the memory of the last tick in this thread, if the number of
    actors is the same.
    """
    kept: WeakKeyDictionary[Role, Memory] | None = getattr(_KEPT, "memory", None)
    if kept is None:
        kept = _KEPT.memory = WeakKeyDictionary()
    memory = kept.get(role)
    if memory is None or memory.actors != actors:
        memory = kept[role] = Memory(role, actors)
    return memory

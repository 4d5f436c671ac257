"""Migration to another version of a role during play: every actor keeps its state, and the shown pose
does not jump.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.character.role import Role
from statwalk.character.solvers import forget_feet
from statwalk.errors import StageError
from statwalk.maths.arrays import Ints
from statwalk.maths.pose_buffer import PoseBuffer
from statwalk.maths.simd.aligned import zeros
from statwalk.maths.simd.lanes import LANES
from statwalk.stage.migrate.map_states import MigratedState, remap
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.pending_events import EVENT_IS_GONE, STATE_IS_GONE, STATE_IS_RENAMED, Notice
from statwalk.stage.state.pose_offsets import PoseOffsets, Transitions
from statwalk.stage.steps.offset_begin import begin
from statwalk.stage.steps.offset_lanes import scratch_size
from statwalk.stage.steps.sample import poses_ahead


def check_joints(old: Role, new: Role) -> None:
    """Checks that a new version has the joints of the old version, between which poses can be blended.

    :raises StageError: when the new version has other joints.
    """
    joints = [role.character.skeleton for role in (old, new)]
    if (
        joints[0].names != joints[1].names
        or old.character.bind_pose.weights.shape != new.character.bind_pose.weights.shape
    ):
        raise StageError(f"the new version of {old.name} has other joints; an edit keeps the character")


def edited(cast: Cast, role: Role, dt: float) -> tuple[Cast, list[Notice]]:
    """Returns the cast in another version of its role, and notices to its actors.

    If the next tick would show another pose than before, a transition begins: over the default blend, from
    the shown pose.
    """
    migrated = remap(cast.role.machine, role.machine, cast.machine)
    offsets, lost = _layered(cast, role)
    new, following = (poses_ahead(role, migrated.state, ticks * dt) for ticks in (1, 2))
    rows = np.union1d(_differing(poses_ahead(cast.role, cast.machine, dt), new), lost)
    seconds = role.definition.defaults.blend
    kept = role.solver_memory.migrated(cast.role.solver_memory, cast.solver_memory)
    after = replace(cast, role=role, machine=migrated.state, offsets=offsets, solver_memory=kept)
    if len(rows) and seconds > 0:
        begun = _begun(after, rows, seconds, (new, following), dt)
        after = replace(after, offsets=begun, solver_memory=forget_feet(role.solvers, kept, rows))
    return after, _notices(cast, after, migrated)


def _layered(cast: Cast, role: Role) -> tuple[PoseOffsets, Ints]:
    """The pose offsets in the layers of the new version, and the rows with an offset in a layer
    that is gone.
    """
    old, new = ([layer.name for layer in version.machine.layers] for version in (cast.role, role))
    gone = [layer for layer, name in enumerate(old) if name not in new]
    lost = np.flatnonzero(cast.offsets.is_under_way[:, gone].any(1))
    return cast.offsets.with_layers([old.index(name) if name in old else -1 for name in new]), lost


def _differing(old: PoseBuffer, new: PoseBuffer) -> Ints:
    """The rows in which two poses differ in any bit."""
    rows_of_difference: Ints = (old.rows() != new.rows()).any(1).nonzero()[0]
    return rows_of_difference


def _begun(
    cast: Cast, rows: Ints, seconds: float, poses: tuple[PoseBuffer, PoseBuffer], dt: float
) -> PoseOffsets:
    """One transition of all layers together, instead of all transitions of the rows; `poses`: poses of the
    new motions in one and two ticks.
    """
    offsets, layers = cast.offsets.copy(), cast.offsets.elapsed.shape[1]
    offsets.end(rows)
    begins = Transitions(np.full((len(cast.ids), layers), -1.0), np.zeros((len(cast.ids), layers), bool))
    begins.seconds[rows, 0] = seconds
    buffers = cast.previous.values, cast.shown.values, poses[0].values, poses[1].values
    scratch, block = zeros(scratch_size(layers) * LANES).reshape(-1, LANES), 0
    while True:
        block = begin(offsets, begins, cast.role.layer_masks, *buffers, cast.root_delta, dt, block, scratch)
        if block == len(cast.shown.values):
            return offsets
        offsets = offsets.grown()


def _notices(before: Cast, after: Cast, migrated: MigratedState) -> list[Notice]:
    """The notices to actors: the states they had to leave or have under another name, and the events they
    lost.
    """
    old, new = before.role.machine, after.role.machine
    layers, ids, notices = [layer.name for layer in old.layers], before.ids.tolist(), []
    for layer, row in np.ndindex(len(new.layers), len(ids)):
        if (name := new.layers[layer].name) in layers:
            was = old.states[before.machine.state[row, layers.index(name)]]
            comes = new.states[after.machine.state[row, layer]]
            reason = STATE_IS_GONE if (row, layer) in migrated.displaced else STATE_IS_RENAMED
            if was != comes:
                notices.append(Notice(ids[row], EDIT, -1, reason, layer, was, comes))
    return notices + [
        Notice(ids[row], old.events[event], -1, EVENT_IS_GONE) for row, _, event in migrated.lost
    ]


EDIT = "EDIT"
"""event name of a notice about an actor's state after an edit"""

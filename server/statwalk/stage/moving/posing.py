"""The local poses that motions give, all layers over one another, without what is left of transitions."""

from __future__ import annotations

import numpy as np

from statwalk.machine.ticking.state import MachineState
from statwalk.machine.ticking.step import speeds
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.easing import clamp01
from statwalk.maths.pose import Pose
from statwalk.motion.layering import additive, override
from statwalk.stage.role import Role


def composite(role: Role, state: MachineState) -> Pose:
    """Poses (N, …) of actors whose machines are in `state`."""
    return _at(role, state, state.time)


def ahead(role: Role, state: MachineState, seconds: float) -> Pose:
    """The poses (N, …) that the motions come to in so many seconds, if nothing else happens."""
    machine = role.machine
    times = state.time + seconds * (speeds(machine, state) * rates(role, state, seconds))
    duration = machine.duration[state.state]
    loops = machine.loop[state.state] & (duration > 0)
    return _at(role, state, np.where(loops, np.mod(times, np.where(duration > 0, duration, 1)), times))


def rates(role: Role, state: MachineState, seconds: float) -> Floats:
    """(N, L) factor of time of each motion, beside its speed, for so many seconds: clips that are blended share a lap."""
    factor = np.ones(state.state.shape)
    if role.blends:
        way = seconds * speeds(role.machine, state)
        for row in np.unique(state.state):
            motion, at = role.motions[row], (state.state == row).nonzero()
            if motion is not None:
                factor[at] = motion.rate(state.time[at], way[at], state.smoothed[at[0]])
    return factor


def _at(role: Role, state: MachineState, times: Floats) -> Pose:
    """Poses at `times` (N, L) seconds into the motions."""
    pose = _sampled(role, state.state[:, 0], times[:, 0], state.smoothed)
    for layer in range(1, len(role.machine.layers)):
        pose = _laid(role, layer, pose, state, times[:, layer])
    return pose


def _sampled(role: Role, states: Ints, times: Floats, parameters: Floats, first: bool = False) -> Pose:
    """Poses (N, …) of one layer: those who play the same motion at once. `first`: those that the motions begin with."""

    def play(state: int, rows: Ints | slice) -> Pose:
        motion = role.motions[state]
        assert motion is not None  # who has none is not asked
        found: Pose = motion.first(parameters[rows]) if first else motion.pose(times[rows], parameters[rows])
        return found

    if (states == states[0]).all():
        return play(states[0], slice(None))
    pose = Pose(*(np.empty((len(states), *array.shape), np.float32) for array in role.character.bind_pose))
    for state in np.unique(states):
        rows = (states == state).nonzero()[0]
        for array, part in zip(pose, play(state, rows), strict=True):
            array[rows] = part
    return pose


def _laid(role: Role, layer: int, under: Pose, state: MachineState, times: Floats) -> Pose:
    """The poses with one layer over them, of those in whom it plays something."""
    one, states = role.machine.layers[layer], state.state[:, layer]
    given = state.smoothed[:, one.weight_parameter] if one.weight_parameter >= 0 else np.full(len(states), one.weight)
    weight = clamp01(given)
    rows = (role.plays[states] & (weight > 0)).nonzero()[0]
    if not len(rows):
        return under
    asked = states[rows], times[rows], state.smoothed[rows]
    over, below = _sampled(role, *asked), under.take(rows)
    if one.mode == "additive":
        laid = additive(below, over, _sampled(role, *asked, first=True), weight[rows], role.masks[layer])
    else:
        laid = override(below, over, weight[rows], role.masks[layer])
    if len(rows) == len(states):
        return laid
    whole = under.copy()
    for array, part in zip(whole, laid, strict=True):
        array[rows] = part
    return whole

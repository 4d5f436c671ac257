"""A state's motion by itself: what transitions are measured against."""

from __future__ import annotations

import numpy as np

from statwalk.character.role import Role
from statwalk.machine.runtime.state import fresh
from statwalk.maths.arrays import Floats
from statwalk.motion.blend_space import BlendSpace
from statwalk.motion.root_track import compose
from statwalk.stage.measure.trials import RATE, machines_at, placed, world_of
from statwalk.stage.steps.sample import poses_ahead


def entries_of(role: Role, state: int) -> list[Floats]:
    """Returns the rows (P + V,) of parameters and entry values that matter for a state's motion by itself: of
    a motion that is blended over entry values one for each clip, else one with the defaults.
    """
    motion, kept = role.motions[state], len(role.machine.parameters)
    row = fresh(role.machine.program, 1).smoothed[0]
    if not isinstance(motion, BlendSpace) or max(motion.columns) < kept:
        return [row]
    rows = np.tile(row, (len(motion.places), 1))
    for axis, column in enumerate(motion.columns):
        if column >= kept:
            rows[:, column] = motion.places[:, axis]
    return list(rows)


def _times_alone(role: Role, state: int, offset: float, axes: Floats, end: float) -> Floats:
    """The seconds into a state's motion at every tick until `end`; for a blend, the seconds into its longest
    clip, which pass at the pace of the blend.
    """
    motion = role.motions[state]
    if not isinstance(motion, BlendSpace):
        return np.arange(offset, end + 1e-9, 1 / RATE)
    times, time, step = list[float](), 0.0, offset
    while len(times) <= end * RATE:
        pace = motion.rate(np.array([time]), np.array([step]), axes[None]) if step > 0 else np.ones(1)
        time, step = time + step * float(pace[0]), 1 / RATE
        if time > end + 1e-9:
            break
        times.append(time)
    return np.array(times)


def motion_alone(role: Role, state: int, offset: float, axes: Floats | None = None) -> Floats:
    """Returns the joints (T, J, 3) of a state's motion by itself, a tick at a time from `offset` seconds on;
    a motion that loops plays twice, a blend at the pace of its clips.

    `axes` (P + V,): parameters and entry values, see `entries_of`; default: the first of them.
    """
    machine = role.machine
    axes = entries_of(role, state)[0] if axes is None else axes
    duration = float(machine.duration[state]) if np.isfinite(machine.duration[state]) else 1.0
    times = _times_alone(role, state, offset, axes, duration * (1 + bool(machine.loop[state])))
    wrapped = np.mod(times, duration) if machine.loop[state] and duration > 0 else np.minimum(times, duration)
    machines = machines_at(role, np.full(len(times), state), wrapped)
    machines.smoothed[:] = axes
    world = world_of(role, poses_ahead(role, machines).rows())
    place = np.zeros((len(times), 3))
    motion = role.motions[state]
    for k in range(1, len(times)):
        if motion is None or machine.layer_of[state]:
            break
        wraps = np.array([int(wrapped[k] < wrapped[k - 1])])
        delta = motion.way(wrapped[k - 1 : k], wrapped[k : k + 1], wraps, axes[None])
        place[k] = compose(place[k - 1 : k], delta)[0]
    position = np.stack([place[:, 0], 0 * place[:, 0], place[:, 1]], -1)
    return placed(world[..., 3].astype(np.float64), position, place[:, 2])

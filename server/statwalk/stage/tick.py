"""One tick: what statwalk does, on one page. Pure: no clock, no file, no chance; the same state and events give the same bits.

The numbers are those of the design. What has no step yet (expressions, limits, reach, senses) has no line.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.machine.step import Changes, Inputs, StepResult, Surroundings, speeds, step
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion import inertialize
from statwalk.motion.root import compose
from statwalk.stage.cast import Cast
from statwalk.stage.hash import chance_keys
from statwalk.stage.role import Role
from statwalk.stage.travel import way_gone


def tick(cast: Cast, inputs: Inputs, dt: float, now: int, seed: int) -> tuple[Cast, StepResult]:
    """The cast one step of `dt` seconds later, as tick `now`, and what its machines did."""
    # 1 advance: motions move on; 2 decide: every event is looked up in the table, END last
    nothing = Surroundings.none(*cast.machine.state.shape)
    done = step(cast.role.machine, cast.machine, dt, now, inputs, nothing._replace(key=chance_keys(seed, cast.ids)))
    machine = done.state

    # 3 sample: the local pose of each actor's motion, at its time
    pose = sample(cast.role, machine.state[:, 0], machine.time[:, 0])

    # 4 blend: what would jump becomes an offset of the pose that was shown, and dies out; the root's velocity goes over into the new one
    fading = cast.fading
    turned, duration = _turned(done.changes)
    rows = turned[duration > 0]  # a blend of 0 s adds nothing to what is still dying out
    if len(rows):
        jump = _jump(cast, done, rows, pose.take(rows), dt)
        fading = fading.begun(rows, duration[duration > 0], jump, cast.way[rows])
    fading = fading.advanced(dt)
    shown = fading.on(pose)
    way = fading.blended_way(way_gone(cast, done, turned))
    place = compose(np.stack([cast.position[:, 0], cast.position[:, 2], cast.heading], -1), way)
    position = np.stack([place[:, 0], cast.position[:, 1], place[:, 1]], -1)

    # 7 world and 9 skin are worked out for those who look (Actor.world, Actor.vertices, the web floor's frames)
    after = replace(cast, machine=machine, shown=shown, before=cast.shown, fading=fading, position=position, heading=place[:, 2], way=way)
    return after.rehashed(), done


def sample(role: Role, states: Ints, times: Floats) -> Pose:
    """Local poses (N, …) of actors in `states` (N,) at `times` (N,) seconds: those that play the same motion at once."""
    if (states == states[0]).all():
        only: Pose = role.clips[states[0]].sample(times)
        return only
    pose = Pose(*(np.empty((len(states), *array.shape), np.float32) for array in role.clips[0].rest))
    for state in np.unique(states):
        rows = (states == state).nonzero()[0]
        for array, part in zip(pose, role.clips[state].sample(times[rows]), strict=True):
            array[rows] = part
    return pose


def _turned(changes: Changes) -> tuple[Ints, Floats]:
    """Rows (n,) whose motion began in this tick, and for how many seconds (n,) each blends: as its last change says."""
    rows, last = np.unique(changes.actor[::-1], return_index=True)
    return rows, changes.blend[::-1][last].astype(np.float64)


def _jump(cast: Cast, done: StepResult, rows: Ints, pose: Pose, dt: float) -> tuple[Floats, Floats]:
    """The offset, and its velocity, that carry what was shown of `rows` over into their new motions."""
    states, times = done.state.state[rows, 0], done.state.time[rows, 0]
    speed = speeds(cast.role.machine, done.state)[rows, 0]
    following = sample(cast.role, states, time_after(cast.role, states, times + dt * speed))
    return inertialize.transition(cast.before.take(rows), cast.shown.take(rows), pose, following, dt)


def time_after(role: Role, states: Ints, times: Floats) -> Floats:
    """Times (N,) with those of motions that loop brought back into them."""
    duration = role.machine.duration[states]
    return np.where(role.machine.loop[states] & (duration > 0), np.mod(times, np.where(duration > 0, duration, 1)), times)

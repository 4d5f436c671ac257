"""One tick: what statwalk does, on one page. Pure: no clock, no file, no chance; the same state and events give the same bits.

The numbers are those of the design. What has no step yet (expressions, limits, reach) has no line; 10 sense is for the whole stage (fold).
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from statwalk.machine.ticking.step import Inputs, StepResult, step
from statwalk.motion.root import compose
from statwalk.stage.cast import Cast
from statwalk.stage.moving.posing import composite
from statwalk.stage.moving.rootway import way_gone
from statwalk.stage.moving.surroundings import surroundings
from statwalk.stage.moving.turning import faded, turned


def tick(cast: Cast, inputs: Inputs, dt: float, now: int, seed: int) -> tuple[Cast, StepResult]:
    """The cast one step of `dt` seconds later, as tick `now`, and what its machines did."""
    # 1 advance: motions move on; 2 decide: every event is looked up in the table, END last
    done = step(cast.role.machine, cast.machine, dt, now, inputs, surroundings(cast, dt, seed))

    # 3 sample: the local pose of each actor's motions at their times, those of upper layers over those of lower ones
    pose = composite(cast.role, done.state)

    # 4 blend: what would jump becomes an offset of the pose that was shown, and dies out; the root's velocity goes over into the new one
    turns = turned(done.changes, len(cast.role.machine.layers))
    fading = faded(cast, done.state, pose, turns, dt).advanced(dt)
    shown = fading.on(pose)
    way = fading.blended_way(way_gone(cast, done, turns.of_base))
    place = compose(np.stack([cast.position[:, 0], cast.position[:, 2], cast.heading], -1), way)
    position = np.stack([place[:, 0], cast.position[:, 1], place[:, 1]], -1)

    # 7 world and 9 skin are worked out for those who look (Actor.world, Actor.vertices, the web floor's frames)
    after = replace(
        cast, machine=done.state, shown=shown, before=cast.shown, fading=fading, position=position, heading=place[:, 2], way=way
    )
    return after.rehashed(), done

"""What machines are told beside their inputs: the pace of their motions, how their actors move, and what their chance hangs on."""

from __future__ import annotations

import numpy as np

from statwalk.machine.ticking.step import Surroundings
from statwalk.maths.arrays import Floats
from statwalk.stage.cast import Cast
from statwalk.stage.hash import chance_keys
from statwalk.stage.moving.posing import rates


def surroundings(cast: Cast, dt: float, seed: int) -> Surroundings:
    """Of all actors of a cast, as they were shown at the tick before this one."""
    way = cast.way
    speed = np.sqrt(way[:, 0] * way[:, 0] + way[:, 1] * way[:, 1]) / dt
    measured = np.stack([speed, way[:, 2] / dt, cast.position[:, 1] + root_height(cast)])
    return Surroundings(rates(cast.role, cast.machine, dt), measured, chance_keys(seed, cast.ids))


def root_height(cast: Cast) -> Floats:
    """(N,) metres from an actor's place up to its root joint; 0 where the machine names none."""
    if cast.role.root < 0:
        return np.zeros(len(cast.ids))
    at = cast.shown.translation[:, cast.role.root].astype(np.float64)
    frame = cast.role.root_frame
    if frame is None:
        return at[:, 1]
    height: Floats = frame[1, 0] * at[:, 0] + frame[1, 1] * at[:, 1] + frame[1, 2] * at[:, 2] + frame[1, 3]
    return height

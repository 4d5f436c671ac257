"""The flight of flocks: the part of a stage's state that flocks keep."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats


class Flight(NamedTuple):
    """The flight of the members of one flock."""

    role: str
    ids: NDArray[np.int64]
    """(N,) ascending"""
    velocity: Floats
    """(N, 3) metres per second"""
    forward: Floats
    """(N, 3) unit"""


Flights = tuple[Flight, ...]

"""How far a foot that is in a step is moved aside, against how deep it was put there."""

from __future__ import annotations

import numpy as np
import pytest
from foot_at_step import EDGE, FEET, FRONT_BESIDE, HEIGHT, LOWEST, ON_THE_FLOOR, legs_at
from foot_kernels import aside
from statwalk.solve.foot_aside import ROOM


def moved_aside(y: float, z: float) -> np.ndarray:
    out = np.zeros(2)
    aside(FEET, legs_at(y, z), out)
    return out


def test_a_foot_before_the_step_stays_where_it_is() -> None:
    assert not moved_aside(ON_THE_FLOOR, EDGE - FRONT_BESIDE - ROOM - 0.001).any()


@pytest.mark.parametrize("deep", [0.001, 0.02, 0.08])
def test_a_foot_in_the_step_is_moved_out_the_way_it_came_in(deep: float) -> None:
    assert moved_aside(ON_THE_FLOOR, EDGE - FRONT_BESIDE + deep) == pytest.approx([0, -deep - ROOM], abs=1e-6)


def test_a_foot_above_the_step_is_not_moved() -> None:
    assert not moved_aside(HEIGHT - LOWEST, EDGE).any()


def test_the_way_out_ends_evenly_as_the_foot_rises() -> None:
    heights = np.linspace(0, HEIGHT, 121)
    ways = np.array([moved_aside(ON_THE_FLOOR + up, EDGE - FRONT_BESIDE + 0.05)[1] for up in heights])
    assert (ways[0], ways[-1]) == (pytest.approx(-0.05 - ROOM, abs=1e-6), 0)
    assert np.abs(np.diff(ways)).max() < 0.004

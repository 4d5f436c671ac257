"""A leg is as straight as its motion has it, though its solver eases towards full stretch: against the
formula of the softening.
"""

from __future__ import annotations

import numpy as np
import pytest
from foot_at_step import FEET, legs_at
from foot_kernels import stretched
from statwalk.solve.foot_stretch import SOFTENING

LEGS = legs_at(0.0, 0.0)
"""the hip is at the origin"""
LENGTH = float(FEET.length[0])
ZONE = LENGTH * SOFTENING


def put(animated: float, wanted: float, drop: float = 0.0, left: float = 1.0) -> float:
    return float(stretched(FEET, LEGS, animated * LENGTH, drop, left, wanted * LENGTH))


def softened(distance: float) -> float:
    """What the solver makes of a distance (docs/ik.md)."""
    beyond = max(distance - (LENGTH - ZONE), 0.0) / ZONE
    return min(distance, LENGTH - ZONE) + ZONE * (1 - 1 / (1 + beyond / 4) ** 4)


@pytest.mark.parametrize("animated", [0.985, 0.99, 0.999])
@pytest.mark.parametrize("drop", [0.0, 0.03])
def test_as_far_as_in_its_motion_the_leg_comes_wholly(animated: float, drop: float) -> None:
    wanted = np.linspace(0.9, animated, 50)
    came = [softened(put(animated, part, drop)) / LENGTH for part in wanted]
    np.testing.assert_allclose(came, wanted, atol=1e-9)


def test_farther_than_in_its_motion_it_eases_to_full_stretch() -> None:
    came = np.array([softened(put(0.985, part)) for part in np.linspace(0.985, 1.2, 200)]) / LENGTH
    assert (np.diff(came) > 0).all()
    assert came.max() < 1
    assert came[1] - came[0] < (1.2 - 0.985) / 199


def test_a_bent_leg_keeps_its_target() -> None:
    assert put(0.9, 1.1) == pytest.approx(1.1 * LENGTH, abs=1e-12)


def test_a_straight_leg_is_softened_a_little() -> None:
    assert 0.999 < softened(put(1.0, 1.0)) / LENGTH < 1


def test_it_goes_over_to_the_softening_as_the_offset_dies_out() -> None:
    came = [softened(put(0.99, 0.99, left=left)) / LENGTH for left in np.linspace(0, 1, 20)]
    assert came[0] == pytest.approx(softened(0.99 * LENGTH) / LENGTH)
    assert came[-1] == pytest.approx(0.99)
    assert (np.diff(came) > 0).all()

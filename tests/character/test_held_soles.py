"""A sole that stands does not slide: an ankle that is carried too far by hand."""

import builders
import numpy as np
from statwalk.character.body import Body
from statwalk.character.carried_soles import Sole
from statwalk.character.held_soles import held

STILL = np.array([0.0, 0, 0, 1])
BODY = Body(builders.character(), {"LeftFoot": 0}, np.zeros((3, 3)), np.tile(STILL, (3, 1)), STILL)
SOLE = Sole("LeftFoot", "", np.array([[0, -0.1, 0.0]]), np.zeros((0, 3)), np.zeros(3), 0.0)
FRAMES = 100
TURNS = {"LeftFoot": np.tile(STILL, (FRAMES, 1))}
STANDS = (np.arange(FRAMES) < 40) | (np.arange(FRAMES) >= 60)
DRIFTING = np.stack([0 * np.arange(FRAMES), np.full(FRAMES, 0.1), 0.001 * np.arange(FRAMES)], -1)
"""metres: 4 cm in each of two contacts"""


def test_a_foot_that_stands_stays_where_it_was_on_average() -> None:
    kept = held(BODY, SOLE, TURNS, DRIFTING, STANDS)
    np.testing.assert_allclose(kept[:40, 2], DRIFTING[:40, 2].mean(), atol=1e-12)
    np.testing.assert_allclose(kept[60:, 2], DRIFTING[60:, 2].mean(), atol=1e-12)


def test_in_the_air_it_goes_over_without_a_jump() -> None:
    kept = held(BODY, SOLE, TURNS, DRIFTING, STANDS)
    steps = np.diff(kept[:, 2])
    assert (steps >= 0).all()
    assert steps.max() < 0.004  # 6 cm in 21 frames: 2.9 mm on average


def test_its_height_stays() -> None:
    np.testing.assert_array_equal(held(BODY, SOLE, TURNS, DRIFTING, STANDS)[:, 1], DRIFTING[:, 1])


def test_a_foot_that_never_stands_goes_where_it_went() -> None:
    np.testing.assert_array_equal(held(BODY, SOLE, TURNS, DRIFTING, ~STANDS & STANDS), DRIFTING)

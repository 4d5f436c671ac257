"""When the foot of a captured motion stands: feet whose steps are known by hand."""

import numpy as np
import pytest
from statwalk.character.captured_steps import steps_of

LEG = 0.8
TIMES = np.arange(241) / 120
"""two seconds: the foot stands for 0.6 s, goes 0.7 m in 0.4 s, and so on"""


def stepping(lift: float = 0.1, floor: float = 0.0) -> np.ndarray:
    """The places of an ankle that stands 0.09 m above the floor, which rises by `floor` metres a second."""
    part = np.clip((TIMES % 1 - 0.6) / 0.4, 0, 1)
    way = 0.7 * (np.floor(TIMES) + part * part * (3 - 2 * part))
    height = 0.09 + lift * np.sin(np.pi * part) ** 2 + floor * TIMES
    return np.stack([np.zeros_like(way), height, way], -1)


def stands_at(place: np.ndarray) -> list[bool]:
    """Whether the foot stands in the middle of each phase: stand, step, stand, step."""
    stands = steps_of([place], LEG, TIMES).stands
    return [bool(stands[round(time * 120)]) for time in (0.3, 0.8, 1.3, 1.8)]


def test_a_foot_stands_where_it_is_low_and_slow() -> None:
    assert stands_at(stepping()) == [True, False, True, False]


def test_a_foot_that_drags_does_not_stand() -> None:
    assert stands_at(stepping(lift=0.0)) == [True, False, True, False]


def test_a_floor_may_rise_under_the_feet() -> None:
    assert stands_at(stepping(floor=0.02)) == [True, False, True, False]


def test_a_foot_that_is_held_up_does_not_stand() -> None:
    place = stepping()
    place[130:, 1] += 0.2
    assert not steps_of([place], LEG, TIMES).stands[140:200].any()


def test_on_tiptoe_the_toes_stand() -> None:
    ankle, toes = stepping(), stepping()
    ankle[:72, 1] += np.linspace(0, 0.12, 72)  # metres: the heel comes up
    assert steps_of([ankle, toes], LEG, TIMES).stands[10:70].all()
    assert steps_of([ankle, toes], LEG, TIMES).above[10:70].max() == 0


def test_a_foot_in_the_air_is_clear_of_the_ground() -> None:
    above = steps_of([stepping(lift=0.0)], LEG, TIMES).above
    assert above[96] == pytest.approx(0.015 * LEG)
    assert above[36] == 0


def test_one_frame_has_no_speed() -> None:
    steps = steps_of([stepping()[:1]], LEG, TIMES[:1])
    assert steps.stands.tolist() == [True]

"""Stages that cost too much slow down until all fit; those that need little keep their pace."""

import pytest
from hypothesis import given
from hypothesis import strategies as some
from statwalk.services.hosting.pacing import (
    FORGET_SECONDS,
    LOOK_SECONDS,
    SLOWEST,
    TICKS,
    Pacing,
    TickCost,
    fair_share,
)

LOADS = some.lists(some.floats(0.001, 50.0), min_size=1, max_size=20)


@given(LOADS, some.floats(0.1, 1.0))
def test_together_they_take_as_much_as_they_may_and_no_more(loads: list[float], most: float) -> None:
    share = fair_share(loads, most)
    assert sum(min(load, share) for load in loads) == pytest.approx(min(sum(loads), most))


@given(LOADS, some.floats(0.1, 1.0))
def test_who_needs_less_than_an_equal_part_gets_it(loads: list[float], most: float) -> None:
    share = fair_share(loads, most)
    assert all(load <= share for load in loads if load <= most / len(loads))


def test_a_costly_stage_slows_down_and_its_neighbour_does_not() -> None:
    pacing = Pacing(0.8)
    now = 0.0
    for _ in range(10):
        now += LOOK_SECONDS
        costly, neighbour = pacing.pace("costly", 3.0, now), pacing.pace("neighbour", 0.02, now)
    assert (costly, neighbour) == (pytest.approx(0.78 / 3), 1.0)


def test_who_is_gone_has_no_share() -> None:
    pacing = Pacing(0.8)
    for stage in ("a", "b"):
        pacing.pace(stage, 0.8, 0.0)
    assert pacing.pace("a", 0.8, LOOK_SECONDS * 1.1) == pytest.approx(0.5)
    assert pacing.pace("a", 0.8, FORGET_SECONDS + LOOK_SECONDS) == 1.0


def test_no_stage_stands_still() -> None:
    assert Pacing(0.8).pace("a", 1e6, 0.0) == SLOWEST


def test_one_slow_tick_among_many_costs_nothing() -> None:
    cost = TickCost()
    for _ in range(TICKS - 1):
        cost.add(0.002, 2)
    assert cost.median() == pytest.approx(0.001)
    cost.add(10.0, 1)
    assert cost.median() == pytest.approx(0.001)

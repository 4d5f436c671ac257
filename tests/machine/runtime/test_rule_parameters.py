"""Parameters: set from outside, smooth where they say so; speeds and conditions see them smoothed."""

import math

import numpy as np
import pytest
from ticking import DT, Ticking

TABLE = "state | GO\nwalk | walk"
MORE = (
    "parameters:\n  pace: {default: 1, min: 0, max: 4, smooth: 0.25}\n  other: {default: 0, min: 0, max: 9}\n"
)
OMEGA = 6.6383521 / 0.25  # (1 + x) e^-x = 0.01


def actor_of(ticks=600.0):
    actor = Ticking(TABLE, {"walk": ticks}, MORE)
    actor.change("speed_parameter", {0: 0})
    return actor


def values(actor, count):
    """Value and rate of pace after each of so many ticks."""
    found = []
    for _ in range(count):
        actor.step()
        found.append((float(actor.memory.smoothed[0, 0]), float(actor.memory.smoothed_rate[0, 0])))
    return found


def test_without_smooth_a_value_is_there_at_once():
    actor = actor_of()
    actor.set(other=7)
    actor.step()
    assert actor.memory.smoothed[0, 1] == 7


def test_a_smooth_one_is_on_its_way_as_a_critically_damped_spring():
    actor = actor_of()
    actor.set(pace=3)
    for tick, (value, _) in enumerate(values(actor, 30), 1):
        x = OMEGA * tick * DT
        assert value == pytest.approx(3 - 2 * (1 + x) * math.exp(-x), abs=1e-5)


def test_a_hundredth_is_left_after_its_seconds():
    actor = actor_of()
    actor.set(pace=3)
    assert values(actor, 15)[-1][0] == pytest.approx(3 - 0.02, abs=1e-4)


def test_then_it_arrives_exactly_and_comes_to_rest():
    actor = actor_of()
    actor.set(pace=3)
    assert values(actor, 60)[-1] == (3.0, 0.0)


def test_without_bounds_it_is_on_its_way_too():
    actor = Ticking(TABLE, {"walk": 600}, "parameters:\n  aim: {kind: point, smooth: 0.25}\n")
    for number in (0.5, -0.2):
        actor.set(**{"aim.x": number})
        start = float(actor.memory.smoothed[0, 0])
        for tick, (value, _) in enumerate(values(actor, 12), 1):
            x = OMEGA * tick * DT
            wanted = number + (start - number) * (1 + x) * math.exp(-x)
            assert value == pytest.approx(wanted, abs=1e-9 * abs(start - number))
        assert values(actor, 60)[-1] == (number, 0.0)


def test_neither_value_nor_rate_jumps_when_it_is_set_on_the_way():
    actor = actor_of()
    actor.set(pace=4)
    way = values(actor, 6)
    actor.set(pace=0)
    way += values(actor, 12)
    steps, turns = np.diff([value for value, _ in way]), np.diff([rate for _, rate in way])
    most = 4 * OMEGA  # of a rate; of an acceleration 4 OMEGA² and twice what drives it
    assert np.abs(steps).max() < most * DT
    assert np.abs(turns).max() < 3 * most * OMEGA * DT


def test_it_stays_within_its_bounds_whatever_is_set():
    actor, found = actor_of(), []
    for number in range(60):
        actor.set(pace=(4, 0, 4, 3.9, 0.1)[number % 5])
        found += values(actor, 1 + number % 7)
    assert min(value for value, _ in found) >= 0
    assert max(value for value, _ in found) <= 4


def test_speeds_see_the_smoothed_value():
    actor = actor_of()
    actor.set(pace=3)
    way = values(actor, 10)
    assert float(actor.memory.time[0, 0]) == pytest.approx(sum(value for value, _ in way) * DT)


def test_what_was_set_is_kept_beside_it():
    actor = actor_of()
    actor.set(pace=3)
    actor.step()
    assert actor.memory.parameters.tolist() == [[3.0, 0.0]]

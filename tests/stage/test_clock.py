"""The clock is told the time and hands out steps."""

import pytest
from statwalk.stage.clock import LARGEST_CATCH_UP_S, NEVER_S, Clock


def test_a_second_in_uneven_pieces_is_sixty_steps():
    clock = Clock(rate=60)
    times = [0.0, 0.013, 0.05, 0.051, 0.2, 0.37, 0.4, 0.61, 0.8, 0.93, 1.0]
    assert sum(clock.due(time) for time in times) == 60


def test_the_first_look_owes_nothing():
    assert Clock().due(1e9) == 0


def test_half_speed_is_half_the_steps():
    clock = Clock(rate=60, speed=0.5)
    assert sum(clock.due(k / 10) for k in range(11)) == 30


def test_a_stall_is_let_go():
    clock = Clock(rate=60)
    clock.due(0)
    assert clock.due(100) == LARGEST_CATCH_UP_S * 60


def test_time_in_a_pause_does_not_count():
    clock = Clock(rate=60)
    clock.due(0)
    clock.paused = True
    assert clock.due(0.2) == 0
    clock.paused = False
    assert clock.due(0.2 + 1 / 60) == 1


def test_wait_is_until_the_next_step():
    clock = Clock(rate=60)
    clock.due(0)
    assert clock.wait(0.01) == pytest.approx(1 / 60 - 0.01)
    assert clock.wait(0.5) == 0


def test_a_paused_clock_waits_long():
    assert Clock(paused=True).wait(0) == NEVER_S


def test_steps_are_as_late_as_the_look_after_they_were_due():
    clock = Clock(rate=10)
    clock.due(0)
    steps = clock.due(0.23)
    assert clock.lateness(steps) == pytest.approx([0.13, 0.03])


def test_steps_that_are_let_go_are_counted_once():
    clock = Clock(rate=60)
    clock.due(0)
    clock.due(LARGEST_CATCH_UP_S + 2)
    assert (clock.take_lost(), clock.take_lost()) == (120, 0)

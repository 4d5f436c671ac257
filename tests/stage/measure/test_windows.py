"""The ticks of a transition, in recordings made by hand."""

import numpy as np
import pytest
from recordings_by_hand import recording, standing
from statwalk.stage.measure.trials import NEVER
from statwalk.stage.measure.windows import NOT_TAKEN, change_ticks, end_of_blend, span


def changed(events, column, sent=3):
    every = np.full(10, NEVER)
    for tick, event in events.items():
        every[tick] = event
    return change_ticks(recording(standing(10), sent=sent, events=every), 0, column)[0]


@pytest.mark.parametrize(
    ("events", "tick"),
    [
        ({4: 1}, 4),
        ({7: 1}, 7),  # it waited
        ({4: 2}, NOT_TAKEN),  # another event was first
        ({2: 2, 4: 1}, NOT_TAKEN),  # the state was left before the event
        ({}, NOT_TAKEN),
    ],
)
def test_the_change_is_the_first_after_the_event(events, tick):
    assert changed(events, 1) == tick


def test_an_end_comes_by_itself():
    assert changed({2: 9}, 9) == 2


def test_a_blend_ends_where_nothing_is_left():
    left = [0, 0, 0, 0, 1, 0.6, 0.2, 0, 0, 0]
    assert end_of_blend(recording(standing(10), left=left), np.array([4]))[0] == 7
    assert end_of_blend(recording(standing(10), left=np.ones(10)), np.array([4]))[0] == 9


def test_a_span_has_both_ends():
    assert span(recording(standing(10)), np.array([3]), np.array([5])).sum() == 3

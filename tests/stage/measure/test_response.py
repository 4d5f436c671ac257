"""The response of a recording made by hand: an event at tick 2, a change at tick 4, a way of 1 m."""

import numpy as np
import pytest
from recordings_by_hand import ANKLE, recording, standing
from statwalk.stage.measure.response import arrivals, visible


def test_half_way_and_arrival():
    shown, target = standing(20), standing(20)
    target[:, ANKLE, 0] = 1
    shown[:, ANKLE, 0] = np.clip((np.arange(20) - 4) / 10, 0, 1)
    half, arrived = arrivals(recording(shown, sent=2, target=target), np.array([4]))
    assert (half[0], arrived[0]) == pytest.approx((7 / 60, 12 / 60))


def test_never_is_infinite():
    target = standing(20)
    target[:, ANKLE, 0] = 1
    half, _ = arrivals(recording(standing(20), sent=2, target=target), np.array([4]))
    assert half[0] == np.inf


def test_the_first_visible_motion_is_the_first_millimetre():
    from dataclasses import replace

    one = standing(20)
    one[5:, ANKLE, 0] = 0.0005
    one[8:, ANKLE, 0] = 0.002
    first, twin = recording(one, sent=2), recording(standing(20), sent=2)
    pairs = {
        name: np.concatenate([getattr(first, name), getattr(twin, name)], 1)
        for name in ("state", "event", "position", "heading", "left", "world", "target")
    }
    both = replace(first, sent=np.array([2, 2]), **pairs)
    assert visible(both, np.array([1, 1])).tolist() == [6 / 60, np.inf]

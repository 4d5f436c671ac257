"""Switched keys against RTCA 2.2, Listing 2: the pose is one key's or the next's, never in between."""

import numpy as np
import pytest
from statwalk.maths import pose as poses
from statwalk.motion.clip import Channel, Clip
from statwalk.motion.switched import switched

TIMES = np.array([0.0, 0.5, 1.5], np.float32)
PLACES = np.array([[1, 0, 0], [2, 0, 0], [4, 0, 0]], np.float32)
WEIGHTS = np.array([[0, 1], [1, 0], [0.5, 0.5]], np.float32)


def clip(interpolation: str = "LINEAR") -> Clip:
    rest = poses.rest(1, 3)
    channels = (
        Channel(0, "translation", TIMES, PLACES, interpolation),
        Channel(0, "weights", TIMES, WEIGHTS, interpolation, weight_first=1),
    )
    return Clip("walk", channels, 1.5, rest, loop=True)


@pytest.mark.parametrize("time", [0.0, 0.2, 0.249, 0.26, 0.5, 0.9, 0.99, 1.01, 1.5])
def test_it_shows_the_key_that_is_nearer(time: float) -> None:
    row = int(np.abs(TIMES - time).argmin())
    pose = switched(clip()).sample(time)
    assert pose.translation[0] == pytest.approx(PLACES[row])
    assert pose.weights == pytest.approx([0, *WEIGHTS[row]])


def test_length_name_and_loop_stay() -> None:
    made = switched(clip())
    assert (made.duration, made.name, made.loop) == (1.5, "walk", True)


def test_keys_that_hold_stay_as_they_are() -> None:
    held = clip("STEP")
    assert switched(held).channels == held.channels

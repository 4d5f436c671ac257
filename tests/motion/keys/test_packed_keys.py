"""Tracks: how many the channels of a clip need."""

import numpy as np
import pytest
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip, duration_of

TIMES = np.array([0.5, 1.0, 2.0], np.float32)
VALUES = np.array([[0, 0, 0], [1, 2, 3], [3, 2, 1]], np.float32)


def clip_of(*channels):
    return Clip("clip", channels, duration_of(channels), rest(6))


def test_a_constant_channel_costs_no_track():
    clip = clip_of(Channel(1, "translation", TIMES, np.full((3, 3), 2, np.float32)))
    assert not clip.tracks
    assert (clip.sample(0.7).translation[1] == 2).all()


def test_many_distinct_times_are_spread_over_several_tracks(monkeypatch):
    monkeypatch.setattr("statwalk.motion.keys.packed_keys.LARGEST_TABLE", 20)
    channels = [Channel(j, "translation", TIMES + np.float32(j), VALUES) for j in range(6)]
    clip = clip_of(*channels)
    assert len(clip.tracks) > 1
    assert clip.sample(3.75).translation[:, 0] == pytest.approx([3, 3, 2.5, 0.5, 0, 0])

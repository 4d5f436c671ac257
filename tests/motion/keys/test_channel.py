"""Channels refuse times that do not rise and values of the wrong shape."""

import numpy as np
import pytest
from statwalk.errors import ContentError
from statwalk.motion.keys.channel import Channel


@pytest.mark.parametrize("times", [[0, 0], [1, 0.5], []])
def test_times_must_rise(times):
    with pytest.raises(ContentError, match="must rise"):
        Channel(0, "translation", np.array(times, np.float32), np.zeros((len(times), 3), np.float32))


def test_values_must_fit_their_path():
    with pytest.raises(ContentError, match=r"joint 3's rotation needs values of shape \(2, 4\)"):
        Channel(3, "rotation", np.array([0, 1], np.float32), np.zeros((2, 3), np.float32))

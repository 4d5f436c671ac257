"""The search for the edge before a time, against NumPy."""

import numpy as np
import pytest
from random_motions import REST
from statwalk.motion.clip import Channel, Clip


@pytest.mark.parametrize("seed", range(3))
def test_keys_are_found_at_any_time(seed):
    """On an edge, a hair before it, and between two that are close together while others are far apart."""
    rng = np.random.default_rng(seed)
    times = np.unique(np.cumsum(rng.choice([1e-4, 0.01, 1, 30], 60)).astype(np.float32))
    values = rng.normal(size=(len(times), 3)).astype(np.float32)
    clip = Clip("uneven", (Channel(0, "translation", times, values, "STEP"),), float(times[-1]), REST)
    exact = times.astype(float)
    asked = np.concatenate([exact, np.nextafter(exact, -1), rng.uniform(-1, times[-1] + 1, 500)])
    expected = values[(exact.searchsorted(asked, "right") - 1).clip(0)]
    assert (clip.sample(asked).translation[:, 0] == expected).all()

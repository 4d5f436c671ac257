import numpy as np
import pytest
from statwalk.motion.keys.channel import Channel
from statwalk.motion.keys.key_set import key_set_of

CHANCE = np.random.default_rng(3)


@pytest.mark.parametrize("column", [0, 2])
def test_a_channel_that_changes_at_its_last_key_is_not_constant(column):
    times = np.arange(4, dtype=np.float32)
    still, moving = np.ones((2, 4, 3), np.float32)
    moving[3, column] = 2
    channels = [
        Channel(joint, "scale", times, values) for joint, values in enumerate((still, moving, still[:4]))
    ]
    assert key_set_of(channels).is_constant.tolist() == [True, False, True]

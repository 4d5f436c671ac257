import numpy as np
import pytest
from statwalk.motion.keys import segments
from statwalk.motion.keys.channel import Channel
from statwalk.motion.keys.key_set import key_set_of

CHANCE = np.random.default_rng(3)


def keys(path, width):
    """Channels of one, two and five keys; a quaternion of no length among them."""
    times = [np.arange(count, dtype=np.float32) for count in (1, 2, 5)]
    values = [CHANCE.normal(size=(len(time), width)).astype(np.float32) for time in times]
    values[2][1] = 0
    return key_set_of(
        [Channel(joint, path, *pair) for joint, pair in enumerate(zip(times, values, strict=True))]
    )


@pytest.mark.parametrize(
    ("path", "width", "slowly"), [("translation", 3, segments._lines), ("rotation", 4, segments._arcs)]
)
def test_straight_keys_get_the_same_bits(path, width, slowly):
    listed = keys(path, width)
    assert segments.pack(listed, loop=False)[1].tobytes() == slowly(listed).tobytes()

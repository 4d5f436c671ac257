import numpy as np
from statwalk.motion.keys.channel_table import gathered


def test_numbers_are_gathered():
    numbers = np.arange(50, dtype=np.float32)
    assert gathered(numbers, np.array([7, 0, 30]), np.array([2, 3, 20])).tolist() == [
        7,
        8,
        0,
        1,
        2,
        *range(30, 50),
    ]


def test_numbers_need_not_be_aligned():
    room = np.zeros(4 * 40 + 1, np.uint8)[1:].view(np.float32)
    assert gathered(room, np.array([3]), np.array([2])).tolist() == [0, 0]

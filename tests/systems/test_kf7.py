"""KF7, step (RTCA Listing 2) and glTF's samplers: what a STEP channel shows over its whole span; the formulas
stand in tests/motion.
"""

import numpy as np
from statwalk.maths import curves
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip

KEYS = np.array([[0, 0, 0], [1, 0, 0]], np.float32)


def test_a_switch_at_the_half_way_point():
    shown = [curves.step(KEYS[0], KEYS[1], np.float32(f))[0] for f in (0, 0.49, 0.5, 1)]
    assert shown == [0, 0, 1, 1]


def test_gltfs_step_holds_until_the_next_key():
    clip = Clip(
        "door", (Channel(0, "translation", np.array([0, 1], np.float32), KEYS, "STEP"),), 1.0, rest(1)
    )
    assert clip.sample([0, 0.5, 0.999, 1]).translation[:, 0, 0].tolist() == [0, 0, 0, 1]

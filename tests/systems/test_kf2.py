"""KF2, keyframe animation (FAQ Q16): clips of timed poses; a walk cycle of 8 keys whose last half mirrors the
first; no seam.
"""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip

LEFT, RIGHT = 0, 1
HALF = np.array(
    [30.0, 18, -5, -22]
)  # degrees: the left leg's first four keys; its last four are the right leg's first
STRIDE = np.concatenate([HALF, -HALF])


def walk(interpolation):
    """A second of walking: 8 keys, and the first one again at the end."""
    times = np.linspace(0, 1, 9).astype(np.float32)
    legs = []
    for joint, stride in ((LEFT, STRIDE), (RIGHT, np.roll(STRIDE, 4))):
        turns = Rotation.from_euler("x", np.append(stride, stride[0])[:, None], degrees=True).as_quat()
        legs.append(Channel(joint, "rotation", times, turns.astype(np.float32), interpolation))
    return Clip("walk", tuple(legs), 1.0, rest(2), loop=True)


def angle(clip, time, joint):
    return Rotation.from_quat(clip.sample(time, loop=True).rotation[..., joint, :]).as_euler(
        "xyz", degrees=True
    )[..., 0]


@pytest.mark.parametrize("interpolation", ["LINEAR", "BSPLINE_THROUGH"])
def test_the_keys_are_met(interpolation):
    assert angle(walk(interpolation), np.arange(8) / 8, LEFT) == pytest.approx(STRIDE, abs=1e-3)


@pytest.mark.parametrize("interpolation", ["LINEAR", "BSPLINE", "BSPLINE_THROUGH"])
def test_the_last_half_mirrors_the_first(interpolation):
    clip, times = walk(interpolation), np.linspace(0, 0.5, 13)
    assert angle(clip, times + 0.5, LEFT) == pytest.approx(angle(clip, times, RIGHT), abs=1e-3)


def test_half_way_between_two_keys_is_half_way():
    assert angle(walk("LINEAR"), 1 / 16, LEFT) == pytest.approx(24, abs=1e-3)


@pytest.mark.parametrize("interpolation", ["BSPLINE", "BSPLINE_THROUGH"])
def test_the_loop_has_no_seam(interpolation):
    """From tick to tick the velocity changes no more across the seam than anywhere else."""
    velocity = np.diff(angle(walk(interpolation), np.arange(-100, 100) / 100, LEFT))
    changes = np.abs(np.diff(velocity))
    assert changes[95:105].max() <= changes[:90].max()


def test_a_clip_prints_on_one_line():
    assert repr(walk("LINEAR")) == "Clip('walk', 1 s, 2 channels, loop)"

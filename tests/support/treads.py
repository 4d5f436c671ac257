"""A leg that treads on the spot, made by hand: how fast the ground runs under its foot is known."""

import numpy as np
from statwalk.character.character import Character
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

SKELETON = Skeleton.sorted(["LeftUpLeg", "LeftLeg", "LeftFoot"], [None, "LeftUpLeg", "LeftLeg"])[0]
POSE = rest(3)
POSE.translation[:] = [[0, 1, 0], [0, -0.5, 0], [0, -0.5, 0]]


def tread_clip(name, speed, lift=0.2, returns=True):
    """The foot runs back on the ground at `speed` m/s for 0.6 s, and forward in the air for 0.4 s; or it
    stays behind, if it does not return.
    """
    times = np.array([0, 0.6, 0.7, 0.9, 1.0], np.float32)
    place = np.zeros((5, 3), np.float32)
    place[:, 1], place[:, 2] = [-0.5, -0.5, -0.5 + lift, -0.5 + lift, -0.5], [0.3, -0.3, -0.25, 0.25, 0.3]
    place[:, 2] *= speed
    kept = slice(None) if returns else slice(2)
    return Clip(name, (Channel(2, "translation", times[kept], place[kept]),), 1.0, POSE)


def trodden(*clips):
    """A character of one leg with clips."""
    named = {clip.name: clip for clip in clips}
    return Character("tread", SKELETON, np.arange(3, dtype=np.int32), POSE, named)


def tread(speed, lift, returns=True):
    """A character with the clip `tread`."""
    return trodden(tread_clip("tread", speed, lift, returns))

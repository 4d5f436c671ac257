"""Recordings of trials made by hand: one actor whose joints are where a test puts them."""

from types import SimpleNamespace

import numpy as np
from statwalk.character.feet import Foot
from statwalk.character.skin_points import SkinPoints
from statwalk.maths.pose import rest
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.measure.trials import NEVER, Recording

HIP, KNEE, ANKLE = range(3)
LEG = SimpleNamespace(
    skeleton=Skeleton(("hip", "knee", "ankle"), np.array([-1, 0, 1], np.int32)), bind_pose=rest(3)
)
LEG.bind_pose.translation[:] = [[0, 1, 0], [0, -0.5, 0], [0, -0.5, 0]]


def recording(joints, sent=0, left=None, target=None, events=None, position=None, low=None):
    """A recording of one leg, its joints (T, 3, 3) without turns; `events` (T,)."""
    ticks = len(joints)
    world = np.zeros((ticks, 1, 3, 3, 4))
    world[..., :3], world[:, 0, :, :, 3] = np.eye(3), joints
    role = SimpleNamespace(character=LEG, machine=SimpleNamespace(end=9))
    return Recording(
        role=role,
        sent=np.array([sent]),
        state=np.zeros((ticks, 1, 1), int),
        event=np.full((ticks, 1, 1), NEVER) if events is None else np.reshape(events, (ticks, 1, 1)),
        position=np.zeros((ticks, 1, 3)) if position is None else np.reshape(position, (ticks, 1, 3)),
        heading=np.zeros((ticks, 1)),
        left=np.zeros((ticks, 1)) if left is None else np.reshape(left, (ticks, 1)),
        world=world,
        low=np.zeros((ticks, 1)) if low is None else np.reshape(low, (ticks, 1)),
        target=world[..., 3] if target is None else np.reshape(target, (ticks, 1, 3, 3)),
    )


def foot():
    """The foot of the leg: its ankle is its sole."""
    points, none = SkinPoints.of_joints_themselves([ANKLE], 3), np.zeros(1, bool)
    return Foot("left", HIP, KNEE, ANKLE, -1, True, np.array([ANKLE]), np.zeros((1, 3)), points, none)


def standing(ticks):
    """The joints (T, 3, 3) of a straight leg that stands at the origin."""
    return np.tile(np.array([[0.0, 1, 0], [0, 0.5, 0], [0, 0, 0]]), (ticks, 1, 1))

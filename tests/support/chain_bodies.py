"""Chains of joints without a skin, and machines of a file's text on them."""

import numpy as np
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

MACHINE = """
character: chain.glb
initial: REST
defaults: {{blend: 0, buffer: 0}}
states:
  REST: {{motion: rest, loop: true}}
parameters:
  grip: {{kind: point, default: [0, 0, 0]}}
  held: {{kind: flag}}
{more}
table: |
  state | GO
  REST  | -
"""


def chain_of(*ends):
    """A character: a root at the origin, below it J0 at the first end, J1 at the second …; metres."""
    ends = np.array(ends, float)
    count = len(ends)
    pose = rest(count + 1)
    pose.translation[1] = ends[0]
    pose.translation[2:] = np.diff(ends, axis=0)
    names = ["Root", *(f"J{k}" for k in range(count))]
    skeleton, _ = Skeleton.sorted(names, [None, *names[:-1]])
    still = Channel(0, "translation", np.array([0, 1], np.float32), np.zeros((2, 3), np.float32))
    clips = {"rest": Clip("rest", (still,), 1.0, pose)}
    return Character("chain", skeleton, np.arange(count + 1, dtype=np.int32), pose, clips)


def role_with(character, *more):
    """The role of a machine file with further lines."""
    return Role.build("chain", character, read_machine(MACHINE.format(more="\n".join(more))))


def places(character, pose):
    """(…, n, 3) places of the chain's joints."""
    return character.world(pose)[..., 1:, :3, 3].astype(float)


def lengths(points):
    """(…, n-1) of the bones."""
    return np.linalg.norm(np.diff(points, axis=-2), axis=-1)

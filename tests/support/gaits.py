"""Two gaits of a figure with two feet: a foot's height is a sine that is lowest when the foot is down; the
arm swings by an angle.
"""

from functools import cache

import numpy as np
from scipy.spatial.transform import Rotation
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.maths.pose import rest
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton

JOINTS = ["hips", "left", "right", "chest", "arm", "hand"]
PARENTS = [None, "hips", "hips", "hips", "chest", "arm"]
HIPS, LEFT, RIGHT, CHEST, ARM, HAND = range(6)
REST = rest(6, weights=1)
REST.translation[:] = [[0, 1, 0], [0.1, -1, 0], [-0.1, -1, 0], [0, 0.4, 0], [0.2, 0.1, 0], [0.5, 0, 0]]


def lowest_at(phase, down):
    return 0.1 * (1 - np.cos(2 * np.pi * (phase - down)))


def turns(axis, degrees):
    return Rotation.from_euler(axis, np.asarray(degrees)[:, None], degrees=True).as_quat().astype(np.float32)


def gait(name, seconds, stride, downs, arm_deg, keys=121):
    """A lap of `seconds` that goes `stride` metres; the left and right foot are down at the phases
    `downs`.
    """
    phase = np.linspace(0, 1, keys)
    times = (phase * seconds).astype(np.float32)
    along = np.stack([0 * phase, 1 + 0 * phase, stride * phase], -1).astype(np.float32)
    feet = [np.tile(REST.translation[foot], (keys, 1)) for foot in (LEFT, RIGHT)]
    for foot, down in zip(feet, downs, strict=True):
        foot[:, 1] += lowest_at(phase, down)
    channels = (
        Channel(HIPS, "translation", times, along),
        Channel(LEFT, "translation", times, feet[0].astype(np.float32), "BSPLINE_THROUGH"),
        Channel(RIGHT, "translation", times, feet[1].astype(np.float32), "BSPLINE_THROUGH"),
        Channel(ARM, "rotation", times, turns("x", arm_deg * np.sin(2 * np.pi * phase)), "BSPLINE_THROUGH"),
    )
    return Clip(name, channels, seconds, REST)


def held(name, seconds, joint, axis, degrees):
    """A clip that turns one joint through the angles `degrees`, evenly spaced in time, without a kink."""
    times = np.linspace(0, seconds, len(degrees)).astype(np.float32)
    return Clip(
        name, (Channel(joint, "rotation", times, turns(axis, degrees), "BSPLINE_THROUGH"),), seconds, REST
    )


WALK_DOWN, RUN_DOWN = (0.0, 0.5), (0.2, 0.62)
WALK, RUN = gait("walk", 1.0, 1.2, WALK_DOWN, 20), gait("run", 0.6, 2.4, RUN_DOWN, 60)
STAND = held("stand", 2.0, CHEST, "x", [0, 2, 3, 2, 0])
WAVE = held("wave", 0.8, ARM, "z", [60, 90, 60, 30, 60])
NOD = held("nod", 0.5, CHEST, "x", [10, 20, 30, 20, 10])
STILL = held("still", 0.5, CHEST, "x", [25, 25.0])
CLIPS = {clip.name: clip for clip in (STAND, WALK, RUN, WAVE, NOD, STILL)}


def character():
    skeleton, _ = Skeleton.sorted(JOINTS, PARENTS)
    return Character("gaits", skeleton, np.arange(6, dtype=np.int32), REST, CLIPS)


MACHINE = """
character: gaits.glb
initial: STAND
defaults: {blend: 0.2, buffer: 0}
parameters:
  speed: {default: 1.2, min: 0, max: 5, smooth: 0.3}
  force: {default: 1, min: 0, max: 1}
states:
  STAND: {motion: stand, loop: true}
  MOVE:
    motion:
      over: speed
      clips: {walk: 1.2, run: 4}
      markers: {walk: {left: 0, right: 0.5}, run: {left: 0.2, right: 0.62}}
    loop: true
table: |
  state | GO   | STOP  | BOTH  | END
  STAND | MOVE |       | MOVE  |
  MOVE  |      | STAND | STAND |
layers:
  arm:
    mask: [arm]
    initial: REST
    states:
      REST: {motion: none}
      WAVE: {motion: wave, loop: true}
    table: |
      state | WAVE | REST | BOTH
      REST  | WAVE |      | WAVE
      WAVE  |      | REST | REST
  head:
    mask: [chest]
    mode: additive
    weight: force
    initial: CALM
    states:
      CALM: {motion: none}
      NOD: {motion: nod, loop: true}
      STILL: {motion: still, loop: true}
    table: |
      state | NOD | CALM | STILL
      CALM  | NOD |      | STILL
      NOD   |     | CALM |
      STILL |     | CALM |
"""


@cache
def role(*changes):
    """The role of that machine, with some of its text replaced."""
    text = MACHINE
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return Role.build("gaits", character(), read_machine(text), "hips")

"""Left and right: the partner of each joint by its name, and poses and clips mirrored (solid drawing).

The mirror is the plane x = 0 of the character's space. The rest pose counts: a joint turns from its own rest
pose as its partner turned from its rest pose, seen in the mirror, so that bones may have any local axes.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from statwalk.errors import ContentError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats, Ints
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Channel

_WORDS = (("left", "right"), ("Left", "Right"), ("LEFT", "RIGHT"))
_LETTER = re.compile(r"(?<![A-Za-z])([lLrR])(?![A-Za-z])")
_SWAPPED = {"l": "r", "r": "l", "L": "R", "R": "L"}


def partner_name(name: str) -> str:
    """Returns the name with left and right exchanged: `Left.arm`, `hand_l`, `L_Foot`, `arm.R.001`; a name
    without a side stays.
    """
    for left, right in _WORDS:
        for own, other in ((left, right), (right, left)):
            if own in name:
                return name.replace(own, other, 1)
    return _LETTER.sub(lambda letter: _SWAPPED[letter[1]], name, count=1)


@dataclass(frozen=True, eq=False)
class Sides:
    """The two sides of a character with J joints, and what mirroring needs of its rest pose."""

    names: tuple[str, ...]
    partner: Ints
    """(J,) the joint on the other side; a joint in the middle is its own partner, -1: no partner"""
    before: Floats
    """(J, 4) for the joint that receives, the rotation to the left of its partner's, seen in the mirror"""
    after: Floats
    """(J, 4) the rotation to its right"""
    moved: Floats
    """(J, 3, 3) its partner's way from rest, seen in the mirror"""
    rest: Pose

    @classmethod
    def of(cls, names: Sequence[str], parent: Ints, rest: Pose, frames: Floats) -> Sides:
        """Returns the sides of a skeleton; `frames` (J, 3, 3) are the joints' rotations and scales at rest
        in the character's space.
        """
        partner = _partners(names, parent.tolist())
        turn = _rotations(frames)
        above = np.where((parent >= 0)[:, None], turn[parent], quat.IDENTITY)
        frame = np.where((parent >= 0)[:, None, None], frames[parent], np.eye(3))
        other = np.where(partner >= 0, partner, np.arange(len(partner)))
        before = quat.mul(quat.conjugate(above), seen(above[other]))
        after = quat.mul(quat.conjugate(seen(turn[other])), turn)
        flipped = np.array([-1.0, 1, 1])[:, None] * frame[other]
        moved = np.stack([_inverse(own) @ there for own, there in zip(frame, flipped, strict=True)])
        return cls(tuple(names), partner, before, after, moved, rest)

    @property
    def alone(self) -> tuple[str, ...]:
        """Returns the joints that have a side and no partner: mirroring leaves them as they are."""
        return tuple(name for name, row in zip(self.names, self.partner, strict=True) if row < 0)

    @property
    def pairs(self) -> tuple[tuple[int, int], ...]:
        """Returns the pairs of different joints, each once."""
        return tuple((row, other) for row, other in enumerate(self.partner.tolist()) if other > row)

    def turned(self, joint: int, values: Floats) -> Floats:
        """Returns the local rotations (…, 4) of `joint` that mirror its partner's `values` (linear: also for
        tangents).
        """
        exact = values.astype(np.float64)
        return quat.mul(quat.mul(self.before[joint], seen(exact)), self.after[joint])

    def placed(self, joint: int, values: Floats, is_slope: bool = False) -> Floats:
        """Returns the local translations (…, 3) of `joint` that mirror its partner's `values`; slopes have no
        rest.
        """
        there = 0.0 if is_slope else self.rest.translation[self.partner[joint]].astype(np.float64)
        here = 0.0 if is_slope else self.rest.translation[joint].astype(np.float64)
        return np.asarray(here + ((values - there)[..., None, :] * self.moved[joint]).sum(-1))

    def scaled(self, joint: int, values: Floats) -> Floats:
        """Returns the local scales (…, 3) of `joint` that mirror its partner's `values`."""
        return np.asarray(values / self.rest.scale[self.partner[joint]] * self.rest.scale[joint])

    def pose(self, pose: Pose) -> Pose:
        """Returns poses (…, J) mirrored; morph weights stay."""
        out = Pose(*(np.array(array, np.float64) for array in pose))
        for joint, other in enumerate(self.partner.tolist()):
            if other >= 0:
                out.rotation[..., joint, :] = self.turned(joint, pose.rotation[..., other, :])
                out.translation[..., joint, :] = self.placed(joint, pose.translation[..., other, :])
                out.scale[..., joint, :] = self.scaled(joint, pose.scale[..., other, :])
        return Pose(*(array.astype(np.float32) for array in out))

    def clip(self, clip: Clip) -> Clip:
        """Returns the clip mirrored: each key goes to the partner of its joint, with the same curve.

        :raises ContentError: when the clip is one of a character with other joints.
        """
        joints = clip.rest.rotation.shape[-2]
        if joints != len(self.partner):
            raise ContentError(f"the clip moves {joints} joints, these sides have {len(self.partner)}")
        receiver = {int(other): joint for joint, other in enumerate(self.partner) if other >= 0}
        channels = tuple(
            self._channel(channel, receiver[channel.joint])
            if channel.path != "weights" and channel.joint in receiver
            else channel
            for channel in clip.channels
        )
        rest = self.pose(clip.rest)
        return replace(clip, channels=channels, rest=rest)

    def _channel(self, channel: Channel, joint: int) -> Channel:
        values: Floats = channel.values.astype(np.float64)
        if channel.path == "rotation":
            values = self.turned(joint, values)
        elif channel.path == "scale":
            values = self.scaled(joint, values)
        elif channel.interpolation == "CUBICSPLINE":
            slopes = self.placed(joint, values, is_slope=True)
            slopes[:, 1] = self.placed(joint, values[:, 1])
            values = slopes
        else:
            values = self.placed(joint, values)
        return replace(channel, joint=joint, values=values.astype(np.float32))


def seen(rotation: Floats) -> Floats:
    """Returns rotations (…, 4) as the mirror x = 0 shows them."""
    return np.asarray(rotation * np.array([1.0, -1, -1, 1]))


def _partners(names: Sequence[str], parent: Sequence[int]) -> Ints:
    """(J,) partners by name, whose parents are partners too; -1 for a joint with a side and no partner."""
    rows, partner = {name: row for row, name in enumerate(names)}, np.full(len(names), -1)
    for row, name in enumerate(names):
        other = rows.get(partner_name(name), -1)
        above = partner[parent[row]] if parent[row] >= 0 else -1
        if other >= 0 and above == parent[other]:
            partner[row] = other
        elif other == row:
            partner[row] = row
    return partner


def _rotations(frames: Floats) -> Floats:
    lengths = np.sqrt((frames * frames).sum(-2, keepdims=True))
    return np.stack([quat.from_matrix(frame) for frame in frames / np.where(lengths > 0, lengths, 1)])


def _inverse(matrix: Floats) -> Floats:
    """The inverse (3, 3) by cofactors; of a flat matrix the identity."""
    a, b, c = matrix.astype(np.float64)
    cofactors = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], -1)
    volume = float((a * cofactors[:, 0]).sum())
    return cofactors / volume if abs(volume) > 1e-30 else np.eye(3)

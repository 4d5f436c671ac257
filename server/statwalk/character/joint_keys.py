"""Turns the motion of bones in a character's space into keys of its joints."""

from __future__ import annotations

import numpy as np

from statwalk.character.body import Body
from statwalk.character.plant import Keys
from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.motion.clip import Channel


def channels_of(body: Body, keys: Keys, times: Floats) -> tuple[Channel, ...]:
    """Returns the keys of the joints at `times` (F,): rotations of the bones, translations of those that have a
    place. Joints without a bone keep their rest below the nearest joint that turns.
    """
    bone_of = {body.bones[bone]: bone for bone in keys.turns}
    frames = len(times)
    pose = body.character.bind_pose
    world: list[Floats] = []
    channels: list[Channel] = []
    at = times.astype(np.float32)
    for joint, parent in enumerate(body.character.skeleton.parent.tolist()):
        bone = bone_of.get(joint)
        rest = [array[joint].astype(np.float64) for array in pose[:3]]
        above = world[parent] if parent >= 0 else np.eye(3, 4)
        place, turn, scale = np.asarray(rest[0]), quat.normalize(rest[1]), rest[2]
        if bone is not None:
            turn = continuous(quat.mul(quat.conjugate(_rotation(above, frames)), keys.turns[bone]))
            channels.append(Channel.checked(joint, "rotation", at, turn.astype(np.float32), "LINEAR"))
            if bone in keys.places:
                place = transform.apply(transform.invert(above), keys.places[bone])
                channels.append(Channel.checked(joint, "translation", at, place.astype(np.float32), "LINEAR"))
        lead = np.broadcast_shapes(place.shape[:-1], turn.shape[:-1])
        own = transform.from_trs(
            *(np.broadcast_to(part, (*lead, part.shape[-1])) for part in (place, turn, np.asarray(scale)))
        )
        world.append(transform.mul(above, own))
    return tuple(channels)


def _rotation(frame: Floats, frames: int) -> Floats:
    """Returns the rotation (F, 4) of matrices T·R·S with an even scale."""
    columns = frame[..., :3]
    lengths = np.sqrt((columns * columns).sum(-2, keepdims=True))
    turn = quat.from_matrix(columns / np.where(lengths > 0, lengths, 1))
    return np.broadcast_to(turn, (frames, 4))

"""Turns the motion of bones in a character's space into keys of its joints."""

from __future__ import annotations

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import carrier
from statwalk.character.plant import BodyKeys
from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.motion.clip import Channel


def travelling_joint(body: Body, keys: BodyKeys) -> int:
    """Returns the joint that travels: the hips, or what carries hips and feet, where feet do not hang on
    legs.
    """
    placed = [body.bones[bone] for bone in keys.places]
    above = carrier(body.character.skeleton, placed) if len(placed) > 1 else None
    return body.bones["Hips"] if above is None else above


def channels_of(body: Body, keys: BodyKeys, times: Floats) -> tuple[Channel, ...]:
    """Returns the keys of the joints at `times` (F,): rotations of the bones, translations of those that have
    a place. Joints without a bone keep their rest below the nearest joint that turns.
    """
    bone_of = {body.bones[bone]: bone for bone in keys.turns}
    frames, travelling = len(times), travelling_joint(body, keys)
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
        if bone in keys.places or joint == travelling:
            goal = keys.places[bone] if bone in keys.places else _below_hips(body, keys, joint)
            place = transform.apply(transform.invert(above), goal)
            channels.append(Channel.checked(joint, "translation", at, place.astype(np.float32), "LINEAR"))
        lead = np.broadcast_shapes(place.shape[:-1], turn.shape[:-1])
        own = transform.from_trs(
            *(np.broadcast_to(part, (*lead, part.shape[-1])) for part in (place, turn, np.asarray(scale)))
        )
        world.append(transform.mul(above, own))
    return tuple(channels)


def _below_hips(body: Body, keys: BodyKeys, joint: int) -> Floats:
    """Returns the way (F, 3) of a joint that travels with the hips over the ground, and keeps its height."""
    hips = keys.places["Hips"]
    way: Floats = body.position[joint] + (hips - hips[:1]) * np.array([1.0, 0.0, 1.0])
    return way


def _rotation(frame: Floats, frames: int) -> Floats:
    """Returns the rotation (F, 4) of matrices T·R·S with an even scale."""
    columns = frame[..., :3]
    lengths = np.sqrt((columns * columns).sum(-2, keepdims=True))
    turn = quat.from_matrix(columns / np.where(lengths > 0, lengths, 1))
    return np.broadcast_to(turn, (frames, 4))

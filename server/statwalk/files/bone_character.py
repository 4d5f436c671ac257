"""A character made of the bones of a FAQ skeleton table (SK1): joints, and a tetrahedron for each bone (FAQ
Q28).

Bones at the end of a limb, and with a keyed length, get a second joint, `NAME.end`, at their end.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import TextError
from statwalk.files import tetrahedra
from statwalk.files.faq.key_frame_clip import ClipForm, keyed_lengths
from statwalk.files.faq.key_frame_text import KeyFrame
from statwalk.maths import pose as poses
from statwalk.maths.arrays import Floats
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin


def bone_character(
    name: str, bones: Bones, scale: float, frames: Sequence[KeyFrame]
) -> tuple[Character, ClipForm]:
    """Returns the character at rest, without clips, and the ClipForm that its clips are built from."""
    metric = Bones(bones.skeleton, bones.length * scale, bones.direction)
    keyed = keyed_lengths(bones, frames)
    limb_ends = set(range(len(bones.skeleton))) - set(bones.skeleton.parent.tolist())
    bones_with_end = sorted({bone for bone in limb_ends if bones.length[bone] > 0} | keyed.keys())
    end_joint_of = {bone: len(bones.skeleton) + row for row, bone in enumerate(bones_with_end)}
    skeleton = _with_ends(bones.skeleton, bones_with_end)
    parts, skins = _parts(metric, {bone: keyed[bone] * scale for bone in keyed}, end_joint_of, len(skeleton))
    rest = poses.rest(len(skeleton))
    rest.translation[: len(bones.skeleton)] = metric.pose().translation
    rest.translation[len(bones.skeleton) :] = metric.attachment()[bones_with_end]
    node_index = np.arange(len(skeleton), dtype=np.int32)
    character = Character(
        name, skeleton, node_index, rest, skins=skins, parts=parts, materials=(tetrahedra.MATERIAL,)
    )
    return character, ClipForm(metric, scale, end_joint_of, rest)


def _with_ends(skeleton: Skeleton, bones_with_end: Sequence[int]) -> Skeleton:
    """Returns the skeleton with one more joint, after all others, for the end of each bone in
    `bones_with_end`.
    """
    names = tuple(f"{skeleton.names[bone]}.end" for bone in bones_with_end)
    for name in set(names) & set(skeleton.names):
        raise TextError(
            f"{name} is reserved for the end of {name.removesuffix('.end')}; give this bone another name"
        )
    return Skeleton(
        skeleton.names + names, np.concatenate([skeleton.parent, np.array(bones_with_end, np.int32)])
    )


def _parts(
    bones: Bones, keyed: Mapping[int, float], end_joint_of: Mapping[int, int], node: int
) -> tuple[tuple[Primitive, ...], tuple[Skin, ...]]:
    """Returns a rigid part for each bone that has a length, and one skinned part for all bones with a keyed
    length.

    `keyed` is the greatest keyed length in metres, by bone.
    """
    rigid = tetrahedra.rigid_parts(
        bones, [bone for bone in np.flatnonzero(bones.length > 0).tolist() if bone not in keyed]
    )
    longest_length: Floats = bones.length.copy()
    for bone, length in keyed.items():
        longest_length[bone] = max(longest_length[bone], length)
    drawn_end_joint_of = {bone: end_joint_of[bone] for bone in keyed if longest_length[bone] > 0}
    if not drawn_end_joint_of:
        return rigid, ()
    part, skin = tetrahedra.growing_part(bones, longest_length, drawn_end_joint_of, len(rigid), node)
    return (*rigid, part), (skin,)

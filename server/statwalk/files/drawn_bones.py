"""Which joints and bones of a character are drawn, as the page draws them: muscle bones, which only deform
the skin, are joints without a line.
"""

from __future__ import annotations

from typing import NamedTuple

from statwalk.character.character import Character


class DrawnBones(NamedTuple):
    """The joints that are drawn, and the bones between them, by their rows among these joints."""

    joints: list[int]
    segments: list[tuple[int, int]]


def drawn_bones(character: Character) -> DrawnBones:
    """Returns the joints of the skins (all joints if there is no skin), and for each joint the bone from the
    nearest of them above it.
    """
    parents = character.skeleton.parent.tolist()
    muscles = {character.skeleton.index(name) for name in character.skeleton.muscle_bones}
    skinned = sorted({joint for skin in character.skins for joint in skin.joints.tolist()})
    joints = skinned or list(range(len(parents)))
    row_of = {joint: row for row, joint in enumerate(joints)}
    above: list[int] = []  # for each joint the row of the nearest drawn one, itself included
    segments = []
    for joint, parent in enumerate(parents):
        start = above[parent] if parent >= 0 else -1
        row = row_of.get(joint, -1)
        is_bone = row >= 0 and joint not in muscles
        if is_bone and start >= 0:
            segments.append((start, row))
        above.append(row if is_bone else start)
    return DrawnBones(joints, segments)

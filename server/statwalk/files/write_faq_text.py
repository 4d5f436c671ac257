"""Writes a character as the FAQ's text: a character file, its skeleton table, key frames of each clip, its
limits and its digital skin.

A bone of the FAQ begins where its parent ends and has no rotation at rest. So a joint with one child is
a bone that reaches to it; to each of several children leads a bone of its own, `PARENT.to.CHILD`; a root that
is not at the origin hangs on `ROOT.place`. As in BVH, all bones have the axes of the character.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.bvh.write_bvh import one_word_names
from statwalk.files.bvh.write_frames import BvhMotion, motion_of
from statwalk.files.digital_skin_part import skin_text
from statwalk.files.faq.digital_skin_text import write_digital_skin
from statwalk.files.faq.key_frame_text import BoneKey, KeyFrame, Triple, write_keys
from statwalk.files.faq.skeleton_text import LARGEST_TEXT_BYTES, MOST_BONES, write_skeleton
from statwalk.files.gltf.names import unique
from statwalk.files.held_parts import carriers
from statwalk.files.write_limits import entry_lines, limit_entries
from statwalk.maths.arrays import Bools, Floats
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton

STILL_DEG = 1e-4
"""degrees: a bone that turns by less is not keyed"""


class _Row(NamedTuple):
    """A bone: the place of its end, seen from its beginning; the joint that it is, -1 for none."""

    name: str
    parent: str | None
    end: Floats
    joint: int


def write_faq_files(character: Character, stem: str) -> dict[str, bytes]:
    """Returns the files of a character by name, the character file first; lengths are the character's.

    :raises ContentError: when the skeleton or a clip is too large for a text.
    """
    rest = motion_of(character, None)
    rows = _rows(character, rest.offset)
    if len(rows) > MOST_BONES:
        raise ContentError(f"a skeleton table has {MOST_BONES} bones at most; this one needs {len(rows)}")
    skeleton_name = f"{stem}.skeleton.txt"
    stems = unique([_plain(name) for name in character.clips], "clip", between="-")
    files = {
        f"{stem}.{own}.txt": _keys(rows, motion_of(character, clip))
        for own, clip in zip(stems, character.clips.values(), strict=True)
    }
    lines = [f"name: {json.dumps(character.name)}", f"skeleton: {json.dumps(skeleton_name)}"]
    names = one_word_names(character.skeleton.names)
    limits, limit_files = limit_entries(character, names, f"{stem}.limits.txt")
    lines += entry_lines(limits)
    skin = skin_text(character, names)
    skin_files = {} if skin is None else {f"{stem}.skin.txt": write_digital_skin(skin)}
    lines += [f"digital_skin: {json.dumps(name)}" for name in skin_files]
    lines += ["clips:"] if files else []
    for name, file in zip(character.clips, files, strict=True):
        loop = ", loop: true" if character.clips[name].loop else ""
        lines.append(f"  {json.dumps(name)}: {{keys: {json.dumps(file)}, interpolation: slerp{loop}}}")
    texts = {f"{stem}.yaml": "\n".join(lines) + "\n", skeleton_name: write_skeleton(_bones(rows))}
    texts |= {**limit_files, **skin_files, **files}
    for name, text in texts.items():
        if len(text) > LARGEST_TEXT_BYTES:
            raise ContentError(f"{name} would be larger than {LARGEST_TEXT_BYTES >> 20} MiB")
    return {name: text.encode() for name, text in texts.items()}


def _plain(name: str) -> str:
    return re.sub(r"[^\w-]+", "-", name, flags=re.ASCII)[:60]


def _rows(character: Character, offset: Floats) -> list[_Row]:
    """Returns the bones, parents first."""
    left_out, parents = carriers(character), character.skeleton.parent.tolist()
    names = one_word_names(character.skeleton.names)
    children: dict[int, list[int]] = {joint: [] for joint in range(-1, len(parents))}
    for joint, parent in enumerate(parents):
        if joint not in left_out:
            children[parent].append(joint)
    rows: list[_Row] = []
    hangs_on: dict[int, str | None] = {}
    for joint, parent in enumerate(parents):
        if joint in left_out:
            continue
        if parent < 0 and offset[joint].any():
            rows.append(_Row(f"{names[joint]}.place", None, offset[joint], -1))
            hangs_on[joint] = f"{names[joint]}.place"
        below = children[joint]
        rows.append(
            _Row(
                names[joint],
                hangs_on.get(joint),
                offset[below[0]] if len(below) == 1 else np.zeros(3),
                joint,
            )
        )
        for child in below:
            way = f"{names[joint]}.to.{names[child]}"
            hangs_on[child] = names[joint] if len(below) == 1 else way
            if len(below) > 1:
                rows.append(_Row(way, names[joint], offset[child], -1))
    return rows


def _bones(rows: list[_Row]) -> Bones:
    row_of = {row.name: place for place, row in enumerate(rows)}
    parents = [-1 if row.parent is None else row_of[row.parent] for row in rows]
    ends = np.array([row.end for row in rows]).reshape(-1, 3)
    length = np.sqrt((ends * ends).sum(-1))
    direction = ends / np.where(length == 0, 1, length)[:, None]
    return Bones(Skeleton(tuple(row_of), np.array(parents, np.int32)), length, direction)


def _keys(rows: list[_Row], motion: BvhMotion) -> str:
    """Returns the key frames of a clip; bones that neither turn nor move are not keyed."""
    turns: Bools = np.asarray((np.abs(motion.angles_deg) > STILL_DEG).any((0, 2)))
    keyed = [row for row in rows if row.joint >= 0 and (turns[row.joint] or motion.moves[row.joint])]
    keyed = keyed or [row for row in rows if row.joint >= 0][:1]
    return write_keys(
        [KeyFrame(float(time), dict(_frame(keyed, motion, at))) for at, time in enumerate(motion.times)]
    )


def _frame(rows: list[_Row], motion: BvhMotion, at: int) -> Iterator[tuple[str, BoneKey]]:
    for row in rows:
        way = motion.position[at, row.joint] - motion.offset[row.joint]
        translate = _triple(way) if motion.moves[row.joint] else None
        yield row.name, BoneKey(rotate_deg=_triple(motion.angles_deg[at, row.joint]), translate=translate)


def _triple(numbers: Floats) -> Triple:
    x, y, z = (float(np.float32(number)) for number in numbers)
    return x, y, z

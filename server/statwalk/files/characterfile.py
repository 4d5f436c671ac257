"""A character in text: the FAQ's skeleton table and key frames, brought together by a short YAML file.

    name: mammal
    skeleton: mammal.txt          # a file beside this one, or `mammal` or `hand`, which come with statwalk
    scale: 0.08                   # metres per unit of the files
    clips:
      walk: {keys: walk.txt, interpolation: slerp, loop: true}

Every bone becomes a joint and a rigid tetrahedron (FAQ Q28). Bones at the end of a limb, and bones whose length is keyed, get a second
joint, `NAME.end`, at their end-point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from statwalk.character import Character
from statwalk.errors import ContentError, TextError
from statwalk.files import tetrahedra
from statwalk.files.faqclip import INTERPOLATIONS, ClipForm, check_names, clip_of, keyed_lengths
from statwalk.files.faqkeys import KeyFrame, read_keys
from statwalk.files.faqtext import SHIPPED, read_skeleton, read_text
from statwalk.files.glb import write
from statwalk.files.yamltext import Node, parse
from statwalk.maths import pose as poses
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Clip
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

_KEYS = ("name", "skeleton", "scale", "clips")
_CLIP_KEYS = ("keys", "interpolation", "loop")
_SCALES = (1e-6, 1e6)


def load_character(path: Path) -> Character:
    """The character of a YAML file; raises TextError with file and line where it, or a text it names, says something wrong."""
    root = parse(read_text(path), str(path), TextError)
    entries = root.entries(*_KEYS)
    if "skeleton" not in entries:
        raise root.refuse("a character needs a skeleton: skeleton: mammal.txt")
    bones = _skeleton(entries["skeleton"], path.parent)
    scale = entries["scale"].number(*_SCALES) if "scale" in entries else 1.0
    clips = entries["clips"].entries() if "clips" in entries else {}
    frames = {name: _frames(node, bones, path.parent) for name, node in clips.items()}
    name = entries["name"].text() if "name" in entries else path.stem
    character, form = _boneman(name, bones, scale, [frame for each in frames.values() for frame in each])
    animated = replace(character, clips={name: _clip(name, node, form, frames[name]) for name, node in clips.items()})
    return replace(animated, model_glb=write.model_glb(animated))


def _beside(node: Node, folder: Path) -> Path:
    """The file that a value names: in the folder of the character or below it."""
    path = Path(node.text())
    if path.is_absolute() or ".." in path.parts or not path.parts:
        raise node.refuse(f"{node.text()[:80]!r} should name a file in the folder of this one")
    return folder / path


def _skeleton(node: Node, folder: Path) -> Bones:
    shipped = SHIPPED / f"{node.text()}.txt"
    path = shipped if node.text().isidentifier() and shipped.is_file() else _beside(node, folder)
    try:
        return read_skeleton(read_text(path))
    except ContentError as error:
        raise error.in_file(str(path)) from None


def _frames(node: Node, bones: Bones, folder: Path) -> tuple[KeyFrame, ...]:
    """The poses of the key-frame file that a clip names."""
    entries = node.entries(*_CLIP_KEYS)
    if "keys" not in entries:
        raise node.refuse("a clip needs key frames: keys: walk.txt")
    path = _beside(entries["keys"], folder)
    try:
        frames = read_keys(read_text(path))
        check_names(bones, frames)
    except ContentError as error:
        raise error.in_file(str(path)) from None
    return frames


def _clip(name: str, node: Node, form: ClipForm, frames: Sequence[KeyFrame]) -> Clip:
    entries = node.entries(*_CLIP_KEYS)
    interpolation = entries["interpolation"].text() if "interpolation" in entries else "slerp"
    if interpolation not in INTERPOLATIONS:
        raise entries["interpolation"].unknown("interpolation", interpolation, INTERPOLATIONS)
    loop = "loop" in entries and entries["loop"].truth()
    try:
        clip = clip_of(name, form, frames, interpolation, loop)
        clip.sample(0.0)  # a B-spline that cannot pass through its keys is refused here, not in a tick
    except ContentError as error:
        raise node.refuse(f"clip {name}: {error.message}") from None
    return clip


def _boneman(name: str, bones: Bones, scale: float, frames: Sequence[KeyFrame]) -> tuple[Character, ClipForm]:
    """The character at rest, without clips, and what its clips need: every bone a joint and a tetrahedron."""
    metric = Bones(bones.skeleton, bones.length * scale, bones.direction)
    keyed = keyed_lengths(bones, frames)
    tips = set(range(len(bones.skeleton))) - set(bones.skeleton.parent.tolist())
    ended = sorted({bone for bone in tips if bones.length[bone] > 0} | keyed.keys())
    ends = {bone: len(bones.skeleton) + row for row, bone in enumerate(ended)}
    skeleton = _with_ends(bones.skeleton, ended)
    parts, skins = _parts(metric, {bone: keyed[bone] * scale for bone in keyed}, ends, len(skeleton))
    rest = poses.rest(len(skeleton))
    rest.translation[: len(bones.skeleton)] = metric.pose().translation
    rest.translation[len(bones.skeleton) :] = metric.attachment()[ended]
    node_index = np.arange(len(skeleton), dtype=np.int32)
    character = Character(name, skeleton, node_index, rest, skins=skins, parts=parts, materials=(tetrahedra.MATERIAL,))
    return character, ClipForm(metric, scale, ends, rest)


def _with_ends(skeleton: Skeleton, ended: Sequence[int]) -> Skeleton:
    """The skeleton with a joint at the end of some bones, after all others."""
    names = tuple(f"{skeleton.names[bone]}.end" for bone in ended)
    for name in set(names) & set(skeleton.names):
        raise TextError(f"{name} is kept for the end of {name.removesuffix('.end')}; give this bone another name")
    return Skeleton(skeleton.names + names, np.concatenate([skeleton.parent, np.array(ended, np.int32)]))


def _parts(bones: Bones, keyed: Mapping[int, float], ends: Mapping[int, int], node: int) -> tuple[tuple[Primitive, ...], tuple[Skin, ...]]:
    """A rigid part for each bone that has a length, and one skinned part for all whose length is keyed."""
    rigid = tetrahedra.rigid_parts(bones, [bone for bone in np.flatnonzero(bones.length > 0).tolist() if bone not in keyed])
    longest: Floats = bones.length.copy()
    for bone, length in keyed.items():
        longest[bone] = max(longest[bone], length)
    growing = {bone: ends[bone] for bone in keyed if longest[bone] > 0}
    if not growing:
        return rigid, ()
    part, skin = tetrahedra.growing_part(bones, longest, growing, len(rigid), node)
    return (*rigid, part), (skin,)

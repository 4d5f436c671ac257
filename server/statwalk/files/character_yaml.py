"""A character in text: the FAQ's skeleton table and key frames, combined by a short YAML file.

    name: mammal
    skeleton: mammal.txt          # a file in the same folder, or `mammal` or `hand`, which statwalk ships
    scale: 0.08                   # metres per unit of the files
    clips:
      walk: {keys: walk.txt, interpolation: slerp, loop: true}
      wave: {keys: wave.txt, interpolation: {rotation: nurbs, translation: linear}}
    expressions: |                # what moves with what, whichever machine plays it
      Wheel.rotate_z = -2 * Crank.rotate_z

`model: robot.glb` in place of `skeleton` names a model, whose clips it may change (`of:`).

Every bone becomes a joint and a rigid tetrahedron (FAQ Q28). A bone at the end of a limb, and a bone with a
keyed length, gets a second joint, `NAME.end`, at its end point.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from statwalk.character.character import Character
from statwalk.character.expressions import channels_of
from statwalk.character.made_clips import Refuse, with_clips
from statwalk.character.made_clips import changed as with_changes
from statwalk.errors import ContentError, TextError, UnknownNameError
from statwalk.files import clip_changes, tetrahedra
from statwalk.files.expressions import expressions
from statwalk.files.faq.key_frame_clip import ClipForm, check_names, clip_of, keyed_lengths
from statwalk.files.faq.key_frame_text import KeyFrame, read_keys
from statwalk.files.faq.skeleton_text import SHIPPED, read_skeleton, read_text
from statwalk.files.gltf import write
from statwalk.files.joint_limits import joint_limits, table_limits
from statwalk.files.model_character import model_of, with_made_clips
from statwalk.files.yaml.yaml_text import Node, parse
from statwalk.machine.definition.limit_definition import LimitDefinition
from statwalk.maths import pose as poses
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_table import JointLimit
from statwalk.motion.clip import Clip
from statwalk.motion.keys.channel import Path as Property
from statwalk.motion.keys.channel_table import PATHS
from statwalk.motion.keys.interpolations import INTERPOLATIONS
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.primitive import Primitive, Skin

_KEYS = ("name", "skeleton", "model", "scale", "joints", "limits", "clips", "expressions")
_CLIP_KEYS = ("keys", "interpolation", "loop", *clip_changes.CHANGES)
_SCALES = (1e-6, 1e6)


def load_character(path: Path) -> Character:
    """Reads the character of a YAML file.

    :raises TextError: when the file, or a text that it names, is wrong; `file` and `place` say where.
    """
    root = parse(read_text(path), str(path), TextError)
    entries = root.entries(*_KEYS)
    if ("skeleton" in entries) == ("model" in entries):
        raise root.refuse("a character needs a skeleton (skeleton: mammal.txt) or a model (model: robot.glb)")
    if "model" in entries:
        model = model_of(entries["model"], _beside(entries["model"], path.parent), entries)
        return _with_rules(root, with_made_clips(model, entries, _refuser(root)), 1.0, path.parent)
    bones = _skeleton(entries["skeleton"], path.parent)
    scale = entries["scale"].number(*_SCALES) if "scale" in entries else 1.0
    clips = entries["clips"].entries() if "clips" in entries else {}
    made = {name: clip_changes.clip(node) for name, node in clips.items() if "of" in node.entries()}
    keyed = {name: node for name, node in clips.items() if name not in made}
    frames = {name: _frames(node, bones, path.parent) for name, node in keyed.items()}
    name = entries["name"].text() if "name" in entries else path.stem
    character, form = _bone_character(
        name, bones, scale, [frame for clip_frames in frames.values() for frame in clip_frames]
    )
    own = {name: _clip(name, node, form, frames[name]) for name, node in keyed.items()}
    changed = {
        name: with_changes(character, clip, clip_changes.changes(keyed[name].entries()), _refuser(root))
        for name, clip in own.items()
    }
    animated = with_clips(replace(character, clips=changed), made, _refuser(root))
    animated = replace(animated, made=frozenset())  # the model carries them as its own
    ruled = _with_rules(root, animated, scale, path.parent)
    return replace(ruled, model_glb=write.model_glb(ruled))


def _with_rules(root: Node, character: Character, scale: float, folder: Path) -> Character:
    """Returns the character with its limits and expressions."""
    lines = expressions(root.entries(*_KEYS).get("expressions"))
    channels_of(character.skeleton, lines, _refuser(root))  # an unknown joint is an error now
    return replace(character, limits=_limits(root, character.skeleton, scale, folder), expressions=lines)


def _refuser(root: Node) -> Refuse:
    return lambda message, line: root.refuse(message, line)


def _beside(node: Node, folder: Path) -> Path:
    """Returns the path of the file that a value names, in the character's folder or below it."""
    path = Path(node.text())
    if path.is_absolute() or ".." in path.parts or not path.parts:
        raise node.refuse(f"{node.text()[:80]!r} must name a file in the folder of this file")
    return folder / path


def _skeleton(node: Node, folder: Path) -> Bones:
    shipped = SHIPPED / f"{node.text()}.txt"
    path = shipped if node.text().isidentifier() and shipped.is_file() else _beside(node, folder)
    try:
        return read_skeleton(read_text(path))
    except ContentError as error:
        raise error.in_file(str(path)) from None


def _limits(root: Node, skeleton: Skeleton, scale: float, folder: Path) -> dict[str, JointLimit]:
    """Reads `joints` and `limits`; `limits` may name a file with the FAQ's table of constraints."""
    entries = root.entries(*_KEYS)
    joints, limits = entries.get("joints"), entries.get("limits")
    is_file = limits is not None and limits.is_text and limits.style is None and limits.value != ""
    read = joint_limits(joints, None if is_file else limits, scale)
    in_file: dict[str, LimitDefinition] = {}
    if limits is not None and is_file:
        path = _beside(limits, folder)
        in_file = table_limits(limits, read_text(path), scale, file=str(path))
        for name in in_file.keys() & read.keys():
            raise limits.refuse(f"{name} stands under `joints` and in {path.name}")
        _check_joints(in_file, skeleton, str(path))
    _check_joints(read, skeleton, root.file)
    read |= in_file
    return {name: definition.limit for name, definition in read.items()}


def _check_joints(limits: Mapping[str, LimitDefinition], skeleton: Skeleton, file: str) -> None:
    for name, definition in limits.items():
        if name not in skeleton.names:
            message = f"limits: {UnknownNameError('joint', name, skeleton.names)}"
            raise TextError(message, file=file, place=f"line {definition.line}")


def _frames(node: Node, bones: Bones, folder: Path) -> tuple[KeyFrame, ...]:
    """Reads the poses of the key-frame file that a clip names."""
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
    how = _interpolations(entries.get("interpolation"))
    loop = "loop" in entries and entries["loop"].truth()
    try:
        clip = clip_of(name, form, frames, how, loop)
        clip.tracks  # noqa: B018 - refuses a B-spline that cannot pass through its keys here, not in a tick
    except ContentError as error:
        raise node.refuse(f"clip {name}: {error.message}") from None
    return clip


def _interpolations(node: Node | None) -> dict[Property, str]:
    """Returns the interpolation of each property: one name for all, or a name for some of them."""
    if node is None or node.is_mapping:
        entries = node.entries(*PATHS) if node is not None else {}
        return {path: _interpolation(entries[path]) if path in entries else "slerp" for path in PATHS}
    return dict.fromkeys(PATHS, _interpolation(node))


def _interpolation(node: Node) -> str:
    if node.text() not in INTERPOLATIONS:
        raise node.unknown("interpolation", node.text(), INTERPOLATIONS)
    return node.text()


def _bone_character(
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

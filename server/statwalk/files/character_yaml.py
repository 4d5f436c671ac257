"""A character in text: the FAQ's skeleton table and key frames, combined by a short YAML file.

    name: mammal
    skeleton: mammal.txt          # a file in the same folder, or `mammal` or `hand`, which statwalk ships
    scale: 0.08                   # metres per unit of the files
    clips:
      walk: {keys: walk.txt, interpolation: slerp, loop: true}
      wave: {keys: wave.txt, interpolation: {rotation: nurbs, bones: {Hand: slerp}}}
    expressions: |                # what moves with what, whichever machine plays it
      Wheel.rotate_z = -2 * Crank.rotate_z
    skinning: dual-quaternion     # or linear (the default), rigid, parts
    digital_skin: arm.skin.txt    # vertices for each bone, and one list of polygons, in place of tetrahedra
    muscle_bones: [Biceps]        # bones that only deform the skin
    bulges: {…}                   # muscles that bulge with the angle of a joint (bulges_part)

`model: robot.glb` in place of `skeleton` names a model; the file may change its clips (`of:`) and its face.

Every bone becomes a joint and a rigid tetrahedron (FAQ Q28). Bones at the end of a limb, and with a keyed
length, get a second joint, `NAME.end`, at their end.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from statwalk.character.character import Character
from statwalk.character.expressions import check_channels
from statwalk.character.made_clips import Refuse, with_clips
from statwalk.character.made_clips import changed as with_changes
from statwalk.errors import ContentError, TextError, UnknownNameError
from statwalk.files import clip_changes
from statwalk.files.bone_character import bone_character
from statwalk.files.bulges_part import with_bulges_of
from statwalk.files.digital_skin_part import with_skin_of
from statwalk.files.expressions import expressions
from statwalk.files.faq.key_frame_clip import ClipForm, check_names, clip_of
from statwalk.files.faq.key_frame_text import KeyFrame, read_keys
from statwalk.files.faq.skeleton_text import SHIPPED, read_skeleton, read_text
from statwalk.files.gltf import write
from statwalk.files.gltf.add_parts import model_with_parts
from statwalk.files.gltf.carried import with_carried
from statwalk.files.interpolations_part import read_interpolations
from statwalk.files.joint_limits import joint_limits, table_limits
from statwalk.files.model_character import model_of, with_made_clips
from statwalk.files.muscle_bones import muscle_bones
from statwalk.files.with_face import KEYS, with_face, without_face
from statwalk.files.yaml.yaml_text import Node, parse
from statwalk.machine.definition.limit_definition import LimitDefinition
from statwalk.maths.clamp_table import JointLimit
from statwalk.motion.clip import Clip
from statwalk.rig.bones import Bones
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.skinning import Skinning, skinning_of

_KEYS = (
    *("name", "skeleton", "model", "scale", "joints", "limits", "clips", "expressions", "skinning"),
    *("digital_skin", "muscle_bones", "bulges"),
    *KEYS,
)
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
        made_clips = with_made_clips(with_face(model, entries), entries, _refuser(root))
        skinned = _with_digital_skin(entries, made_clips, 1.0, path.parent)
        ruled = _with_rules(root, skinned, 1.0, path.parent)
        if ruled.parts is not made_clips.parts:
            ruled = replace(ruled, model_glb=model_with_parts(ruled))
        return with_carried(ruled)
    bones = _skeleton(without_face(entries)["skeleton"], path.parent)
    scale = entries["scale"].number(*_SCALES) if "scale" in entries else 1.0
    clips = entries["clips"].entries() if "clips" in entries else {}
    made = {name: clip_changes.clip(node) for name, node in clips.items() if "of" in node.entries()}
    keyed = {name: node for name, node in clips.items() if name not in made}
    frames = {name: _frames(node, bones, path.parent) for name, node in keyed.items()}
    name = entries["name"].text() if "name" in entries else path.stem
    all_frames = [frame for clip_frames in frames.values() for frame in clip_frames]
    character, form = bone_character(name, bones, scale, all_frames)
    own = {name: _clip(name, node, form, frames[name]) for name, node in keyed.items()}
    changed = {
        name: with_changes(character, clip, clip_changes.changes(keyed[name].entries()), _refuser(root))
        for name, clip in own.items()
    }
    animated = with_clips(replace(character, clips=changed), made, _refuser(root))
    animated = replace(animated, made=frozenset())  # the model carries them as its own
    skinned = _with_digital_skin(entries, animated, scale, path.parent)
    ruled = _with_rules(root, skinned, scale, path.parent)
    return replace(ruled, model_glb=write.model_glb(ruled))


def _with_digital_skin(
    entries: Mapping[str, Node], character: Character, scale: float, folder: Path
) -> Character:
    """Returns the character with its digital skin: in place of the tetrahedra, or beside a model's parts."""
    if (node := entries.get("digital_skin")) is None:
        return character
    bare = character if character.model_glb else replace(character, parts=(), skins=(), materials=())
    return with_skin_of(node, bare, lambda name: _beside(name, folder), scale)


def _with_rules(root: Node, character: Character, scale: float, folder: Path) -> Character:
    """Returns the character with its limits, expressions and way of skinning, before the model's own."""
    entries = root.entries(*_KEYS)
    lines = expressions(entries["expressions"]) if "expressions" in entries else character.expressions
    check_channels(character, lines, _refuser(root))  # an unknown joint is an error now
    limits = {**character.limits, **_limits(root, character.skeleton, scale, folder)}
    skeleton = muscle_bones(entries.get("muscle_bones"), character.skeleton)
    ruled = replace(
        character,
        skeleton=skeleton,
        limits=limits,
        expressions=lines,
        skinning=_skinning(root, character),
    )
    return with_bulges_of(entries["bulges"], ruled) if "bulges" in entries else ruled


def _skinning(root: Node, character: Character) -> Skinning:
    if (node := root.entries(*_KEYS).get("skinning")) is None:
        return character.skinning
    try:
        return skinning_of(node.text())
    except UnknownNameError as error:
        raise node.refuse(str(error)) from None


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
    is_file = limits is not None and limits.is_text and limits.style != "|" and limits.value != ""
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
    loop = "loop" in entries and entries["loop"].truth()
    how = read_interpolations(entries.get("interpolation"), form.bones.skeleton.names)
    try:
        clip = clip_of(name, form, frames, how, loop)
        clip.tracks  # noqa: B018 - refuses a B-spline that cannot pass through its keys here, not in a tick
    except ContentError as error:
        raise node.refuse(f"clip {name}: {error.message}") from None
    return clip

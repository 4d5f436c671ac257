"""What a character file says about a model, carried in the model's own extras, in the same words: joints,
limits, expressions, muscle bones, bulges, muscles and faces, chains, and the markers and loops of clips.
`detail` reads the levels of detail.

    extras.statwalk                {"joints": {…}, "limits": {…}, "expressions": ["a.rotate_z = …"],
                                    "muscle_bones": ["biceps"]}
    animations/N/extras.statwalk   {"loop": true, "markers": [["left-down", 0.25]]}
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any, NamedTuple

import orjson

from statwalk.character.bulge_targets import checked_bulges, expressions_of_bulges
from statwalk.character.character import Character
from statwalk.character.expressions import check_channels
from statwalk.character.muscle_targets import check_targets
from statwalk.errors import ModelError, StatwalkError
from statwalk.files.bulges_part import bulges_in_words, read_bulges
from statwalk.files.expressions import expressions
from statwalk.files.face_yaml import in_words, read_faces, read_muscles
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.detail import level_words
from statwalk.files.gltf.document import Document
from statwalk.files.joint_limits import joint_limits
from statwalk.files.limit_words import limits_in_words
from statwalk.files.muscle_bones import muscle_bones
from statwalk.files.named_chains import named_chains
from statwalk.files.yaml.yaml_text import tree_of_json
from statwalk.maths.clamp_table import JointLimit
from statwalk.maths.formula.assignments import Assignment
from statwalk.motion.clip import Clip, Marker
from statwalk.rig.skeleton import Skeleton
from statwalk.skin.bulge import Bulge
from statwalk.skin.face_muscles import Muscle

KEY = "statwalk"
MOST_MARKERS = 1000
_KEYS = (
    *("joints", "limits", "expressions", "muscle_bones", "bulges"),
    *("muscles", "faces", "chains", "levels"),
)


class Said(NamedTuple):
    """What a model's extras say about its character."""

    skeleton: Skeleton
    limits: Mapping[str, JointLimit]
    expressions: tuple[Assignment, ...]
    muscles: Mapping[str, Muscle]
    faces: Mapping[str, Mapping[str, float]]
    chains: Mapping[str, tuple[str, ...]]
    bulges: Mapping[str, Bulge]


def character_extras(character: Character) -> Json:
    """Returns the extras of a model's root; empty for a character without limits, expressions and muscle
    bones.
    """
    said = limits_in_words(character.limits)
    if character.expressions:
        said["expressions"] = [line.text for line in character.expressions]
    if character.skeleton.muscle_bones:
        said["muscle_bones"] = sorted(character.skeleton.muscle_bones)
    if character.chains:
        said["chains"] = {name: list(joints) for name, joints in character.chains.items()}
    if character.levels:
        said["levels"] = level_words(character.levels)
    said |= bulges_in_words(character.bulges) | in_words(character.muscles, character.faces)
    return {KEY: said} if said else {}


def clip_extras(clip: Clip) -> Json:
    """Returns the extras of a clip's animation; empty for a clip without markers that does not loop."""
    said: Json = {"loop": True} if clip.loop else {}
    if clip.markers:
        said["markers"] = [[marker.name, marker.time] for marker in clip.markers]
    return {KEY: said} if said else {}


def with_carried(character: Character) -> Character:
    """Returns the character with a model that carries its limits, expressions and muscle bones."""
    extras = character_extras(character)
    if not extras or not container.is_glb(character.model_glb):
        return character
    text, binary = container.split(character.model_glb)
    root: Json = orjson.loads(bytes(text))
    own = root.get("extras")
    root["extras"] = {**(own if isinstance(own, dict) else {}), **extras}
    return replace(character, model_glb=container.join(json_text.dumps(root), binary or b""))


def carried(document: Document, character: Character) -> Character:
    """Returns the character with what its document carries. What does not fit the model is left out, with a
    note: an editor may have renamed its joints.
    """
    try:
        said = _character_said(document.root, character)
    except StatwalkError as error:
        document.note(f"what the model says in extras.{KEY} is left out: {str(error)[:500]}")
        said = _nothing(character)
    clips = [
        _with_said(document, clip, entry)
        for clip, entry in zip(character.clips.values(), document["animations"], strict=True)
    ]
    return replace(character, **said._asdict(), clips={clip.name: clip for clip in clips})


def _said(entry: Json) -> Any:
    extras = entry.get("extras")
    return extras.get(KEY) if isinstance(extras, dict) else None


def _character_said(root: Json, character: Character) -> Said:
    said = _said(root)
    if said is None:
        return _nothing(character)
    entries = tree_of_json(said, ModelError).entries(*_KEYS)
    limits = joint_limits(entries.get("joints"), entries.get("limits"))
    for name in limits:
        character.skeleton.index(name)
    bulges = checked_bulges(character, read_bulges(entries.get("bulges")))
    lines = expressions_of_bulges(expressions(entries.get("expressions")), bulges)
    check_channels(character, lines, _refuse)
    muscles = read_muscles(entries.get("muscles"))
    check_targets(character, muscles)
    faces = read_faces(entries.get("faces"), muscles)
    skeleton = muscle_bones(entries.get("muscle_bones"), character.skeleton)
    joints = {name: definition.limit for name, definition in limits.items()}
    chains = named_chains(entries.get("chains"), character.skeleton)
    return Said(skeleton, joints, lines, muscles, faces, chains, bulges)


def _nothing(character: Character) -> Said:
    return Said(character.skeleton, {}, (), {}, {}, {}, {})


def _refuse(message: str, _line: int) -> StatwalkError:
    return ModelError(message)


def _with_said(document: Document, clip: Clip, entry: Json) -> Clip:
    said = _said(entry)
    if said is None:
        return clip
    markers = said.get("markers", []) if isinstance(said, dict) else None
    if not isinstance(markers, list) or not _are_markers(markers, clip.duration):
        document.note(
            f"the markers in extras.{KEY} of the clip {clip.name[:60]} are left out: they are wrong"
        )
        return clip
    read = tuple(Marker(name, float(time)) for name, time in markers)
    return replace(clip, loop=said.get("loop") is True, markers=read)


def _are_markers(values: list[Any], duration: float) -> bool:
    """Returns whether the values are names with times from 0 to the clip's end."""
    return (
        len(values) <= MOST_MARKERS
        and all(isinstance(pair, list) and len(pair) == 2 and isinstance(pair[0], str) for pair in values)
        and all(type(time) in (int, float) and 0 <= time <= duration for _, time in values)
    )


def in_extras(entry: Json, extras: Json) -> Json:
    """Returns the object with these extras, unchanged without any."""
    return {**entry, "extras": extras} if extras else entry

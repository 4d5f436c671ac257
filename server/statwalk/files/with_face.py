"""Gives a model the muscles and named expressions that a character file describes (DS9)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from statwalk.character.character import Character
from statwalk.character.face_clips import face_clip
from statwalk.character.muscle_targets import with_muscle_targets
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.face_yaml import read_face_clips, read_faces, read_muscles
from statwalk.files.gltf.add_clip import model_with_clip
from statwalk.files.gltf.add_parts import model_with_parts
from statwalk.files.yaml.yaml_text import Node
from statwalk.skin.face_muscles import Muscle

KEYS = ("muscles", "faces")


def with_face(character: Character, entries: Mapping[str, Node]) -> Character:
    """Returns the character of a model with `muscles`, `faces`, and the clips that key faces; each face is
    a clip of its own too. The model has the morph targets and the clips.

    :raises ContentError: when a value is wrong, a muscle moves no vertex, or a clip has that name already.
    """
    made = character
    if "muscles" in entries:
        try:
            made = with_muscles(character, read_muscles(entries["muscles"]))
        except UnknownNameError as error:
            raise entries["muscles"].refuse(f"muscles: {error}") from None
        except ContentError as error:
            raise error if error.place else entries["muscles"].refuse(f"muscles: {error.message}") from None
    faces = read_faces(entries.get("faces"), made.muscles)
    made = with_faces(made, faces, lambda message: entries["faces"].refuse(message))
    keyed = read_face_clips(entries.get("clips"), made.muscles, {**made.faces, **faces})
    for name, (keys, loop) in keyed.items():
        if name in made.clips:
            raise entries["clips"].refuse(f"the model has a clip {name} already")
        made = _with_clip(made, name, keys, loop=loop)
    return made


def with_muscles(character: Character, muscles: Mapping[str, Muscle]) -> Character:
    """Returns the character with some muscles; its model has their morph targets.

    :raises ContentError: when a muscle moves no vertex, or the model cannot have them.
    :raises UnknownNameError: when a muscle names a joint or a material that the model does not have.
    """
    if character.muscles:
        raise ContentError("the model has muscles already")
    with np.errstate(over="ignore", invalid="ignore"):
        made = with_muscle_targets(character, muscles)
    return replace(made, model_glb=model_with_parts(made))


def with_faces(
    character: Character,
    faces: Mapping[str, Mapping[str, float]],
    refuse: Callable[[str], ContentError] = ContentError,
) -> Character:
    """Returns the character with named expressions, each with a clip of its name.

    :raises ContentError: what `refuse` returns, when the model has a clip of a name already.
    """
    made = replace(character, faces={**character.faces, **faces})
    for name, face in faces.items():
        if name in made.clips:
            raise refuse(f"the model has a clip {name} already")
        made = _with_clip(made, name, {0.0: face})
    return made


def _with_clip(
    character: Character, name: str, keys: Mapping[float, Mapping[str, float]], *, loop: bool = False
) -> Character:
    clip = face_clip(character, name, keys, loop=loop)
    made = replace(character, clips={**character.clips, name: clip})
    return replace(made, model_glb=model_with_clip(made, clip))


def without_face(entries: Mapping[str, Node]) -> Mapping[str, Node]:
    """Returns the entries of a character file that names no model.

    :raises ContentError: when they have muscles or faces.
    """
    for key in KEYS:
        if key in entries:
            raise entries[key].refuse(f"`{key}` are for a character with a model")
    return entries

"""A character with its level of detail in its model, and a coarser character with its model (DS10)."""

from __future__ import annotations

from dataclasses import replace

import orjson

from statwalk.character.character import Character
from statwalk.character.detail.find_detail import Progress, find_detail
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.detail import KEY, collapse_extras, level_words
from statwalk.files.gltf.model_textures import textures_of
from statwalk.files.gltf.write import model_glb


def with_detail(character: Character, progress: Progress = lambda _work, _share: None) -> Character:
    """Returns the character with the order in which its vertices collapse (DS10), also in
    its .glb; an order that it had is replaced.

    :raises ContentError: when the character has no triangles, or too many.
    """
    made = find_detail(character, progress)
    return replace(made, model_glb=model_with_detail(made))


def lod(
    character: Character,
    error: float | None = None,
    *,
    vertices: int | None = None,
    share: float | None = None,
) -> Character:
    """Returns the character with a coarser skin (`Character.lod`), also in its .glb, which holds what a
    Character has, and the textures: cameras and unknown extensions are left out. Without levels they are
    found first, which takes seconds.

    :raises ContentError: when not exactly one wish is given, or it cannot be met.
    """
    whole = character if character.levels else find_detail(character)
    coarse = whole.lod(error, vertices=vertices, share=share)
    return replace(coarse, model_glb=model_glb(coarse, textures_of(character.model_glb)))


def model_with_detail(character: Character) -> bytes:
    """Returns the character's model with its collapses and levels in extras; all else as it was."""
    if not container.is_glb(character.model_glb):
        return model_glb(character)
    text, binary = container.split(character.model_glb)
    document: Json = orjson.loads(bytes(text))
    builder = Builder(
        bytearray(binary or b""), list(document.get("bufferViews", ())), list(document.get("accessors", ()))
    )
    for part in character.parts:
        entry = document["meshes"][part.mesh]["primitives"][part.primitive]
        _say(entry, "collapses", collapse_extras(builder, part).get(KEY, {}).get("collapses"))
    _say(document, "levels", level_words(character.levels))
    return container.join(json_text.dumps(builder.finished(document)), bytes(builder.binary))


def _say(entry: Json, key: str, value: object) -> None:
    """Puts a value into an object's own extras; an empty one takes the key out."""
    extras = entry.get("extras")
    extras = dict(extras) if isinstance(extras, dict) else {}
    own = extras.get(KEY)
    own = {**(own if isinstance(own, dict) else {}), key: value}
    if not value:
        del own[key]
    extras[KEY] = own
    if own or entry.get("extras"):
        entry["extras"] = extras

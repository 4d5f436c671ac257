"""Leaves meshes out of a character when its file is read, as a knight's weapons."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import orjson

from statwalk.character.character import Character
from statwalk.character.fewer_parts import with_parts
from statwalk.errors import ContentError, UnknownNameError
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.model_textures import textures_of
from statwalk.files.gltf.write import model_glb
from statwalk.files.model_facts import mesh_names
from statwalk.skin.primitive import Primitive


def without_meshes(character: Character, meshes: Sequence[str]) -> Character:
    """Returns the character without some of its meshes, also in its .glb, which holds what a Character has,
    and the textures: cameras and unknown extensions are left out.

    `meshes`: the name of a node that carries a mesh, or of the mesh itself: all parts of a name are left out;
    or `NODE/PRIMITIVE`, the numbers of one part. Without any, the character stays as it is.

    :raises ContentError: when there is no such mesh, none would be left, or the character needs one's morph
        targets.
    """
    if not meshes:
        return character
    own = mesh_names(character.model_glb)
    gone = {row for wanted in meshes for row in _rows(character, own, wanted)}
    kept = [row for row in range(len(character.parts)) if row not in gone]
    if not kept:
        raise ContentError("every mesh of the character is left out; at least one must stay")
    fewer = with_parts(character, kept)
    numbers = {part.mesh: character.parts[row].mesh for row, part in zip(kept, fewer.parts, strict=True)}
    named = {mesh: own[old] for mesh, old in numbers.items() if old in own}
    model = _named(model_glb(fewer, textures_of(character.model_glb)), named)
    left_out = ", ".join(dict.fromkeys(_node_name(character, character.parts[row]) for row in sorted(gone)))
    return replace(fewer, model_glb=model, notes=(*fewer.notes, f"left out as wished: {left_out[:500]}"))


def _rows(character: Character, own: Mapping[int, str], wanted: str) -> list[int]:
    """Returns the places of the parts that one text means: numbers, a node, or else a mesh."""
    places = [f"{part.node}/{part.primitive}" for part in character.parts]
    nodes = [_node_name(character, part) for part in character.parts]
    meshes = [own.get(part.mesh, "") for part in character.parts]
    for names in (places, nodes, meshes):
        rows = [row for row, name in enumerate(names) if name == wanted]
        if rows:
            return rows
    raise ContentError(str(UnknownNameError("mesh", wanted, dict.fromkeys(filter(None, nodes + meshes)))))


def _node_name(character: Character, part: Primitive) -> str:
    return character.skeleton.names[part.joint]


def _named(model: bytes, names: dict[int, str]) -> bytes:
    """Returns a written model with the names of its meshes, which a Character does not keep."""
    text, binary = container.split(model)
    document = orjson.loads(bytes(text))
    for mesh, name in names.items():
        document["meshes"][mesh]["name"] = name
    return container.join(json_text.dumps(document), binary or b"")

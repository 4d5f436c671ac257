"""Brings a model up to its character: the morph targets, the parts with their materials and skins that it
lacks. Textures, cameras, lights, extensions and extras of the .glb stay as they were.
"""

from __future__ import annotations

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.add_skin import add_roots
from statwalk.files.gltf.add_targets import add_targets
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.materials import with_textures_from
from statwalk.files.gltf.write import mesh_entry, model_glb, skin_entry
from statwalk.skin.primitive import Primitive


def model_with_parts(character: Character) -> bytes:
    """Returns the character's .glb with the morph targets and the parts that it lacks. New parts are those
    on nodes after the model's own.

    :raises ContentError: when the model does not have the meshes of the character's other parts.
    """
    if not container.is_glb(character.model_glb):
        return model_glb(character)
    text, binary = container.split(character.model_glb)
    document: Json = orjson.loads(bytes(text))
    builder = Builder(
        bytearray(binary or b""), list(document.get("bufferViews", ())), list(document.get("accessors", ()))
    )
    add_targets(document, builder, character)
    _add_parts(document, builder, character)
    return container.join(json_text.dumps(builder.finished(document)), bytes(builder.binary))


def _add_parts(document: Json, builder: Builder, character: Character) -> None:
    """Adds the nodes of new parts, to the scenes as roots, where skinned meshes belong."""
    count = len(document["nodes"])
    added: dict[int, list[Primitive]] = {}
    for part in character.parts:
        if part.node >= count:
            added.setdefault(part.node, []).append(part)
    if not added:
        return
    materials, skins, meshes = (document.setdefault(key, []) for key in ("materials", "skins", "meshes"))
    materials += [with_textures_from(entry, None) for entry in character.materials[len(materials) :]]
    skins += [skin_entry(builder, character, skin) for skin in character.skins[len(skins) :]]
    for _, parts in sorted(added.items()):
        document["nodes"].append(_node(character, parts[0], len(meshes)))
        meshes.append(mesh_entry(builder, character, parts))
    add_roots(document, count, range(count, len(document["nodes"])))


def _node(character: Character, part: Primitive, mesh: int) -> Json:
    node: Json = {"name": f"mesh {mesh}", "mesh": mesh}
    if part.skin is not None:
        node["skin"] = part.skin
    if part.target_positions is not None:
        weights = character.bind_pose.weights[part.weight_first :][: len(part.target_positions)]
        node["weights"] = weights.tolist()
    return node

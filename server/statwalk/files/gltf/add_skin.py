"""Puts a character's skin into its model: textures, cameras and all else of the .glb stay as they were."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import orjson

from statwalk.character.character import Character
from statwalk.files.gltf import container
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.write import influence_sets, joint_nodes, model_glb, skin_entry
from statwalk.files.gltf.write_animations import animation
from statwalk.skin.primitive import Primitive

OLD_SKIN = ("JOINTS_", "WEIGHTS_")


def model_with_skin(character: Character) -> bytes:
    """Returns the character's model with the character's skins in place of its own, with the joints that it
    lacks, and with the clips that follow those of the model.
    """
    if not character.model_glb:
        return model_glb(character)
    text, binary = container.split(character.model_glb)
    document: Json = orjson.loads(bytes(text))
    builder = Builder(
        bytearray(binary or b""), list(document.get("bufferViews", ())), list(document.get("accessors", ()))
    )
    _add_joints(document, character)
    document["skins"] = [skin_entry(builder, character, skin) for skin in character.skins]
    for node in document["nodes"]:
        node.pop("skin", None)
    used: set[int] = set()
    for number in sorted({part.node for part in character.parts}):
        parts = [part for part in character.parts if part.node == number]
        _bind_node(document, builder, document["nodes"][number], parts, used)
    animations = list(document.get("animations", ()))
    made = [animation(builder, character, clip) for clip in list(character.clips.values())[len(animations) :]]
    document["animations"] = [*animations, *(entry for entry in made if entry is not None)]
    return container.join(orjson.dumps(builder.finished(document)), bytes(builder.binary))


def _add_joints(document: Json, character: Character) -> None:
    """Adds the joints that the document lacks as nodes, their roots to its scenes."""
    count = len(document["nodes"])
    nodes = joint_nodes(character)
    added = [nodes[number] for number in sorted(nodes) if number >= count]
    document["nodes"] += added
    children = {child for node in added for child in node.get("children", ())}
    add_roots(document, count, [row for row in range(count, count + len(added)) if row not in children])


def add_roots(document: Json, count: int, rows: Sequence[int]) -> None:
    """Adds nodes to all scenes as roots; a document without scenes gets one, with the roots of its first
    `count` nodes.
    """
    scenes = document.setdefault("scenes", [{"nodes": _roots(document["nodes"][:count])}])
    for scene in scenes:
        scene["nodes"] = [*scene.get("nodes", ()), *rows]


def _roots(nodes: list[Json]) -> list[int]:
    """The nodes that are no children."""
    children = {child for node in nodes for child in node.get("children", ())}
    return [row for row in range(len(nodes)) if row not in children]


def _bind_node(document: Json, builder: Builder, node: Json, parts: list[Primitive], used: set[int]) -> None:
    """Gives a node its skin, and a mesh of its own with the weights of its parts."""
    mesh: Json = document["meshes"][node["mesh"]]
    primitives = [_without_skin(entry) for entry in mesh["primitives"]]
    for part in parts:
        if part.joints is not None and part.weights is not None:
            primitives[part.primitive]["attributes"] |= influence_sets(builder, part.joints, part.weights)
    bound = {**mesh, "primitives": primitives}
    if node["mesh"] in used:
        document["meshes"].append(bound)
        node["mesh"] = len(document["meshes"]) - 1
    else:
        document["meshes"][node["mesh"]] = bound
    used.add(node["mesh"])
    node["skin"] = parts[0].skin


def _without_skin(primitive: Json) -> dict[str, Any]:
    attributes = primitive["attributes"].items()
    kept = {name: row for name, row in attributes if not name.startswith(OLD_SKIN)}
    return {**primitive, "attributes": kept}

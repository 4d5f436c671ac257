"""The layout of a posed frame: its JSON, and the place of each actor's joints and vertices in the binary
chunk.
"""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.gltf import json_text
from statwalk.files.gltf.builder import GENERATOR, INDICES, VERTICES, Builder, index_array
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.materials import extensions_used, with_textures_from
from statwalk.files.gltf.textures import Resources, add_textures, no_resources
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import triangles

# Slots in the JSON and their print formats, of constant width. The salt makes sure that no name in a file is
# equal to a slot.
SALT = secrets.token_hex(8)
HASH_SLOT, TICK_SLOT, NUMBER_SLOT = f"hash {SALT}", f"tick {SALT}", f"number {SALT}"
SLOTS = ((f'"{HASH_SLOT}"', '"%16.16b"'), (f'"{TICK_SLOT}"', "%10d"), (f'"{NUMBER_SLOT}"', "%16.8e"))


class ActorBlock(NamedTuple):
    """The byte offsets in the binary chunk of an actor's matrices (1+J,4,4), positions (V,3) and normals
    (V,3), float32.

    The matrices are in column-major order, as in glTF: the actor's root, then its joints.
    """

    matrices: int
    positions: int
    normals: int


class VertexLayout(NamedTuple):
    """The layout of a frame.

    text      the JSON as a %-format
    binary    the constant part of the binary chunk
    blocks    for each entry the blocks of its actors
    parts     the number of parts of all actors
    """

    text: bytes
    binary: bytearray
    blocks: list[list[ActorBlock]]
    parts: int


@dataclass
class LayoutDraft:
    """The layout of a frame, while it is built."""

    images: bool
    builder: Builder = field(default_factory=Builder)
    nodes: list[Json] = field(default_factory=list)
    meshes: list[Json] = field(default_factory=list)
    materials: list[Json] = field(default_factory=list)
    resources: Resources = field(default_factory=no_resources)
    parts: int = 0
    """number of the actors' parts so far: each part has its own bounds"""


def laid_out(entries: Sequence[tuple[Character, int]], *, images: bool) -> VertexLayout:
    """Returns the layout for a number of actors of each character."""
    draft = LayoutDraft(images)
    blocks = [_cast_blocks(draft, character, count) for character, count in entries]
    children = {child for node in draft.nodes for child in node.get("children", ())}
    root: Json = {
        "asset": {"version": "2.0", "generator": GENERATOR, "extras": {"hash": HASH_SLOT, "tick": TICK_SLOT}},
        "scene": 0,
        "scenes": [{"nodes": [row for row in range(len(draft.nodes)) if row not in children]}],
        "extensionsUsed": extensions_used([*draft.materials, *draft.resources["textures"]]),
        "nodes": draft.nodes,
        "meshes": draft.meshes,
        "materials": draft.materials,
        **draft.resources,
    }
    if not draft.nodes:
        del root["scene"], root["scenes"]
    text = json_text.dumps(draft.builder.finished(root)).decode().replace("%", "%%")
    for slot, print_format in SLOTS:
        text = text.replace(slot, print_format)
    return VertexLayout(text.encode(), draft.builder.binary, blocks, draft.parts)


def _cast_blocks(draft: LayoutDraft, character: Character, count: int) -> list[ActorBlock]:
    """Adds all actors of one character; they share the constant data."""
    first_material = len(draft.materials)
    first_texture = add_textures(draft.builder, draft.resources, character) if draft.images else None
    draft.materials += [with_textures_from(material, first_texture) for material in character.materials]
    mirrored = _mirrored_joints(character)
    constant_entries = [
        _constant_entry(draft.builder, part, first_material, bool(mirrored[part.joint]))
        for part in character.shown_parts
    ]
    return [_actor_block(draft, character, number, constant_entries) for number in range(count)]


def _mirrored_joints(character: Character) -> NDArray[np.bool_]:
    """Returns (J,): whether a joint's world matrix mirrors at rest, which reverses the triangles of its rigid
    parts (glTF 2.0, 3.7.4).
    """
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(
            np.linalg.det(world_from_local(character.skeleton, character.bind_pose)[..., :3]) < 0
        )


def _constant_entry(builder: Builder, part: Primitive, first_material: int, mirrored: bool) -> Json:
    """Returns a primitive without positions and normals."""
    entry: Json = {
        "attributes": {name: builder.array(values, VERTICES) for name, values in part.attributes.items()},
        "mode": part.mode,
    }
    indices = part.indices
    if mirrored and part.skin is None and part.mode >= TRIANGLES:
        vertex_order = np.arange(len(part.positions), dtype=np.uint32) if indices is None else indices
        indices, entry["mode"] = (
            triangles(vertex_order, part.mode)[:, ::-1].reshape(-1).astype(np.uint32),
            TRIANGLES,
        )
    if indices is not None:
        entry["indices"] = builder.array(index_array(indices, len(part.positions)), INDICES)
    if part.material is not None:
        entry["material"] = part.material + first_material
    return entry


def _actor_block(
    draft: LayoutDraft, character: Character, number: int, constant_entries: Sequence[Json]
) -> ActorBlock:
    """Adds an actor: its node, the mesh nodes below it, and room for its matrices and vertices."""
    matrices = draft.builder.array(np.tile(np.eye(4, dtype=np.float32), (1 + len(character.skeleton), 1, 1)))
    matrices_start = draft.builder.views[-1]["byteOffset"]
    actor: Json = {"name": f"{character.name} {number + 1}", "extras": {"joints": matrices}}
    draft.nodes.append(actor)
    total = sum(len(part.positions) for part in character.shown_parts)
    if not total:
        return ActorBlock(matrices_start, 0, 0)
    views = draft.builder.view(12 * total, VERTICES, 12), draft.builder.view(12 * total, VERTICES, 12)
    primitives_of_node: dict[int, list[Json]] = {}
    for part, vertex_range, entry in zip(
        character.shown_parts, character.surface.spans, constant_entries, strict=True
    ):
        attributes = _vertex_attributes(draft, part, views, vertex_range.start)
        primitives_of_node.setdefault(part.node, []).append(
            {**entry, "attributes": {**entry["attributes"], **attributes}}
        )
        draft.parts += 1
    names = dict(zip(character.node_index.tolist(), character.skeleton.names, strict=True))
    actor["children"] = [
        _mesh_node(draft, names.get(node, f"mesh {node}"), primitives)
        for node, primitives in primitives_of_node.items()
    ]
    starts = [draft.builder.views[view]["byteOffset"] for view in views]
    return ActorBlock(matrices_start, *starts)


def _vertex_attributes(
    draft: LayoutDraft, part: Primitive, views: tuple[int, int], first: int
) -> dict[str, int]:
    """Adds the accessors of positions and normals, for the vertices from `first` in the actor's block."""
    position = draft.builder.accessor(views[0], part.positions, bounds=False, offset=12 * first)
    draft.builder.accessors[position] |= {"min": [NUMBER_SLOT] * 3, "max": [NUMBER_SLOT] * 3}
    if part.normals is None:
        return {"POSITION": position}
    return {
        "POSITION": position,
        "NORMAL": draft.builder.accessor(views[1], part.positions, bounds=False, offset=12 * first),
    }


def _mesh_node(draft: LayoutDraft, name: str, primitives: list[Json]) -> int:
    """Adds a node with its own mesh; returns the node's index."""
    draft.meshes.append({"primitives": primitives})
    draft.nodes.append({"name": name, "mesh": len(draft.meshes) - 1})
    return len(draft.nodes) - 1

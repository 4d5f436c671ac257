"""The layout of a posed frame: what its JSON says and where in the binary chunk each actor's vertices are."""

from __future__ import annotations

import secrets
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
import orjson
from numpy.typing import NDArray

from statwalk.character import Character
from statwalk.files.glb.builder import GENERATOR, INDICES, VERTICES, Builder, index_array
from statwalk.files.glb.check import Json
from statwalk.files.glb.materials import extensions_used, moved
from statwalk.files.glb.textures import Resources, add_textures, no_resources
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import triangles

# Slots in the JSON and what is printed into them: always the same number of characters. The salt keeps a node of a file from being
# called like a slot.
SALT = secrets.token_hex(8)
HASH_SLOT, TICK_SLOT, NUMBER_SLOT = f"hash {SALT}", f"tick {SALT}", f"number {SALT}"
SLOTS = ((f'"{HASH_SLOT}"', '"%16.16b"'), (f'"{TICK_SLOT}"', "%10d"), (f'"{NUMBER_SLOT}"', "%16.8e"))


class ActorBlock(NamedTuple):
    """Where an actor's vertices start in the binary chunk: all positions (V,3), all normals (V,3), float32."""

    positions: int
    normals: int


class Layout(NamedTuple):
    """text: the JSON as a %-format; binary: what does not change; blocks: per entry its actors; parts: how many there are in all."""

    text: bytes
    binary: bytearray
    blocks: list[list[ActorBlock]]
    parts: int


@dataclass
class Draft:
    """A frame while it is laid out."""

    images: bool
    builder: Builder = field(default_factory=Builder)
    nodes: list[Json] = field(default_factory=list)
    meshes: list[Json] = field(default_factory=list)
    materials: list[Json] = field(default_factory=list)
    resources: Resources = field(default_factory=no_resources)
    parts: int = 0
    """actors' parts so far: each has bounds of its own"""


def laid_out(entries: Sequence[tuple[Character, int]], *, images: bool) -> Layout:
    """The layout for so many actors of each character."""
    draft = Draft(images)
    blocks = [cast_blocks(draft, character, count) for character, count in entries]
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
    text = orjson.dumps(draft.builder.finished(root)).decode().replace("%", "%%")
    for slot, printed in SLOTS:
        text = text.replace(slot, printed)
    return Layout(text.encode(), draft.builder.binary, blocks, draft.parts)


def cast_blocks(draft: Draft, character: Character, count: int) -> list[ActorBlock]:
    """Lay out all actors of one character; they share what does not change."""
    first_material = len(draft.materials)
    first_texture = add_textures(draft.builder, draft.resources, character) if draft.images else None
    draft.materials += [moved(material, first_texture) for material in character.materials]
    mirrored = mirrored_joints(character)
    constant = [constant_entry(draft.builder, part, first_material, bool(mirrored[part.joint])) for part in character.parts]
    return [actor_block(draft, character, number, constant) for number in range(count)]


def mirrored_joints(character: Character) -> NDArray[np.bool_]:
    """(J,) whether a joint's world matrix mirrors at rest: the triangles of its rigid parts then turn round (glTF 2.0, 3.7.4)."""
    with np.errstate(over="ignore", invalid="ignore"):
        return np.asarray(np.linalg.det(world_from_local(character.skeleton, character.bind_pose)[..., :3]) < 0)


def constant_entry(builder: Builder, part: Primitive, first_material: int, mirrored: bool) -> Json:
    """A primitive without its positions and normals."""
    entry: Json = {"attributes": {name: builder.array(values, VERTICES) for name, values in part.attributes.items()}, "mode": part.mode}
    indices = part.indices
    if mirrored and part.skin is None and part.mode >= TRIANGLES:
        listed = np.arange(len(part.positions), dtype=np.uint32) if indices is None else indices
        indices, entry["mode"] = triangles(listed, part.mode)[:, ::-1].reshape(-1).astype(np.uint32), TRIANGLES
    if indices is not None:
        entry["indices"] = builder.array(index_array(indices, len(part.positions)), INDICES)
    if part.material is not None:
        entry["material"] = part.material + first_material
    return entry


def actor_block(draft: Draft, character: Character, number: int, constant: Sequence[Json]) -> ActorBlock:
    """Lay out one actor: its node, mesh nodes below it, and room for its vertices."""
    actor: Json = {"name": f"{character.name} {number + 1}"}
    draft.nodes.append(actor)
    total = sum(len(part.positions) for part in character.parts)
    if not total:
        return ActorBlock(0, 0)
    views = draft.builder.view(12 * total, VERTICES, 12), draft.builder.view(12 * total, VERTICES, 12)
    by_node: dict[int, list[Json]] = {}
    for part, span, entry in zip(character.parts, character.surface.spans, constant, strict=True):
        attributes = vertex_attributes(draft, part, views, span.start)
        by_node.setdefault(part.node, []).append({**entry, "attributes": {**entry["attributes"], **attributes}})
        draft.parts += 1
    names = dict(zip(character.node_index.tolist(), character.skeleton.names, strict=True))
    actor["children"] = [mesh_node(draft, names.get(node, f"mesh {node}"), listed) for node, listed in by_node.items()]
    starts = [draft.builder.views[view]["byteOffset"] for view in views]
    return ActorBlock(*starts)


def vertex_attributes(draft: Draft, part: Primitive, views: tuple[int, int], first: int) -> dict[str, int]:
    """The accessors of what a pose changes, for the vertices from `first` in the actor's block."""
    position = draft.builder.accessor(views[0], part.positions, bounds=False, offset=12 * first)
    draft.builder.accessors[position] |= {"min": [NUMBER_SLOT] * 3, "max": [NUMBER_SLOT] * 3}
    if part.normals is None:
        return {"POSITION": position}
    return {"POSITION": position, "NORMAL": draft.builder.accessor(views[1], part.positions, bounds=False, offset=12 * first)}


def mesh_node(draft: Draft, name: str, primitives: list[Json]) -> int:
    """A node with a mesh of its own; its index."""
    draft.meshes.append({"primitives": primitives})
    draft.nodes.append({"name": name, "mesh": len(draft.meshes) - 1})
    return len(draft.nodes) - 1

"""Writes a character as a .glb: nodes, meshes, skins and animations (for characters that do not come from
glTF).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.gltf import container, json_text
from statwalk.files.gltf.builder import GENERATOR, INDICES, VERTICES, Builder, index_array
from statwalk.files.gltf.carried import character_extras, in_extras
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.detail import collapse_extras
from statwalk.files.gltf.materials import extensions_used, with_textures_from
from statwalk.files.gltf.model_textures import ModelTextures, add_to
from statwalk.files.gltf.write_animations import animation
from statwalk.skin.primitive import Primitive, Skin

MeshKey = tuple[int, int | None]


def model_glb(character: Character, textures: ModelTextures | None = None) -> bytes:
    """Returns the character as a GLB that any viewer opens.

    Node i of the file is the joint with node_index i. A part whose node is no joint gets its own node at the
    root, where skinned meshes belong. Without `textures` materials have none: a character with textures comes
    from a file that has them, and keeps its model. Limits, expressions, markers and loops are in
    extras. Clips with B-splines, which glTF lacks, are written as linear keys at 60 Hz.
    """
    builder = Builder()
    meshes = grouped(character.parts)
    numbers = {key: row for row, key in enumerate(meshes)}
    nodes = joint_nodes(character)
    for part in character.parts:
        nodes.setdefault(part.node, {"name": f"mesh {part.mesh}"})["mesh"] = numbers[part.mesh, part.skin]
        if part.skin is not None:
            nodes[part.node]["skin"] = part.skin
        if part.target_positions is not None:
            weight_end = part.weight_first + len(part.target_positions)
            nodes[part.node]["weights"] = character.bind_pose.weights[part.weight_first : weight_end].tolist()
    children = {child for node in nodes.values() for child in node.get("children", ())}
    first = None if textures is None else 0
    materials = [with_textures_from(material, first) for material in character.materials]
    resources = {} if textures is None else add_to(builder, textures)
    skins = [skin_entry(builder, character, skin) for skin in character.skins]
    root = {
        "asset": {"version": "2.0", "generator": GENERATOR},
        "scene": 0,
        "scenes": [{"name": character.name, "nodes": [row for row in sorted(nodes) if row not in children]}],
        "nodes": [nodes[row] for row in sorted(nodes)],
        "extensionsUsed": extensions_used([*materials, *resources.get("textures", ())]),
        "materials": materials,
        "meshes": [mesh_entry(builder, character, parts) for parts in meshes.values()],
        "skins": skins,
        **resources,
        "animations": [
            entry for clip in character.clips.values() if (entry := animation(builder, character, clip))
        ],
    }
    return container.join(
        json_text.dumps(builder.finished(in_extras(root, character_extras(character)))), bytes(builder.binary)
    )


def grouped(parts: tuple[Primitive, ...]) -> dict[MeshKey, list[Primitive]]:
    """Returns the parts by mesh and skin (a mesh may be rigid on one node and skinned on another), each
    primitive once.
    """
    meshes: dict[MeshKey, list[Primitive]] = {}
    for part in parts:
        group = meshes.setdefault((part.mesh, part.skin), [])
        if all(part.primitive != listed.primitive for listed in group):
            group.append(part)
    return meshes


def joint_nodes(character: Character) -> dict[int, Json]:
    """Returns the joints as nodes, by their number in the file."""
    pose, numbers = character.bind_pose, character.node_index.tolist()
    nodes: dict[int, Json] = {}
    for joint, (name, parent) in enumerate(
        zip(character.skeleton.names, character.skeleton.parent.tolist(), strict=True)
    ):
        node: Json = {"name": name}
        for key, values, default in (
            ("translation", pose.translation[joint], (0, 0, 0)),
            ("rotation", pose.rotation[joint], (0, 0, 0, 1)),
            ("scale", pose.scale[joint], (1, 1, 1)),
        ):
            if not np.array_equal(values, default):
                node[key] = values.tolist()
        nodes[numbers[joint]] = node
        if parent >= 0:
            nodes[numbers[parent]].setdefault("children", []).append(numbers[joint])
    return nodes


def skin_entry(builder: Builder, character: Character, skin: Skin) -> Json:
    """Adds a skin's matrices; returns the skin, its joints by their node in the file."""
    joints = character.node_index[skin.joints].tolist()
    return {"name": skin.name, "joints": joints, "inverseBindMatrices": builder.array(matrix_columns(skin))}


def mesh_entry(builder: Builder, character: Character, parts: Sequence[Primitive]) -> Json:
    """Adds the primitives of a mesh; returns the mesh as glTF, with the names of its morph targets."""
    mesh: Json = {"primitives": [primitive_entry(builder, part) for part in parts]}
    count = 0 if parts[0].target_positions is None else len(parts[0].target_positions)
    names = character.target_names[parts[0].weight_first : parts[0].weight_first + count]
    return in_extras(mesh, {"targetNames": list(names)} if any(names) else {})


def matrix_columns(skin: Skin) -> NDArray[np.float32]:
    """Returns the inverse bind matrices (K,16), written column by column."""
    matrices = np.zeros((len(skin.joints), 4, 4), np.float32)
    matrices[:, :3] = skin.inverse_bind
    matrices[:, 3, 3] = 1
    return np.ascontiguousarray(matrices.swapaxes(1, 2)).reshape(-1, 16)


def primitive_entry(builder: Builder, part: Primitive) -> Json:
    """Adds a primitive's arrays; returns the primitive as glTF."""
    attributes = {"POSITION": builder.array(part.positions, VERTICES, bounds=True)}
    if part.normals is not None:
        attributes["NORMAL"] = builder.array(part.normals, VERTICES)
    for name, values in part.attributes.items():
        attributes[name] = builder.array(values, VERTICES)
    if part.skin is not None and part.joints is not None and part.weights is not None:
        attributes |= influence_sets(builder, part.joints, part.weights)
    entry: Json = {"attributes": attributes, "mode": part.mode}
    if part.indices is not None:
        entry["indices"] = builder.array(index_array(part.indices, len(part.positions)), INDICES)
    if part.material is not None:
        entry["material"] = part.material
    if part.target_positions is not None:
        entry["targets"] = [_target_entry(builder, part, row) for row in range(len(part.target_positions))]
    return in_extras(entry, collapse_extras(builder, part))


def influence_sets(builder: Builder, joints: NDArray[Any], weights: NDArray[np.float32]) -> dict[str, int]:
    """Adds JOINTS_n and WEIGHTS_n, four influences each; an unused influence has joint 0 and weight 0."""
    padding = ((0, 0), (0, -joints.shape[1] % 4))
    padded_weights = np.pad(weights, padding).astype(np.float32)
    padded_joints = np.where(padded_weights > 0, np.pad(joints, padding), 0).astype(np.uint16)
    sets: dict[str, int] = {}
    for row in range(padded_weights.shape[1] // 4):
        columns = slice(4 * row, 4 * row + 4)
        sets[f"JOINTS_{row}"] = builder.array(np.ascontiguousarray(padded_joints[:, columns]), VERTICES)
        sets[f"WEIGHTS_{row}"] = builder.array(np.ascontiguousarray(padded_weights[:, columns]), VERTICES)
    return sets


def _target_entry(builder: Builder, part: Primitive, row: int) -> Json:
    assert part.target_positions is not None
    target = {"POSITION": builder.array(part.target_positions[row], VERTICES, bounds=True)}
    if part.target_normals is not None:
        target["NORMAL"] = builder.array(part.target_normals[row], VERTICES)
    return target

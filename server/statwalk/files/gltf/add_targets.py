"""Adds morph targets to the meshes of a model: columns of its meshes, of its default weights and of its
animations' keys.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf.builder import Builder
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.formats import COMPONENT_OF_DTYPE
from statwalk.files.gltf.write_animations import gltf_channels, sampler
from statwalk.motion.clip import Clip
from statwalk.skin.primitive import Primitive

DISPLACED = ("POSITION", "NORMAL", "TANGENT")
"""attributes of a target with rows (V, 3); all targets of a primitive have the same ones"""


def add_targets(document: Json, builder: Builder, character: Character) -> None:
    """Gives the meshes of a document the morph targets that the character's parts have after theirs, as
    sparse accessors. A node that alone gets targets gets a mesh of its own.

    :raises ContentError: when the document does not have the meshes of the character's parts.
    """
    by_node: dict[int, list[Primitive]] = {}
    for part in character.parts:
        if part.node < len(document["nodes"]):
            by_node.setdefault(part.node, []).append(part)
    old = {node: _mesh_of(document, node) for node in by_node}
    meshes = document["meshes"]
    targeted = {node: parts for node, parts in by_node.items() if _lacks(character, meshes[old[node]], parts)}
    sharing: dict[tuple[int, int], list[int]] = {}
    for node, parts in targeted.items():
        sharing.setdefault((old[node], parts[0].mesh), []).append(node)
    rows, before = [node.get("mesh") for node in document["nodes"]], list(meshes)
    for (row, _), nodes in sharing.items():
        mesh = _with_targets(before[row], builder, character, targeted[nodes[0]])
        is_left = sum(old[node] == row for node in targeted) == rows.count(row)
        place = row if is_left and meshes[row] is before[row] else len(meshes)
        meshes[place : place + 1] = [mesh]
        for node in nodes:
            entry, first = document["nodes"][node], targeted[node][0].weight_first
            entry["mesh"] = place
            entry["weights"] = character.bind_pose.weights[first : first + _count(targeted[node])].tolist()
    _add_keys(document, builder, character, targeted)


def _mesh_of(document: Json, node: int) -> int:
    row = document["nodes"][node].get("mesh")
    if not isinstance(row, int):
        raise ContentError(f"node {node} of the model has no mesh, but the character has one there")
    return row


def _count(parts: Sequence[Primitive]) -> int:
    return 0 if parts[0].target_positions is None else len(parts[0].target_positions)


def _primitives(mesh: Json, parts: Sequence[Primitive]) -> list[int]:
    """Returns which primitives of a mesh the parts are: those in a file that was written from a character are
    in the order of its parts.
    """
    count = len(mesh["primitives"])
    rows = list(range(count)) if len(parts) == count else [part.primitive for part in parts]
    if max(rows) >= count:
        raise ContentError(f"the model's mesh has {count} primitives, not primitive {max(rows)}")
    return rows


def _lacks(character: Character, mesh: Json, parts: Sequence[Primitive]) -> bool:
    """Returns whether a mesh lacks targets of its parts, or their names."""
    row = _primitives(mesh, parts)[0]
    extras = mesh.get("extras")
    written = extras.get("targetNames") if isinstance(extras, dict) else None
    names = _names(character, parts)
    is_named = not any(names) or written == names
    return _count(parts) > len(mesh["primitives"][row].get("targets", ())) or not is_named


def _names(character: Character, parts: Sequence[Primitive]) -> list[str]:
    first = parts[0].weight_first
    return list(character.target_names[first : first + _count(parts)])


def _with_targets(mesh: Json, builder: Builder, character: Character, parts: Sequence[Primitive]) -> Json:
    primitives = list(mesh["primitives"])
    for row, part in zip(_primitives(mesh, parts), parts, strict=True):
        primitives[row] = {**primitives[row], "targets": _targets(builder, primitives[row], part)}
    own, count = mesh.get("extras"), _count(parts)
    extras = {**(own if isinstance(own, dict) else {}), "targetNames": _names(character, parts)}
    made = {**mesh, "primitives": primitives, "extras": extras}
    if "weights" in mesh:
        made["weights"] = [*mesh["weights"], *[0.0] * (count - len(mesh["weights"]))]
    return made


def _targets(builder: Builder, primitive: Json, part: Primitive) -> list[Json]:
    """Returns the targets of a primitive, its own first; a displacement that only others have is zero."""
    assert part.target_positions is not None
    old = [dict(target) for target in primitive.get("targets", ())]
    columns: dict[str, NDArray[np.float32]] = {"POSITION": part.target_positions}
    if part.target_normals is not None and "NORMAL" in primitive["attributes"]:
        columns["NORMAL"] = part.target_normals
    new = [
        {name: sparse(builder, values[row], bounds=name == "POSITION") for name, values in columns.items()}
        for row in range(len(old), len(part.target_positions))
    ]
    targets = [*old, *new]
    still = np.zeros_like(part.positions)
    for name in DISPLACED:
        lacking = [target for target in targets if name not in target]
        if 0 < len(lacking) < len(targets):
            row = sparse(builder, still, bounds=name == "POSITION")
            for target in lacking:
                target[name] = row
    return targets


def _add_keys(
    document: Json, builder: Builder, character: Character, targeted: Mapping[int, Sequence[Primitive]]
) -> None:
    """Replaces the keys of the weights of some nodes, which have columns more."""
    animations = document.get("animations", [])
    for entry, clip in zip(animations, _clips_of(animations, character), strict=True):
        for channel in entry["channels"]:
            node = channel.get("target", {}).get("node")
            if channel.get("target", {}).get("path") != "weights" or node not in targeted:
                continue
            joint = targeted[node][0].joint
            keys = next((k for k in gltf_channels(clip) if (k.joint, k.path) == (joint, "weights")), None)
            if keys is not None:
                entry["samplers"].append(sampler(builder, keys))
                channel["sampler"] = len(entry["samplers"]) - 1


def _clips_of(animations: Sequence[Json], character: Character) -> list[Clip]:
    """Returns the clip of each animation: the model's own come first, and of later ones only a clip with
    channels is an animation.
    """
    clips = list(character.clips.values())
    bare = [row for row, clip in enumerate(clips) if not len(clip.channels)]
    absent = bare[len(bare) - (len(clips) - len(animations)) :] if len(clips) > len(animations) else []
    return [clip for row, clip in enumerate(clips) if row not in absent]


def sparse(builder: Builder, values: NDArray[np.float32], *, bounds: bool = False) -> int:
    """Adds an array (V, 3), most of whose rows are zeros, as a sparse accessor (glTF 2.0, 3.6.2.3); returns
    its index.
    """
    rows = np.flatnonzero(values.any(axis=1))
    rows = rows if len(rows) else np.zeros(1, np.int64)
    numbers = rows.astype("<u2" if len(values) <= 0xFFFF else "<u4")
    accessor: Json = {
        "componentType": COMPONENT_OF_DTYPE[np.dtype("<f4")],
        "count": len(values),
        "type": "VEC3",
        "sparse": {
            "count": len(rows),
            "indices": {
                "bufferView": builder.data(numbers.tobytes()),
                "componentType": COMPONENT_OF_DTYPE[numbers.dtype],
            },
            "values": {"bufferView": builder.data(np.ascontiguousarray(values[rows]).tobytes())},
        },
    }
    if bounds:
        accessor |= {"min": values.min(axis=0).tolist(), "max": values.max(axis=0).tolist()}
    builder.accessors.append(accessor)
    return len(builder.accessors) - 1

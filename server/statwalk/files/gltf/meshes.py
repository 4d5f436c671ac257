"""Reads meshes: each primitive once, then placed on every node that carries its mesh (glTF 2.0, 3.7)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.allowance import Allowance, drawn_vertices, mesh_vertices
from statwalk.files.gltf.attributes import constant_attributes, influences, normals, targets, vector
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import INDICES
from statwalk.files.gltf.nodes import Hierarchy
from statwalk.skin.primitive import TRIANGLES, Primitive, Skin
from statwalk.skin.weights import normalised

MODES = range(7)
LONGEST_TARGET_NAME = 200
CARRIED = frozenset(("mesh", "skin", "camera"))
"""fields of a node that refer to an object on the node"""


class Influences(NamedTuple):
    """The skin influences of a primitive, as the file has them: joints (V,I) of the skin and weights
    (V,I).
    """

    joints: NDArray[np.integer]
    weights: NDArray[np.float32]


@dataclass
class Meshes:
    """The meshes of a document; each is read on first use."""

    document: Document
    accessors: Accessors
    read: dict[int, list[tuple[Primitive, Influences | None]]] = field(default_factory=dict)
    vertices: Allowance = field(default_factory=mesh_vertices)

    def mesh(self, row: int) -> list[tuple[Primitive, Influences | None]]:
        """Returns the primitives of a mesh, not placed yet; primitives without positions are left out.

        :raises ModelError: when a primitive is wrong, or primitives have different numbers of morph targets.
        """
        if row not in self.read:
            place = f"/meshes/{row}"
            entries = check.objects(self.document["meshes"][row], "primitives", place, required=True)
            primitives = [
                self.primitive(row, k, entry, f"{place}/primitives/{k}") for k, entry in enumerate(entries)
            ]
            self.read[row] = [primitive for primitive in primitives if primitive is not None]
            if len({_target_count(primitive) for primitive, _ in self.read[row]}) > 1:
                raise ModelError(
                    "the primitives of a mesh must have the same number of morph targets", place=place
                )
        return self.read[row]

    def primitive(
        self, mesh: int, row: int, entry: Json, place: str
    ) -> tuple[Primitive, Influences | None] | None:
        """Returns a primitive at rest; None if it has no positions."""
        attributes = check.mapping(entry, "attributes", place)
        positions = vector(self.document, self.accessors, attributes, "POSITION", f"{place}/attributes")
        if positions is None:
            self.document.note("a primitive without positions is not drawn")
            return None
        count = len(positions)
        counted_attributes = len(attributes) + len(check.items(entry, "targets", place)) // 4
        self.vertices.take(count * counted_attributes, f"{place}/attributes/POSITION")
        mode = check.one_of(entry, "mode", place, MODES, TRIANGLES)
        indices = self.indices(entry, count, place)
        target_positions, target_normals = targets(self.document, self.accessors, entry, count, place)
        primitive = Primitive(
            joint=0,
            node=0,
            mesh=mesh,
            primitive=row,
            positions=positions,
            normals=normals(
                self.document, self.accessors, attributes, positions, indices, mode, f"{place}/attributes"
            ),
            indices=indices,
            mode=mode,
            material=check.reference(entry, "material", place, self.document["materials"], "material"),
            target_positions=target_positions,
            target_normals=target_normals,
            attributes=constant_attributes(
                self.document, self.accessors, attributes, count, f"{place}/attributes"
            ),
        )
        skin_influences = influences(self.document, self.accessors, attributes, count, f"{place}/attributes")
        return primitive, None if skin_influences is None else Influences(*skin_influences)

    def indices(self, entry: Json, count: int, place: str) -> NDArray[np.uint32] | None:
        """Returns vertex numbers (N,), each below `count`; None if the vertices are drawn in order.

        :raises ModelError: when an index is too large.
        """
        row = check.reference(entry, "indices", place, self.document["accessors"], "accessor")
        if row is None:
            return None
        values = self.accessors.read(row, INDICES, f"{place}/indices")
        if int(values.max()) >= count:
            raise ModelError(
                f"an index is {int(values.max())}; the primitive has {count} vertices",
                place=f"{place}/indices",
            )
        self.vertices.take(len(values) // 3, f"{place}/indices")
        return values.astype(np.uint32, copy=False)


def _target_count(primitive: Primitive) -> int:
    return 0 if primitive.target_positions is None else len(primitive.target_positions)


class Drawn(NamedTuple):
    """The placed primitives, the weights at rest (W,) of all morph targets, for each node (first, count) of
    its weights, and the names (W,) of the targets, "" without a name.
    """

    parts: tuple[Primitive, ...]
    weights: NDArray[np.float32]
    weight_span: dict[int, tuple[int, int]]
    target_names: tuple[str, ...]


def place_meshes(
    document: Document, accessors: Accessors, nodes: Hierarchy, skins: tuple[Skin, ...]
) -> Drawn:
    """Places every mesh on every node of the scene that carries it, in the order of the file's nodes."""
    meshes, vertices = Meshes(document, accessors), drawn_vertices()
    bind = partial(_bind, document, skins, {})
    parts: list[Primitive] = []
    weights: list[float] = []
    names: list[str] = []
    weight_span: dict[int, tuple[int, int]] = {}
    for row, node in enumerate(document["nodes"]):
        if CARRIED.isdisjoint(node):
            continue
        place = f"/nodes/{row}"
        mesh = check.reference(node, "mesh", place, document["meshes"], "mesh")
        skin = check.reference(node, "skin", place, document["skins"], "skin")
        check.reference(node, "camera", place, document["cameras"], "camera")
        if mesh is None:
            continue
        primitives = meshes.mesh(mesh)
        first, count = len(weights), _target_count(primitives[0][0]) if primitives else 0
        weights += _rest_weights(document, node, mesh, count, place)
        names += _target_names(document, mesh, count)
        weight_span[row] = (first, count)
        joint = int(nodes.joint_of[row])
        if nodes.drawn[joint]:
            vertices.take(sum(len(primitive.positions) for primitive, _ in primitives), f"{place}/mesh")
            placed = [bind(primitive, skin_influences, skin) for primitive, skin_influences in primitives]
            parts += [replace(part, node=row, joint=joint, weight_first=first) for part in placed]
    for row in range(len(document["meshes"])):
        meshes.mesh(row)
    return Drawn(tuple(parts), np.array(weights, np.float32), weight_span, tuple(names) if any(names) else ())


def _rest_weights(document: Document, node: Json, mesh: int, count: int, place: str) -> list[float]:
    """Returns the morph weights at rest: the node's, otherwise the mesh's, otherwise zeros."""
    if "weights" in node:
        return check.numbers(node, "weights", place, count)
    return check.numbers(document["meshes"][mesh], "weights", f"/meshes/{mesh}", count, [0.0] * count)


def _target_names(document: Document, mesh: int, count: int) -> list[str]:
    """Returns the names in a mesh's `extras.targetNames` (glTF 2.0, 3.7.2.2), "" where there is none."""
    extras = document["meshes"][mesh].get("extras")
    written = extras.get("targetNames") if isinstance(extras, dict) else None
    names = written[:count] if isinstance(written, list) else []
    read = [name[:LONGEST_TARGET_NAME] if isinstance(name, str) else "" for name in names]
    return read + [""] * (count - len(read))


Bound = dict[tuple[int, int, int], Primitive]


def _bind(
    document: Document,
    skins: tuple[Skin, ...],
    bound_parts: Bound,
    part: Primitive,
    skin_influences: Influences | None,
    skin: int | None,
) -> Primitive:
    """Returns the primitive with its skin, weights normalised; unchanged (rigid) if the node has no skin or
    the mesh no joints.
    """
    if skin is None or skin_influences is None:
        return part
    key = (part.mesh, part.primitive, skin)
    if key not in bound_parts:
        place = f"/meshes/{part.mesh}/primitives/{part.primitive}/attributes/JOINTS_0"
        joints_in_use = _joints_in_use(skin_influences, len(skins[skin].joints), skin, place)
        joints, weights, corrected = normalised(joints_in_use, skin_influences.weights)
        if corrected:
            document.note(
                f"skin weights did not sum to 1 and were normalised: {corrected} of {len(weights)} vertices "
                f"of mesh {part.mesh}"
            )
        bound_parts[key] = replace(part, skin=skin, joints=joints, weights=weights)
    return bound_parts[key]


def _joints_in_use(skin_influences: Influences, count: int, skin: int, place: str) -> NDArray[np.integer]:
    """Returns the joints (V,I), each below `count`; joints without weight are replaced by joint 0 if any
    joint is too large.
    """
    if int(skin_influences.joints.max()) < count:
        return skin_influences.joints
    weighted_joints = skin_influences.joints * (skin_influences.weights > 0)
    if int(weighted_joints.max()) >= count:
        raise ModelError(
            f"a joint index is {int(weighted_joints.max())}; skin {skin} has {count} joints", place=place
        )
    return weighted_joints

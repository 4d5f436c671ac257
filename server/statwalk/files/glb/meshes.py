"""Meshes: their primitives read once, then placed on every node that carries them (glTF 2.0, 3.7)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.accessors import Accessors
from statwalk.files.glb.allowance import Allowance, drawn_vertices, mesh_vertices
from statwalk.files.glb.attributes import constant_attributes, influences, normals, targets, vector
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import INDICES
from statwalk.files.glb.nodes import Hierarchy
from statwalk.skin.primitive import TRIANGLES, Primitive, Skin
from statwalk.skin.weights import normalised

MODES = range(7)
CARRIED = frozenset(("mesh", "skin", "camera"))
"""what a node may carry"""


class Influences(NamedTuple):
    """What skins a primitive, as the file has it: joints (V,I) of the skin and weights (V,I)."""

    joints: NDArray[np.integer]
    weights: NDArray[np.float32]


@dataclass
class Meshes:
    """The meshes of a document, read when a node first carries them."""

    document: Document
    accessors: Accessors
    read: dict[int, list[tuple[Primitive, Influences | None]]] = field(default_factory=dict)
    vertices: Allowance = field(default_factory=mesh_vertices)

    def mesh(self, row: int) -> list[tuple[Primitive, Influences | None]]:
        """The primitives of a mesh, not placed yet. One without positions cannot be drawn and is left out."""
        if row not in self.read:
            place = f"/meshes/{row}"
            listed = check.objects(self.document["meshes"][row], "primitives", place, required=True)
            found = [self.primitive(row, k, entry, f"{place}/primitives/{k}") for k, entry in enumerate(listed)]
            self.read[row] = [primitive for primitive in found if primitive is not None]
            if len({target_count(primitive) for primitive, _ in self.read[row]}) > 1:
                raise ModelError("its primitives have different numbers of morph targets", place=place)
        return self.read[row]

    def primitive(self, mesh: int, row: int, entry: Json, place: str) -> tuple[Primitive, Influences | None] | None:
        """One primitive at rest; None without positions."""
        attributes = check.mapping(entry, "attributes", place)
        positions = vector(self.document, self.accessors, attributes, "POSITION", f"{place}/attributes")
        if positions is None:
            self.document.note("a primitive without positions is not drawn")
            return None
        count = len(positions)
        asked = len(attributes) + len(check.items(entry, "targets", place)) // 4
        self.vertices.take(count * asked, f"{place}/attributes/POSITION")
        mode = check.one_of(entry, "mode", place, MODES, TRIANGLES)
        indices = self.indices(entry, count, place)
        target_positions, target_normals = targets(self.document, self.accessors, entry, count, place)
        primitive = Primitive(
            joint=0,
            node=0,
            mesh=mesh,
            primitive=row,
            positions=positions,
            normals=normals(self.document, self.accessors, attributes, positions, indices, mode, f"{place}/attributes"),
            indices=indices,
            mode=mode,
            material=check.reference(entry, "material", place, self.document["materials"], "material"),
            target_positions=target_positions,
            target_normals=target_normals,
            attributes=constant_attributes(self.document, self.accessors, attributes, count, f"{place}/attributes"),
        )
        found = influences(self.document, self.accessors, attributes, count, f"{place}/attributes")
        return primitive, None if found is None else Influences(*found)

    def indices(self, entry: Json, count: int, place: str) -> NDArray[np.uint32] | None:
        """(N,) vertex numbers, each below `count`; None where the vertices are drawn in order."""
        row = check.reference(entry, "indices", place, self.document["accessors"], "accessor")
        if row is None:
            return None
        values = self.accessors.read(row, INDICES, f"{place}/indices")
        if int(values.max()) >= count:
            raise ModelError(f"it points at vertex {int(values.max())}; there are {count}", place=f"{place}/indices")
        self.vertices.take(len(values) // 3, f"{place}/indices")
        return values.astype(np.uint32, copy=False)


def target_count(primitive: Primitive) -> int:
    """The number of morph targets."""
    return 0 if primitive.target_positions is None else len(primitive.target_positions)


class Drawn(NamedTuple):
    """The placed primitives, the weights at rest (W,) of all morph targets, and per node where its weights start and how many."""

    parts: tuple[Primitive, ...]
    weights: NDArray[np.float32]
    weight_span: dict[int, tuple[int, int]]


def place_meshes(document: Document, accessors: Accessors, nodes: Hierarchy, skins: tuple[Skin, ...]) -> Drawn:
    """Every mesh on every node of the scene that carries it, in the order of the nodes in the file."""
    meshes, vertices = Meshes(document, accessors), drawn_vertices()
    bound = partial(bind, document, skins, {})
    parts: list[Primitive] = []
    weights: list[float] = []
    span: dict[int, tuple[int, int]] = {}
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
        first, count = len(weights), target_count(primitives[0][0]) if primitives else 0
        weights += rest_weights(document, node, mesh, count, place)
        span[row] = (first, count)
        joint = int(nodes.joint_of[row])
        if nodes.drawn[joint]:
            vertices.take(sum(len(primitive.positions) for primitive, _ in primitives), f"{place}/mesh")
            placed = [bound(primitive, found, skin) for primitive, found in primitives]
            parts += [replace(part, node=row, joint=joint, weight_first=first) for part in placed]
    for row in range(len(document["meshes"])):
        meshes.mesh(row)
    return Drawn(tuple(parts), np.array(weights, np.float32), span)


def rest_weights(document: Document, node: Json, mesh: int, count: int, place: str) -> list[float]:
    """The morph weights at rest: the node's, else the mesh's, else zeros."""
    if "weights" in node:
        return check.numbers(node, "weights", place, count)
    return check.numbers(document["meshes"][mesh], "weights", f"/meshes/{mesh}", count, [0.0] * count)


Bound = dict[tuple[int, int, int], Primitive]


def bind(
    document: Document, skins: tuple[Skin, ...], known: Bound, part: Primitive, found: Influences | None, skin: int | None
) -> Primitive:
    """The primitive with its skin, weights normalised; rigid where the node has no skin or the mesh no joints."""
    if skin is None or found is None:
        return part
    key = (part.mesh, part.primitive, skin)
    if key not in known:
        where = f"/meshes/{part.mesh}/primitives/{part.primitive}/attributes/JOINTS_0"
        used = joints_in_use(found, len(skins[skin].joints), skin, where)
        joints, weights, off = normalised(used, found.weights)
        if off:
            document.note(f"skin weights did not sum to 1 and were normalised: {off} of {len(weights)} vertices of mesh {part.mesh}")
        known[key] = replace(part, skin=skin, joints=joints, weights=weights)
    return known[key]


def joints_in_use(found: Influences, count: int, skin: int, place: str) -> NDArray[np.integer]:
    """The joints (V,I), each below `count`; those without weight are joint 0 where some are not."""
    if int(found.joints.max()) < count:
        return found.joints
    used = found.joints * (found.weights > 0)
    if int(used.max()) >= count:
        raise ModelError(f"it points at joint {int(used.max())}; skin {skin} has {count}", place=place)
    return used

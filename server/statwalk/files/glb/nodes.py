"""Nodes: the hierarchy, parents first, and the transforms at rest (glTF 2.0, 3.5)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.check import Json
from statwalk.files.glb.columns import lists_of_indices, vectors
from statwalk.files.glb.document import Document
from statwalk.files.glb.names import unique
from statwalk.maths import quat
from statwalk.rig.skeleton import Skeleton

MOST_NODES, DEEPEST = 65_536, 4_096
REST: dict[str, list[float]] = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]}
"""what a node's transform is made of, and where it has none"""


class Hierarchy(NamedTuple):
    """The nodes as joints: `node_index` (J,) the node of each joint, `joint_of` its inverse, `drawn` whether the scene holds it."""

    skeleton: Skeleton
    node_index: NDArray[np.int32]
    joint_of: NDArray[np.int32]
    drawn: NDArray[np.bool_]


class RestTransforms(NamedTuple):
    """Local transforms of the joints at rest: translation (J,3), rotation (J,4) xyzw, scale (J,3), float32."""

    translation: NDArray[np.float32]
    rotation: NDArray[np.float32]
    scale: NDArray[np.float32]


def hierarchy(document: Document) -> Hierarchy:
    """Every node of the file as a joint, parents first. Raises ModelError for cycles and nodes with two parents."""
    nodes = document["nodes"]
    if len(nodes) > MOST_NODES:
        raise ModelError(f"there are {len(nodes)} nodes; {MOST_NODES} are allowed", place="/nodes")
    children = lists_of_indices(nodes, "children", len(nodes)) or [children_of(nodes, row, node) for row, node in enumerate(nodes)]
    parent = parents_of(children)
    order = parents_first(children, parent)
    node_index = np.array(order, np.int32)
    joint_of = np.empty(len(nodes), np.int32)
    joint_of[node_index] = np.arange(len(nodes), dtype=np.int32)
    labels = check.labels(nodes, "/nodes")
    names = unique([labels[row] for row in order], "node", order)
    above = np.array(parent, np.int32)[node_index]
    parents = np.where(above < 0, np.int32(-1), joint_of[above])
    drawn = np.zeros(len(nodes), bool)
    roots = scene_roots(document, parent)
    all_are_drawn = len(roots) == np.count_nonzero(above < 0)
    drawn[joint_of[np.array(order if all_are_drawn else reached(roots, children), np.intp)]] = True
    return Hierarchy(Skeleton(tuple(names), parents), node_index, joint_of, drawn)


def children_of(nodes: list[Json], row: int, node: Json) -> list[int]:
    """The children of a node, checked to be nodes."""
    place = f"/nodes/{row}"
    return check.indices(check.items(node, "children", place), f"{place}/children", nodes, "node")


def parents_of(children: Sequence[Sequence[int]]) -> list[int]:
    """The parent of every node, -1 for roots."""
    parent = [-1] * len(children)
    for row, listed in enumerate(children):
        for k, child in enumerate(listed):
            if parent[child] >= 0:
                raise ModelError(f"node {child} is already a child of node {parent[child]}", place=f"/nodes/{row}/children/{k}")
            parent[child] = row
    return parent


def parents_first(children: Sequence[Sequence[int]], parent: Sequence[int]) -> list[int]:
    """The nodes in an order in which parents come first; nodes that no root leads to are part of a cycle."""
    order = reached([row for row, above in enumerate(parent) if above < 0], children)
    if len(order) < len(parent):
        lost = next(iter(set(range(len(parent))) - set(order)))
        raise ModelError("following the children leads back to this node", place=f"/nodes/{lost}/children")
    return order


def reached(roots: Sequence[int], children: Sequence[Sequence[int]]) -> list[int]:
    """All nodes below the roots, each before its children. Nodes have one parent at most, so none comes twice."""
    order: list[int] = []
    ready = [(root, 1) for root in reversed(roots)]
    while ready:
        row, depth = ready.pop()
        if depth > DEEPEST:
            raise ModelError(f"nodes are nested deeper than {DEEPEST}", place=f"/nodes/{row}")
        order.append(row)
        ready += [(child, depth + 1) for child in reversed(children[row])]
    return order


def scene_roots(document: Document, parent: Sequence[int]) -> list[int]:
    """The roots of the scene that is shown: the default one, else the first, else every root of the file."""
    scenes = document["scenes"]
    listed = [scene_nodes(document, row, scene, parent) for row, scene in enumerate(scenes)]
    chosen = check.reference(document.root, "scene", "", scenes, "scene")
    return listed[chosen or 0] if listed else [row for row, above in enumerate(parent) if above < 0]


def scene_nodes(document: Document, row: int, scene: Json, parent: Sequence[int]) -> list[int]:
    """The nodes of one scene, which must be roots and differ."""
    place = f"/scenes/{row}"
    found: dict[int, None] = {}
    for k, value in enumerate(check.items(scene, "nodes", place)):
        node = check.index(value, f"{place}/nodes/{k}", document["nodes"], "node")
        if parent[node] >= 0 or node in found:
            raise ModelError(f"node {node} must be a root, and listed once", place=f"{place}/nodes/{k}")
        found[node] = None
    return list(found)


def rest_transforms(document: Document, order: NDArray[np.int32]) -> RestTransforms:
    """The local transforms of the nodes in the order given; matrices are taken apart, rotations brought to unit length."""
    nodes = document["nodes"]
    plain = [] if any("matrix" in node for node in nodes) else [vectors(nodes, *one) for one in REST.items()]
    given = [values for values in plain if values is not None]
    if len(given) < len(REST):
        rows = [node_transform(document, row, node) for row, node in enumerate(nodes)]
        given = [np.array(values, np.float64) for values in zip(*rows, strict=True)]
    translation, rotation, scale = (values[order] for values in given)
    if (np.abs(quat.dot(rotation, rotation) - 1) > 1e-3).any():
        document.note("node rotations were not of unit length and were normalised")
    return RestTransforms(translation.astype(np.float32), quat.normalize(rotation).astype(np.float32), scale.astype(np.float32))


def node_transform(document: Document, row: int, node: Json) -> tuple[Sequence[float], Sequence[float], Sequence[float]]:
    """Translation, rotation and scale of one node."""
    place = f"/nodes/{row}"
    if "matrix" in node:
        return taken_apart(document, check.numbers(node, "matrix", place, 16))
    return (
        check.numbers(node, "translation", place, 3, REST["translation"]),
        check.numbers(node, "rotation", place, 4, REST["rotation"]),
        check.numbers(node, "scale", place, 3, REST["scale"]),
    )


def taken_apart(document: Document, matrix: list[float]) -> tuple[list[float], list[float], list[float]]:
    """Translation, rotation and scale of a matrix written column by column; a mirrored one gets a negative X scale."""
    columns = np.array(matrix, np.float64).reshape(4, 4)[:3, :3]
    scale = np.sqrt((columns**2).sum(axis=1))
    if np.linalg.det(columns) < 0:
        scale[0] = -scale[0]
    axes = np.where(scale[:, None] == 0, np.eye(3), columns / np.where(scale == 0, 1, scale)[:, None])
    if np.abs(axes @ axes.T - np.eye(3)).max() > 1e-3:
        document.note("a node's matrix is skewed and was replaced by the nearest translation, rotation and scale")
    rotation = quat.from_matrix(axes.T)
    return matrix[12:15], rotation.tolist(), scale.tolist()

"""Nodes: the hierarchy, parents first, and the transforms at rest (glTF 2.0, 3.5)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.names import unique
from statwalk.maths import quat
from statwalk.rig.skeleton import Skeleton

MOST_NODES, DEEPEST = 65_536, 4_096


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
    children = [children_of(document, row, node) for row, node in enumerate(nodes)]
    parent = parents_of(children)
    order = parents_first(children, parent)
    joint_of = np.empty(len(nodes), np.int32)
    joint_of[order] = np.arange(len(nodes), dtype=np.int32)
    names = unique([check.label(nodes[row], f"/nodes/{row}") for row in order], "node", order)
    parents = np.array([joint_of[parent[row]] if parent[row] >= 0 else -1 for row in order], np.int32)
    drawn = np.zeros(len(nodes), bool)
    drawn[[joint_of[row] for row in reached(scene_roots(document, parent), children)]] = True
    return Hierarchy(Skeleton(tuple(names), parents), np.array(order, np.int32), joint_of, drawn)


def children_of(document: Document, row: int, node: Json) -> list[int]:
    """The children of a node, checked to be nodes."""
    place = f"/nodes/{row}"
    listed = check.items(node, "children", place)
    return [check.index(child, f"{place}/children/{k}", document["nodes"], "node") for k, child in enumerate(listed)]


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
    rows = [node_transform(document, row, document["nodes"][row]) for row in order.tolist()]
    translation = np.array([row[0] for row in rows], np.float32).reshape(-1, 3)
    rotation = np.array([row[1] for row in rows], np.float64).reshape(-1, 4)
    scale = np.array([row[2] for row in rows], np.float32).reshape(-1, 3)
    if np.any(np.abs((rotation**2).sum(axis=1) - 1) > 1e-3):
        document.note("node rotations were not of unit length and were normalised")
    return RestTransforms(translation, quat.normalize(rotation).astype(np.float32), scale)


def node_transform(document: Document, row: int, node: Json) -> tuple[Sequence[float], Sequence[float], Sequence[float]]:
    """Translation, rotation and scale of one node."""
    place = f"/nodes/{row}"
    if "matrix" in node:
        return taken_apart(document, check.numbers(node, "matrix", place, 16))
    return (
        check.numbers(node, "translation", place, 3, [0, 0, 0]),
        check.numbers(node, "rotation", place, 4, [0, 0, 0, 1]),
        check.numbers(node, "scale", place, 3, [1, 1, 1]),
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

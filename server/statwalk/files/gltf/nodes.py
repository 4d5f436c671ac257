"""Reads nodes: the hierarchy, parents first, and the transforms at rest (glTF 2.0, 3.5)."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.columns import lists_of_indices, vectors
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.names import unique
from statwalk.maths import quat, transform
from statwalk.rig.skeleton import Skeleton

MOST_NODES, DEEPEST = 65_536, 4_096
REST: dict[str, list[float]] = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1], "scale": [1, 1, 1]}
"""the fields of a node's transform, with their defaults"""


class Hierarchy(NamedTuple):
    """The nodes as joints: `node_index` (J,) is the node of each joint, `joint_of` (J,) its inverse, `drawn`
    (J,) is true for the nodes of the scene.
    """

    skeleton: Skeleton
    node_index: NDArray[np.int32]
    joint_of: NDArray[np.int32]
    drawn: NDArray[np.bool_]


class RestTransforms(NamedTuple):
    """Local transforms of the joints at rest: translation (J,3), rotation (J,4) xyzw, scale (J,3),
    float32.
    """

    translation: NDArray[np.float32]
    rotation: NDArray[np.float32]
    scale: NDArray[np.float32]


def hierarchy(document: Document) -> Hierarchy:
    """Returns every node of the file as a joint, parents first.

    :raises ModelError: when nodes form a cycle, a node has two parents, or there are too many nodes.
    """
    nodes = document["nodes"]
    if len(nodes) > MOST_NODES:
        raise ModelError(f"the file has {len(nodes)} nodes; at most {MOST_NODES} are allowed", place="/nodes")
    children = lists_of_indices(nodes, "children", len(nodes)) or [
        _children_of(nodes, row, node) for row, node in enumerate(nodes)
    ]
    parent = _parents_of(children)
    order = _parents_first(children, parent)
    node_index = np.array(order, np.int32)
    joint_of = np.empty(len(nodes), np.int32)
    joint_of[node_index] = np.arange(len(nodes), dtype=np.int32)
    labels = check.labels(nodes, "/nodes")
    names = unique([labels[row] for row in order], "node", order)
    parent_of_joint = np.array(parent, np.int32)[node_index]
    parents = np.where(parent_of_joint < 0, np.int32(-1), joint_of[parent_of_joint])
    drawn = np.zeros(len(nodes), bool)
    roots = _scene_roots(document, parent)
    draws_all = len(roots) == np.count_nonzero(parent_of_joint < 0)
    drawn[joint_of[np.array(order if draws_all else _reached(roots, children), np.intp)]] = True
    return Hierarchy(Skeleton(tuple(names), parents), node_index, joint_of, drawn)


def _children_of(nodes: list[Json], row: int, node: Json) -> list[int]:
    place = f"/nodes/{row}"
    return check.indices(check.items(node, "children", place), f"{place}/children", nodes, "node")


def _parents_of(children: Sequence[Sequence[int]]) -> list[int]:
    """Returns the parent of every node, -1 for roots."""
    parent = [-1] * len(children)
    for row, row_children in enumerate(children):
        for k, child in enumerate(row_children):
            if parent[child] >= 0:
                raise ModelError(
                    f"node {child} is already a child of node {parent[child]}",
                    place=f"/nodes/{row}/children/{k}",
                )
            parent[child] = row
    return parent


def _parents_first(children: Sequence[Sequence[int]], parent: Sequence[int]) -> list[int]:
    """Returns the nodes in an order with parents first; a node that no root leads to is part of a cycle."""
    order = _reached([row for row, parent_row in enumerate(parent) if parent_row < 0], children)
    if len(order) < len(parent):
        cycle_row = next(iter(set(range(len(parent))) - set(order)))
        raise ModelError(
            "this node is its own descendant; remove one of the children",
            place=f"/nodes/{cycle_row}/children",
        )
    return order


def _reached(roots: Sequence[int], children: Sequence[Sequence[int]]) -> list[int]:
    """Returns all nodes below the roots, each before its children.

    A node has at most one parent, so no node is reached twice.
    """
    order: list[int] = []
    pending = [(root, 1) for root in reversed(roots)]
    while pending:
        row, depth = pending.pop()
        if depth > DEEPEST:
            raise ModelError(f"nodes are nested deeper than {DEEPEST}", place=f"/nodes/{row}")
        order.append(row)
        pending += [(child, depth + 1) for child in reversed(children[row])]
    return order


def _scene_roots(document: Document, parent: Sequence[int]) -> list[int]:
    """Returns the roots of the shown scene: the default one, otherwise the first, otherwise every root of the
    file.
    """
    scenes = document["scenes"]
    roots_of_scenes = [_scene_nodes(document, row, scene, parent) for row, scene in enumerate(scenes)]
    default_scene = check.reference(document.root, "scene", "", scenes, "scene")
    return (
        roots_of_scenes[default_scene or 0]
        if roots_of_scenes
        else [row for row, parent_row in enumerate(parent) if parent_row < 0]
    )


def _scene_nodes(document: Document, row: int, scene: Json, parent: Sequence[int]) -> list[int]:
    """Returns the nodes of one scene, which must be roots and differ."""
    place = f"/scenes/{row}"
    scene_nodes: dict[int, None] = {}
    for k, value in enumerate(check.items(scene, "nodes", place)):
        node = check.index(value, f"{place}/nodes/{k}", document["nodes"], "node")
        if parent[node] >= 0 or node in scene_nodes:
            raise ModelError(f"node {node} must be a root, and be listed once", place=f"{place}/nodes/{k}")
        scene_nodes[node] = None
    return list(scene_nodes)


def rest_transforms(document: Document, order: NDArray[np.int32]) -> RestTransforms:
    """Returns the local transforms of the nodes in `order`; matrices are decomposed, rotations brought to
    unit length.
    """
    nodes = document["nodes"]
    fields = (
        [] if any("matrix" in node for node in nodes) else [vectors(nodes, *item) for item in REST.items()]
    )
    columns = [values for values in fields if values is not None]
    if len(columns) < len(REST):
        rows = [_node_transform(document, row, node) for row, node in enumerate(nodes)]
        columns = [np.array(values, np.float64) for values in zip(*rows, strict=True)]
    translation, rotation, scale = (values[order] for values in columns)
    if (np.abs(quat.dot(rotation, rotation) - 1) > 1e-3).any():
        document.note("node rotations were not of unit length and were normalised")
    return RestTransforms(
        translation.astype(np.float32), quat.normalize(rotation).astype(np.float32), scale.astype(np.float32)
    )


def _node_transform(
    document: Document, row: int, node: Json
) -> tuple[Sequence[float], Sequence[float], Sequence[float]]:
    place = f"/nodes/{row}"
    if "matrix" in node:
        return _decomposed(document, check.numbers(node, "matrix", place, 16))
    return (
        check.numbers(node, "translation", place, 3, REST["translation"]),
        check.numbers(node, "rotation", place, 4, REST["rotation"]),
        check.numbers(node, "scale", place, 3, REST["scale"]),
    )


def _decomposed(document: Document, matrix: list[float]) -> tuple[list[float], list[float], list[float]]:
    """Decomposes a matrix written column by column into translation, rotation and scale; a mirrored matrix
    gets a negative X scale.
    """
    affine = np.array(matrix, np.float64).reshape(4, 4).T[:3]
    if transform.is_skewed(affine):
        document.note(
            "a node's matrix is skewed and was replaced by the nearest translation, rotation and scale"
        )
    translation, rotation, scale = (part.tolist() for part in transform.to_trs(affine))
    return translation, rotation, scale

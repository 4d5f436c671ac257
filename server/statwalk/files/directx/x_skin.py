"""The SkinWeights of a .x mesh as a skin: for each bone the vertices that it moves, and the matrix from the
mesh's space at rest to the bone's.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import TextError
from statwalk.files.directx.left_handed import affine
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import DataObject
from statwalk.maths.arrays import Floats, Ints
from statwalk.skin.primitive import Skin
from statwalk.skin.weights import normalised

MOST_BONES, MOST_WEIGHTS = 65_535, 8_000_000


class BoundVertices(NamedTuple):
    """A skin, and for each vertex the joints of the skin (V, I) and their weights (V, I)."""

    skin: Skin
    joints: NDArray[np.uint16]
    weights: NDArray[np.float32]


class _Influences(NamedTuple):
    """One bone: its joint, its inverse bind matrix (3, 4), and its vertices (N,) with their weights (N,)."""

    joint: int
    inverse: Floats
    vertices: Ints
    weights: Floats


def read_skin(
    mesh: DataObject, vertices: int, row_of: Mapping[str, int], carrier: int | None, notes: list[str]
) -> BoundVertices | None:
    """Returns the skin of a mesh; None if no bone of the file moves it.

    Vertices that no bone moves follow the joint `carrier`, if there is one. Weights of bones that the file
    does not have are shared among the other bones of the vertex.

    :raises TextError: when a vertex does not exist, or numbers are missing.
    """
    parts = list(mesh.of_kind("skinweights"))
    if len(parts) > MOST_BONES:
        raise TextError(f"a mesh may have {MOST_BONES} bones at most", place=mesh.place)
    read = [_influences(part, vertices, row_of) for part in parts]
    missing = [part.strings[0][:60] for part, bone in zip(parts, read, strict=True) if bone is None]
    bones = [bone for bone in read if bone is not None]
    if missing:
        notes.append(
            f"the file has no frames {', '.join(missing[:8])}: their skin weights go to the other bones"
        )
    if not bones:
        return None
    weighted = np.zeros(vertices, bool)
    for bone in bones:
        weighted[bone.vertices[bone.weights > 0]] = True
    if carrier is not None and not weighted.all():
        free = np.flatnonzero(~weighted)
        notes.append(f"{len(free)} vertices of {mesh.title} have no bone and follow their frame")
        bones.append(_Influences(carrier, np.eye(4)[:3], free, np.ones(len(free))))
    return _bound(mesh, bones, vertices, notes)


def _influences(part: DataObject, vertices: int, row_of: Mapping[str, int]) -> _Influences | None:
    """Reads the influences of one bone; returns None if the file has no such bone."""
    if not part.strings:
        raise TextError('SkinWeights begin with the name of a frame in quotes, like "Arm"', place=part.place)
    numbers = NumberReader(part)
    count = numbers.count("skin weights", 2)
    rows = numbers.indices(count, vertices, "a vertex of a bone")
    weights = numbers.floats(count, "skin weights")
    inverse = affine(numbers.floats(16, "the offset matrix"))
    numbers.end()
    joint = row_of.get(part.strings[0])
    return None if joint is None else _Influences(joint, inverse, rows, weights)


def _bound(mesh: DataObject, bones: list[_Influences], vertices: int, notes: list[str]) -> BoundVertices:
    """Returns the influences by vertex, as many columns as the vertex with the most bones has."""
    vertex = np.concatenate([bone.vertices for bone in bones])
    weight = np.concatenate([bone.weights for bone in bones])
    number = np.repeat(np.arange(len(bones)), [len(bone.vertices) for bone in bones])
    used = weight > 0
    order = np.argsort(vertex[used], kind="stable")
    vertex, weight, number = vertex[used][order], weight[used][order], number[used][order]
    per_vertex = np.bincount(vertex, minlength=vertices)
    width = max(int(per_vertex.max(initial=0)), 1)
    if width * vertices > MOST_WEIGHTS:
        raise TextError(
            f"{mesh.title}: {vertices} vertices with up to {width} bones each need more than "
            f"{MOST_WEIGHTS} weights",
            place=mesh.place,
        )
    column = np.arange(len(vertex)) - (np.cumsum(per_vertex) - per_vertex)[vertex]
    joints, weights = np.zeros((vertices, width), np.int64), np.zeros((vertices, width), np.float32)
    joints[vertex, column], weights[vertex, column] = number, weight
    sorted_joints, sorted_weights, corrected = normalised(joints, weights)
    if corrected:
        notes.append(
            f"skin weights did not sum to 1 and were normalised: {corrected} vertices of {mesh.title}"
        )
    skin = Skin(
        mesh.name or "skin",
        np.array([bone.joint for bone in bones], np.int32),
        np.array([bone.inverse for bone in bones], np.float32),
    )
    return BoundVertices(skin, sorted_joints, sorted_weights)

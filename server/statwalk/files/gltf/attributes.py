"""Reads the attributes of a primitive as arrays: positions, normals, skin influences, morph targets, and
attributes that no pose changes.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import _kernels, check
from statwalk.files.gltf.accessors import Accessors, Array
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import COLORS, JOINTS, TEXCOORDS, VECTORS, WEIGHTS
from statwalk.skin.rows import unit
from statwalk.skin.shading import smooth_normals, triangles

Floats32 = NDArray[np.float32]


def vector(
    document: Document, accessors: Accessors, attributes: Json, name: str, place: str, count: int = 0
) -> Floats32 | None:
    """Returns an attribute (V,3); None if it is missing. `count` is the number of vertices, 0 if unknown.

    :raises ModelError: when the accessor has another type or another number of elements.
    """
    row = check.reference(attributes, name, place, document["accessors"], "accessor")
    if row is None:
        return None
    values = accessors.floats(row, VECTORS, f"{place}/{name}")
    _check_count(values, count or len(values), f"{place}/{name}")
    return np.ascontiguousarray(values)


def _check_count(values: Array, count: int, place: str) -> None:
    if len(values) != count:
        raise ModelError(f"the attribute has {len(values)} elements; POSITION has {count}", place=place)


def normals(
    document: Document,
    accessors: Accessors,
    attributes: Json,
    positions: Floats32,
    indices: Array | None,
    mode: int,
    place: str,
) -> Floats32 | None:
    """Returns unit normals (V,3): the file's, or smooth normals computed for triangles; None for points and
    lines without normals.
    """
    file_normals = vector(document, accessors, attributes, "NORMAL", place, len(positions))
    if file_normals is not None:
        return _unit_normals(file_normals)
    if mode < 4:
        return None
    document.note("a mesh without normals got smooth normals")
    vertex_order = np.arange(len(positions)) if indices is None else indices.astype(np.int64)
    return smooth_normals(positions, triangles(vertex_order, mode))


def _unit_normals(vectors: Floats32) -> Floats32:
    """Returns the normals (V,3) at unit length; the same array if they already are, to the precision of
    32-bit floats.
    """
    if are_unit(vectors):
        return vectors
    return np.ascontiguousarray(unit(vectors.T, np.zeros((3, 1), np.float32)).T, np.float32)


def are_unit(vectors: Floats32) -> bool:
    """Returns whether all vectors (V,3) are of unit length, to the precision of 32-bit floats."""
    return bool(_kernels.unit_length(np.require(vectors, requirements=["C", "A"]), np.float32(1e-6)))


def influences(
    document: Document, accessors: Accessors, attributes: Json, count: int, place: str
) -> tuple[Array, Floats32] | None:
    """Returns joints and weights (V,4·sets) of all sets JOINTS_n and WEIGHTS_n; None if there is no set."""
    joints: list[Array] = []
    weights: list[Floats32] = []
    while f"JOINTS_{len(joints)}" in attributes or f"WEIGHTS_{len(joints)}" in attributes:
        names = f"JOINTS_{len(joints)}", f"WEIGHTS_{len(joints)}"
        rows = [
            check.required_reference(attributes, name, place, document["accessors"], "accessor")
            for name in names
        ]
        joints.append(accessors.read(rows[0], JOINTS, f"{place}/{names[0]}"))
        weights.append(accessors.floats(rows[1], WEIGHTS, f"{place}/{names[1]}"))
        _check_count(joints[-1], count, f"{place}/{names[0]}")
        _check_count(weights[-1], count, f"{place}/{names[1]}")
    if not joints:
        return None
    all_weights = weights[0] if len(weights) == 1 else np.concatenate(weights, axis=1)
    return joints[0] if len(joints) == 1 else np.concatenate(joints, axis=1), all_weights


def targets(
    document: Document, accessors: Accessors, entry: Json, count: int, place: str
) -> tuple[Floats32, Floats32 | None] | tuple[None, None]:
    """Returns the displacements (M,V,3) of positions, and of normals (None if no target has normals)."""
    target_entries = check.objects(entry, "targets", place)
    if not target_entries:
        return None, None
    rows_of: dict[str, list[Floats32 | None]] = {"POSITION": [], "NORMAL": []}
    for k, target in enumerate(target_entries):
        for name, rows in rows_of.items():
            rows.append(vector(document, accessors, target, name, f"{place}/targets/{k}", count))
    zeros = np.zeros((count, 3), np.float32)
    position_offsets, normal_offsets = (
        np.array([zeros if row is None else row for row in rows]) for rows in rows_of.values()
    )
    return position_offsets, normal_offsets if any(row is not None for row in rows_of["NORMAL"]) else None


def constant_attributes(
    document: Document, accessors: Accessors, attributes: Json, count: int, place: str
) -> dict[str, Floats32]:
    """Returns texture coordinates (V,2) and colours (V,4), by name."""
    arrays: dict[str, Floats32] = {}
    for name in sorted(attributes):
        if name.startswith(("TEXCOORD_", "COLOR_")):
            row = check.required_reference(attributes, name, place, document["accessors"], "accessor")
            values = accessors.floats(
                row, COLORS if name.startswith("COLOR_") else TEXCOORDS, f"{place}/{name}"
            )
            _check_count(values, count, f"{place}/{name}")
            opaque = name.startswith("COLOR_") and values.shape[1] == 3
            arrays[name] = (
                np.pad(values, ((0, 0), (0, 1)), constant_values=1)
                if opaque
                else np.ascontiguousarray(values)
            )
    return arrays

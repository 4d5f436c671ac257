"""The attributes of a primitive as arrays: positions, normals, skin influences, morph targets, and what no pose changes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.glb import check
from statwalk.files.glb.accessors import Accessors, Array
from statwalk.files.glb.check import Json
from statwalk.files.glb.document import Document
from statwalk.files.glb.formats import COLORS, JOINTS, TEXCOORDS, VECTORS, WEIGHTS
from statwalk.maths.kernels.choose import loaded
from statwalk.skin.rows import unit
from statwalk.skin.shading import smooth_normals, triangles

Floats32 = NDArray[np.float32]


def vector(document: Document, accessors: Accessors, attributes: Json, name: str, place: str, count: int = 0) -> Floats32 | None:
    """(V,3) of an attribute, None where it is missing; `count` vertices where that is known."""
    row = check.reference(attributes, name, place, document["accessors"], "accessor")
    if row is None:
        return None
    values = accessors.floats(row, VECTORS, f"{place}/{name}")
    counted(values, count or len(values), f"{place}/{name}")
    return np.ascontiguousarray(values)


def counted(values: Array, count: int, place: str) -> None:
    """All attributes of a primitive must have the same number of elements."""
    if len(values) != count:
        raise ModelError(f"it has {len(values)} elements; POSITION has {count}", place=place)


def normals(
    document: Document, accessors: Accessors, attributes: Json, positions: Floats32, indices: Array | None, mode: int, place: str
) -> Floats32 | None:
    """(V,3) unit normals: the file's, or smooth ones computed for triangles; None for points and lines without any."""
    given = vector(document, accessors, attributes, "NORMAL", place, len(positions))
    if given is not None:
        return unit_normals(given)
    if mode < 4:
        return None
    document.note("a mesh without normals got smooth ones")
    order = np.arange(len(positions)) if indices is None else indices.astype(np.int64)
    return smooth_normals(positions, triangles(order, mode))


def unit_normals(given: Floats32) -> Floats32:
    """The normals (V,3) at unit length; the same array where they are, within what 32-bit floats can say."""
    if are_unit(given):
        return given
    return np.ascontiguousarray(unit(given.T, np.zeros((3, 1), np.float32)).T, np.float32)


def are_unit(vectors: Floats32) -> bool:
    """Whether all vectors (V,3) are of unit length, within what 32-bit floats can say."""
    compiled = loaded()
    if compiled is not None and vectors.flags.aligned and vectors.flags.c_contiguous:
        return compiled.unit_length(vectors, np.float32(1e-6))
    x, y, z = np.square(vectors.T, order="C")
    return bool(np.abs(x + y + z - 1).max() < 1e-6)


def influences(document: Document, accessors: Accessors, attributes: Json, count: int, place: str) -> tuple[Array, Floats32] | None:
    """Joints and weights (V,4·sets) of all sets JOINTS_n and WEIGHTS_n; None without any."""
    joints: list[Array] = []
    weights: list[Floats32] = []
    while f"JOINTS_{len(joints)}" in attributes or f"WEIGHTS_{len(joints)}" in attributes:
        names = f"JOINTS_{len(joints)}", f"WEIGHTS_{len(joints)}"
        rows = [check.required_reference(attributes, name, place, document["accessors"], "accessor") for name in names]
        joints.append(accessors.read(rows[0], JOINTS, f"{place}/{names[0]}"))
        weights.append(accessors.floats(rows[1], WEIGHTS, f"{place}/{names[1]}"))
        counted(joints[-1], count, f"{place}/{names[0]}")
        counted(weights[-1], count, f"{place}/{names[1]}")
    if not joints:
        return None
    together = weights[0] if len(weights) == 1 else np.concatenate(weights, axis=1)
    return joints[0] if len(joints) == 1 else np.concatenate(joints, axis=1), together


def targets(
    document: Document, accessors: Accessors, entry: Json, count: int, place: str
) -> tuple[Floats32, Floats32 | None] | tuple[None, None]:
    """Displacements (M,V,3) of positions and of normals (None where no target has any)."""
    listed = check.objects(entry, "targets", place)
    if not listed:
        return None, None
    found: dict[str, list[Floats32 | None]] = {"POSITION": [], "NORMAL": []}
    for k, target in enumerate(listed):
        for name, rows in found.items():
            rows.append(vector(document, accessors, target, name, f"{place}/targets/{k}", count))
    zeros = np.zeros((count, 3), np.float32)
    positions, turned = (np.array([zeros if row is None else row for row in rows]) for rows in found.values())
    return positions, turned if any(row is not None for row in found["NORMAL"]) else None


def constant_attributes(document: Document, accessors: Accessors, attributes: Json, count: int, place: str) -> dict[str, Floats32]:
    """Texture coordinates (V,2) and colours (V,4), by name."""
    found: dict[str, Floats32] = {}
    for name in sorted(attributes):
        if name.startswith(("TEXCOORD_", "COLOR_")):
            row = check.required_reference(attributes, name, place, document["accessors"], "accessor")
            values = accessors.floats(row, COLORS if name.startswith("COLOR_") else TEXCOORDS, f"{place}/{name}")
            counted(values, count, f"{place}/{name}")
            opaque = name.startswith("COLOR_") and values.shape[1] == 3
            found[name] = np.pad(values, ((0, 0), (0, 1)), constant_values=1) if opaque else np.ascontiguousarray(values)
    return found

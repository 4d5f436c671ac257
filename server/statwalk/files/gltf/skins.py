"""Reads skins: joints and inverse bind matrices (glTF 2.0, 3.7.3)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from statwalk.errors import ModelError
from statwalk.files.gltf import check
from statwalk.files.gltf.accessors import Accessors
from statwalk.files.gltf.check import Json
from statwalk.files.gltf.document import Document
from statwalk.files.gltf.formats import MATRICES
from statwalk.skin.primitive import Skin


def read_skins(document: Document, accessors: Accessors, joint_of: NDArray[np.int32]) -> tuple[Skin, ...]:
    """Returns all skins of the file. The field `skeleton` is a hint that may be wrong: it is checked and not
    used.
    """
    return tuple(
        _read_skin(document, accessors, joint_of, row, skin) for row, skin in enumerate(document["skins"])
    )


def _read_skin(
    document: Document, accessors: Accessors, joint_of: NDArray[np.int32], row: int, skin: Json
) -> Skin:
    """Returns a skin; without inverse bind matrices they are identities."""
    place = f"/skins/{row}"
    check.reference(skin, "skeleton", place, document["nodes"], "node")
    joint_nodes = check.items(skin, "joints", place, required=True)
    nodes = check.indices(joint_nodes, f"{place}/joints", document["nodes"], "node")
    matrices = _inverse_bind(document, accessors, skin, len(nodes), place)
    return Skin(check.label(skin, place) or f"skin {row}", joint_of[nodes], matrices)


def _inverse_bind(
    document: Document, accessors: Accessors, skin: Json, count: int, place: str
) -> NDArray[np.float32]:
    """Returns the inverse bind matrices (K,3,4)."""
    row = check.reference(skin, "inverseBindMatrices", place, document["accessors"], "accessor")
    if row is None:
        return np.broadcast_to(np.eye(4, dtype=np.float32)[:3], (count, 3, 4)).copy()
    matrices = accessors.floats(row, MATRICES, f"{place}/inverseBindMatrices")
    if len(matrices) < count:
        raise ModelError(
            f"the skin has {len(matrices)} matrices for {count} joints; it needs one for each joint",
            place=f"{place}/inverseBindMatrices",
        )
    return np.ascontiguousarray(matrices[:count, :3])

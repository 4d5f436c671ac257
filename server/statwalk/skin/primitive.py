"""Drawable primitives of meshes at rest, the skins that bend them, and primitives in a pose."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.columns import lock_fields
from statwalk.skin.collapses import Collapses

TRIANGLES = 4


@dataclass(frozen=True, eq=False)
class Skin:
    """The joints that bend a mesh: `joints` (K,) indices into the skeleton, `inverse_bind` (K,3,4) row-major
    (glTF 2.0, 3.7.3).
    """

    name: str
    joints: NDArray[np.int32]
    inverse_bind: NDArray[np.float32]

    def __post_init__(self) -> None:
        lock_fields(self)


@dataclass(frozen=True, eq=False)
class Primitive:
    """One drawable primitive at rest, in metres, in the space of its mesh.

    node, mesh, primitive    indices in the file; primitives that share a mesh share the arrays
    joint                    index in the skeleton of the node that carries the mesh
    positions, normals       (V,3); normals None for points and lines
    indices, mode            (N,) vertex numbers, None to draw all in order; mode 4 = triangles, as in glTF
    material                 index into the character's materials, or None
    skin, joints, weights    index into the character's skins; (V,I) indices into the skin's joints; (V,I)
                             weights that sum to 1
    target_positions         (M,V,3) displacements of morph targets; target_normals the same for normals, or
                             None
    weight_first             the first of this mesh's M columns in a pose's weights
    attributes               independent of the pose, by glTF's names: TEXCOORD_n (V,2), COLOR_n (V,4)
    collapses                the order in which vertices collapse (DS10), or None
    """

    joint: int
    node: int
    mesh: int
    primitive: int
    positions: NDArray[np.float32]
    normals: NDArray[np.float32] | None = None
    indices: NDArray[np.uint32] | None = None
    mode: int = TRIANGLES
    material: int | None = None
    skin: int | None = None
    joints: NDArray[np.uint16] | None = None
    weights: NDArray[np.float32] | None = None
    target_positions: NDArray[np.float32] | None = None
    target_normals: NDArray[np.float32] | None = None
    weight_first: int = 0
    attributes: Mapping[str, NDArray[np.float32]] = field(default_factory=dict)
    collapses: Collapses | None = None


class Part(NamedTuple):
    """A primitive in a pose: `positions` and unit `normals` (V,3) in the character's space (None for points
    and lines).
    """

    node: int
    mesh: int
    primitive: int
    positions: NDArray[np.float32]
    normals: NDArray[np.float32] | None

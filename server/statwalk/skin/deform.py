"""All primitives of a character as one surface: one list of vertices, one palette of bones, posed by compiled
kernels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.skin.blocks import Blocks, MorphedBlocks
from statwalk.skin.morph import Morph
from statwalk.skin.primitive import Part, Primitive, Skin
from statwalk.skin.soft import Palette

IDENTITY = np.eye(4, dtype=np.float32)[:3]


@dataclass(frozen=True, eq=False)
class Surface:
    """V vertices of all parts, one part after the other; `spans` are the vertices of each part.

    positions and normals (3,V) at rest; morphs of both; the palette; bones of the palette and weights (V,I)
    of all vertices.
    """

    parts: tuple[Primitive, ...]
    spans: tuple[slice, ...]
    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    position_morphs: tuple[Morph, ...]
    normal_morphs: tuple[Morph, ...]
    palette: Palette
    bones: NDArray[np.intp]
    weights: NDArray[np.float32]
    is_dual: bool = False
    """whether bones are blended as dual quaternions, not as matrices"""

    def pose_into(
        self,
        world: Floats,
        weights: Floats,
        positions: NDArray[np.float32],
        normals: NDArray[np.float32],
        bounds: NDArray[np.float32],
    ) -> None:
        """Writes positions and unit normals (V,3), flat, for world matrices (J,3,4) and morph weights (W,),
        and the bounds (P,6) of each part.

        A skinned mesh is placed by its joints alone, not by the node that carries it (glTF 2.0, 3.7.3.1). The
        result is finite for all matrices. The three arrays must be contiguous.

        :raises ValueError: when an array is too small.
        """
        if self.parts:
            self.blocks.pose(world, weights, positions, normals, bounds)

    def posed_parts(self, world: Floats, weights: Floats) -> list[Part]:
        """Returns the parts in one pose, named by their indices in the file."""
        flat = np.empty((2, self.positions.size), np.float32)
        self.pose_into(world, weights, flat[0], flat[1], np.empty((len(self.parts), 6), np.float32))
        return self.parts_of(*flat.reshape(2, -1, 3))

    def parts_of(self, positions: NDArray[np.float32], normals: NDArray[np.float32]) -> list[Part]:
        """Returns the parts of posed vertices (V,3), named by their indices in the file."""
        return [
            Part(
                part.node,
                part.mesh,
                part.primitive,
                positions[span],
                None if part.normals is None else normals[span],
            )
            for part, span in zip(self.parts, self.spans, strict=True)
        ]

    @cached_property
    def blocks(self) -> Blocks:
        """Returns the vertices in blocks for the kernels, made on first use."""
        shown = [(self.positions, self.position_morphs), (self.normals, self.normal_morphs)]
        points, normals = (MorphedBlocks(self.spans, rest, morphs) for rest, morphs in shown)
        influences = self.bones, self.weights
        return Blocks(self.spans, (points, normals), self.palette, influences, is_dual=self.is_dual)


def surface(parts: Sequence[Primitive], skins: Sequence[Skin], *, is_dual: bool = False) -> Surface:
    """Returns the surface of a character's primitives; `is_dual`: bones are blended as dual quaternions."""
    ends = np.cumsum([len(part.positions) for part in parts]).tolist()
    spans = tuple(slice(end - len(part.positions), end) for part, end in zip(parts, ends, strict=True))
    first_bone = np.cumsum([0, *(len(skin.joints) for skin in skins)]).tolist()
    bones, weights = _influence_table(parts, spans, first_bone)
    rigid = np.array([part.joint for part in parts], np.int32)
    return Surface(
        parts=tuple(parts),
        spans=spans,
        positions=_joined([part.positions for part in parts]),
        normals=_joined([_upright(part) if part.normals is None else part.normals for part in parts]),
        position_morphs=tuple(morphs(parts, spans, "target_positions")),
        normal_morphs=tuple(morphs(parts, spans, "target_normals")),
        palette=Palette(
            np.concatenate([*(skin.joints for skin in skins), rigid]).astype(np.int32),
            np.concatenate(
                [*(skin.inverse_bind for skin in skins), np.broadcast_to(IDENTITY, (len(parts), 3, 4))]
            ).astype(np.float32),
        ),
        bones=bones,
        weights=weights,
        is_dual=is_dual,
    )


def _influence_table(
    parts: Sequence[Primitive], spans: Sequence[slice], first_bone: Sequence[int]
) -> tuple[NDArray[np.intp], NDArray[np.float32]]:
    """Bones of the palette and weights (V,I) of all vertices; a rigid part follows its own bone, after the
    bones of the skins.
    """
    count = spans[-1].stop if spans else 0
    width = max([1, *(part.joints.shape[1] for part in parts if part.joints is not None)])
    bones, weights = np.zeros((count, width), np.intp), np.zeros((count, width), np.float32)
    for row, (part, span) in enumerate(zip(parts, spans, strict=True)):
        if part.skin is None or part.joints is None or part.weights is None:
            bones[span, 0], weights[span, 0] = first_bone[-1] + row, 1
        else:
            bones[span, : part.joints.shape[1]] = part.joints.astype(np.intp) + first_bone[part.skin]
            weights[span, : part.weights.shape[1]] = part.weights
    return bones, weights


def morphs(parts: Sequence[Primitive], spans: Sequence[slice], name: str) -> list[Morph]:
    """Returns the morph targets, of positions or of normals, of the parts that have any."""
    targets = [
        (part.weight_first, span, getattr(part, name)) for part, span in zip(parts, spans, strict=True)
    ]
    return [
        Morph(span, first, np.ascontiguousarray(rows.swapaxes(1, 2)))
        for first, span, rows in targets
        if rows is not None
    ]


def _joined(arrays: Sequence[NDArray[np.float32]]) -> NDArray[np.float32]:
    """Arrays (V,3) one after the other, as (3,V)."""
    whole = np.concatenate([np.zeros((0, 3), np.float32), *arrays])
    return np.ascontiguousarray(whole.T)


def _upright(part: Primitive) -> NDArray[np.float32]:
    """(V,3) of +Z, for a primitive without normals."""
    return np.broadcast_to(np.array([0, 0, 1], np.float32), part.positions.shape)

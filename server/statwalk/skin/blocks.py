"""Vertices in blocks of sixteen for the kernels, each block with as many influences as its vertex with the
most.

Neighbours in a file are mostly neighbours on the body, so a block wastes little, and vertices keep their
order. Every part starts a new block; a part's last block is filled up with its last vertex.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.maths.simd import aligned
from statwalk.maths.simd.lanes import LANES
from statwalk.skin import _kernels
from statwalk.skin.dual_bones import DualBones
from statwalk.skin.dual_palette import LINEAR
from statwalk.skin.morph import Morph
from statwalk.skin.repair import MATRIX, SCRATCH, XYZ
from statwalk.skin.soft import Palette


class Blocks:
    """A surface prepared for the kernels, and the memory that they work in.

    Safe to use from several threads.
    """

    def __init__(
        self,
        spans: Sequence[slice],
        vertices: tuple[MorphedBlocks, MorphedBlocks],
        palette: Palette,
        influences: tuple[NDArray[np.intp], NDArray[np.float32]],
        *,
        is_dual: bool = False,
    ) -> None:
        """Prepares parts at `spans`: positions and normals, the palette, bones and weights (V,I) of all
        vertices; `is_dual`: blended as dual quaternions.

        :raises IndexError: when a vertex follows a bone that is not in the palette; kernels do not check.
        """
        bones, weights = influences
        if bones.max(initial=0) >= max(1, len(palette.joints)):
            raise IndexError(f"a vertex follows bone {bones.max()} of {len(palette.joints)}")
        self.dual = DualBones(bones, weights, len(palette.joints)) if is_dual else None
        bones = self.dual.numbers if self.dual else bones
        counts = _influence_counts(spans, weights)
        mask = np.arange(weights.shape[1]) < np.repeat(counts, LANES)[:, None]
        source = sources(spans)
        self.spans = np.array([(span.start, span.stop - span.start) for span in spans], np.int64).reshape(
            -1, 2
        )
        self.table = np.ascontiguousarray(
            np.stack([np.cumsum(LANES * counts) - LANES * counts, counts], axis=1)
        )
        self.bones = (bones[source][mask] * MATRIX).astype(np.int32)
        self.weights = aligned.copy(weights[source][mask])
        self.vertices = vertices
        self.joints = np.array(palette.joints, np.int32)
        self.inverse_bind = np.array(palette.inverse_bind, np.float32, order="C")
        self.palette = aligned.zeros(MATRIX * len(palette.joints))
        self.scratch = aligned.zeros(SCRATCH)
        self.needs = int(self.joints.max(initial=-1)) + 1, 3 * len(bones), 6 * len(spans)
        self.lock = threading.Lock()

    def pose(
        self,
        world: Floats,
        weights: Floats,
        positions: NDArray[np.float32],
        normals: NDArray[np.float32],
        bounds: Floats,
    ) -> None:
        """Writes positions, normals and bounds; see `Surface.pose_into`.

        :raises ValueError: when an array is too small; kernels do not check.
        """
        joints, floats, limits = self.needs
        if (
            world.shape[1:] != (3, 4)
            or len(world) < joints
            or positions.size != floats
            or normals.size != floats
            or bounds.size != limits
        ):
            raise ValueError(
                f"{world.shape}, {positions.shape}, {normals.shape}, {bounds.shape} do not fit this surface"
            )
        with self.lock:
            _kernels.palette(
                np.ascontiguousarray(world, np.float32), self.joints, self.inverse_bind, self.palette
            )
            way, palette, stretches = LINEAR, self.palette, self.palette
            if self.dual:
                way, palette, stretches = self.dual.pose(self.palette), self.dual.turns, self.dual.stretches
            rest, rest_normals = self.vertices[0].posed(weights), self.vertices[1].posed(weights)
            _kernels.skinned(
                way,
                palette,
                stretches,
                self.spans,
                self.table,
                self.bones,
                self.weights,
                rest,
                rest_normals,
                positions,
                normals,
                bounds,
                self.scratch,
            )


class MorphedBlocks:
    """Positions or normals in blocks, and their morph targets: (first float, column of the weights,
    displacements (M,n) flat).
    """

    def __init__(self, spans: Sequence[slice], rest: NDArray[np.float32], morphs: Sequence[Morph]) -> None:
        """Prepares parts at `spans`: points at rest (3,V), and the targets of some of the parts."""
        self.rest = aligned.copy(_by_blocks(rest[:, sources(spans)]))
        self.morphed = aligned.copy(self.rest) if morphs else self.rest
        first_block = dict(
            zip((span.start for span in spans), np.cumsum([0, *_block_counts(spans)]).tolist(), strict=False)
        )
        self.targets = [_target_blocks(morph, XYZ * first_block[morph.span.start]) for morph in morphs]

    def posed(self, weights: Floats) -> NDArray[np.float32]:
        """Returns the blocks under morph weights (W,), valid until the next call.

        Targets of weight 0 cost nothing.
        """
        for span, first, targets, displacements in self.targets:
            own = weights[first : first + targets]
            used = np.flatnonzero(own)
            floats = span.stop - span.start
            _kernels.morphed(
                self.rest[span],
                displacements,
                own[used].astype(np.float32),
                used * floats,
                self.morphed[span],
            )
        return self.morphed


def _target_blocks(morph: Morph, start: int) -> tuple[slice, int, int, NDArray[np.float32]]:
    """The targets of one part in blocks: the floats that they move, their first weight, their number, and the
    displacements.
    """
    own = slice(0, morph.span.stop - morph.span.start)
    listed = np.stack([_by_blocks(row[:, sources([own])]) for row in morph.displacements])
    return slice(start, start + listed.shape[1]), morph.first, len(listed), aligned.copy(listed)


def _block_counts(spans: Sequence[slice]) -> list[int]:
    """The number of blocks of each part."""
    return [-((span.start - span.stop) // LANES) for span in spans]


def sources(spans: Sequence[slice]) -> NDArray[np.intp]:
    """Returns (16·B,) the vertex in each lane of all blocks."""
    counts = _block_counts(spans)
    listed = [
        np.minimum(span.start + np.arange(LANES * count), span.stop - 1)
        for span, count in zip(spans, counts, strict=True)
    ]
    return np.concatenate([np.zeros(0, np.intp), *listed])


def _by_blocks(xyz: NDArray[np.float32]) -> NDArray[np.float32]:
    """Points (3,16·B) flat as 16 x, 16 y, 16 z for each block."""
    return xyz.reshape(3, -1, LANES).transpose(1, 0, 2).reshape(-1)


def _influence_counts(spans: Sequence[slice], weights: NDArray[np.float32]) -> NDArray[np.int64]:
    """(B,) the number of columns of weights (V,I) that the vertices of each block need, at least 1."""
    numbers = np.where(weights != 0, np.arange(1, weights.shape[1] + 1), 1).max(axis=1, initial=1)
    return np.asarray(numbers[sources(spans)].reshape(-1, LANES).max(axis=1, initial=1), np.int64)

"""One mesh in the poses of many actors: sixteen actors side by side, vertex by vertex.

A bone's matrices of sixteen actors lie together, so that a vertex needs no shuffles; one mesh alone is posed
sixteen vertices at a time instead (`blocks`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats
from statwalk.maths.simd import aligned
from statwalk.maths.simd.lanes import LANES
from statwalk.maths.simd.pose_layout import blocks, zero_blocks
from statwalk.skin import _kernels
from statwalk.skin.deform import Surface
from statwalk.skin.primitive import Part
from statwalk.skin.repair import NUMBERS


class CrowdVertices(NamedTuple):
    """The vertices of a surface in the poses of N actors."""

    surface: Surface
    actors: int
    values: NDArray[np.float32]
    """(B,V,6,16) positions xyz and unit normals xyz of blocks of sixteen actors"""

    def parts(self, actor: int) -> list[Part]:
        """Returns the parts of an actor, 0…N-1: positions and normals (V,3), as `Surface.posed_parts`.

        :raises IndexError: when there is no such actor.
        """
        if not 0 <= actor < self.actors:
            raise IndexError(f"actor {actor} of {self.actors}")
        block, lane = divmod(actor, LANES)
        flat = self.values[block, :, :, lane]
        return self.surface.parts_of(np.ascontiguousarray(flat[:, :3]), np.ascontiguousarray(flat[:, 3:]))


class CrowdSkin:
    """A surface prepared for crowds; `pose` writes all vertices of all actors."""

    def __init__(self, surface: Surface) -> None:
        """Sorts the influences by vertex; leaves out influences of weight 0 at the end of a row."""
        counts = np.where(surface.weights != 0, np.arange(1, surface.weights.shape[1] + 1), 1).max(
            1, initial=1
        )
        mask = np.arange(surface.weights.shape[1]) < counts[:, None]
        self.surface = surface
        self.starts = np.concatenate([[0], np.cumsum(counts)]).astype(np.int64)
        self.bones = (surface.bones[mask] * (NUMBERS * LANES)).astype(np.int32)
        self.weights = np.ascontiguousarray(surface.weights[mask])
        self.at_rest = np.ascontiguousarray(np.concatenate([surface.positions, surface.normals]).T).reshape(
            -1
        )
        self.joints = np.array(surface.palette.joints, np.int32)
        self.inverse_bind = np.array(surface.palette.inverse_bind, np.float32, order="C")
        self.palette = aligned.zeros(NUMBERS * LANES * len(self.joints))

    def room(self, actors: int) -> NDArray[np.float32]:
        """Returns memory (B,V,6,16) for the vertices of so many actors."""
        vertices = len(self.starts) - 1
        return zero_blocks(blocks(actors), 6 * vertices).reshape(blocks(actors), vertices, 6, LANES)

    def posed(self, world: Floats, weights: Floats) -> CrowdVertices:
        """Returns the vertices for world matrices (N,J,3,4) and morph weights (N,W)."""
        values = self.room(len(world))
        self.pose(world, weights, values)
        return CrowdVertices(self.surface, len(world), values)

    def pose(self, world: Floats, weights: Floats, out: NDArray[np.float32]) -> None:
        """Writes the vertices for world matrices (N,J,3,4) and morph weights (N,W) into `room(N)`.

        Dual quaternions, morph targets, and matrices of extreme size are posed actor by actor.
        """
        for block, first in enumerate(range(0, len(world), LANES)):
            own = slice(first, first + LANES)
            is_plain = self.surface.is_dual or weights[own].any()
            if is_plain or not self._pose_block(world[own], out[block].reshape(-1)):
                for lane, (matrices, morphs) in enumerate(zip(world[own], weights[own], strict=True)):
                    self._pose_one(matrices, morphs, out[block, :, :, lane])

    def _pose_block(self, world: Floats, out: NDArray[np.float32]) -> bool:
        matrices = np.ascontiguousarray(world, np.float32)
        _kernels.palette_lanes(matrices, self.joints, self.inverse_bind, self.palette)
        return bool(
            _kernels.skinned_crowd(self.starts, self.bones, self.weights, self.at_rest, self.palette, out)
        )

    def _pose_one(self, world: Floats, weights: Floats, out: NDArray[np.float32]) -> None:
        flat = np.empty((2, self.surface.positions.size), np.float32)
        bounds = np.empty((len(self.surface.parts), 6), np.float32)
        self.surface.pose_into(world, weights, flat[0], flat[1], bounds)
        out[:, :3], out[:, 3:] = flat.reshape(2, -1, 3)

"""The inside of a mesh as voxels: what tells which bones lie in the body, and which a vertex sees.

Voxels know no topology: holes, several shells and edges of three triangles are no obstacle. SciPy is imported
on first use.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.skin.binding.shell import Shell

CELLS = 96
"""voxels along the longest side"""
MARGIN = 4
"""empty voxels around the body"""
MOST_SAMPLES = 1 << 24
AT_ONCE = 1 << 20
WIDEST_GAP = 3
"""voxels: holes that are closed before the outside is flooded"""
ENCLOSED = 0.5
"""share of the voxels with surface in all six directions that a closed body fills at least"""


class Volume(NamedTuple):
    """A body in voxels of side `size`; voxel (0,0,0) has its centre at `origin` (3,)."""

    solid: Bools
    """(X,Y,Z) whether a voxel is on the surface or inside it"""
    depth: Floats
    """(X,Y,Z) the distance to the outside, 0 outside"""
    origin: Floats
    size: float

    def cells(self, points: Floats) -> Ints:
        """Returns the voxels (…,3) of points (…,3); points far outside are in a voxel of the margin."""
        cells = np.rint((points - self.origin) / self.size)
        return np.clip(cells, 0, np.array(self.solid.shape) - 1).astype(np.int64)

    def points(self, cells: Ints) -> Floats:
        """Returns the centres (…,3) of voxels (…,3)."""
        centres: Floats = self.origin + cells * self.size
        return centres

    def holds(self, points: Floats) -> Bools:
        """Returns (…) whether points (…,3) are in the body."""
        x, y, z = np.moveaxis(self.cells(points), -1, 0)
        inside: Bools = self.solid[x, y, z]
        return inside

    def depth_at(self, points: Floats) -> Floats:
        """Returns (…) the distance of points (…,3) to the outside."""
        x, y, z = np.moveaxis(self.cells(points), -1, 0)
        depth: Floats = self.depth[x, y, z]
        return depth


def volume_of(shell: Shell, cells: int = CELLS) -> Volume:
    """Returns the body that a shell with triangles encloses, at `cells` voxels along its longest side."""
    from scipy import ndimage

    low, high = shell.points.min(0), shell.points.max(0)
    size = max(float((high - low).max()), 1e-12) / cells
    shape = np.ceil((high - low) / size).astype(int) + 1 + 2 * MARGIN
    volume = Volume(np.zeros(shape, bool), np.zeros(0), low - MARGIN * size, size)
    _mark(volume, shell)
    solid = _filled(volume.solid)
    return volume._replace(solid=solid, depth=ndimage.distance_transform_edt(solid) * size)


def _mark(volume: Volume, shell: Shell) -> None:
    """Marks the voxels of the surface: samples every triangle along its longest edge, and across."""
    corners = shell.points[shell.triangles]
    edges = np.linalg.norm(corners - np.roll(corners, -1, 1), axis=2)
    order = (edges.argmax(1)[:, None] + np.arange(3)) % 3
    corners = np.take_along_axis(corners, order[:, :, None], 1)
    longest = edges.max(1)
    across = 2 * shell.areas() / np.maximum(longest, 1e-300)
    step, along, up = volume.size / 2, np.zeros(0, int), np.zeros(0, int)
    while True:
        along, up = ((np.ceil(lengths / step) + 1).astype(np.int64) for lengths in (longest, across))
        if (along * up).sum() <= MOST_SAMPLES + 4 * len(along):
            break
        step *= 1.5
    ends = np.cumsum(along * up)
    blocks = np.searchsorted(ends, np.arange(0, ends[-1] if len(ends) else 0, AT_ONCE), side="left")
    for first, last in zip(blocks, [*blocks[1:], len(ends)], strict=True):
        _mark_block(volume, corners[first:last], along[first:last], up[first:last])


def _mark_block(volume: Volume, corners: Floats, along: Ints, up: Ints) -> None:
    """Marks the voxels of some triangles (T,3,3): `along` · `up` samples of each."""
    counts = along * up
    row = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(row)) - np.repeat(np.cumsum(counts) - counts, counts)
    s = (number % along[row]) / (along[row] - 1).clip(1)
    t = (number // along[row]) / (up[row] - 1).clip(1)
    base = corners[row, 0] + (corners[row, 1] - corners[row, 0]) * s[:, None]
    x, y, z = volume.cells(base + (corners[row, 2] - base) * t[:, None]).T
    volume.solid[x, y, z] = True


def _filled(surface: Bools) -> Bools:
    """The surface with all that it encloses; small holes are closed first. A surface that encloses nothing
    keeps what lies between surfaces in all six directions.
    """
    from scipy import ndimage

    between = _between(surface)
    wanted = ENCLOSED * np.count_nonzero(between & ~surface)
    for gap in range(WIDEST_GAP + 1):
        grown = ndimage.binary_dilation(surface, iterations=gap) if gap else surface
        regions, _ = ndimage.label(~grown)
        body: Bools = regions != regions[0, 0, 0]
        body = (ndimage.binary_erosion(body, iterations=gap) if gap else body) | surface
        if np.count_nonzero(body & ~surface) >= wanted:
            return body
    return between | surface


def _between(surface: Bools) -> Bools:
    """Whether a voxel has surface in all six directions."""
    between = np.ones_like(surface)
    for axis in range(3):
        between &= np.logical_or.accumulate(surface, axis)
        between &= np.flip(np.logical_or.accumulate(np.flip(surface, axis), axis), axis)
    return between

"""Posed frames as complete GLB files, written into a prepared one.

The JSON keeps its length and layout from frame to frame: only numbers of fixed width change in it (tick, hash, bounds of positions).
Of the binary chunk, positions and normals change; indices, texture coordinates and colours do not.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character import Character
from statwalk.files.glb import container
from statwalk.files.glb.layout import ActorBlock, laid_out
from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import sincos
from statwalk.maths.kernels.choose import kernels
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local


class PosedCast(NamedTuple):
    """The actors of one entry: local poses (n,J,…), places (n,3) in metres, headings (n,) in radians about +Y."""

    pose: Pose
    root_position: Floats
    heading: Floats


class Vertices(NamedTuple):
    """Where one actor's vertices are written: positions and normals (V,3), flat, in the file, the bounds (P,6) of its parts beside it."""

    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    bounds: NDArray[np.float32]


class FrameTemplate:
    """A GLB prepared for `entries`: characters, and how many actors of each.

    template = FrameTemplate([(fox, 1)]); template.frame(12, "00ff", [PosedCast(poses, places, headings)])

    Every actor is a node with a mesh node for each node of its file that carries a mesh, vertices in stage space, materials in the
    order of the files. With `images` the textures come along; without them a frame is as small as can be.
    """

    def __init__(self, entries: Sequence[tuple[Character, int]], *, images: bool = False) -> None:
        self.characters = [character for character, _ in entries]
        layout = laid_out(entries, images=images)
        self.layout_text, self.bounds = layout.text, np.zeros((layout.parts, 6), np.float32)
        text = self.text(0, "")
        self.data = bytearray(container.join(text, bytes(layout.binary)))
        self.text_start = container.HEADER.size + container.CHUNK_HEADER.size
        self.vertices = self.views(layout.blocks, self.text_start + len(text) + (-len(text) % 4) + container.CHUNK_HEADER.size)
        self.lock = threading.Lock()

    def views(self, blocks: Sequence[Sequence[ActorBlock]], start: int) -> list[list[Vertices]]:
        """Where the actors of each entry are written: into the binary chunk, which starts at `start`, and the table of bounds."""
        out: list[list[Vertices]] = []
        row = 0
        for character, actors in zip(self.characters, blocks, strict=True):
            floats, parts = character.surface.positions.size, len(character.parts)
            out.append([])
            for block in actors:
                positions, normals = (self.view(floats, start + first) for first in block)
                out[-1].append(Vertices(positions, normals, self.bounds[row : row + parts]))
                row += parts
        return out

    def view(self, floats: int, start: int) -> NDArray[np.float32]:
        """So many floats of the file; none need no place in it."""
        return np.ndarray(floats, "<f4", self.data, start) if floats else np.zeros(0, np.float32)

    def frame(self, tick: int, state_hash: str, casts: Sequence[PosedCast]) -> bytes:
        """One frame: a complete GLB with every actor of `casts` (in the order of the entries) in its pose, at its place."""
        with np.errstate(over="ignore", invalid="ignore"):
            worlds = [stage_worlds(character, cast) for character, cast in zip(self.characters, casts, strict=True)]
        return self.filled(tick, state_hash, worlds, [cast.pose.weights for cast in casts])

    def filled(self, tick: int, state_hash: str, worlds: Sequence[Floats], weights: Sequence[Floats]) -> bytes:
        """The frame for joint matrices (n,J,3,4) in stage space and morph weights (n,W) of each entry. Safe in several threads."""
        with self.lock:
            for character, actors, matrices, shares in zip(self.characters, self.vertices, worlds, weights, strict=True):
                for vertices, matrix, share in zip(actors, matrices, shares, strict=True):
                    character.surface.pose_into(matrix, share, *vertices)
            text = self.text(tick, state_hash)
            self.data[self.text_start : self.text_start + len(text)] = text
            return bytes(self.data)

    def text(self, tick: int, state_hash: str) -> bytes:
        """The JSON chunk: hash, tick and bounds printed into its slots, in their order."""
        return self.layout_text % (state_hash.zfill(16).encode(), tick, *self.bounds.reshape(-1).tolist())


def stage_worlds(character: Character, cast: PosedCast) -> Floats:
    """World matrices (n,J,3,4) in stage space: the actor's root, then its joints.

    :raises ValueError: if the pose is not one of so many actors of this character.
    """
    roots = root_matrices(cast)
    if any(array.shape[:2] != (len(roots), len(character.skeleton)) for array in cast.pose[:3]):
        raise ValueError(f"a pose of {cast.pose.translation.shape} for {len(roots)} actors of {len(character.skeleton)} joints")
    compiled = kernels()
    if compiled is None:
        return transform.mul(roots, world_from_local(character.skeleton, cast.pose))
    parents, local = character.skeleton.parent, [np.ascontiguousarray(array, np.float32) for array in cast.pose[:3]]
    out = np.empty((len(roots), len(parents), 3, 4), np.float32)
    compiled.placed(parents, *local, roots, out)
    return out


def root_matrices(cast: PosedCast) -> NDArray[np.float32]:
    """(n,1,3,4): each actor turned by its heading about +Y, then put in its place."""
    sine, cosine = sincos(np.asarray(cast.heading, np.float64))
    roots = np.zeros((len(sine), 1, 3, 4), np.float32)
    roots[:, 0, 0, 0] = roots[:, 0, 2, 2] = cosine
    roots[:, 0, 0, 2], roots[:, 0, 2, 0], roots[:, 0, 1, 1] = sine, -sine, 1
    roots[:, 0, :, 3] = cast.root_position
    return roots

"""Posed frames as complete GLB files, written into a prepared one.

The JSON keeps its length and layout from frame to frame: only numbers of fixed width change in it (tick, hash, bounds of positions).
Of the binary chunk, positions and normals change; indices, texture coordinates and colours do not.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character import Character
from statwalk.files.glb import container
from statwalk.files.glb.layout import ActorBlock, laid_out
from statwalk.maths import quat, transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.rows import finite

UP = np.array([0, 1, 0], np.float64)


class PosedCast(NamedTuple):
    """The actors of one entry: local poses (n,J,…), places (n,3) in metres, headings (n,) in radians about +Y."""

    pose: Pose
    root_position: Floats
    heading: Floats


class FrameTemplate:
    """A GLB prepared for `entries`: characters, and how many actors of each.

    template = FrameTemplate([(fox, 1)]); template.frame(12, "00ff", [PosedCast(poses, places, headings)])

    Every actor is a node with a mesh node for each node of its file that carries a mesh, vertices in stage space, materials in the
    order of the files. With `images` the textures come along; without them a frame is as small as can be.
    """

    def __init__(self, entries: Sequence[tuple[Character, int]], *, images: bool = False) -> None:
        self.characters = [character for character, _ in entries]
        self.layout = laid_out(entries, images=images)
        text = self.text(0, "", [np.zeros(6)] * self.layout.parts)
        self.template = container.join(text, bytes(self.layout.binary))
        self.text_start = container.HEADER.size + container.CHUNK_HEADER.size
        self.binary_start = self.text_start + len(text) + (-len(text) % 4) + container.CHUNK_HEADER.size

    def frame(self, tick: int, state_hash: str, casts: Sequence[PosedCast]) -> bytes:
        """One frame: a complete GLB with every actor of `casts` (in the order of the entries) in its pose, at its place."""
        data = bytearray(self.template)
        bounds: list[Floats] = []
        with np.errstate(over="ignore", invalid="ignore"):
            for character, blocks, cast in zip(self.characters, self.layout.blocks, casts, strict=True):
                worlds = stage_worlds(character, cast)
                for row, block in enumerate(blocks):
                    bounds += self.write(data, character, block, worlds[row], cast.pose.weights[row])
        text = self.text(tick, state_hash, bounds)
        data[self.text_start : self.text_start + len(text)] = text
        return bytes(data)

    def write(self, data: bytearray, character: Character, block: ActorBlock, world: Floats, weights: Floats) -> list[Floats]:
        """One actor's positions and normals into the binary chunk; the bounds (6,) of each of its parts."""
        surface = character.surface
        count = surface.positions.shape[1]
        if not count:
            return []
        positions, normals = (finite(values) for values in surface.pose(world, weights))
        bounds = [np.concatenate([positions[:, span].min(axis=1), positions[:, span].max(axis=1)]) for span in surface.spans]
        for values, start in ((positions, block.positions), (normals, block.normals)):
            np.ndarray((count, 3), "<f4", data, self.binary_start + start)[:] = values.T
        return bounds

    def text(self, tick: int, state_hash: str, bounds: Sequence[Floats]) -> bytes:
        """The JSON chunk: hash, tick and bounds printed into its slots, in their order."""
        numbers = (number for row in bounds for number in row.tolist())
        return self.layout.text % (state_hash.zfill(16).encode(), tick, *numbers)


def stage_worlds(character: Character, cast: PosedCast) -> Floats:
    """World matrices (n,J,3,4) in stage space: the actor's root, then its joints."""
    local = world_from_local(character.skeleton, cast.pose)
    turn = quat.from_axis_angle(UP, np.asarray(cast.heading, np.float64))
    place = np.asarray(cast.root_position, np.float64)
    root = transform.from_trs(place, turn, np.ones_like(place)).astype(local.dtype)
    return transform.mul(root[:, None], local)

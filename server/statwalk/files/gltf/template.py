"""Writes posed frames into a prepared GLB; each frame is a complete file.

The JSON keeps its length and layout from frame to frame: only numbers of fixed width change (tick, hash,
bounds of positions). In the binary chunk matrices, positions and normals change; indices, texture
coordinates and colours do not.
"""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.gltf import container
from statwalk.files.gltf.layout import ActorBlock, laid_out
from statwalk.maths.arrays import Floats
from statwalk.maths.elementary import sincos
from statwalk.maths.pose import Pose
from statwalk.rig.evaluate import stage_from_local


class PosedCast(NamedTuple):
    """The actors of one entry: local poses (n,J,…), positions (n,3) in metres, headings (n,) in radians about
    +Y.
    """

    pose: Pose
    root_position: Floats
    heading: Floats


class ActorArrays(NamedTuple):
    """The arrays that one actor is written to: in the file matrices (1+J,4,4) in column-major order, the
    root's first, and positions and normals (V,3), flat; and the bounds (P,6) of its parts.
    """

    matrices: NDArray[np.float32]
    positions: NDArray[np.float32]
    normals: NDArray[np.float32]
    bounds: NDArray[np.float32]


class FrameTemplate:
    """A GLB prepared for `entries`: characters, and the number of actors of each.

    template = FrameTemplate([(fox, 1)]); template.frame(12, "00ff", [PosedCast(poses, positions, headings)])

    Every actor is a node, with a mesh node below for each node of its file that carries a mesh; vertices are
    in stage space, materials in the order of the files. `extras.joints` of an actor's node is the accessor of
    the world matrices of its root and its joints. With `images` a frame contains the textures; without them
    it is as small as possible.
    """

    def __init__(self, entries: Sequence[tuple[Character, int]], *, images: bool = False) -> None:
        self.characters = [character for character, _ in entries]
        layout = laid_out(entries, images=images)
        self.layout_text, self.bounds = layout.text, np.zeros((layout.parts, 6), np.float32)
        text = self.text(0, "")
        self.data = bytearray(container.join(text, bytes(layout.binary)))
        self.text_start = container.HEADER.size + container.CHUNK_HEADER.size
        self.arrays = self.views(
            layout.blocks, self.text_start + len(text) + (-len(text) % 4) + container.CHUNK_HEADER.size
        )
        self.lock = threading.Lock()

    def views(self, blocks: Sequence[Sequence[ActorBlock]], start: int) -> list[list[ActorArrays]]:
        """Returns the arrays that the actors of each entry are written to: in the binary chunk, which starts
        at `start`, and in the table of bounds.
        """
        arrays_of_entries: list[list[ActorArrays]] = []
        row = 0
        for character, actors in zip(self.characters, blocks, strict=True):
            float_count, parts = character.surface.positions.size, len(character.shown_parts)
            matrices = (1 + len(character.skeleton), 4, 4)
            arrays_of_entries.append([])
            for block in actors:
                arrays_of_entries[-1].append(
                    ActorArrays(
                        self.view(16 * matrices[0], start + block.matrices).reshape(matrices),
                        self.view(float_count, start + block.positions),
                        self.view(float_count, start + block.normals),
                        self.bounds[row : row + parts],
                    )
                )
                row += parts
        return arrays_of_entries

    def view(self, floats: int, start: int) -> NDArray[np.float32]:
        """Returns `floats` floats of the file, from byte `start`; an empty array needs no place in the
        file.
        """
        return np.ndarray(floats, "<f4", self.data, start) if floats else np.zeros(0, np.float32)

    def frame(self, tick: int, state_hash: str, casts: Sequence[PosedCast]) -> bytes:
        """Returns a frame: a complete GLB with every actor of `casts` (in the order of the entries) in its
        pose, at its position.
        """
        with np.errstate(over="ignore", invalid="ignore"):
            matrices = [
                actor_matrices(character, cast)
                for character, cast in zip(self.characters, casts, strict=True)
            ]
        return self.filled(tick, state_hash, matrices, [cast.pose.weights for cast in casts])

    def filled(
        self, tick: int, state_hash: str, matrices: Sequence[Floats], weights: Sequence[Floats]
    ) -> bytes:
        """Returns the frame for `actor_matrices` (n,1+J,3,4) and morph weights (n,W) of each entry.

        Can be called from several threads.
        """
        with self.lock:
            for character, actors, cast_matrices, cast_weights in zip(
                self.characters, self.arrays, matrices, weights, strict=True
            ):
                for arrays, actor_worlds, actor_weights in zip(
                    actors, cast_matrices, cast_weights, strict=True
                ):
                    arrays.matrices[:, :, :3] = np.nan_to_num(actor_worlds).swapaxes(1, 2)
                    character.surface.pose_into(
                        actor_worlds[1:], actor_weights, arrays.positions, arrays.normals, arrays.bounds
                    )
            text = self.text(tick, state_hash)
            self.data[self.text_start : self.text_start + len(text)] = text
            return bytes(self.data)

    def text(self, tick: int, state_hash: str) -> bytes:
        """Returns the JSON chunk, with hash, tick and bounds in its slots."""
        return self.layout_text % (state_hash.zfill(16).encode(), tick, *self.bounds.reshape(-1).tolist())


def actor_matrices(character: Character, cast: PosedCast) -> Floats:
    """Returns the world matrices (n,1+J,3,4) of each actor's root and joints in stage space.

    :raises ValueError: when the pose has another number of actors or joints.
    """
    return np.concatenate([_root_matrices(cast)[:, None], stage_worlds(character, cast)], axis=1)


def stage_worlds(character: Character, cast: PosedCast) -> Floats:
    """Returns the joints' world matrices (n,J,3,4) in stage space, computed below the actor's root.

    :raises ValueError: when the pose has another number of actors or joints.
    """
    return stage_from_local(character.skeleton, cast.pose, _root_matrices(cast))


def _root_matrices(cast: PosedCast) -> NDArray[np.float32]:
    """Returns (n,3,4): each actor rotated by its heading about +Y, then moved to its position."""
    sin, cos = sincos(np.asarray(cast.heading, np.float64))
    roots = np.zeros((len(sin), 3, 4), np.float32)
    roots[:, 0, 0] = roots[:, 2, 2] = cos
    roots[:, 0, 2], roots[:, 2, 0], roots[:, 1, 1] = sin, -sin, 1
    roots[:, :, 3] = cast.root_position
    return roots

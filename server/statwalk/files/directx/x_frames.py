"""The frames of a .x file as joints, and the meshes that hang on them (RTCA 3.2, Listing 7)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from statwalk.errors import TextError
from statwalk.files.directx.left_handed import affine
from statwalk.files.directx.x_numbers import NumberReader
from statwalk.files.directx.x_objects import REFERENCE, DataObject
from statwalk.files.gltf.names import unique
from statwalk.maths import transform
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.rig.skeleton import Skeleton

FRAME, MATRIX, MESH, WEIGHTS = "frame", "frametransformmatrix", "mesh", "skinweights"
MOST_FRAMES, MOST_PLACED = 65_536, 65_536
SKEWED = "a frame's matrix is skewed and was replaced by the nearest translation, rotation and scale"
_ROOT = -1


class PlacedMesh(NamedTuple):
    """A mesh, the joint that carries it, and its node in the .glb: the joint's, or one of its own."""

    mesh: DataObject
    joint: int
    node: int


@dataclass
class XFrames:
    """The joints, parents first.

    names     as in the file, "" for a frame without a name
    parents   rows, -1 for a root
    matrices  (3, 4) each, in glTF's convention
    """

    names: list[str] = field(default_factory=list)
    parents: list[int] = field(default_factory=list)
    matrices: list[Floats] = field(default_factory=list)
    row_of: dict[str, int] = field(default_factory=dict)
    meshes: list[PlacedMesh] = field(default_factory=list)

    def add(self, name: str, parent: int, place: str) -> int:
        """Adds a joint at rest at its parent; returns its row."""
        if len(self.names) >= MOST_FRAMES:
            raise TextError(f"the file has more than {MOST_FRAMES} frames", place=place)
        self.names.append(name)
        self.parents.append(parent)
        self.matrices.append(np.eye(4)[:3])
        return len(self.names) - 1

    def skeleton(self) -> Skeleton:
        """Returns the skeleton; missing and repeated names are made unique."""
        return Skeleton(tuple(unique(self.names, "frame")), np.array(self.parents, np.int32))

    def rest(self, notes: list[str]) -> Pose:
        """Returns the pose of the frames' matrices."""
        matrices = np.array(self.matrices)
        if transform.is_skewed(matrices).any():
            notes.append(SKEWED)
        translation, rotation, scale = (part.astype(np.float32) for part in transform.to_trs(matrices))
        return Pose(translation, rotation, scale, np.zeros(0, np.float32))


def read_frames_of(file: DataObject, notes: list[str]) -> XFrames:
    """Returns the frames of a file with their meshes.

    A frame's matrix and mesh may stand elsewhere, under a name to which the frame refers. A frame with
    several meshes gets a joint for each mesh after its first. A mesh outside any frame becomes a joint,
    unless bones of the file move it.

    :raises TextError: when a matrix is wrong, or there is neither a frame nor a mesh.
    """
    frames, elsewhere = XFrames(), _Elsewhere(file, notes)
    ready = [(part, _ROOT) for part in reversed(file.parts) if part.kind == FRAME]
    while ready:
        frame, parent = ready.pop()
        row = frames.add(frame.name, parent, frame.place)
        frames.row_of.setdefault(frame.name, row)
        parts = list(elsewhere.parts_of(frame))
        for part in parts:
            if part.kind == MATRIX:
                frames.matrices[row] = _matrix(part)
            elif part.kind == MESH:
                frames.meshes.append(PlacedMesh(part, row, row))
        ready += [(part, row) for part in reversed(parts) if part.kind == FRAME]
    frames.meshes += [
        PlacedMesh(part, _ROOT, _ROOT) for part in file.of_kind(MESH) if id(part) not in elsewhere.used
    ]
    if len(frames.meshes) > MOST_PLACED:
        raise TextError(f"the file has more than {MOST_PLACED} meshes", place=file.place)
    _give_nodes(frames)
    if not frames.names:
        raise TextError("the file has no Frame and no Mesh: there is nothing to show", place="line 1")
    return frames


class _Elsewhere:
    """The named objects of the file to which frames may refer; `used` are the objects that one refers to."""

    def __init__(self, file: DataObject, notes: list[str]) -> None:
        self.notes, self.used = notes, set[int]()
        self.named: dict[str, DataObject] = {}
        ready = [file]
        while ready:
            parts = ready.pop().parts
            ready += [part for part in reversed(parts) if part.kind == FRAME]
            for part in parts:
                if part.kind in (MATRIX, MESH) and part.name:
                    self.named.setdefault(part.name, part)

    def parts_of(self, frame: DataObject) -> Iterator[DataObject]:
        """Yields the parts of a frame, references followed."""
        for part in frame.parts:
            if part.kind != REFERENCE:
                yield part
            elif part.name in self.named:
                self.used.add(id(self.named[part.name]))
                yield self.named[part.name]
            else:
                _note(
                    self.notes,
                    f"a frame refers to {part.name[:60]!r}, which is no mesh and no matrix of the file",
                )


def _note(notes: list[str], text: str) -> None:
    if text not in notes:
        notes.append(text)


def _matrix(part: DataObject) -> Floats:
    numbers = NumberReader(part)
    matrix = affine(numbers.floats(16, "a matrix"))
    numbers.end()
    return matrix


def _give_nodes(frames: XFrames) -> None:
    """Gives each mesh a node of its own."""
    count = Counter(placed.node for placed in frames.meshes if placed.node != _ROOT)
    taken: set[int] = set()
    only_bones = bool(frames.names)
    for row, (mesh, joint, node) in enumerate(frames.meshes):
        if joint == _ROOT and only_bones and any(mesh.of_kind(WEIGHTS)):
            frames.meshes[row] = PlacedMesh(mesh, 0, _ROOT)
        elif joint == _ROOT or (count[node] > 1 and node in taken):
            own = frames.add(mesh.name or "mesh", joint, mesh.place)
            frames.meshes[row] = PlacedMesh(mesh, own, own)
        else:
            taken.add(node)
    free = len(frames.names)
    for row, placed in enumerate(frames.meshes):
        if placed.node == _ROOT:
            frames.meshes[row], free = placed._replace(node=free), free + 1

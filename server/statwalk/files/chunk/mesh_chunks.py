"""The mesh: a POLY chunk for each primitive, in the SKIN chunk of the joint that carries it; BIND chunks."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from statwalk.character.character import Character
from statwalk.files.chunk.array_pool import ArrayPool, PoolWriter, below, largest
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, joined, refuse
from statwalk.files.chunk.detail_chunks import collapse_chunks, read_collapses
from statwalk.files.chunk.records import ATTR, BIND, NONE, POLY
from statwalk.files.gltf.allowance import Allowance, drawn_vertices, mesh_vertices
from statwalk.skin.primitive import Primitive, Skin

MOST_NUMBER = 65_536
WEIGHT_ERROR = 1e-4
"""how far the sum of a vertex's weights may be from 1"""
MODES = range(7)


def skin_chunk(pool: PoolWriter, skin: Skin) -> bytes:
    """Returns the BIND chunk of a skin."""
    record = BIND.pack(pool.add(skin.joints), pool.add(skin.inverse_bind))
    return joined("BIND", record, joined("NAME", skin.name.encode()))


def read_skin(reader: ChunkReader, chunk: Chunk, pool: ArrayPool, joints: int) -> Skin:
    """Returns the skin in a BIND chunk; the skeleton has `joints` joints.

    :raises ModelError: when an array is wrong.
    """
    rows, matrices = chunk.record(BIND)
    name, _ = reader.name(chunk, BIND.size)
    bending = pool.array(chunk, rows, "the joints", "i4", (None,))
    if not len(bending) or int(bending.min()) < 0 or largest(bending) >= joints:
        raise refuse(chunk, f"a skin has joints 0…{joints - 1}")
    inverse = pool.array(chunk, matrices, "the inverse bind matrices", "f4", (len(bending), 3, 4))
    return Skin(name, bending, inverse)


def polygon_chunk(pool: PoolWriter, row: int, part: Primitive) -> bytes:
    """Returns the POLY chunk of a primitive, the character's part `row`."""
    arrays = (
        part.positions,
        part.normals,
        part.indices,
        part.joints,
        part.weights,
        part.target_positions,
        part.target_normals,
    )
    numbers = (
        row,
        part.node,
        part.mesh,
        part.primitive,
        part.mode,
        _or_none(part.material),
        _or_none(part.skin),
    )
    record = POLY.pack(*numbers, part.weight_first, *(pool.add(values) for values in arrays))
    attributes = [
        joined("ATTR", ATTR.pack(pool.add(values)) + name.encode())
        for name, values in part.attributes.items()
        if _is_held(name)
    ]
    return joined("POLY", record, *attributes, *collapse_chunks(pool, part))


def _is_held(attribute: str) -> bool:
    kind, _, number = attribute.partition("_")
    return kind in ("TEXCOORD", "COLOR") and number.isdecimal()


def _or_none(value: int | None) -> int:
    return -1 if value is None else value


@dataclass
class PolygonReader:
    """Reads POLY chunks; counts vertices, which many chunks may share."""

    reader: ChunkReader
    pool: ArrayPool
    character: Character
    """the character as read so far: no parts yet, but what parts refer to"""
    rows: dict[int, Primitive] = field(default_factory=dict)
    drawn: Allowance = field(default_factory=drawn_vertices)
    vertices: Allowance = field(default_factory=mesh_vertices)

    def take(self, joint: int, chunk: Chunk) -> None:
        """Reads the POLY chunk in the SKIN chunk of a joint.

        :raises ModelError: when a reference, an array or a name is wrong.
        """
        row, node, mesh, primitive, mode, material, skin, first, *arrays = chunk.record(POLY)
        if mode not in MODES or max(node, mesh, primitive) >= MOST_NUMBER or row in self.rows:
            raise refuse(
                chunk, f"a mode is 0…6, numbers are below {MOST_NUMBER}, and every part has its own row"
            )
        self._check_node(chunk, joint, node)
        positions = self.pool.array(chunk, arrays[0], "the positions", "f4", (None, 3))
        count = len(positions)
        place = f"byte {chunk.place}"
        self.drawn.take(count, place)
        self.vertices.take(count, place)
        if not count:
            raise refuse(chunk, "a primitive has at least one vertex")
        joints, weights = self._influences(chunk, skin, arrays[3], arrays[4], count)
        targets = self.pool.optional(chunk, arrays[5], "the displacements", "f4", (None, count, 3))
        shape = (0 if targets is None else len(targets), count, 3)
        below(chunk, first, len(self.character.bind_pose.weights) - shape[0] + 1, "the first morph weight")
        self.vertices.take(count * (shape[0] // 4 + 1), place)
        self.rows[row] = Primitive(
            joint,
            node,
            mesh,
            primitive,
            positions,
            self.pool.optional(chunk, arrays[1], "the normals", "f4", (count, 3)),
            self._indices(chunk, arrays[2], count),
            mode,
            None if material == -1 else below(chunk, material, len(self.character.materials), "the material"),
            None if skin == -1 else skin,
            joints,
            weights,
            targets,
            self.pool.optional(chunk, arrays[6], "the normals' displacements", "f4", shape),
            first,
            self._attributes(chunk, count),
            read_collapses(self.reader, chunk, self.pool, count),
        )

    def _check_node(self, chunk: Chunk, joint: int, node: int) -> None:
        """A node that is a joint is the joint that carries the primitive."""
        rows = np.flatnonzero(self.character.node_index == node)
        if len(rows) and int(rows[0]) != joint:
            raise refuse(chunk, f"node {node} is another joint than the one around it")

    def _influences(
        self, chunk: Chunk, skin: int, joints_row: int, weights_row: int, count: int
    ) -> tuple[NDArray[np.uint16] | None, NDArray[np.float32] | None]:
        if skin == -1 and joints_row == weights_row == NONE:
            return None, None
        below(chunk, skin, len(self.character.skins), "the skin")
        joints = self.pool.array(chunk, joints_row, "the joints", "u2", (count, None))
        weights = self.pool.array(chunk, weights_row, "the weights", "f4", joints.shape)
        below(chunk, largest(joints), len(self.character.skins[skin].joints), "a joint of the skin")
        if not (weights >= 0).all() or not (np.abs(weights.sum(1) - 1) <= WEIGHT_ERROR).all():
            raise refuse(chunk, "the weights of a vertex are 0 or more, and sum to 1")
        return joints, weights

    def _indices(self, chunk: Chunk, row: int, count: int) -> NDArray[np.uint32] | None:
        indices = self.pool.optional(chunk, row, "the indices", "u4", (None,))
        if indices is not None:
            below(chunk, largest(indices), count, "an index")
            self.vertices.take(len(indices) // 3, f"byte {chunk.place}")
        return indices

    def _attributes(self, chunk: Chunk, count: int) -> dict[str, NDArray[np.float32]]:
        attributes = {}
        for part in self.reader.inside(chunk, POLY.size, ("ATTR", "LODD")):
            if part.tag == "LODD":
                continue
            (row,) = part.record(ATTR)
            name = part.text(ATTR.size)
            width = 2 if name.startswith("TEXCOORD_") else 4
            if not _is_held(name):
                raise refuse(part, f"attributes are TEXCOORD_0, COLOR_0 …, not {name[:60]!r}")
            attributes[name] = self.pool.array(part, row, name[:60], "f4", (count, width))
            self.vertices.take(count, f"byte {part.place}")
        return attributes

    def parts(self) -> tuple[Primitive, ...]:
        """Returns the primitives by their rows."""
        return tuple(self.rows[row] for row in sorted(self.rows))

"""Level of detail: a LODD chunk in each POLY chunk, the order in which its vertices collapse, and one in the
object, the levels (DS10; RTCA 3.1).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from statwalk.files.chunk.array_pool import ArrayPool, PoolWriter
from statwalk.files.chunk.chunk_tree import Chunk, ChunkReader, joined, refuse
from statwalk.files.chunk.records import LODD, LODD_POLY, POLY
from statwalk.skin.collapses import Collapses, DetailLevel, fault, level_fault
from statwalk.skin.primitive import Primitive


def collapse_chunks(pool: PoolWriter, part: Primitive) -> list[bytes]:
    """Returns the LODD chunk of a primitive; no chunk if it has no collapses."""
    if part.collapses is None:
        return []
    arrays = part.collapses.vertices, part.collapses.onto, part.collapses.steps
    return [joined("LODD", LODD_POLY.pack(*(pool.add(values) for values in arrays)))]


def read_collapses(reader: ChunkReader, polygon: Chunk, pool: ArrayPool, vertices: int) -> Collapses | None:
    """Returns the collapses of a POLY chunk with so many vertices, None without any.

    :raises ModelError: when they are wrong, or there are two LODD chunks.
    """
    chunks = [part for part in reader.inside(polygon, POLY.size, ("ATTR", "LODD")) if part.tag == "LODD"]
    if not chunks:
        return None
    if len(chunks) > 1:
        raise refuse(polygon, "a POLY has one LODD at most")
    rows = zip(chunks[0].record(LODD_POLY), ("the vertices", "their goals", "the steps"), strict=True)
    collapses = Collapses(*(pool.array(chunks[0], row, what, "u4", (None,)) for row, what in rows))
    wrong = fault(collapses, vertices)
    if wrong:
        raise refuse(chunks[0], wrong)
    return collapses


def level_chunks(pool: PoolWriter, levels: Sequence[DetailLevel]) -> list[bytes]:
    """Returns the LODD chunk of an object; no chunk without levels."""
    if not levels:
        return []
    steps = np.array([level.steps for level in levels], np.uint32)
    return [joined("LODD", LODD.pack(pool.add(steps), pool.add(np.array([level.error for level in levels]))))]


def read_levels(chunks: Sequence[Chunk], pool: ArrayPool) -> tuple[DetailLevel, ...]:
    """Returns the levels in the LODD chunks of an object, empty without any.

    :raises ModelError: when they are wrong, or there are two LODD chunks.
    """
    if not chunks:
        return ()
    if len(chunks) > 1:
        raise refuse(chunks[1], "an OBJE has one LODD at most")
    rows = chunks[0].record(LODD)
    steps = pool.array(chunks[0], rows[0], "the steps", "u4", (None,))
    errors = pool.array(chunks[0], rows[1], "the errors", "f8", (len(steps),))
    levels = tuple(map(DetailLevel, steps.tolist(), errors.tolist()))
    wrong = level_fault(levels)
    if wrong:
        raise refuse(chunks[0], wrong)
    return levels

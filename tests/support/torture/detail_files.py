"""Mutations of a stored level of detail: the extras of a glTF model, and the LODD chunks of a chunk file.

A glTF model whose order is wrong is read without it; a chunk file is refused.
"""

import random
from copy import deepcopy
from functools import cache
from typing import Any

import numpy as np
import statwalk
from rig_shapes import human, mesh
from statwalk.character.character import Character
from statwalk.files.chunk import write_chunk_file
from torture.chunk_files import CHANGES_OF_CHUNKS, chunk_outcome
from torture.gltf_changes import CHANGES, other_value, places
from torture.gltf_files import Parts, finish, gltf_outcome, of_parts, split
from torture.mutator import Mutator

NUMBERS = (0, 1, 2, 77, 255, 65_535, 1 << 31, (1 << 32) - 1)
ARRAYS = ("vertices", "onto", "steps")
LEVELS = ("all", [], None, [[1]], [[0, 0.1]], [[1, 1e99]], [[True, 0.1]], [[2, 0.1], [1, 0.2]], [[1, -1.0]])


@cache
def figure() -> Character:
    """A small figure with an order of collapses."""
    return statwalk.with_detail(mesh(*human()))


def _extras(root: Any) -> Any:
    return root["meshes"][0]["primitives"][0]["extras"]["statwalk"]["collapses"]


def other_number(chance: random.Random, root: Any, binary: bytearray) -> None:
    """One or some of the stored numbers of the order."""
    accessor = root["accessors"][_extras(root)[chance.choice(ARRAYS)]]
    start = root["bufferViews"][accessor["bufferView"]]["byteOffset"]
    size = {5121: 1, 5123: 2, 5125: 4}[accessor["componentType"]]
    for _ in range(chance.choice([1, 1, 4])):
        at = start + size * chance.randrange(accessor["count"])
        value = chance.choice([*NUMBERS, chance.randrange(100)])
        binary[at : at + size] = (value % (1 << 8 * size)).to_bytes(size, "little")


def other_levels(chance: random.Random, root: Any, binary: bytearray) -> None:
    """The list of levels, or something in it."""
    own = root["extras"]["statwalk"]
    if chance.random() < 0.3:
        own["levels"] = deepcopy(chance.choice(LEVELS))
        return
    entry, key = chance.choice(places(own["levels"]))
    entry[key] = other_value(chance, entry[key])


def other_extras(chance: random.Random, root: Any, binary: bytearray) -> None:
    """The accessors that the order names."""
    rows = _extras(root)
    rows[chance.choice(ARRAYS)] = chance.choice([*rows.values(), *range(12), other_value(chance, 1)])


def order_in_chunks(chance: random.Random, data: bytearray) -> None:
    """One or some of the stored numbers of the order, where they are in the pool."""
    (part,) = figure().parts
    assert part.collapses is not None
    values = getattr(part.collapses, chance.choice(ARRAYS))
    at = data.index(values.astype("<u4").tobytes())
    for _ in range(chance.choice([1, 1, 4])):
        place = at + 4 * chance.randrange(len(values))
        data[place : place + 4] = chance.choice([*NUMBERS, chance.randrange(100)]).to_bytes(4, "little")


def levels_in_chunks(chance: random.Random, data: bytearray) -> None:
    """The steps or the error of a level, where they are in the pool."""
    levels = figure().levels
    steps = np.array([level.steps for level in levels], "<u4")
    errors = np.array([level.error for level in levels], "<f8")
    values, other = chance.choice(
        [
            (steps, np.array(chance.choice(NUMBERS), "<u4")),
            (errors, np.array(chance.choice([0.0, -1.0, 1e30, 1e308, np.nan, np.inf]), "<f8")),
        ]
    )
    at = data.index(values.tobytes()) + values.itemsize * chance.randrange(len(values))
    data[at : at + values.itemsize] = other.tobytes()


def _model() -> list[Parts]:
    return [split(figure().model_glb)]


def _chunk_file() -> list[bytearray]:
    return [bytearray(write_chunk_file(figure()))]


GLTF_DETAIL = Mutator(
    _model,
    [of_parts(change) for change in [other_number, other_levels, other_extras] * 4 + CHANGES[-5:]],
    gltf_outcome,
    finish,
)
CHUNK_DETAIL = Mutator(
    _chunk_file,
    [*[order_in_chunks, levels_in_chunks] * 4, *CHANGES_OF_CHUNKS],
    chunk_outcome,
)

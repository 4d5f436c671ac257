"""Mutations of chunk files: each is read, or refused with a byte."""

import random
import re
import struct

from reference_poses import MODELS, character
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from torture.mutator import Mutator
from torture.outcomes import outcome
from whole_character import whole

TAGS = (
    b"HEAD TEXT INFO IMAG MATE OBJE NAME VECT BIND SKIN PIVO CONS POLY ATTR ANIM MARK CHAN IKCH EXPR LODD"
).split()
TAG = re.compile(b"|".join(TAGS))
NUMBERS = (0, 1, 2, 3, 4, 7, 255, 65_535, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF)
REALS = (0.0, -1.0, 0.5, 1e-30, 1e30, -1e30, float("nan"), float("inf"))
LARGEST_SOURCE_BYTES = 60_000


def sources() -> list[bytearray]:
    """A character with every kind of part, and small models."""
    small = [character(name) for name in MODELS if "/" not in name or "synthetic" in name]
    files = [write_chunk_file(source) for source in (whole(), whole(), *small)]
    return [bytearray(data) for data in files if len(data) <= LARGEST_SOURCE_BYTES]


def chunk_starts(data: bytearray) -> list[int]:
    """Where chunks seem to begin."""
    return [match.start() for match in TAG.finditer(data, 12, len(data) - 8) if match.start() % 4 == 0]


def _in_a_chunk(chance: random.Random, data: bytearray) -> int:
    at = chance.choice(chunk_starts(data))
    return min(len(data) - 8, at + 8 + 4 * chance.choice([0, 0, 1, 2, 3, 5, 8, 13, chance.randrange(60)]))


def other_length(chance: random.Random, data: bytearray) -> None:
    at = chance.choice(chunk_starts(data)) + 4
    (length,) = struct.unpack_from("<I", data, at)
    new = chance.choice([*NUMBERS, length + 4, length - 4, length + 1, length * 2])
    struct.pack_into("<I", data, at, new & 0xFFFFFFFF)


def other_tag(chance: random.Random, data: bytearray) -> None:
    at = chance.choice(chunk_starts(data))
    data[at : at + 4] = chance.choice([*TAGS, b"\xff\0\xff\0"])


def other_whole_number(chance: random.Random, data: bytearray) -> None:
    struct.pack_into("<I", data, _in_a_chunk(chance, data), chance.choice(NUMBERS))


def other_real_number(chance: random.Random, data: bytearray) -> None:
    struct.pack_into(chance.choice(["<f", "<d"]), data, _in_a_chunk(chance, data), chance.choice(REALS))


def other_byte(chance: random.Random, data: bytearray) -> None:
    data[_in_a_chunk(chance, data) + chance.randrange(4)] = chance.randrange(256)


def any_byte(chance: random.Random, data: bytearray) -> None:
    data[chance.randrange(len(data))] = chance.randrange(256)


def swapped(chance: random.Random, data: bytearray) -> None:
    """Two pieces of the file change places."""
    size = 4 * chance.randrange(1, 20)
    one, other = (min(chance.choice(chunk_starts(data)), len(data) - size) for _ in range(2))
    data[one : one + size], data[other : other + size] = data[other : other + size], data[one : one + size]


CHANGES_OF_CHUNKS = (
    other_length,
    other_tag,
    other_whole_number,
    other_whole_number,
    other_real_number,
    other_byte,
    any_byte,
    swapped,
)


def cut(chance: random.Random, data: bytearray) -> None:
    del data[chance.randrange(len(data)) :]


def chunk_outcome(data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    return outcome(lambda: read_chunk_file(data, "mutated"), ("/", "byte "))


CHUNK = Mutator(sources, [*CHANGES_OF_CHUNKS * 2, cut], chunk_outcome)

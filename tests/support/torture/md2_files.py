"""Mutations of MD2 files: each is read, or refused with a byte; what is read is written and read again,
unless it reaches too far.
"""

import random
import struct

from md2_models import md2
from paths import ASSETS
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.md2 import read_md2, write_md2
from torture.mutator import Mutator
from torture.outcomes import outcome

NUMBERS = [
    0,
    1,
    2,
    3,
    4,
    7,
    40,
    68,
    255,
    256,
    65_535,
    65_536,
    1 << 20,
    1 << 30,
    (1 << 31) - 1,
    -1,
    -4,
    -(1 << 31),
]
FLOATS = [float("nan"), float("inf"), -float("inf"), 0.0, -1.0, 1e-45, 1e6, -1e6, 1.1e6, 3.4e38]


def sources() -> list[bytearray]:
    """The files that are mutated: small ones made by hand, and real ones where they are."""
    real = sorted((ASSETS / "md2").glob("[!m]*.md2")) if ASSETS.is_dir() else []
    made = [md2(), md2(["flag"]), md2(["run1", "run2"], (0, 0, 0, 0)), md2(["death101"] * 3)]
    found = (path.read_bytes() for path in real if path.stat().st_size < 100_000)
    return [bytearray(data) for data in (*made, *found)]


def head_number(chance: random.Random, data: bytearray) -> None:
    """Another number in the head, near the old one or of any size."""
    first = 4 * chance.randrange(2, 17)
    (old,) = struct.unpack_from("<i", data, first)
    near = old + chance.choice([-4, -1, 1, 2, 12, 64])
    value = near if chance.random() < 0.5 else chance.choice(NUMBERS)
    struct.pack_into("<i", data, first, max(-(1 << 31), min(value, (1 << 31) - 1)))


def swapped_numbers(chance: random.Random, data: bytearray) -> None:
    """Two numbers of the head change places."""
    a, b = (4 * chance.randrange(2, 17) for _ in range(2))
    data[a : a + 4], data[b : b + 4] = data[b : b + 4], data[a : a + 4]


def frame_number(chance: random.Random, data: bytearray) -> None:
    """A number that cannot be in the head of a frame; the frames' place is taken from the head."""
    size, count, first = (struct.unpack_from("<i", data, place)[0] for place in (16, 40, 56))
    struct.pack_into(
        "<f", data, first + size * chance.randrange(count) + 4 * chance.randrange(6), chance.choice(FLOATS)
    )


def name_letters(chance: random.Random, data: bytearray) -> None:
    """Other letters in the name of a frame."""
    size, count, first = (struct.unpack_from("<i", data, place)[0] for place in (16, 40, 56))
    at = first + size * chance.randrange(count) + 24
    data[at : at + 16] = bytes(chance.choice(b"09ar_\xff\n\0") for _ in range(16))


def any_bytes(chance: random.Random, data: bytearray) -> None:
    for _ in range(chance.choice([1, 4, 40])):
        data[chance.randrange(len(data))] = chance.randrange(256)


def cut(chance: random.Random, data: bytearray) -> None:
    del data[chance.randrange(len(data)) :]


def insert(chance: random.Random, data: bytearray) -> None:
    at = chance.randrange(len(data))
    data[at:at] = bytes(chance.choice([1, 4, 68]))


CHANGES = (
    [head_number] * 5 + [frame_number, name_letters] * 2 + [any_bytes] * 3 + [swapped_numbers, cut, insert]
)


def md2_outcome(data: bytes) -> str:
    """Returns `read`, `too far` (to be written) or `refused`; raises where the reader breaks."""
    return outcome(lambda: read_md2(data, "mutated"), ("byte ",), then=_written)


def _written(character: Character) -> str:
    try:
        written = write_md2(character)
    except ContentError as error:
        if "reaches farther" in error.message:
            return "too far"
        raise
    again = read_md2(written, "again")
    durations = [[clip.duration for clip in one.clips.values()] for one in (character, again)]
    assert durations[0] == durations[1]
    return "read"


MD2 = Mutator(sources, CHANGES, md2_outcome)

"""Chunk files that nobody should send; each is refused with the byte and the reason."""

import struct
import tracemalloc

import pytest
from statwalk.errors import ContentError, ModelError
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from whole_character import straight, whole

WHOLE = write_chunk_file(whole())
HUGE = struct.pack("<I", 0xFFFFFFF0)


def place_of(tag: bytes, which: int = 0) -> int:
    """The byte where the first (or a later) chunk of a tag begins."""
    at = -1
    for _ in range(which + 1):
        at = WHOLE.index(tag, at + 1)
    return at


def changed(tag: bytes, offset: int, new: bytes) -> bytes:
    """The file with other bytes at an offset of the first chunk's content."""
    at = place_of(tag) + 8 + offset
    return WHOLE[:at] + new + WHOLE[at + len(new) :]


def u32(*values: int) -> bytes:
    return struct.pack(f"<{len(values)}I", *values)


def nested(depth: int) -> bytes:
    """A file of nothing but SKIN chunks inside each other."""
    record = struct.pack("<II10f", 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1)
    own = b"NAME" + u32(1) + b"a\0\0\0" + b"PIVO" + u32(len(record)) + record
    lengths = ((depth - level - 1) * (8 + len(own)) + len(own) for level in range(depth))
    skins = b"".join(b"SKIN" + u32(length) + own for length in lengths)
    body = u32(depth, 0xFFFFFFFF) + skins
    return WHOLE[:12] + b"HEAD" + u32(len(body) + 8) + b"OBJE" + u32(len(body)) + body


HOSTILE = {
    "nothing": (b"", "begins with"),
    "another file": (b"glTF" + b"\0" * 100, "begins with"),
    "text mode": (WHOLE.replace(b"\r\n", b"\n"), "begins with"),
    "another version": (WHOLE[:8] + u32(2) + WHOLE[12:], "version 2"),
    "only the magic": (WHOLE[:12], "one HEAD"),
    "cut": (WHOLE[:-100], "are left"),
    "cut in a head": (WHOLE[:18], "cut within the head"),
    "a chunk longer than the file": (changed(b"VECT", -4, HUGE), "are left"),
    "an array of 16 thousand million numbers": (changed(b"VECT", 4, HUGE), "numbers take"),
    "an array without dimensions": (changed(b"VECT", 1, b"\0"), "dimensions"),
    "an array of an unknown type": (changed(b"VECT", 0, b"\x09"), "type"),
    "a joint's row twice": (changed(b"PIVO", 0, u32(1)), "rows of joints"),
    "a joint at infinity": (changed(b"PIVO", 8, struct.pack("<f", float("inf"))), "finite"),
    "a node beyond the last": (changed(b"PIVO", 4, u32(60_000)), "nodes of joints"),
    "an unknown array": (changed(b"POLY", 32, u32(77)), "array 77"),
    "an array of another shape": (changed(b"POLY", 32, u32(0)), "must be"),
    "an unknown mode": (changed(b"POLY", 16, u32(9)), "mode"),
    "an unknown material": (changed(b"POLY", 20, u32(3)), "material"),
    "an unknown skin": (changed(b"POLY", 24, u32(3)), "skin"),
    "a weight beyond the pose's": (changed(b"POLY", 28, u32(5)), "morph weight"),
    "a skin without joints of its own": (changed(b"BIND", 0, u32(0)), "must be"),
    "a channel of no joint": (changed(b"CHAN", 0, u32(9)), "joint"),
    "a channel of no path": (changed(b"CHAN", 4, u32(9)), "path"),
    "a channel of no interpolation": (changed(b"CHAN", 8, u32(99)), "interpolation"),
    "a clip that ends before it begins": (changed(b"ANIM", 0, struct.pack("<d", -1)), "duration"),
    "a clip of NaN seconds": (changed(b"ANIM", 0, struct.pack("<d", float("nan"))), "duration"),
    "a marker after the end": (changed(b"MARK", 0, struct.pack("<d", 7)), "marker"),
    "a chain of a million joints": (changed(b"IKCH", 0, u32(1_000_000)), "more than"),
    "a chain upwards": (changed(b"IKCH", 4, u32(1, 0)), "not below"),
    "a minimum above its maximum": (changed(b"CONS", 40, struct.pack("<d", 99)), "minimum"),
    "a limit of no type": (changed(b"CONS", 192, b"knotted\0"), "knotted"),
    "an expression of nothing": (changed(b"EXPR", 4, b"????"), "expressions"),
    "materials of no JSON": (changed(b"MATE", 0, b"!"), "JSON"),
    "an attribute of another name": (changed(b"ATTR", 4, b"VOLUM_0"), "TEXCOORD_0"),
    "joints ten thousand deep": (nested(10_000), "deep"),
    "joints of one name": (nested(2), "rows of joints"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_refused_with_the_byte(name: str) -> None:
    data, reason = HOSTILE[name]
    tracemalloc.start()
    with pytest.raises(ModelError, match=reason) as refused:
        read_chunk_file(data, "hostile")
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert refused.value.place.startswith("byte ")
    assert peak < 4 * len(data) + (2 << 20)


def test_joints_too_deep_are_not_written() -> None:
    with pytest.raises(ContentError, match="1024 deep"):
        write_chunk_file(straight(1_025))
    assert len(read_chunk_file(write_chunk_file(straight(1_024)), "deep").skeleton) == 1_024

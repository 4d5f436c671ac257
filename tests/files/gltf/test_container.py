import struct

import pytest
from statwalk.errors import ModelError
from statwalk.files.gltf import container
from tiny_model import glb, model


def test_split_gives_back_what_was_joined():
    text, binary = container.split(container.join(b'{"a":1}', b"12345"))
    assert (bytes(text), bytes(binary)) == (b'{"a":1} ', b"12345\0\0\0")


def test_bytes_after_the_end_are_ignored():
    assert bytes(container.split(model() + b"garbage")[0]) == bytes(container.split(model())[0])


def test_chunks_of_unknown_type_are_ignored():
    whole = glb({}, b"")
    extra = struct.pack("<II", 4, 0x58585858) + b"xxxx"
    longer = whole[:8] + struct.pack("<I", len(whole) + len(extra)) + whole[12:] + extra
    assert bytes(container.split(longer)[0]) == b"{}  "


BROKEN = {
    "no header": (model()[:11], "byte 0"),
    "version 1": (model()[:4] + struct.pack("<I", 1) + model()[8:], "byte 4"),
    "cut off": (model()[:-64], "byte 8"),
    "chunk too long": (model()[:12] + struct.pack("<I", 1 << 30) + model()[16:], "byte 12"),
    "no JSON first": (model()[:16] + struct.pack("<I", 0x004E4942) + model()[20:], "byte 12"),
}


@pytest.mark.parametrize(("data", "place"), BROKEN.values(), ids=BROKEN)
def test_broken_containers_are_refused_at_a_byte(data, place):
    with pytest.raises(ModelError) as caught:
        container.split(data)
    assert caught.value.place == place

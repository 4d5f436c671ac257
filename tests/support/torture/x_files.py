"""Mutations of .x text: each is read, or refused with a line; what is read is written and read again."""

import re

import small_x
import tiny_model
from paths import ASSETS
from statwalk.character.character import Character
from statwalk.errors import TextError
from statwalk.files.directx import read_directx, write_directx
from statwalk.files.gltf import read_model
from torture.mutator import Mutator
from torture.outcomes import outcome
from torture.text_changes import deepen, rename, text_changes

PIECE = re.compile(rb'[{}]|"[^"\n]*"|[;,]+|[^\s;,{}"]+')
NAMES = re.compile(rb"(?:Frame|Mesh|Material|AnimationSet) (\w+)")
WORDS = b"Frame Mesh MeshNormals SkinWeights FrameTransformMatrix AnimationKey IKchain template".split()
WORDS += [b"Arm", b"{Arm}", b"{}", b"{ {", b"} }", b'"Arm"', b"<0-0>"]
HEAD_BYTES = 16


def sources() -> list[bytearray]:
    """The texts that are mutated: by hand, written, and a small real one where it is."""
    tiny = write_directx(read_model(tiny_model.model(), "tiny"))
    real = ASSETS / "x" / "test_cube_text.x"
    found = [real.read_bytes()] if real.is_file() else []
    by_hand = [text.encode() for text in (small_x.ARM, small_x.ARM, small_x.LISTING_7_AND_8)]
    return [bytearray(text) for text in (*by_hand, tiny, *found)]


def x_outcome(data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    return outcome(lambda: read_directx(data, "mutated"), ("line ",), TextError, _written)


def _written(character: Character) -> str:
    read_directx(write_directx(character), "again")
    return "read"


X = Mutator(
    sources,
    [*text_changes(PIECE, WORDS, HEAD_BYTES), deepen(PIECE, b"Frame a { ", b"} "), rename(NAMES)],
    x_outcome,
)

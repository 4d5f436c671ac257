"""Mutations of motion captures, BVH and TRC: each is read, or refused with a line."""

import re

import captures
import numpy as np
from paths import ASSETS
from statwalk.files.bvh.write_bvh import write_bvh
from statwalk.files.captures import read_capture
from torture.mutator import Mutator
from torture.outcomes import outcome
from torture.text_changes import deepen, rename, text_changes
from whole_character import whole

PIECE = re.compile(rb"[^\s]+")
NAMES = re.compile(rb"(?:ROOT|JOINT) (\S+)")
BVH_WORDS = (
    b"HIERARCHY ROOT JOINT End Site OFFSET CHANNELS MOTION Frames: Frame Time: Xposition Zrotation".split()
)
TRC_WORDS = b"PathFileType DataRate NumFrames NumMarkers Units mm cm m Frame# Time X1 Y1".split()
LARGEST_SOURCE_BYTES = 60_000


def bvh_sources() -> list[bytearray]:
    """Captures by hand, one that statwalk writes, and small real ones where they are."""
    real = [path for path in sorted(ASSETS.rglob("*.bvh")) if "invalid" not in path.parts]
    found = (path.read_bytes() for path in real if path.stat().st_size <= LARGEST_SOURCE_BYTES)
    return [bytearray(data) for data in (captures.walk().encode(), write_bvh(whole()), *found)]


def trc_sources() -> list[bytearray]:
    """Markers of a body, some of them hidden in some frames."""
    chance = np.random.default_rng(1)
    places = chance.random((6, 4, 3))
    places[2, 1] = np.nan
    return [bytearray(captures.trc(["Hips", "LKNE", "LANK", "RHip"], places).encode())]


def bvh_outcome(data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    return outcome(lambda: read_capture(data, ".bvh", "mutated"), PLACES)


def trc_outcome(data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    return outcome(lambda: read_capture(data, ".trc", "mutated"), PLACES)


PLACES = ("line ", "byte ", "")
"""what is wrong with all frames together has no line"""
NEST = b"JOINT a\n{\nOFFSET 0 1 0\nCHANNELS 1 Xrotation\n"
BVH = Mutator(
    bvh_sources, [*text_changes(PIECE, BVH_WORDS), deepen(PIECE, NEST, b"}\n"), rename(NAMES)], bvh_outcome
)
TRC = Mutator(trc_sources, text_changes(PIECE, TRC_WORDS), trc_outcome)

"""Mutations of glTF models: each is read, or refused with a place in its JSON or its bytes."""

import json
import random
from typing import Any

from paths import GLTF
from statwalk.files.gltf import read_model
from tiny_model import document, glb
from torture.gltf_changes import CHANGES, bent_container
from torture.mutator import Change, Mutator
from torture.outcomes import outcome

LARGEST_SOURCE_BYTES = 400_000
Parts = tuple[dict[str, Any], bytearray]
"""JSON and binary chunk"""


def split(data: bytes) -> Parts:
    """JSON and binary chunk of a valid GLB."""
    size = int.from_bytes(data[12:16], "little")
    return json.loads(data[20 : 20 + size]), bytearray(data[28 + size :])


def sources() -> list[Parts]:
    """The files that are mutated: the tiny model, and small real ones where they are."""
    real = sorted(GLTF.rglob("*.glb")) if GLTF.is_dir() else []
    return [
        document(),
        *(split(path.read_bytes()) for path in real if path.stat().st_size < LARGEST_SOURCE_BYTES),
    ]


def of_parts(change: Any) -> Change:
    """A change of JSON and binary as a change of both together."""
    return lambda chance, parts: change(chance, *parts)


def finish(chance: random.Random | None, parts: Parts) -> bytes:
    """The GLB; one in ten has a bent container."""
    data = glb(*parts)
    return bent_container(chance, data) if chance is not None and chance.random() < 0.1 else data


def gltf_outcome(data: bytes) -> str:
    """Returns `read` or `refused`; raises where a reader breaks."""
    return outcome(lambda: read_model(data, "mutated"), ("/", "byte "))


GLTF_MODEL = Mutator(sources, [of_parts(change) for change in CHANGES], gltf_outcome, finish)

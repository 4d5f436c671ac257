"""The malformed files of the shared assets: each refused with a place, repaired, or read, as its expectation
says.

253 are glTF. The other 23 (.bvh and .md2) are in formats that are not read: the reader of models refuses them
at their first byte.
"""

import json

import numpy as np
import pytest
from paths import ASSETS, needs_assets
from statwalk.errors import ModelError
from statwalk.files.gltf import read_model

EXPECTATIONS = ASSETS / "invalid" / "expectations.json"
LISTED = json.loads(EXPECTATIONS.read_text())["files"] if EXPECTATIONS.is_file() else []


def read(entry):
    path = ASSETS / entry["file"]
    return read_model(path.read_bytes(), path.stem, path.parent)


def of(*kinds):
    chosen = [entry for entry in LISTED if entry["expect"] in kinds]
    return pytest.mark.parametrize("entry", chosen, ids=[entry["file"] for entry in chosen])


@needs_assets
def test_all_are_listed():
    assert len(LISTED) == 276


@needs_assets
@of("reject")
def test_refused_with_a_place(entry):
    with pytest.raises(ModelError) as caught:
        read(entry)
    assert caught.value.place.startswith(("/", "byte "))


@needs_assets
@of("accept", "normalise", "ignore")
def test_read(entry):
    assert_finite(read(entry))


@needs_assets
@of("either")
def test_read_or_refused(entry):
    try:
        character = read(entry)
    except ModelError:
        return
    assert_finite(character)


def assert_finite(character):
    """Nothing but finite numbers in any clip."""
    for pose in [character.bind_pose, *(clip.sample(0.4) for clip in character.clips.values())]:
        parts = character.vertices(pose)
        arrays = [
            *pose,
            character.world(pose),
            *(part.positions for part in parts),
            *(part.normals for part in parts if part.normals is not None),
        ]
        assert all(np.isfinite(array).all() for array in arrays)

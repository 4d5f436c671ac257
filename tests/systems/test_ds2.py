"""DS2 inbetweening (RTCA 2.2, Listings 1 and 2): whole meshes with equal vertex counts are blended, forwards
in time.
"""

from pathlib import Path

import numpy as np
import pytest
from statwalk.character.character import Character
from statwalk.services.library.load import load
from statwalk.skin.morph import inbetween
from tiny_model import LIFTED, POSITIONS, document, glb


@pytest.fixture
def face(tmp_path: Path) -> Character:
    """A triangle with a target one metre along z, whose weight goes from 0 to 1 in a second."""
    root, binary = document()
    del root["skins"]
    root["nodes"] = [{"name": "face", "mesh": 0}]
    root["scenes"] = [{"nodes": [0]}]
    root["animations"][0]["channels"] = [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]
    root["animations"][0]["samplers"] = [{"input": 7, "output": 7}]
    (tmp_path / "face.glb").write_bytes(glb(root, binary))
    return load(tmp_path / "face.glb")


@pytest.mark.parametrize("time", [0.0, 0.25, 0.5, 1.0])
def test_the_mesh_goes_from_one_shape_to_the_next(face: Character, time: float) -> None:
    start, end = POSITIONS, POSITIONS + LIFTED
    shown = face.vertices(face.clips["Bend"].sample(time))[0].positions
    assert shown == pytest.approx(start + time * (end - start))


@pytest.mark.parametrize("time", [0.0, 0.25, 1.0])
def test_the_listing_as_corrected_says_the_same(face: Character, time: float) -> None:
    shown = face.vertices(face.clips["Bend"].sample(time))[0].positions
    assert shown == pytest.approx(inbetween(POSITIONS, POSITIONS + LIFTED, time))


def test_without_weight_it_is_the_base(face: Character) -> None:
    pose = face.bind_pose._replace(weights=np.zeros(1, np.float32))
    assert np.array_equal(face.vertices(pose)[0].positions, POSITIONS)

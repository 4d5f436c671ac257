"""DS1 hierarchical rigid parts (RTCA 2.1, FAQ Q20): a mesh per bone, drawn with that bone's matrix, gaps and
all.
"""

from pathlib import Path

import numpy as np
import pytest
from statwalk.character.character import Character
from statwalk.services.library.load import load
from tiny_model import POSITIONS, document, glb


@pytest.fixture
def arm(tmp_path: Path) -> Character:
    """An upper arm and, one metre along x, a forearm: a triangle on each; the forearm turns half round its z
    axis.
    """
    root, binary = document()
    del root["skins"], root["meshes"][0]["weights"], root["meshes"][0]["primitives"][0]["targets"]
    root["nodes"] = [
        {"name": "upper", "mesh": 0, "children": [1]},
        {"name": "fore", "mesh": 0, "translation": [1, 0, 0]},
    ]
    root["scenes"] = [{"nodes": [0]}]
    (tmp_path / "arm.glb").write_bytes(glb(root, binary))
    return load(tmp_path / "arm.glb")


def test_each_part_is_where_its_bone_is(arm: Character) -> None:
    upper, fore = arm.vertices(arm.bind_pose)
    assert np.array_equal(upper.positions, POSITIONS)
    assert np.array_equal(fore.positions, POSITIONS + np.array([1, 0, 0]))


def test_a_part_follows_its_bone_and_leaves_the_others(arm: Character) -> None:
    upper, fore = arm.vertices(arm.clips["Bend"].sample(1.0))
    assert np.array_equal(upper.positions, POSITIONS)
    assert fore.positions == pytest.approx(np.array([1, 0, 0]) - POSITIONS, abs=1e-6)


def test_parts_stay_rigid(arm: Character) -> None:
    for part in arm.vertices(arm.clips["Bend"].sample(0.3)):
        edges = np.linalg.norm(part.positions - np.roll(part.positions, 1, axis=0), axis=1)
        assert edges == pytest.approx([1, 1, np.sqrt(2)])

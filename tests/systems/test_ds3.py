"""DS3 rigid skin (RTCA 2.3.1): one bone for each vertex of one seamless mesh."""

from pathlib import Path

import numpy as np
import pytest
from statwalk.character.character import Character
from statwalk.services.library.load import load
from tiny_model import POSITIONS, document, glb

OWNERS = [0, 1, 1]


@pytest.fixture
def leg(tmp_path: Path) -> Character:
    """The triangle of the small model, each corner on one bone; the knee, one metre up, turns half round
    z.
    """
    root, binary = document()
    start = root["bufferViews"][3]["byteOffset"]
    binary[start : start + 48] = np.eye(4, dtype="<f4")[OWNERS].tobytes()
    del root["meshes"][0]["primitives"][0]["targets"], root["meshes"][0]["weights"]
    (tmp_path / "leg.glb").write_bytes(glb(root, binary))
    return load(tmp_path / "leg.glb")


def test_each_vertex_moves_exactly_with_its_bone(leg: Character) -> None:
    pose = leg.clips["Bend"].sample(1.0)
    world = leg.world(pose)
    expected = [(world[bone] @ [*vertex, 1])[:3] for bone, vertex in zip(OWNERS, POSITIONS, strict=True)]
    assert leg.vertices(pose)[0].positions == pytest.approx(np.array(expected), abs=1e-6)


def test_the_mesh_stays_one_and_stretches_between_its_bones(leg: Character) -> None:
    assert [len(part.positions) for part in leg.vertices(leg.bind_pose)] == [3]
    assert leg.vertices(leg.bind_pose)[0].positions.tolist() == [[0, 0, 0], [1, 1, 0], [0, 2, 0]]

"""DS5 soft skin (RTCA 2.3.2, Listings 4 and 5): v' = Σ wᵢ · Mᵢ · v, Mᵢ = world · inverse bind; weights
normalised and reported.
"""

from pathlib import Path

import numpy as np
import pytest
from paths import GLTF, needs_assets
from statwalk.character.character import Character
from statwalk.services.library.load import load
from tiny_model import JOINTS, LIFTED, POSITIONS, WEIGHTS, document, glb, model


def loaded(folder: Path, data: bytes) -> Character:
    (folder / "leg.glb").write_bytes(data)
    return load(folder / "leg.glb")


def listing_5(character: Character, pose: object, weights: np.ndarray) -> np.ndarray:
    """The listing, vertex by vertex in float64; the inverse bind matrices of the small model are
    identities.
    """
    world = character.world(pose).astype(float)
    rest = POSITIONS + 0.5 * LIFTED
    total = weights.astype(float) / weights.astype(float).sum(axis=1, keepdims=True)
    return np.array(
        [
            sum(w * (world[j] @ [*v, 1])[:3] for j, w in zip(JOINTS[k], total[k], strict=True))
            for k, v in enumerate(rest)
        ]
    )


@pytest.mark.parametrize("time", [0.0, 0.3, 0.5, 1.0])
def test_vertices_follow_all_their_bones(tmp_path: Path, time: float) -> None:
    character = loaded(tmp_path, model())
    pose = character.clips["Bend"].sample(time)
    assert character.vertices(pose)[0].positions == pytest.approx(
        listing_5(character, pose, WEIGHTS), abs=1e-6
    )


def test_weights_that_do_not_sum_to_one_are_normalised_and_reported(tmp_path: Path) -> None:
    root, binary = document()
    start = root["bufferViews"][3]["byteOffset"]
    binary[start : start + 48] = (WEIGHTS * 0.5).astype("<f4").tobytes()
    character = loaded(tmp_path, glb(root, binary))
    pose = character.clips["Bend"].sample(0.6)
    assert character.vertices(pose)[0].positions == pytest.approx(
        listing_5(character, pose, WEIGHTS), abs=1e-6
    )
    assert character.notes == (
        "skin weights did not sum to 1 and were normalised: 3 of 3 vertices of mesh 0",
    )


@needs_assets
@pytest.mark.parametrize("name", ["CesiumMan.glb", "RobotExpressive.glb"])
def test_real_models_with_such_weights_are_reported(name: str) -> None:
    assert any("weights did not sum to 1" in note for note in load(GLTF / name).notes)


def test_a_second_set_of_four_influences_counts(tmp_path: Path) -> None:
    """The same bones once more with other weights: together as if each bone had the sum."""
    root, binary = document()
    second = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 1, 0, 0]], "<f4")
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": 48})
    root["accessors"].append({"bufferView": 9, "componentType": 5126, "count": 3, "type": "VEC4"})
    root["buffers"][0]["byteLength"] += 48
    root["meshes"][0]["primitives"][0]["attributes"] |= {"JOINTS_1": 2, "WEIGHTS_1": 9}
    character = loaded(tmp_path, glb(root, binary + second.tobytes()))
    pose = character.clips["Bend"].sample(0.6)
    assert character.vertices(pose)[0].positions == pytest.approx(
        listing_5(character, pose, WEIGHTS + second), abs=1e-6
    )

"""A stored order that is wrong is left out with a note, whatever is wrong with it: the full skin stays."""

from typing import Any

import pytest
import statwalk
from rig_shapes import human, mesh
from statwalk.character.character import Character
from statwalk.files.gltf import read_model
from tiny_model import glb
from torture.gltf_files import split


@pytest.fixture(scope="module")
def figure() -> Character:
    return statwalk.with_detail(mesh(*human()))


def read(root: Any, binary: bytes) -> Character:
    return read_model(glb(root, binary), "figure")


def check_left_out(character: Character, words: str) -> None:
    """The character is whole, and a note says why it has no order."""
    assert character.levels == ()
    assert character.parts[0].collapses is None
    assert any("level of detail" in note and words in note for note in character.notes), character.notes


@pytest.mark.parametrize(
    ("name", "accessor", "words"),
    [
        ("vertices", 9999, "9999 is not the index"),
        ("onto", "x", "is not the index"),
        ("steps", None, "is not the index"),
        ("steps", 0, "accessor 0 is"),
        ("onto", "vertices", "gone"),
        ("vertices", "steps", ""),
    ],
)
def test_wrong_accessors(figure: Character, name: str, accessor: Any, words: str) -> None:
    root, binary = split(figure.model_glb)
    rows = root["meshes"][0]["primitives"][0]["extras"]["statwalk"]["collapses"]
    rows[name] = rows.get(accessor, accessor)
    check_left_out(read(root, binary), words)


@pytest.mark.parametrize(
    ("levels", "words"),
    [
        ([[1]], "pairs"),
        ([[1, 1e99]], "pairs"),
        ([[1.5, 0.1]], "pairs"),
        ([[True, 0.1]], "pairs"),
        ("all", "pairs"),
        ([[2, 0.1], [1, 0.2]], "more steps"),
        ([[k + 1, 0.1] for k in range(1001)], "at most"),
    ],
)
def test_wrong_levels(figure: Character, levels: Any, words: str) -> None:
    root, binary = split(figure.model_glb)
    root["extras"]["statwalk"]["levels"] = levels
    check_left_out(read(root, binary), words)

"""A checked character comes back from its archive bit for bit; other files are refused."""

from pathlib import Path

import numpy as np
import pytest
import tiny_model
from paths import GLTF, MACHINES, needs_assets
from statwalk.errors import ContentError
from statwalk.files.character_archive import FORMAT, read_character, write_character
from statwalk.files.character_file import load_character_file
from statwalk.files.gltf import read_model
from statwalk.services.library.load import load
from whole_character import difference

SHIPPED = sorted(MACHINES.rglob("*.glb"))
MODELS = ["KayKit_Knight", "AnimatedMorphCube", "CesiumMan", "Khronos_Fox", "RobotExpressive"]


def back(path: Path, folder: Path) -> None:
    """Reads a model, brings it through an archive, and compares poses and vertices bit for bit."""
    character = load_character_file(path)
    write_character(character, folder / "archive")
    read = read_character(folder / "archive", character.model_glb)
    for name, clip in character.clips.items():
        moments = np.linspace(0, clip.duration, 7)
        for ours, theirs in zip(clip.sample(moments), read.clips[name].sample(moments), strict=True):
            np.testing.assert_array_equal(ours, theirs)
    for before, after in zip(
        character.vertices(character.bind_pose), read.vertices(read.bind_pose), strict=True
    ):
        np.testing.assert_array_equal(before.positions, after.positions)
    assert (read.skeleton.names, read.materials, read.notes, read.made) == (
        character.skeleton.names,
        character.materials,
        character.notes,
        character.made,
    )
    assert read.model_glb == character.model_glb


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_shipped_models_come_back(path: Path, tmp_path: Path) -> None:
    back(path, tmp_path)


@needs_assets
@pytest.mark.parametrize("name", MODELS)
def test_real_models_come_back(name: str, tmp_path: Path) -> None:
    back(GLTF / f"{name}.glb", tmp_path)


@pytest.mark.parametrize("name", ["biceps", "car-face", "joints/hinge", "walker-layers"])
def test_bulges_muscles_limits_and_levels_come_back(name: str, tmp_path: Path) -> None:
    """Of the model, which carries them in its extras."""
    authored = load(MACHINES / name).character
    character = read_model(authored.model_glb, "carried")
    write_character(character, tmp_path / "archive")
    assert difference(character, read_character(tmp_path / "archive", b"")) == ""


@pytest.fixture
def archive(tmp_path: Path) -> Path:
    write_character(read_model(tiny_model.model(), "tiny"), tmp_path / "archive")
    return tmp_path / "archive"


@pytest.mark.parametrize("length", [0, 10, 200, -30])
def test_a_cut_archive_is_refused(archive: Path, length: int) -> None:
    archive.write_bytes(archive.read_bytes()[:length])
    with pytest.raises(ContentError):
        read_character(archive, b"")


def test_an_archive_of_another_version_is_refused(archive: Path) -> None:
    tree = np.frombuffer(b'{"format": 0}', np.uint8)
    with archive.open("wb") as opened:
        np.savez(opened, tree=tree)
    with pytest.raises(ContentError, match="another version"):
        read_character(archive, b"")


def test_an_archive_brings_no_objects(archive: Path) -> None:
    tree = b'{"format": %d, "objects": [["Popen", {"args": "true"}]], "root": {"object": 0}}' % FORMAT
    with archive.open("wb") as opened:
        np.savez(opened, tree=np.frombuffer(tree, np.uint8))
    with pytest.raises(ContentError, match="Popen"):
        read_character(archive, b"")


def test_a_missing_archive_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ContentError):
        read_character(tmp_path / "none", b"")

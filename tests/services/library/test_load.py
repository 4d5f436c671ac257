import json

import pytest
from statwalk import load
from statwalk.errors import ContentError
from tiny_model import document, glb


@pytest.fixture
def folder(tmp_path):
    """A .gltf with its buffer in a file of its own, and a file that is no model."""
    root, binary = document()
    root["buffers"][0]["uri"] = "tiny.bin"
    (tmp_path / "tiny.gltf").write_text(json.dumps(root))
    (tmp_path / "tiny.bin").write_bytes(binary)
    (tmp_path / "read me.txt").write_text("a tiny model")
    return tmp_path


def test_a_folder_with_one_model_is_that_model(folder):
    assert load(folder).name == "tiny"


def test_a_folder_with_several_models_names_them(folder):
    (folder / "other.glb").write_bytes(glb(*document()))
    with pytest.raises(
        ContentError, match=r"holds 2 models; name the one that you want: other\.glb, tiny\.gltf"
    ):
        load(folder)


def test_a_folder_without_any_says_what_is_missing(tmp_path):
    with pytest.raises(ContentError, match=r"holds no machine\.yaml, and no \.gltf or \.glb"):
        load(tmp_path)

import json

import captures
import pytest
from statwalk import load
from statwalk.errors import ContentError
from tiny_model import document, glb, robot


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


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ({"position": "add"}, r"x\.glb: position= is an option of \.bvh files: leave it out"),
        ({"scale": 2.0}, r"x\.glb: scale= is an option of \.bvh and \.trc and \.md2 files: leave it out"),
        ({"inbetween": "linear"}, r"x\.glb: inbetween= is an option of \.md2 files: leave it out"),
    ],
)
def test_an_option_that_the_format_does_not_have_is_refused(tmp_path, option, words):
    (tmp_path / "x.glb").write_bytes(robot())
    with pytest.raises(ContentError, match=words):
        load(tmp_path / "x.glb", **option)


def test_an_option_with_a_wrong_value_names_the_right_ones(tmp_path):
    (tmp_path / "walk.bvh").write_text(captures.walk())
    with pytest.raises(ContentError, match=r"position= should be 'replace' or 'add', it is 'sum'"):
        load(tmp_path / "walk.bvh", position="sum")


def test_a_file_of_no_format_lists_the_formats(tmp_path):
    (tmp_path / "walk.fbx").write_bytes(b"Kaydara FBX Binary")
    with pytest.raises(ContentError, match=r"no format has the suffix '\.fbx'; there are: \.glb"):
        load(tmp_path / "walk.fbx")

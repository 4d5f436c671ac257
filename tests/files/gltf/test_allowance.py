"""What names the same data again and again: small files that would take much memory."""

import pytest
from statwalk.errors import ModelError
from statwalk.files.gltf import read_model
from tiny_model import document, glb


def refused_at(change):
    root, binary = document()
    change(root)
    with pytest.raises(ModelError) as caught:
        read_model(glb(root, binary), "tiny")
    return caught.value.place


def blank(root, row, count):
    """An accessor of zeros, which takes no room in the file."""
    entry = root["accessors"][row]
    entry["count"] = count
    for key in ("bufferView", "min", "max"):
        entry.pop(key, None)


def test_zeros_for_indices():
    assert refused_at(lambda root: blank(root, 6, 60_000_000)) == "/meshes/0/primitives/0/indices"


def test_zeros_for_everything():
    assert refused_at(lambda root: blank(root, 6, 4_000_000_000)) == "/accessors/6/count"


def test_bytes_that_become_floats():
    def change(root):
        blank(root, 3, 60_000_000)
        root["accessors"][3] |= {"componentType": 5121, "normalized": True}

    assert refused_at(change) == "/accessors/3/count"


def test_a_mesh_of_zeros():
    def change(root):
        for row in (0, 1, 2, 3, 4):
            blank(root, row, 700_000)

    assert refused_at(change) == "/meshes/0/primitives/0/attributes/POSITION"


def test_one_primitive_very_often():
    def change(root):
        blank(root, 0, 50_000)
        root["meshes"][0] = {"primitives": [{"attributes": {"POSITION": 0}}] * 100}

    assert refused_at(change).startswith("/meshes/0/primitives/")


def test_one_mesh_on_many_nodes():
    def change(root):
        blank(root, 0, 50_000)
        root["meshes"][0] = {"primitives": [{"attributes": {"POSITION": 0}, "mode": 0}]}
        root["nodes"] += [{"mesh": 0}] * 100
        root["scenes"][0]["nodes"] += range(3, 103)

    assert refused_at(change).startswith("/nodes/")


def test_one_sampler_in_many_animations():
    def change(root):
        blank(root, 8, 200_000)
        blank(root, 7, 200_000)
        root["animations"] *= 100

    assert refused_at(change).startswith("/animations/")


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"images": [{"bufferView": 99, "mimeType": "image/png"}]}, "/images/0/bufferView"),
        ({"textures": [{"source": 0}]}, "/textures/0/source"),
        ({"textures": [{"sampler": 0}]}, "/textures/0/sampler"),
        (
            {"textures": [{"extensions": {"EXT_texture_webp": {"source": 3}}}]},
            "/textures/0/extensions/EXT_texture_webp/source",
        ),
        (
            {"materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}]},
            "/materials/0/pbrMetallicRoughness/baseColorTexture/index",
        ),
    ],
)
def test_textures_that_point_nowhere(change, place):
    assert refused_at(lambda root: root.update(change)) == place

"""Compressed models: refused with what to do; Draco's data beside plain data are left out."""

import orjson
import pytest
import tiny_model
from statwalk.errors import ModelError
from statwalk.files.gltf import container, read_model
from statwalk.files.gltf.document import COMPRESSIONS, DRACO


def with_draco(**accessor):
    """The model with Draco's data beside its own; `accessor` replaces the accessor of the positions."""
    root, binary = tiny_model.document()
    root["extensionsUsed"] = ["KHR_mesh_quantization", DRACO]
    root["meshes"][0]["primitives"][0]["extensions"] = {
        DRACO: {"bufferView": 0, "attributes": {"POSITION": 0}}
    }
    if accessor:
        root["accessors"][0] = accessor
    return tiny_model.glb(root, binary)


@pytest.mark.parametrize("extension", COMPRESSIONS)
def test_compressed_models_are_refused_with_what_to_do(extension):
    root, binary = tiny_model.document()
    root["extensionsUsed"] = root["extensionsRequired"] = [extension]
    with pytest.raises(ModelError, match=r"npx @gltf-transform/cli copy model\.glb plain\.glb") as caught:
        read_model(tiny_model.glb(root, binary), "packed")
    assert caught.value.place == "/extensionsRequired/0"


def test_plain_data_beside_draco_are_read():
    character = read_model(with_draco(), "both")
    assert (character.parts[0].positions == tiny_model.POSITIONS).all()
    root = orjson.loads(container.split(character.model_glb)[0])
    assert root["extensionsUsed"] == ["KHR_mesh_quantization"]
    assert "extensions" not in root["meshes"][0]["primitives"][0]


def test_draco_without_plain_data_is_refused_in_place():
    data = with_draco(componentType=5126, count=3, type="VEC3")
    with pytest.raises(ModelError, match="Draco") as caught:
        read_model(data, "packed")
    assert caught.value.place == f"/meshes/0/primitives/0/extensions/{DRACO}"

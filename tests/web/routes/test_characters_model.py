"""What GET /api/characters/{name} says of a model that somebody looks at, against the model's own JSON."""

import json
import struct
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import tiny_model
from paths import GLTF, needs_assets
from uploads import opened, put

pytestmark = pytest.mark.anyio
PNG = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sII", 13, b"IHDR", 3, 2) + bytes(9)


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


def painted() -> bytes:
    """The tiny model with a material that shows its second image twice, and names."""
    root, binary = tiny_model.document()
    root["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(PNG)})
    root["buffers"][0]["byteLength"] = len(binary) + len(PNG)
    image = {"mimeType": "image/png", "bufferView": len(root["bufferViews"]) - 1}
    root["images"] = [image | {"name": "leaf"}, image | {"name": "bark"}]
    root["textures"] = [{}, {"source": 1}]
    sheen = {"KHR_materials_sheen": {"sheenColorTexture": {"index": 1}}}
    colour = {"baseColorTexture": {"index": 1}}
    paint = {"pbrMetallicRoughness": colour, "extensions": sheen, "doubleSided": True, "name": "Paint"}
    root["materials"] = [{"name": "Bare"}, paint]
    root["extensionsUsed"] = ["KHR_materials_sheen"]
    mesh = root["meshes"][0]
    mesh |= {"name": "Sail", "extras": {"targetNames": ["lifted"]}}
    mesh["primitives"][0]["material"] = 1
    return tiny_model.glb(root, binary + PNG)


async def described(client: httpx.AsyncClient, data: bytes) -> dict[str, Any]:
    (await put(client, data=data)).raise_for_status()
    found: dict[str, Any] = (await client.get("/api/characters/tiny")).json()
    return found


async def test_the_parts_of_an_uploaded_model(client: httpx.AsyncClient) -> None:
    found = await described(client, painted())
    assert found["parts"] == [
        {
            "node": 2,
            "mesh": 0,
            "primitive": 0,
            "name": "Sail",
            "vertices": 3,
            "triangles": 1,
            "material": 1,
            "skinned": True,
            "targets": ["lifted"],
        }
    ]
    assert (found["vertices"], found["triangles"]) == (3, 1)


async def test_its_materials_and_textures(client: httpx.AsyncClient) -> None:
    found = await described(client, painted())
    assert [material["name"] for material in found["materials"]] == ["Bare", "Paint"]
    assert found["materials"][1]["textures"] == {"baseColorTexture": 1, "sheenColorTexture": 1}
    assert (found["materials"][1]["alpha"], found["materials"][1]["double_sided"]) == ("OPAQUE", True)
    image = {"type": "image/png", "bytes": len(PNG), "width": 3, "height": 2}
    assert found["textures"] == [{"name": "leaf"} | image, {"name": "bark"} | image]


async def test_a_mesh_without_a_name_has_that_of_its_node(client: httpx.AsyncClient) -> None:
    (part,) = (await described(client, tiny_model.model()))["parts"]
    assert (part["name"], part["material"], part["targets"]) == ("skin", None, ["target_0"])


async def test_a_static_model_can_be_looked_at_too(client: httpx.AsyncClient) -> None:
    root, binary = tiny_model.document()
    del root["skins"], root["animations"], root["nodes"][2]["skin"]
    found = await described(client, tiny_model.glb(root, binary))
    assert (found["clips"], found["skins"], len(found["joints"])) == ([], 0, 3)
    assert [(part["triangles"], part["skinned"]) for part in found["parts"]] == [(1, False)]


@needs_assets
@pytest.mark.parametrize("name", ["CesiumMan", "RobotExpressive"])
async def test_numbers_of_a_real_model(client: httpx.AsyncClient, name: str) -> None:
    data = (GLTF / f"{name}.glb").read_bytes()
    root = json.loads(data[20 : 20 + int.from_bytes(data[12:16], "little")])
    found = await described(client, data)
    meshes = [root["meshes"][node["mesh"]] for node in root["nodes"] if "mesh" in node]
    primitives = [part for mesh in meshes for part in mesh["primitives"]]
    corners = sum(root["accessors"][part["indices"]]["count"] for part in primitives)
    assert (len(found["parts"]), found["triangles"]) == (len(primitives), corners // 3)
    assert [material["name"] for material in found["materials"]] == [
        material["name"] for material in root["materials"]
    ]
    assert len(found["textures"]) == len(root.get("images", []))
    assert sorted(part["material"] for part in found["parts"]) == sorted(
        part["material"] for part in primitives
    )

"""Characters that users bring along: taken, listed, replaced, deleted, and refused with the place of the
fault.
"""

import json
from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
import tiny_model
from paths import ASSETS, needs_assets
from statwalk.services.library import upload_sandbox
from statwalk.web.app import create_app
from statwalk.web.settings import LARGEST_UPLOAD_BYTES, Settings
from uploads import BINARY, files_of, make, opened, put
from zipped import MODEL, packed

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


# --- characters


async def test_a_character_is_taken_and_given_back(client: httpx.AsyncClient) -> None:
    taken = await put(client)
    assert (taken.status_code, taken.headers["Location"]) == (201, "/api/characters/tiny")
    assert (taken.json()["joints"], taken.json()["clips"], taken.json()["skins"]) == (3, 1, 1)
    assert (await client.get(taken.json()["model"])).content == tiny_model.model()
    assert (await client.get("/api/characters/tiny")).json()["clips"] == [{"name": "Bend", "duration": 1.0}]


@pytest.mark.parametrize(
    "data",
    [tiny_model.gltf(), packed(MODEL), packed({"a.glb": tiny_model.model()})],
    ids=["gltf", "zip", "zipped glb"],
)
async def test_other_forms_are_kept_as_a_glb(client: httpx.AsyncClient, data: bytes) -> None:
    assert (await put(client, data=data)).status_code == 201
    assert (await client.get("/api/characters/tiny/model.glb")).content.startswith(b"glTF")


async def test_the_list_shows_what_came_with_the_server_and_what_was_uploaded(
    client: httpx.AsyncClient,
) -> None:
    sha256 = (await put(client)).json()["sha256"]
    assert (await client.get("/api/characters")).json()[-1]["machines"] == []
    await make(client)
    shown = {one["name"]: one for one in (await client.get("/api/characters")).json()}
    assert (shown["walker"]["uploaded"], shown["walker"]["machine"]) == (False, "faq-walker")
    assert (shown["tiny"]["uploaded"], shown["tiny"]["machine"], shown["tiny"]["sha256"]) == (
        True,
        "robot",
        sha256,
    )


async def test_a_character_is_replaced(client: httpx.AsyncClient, tmp_path: Path) -> None:
    first, second = await put(client), await put(client, data=tiny_model.changed("/animations/0/name", "Nod"))
    assert (first.status_code, second.status_code) == (201, 200)
    assert [clip["name"] for clip in (await client.get("/api/characters/tiny")).json()["clips"]] == ["Nod"]
    model = f"characters/{second.json()['sha256']}"
    assert files_of(tmp_path) == [f"{model}.glb", f"{model}.npz", "names/tiny.json"]


async def test_a_character_is_deleted(client: httpx.AsyncClient, tmp_path: Path) -> None:
    await put(client)
    assert (await client.delete("/api/characters/tiny")).status_code == 204
    assert (await client.get("/api/characters/tiny")).status_code == 404
    assert (await client.delete("/api/characters/tiny")).status_code == 404
    assert files_of(tmp_path) == []


async def test_what_came_with_the_server_is_neither_replaced_nor_deleted(client: httpx.AsyncClient) -> None:
    assert (await put(client, "walker")).status_code == 409
    assert (await client.delete("/api/characters/walker")).status_code == 409
    assert (await client.delete("/api/machines/faq-walker")).status_code == 409


@pytest.mark.parametrize("name", ["walker", "faq-walker", "playground"])
async def test_no_upload_and_no_machine_takes_a_shipped_name(client: httpx.AsyncClient, name: str) -> None:
    """The names of a character, a machine and a scene."""
    assert (await put(client, name)).status_code == 409
    await put(client)
    if name != "walker":  # characters and machines are called alike
        assert (await make(client, name)).status_code == 409


async def test_an_upload_may_have_the_name_of_its_machine(client: httpx.AsyncClient) -> None:
    await put(client)
    assert (await make(client, "tiny")).status_code == 201
    assert (await put(client)).status_code == 200


@pytest.mark.parametrize(
    "name", ["..", "a.b", "a b", "-a", "x" * 65, "%2e%2e", "..%5cx", "caf%C3%A9", "a%00", "a%0a"]
)
async def test_names_that_cannot_be_kept(client: httpx.AsyncClient, tmp_path: Path, name: str) -> None:
    assert (await put(client, name)).status_code in (404, 405, 415, 422)
    assert files_of(tmp_path) == []


async def test_without_a_data_folder_nothing_is_taken() -> None:
    transport = httpx.ASGITransport(create_app(Settings(main_stage=False)))
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
        assert (await put(client)).status_code == 409
        assert (await make(client, character="walker")).status_code == 409


# --- refusals


async def test_a_refusal_names_the_place(client: httpx.AsyncClient, tmp_path: Path) -> None:
    refused = await put(client, data=tiny_model.changed("/skins/0/joints", [0, 99]))
    assert (refused.status_code, refused.headers["content-type"]) == (422, "application/problem+json")
    assert refused.json()["errors"][0]["field"].startswith("/skins/0/joints")
    assert files_of(tmp_path) == []


async def test_a_refusal_in_a_zip_names_the_file(client: httpx.AsyncClient) -> None:
    refused = await put(client, data=packed({"robot/robot.gltf": tiny_model.gltf("arm.bin")}))
    assert refused.json()["detail"].startswith("robot/robot.gltf, /buffers/0/uri: ")


@pytest.mark.parametrize(
    "uri", ["../names/x", "/etc/passwd", "file:///etc/passwd", "https://example.com/a.bin"]
)
async def test_a_model_reads_no_other_files(client: httpx.AsyncClient, uri: str) -> None:
    assert (await put(client, data=tiny_model.gltf(uri))).json()["errors"][0]["field"] == "/buffers/0/uri"


async def test_an_empty_body(client: httpx.AsyncClient) -> None:
    assert (await put(client, data=b"")).status_code == 400


@pytest.mark.parametrize("kind", ["text/html", "application/json", "multipart/form-data; boundary=x"])
async def test_a_model_has_a_models_type(client: httpx.AsyncClient, kind: str) -> None:
    assert (await put(client, **{"content-type": kind})).status_code == 415


async def test_only_a_character_may_be_long(client: httpx.AsyncClient) -> None:
    answer = await client.post("/api/stages", content=tiny_model.model(), headers=BINARY)
    assert answer.status_code == 415


async def test_a_body_that_says_it_is_too_long(client: httpx.AsyncClient) -> None:
    assert (await put(client, **{"content-length": str(LARGEST_UPLOAD_BYTES + 1)})).status_code == 413


async def test_a_body_without_a_length_is_cut_off_at_the_limit(
    client: httpx.AsyncClient, tmp_path: Path
) -> None:
    async def endless() -> AsyncIterator[bytes]:
        for _ in range(65):
            yield bytes(1 << 20)

    assert (await put(client, data=endless())).status_code == 413
    assert files_of(tmp_path) == []


async def test_a_child_that_is_out_of_time(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(upload_sandbox, "WALL_SECONDS", 0.001)
    refused = await put(client)
    assert (refused.status_code, refused.json()["detail"]) == (422, "reading it takes longer than 0.001 s")


@needs_assets
@pytest.mark.parametrize("expected", ["reject", "either", "accept", "normalise", "ignore"])
async def test_hostile_files_are_client_errors_at_worst(client: httpx.AsyncClient, expected: str) -> None:
    listed = json.loads((ASSETS / "invalid" / "expectations.json").read_text())["files"]
    for file in [one["file"] for one in listed if one["expect"] == expected][::20]:
        answer = await put(client, "x", (ASSETS / file).read_bytes())
        assert answer.status_code in (200, 201, 400, 422), file
        if expected == "reject":
            assert answer.status_code >= 400, file
            assert answer.json()["errors"][0]["field"], file

"""Meshes that are left out of an upload over REST: they stay away from the machine, and from its files."""

import io
import zipfile
from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
import tiny_model
from statwalk.files.model_facts import mesh_names
from uploads import BINARY, make, names, opened

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


def armed() -> bytes:
    """The tiny model, which holds a sword and a shield, three vertices each."""
    root, binary = tiny_model.document()
    root["meshes"] = [root["meshes"][0] | {"name": name} for name in ("body", "sword", "shield")]
    root["nodes"] += [{"name": "hand.L", "mesh": 1}, {"name": "hand.R", "mesh": 2}]
    root["scenes"][0]["nodes"] += [3, 4]
    return tiny_model.glb(root, binary)


def forget_checked(folder: Path) -> None:
    """Has the next server read the stored models again, as after an update."""
    for checked in folder.glob("characters/*.npz"):
        checked.unlink()


async def put_without(client: httpx.AsyncClient, *meshes: str) -> httpx.Response:
    query = {"without": list(meshes)}
    return await client.put("/api/characters/tiny", params=query, content=armed(), headers=BINARY)


async def test_the_machine_and_its_zip_lack_what_was_left_out(
    client: httpx.AsyncClient, tmp_path: Path
) -> None:
    taken = await put_without(client, "hand.L", "4/0")
    assert (taken.status_code, taken.json()["vertices"]) == (201, 3), taken.text
    assert taken.json()["notes"] == ["left out as wished: hand.L, hand.R"]
    assert (await make(client)).status_code == 201
    forget_checked(tmp_path)
    async with opened(tmp_path) as restarted:
        machine = (await restarted.get("/api/machines/robot")).json()
        shown = (await restarted.get(f"/api/characters/{machine['character']}")).json()
        assert ([part["name"] for part in shown["parts"]], shown["vertices"]) == (["body"], 3)
        answer = await restarted.get("/api/machines/robot/export.zip")
        with zipfile.ZipFile(io.BytesIO(answer.content)) as exported:
            (model,) = [name for name in exported.namelist() if name.endswith(".glb")]
            assert mesh_names(exported.read(model)) == {0: "body"}


@pytest.mark.parametrize(
    ("meshes", "words"),
    [
        (["hand.X"], "There are: skin, hand.L, hand.R, body, sword, shield"),
        (["skin", "hand.L", "hand.R"], "at least one must stay"),
        ([""], "without"),
        (["x" * 201], "without"),
    ],
)
async def test_what_cannot_be_left_out_is_refused(
    client: httpx.AsyncClient, meshes: list[str], words: str
) -> None:
    answer = await put_without(client, *meshes)
    assert (answer.status_code, words in answer.text) == (422, True), answer.text
    assert "tiny" not in await names(client, "characters")


async def test_so_many_meshes_are_left_out_and_no_more(client: httpx.AsyncClient) -> None:
    assert [(await put_without(client, *["hand.L"] * count)).status_code for count in (500, 501)] == [
        201,
        422,
    ]

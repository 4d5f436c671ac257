"""A character in other formats over REST: listed with what they lose, downloaded, uploaded again."""

import io
import zipfile
from collections.abc import AsyncIterator
from pathlib import Path

import httpx
import pytest
from statwalk.files.bvh import read_bvh
from statwalk.files.chunk import read_chunk_file, write_chunk_file
from statwalk.files.zipped import zipped
from uploads import opened, put
from whole_character import difference, whole

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def test_formats_are_listed_with_what_they_cannot_hold(client: httpx.AsyncClient) -> None:
    formats = {row["suffix"]: row for row in (await client.get("/api/characters/walker/formats")).json()}
    assert {".glb", ".gltf", ".zip", ".bvh", ".chunk"} <= formats.keys()
    assert formats[".chunk"]["lost"] == []
    assert formats[".bvh"]["file"] == "/api/characters/walker/model.bvh"
    lost = {loss["part"]: loss for loss in formats[".bvh"]["lost"]}
    assert lost["skins"]["count"] == len(lost["skins"]["names"]) == 1


async def test_a_character_is_downloaded_with_the_clip_that_is_asked_for(client: httpx.AsyncClient) -> None:
    answer = await client.get("/api/characters/walker/model.bvh", params={"clip": "walk"})
    assert (answer.status_code, answer.headers["content-type"]) == (200, "model/bvh")
    assert answer.headers["content-disposition"] == 'attachment; filename="walker.bvh"'
    clips = (await client.get("/api/characters/walker")).json()["clips"]
    (duration,) = [clip["duration"] for clip in clips if clip["name"] == "walk"]
    assert read_bvh(answer.content, "x").clips["x"].duration == pytest.approx(duration)


async def test_an_uploaded_chunk_file_comes_back_to_the_last_bit(client: httpx.AsyncClient) -> None:
    taken = await put(client, data=write_chunk_file(whole()), **{"content-type": "model/x-chunk"})
    assert (taken.status_code, taken.json()["joints"], taken.json()["clips"]) == (201, 3, 2)
    back = await client.get("/api/characters/tiny/model.chunk")
    assert difference(whole(), read_chunk_file(back.content, "tiny")) == ""
    assert (await client.get("/api/characters/tiny/model.glb")).content.startswith(b"glTF")


async def test_the_faqs_text_is_downloaded_and_uploaded_as_a_zip(client: httpx.AsyncClient) -> None:
    """Its first clip, in three texts, moves the bones of the uploaded character."""
    text = await client.get("/api/characters/walker/model.yaml", params={"clip": "walk"})
    assert text.headers["content-type"] == "application/zip"
    assert text.headers["content-disposition"] == 'attachment; filename="walker.zip"'
    taken = await put(client, data=text.content)
    assert (taken.status_code, taken.json()["clips"]) == (
        201,
        len((await client.get("/api/characters/walker")).json()["clips"]),
    )
    names = zipfile.ZipFile(io.BytesIO(text.content)).namelist()
    assert names[:2] == ["walker.yaml", "walker.skeleton.txt"]
    back = await client.get("/api/characters/tiny/model.bvh", params={"clip": "walk"})
    assert "Left.upperleg" in read_bvh(back.content, "x").skeleton.names


async def test_a_fault_in_a_text_of_a_zip_is_named_with_file_and_line(client: httpx.AsyncClient) -> None:
    files = {"leg/leg.yaml": b"skeleton: leg.txt\n", "leg/leg.txt": b"Root --- - - - -\nShin Hip 4 0 -1 0\n"}
    refused = await put(client, data=zipped(files))
    assert refused.status_code == 422
    assert "leg/leg.txt" in refused.json()["detail"]
    assert refused.json()["errors"][0]["field"].endswith("line 2")


async def test_a_broken_chunk_file_is_refused_with_the_byte(client: httpx.AsyncClient) -> None:
    refused = await put(client, data=write_chunk_file(whole())[:-40])
    assert refused.status_code == 422
    assert refused.json()["errors"][0]["field"] == "byte 12"


async def test_unknown_formats_and_clips_are_refused(client: httpx.AsyncClient) -> None:
    unknown = await client.get("/api/characters/walker/model.fbx")
    assert (unknown.status_code, ".bvh" in unknown.json()["known"]) == (404, True)
    assert (await client.get("/api/characters/walker/model.trc")).status_code == 404
    assert (await client.get("/api/characters/walker/model.bvh?clip=fly-away")).status_code in (404, 422)
    assert (await client.get("/api/characters/nobody/model.bvh")).status_code == 404

"""Machines made of nothing, copied, renamed, packed and unpacked: each plays at once, and outlives the
server.
"""

import io
import zipfile
from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import captures
import httpx
import numpy as np
import pytest
from statwalk.files.machine_yaml import capture_lines
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage
from uploads import make, names, opened, put

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def new(client: httpx.AsyncClient, **members: Any) -> httpx.Response:
    return await client.post("/api/machines", json=members)


async def shown(client: httpx.AsyncClient, machine: str, ticks: int = 30) -> dict[str, Any]:
    """The pose of an actor that plays a machine, and the stage's hash."""
    stage = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": machine}]})
    path = stage.headers["Location"]
    stepped = (await client.post(f"{path}/step", json={"ticks": ticks})).json()
    pose = (await client.get(f"{path}/actors/{stage.json()['actors'][0]['id']}/pose")).json()
    await client.delete(path)
    return {"hash": stepped["hash"], "world": pose["world"], "state": pose["state"]}


async def test_from_nothing_it_plays_at_once(client: httpx.AsyncClient) -> None:
    made = await new(client, name="mine")
    assert (made.status_code, [state["name"] for state in made.json()["states"]]) == (201, ["STAT"])
    assert (await shown(client, "mine"))["state"] == "STAT"


async def test_a_character_with_one_state(client: httpx.AsyncClient) -> None:
    made = await new(client, name="mine", character="walker", empty=True)
    assert [(state["name"], state["motion"]) for state in made.json()["states"]] == [("STAND", "stand")]


def cells(table: dict[str, dict[str, Any]]) -> dict[str, Any]:
    """A table without the lines in which its cells stand: a copy has no line for a title."""
    return {
        state: {event: {**cell, "line": None} for event, cell in row.items()} for state, row in table.items()
    }


@pytest.mark.parametrize("machine", ["faq-walker", "playground.door", "walker-layers", "biceps"])
async def test_a_copy_does_what_its_origin_does(client: httpx.AsyncClient, machine: str) -> None:
    made = await new(client, name="mine", copy_of=machine)
    assert made.status_code == 201, made.text
    origin = (await client.get(f"/api/machines/{machine}")).json()
    assert cells(made.json()["table"]) == cells(origin["table"])
    assert (await shown(client, "mine"))["state"] == (await shown(client, machine))["state"]


async def test_a_machine_that_is_made_is_called_by_its_name(client: httpx.AsyncClient) -> None:
    """Also after it was renamed."""
    copied = await new(client, name="mine", copy_of="faq-walker")
    await new(client, name="fresh")
    renamed = await client.post("/api/machines/fresh/rename", json={"to": "ripe"})
    assert [made.json()["title"] for made in (copied, renamed)] == ["mine", "ripe"]


async def test_a_copy_of_a_model_poses_bit_for_bit_like_its_origin(client: httpx.AsyncClient) -> None:
    await new(client, name="mine", copy_of="faq-walker")
    assert (await shown(client, "mine"))["world"] == (await shown(client, "faq-walker"))["world"]


async def test_a_copy_of_an_edited_machine_has_the_edit(client: httpx.AsyncClient) -> None:
    operation = {"kind": "rename_state", "state": "WALK", "to": "STROLL"}
    await client.patch(
        "/api/machines/faq-walker", json={"operations": [operation]}, headers={"If-Match": "1"}
    )
    made = await new(client, name="mine", copy_of="faq-walker")
    assert "STROLL" in made.json()["table"]


async def test_a_copy_outlives_the_server_and_is_edited(client: httpx.AsyncClient, tmp_path: Path) -> None:
    await new(client, name="mine", copy_of="biceps")
    before = await shown(client, "mine")
    async with opened(tmp_path) as later:
        assert await shown(later, "mine") == before
        operation = {"kind": "add_state", "state": "MORE"}
        edited = await later.patch(
            "/api/machines/mine", json={"operations": [operation]}, headers={"If-Match": "1"}
        )
        assert (edited.status_code, edited.json()["saved"]) == (200, "file")


async def test_a_machine_can_go_once_its_stage_is_gone(client: httpx.AsyncClient) -> None:
    await new(client, name="mine")
    stage = (await client.post("/api/stages", json={"actors": [{"machine": "mine"}]})).json()["id"]
    played = await client.get("/api/machines/mine/unused")
    assert (played.status_code, stage in played.text) == (409, True)
    assert (await client.get(f"/api/machines/mine/unused?besides={stage}")).status_code == 204
    assert (await client.get("/api/machines/elbow/unused")).status_code == 409


async def test_a_renamed_machine_keeps_its_versions(client: httpx.AsyncClient, tmp_path: Path) -> None:
    await new(client, name="mine")
    operation = {"kind": "add_state", "state": "MORE"}
    await client.patch("/api/machines/mine", json={"operations": [operation]}, headers={"If-Match": "1"})
    renamed = await client.post("/api/machines/mine/rename", json={"to": "yours"})
    assert (renamed.status_code, renamed.json()["version"]) == (200, 2)
    async with opened(tmp_path) as later:
        assert {"mine", "yours"} & set(await names(later, "machines")) == {"yours"}
    assert len((await client.get("/api/machines/yours/versions")).json()) == 2


@pytest.mark.parametrize("to", ["faq-walker", "../x", "playground", "a/b", ""])
async def test_a_name_that_is_taken_or_unsafe(client: httpx.AsyncClient, to: str) -> None:
    await new(client, name="mine")
    assert (await client.post("/api/machines/mine/rename", json={"to": to})).status_code in (409, 422)
    assert (await new(client, name=to)).status_code in (409, 422)


async def test_a_shipped_machine_keeps_its_name(client: httpx.AsyncClient) -> None:
    assert (await client.post("/api/machines/elbow/rename", json={"to": "x"})).status_code == 409


@pytest.mark.parametrize("machine", ["faq-walker", "faq-printed", "street.walker"])
async def test_the_unpacked_folder_is_a_machine(
    client: httpx.AsyncClient, tmp_path: Path, machine: str
) -> None:
    packed = await client.get(f"/api/machines/{machine}/export.zip")
    with zipfile.ZipFile(io.BytesIO(packed.content)) as archive:
        archive.extractall(tmp_path / "unpacked")
        assert archive.namelist() == ["machine.yaml", "character.glb"]
    role = load(tmp_path / "unpacked")
    assert list(role.machine.states) == list(load(machine).machine.states)


async def test_what_was_packed_is_unpacked(client: httpx.AsyncClient) -> None:
    packed = await client.get("/api/machines/faq-walker/export.zip")
    made = await unpacked(client, packed.content)
    assert made.status_code == 201, made.text
    assert (await shown(client, "mine"))["world"] == (await shown(client, "faq-walker"))["world"]
    again = await client.get("/api/machines/mine/export.zip")
    assert again.content == packed.content


async def test_a_machine_of_a_made_one_with_a_large_table(client: httpx.AsyncClient) -> None:
    await put(client)
    await make(client)
    table = "state,STOP,END\nBEND,BEND,\n"
    text = (await client.get("/api/machines/robot")).json()["text"]
    start = text.index("table:")
    text = text[:start] + "table: big.csv\n"
    put_text = await client.put(
        "/api/machines/robot", json={"text": text, "tables": {"big.csv": table}}, headers={"If-Match": "1"}
    )
    assert put_text.status_code == 200, put_text.text
    made = await unpacked(client, (await client.get("/api/machines/robot/export.zip")).content)
    assert made.json()["tables"] == {"big.csv": table}


async def test_another_content_type_is_refused_with_the_right_ones(client: httpx.AsyncClient) -> None:
    headers = {"Content-Type": "model/gltf-binary"}
    answer = await client.put("/api/machines/mine/import.zip", content=b"glTF", headers=headers)
    assert answer.status_code == 415
    assert answer.json()["detail"].startswith("the Content-Type must be application/zip or")


async def unpacked(client: httpx.AsyncClient, content: bytes, name: str = "mine") -> httpx.Response:
    headers = {"Content-Type": "application/zip"}
    return await client.put(f"/api/machines/{name}/import.zip", content=content, headers=headers)


def zipped(**files: str | bytes) -> bytes:
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        for name, data in files.items():
            archive.writestr(name.replace("__", "."), data)
    return packed.getvalue()


TAKE = "takes/one/walk.bvh"
CAPTURED = """character: faq-walker
root: Root
captures: {stroll: {file: takes/one/walk.bvh}}
initial: A
states: {A: {motion: stroll, loop: true}}
table: |
  state | GO
  A     | A
"""


async def test_captures_come_along_and_only_a_child_reads_them(
    client: httpx.AsyncClient, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "captured"
    (folder / "takes" / "one").mkdir(parents=True)
    (folder / "machine.yaml").write_text(CAPTURED)
    (folder / TAKE).write_text(captures.walk())
    stage = Stage()
    actor = stage.add(load(folder))
    stage.step(30)
    monkeypatch.setattr(capture_lines, "load_capture", None)  # the child has its own
    made = await unpacked(client, zipped(**{"machine__yaml": CAPTURED, TAKE: captures.walk()}))
    assert made.status_code == 201, made.text
    world = (await shown(client, "mine"))["world"]
    np.testing.assert_allclose(world, actor.world, atol=1e-6)
    packed = (await client.get("/api/machines/mine/export.zip")).content
    assert (await unpacked(client, packed, "yours")).status_code == 201
    assert (await shown(client, "yours"))["world"] == world
    async with opened(tmp_path) as later:
        assert (await shown(later, "yours"))["world"] == world


async def test_a_capture_that_a_zip_does_not_hold_is_named(client: httpx.AsyncClient) -> None:
    refused = await unpacked(client, zipped(machine__yaml=CAPTURED))
    assert (refused.status_code, "line 3: capture stroll" in refused.text) == (422, True), refused.text


TABLE = "|\n  state | GO\n  A | A"
MACHINE = (
    f"character: {{}}\ninitial: A\nstates: {{{{A: {{{{motion: stand, loop: true}}}}}}}}\ntable: {TABLE}\n"
)


async def test_a_zip_may_name_a_shipped_character(client: httpx.AsyncClient) -> None:
    made = await unpacked(client, zipped(machine__yaml=MACHINE.format("faq-walker")))
    assert (made.status_code, made.json()["states"][0]["motion"]) == (201, "stand")


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"PK no zip", "cut short"),
        (zipped(readme__txt="x"), "the zip holds no machine.yaml"),
        (zipped(machine__yaml=MACHINE.format("robot.glb")), "the zip holds no robot.glb"),
        (zipped(machine__yaml=MACHINE.format("/etc/passwd.glb")), "the zip holds no passwd.glb"),
        (zipped(machine__yaml=MACHINE.format("faq-walker").replace("stand", "stnd")), "did you mean stand"),
        (zipped(machine__yaml="a: &b 1"), "line 1"),
        (zipped(machine__yaml=b"\xff"), "not UTF-8"),
        (
            zipped(machine__yaml=MACHINE.format("faq-walker").replace("|\n  state | GO\n  A | A", "x.csv")),
            "x.csv",
        ),
    ],
)
async def test_refused(client: httpx.AsyncClient, tmp_path: Path, content: bytes, words: str) -> None:
    refused = await unpacked(client, content)
    assert (refused.status_code, words in refused.text) == (422, True), refused.text
    assert str(tmp_path) not in refused.text
    assert "mine" not in await names(client, "machines")

"""Machines made of uploaded characters: kept, protected, and refused."""

from collections.abc import AsyncIterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import tiny_model
from statwalk.files import model_formats
from uploads import files_of, make, names, opened, put

pytestmark = pytest.mark.anyio


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    async with opened(tmp_path) as client:
        yield client


async def test_a_machine_is_made_on_the_spot(client: httpx.AsyncClient) -> None:
    await put(client)
    made = await make(client)
    assert (made.status_code, made.headers["Location"]) == (201, "/api/machines/robot")
    state = {"name": "BEND", "motion": "Bend", "loop": True, "duration": 1.0}
    assert [one | state for one in made.json()["states"]] == made.json()["states"]
    assert len(made.json()["states"]) == 1
    assert "robot" in await names(client, "machines")
    stage = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "robot"}]})
    assert stage.json()["actors"][0]["state"] == "BEND"


async def test_it_outlives_the_server(client: httpx.AsyncClient, tmp_path: Path) -> None:
    await put(client)
    table = (await make(client)).json()["table"]
    async with opened(tmp_path) as later:
        assert (await later.get("/api/machines/robot")).json()["table"] == table
        assert (await later.get("/api/characters/tiny/model.glb")).content == tiny_model.model()


async def test_it_keeps_the_character_it_was_made_of(client: httpx.AsyncClient) -> None:
    await put(client)
    character = (await make(client)).json()["character"]
    await put(client, data=tiny_model.changed("/animations/0/name", "Nod"))
    assert (await client.get(f"/api/characters/{character}/model.glb")).content == tiny_model.model()
    assert (await client.get("/api/machines/robot")).json()["states"][0]["motion"] == "Bend"


async def test_a_character_that_a_machine_is_made_of_stays(client: httpx.AsyncClient, tmp_path: Path) -> None:
    await put(client)
    await make(client)
    refused = await client.delete("/api/characters/tiny")
    assert (refused.status_code, refused.json()["known"]) == (409, ["robot"])
    assert (await client.delete("/api/machines/robot")).status_code == 204
    assert (await client.delete("/api/characters/tiny")).status_code == 204
    assert files_of(tmp_path) == []


async def test_a_machine_on_a_stage_stays(client: httpx.AsyncClient) -> None:
    await put(client)
    await make(client)
    stage = (
        await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "robot"}]})
    ).headers["Location"]
    await client.delete(f"{stage}/actors/0")
    assert (await client.delete("/api/machines/robot")).status_code == 409  # it is in the stage's past
    await client.delete(stage)
    assert (await client.delete("/api/machines/robot")).status_code == 204
    assert "robot" not in await names(client, "machines")


async def test_a_machine_is_never_written_over(client: httpx.AsyncClient) -> None:
    await put(client)
    await make(client)
    assert (await make(client)).status_code == 409
    assert (await make(client, "faq-walker")).status_code == 409


async def test_a_mapping_is_proposed_changed_and_posted_back(client: httpx.AsyncClient) -> None:
    await put(client)
    proposal = (await client.get("/api/characters/tiny/mapping")).json()
    assert (proposal["mapping"], proposal["meanings"]["STAT"]) == ({"Bend": "BEND"}, "stands about")
    made = await make(client, mapping={"Bend": "STAT"})
    assert [state["name"] for state in made.json()["states"]] == ["STAT"]


BAD_MAPPINGS = [
    {"Nod": "STAT"},
    {"Bend": "a b"},
    {"Bend": "$"},
    {"Bend": None},
    {},
    {"Bend": 1},
    {"Bend": "x" * 100},
    ["Bend"],
]


@pytest.mark.parametrize("mapping", BAD_MAPPINGS, ids=str)
async def test_mappings_that_cannot_be(client: httpx.AsyncClient, mapping: Any) -> None:
    await put(client)
    assert (await make(client, mapping=mapping)).status_code == 422
    assert "robot" not in await names(client, "machines")


async def test_two_clips_of_one_state(client: httpx.AsyncClient) -> None:
    root, binary = tiny_model.document()
    root["animations"].append(root["animations"][0] | {"name": "Nod"})
    await put(client, data=tiny_model.glb(root, binary))
    refused = await make(client, mapping={"Bend": "STAT", "Nod": "STAT"})
    assert refused.json()["errors"][0]["field"] == "mapping.Nod"


@pytest.mark.parametrize("mapping", [None, {}], ids=["proposed", "empty"])
async def test_a_character_without_clips_gets_its_pose_at_rest(
    client: httpx.AsyncClient, mapping: dict[str, str] | None
) -> None:
    await put(client, data=tiny_model.changed("/animations", None))
    made = await make(client, **({} if mapping is None else {"mapping": mapping}))
    assert made.status_code == 201
    assert [state["name"] for state in made.json()["states"]] == ["STAT"]


async def test_a_character_without_clips_has_no_other_state(
    client: httpx.AsyncClient, tmp_path: Path
) -> None:
    await put(client, data=tiny_model.changed("/animations", None))
    assert (await make(client, mapping={"Bend": "STAT"})).status_code == 422
    assert all(file.startswith(("characters/", "names/")) for file in files_of(tmp_path))


async def test_unknown_characters_are_listed(client: httpx.AsyncClient) -> None:
    refused = await make(client, character="nobody")
    assert (refused.status_code, "walker" in refused.json()["known"]) == (422, True)


async def test_a_machine_of_the_data_folder_that_is_damaged_is_left_out(
    client: httpx.AsyncClient, tmp_path: Path
) -> None:
    await put(client)
    await make(client)
    (tmp_path / "machines" / "robot" / "machine.yaml").write_text("states: [")
    async with opened(tmp_path) as later:
        assert "robot" not in await names(later, "machines")
        assert "tiny" in await names(later, "characters")


async def test_the_server_never_reads_an_upload_itself(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The child process has read it; the server's own reader is broken here, and everything works."""
    monkeypatch.setattr(model_formats, "FORMATS", ())
    await put(client)
    assert (await make(client)).status_code == 201
    assert (await client.get("/api/characters/tiny")).json()["clips"][0]["name"] == "Bend"
    model = (await client.get("/api/characters/tiny/model.glb")).content
    assert model == tiny_model.model()
    opened_stage = await client.post("/api/stages", json={"actors": [{"machine": "robot"}]})
    assert opened_stage.status_code == 201

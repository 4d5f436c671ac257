"""Back and forth through the versions of a machine, and what differs between them."""

from typing import Any

import httpx
import pytest
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
WALKER = "/api/machines/faq-walker"


@pytest.fixture
def app() -> Any:
    """Not shared: machines are changed here."""
    return create_app(Settings(main_stage=False))


async def operate(client: httpx.AsyncClient, version: int, *operations: dict[str, Any]) -> httpx.Response:
    return await client.patch(WALKER, json={"operations": operations}, headers={"If-Match": f'"{version}"'})


def cell(state: str, event: str, text: str) -> dict[str, Any]:
    return {"kind": "set_cell", "state": state, "event": event, "text": text}


async def post(client: httpx.AsyncClient, path: str, version: int) -> httpx.Response:
    return await client.post(f"{WALKER}{path}", headers={"If-Match": str(version)})


async def test_several_operations_are_one_version(client: httpx.AsyncClient) -> None:
    run = {"kind": "add_state", "state": "RUN", "fields": {"motion": "walk"}}
    made = await operate(client, 1, run, cell("WALK", "JUMP", "RUN"))
    assert (made.json()["version"], made.json()["undo"], made.json()["redo"]) == (2, 1, 0)
    assert made.json()["table"]["WALK"]["JUMP"]["to"] == "RUN"


async def test_the_foot_lock_is_shown_as_it_is_set(client: httpx.AsyncClient) -> None:
    assert (await client.get(WALKER)).json()["foot_lock"] == 1
    made = await operate(client, 1, {"kind": "set_machine", "fields": {"foot_lock": 0.5}})
    assert made.json()["foot_lock"] == 0.5
    made = await operate(client, 2, {"kind": "set_machine", "fields": {"foot_lock": None}})
    assert made.json()["foot_lock"] == 0


async def test_the_second_is_refused_and_the_first_is_not_made(client: httpx.AsyncClient) -> None:
    refused = await operate(client, 1, {"kind": "add_state", "state": "RUN"}, cell("WALK", "JMUP", "RUN"))
    assert (refused.status_code, "did you mean JUMP" in refused.json()["detail"]) == (422, True)
    assert (await client.get(WALKER)).json()["version"] == 1


async def test_undo_and_redo(client: httpx.AsyncClient) -> None:
    await operate(client, 1, cell("WALK", "LEFT", "TRGT"))
    undone = (await post(client, "/undo", 2)).json()
    assert (undone["table"]["WALK"]["LEFT"]["to"], undone["undo"], undone["redo"]) == ("TLFT", 0, 2)
    redone = (await post(client, "/redo", 3)).json()
    assert (redone["table"]["WALK"]["LEFT"]["to"], redone["undo"], redone["redo"]) == ("TRGT", 1, 0)
    statuses = [(await post(client, path, 4)).status_code for path in ("/redo", "/undo", "/undo")]
    assert statuses == [409, 200, 412]


async def test_an_edit_ends_the_redo(client: httpx.AsyncClient) -> None:
    await operate(client, 1, cell("WALK", "LEFT", "TRGT"))
    await post(client, "/undo", 2)
    await operate(client, 3, cell("WALK", "RIGHT", "TLFT"))
    assert (await post(client, "/redo", 4)).status_code == 409


async def test_a_version_with_its_text(client: httpx.AsyncClient) -> None:
    first = (await client.get(WALKER)).json()["text"]
    await operate(client, 1, cell("WALK", "LEFT", "TRGT"))
    version = (await client.get(f"{WALKER}/versions/1")).json()
    assert (version["version"], version["text"], version["tables"]) == (1, first, {})
    assert (await client.get(f"{WALKER}/versions/3")).status_code == 404
    assert (await client.get(f"{WALKER}/versions/x")).status_code == 422


async def test_differences(client: httpx.AsyncClient) -> None:
    rename = {"kind": "rename_state", "state": "WALK", "to": "STROLL"}
    title = {"kind": "set_machine", "fields": {"title": "x"}}
    await operate(client, 1, rename, cell("STROLL", "LEFT", "TRGT"), title)
    answer = (await client.get(f"{WALKER}/versions/2/differences", params={"since": 1})).json()
    fields = "{enter: match, blend: 0.25}"
    assert answer == {
        "version": 2,
        "since": 1,
        "names": [{"kind": "state", "layer": "base", "before": "WALK", "after": "STROLL"}],
        "cells": [
            {
                "layer": "base",
                "state": "STROLL",
                "event": "LEFT",
                "before": f"TLFT {fields}",
                "after": f"TRGT {fields}",
            }
        ],
        "parts": [{"part": ["machine", "title"], "before": "The FAQ's walker", "after": "x"}],
    }


async def test_restore(client: httpx.AsyncClient) -> None:
    await operate(client, 1, cell("WALK", "LEFT", "TRGT"))
    await operate(client, 2, cell("WALK", "LEFT", "STAT"))
    restored = (await post(client, "/versions/1/restore", 3)).json()
    assert (restored["version"], restored["table"]["WALK"]["LEFT"]["to"]) == (4, "TLFT")
    assert (await post(client, "/versions/1/restore", 1)).status_code == 412


async def test_a_refusal_names_the_cells_that_lead_there(client: httpx.AsyncClient) -> None:
    refused = await operate(client, 1, {"kind": "delete_state", "state": "CRCH"})
    places = [(finding["state"], finding["event"]) for finding in refused.json()["findings"]]
    assert (refused.status_code, places[:2]) == (422, [("STAT", "CROUCH"), ("LAND", "END")])


async def test_places_in_the_graph_leave_every_bit(client: httpx.AsyncClient) -> None:
    async def played(*operations: dict[str, Any]) -> str:
        actors = [{"machine": "faq-walker"}]
        made = await client.post("/api/stages", json={"clock": "manual", "actors": actors})
        path = made.headers["Location"]
        await client.post(f"{path}/events", json={"event": "FORWARD"})
        await client.post(f"{path}/step", json={"ticks": 100})
        if operations:
            assert (await operate(client, 1, *operations)).status_code == 200
        return str((await client.post(f"{path}/step", json={"ticks": 100})).json()["hash"])

    plain = await played()
    assert await played({"kind": "set_view", "positions": {"WALK": [10, 20]}}) == plain
    assert (await client.get(WALKER)).json()["view"] == {"base": {"WALK": [10, 20]}}

"""Tables changed while they are played: verified first, in force at once, undone."""

import threading
from pathlib import Path
from shutil import copytree
from typing import Any

import httpx
import pytest
from paths import MACHINES
from starlette.types import Receive, Scope, Send
from statwalk.web.app import create_app
from statwalk.web.dependencies import ENDING
from statwalk.web.same_origin import OwnNames
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
WALKER = "/api/machines/faq-walker"


OTHER = "character: other.glb\ninitial: A\nstates: {A: {motion: walk}}\ntable: |\n  state | GO\n"


@pytest.fixture
def app() -> Any:
    """Not shared: machines are changed here."""
    return create_app(Settings(main_stage=False))


async def patch(
    client: httpx.AsyncClient, state: str, event: str, text: str, version: int = 1, dry: bool = False
) -> httpx.Response:
    body = {"state": state, "event": event, "text": text}
    return await client.patch(
        f"{WALKER}/cells", json=body, headers={"If-Match": f'"{version}"'}, params={"dry": dry}
    )


async def walking(client: httpx.AsyncClient) -> str:
    """A stage with a walker on its way."""
    made = await client.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]})
    path = f"/api/stages/{made.json()['id']}"
    await client.post(f"{path}/events", json={"event": "FORWARD"})
    await client.post(f"{path}/step", json={"ticks": 120})
    return path


async def state_after(client: httpx.AsyncClient, path: str, event: str) -> str:
    await client.post(f"{path}/events", json={"event": event})
    answer = await client.post(f"{path}/step", json={"ticks": 2})
    return str(answer.json()["actors"][0]["state"])


async def test_a_changed_cell_counts_at_once(client: httpx.AsyncClient) -> None:
    path = await walking(client)
    await patch(client, "WALK", "LEFT", "TRGT")
    assert await state_after(client, path, "LEFT") == "TRGT"


async def test_the_actor_walks_on(client: httpx.AsyncClient) -> None:
    path = await walking(client)
    await patch(client, "WALK", "LEFT", "TRGT")
    assert (await client.get(path)).json()["actors"][0]["state"] == "WALK"


async def test_undo(client: httpx.AsyncClient) -> None:
    path = await walking(client)
    await patch(client, "WALK", "LEFT", "TRGT")
    await client.post(f"{WALKER}/undo", headers={"If-Match": '"2"'})
    assert await state_after(client, path, "LEFT") == "TLFT"


async def test_undone_twice_goes_back_twice(client: httpx.AsyncClient) -> None:
    before = (await client.get(WALKER)).json()["text"]
    await patch(client, "WALK", "LEFT", "TRGT")
    await patch(client, "WALK", "RIGHT", "TLFT", 2)
    await client.post(f"{WALKER}/undo", headers={"If-Match": "3"})
    answer = await client.post(f"{WALKER}/undo", headers={"If-Match": "4"})
    assert (answer.json()["text"], answer.json()["version"]) == (before, 5)
    assert (await client.post(f"{WALKER}/undo", headers={"If-Match": "5"})).status_code == 409


async def test_a_table_that_is_refused_changes_nothing(client: httpx.AsyncClient) -> None:
    answer = await patch(client, "WALK", "LEFT", "TLFTT")
    found = answer.json()["findings"]
    assert (answer.status_code, found[0]["kind"]) == (422, "undefined state")
    assert "did you mean TLFT" in found[0]["message"]
    assert (await client.get(WALKER)).json()["version"] == 1


async def test_a_property_that_no_longer_holds_refuses_it(client: httpx.AsyncClient) -> None:
    answer = await patch(client, "STAT", "JUMP", "JUMP")
    assert "JUMP only after WALK" in answer.json()["findings"][0]["message"]


async def test_one_of_several_errors_can_be_mended(client: httpx.AsyncClient) -> None:
    """TLFG stands in another cell, too, so the same errors are left."""
    body = {"state": "STAT", "event": "LEFT", "text": "TLFT"}
    before = (await client.get("/api/machines/faq-printed/verify")).json()
    mended = await client.patch("/api/machines/faq-printed/cells", json=body, headers={"If-Match": '"1"'})
    assert (
        _errors(mended.json())
        == _errors(before)
        == [("undefined state", "TLFG"), ("undefined state", "TRGY")]
    )
    assert mended.json()["findings"][0]["message"] != before["findings"][0]["message"]


def _errors(answer: dict[str, Any]) -> list[tuple[str, str]]:
    """Kind and subject of each error that an answer lists."""
    return [(one["kind"], one["subject"]) for one in answer["findings"] if one["severity"] == "error"]


async def test_a_dry_run_only_says(client: httpx.AsyncClient) -> None:
    answer = await patch(client, "WALK", "LEFT", "TRGT", dry=True)
    assert answer.json()["table"]["WALK"]["LEFT"]["to"] == "TRGT"
    assert (await client.get(WALKER)).json()["table"]["WALK"]["LEFT"]["to"] == "TLFT"


@pytest.mark.parametrize(
    ("text", "words"), [("TLFTT", "did you mean TLFT"), ("TLFT | TRGT", "no cell of a table")]
)
async def test_a_dry_run_answers_with_its_refusal(client: httpx.AsyncClient, text: str, words: str) -> None:
    answer, edit = (
        await patch(client, "WALK", "LEFT", text, dry=True),
        await patch(client, "WALK", "LEFT", text),
    )
    trial, problem = answer.json(), edit.json()
    assert (answer.status_code, trial.pop("result"), edit.status_code) == (200, "refused", 422)
    assert trial == {name: problem.get(name, []) for name in ("detail", "errors", "findings")}
    assert words in trial["detail"]


async def test_a_dry_run_of_a_whole_text_answers_with_its_refusal(client: httpx.AsyncClient) -> None:
    answer = await client.put(
        WALKER, json={"text": "- a list"}, headers={"If-Match": "1"}, params={"dry": True}
    )
    assert (answer.status_code, answer.json()["result"]) == (200, "refused")
    assert answer.json()["errors"][0]["field"] == "line 1"


async def test_two_editors_are_kept_apart(client: httpx.AsyncClient) -> None:
    await patch(client, "WALK", "LEFT", "TRGT")
    late = await patch(client, "WALK", "LEFT", "STAT")
    assert (late.status_code, "version 2 (WALK/LEFT: TRGT)" in late.json()["detail"]) == (412, True)


async def test_two_editors_of_two_cells_lose_nothing(client: httpx.AsyncClient) -> None:
    await patch(client, "WALK", "LEFT", "TRGT")
    table = (await patch(client, "WALK", "RIGHT", "TLFT")).json()["table"]["WALK"]
    assert (table["LEFT"]["to"], table["RIGHT"]["to"]) == ("TRGT", "TLFT")


async def test_a_whole_text_for_an_older_version_is_refused(client: httpx.AsyncClient) -> None:
    text = (await client.get(WALKER)).json()["text"]
    await patch(client, "WALK", "LEFT", "TRGT")
    late = await client.put(WALKER, json={"text": f"{text}# mine\n"}, headers={"If-Match": "1"})
    assert late.status_code == 412


@pytest.mark.parametrize(
    ("header", "status"), [({}, 428), ({"If-Match": "W/x"}, 422), ({"If-Match": "9" * 50}, 422)]
)
async def test_the_version_is_asked_for(
    client: httpx.AsyncClient, header: dict[str, str], status: int
) -> None:
    assert (await client.put(WALKER, json={"text": "x"}, headers=header)).status_code == status


@pytest.mark.parametrize(
    ("text", "place"), [("- a list", "line 1"), ("a: &b 1", "line 1"), (OTHER, "character")]
)
async def test_a_text_that_is_no_machine_says_where(client: httpx.AsyncClient, text: str, place: str) -> None:
    answer = await client.put(WALKER, json={"text": text}, headers={"If-Match": "1"})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, place)
    assert str(MACHINES) not in answer.text  # where the file lies on the server is nobody's business


async def test_the_same_text_leaves_every_bit(client: httpx.AsyncClient) -> None:
    edited = await walking(client)
    text = (await client.get(WALKER)).json()["text"]
    await client.put(WALKER, json={"text": text}, headers={"If-Match": "1"})
    hashes = [
        (await client.post(f"{path}/step", json={"ticks": 50})).json()["hash"]
        for path in (edited, await walking(client))
    ]
    assert hashes[0] == hashes[1]


async def test_versions_are_listed(client: httpx.AsyncClient) -> None:
    await patch(client, "WALK", "LEFT", "TRGT")
    listed: list[dict[str, Any]] = (await client.get(f"{WALKER}/versions")).json()
    assert [(one["version"], one["what"]) for one in listed] == [
        (1, "as it was read"),
        (2, "WALK/LEFT: TRGT"),
    ]


async def test_a_given_folder_keeps_it_in_its_file(tmp_path: Path) -> None:
    folder = tmp_path / "mine"
    copytree(MACHINES / "faq-walker", folder, ignore=lambda *_: ["make"])
    (folder / "machine.yaml").chmod(0o640)
    app = create_app(Settings(folders=(folder,), names=OwnNames(("test",))))
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://test") as client:
        body = {"state": "WALK", "event": "LEFT", "text": "TRGT"}
        answer = await client.patch("/api/machines/mine/cells", json=body, headers={"If-Match": "1"})
    assert answer.json()["saved"] == "file"
    assert (folder / "machine.yaml").read_text() == answer.json()["text"]
    assert (folder / "machine.yaml").stat().st_mode & 0o777 == 0o640


async def test_the_schema_is_served(client: httpx.AsyncClient) -> None:
    assert (
        (await client.get("/api/schemas/machine.json"))
        .json()["$schema"]
        .startswith("http://json-schema.org/")
    )


@pytest.mark.parametrize("dry", [False, True])
async def test_an_edit_is_given_up_when_the_server_ends(
    app: Any, client: httpx.AsyncClient, dry: bool
) -> None:
    ending = threading.Event()
    ending.set()

    async def ended(scope: Scope, receive: Receive, send: Send) -> None:
        await app({**scope, ENDING: ending}, receive, send)

    async with httpx.AsyncClient(transport=httpx.ASGITransport(ended), base_url="http://localhost") as late:  # type: ignore[arg-type]
        answer = await patch(late, "WALK", "LEFT", "TRGT", dry=dry)
    assert (answer.status_code, (await client.get(WALKER)).json()["version"]) == (503, 1)


@pytest.mark.parametrize("word", ["yes", "1", "on", "True", ""])
async def test_a_dry_run_is_true_or_false(client: httpx.AsyncClient, word: str) -> None:
    """What is misspelled changes nothing."""
    answer = await client.patch(
        f"/api/machines/faq-walker/cells?dry={word}",
        json={"state": "WALK", "event": "LEFT", "text": "TRGT"},
        headers={"If-Match": '"1"'},
    )
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "dry")


@pytest.mark.parametrize(
    "operation",
    [
        {"kind": "add_state", "state": "IDLE", "fields": {"loop": None}},
        {"kind": "add_layer", "layer": "hat", "fields": {"mode": None}},
        {
            "kind": "add_parameter",
            "name": "heat",
            "fields": {"default": 0, "min": 0, "max": 1, "smooth": None},
        },
        {"kind": "add_sense", "name": "DRAUGHT", "fields": {"when": "speed > 1", "release": None}},
        {"kind": "add_key", "name": "z", "fields": {"press": "STOP", "hold": None}},
        {"kind": "add_collider", "name": "brow", "fields": {"sphere": 0.1, "joint": "Head", "at": None}},
    ],
    ids=lambda operation: operation["kind"],
)
async def test_null_is_nothing_in_what_is_new(client: httpx.AsyncClient, operation: dict[str, Any]) -> None:
    """It was a 500."""
    fields = {name: value for name, value in operation["fields"].items() if value is not None}
    texts = []
    for edit in (operation, operation | {"fields": fields}):
        body, match = {"operations": [edit]}, {"If-Match": '"1"'}
        answer = await client.patch(WALKER, json=body, headers=match, params={"dry": True})
        texts.append(answer.raise_for_status().json())
    assert texts[0] == texts[1]

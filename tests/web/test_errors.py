"""Which status each domain error is, and that a name in the path is not found where one in the body does not
fit.
"""

from dataclasses import asdict
from pathlib import Path
from shutil import copytree

import httpx
import orjson
import pytest
from paths import MACHINES
from statwalk import errors
from statwalk.machine.lint.findings import Finding
from statwalk.web.app import create_app
from statwalk.web.errors import LARGEST_PROBLEM_BYTES, Problem, answer, from_error
from statwalk.web.settings import Settings

STATUS = [
    (errors.UnknownNameError("machine", "wolker", ["walker"]), 422),
    (errors.StageError("tick 9 is not there"), 409),
    (errors.ConflictError("nothing to undo"), 409),
    (errors.LimitError("as many as it may"), 409),
    (errors.VersionConflictError("version 2 by now", field="version"), 412),
    (errors.RefusedEditError("refused", field="line 3"), 422),
    (errors.BusyError("try again"), 503),
    (errors.CancelledError("given up"), 503),
    (errors.StorageError("the disk refuses"), 503),
    (errors.StorageError("the disk is full", is_full=True), 507),
    (errors.OverdueError("too long"), 503),
    (errors.MachineError("no such state", place="line 3"), 422),
    (errors.StatwalkError("something else"), 400),
]


@pytest.mark.parametrize(("error", "status"), STATUS, ids=lambda value: type(value).__name__)
def test_each_error_has_its_status(error: errors.StatwalkError, status: int) -> None:
    assert (from_error(error).status_code, from_error(error).detail) == (status, str(error))


def test_no_error_is_without_a_status_of_its_own() -> None:
    def family(kind: type) -> set[type]:
        return {kind}.union(*map(family, kind.__subclasses__()))

    ours = {kind for kind in family(errors.StatwalkError) if kind.__module__ == errors.__name__}
    assert ours - {type(error) for error, _ in STATUS} == {
        errors.ContentError,
        errors.ModelError,
        errors.TextError,
    }


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ({"name": "wolker"}, 404),
        ({"name": "walker"}, 422),
        ({"stage_id": "wolker"}, 422),
        ({}, 422),
    ],
)
def test_only_a_name_in_the_path_is_not_found(path: dict[str, str], status: int) -> None:
    problem = from_error(errors.UnknownNameError("machine", "wolker", ["walker"]), path)
    assert (problem.status_code, problem.body()["known"], problem.field) == (status, ["walker"], "machine")


def test_a_refused_edit_brings_what_was_found() -> None:
    found = Finding("undefined state", "error", "MOON is no state", 3)
    body = from_error(errors.RefusedEditError("refused", field="line 3", findings=[found])).body()
    assert body["findings"] == [asdict(found) | {"subject": "MOON"}]
    assert body["errors"] == [{"field": "line 3", "message": "refused"}]


def test_a_long_name_is_not_said_again_whole() -> None:
    assert len(str(errors.UnknownNameError("stage", "x" * 60_000, []))) < 200


def test_an_error_shows_no_folder_of_the_server() -> None:
    error = errors.MachineError("no", file="/srv/statwalk/machines/a/machine.yaml", place="line 3")
    assert from_error(error).detail == "machine.yaml, line 3: no"


LONG = "x" * 300_000
PROBLEMS = {
    "a long detail": Problem(422, LONG, field="text"),
    "a long field": Problem(422, "no", field=LONG),
    "many known names": Problem(422, "no", field="name", known=[LONG[:80]] * 9_000),
    "a long finding": Problem(422, "no", field="text", more={"findings": [{"message": LONG}]}),
}


@pytest.mark.parametrize("problem", PROBLEMS.values(), ids=PROBLEMS)
def test_an_answer_is_bounded(problem: Problem) -> None:
    body = answer(problem.body()).body
    assert len(body) <= LARGEST_PROBLEM_BYTES
    assert orjson.loads(body)["errors"][0]["message"][:2] == problem.detail[:2]


@pytest.mark.anyio
async def test_an_answer_lists_twenty_errors_and_counts_the_others(client: httpx.AsyncClient) -> None:
    """300 members that nobody asked for, and one that is missing."""
    answer = await client.post("/api/machines", json={f"m{number}": 0 for number in range(300)})
    problem = answer.json()
    assert (answer.status_code, len(problem["errors"])) == (422, 20)
    assert problem["detail"].endswith("and 281 more")


@pytest.mark.anyio
async def test_a_list_is_left_at_its_first_wrong_item(client: httpx.AsyncClient) -> None:
    answer = await client.post("/api/stages", json={"actors": [{"machine": 1}] * 500})
    assert [error["field"] for error in answer.json()["errors"]] == ["actors.0.machine"]


@pytest.mark.anyio
async def test_a_full_stage_is_no_more_than_may_be_said(client: httpx.AsyncClient) -> None:
    """2,000 actors with all their members are refused for the machine, not for their number."""
    actor = {"machine": "no", "name": None, "position": [0, 0, 0], "heading_deg": 0}
    answer = await client.post("/api/stages", json={"actors": [actor] * 2_000})
    assert (answer.status_code, answer.json()["errors"][0]["field"]) == (422, "machine")


@pytest.mark.anyio
async def test_a_machine_of_a_folder_is_refused_without_the_folder(tmp_path: Path) -> None:
    """Its model is read on first use, and found broken."""
    folder = copytree(MACHINES / "faq-walker", tmp_path / "robot")
    (folder / "walker.glb").write_bytes(b"glTF")
    app = create_app(Settings(folders=(folder,), main_stage=False))
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url="http://localhost") as client:
        answer = await client.get("/api/machines/robot/verify")
    assert answer.status_code == 422
    assert "walker.glb" in answer.text
    assert str(tmp_path) not in answer.text


@pytest.mark.anyio
async def test_an_address_that_nothing_has_is_named_and_leads_to_the_operations(
    client: httpx.AsyncClient,
) -> None:
    detail = (await client.get(f"/api/{'x' * 2_000}")).json()["detail"]
    assert "'/api/xxx" in detail
    assert len(detail) < 200
    (there,) = [word for word in detail.replace(";", "").split() if word.endswith(".json")]
    assert "/api/stages" in (await client.get(there)).json()["paths"]

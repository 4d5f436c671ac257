"""Each request has an id, a line in the log without its query, and a place in the metrics."""

import json
import logging
from typing import Any

import httpx
import pytest
from serving import PATIENCE
from statwalk.web.log_format import JsonLine
from watcher import Watcher
from websockets.exceptions import InvalidStatus
from websockets.sync.client import connect

pytestmark = pytest.mark.anyio
SECRET = "abcdefgh12345678"


async def test_a_short_printable_id_comes_back(client: httpx.AsyncClient) -> None:
    answer = await client.get("/healthz", headers={"X-Request-ID": "order-66"})
    assert answer.headers["x-request-id"] == "order-66"


@pytest.mark.parametrize("wanted", ["", "x" * 65, "two words", "caf\xe9", "tab\t."])
async def test_any_other_id_is_replaced(client: httpx.AsyncClient, wanted: str) -> None:
    answer = await client.get("/healthz", headers={"X-Request-ID": wanted.encode("latin-1")})
    assert len(bytes.fromhex(answer.headers["x-request-id"])) == 8


async def test_also_a_refusal_of_the_guard_has_an_id(client: httpx.AsyncClient) -> None:
    answer = await client.get("/healthz", headers={"Host": "evil.example", "X-Request-ID": "1"})
    assert (answer.status_code, answer.headers["x-request-id"]) == (421, "1")


def test_a_socket_has_an_id_too(address: str, stage: str) -> None:
    with Watcher(address, stage, additional_headers={"X-Request-ID": "viewer"}) as viewer:
        assert viewer.socket.response.headers["x-request-id"] == "viewer"
    with pytest.raises(InvalidStatus) as refused:
        connect(
            f"ws://{address}/api/stages/nowhere/stream",
            additional_headers={"X-Request-ID": "2"},
            open_timeout=PATIENCE,
        )
    assert refused.value.response.headers["x-request-id"] == "2"


async def logged(client: httpx.AsyncClient, caplog: pytest.LogCaptureFixture, path: str) -> dict[str, Any]:
    """The line for a request, as JSON."""
    with caplog.at_level(logging.INFO, "statwalk.requests"):
        await client.get(path, headers={"X-Request-ID": "7"})
    records = [record for record in caplog.records if record.name == "statwalk.requests"]
    lines = [json.loads(JsonLine().format(record)) for record in records]
    return next(dict(line) for line in lines if line["method"] == "GET")  # a DELETE before it may end late


async def test_a_line_says_what_was_asked_and_answered(
    client: httpx.AsyncClient, caplog: pytest.LogCaptureFixture
) -> None:
    line = await logged(client, caplog, "/api/stages/nowhere")
    assert (line["method"], line["path"], line["status"]) == ("GET", "/api/stages/nowhere", 404)
    assert line["route"] == "/api/stages/{stage_id}"


async def test_a_query_is_never_logged(client: httpx.AsyncClient, caplog: pytest.LogCaptureFixture) -> None:
    await logged(client, caplog, f"/api/stages/nowhere?token={SECRET}")
    assert caplog.records
    assert SECRET not in str([JsonLine().format(record) for record in caplog.records])


async def test_a_path_cannot_begin_a_line_of_its_own(
    client: httpx.AsyncClient, caplog: pytest.LogCaptureFixture
) -> None:
    line = await logged(client, caplog, "/api/%0Alevel=error")
    assert line["path"] == "/api/%0Alevel=error"


async def counted(client: httpx.AsyncClient) -> float:
    """How often a machine was not found."""
    start = 'statwalk_requests_total{method="GET",route="/api/machines/{name}",status="404"} '
    lines = (await client.get("/metrics")).text.splitlines()
    return sum(float(line.removeprefix(start)) for line in lines if line.startswith(start))


async def test_answers_and_refusals_are_counted(client: httpx.AsyncClient) -> None:
    before = await counted(client)
    for path in ("/api/machines/nothing", "/api/machines/nobody", "/api/machines"):
        await client.get(path)
    assert await counted(client) - before == 2
    text = (await client.get("/metrics")).text
    assert 'statwalk_refusals_total{limit="",status="404"}' in text
    assert "nobody" not in text

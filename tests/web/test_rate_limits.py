"""What comes too often gets a 429 that says when to come again; whose it is, is told by address and stage."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from statwalk.services.access.access_file import AccessFile
from statwalk.services.access.authenticator import Authenticator
from statwalk.services.limits import Limits
from statwalk.web.app import create_app
from statwalk.web.errors import Problem
from statwalk.web.rate_limits import RateLimits
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
SLOW = 0.5
"""a second, with a burst of one"""


def app(**limits: float) -> Any:
    """An app whose stage `main` takes inputs."""
    return create_app(Settings(limits=Limits(**limits)))


def client_of(app: Any, address: str) -> httpx.AsyncClient:
    transport = httpx.ASGITransport(app, client=(address, 1))
    return httpx.AsyncClient(transport=transport, base_url="http://localhost")


async def until_refused(
    client: httpx.AsyncClient, method: str, path: str, body: Any = None
) -> httpx.Response:
    """The first answer that is a 429."""
    for _ in range(20):
        answer = await client.request(method, path, json=body)
        if answer.status_code == 429:
            return answer
    raise AssertionError("20 requests were let in")


def is_refused_for(answer: httpx.Response, words: str) -> bool:
    problem = answer.headers["content-type"] == "application/problem+json"
    return problem and int(answer.headers["retry-after"]) >= 1 and words in answer.json()["detail"]


async def test_requests_of_one_address_are_limited_and_others_are_not() -> None:
    limited = app(requests=SLOW)
    async with client_of(limited, "192.0.2.1") as flooder, client_of(limited, "192.0.2.2") as other:
        answer = await until_refused(flooder, "GET", "/api/machines")
        assert is_refused_for(answer, "requests from your address")
        assert (await other.get("/api/machines")).status_code == 200
        assert (await flooder.get("/healthz")).status_code == 200  # what watches the server is no flood
    async with client_of(limited, "192.0.2.3") as watcher:
        metrics = (await watcher.get("/metrics")).text
    assert 'statwalk_refusals_total{limit="requests",status="429"} 1.0' in metrics


async def test_behind_a_proxy_a_token_is_a_client(tmp_path: Path) -> None:
    """All of them have the proxy's address."""
    people = AccessFile(tmp_path)
    tokens = [people.add(name, "view") for name in ("ada", "bob")]
    settings = Settings(limits=Limits(requests=SLOW), authenticator=Authenticator(people), proxied=True)
    limited = create_app(settings)
    async with client_of(limited, "192.0.2.1") as flooder, client_of(limited, "192.0.2.1") as other:
        for client, token in zip((flooder, other), tokens, strict=True):
            client.headers["Authorization"] = f"Bearer {token}"
        answer = await until_refused(flooder, "GET", "/api/machines")
        assert is_refused_for(answer, "requests with your token")
        assert (await other.get("/api/machines")).status_code == 200


async def test_requests_about_one_stage_are_limited_and_other_stages_are_not() -> None:
    limited = app(stage_requests=SLOW)
    async with client_of(limited, "192.0.2.1") as client:
        own = (await client.post("/api/stages", json={"clock": "manual"})).headers["location"]
        assert is_refused_for(await until_refused(client, "GET", "/api/stages/main"), "about this stage")
        assert (await client.get(own)).status_code == 200


@pytest.mark.parametrize(
    ("limits", "words"),
    [
        ({"inputs": SLOW}, "inputs from your address"),
        ({"stage_inputs": SLOW}, "inputs to this stage"),
    ],
)
async def test_inputs_are_limited_and_questions_are_not(limits: dict[str, float], words: str) -> None:
    async with client_of(app(**limits), "192.0.2.1") as client:
        answer = await until_refused(client, "POST", "/api/stages/main/events", {"event": "FORWARD"})
        assert is_refused_for(answer, words)
        assert (await client.get("/api/stages/main")).status_code == 200


async def test_a_travel_is_an_input_too() -> None:
    async with client_of(app(inputs=SLOW), "192.0.2.1") as client:
        answer = await until_refused(client, "DELETE", "/api/stages/main/actors/1/travel")
        assert is_refused_for(answer, "inputs from your address")


async def test_made_up_stages_fill_no_bucket() -> None:
    limited = app()
    async with client_of(limited, "192.0.2.1") as client:
        for number in range(5):
            await client.post(f"/api/stages/{number}/events", json={"event": "FORWARD"})
    rates = limited.app.app.state.rates
    assert list(rates._stage_requests.buckets._buckets) == []


def test_a_cooled_address_may_come_back_later() -> None:
    rates = RateLimits(Limits(cooling_seconds=10.0))
    rates.check_cooled("192.0.2.1")
    rates.cool("192.0.2.1")
    rates.check_cooled("192.0.2.2")
    with pytest.raises(Problem) as refused:
        rates.check_cooled("192.0.2.1")
    assert refused.value.status_code == 429
    rates._cooling["192.0.2.1"] -= 10.0  # as if 10 s had passed
    rates.check_cooled("192.0.2.1")


async def test_a_log_that_is_full_of_new_inputs_takes_no_more_until_the_stage_has_stepped() -> None:
    async with client_of(app(entries=3), "192.0.2.1") as client:
        stage = (await client.post("/api/stages", json={"clock": "manual"})).headers["location"]
        assert (await client.post(f"{stage}/actors", json={"machine": "faq-walker"})).status_code == 201
        event = {"event": "FORWARD"}
        answers = [await client.post(f"{stage}/events", json=event) for _ in range(3)]
        assert [answer.status_code for answer in answers] == [202, 202, 409]  # one entry is the arrival
        assert "let it step" in answers[-1].json()["detail"]
        await client.post(f"{stage}/step", json={"ticks": 61})
        assert (await client.post(f"{stage}/events", json=event)).status_code == 202
        assert (await client.get(stage)).json()["first"] == 60


async def test_one_tick_takes_so_many_inputs_and_the_next_takes_more() -> None:
    async with client_of(app(tick_entries=2), "192.0.2.1") as client:
        opened = await client.post("/api/stages", json={"clock": "manual"})
        stage = opened.headers["location"]
        assert (await client.post(f"{stage}/actors", json={"machine": "faq-walker"})).status_code == 201
        event = {"event": "FORWARD"}
        posted = [(await client.post(f"{stage}/events", json=event)).status_code for _ in range(2)]
        await client.post(f"{stage}/step", json={"ticks": 1})
        posted.append((await client.post(f"{stage}/events", json=event)).status_code)
    assert posted == [202, 409, 202]

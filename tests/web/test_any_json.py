"""Whatever JSON comes, on whatever route: an answer that is no defect (the transport raises what the server
did not expect).
"""

import asyncio
import json
from typing import Any

import httpx
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

NUMBERS = st.integers(-(2**70), 2**70) | st.floats(allow_nan=False, allow_infinity=False)
VALUES = st.recursive(
    st.none() | st.booleans() | NUMBERS | st.text(max_size=20),
    lambda inner: st.lists(inner, max_size=3),
    max_leaves=5,
)
NAMES = (
    "event",
    "actor",
    "kind",
    "parameter",
    "value",
    "ticks",
    "tick",
    "paused",
    "speed",
    "machine",
    "name",
    "position",
    "heading_deg",
)
SENSIBLE = {
    "event": "FORWARD",
    "kind": "hold",
    "machine": "faq-walker",
    "ticks": 2,
    "tick": 0,
    "paused": True,
    "speed": 2.0,
    "actor": 1,
}
BODIES = VALUES | st.dictionaries(st.sampled_from(NAMES), VALUES, max_size=4).map(lambda odd: SENSIBLE | odd)
BODIES |= st.sampled_from(NAMES).flatmap(lambda name: VALUES.map(lambda value: {name: value}))
ROUTES = ("events", "parameters", "step", "seek", "pause", "speed", "actors", "fork")


@pytest.mark.parametrize("route", ROUTES)
@settings(max_examples=30, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(body=BODIES)
def test_any_json_is_answered(app: Any, route: str, body: Any) -> None:
    async def ask() -> int:
        async with httpx.AsyncClient(
            transport=httpx.ASGITransport(app), base_url="http://localhost"
        ) as client:
            opened = await client.post(
                "/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]}
            )
            stage = opened.headers["Location"]
            answer = await client.post(
                f"{stage}/{route}",
                content=json.dumps(body).encode(),
                headers={"content-type": "application/json"},
            )
            await client.delete(answer.headers.get("Location", stage) if route == "fork" else stage)
            await client.delete(stage)
            return answer.status_code

    assert asyncio.run(ask()) < 500

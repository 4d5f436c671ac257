"""A long step is given up when its client goes."""

import json
from collections.abc import Iterator
from http.client import HTTPConnection

import httpx
import pytest
from serving import wait_for

FOR_EVER = 36_000
IS_JSON = {"content-type": "application/json"}


@pytest.fixture
def crowd(rest: httpx.Client) -> Iterator[str]:
    """The path of a stage with a manual clock that many actors stand on."""
    opened = rest.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}] * 50})
    yield opened.headers["Location"]
    rest.delete(opened.headers["Location"])


@pytest.mark.parametrize("spaces", [0, 200_000])
def test_a_stage_stands_still_when_the_client_that_steps_it_has_gone(
    address: str, crowd: str, rest: httpx.Client, spaces: int
):
    """Also after a long body: meanwhile the server stops reading now and then."""
    impatient = HTTPConnection(address)
    impatient.request("POST", f"{crowd}/step", json.dumps({"ticks": FOR_EVER}) + spaces * " ", IS_JSON)
    wait_for(lambda: rest.get(crowd).json()["head"] > 0)
    impatient.close()

    def stands_still() -> bool:
        return len({rest.get(crowd).json()["head"] for _ in range(20)}) == 1

    wait_for(stands_still)
    assert rest.get(crowd).json()["head"] < FOR_EVER

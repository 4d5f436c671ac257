"""A long step is given up when its client goes."""

from collections.abc import Iterator

import httpx
import pytest
from serving import wait_for

FOR_EVER = 36_000


@pytest.fixture
def crowd(rest: httpx.Client) -> Iterator[str]:
    """The path of a stage with a manual clock that many actors stand on."""
    opened = rest.post("/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}] * 50})
    yield opened.headers["Location"]
    rest.delete(opened.headers["Location"])


def test_a_stage_stands_still_when_the_client_that_steps_it_has_gone(
    address: str, crowd: str, rest: httpx.Client
):
    with httpx.Client(base_url=f"http://{address}") as impatient, pytest.raises(httpx.ReadTimeout):
        impatient.post(f"{crowd}/step", json={"ticks": FOR_EVER}, timeout=1.0)

    def stands_still() -> bool:
        return len({rest.get(crowd).json()["head"] for _ in range(20)}) == 1

    wait_for(stands_still)
    assert 0 < rest.get(crowd).json()["head"] < FOR_EVER

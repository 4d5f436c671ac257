"""A long step is given up when its client goes."""

from collections.abc import Iterator

import httpx
import pytest

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
        impatient.post(f"{crowd}/step", json={"ticks": FOR_EVER}, timeout=0.5)
    left = rest.get(crowd).json()["head"]
    ticks = [rest.get(crowd).json()["head"] for _ in range(20)]
    assert 0 < left < FOR_EVER
    assert len(set(ticks[10:])) == 1

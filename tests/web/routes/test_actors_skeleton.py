"""GET …/actors/{actor}/skeleton.svg: an actor's past as stick figures."""

import xml.etree.ElementTree as ET

import httpx
import numpy as np
import pytest

pytestmark = pytest.mark.anyio
SVG = "{http://www.w3.org/2000/svg}"


@pytest.fixture
async def stage(client: httpx.AsyncClient) -> str:
    """The address of a stage whose walker has walked for 80 ticks."""
    opened = await client.post(
        "/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker", "name": "hero"}]}
    )
    address = opened.headers["location"]
    await client.post(f"{address}/events", json={"event": "FORWARD", "kind": "hold"})
    await client.post(f"{address}/step", json={"ticks": 80})
    return address


async def drawn(client: httpx.AsyncClient, stage: str, **params: object) -> list[ET.Element]:
    (actor,) = (await client.get(f"{stage}/actors")).json()
    answer = await client.get(f"{stage}/actors/{actor['id']}/skeleton.svg", params=params)
    assert (answer.status_code, answer.headers["content-type"]) == (200, "image/svg+xml")
    return ET.fromstring(answer.text).findall(f"{SVG}g")


def circles(picture: ET.Element) -> np.ndarray:
    return np.array([(float(one.get("cx")), float(one.get("cy"))) for one in picture.iter(f"{SVG}circle")])


async def test_a_picture_for_each_tick(client: httpx.AsyncClient, stage: str) -> None:
    pictures = await drawn(client, stage, tick=[0, 40, 60])
    assert [picture.findtext(f"{SVG}text") for picture in pictures] == ["tick 0", "tick 40", "tick 60"]
    shapes = [circles(picture) - circles(picture).mean(axis=0) for picture in pictures]
    assert np.abs(shapes[0] - shapes[2]).max() > 2


async def test_the_playhead_stays(client: httpx.AsyncClient, stage: str) -> None:
    (now,) = await drawn(client, stage, side="front")
    assert now.findtext(f"{SVG}text") == "tick 80"
    await drawn(client, stage, tick=[10])
    assert (await client.get(stage)).json()["tick"] == 80


@pytest.mark.parametrize(
    ("actor", "params", "status"),
    [
        (99, {}, 404),
        (0, {"tick": 9999}, 409),
        (0, {"side": "inside"}, 422),
        (0, {"tick": list(range(61))}, 422),
    ],
    ids=str,
)
async def test_what_cannot_be_drawn_is_refused(
    client: httpx.AsyncClient, stage: str, actor: int, params: dict[str, object], status: int
) -> None:
    (own,) = (await client.get(f"{stage}/actors")).json()
    answer = await client.get(f"{stage}/actors/{actor or own['id']}/skeleton.svg", params=params)
    assert answer.status_code == status, answer.text

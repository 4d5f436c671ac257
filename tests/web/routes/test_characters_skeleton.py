"""GET /api/characters/{name}/skeleton.svg: stick figures without a browser."""

import xml.etree.ElementTree as ET

import httpx
import pytest

pytestmark = pytest.mark.anyio
SVG = "{http://www.w3.org/2000/svg}"
ADDRESS = "/api/characters/walker/skeleton.svg"


async def test_a_film_strip_of_a_clip(client: httpx.AsyncClient) -> None:
    answer = await client.get(ADDRESS, params={"clip": "walk", "frames": 4, "side": "front"})
    assert (answer.status_code, answer.headers["content-type"]) == (200, "image/svg+xml")
    assert len(ET.fromstring(answer.text).findall(f"{SVG}g")) == 4


async def test_times_may_be_repeated(client: httpx.AsyncClient) -> None:
    answer = await client.get(ADDRESS, params={"clip": "walk", "time": [0.1, 0.5, 0.2]})
    texts = [picture.findtext(f"{SVG}text") for picture in ET.fromstring(answer.text).findall(f"{SVG}g")]
    assert texts == ["walk 0.10 s", "walk 0.50 s", "walk 0.20 s"]


@pytest.mark.parametrize(
    "params",
    [
        {"clip": "wlak"},
        {"frames": 4},
        {"clip": "walk", "frames": 61},
        {"side": "inside"},
        {"clip": "walk", "time": "inf"},
    ],
    ids=str,
)
async def test_what_cannot_be_drawn_is_refused(client: httpx.AsyncClient, params: dict[str, str]) -> None:
    answer = await client.get(ADDRESS, params=params)
    assert answer.status_code == 422
    assert answer.headers["content-type"] == "application/problem+json"

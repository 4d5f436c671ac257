"""When a foot stands in a clip, corrected over REST: what is kept, and what is refused where."""

from pathlib import Path
from typing import Any

import httpx
import pytest
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
PATH = "/api/machines/faq-walker"


@pytest.fixture
def app(tmp_path: Path) -> Any:
    """Not shared: machines are changed here."""
    return create_app(Settings(main_stage=False, data=tmp_path))


async def corrected(client: httpx.AsyncClient, version: int = 1, **members: Any) -> httpx.Response:
    """The answer to the contacts of the left foot in the walk; `members` are others."""
    operation = {"kind": "set_contacts", "clip": "walk", "foot": "left", "spans": [[0, 0.5]]} | members
    return await client.patch(PATH, json={"operations": [operation]}, headers={"If-Match": f'"{version}"'})


async def planted(client: httpx.AsyncClient) -> Any:
    clips = (await client.get(f"{PATH}/feet")).json()["clips"]
    return next(clip for clip in clips if clip["clip"] == "walk")["feet"][0]["planted"]


async def test_contacts_are_kept_and_found_again(client: httpx.AsyncClient) -> None:
    found = await planted(client)
    assert (await corrected(client)).status_code == 200
    assert await planted(client) == [[0, 0.5]]
    assert (await corrected(client, 2, spans=[])).status_code == 200
    assert await planted(client) == []
    assert (await corrected(client, 3, spans=None)).status_code == 200
    assert await planted(client) == found


@pytest.mark.parametrize(
    ("members", "words"),
    [
        ({"clip": "wlak"}, "walk"),
        ({"foot": "lefft"}, "left"),
        ({"spans": [[0.5, 0.4]]}, "a contact ends after it begins"),
        ({"spans": [[0.5]]}, "spans"),
        ({"spans": [[0, 0.5]] * 65}, "spans"),
    ],
)
async def test_refused_with_words(client: httpx.AsyncClient, members: dict[str, Any], words: str) -> None:
    answer = await corrected(client, **members)
    assert answer.status_code == 422
    assert words in answer.text
    assert (await client.get(PATH)).json()["version"] == 1

"""Expressions over REST: which line sets what to what, edited while they play; refused with a line."""

from pathlib import Path
from shutil import copytree
from typing import Any

import httpx
import pytest
from paths import MACHINES
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
BOX = "/api/machines/box"
CHARACTER = """\
model: gearbox.glb
expressions: |
  ratio = 10 / 8
  gear_b.rotate_z = -ratio * gear_a.rotate_z
"""


@pytest.fixture
def app(tmp_path: Path) -> Any:
    """The gearbox, whose second gear is the character's own business."""
    folder = tmp_path / "box"
    copytree(MACHINES / "gearbox", folder)
    text = (folder / "machine.yaml").read_text().replace("character: gearbox.glb", "character: box.yaml")
    kept = [line for line in text.split("\n") if not line.strip().startswith("gear_b.rotate_z")]
    (folder / "machine.yaml").write_text("\n".join(kept))
    (folder / "box.yaml").write_text(CHARACTER)
    return create_app(Settings(folders=(folder,), main_stage=False))


async def patch(client: httpx.AsyncClient, text: str, version: int = 1, dry: bool = False) -> httpx.Response:
    headers, params = {"If-Match": f'"{version}"'}, {"dry": dry}
    return await client.patch(f"{BOX}/expressions", json={"text": text}, headers=headers, params=params)


async def played(client: httpx.AsyncClient) -> str:
    stage = {"clock": "manual", "actors": [{"machine": "box"}]}
    url = (await client.post("/api/stages", json=stage)).headers["Location"]
    await client.post(f"{url}/step", json={"ticks": 8})
    return str(url)


async def test_a_machine_lists_its_lines_and_its_characters(client: httpx.AsyncClient) -> None:
    machine = (await client.get(BOX)).json()
    lines = {line["name"]: line for line in machine["expressions"]}
    assert lines["gear_b.rotate_z"] == {
        "line": 4,
        "name": "gear_b.rotate_z",
        "formula": "-ratio * gear_a.rotate_z",
        "source": "character",
    }
    assert lines["ratio"]["source"] == "character"
    gear = lines["gear_a.rotate_z"]
    assert (gear["source"], gear["formula"]) == ("machine", "10 * frameid")
    assert machine["text"].split("\n")[gear["line"] - 1].strip().startswith("gear_a.rotate_z")
    assert machine["expression_text"].startswith("radius_a = 10")
    own = (await client.get("/api/characters/box")).json()["expressions"]
    assert own == ["ratio = 10 / 8", "gear_b.rotate_z = -ratio * gear_a.rotate_z"]


async def test_an_actor_says_what_every_line_sets(client: httpx.AsyncClient) -> None:
    url = await played(client)
    actor = (await client.get(f"{url}/actors/1")).json()
    assert actor["channels"]["gear_a.rotate_z"] == 80
    assert actor["channels"]["gear_b.rotate_z"] == -100
    assert actor["variables"]["ratio"] == 1.25
    assert set(actor["variables"]) == {"ratio", "radius_a", "radius_b", "pitch"}


async def test_edited_lines_count_at_once_and_are_undone(client: httpx.AsyncClient) -> None:
    url = await played(client)
    answer = await patch(client, "gear_a.rotate_z = 2 * frameid  # slower")
    assert answer.status_code == 200, answer.text
    assert "gear_a.rotate_z = 2 * frameid  # slower" in answer.json()["text"]
    await client.post(f"{url}/step", json={"ticks": 2})
    assert (await client.get(f"{url}/actors/1")).json()["channels"] == {
        "gear_a.rotate_z": 20,
        "gear_b.rotate_z": -25,
    }
    await client.post(f"{BOX}/undo", headers={"If-Match": '"2"'})
    assert "10 * frameid" in (await client.get(BOX)).json()["expression_text"]


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("a = 1\ngear_a.rotate_z = pase", "no variable is called 'pase'"),
        ("a = b\nb = a", "circle"),
        ("a = 1\ngear_b.rotate_z = 2", "set by the character's own expressions (line 4 of its file)"),
        ("gear_a.rotate_z = gear_b.rotate_z", "with the character's own"),
        ("gear_x.rotate_z = 1", "did you mean gear"),
        ("a = (1", "the formula"),
        ("a = " + "(" * 5000, "longer than"),
    ],
)
@pytest.mark.parametrize("dry", [False, True])
async def test_a_wrong_line_is_refused_with_its_line(
    client: httpx.AsyncClient, text: str, what: str, dry: bool
) -> None:
    answer = await patch(client, text, dry=dry)
    assert answer.status_code == (200 if dry else 422)
    body = answer.json()
    assert what in body["detail"]
    first = (await client.get(BOX)).json()["text"].split("\n").index("expressions: |") + 1
    wrong = 2 if text.startswith("a = 1") else 1
    assert body["errors"][0]["field"] == f"line {first + wrong}"


async def test_an_edit_of_an_old_version_is_refused(client: httpx.AsyncClient) -> None:
    assert (await patch(client, "a = 1", version=7)).status_code == 412

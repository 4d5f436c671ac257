"""POST /api/deduce: bones as JSON, as a file, of a character; refusals with their field."""

from typing import Any

import httpx
import pytest

pytestmark = pytest.mark.anyio
BONES = {
    "upper": {"length": 5.0, "direction": [0.0, -1.0, 0.0]},
    "fore": {"parent": "upper", "length": 5.0, "direction": [0.0, -1.0, 0.0]},
}
KNOWN: dict[str, Any] = {
    "upper": {"SP": [0.0, 0.0, 0.0]},
    "fore": {"EP": [0.0, -8.0, 0.0], "bend": [0.0, 0.0, 1.0]},
}
FAR = {**KNOWN, "fore": {**KNOWN["fore"], "EP": [0.0, -11.0, 0.0]}}
FILE = """\
bones: {upper: {length: 5, direction: [0, -1, 0]}, fore: {parent: upper, length: 5, direction: [0, -1, 0]}}
known: {upper: {SP: [0, 0, 0]}, fore: {EP: [0, -8, 0], bend: [0, 0, 1]}}
"""


async def ask(client: httpx.AsyncClient, **body: Any) -> httpx.Response:
    return await client.post("/api/deduce", json=body)


async def test_bones_and_known_values_are_answered(client: httpx.AsyncClient) -> None:
    upper, fore = (await ask(client, bones=BONES, known=KNOWN)).json()["bones"]
    assert upper["values"]["EP"] == {"value": pytest.approx([0, -4, 3]), "source": "rule 12"}
    assert fore["values"]["RA_deg"]["value"] == pytest.approx([73.739795, 0, 0])
    assert (fore["start"], fore["end"]) == (pytest.approx([0, -4, 3]), pytest.approx([0, -8, 0]))


async def test_a_file_says_the_same(client: httpx.AsyncClient) -> None:
    as_json, as_file = await ask(client, bones=BONES, known=KNOWN), await ask(client, file=FILE)
    assert as_file.json() == as_json.json()


async def test_unknown_bones_are_drawn_as_at_rest(client: httpx.AsyncClient) -> None:
    known = {"upper": {"RA_deg": [0.0, 0.0, 90.0]}}
    _, fore = (await ask(client, bones=BONES, known=known)).json()["bones"]
    assert fore["unknown"] == ["RA_deg", "RM", "EP"]
    assert (fore["start"], fore["end"]) == (pytest.approx([5, 0, 0]), pytest.approx([10, 0, 0]))


async def test_a_characters_joints_are_bones(client: httpx.AsyncClient) -> None:
    character = (await client.get("/api/characters")).json()[0]["name"]
    answer = await ask(client, character=character, known={})
    bones = {bone["name"]: bone for bone in answer.json()["bones"]}
    turned = await ask(client, character=character, known={name: {"RA_deg": [0, 0, 0]} for name in bones})
    first, second = list(bones)[:2]
    assert turned.json()["bones"][1]["parent"] == 0
    assert bones[second]["values"]["LEN"]["source"] == "default"
    assert not any(bone["unknown"] for bone in turned.json()["bones"])
    assert first in turned.text


async def test_expressions_take_part(client: httpx.AsyncClient) -> None:
    lines = [f"fore.rotate_{axis} = -0.5 * upper.rotate_{axis}" for axis in "xyz"]
    known = {"upper": {"RA_deg": [0.0, 0.0, 90.0]}}
    _, fore = (await ask(client, bones=BONES, known=known, expressions=lines)).json()["bones"]
    assert fore["values"]["RA_deg"]["value"] == pytest.approx([0, 0, -45])
    as_text = await ask(client, bones=BONES, known=known, expressions="\n".join(lines))
    assert as_text.json()["bones"][1] == fore


@pytest.mark.parametrize(
    ("body", "field", "what"),
    [
        ({}, "bones", "one of"),
        ({"skeleton": "mammal", "file": FILE}, "bones", "one of"),
        ({"skeleton": "mouse"}, "", "no skeleton is called 'mouse'"),
        ({"bones": {"a": {"parent": "b"}}}, "bones.a", "no bone is called 'b'"),
        ({"bones": BONES, "known": {"uper": {}}}, "", "did you mean upper"),
        ({"bones": BONES, "known": {"upper": {"SP": [1.0, 2.0]}}}, "known.upper.SP", ""),
        ({"bones": BONES, "known": FAR}, "known.upper.EP", "misses"),
        ({"bones": BONES, "known": {"upper": {"DIR": [0.0, 0.0, 0.0]}}}, "known.upper.DIR", "direction"),
        ({"bones": BONES, "expressions": ["a = b"]}, "expressions", "no line sets b"),
        ({"file": "bones: [1"}, "", "not YAML"),
    ],
)
async def test_what_is_wrong_is_refused(
    client: httpx.AsyncClient, body: dict[str, Any], field: str, what: str
) -> None:
    refused = await ask(client, **body)
    assert 400 <= refused.status_code < 500
    assert field in str(refused.json())
    assert what in str(refused.json())

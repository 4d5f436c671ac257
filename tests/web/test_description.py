"""The description at /api/openapi.json is true: every JSON answer is typed, and an independent validator says
that what is sent fits.
"""

import asyncio
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
import tiny_model
from jsonschema import Draft202012Validator
from paths import MACHINES
from statwalk.character.role import Role
from statwalk.services.library.load import load
from statwalk.stage.explain import remedy_words
from statwalk.stage.history.log_codec import KINDS
from statwalk.stage.stage import Stage
from statwalk.web.app import create_app, openapi_document
from statwalk.web.settings import Settings
from watcher import Watcher

DOCUMENT = openapi_document()
JSON = "application/json"
CELL = {"state": "WALK", "event": "LEFT", "text": "TRGT"}
BAD_CELL = CELL | {"text": "NOWHERE"}
REQUESTS: list[tuple[str, str, Any]] = [  # in this order: 1 is the actor of the stage
    ("GET", "/api/machines", None),
    ("GET", "/api/machines/faq-walker", None),
    ("GET", "/api/machines/playground.cannon", None),
    ("GET", "/api/machines/swarm.bee", None),
    ("GET", "/api/machines/walker-layers", None),
    ("GET", "/api/machines/faq-walker/versions", None),
    ("GET", "/api/machines/faq-printed/verify", None),
    ("PATCH", "/api/machines/faq-walker/cells?dry=true", CELL),
    ("PATCH", "/api/machines/faq-walker/cells?dry=true", BAD_CELL),
    ("PUT", "/api/characters/tiny", tiny_model.model()),
    ("GET", "/api/characters", None),
    ("GET", "/api/characters/tiny", None),
    ("GET", "/api/characters/tiny/mapping", None),
    ("POST", "/api/machines", {"name": "tiny", "character": "tiny"}),
    ("POST", "/api/machines", {"name": "tiny", "character": "tiny"}),
    ("GET", "/api/scenes", None),
    ("GET", "/api/stages", None),
    ("GET", "/api/stages/none", None),
    ("GET", "{stage}", None),
    ("POST", "{stage}/actors", {"machine": "faq-walker"}),
    ("GET", "{stage}/actors", None),
    ("POST", "{stage}/events", {"event": "FORWARD"}),
    ("POST", "{stage}/events", {"event": "NONE"}),
    ("POST", "{stage}/step", {"ticks": 30}),
    ("GET", "{stage}/actors/1/pose", None),
    ("GET", "{stage}/actors/1/why?tick=1", None),
    ("GET", "{stage}/actors/1/whynot?event=CROUCH&tick=20", None),
    ("GET", "{stage}/actors/1/whynot?event=JUMP&tick=1", None),
    ("GET", "{stage}/actors/1/whynot?event=LEFT&tick=1", None),
    ("POST", "{stage}/actors/1/travel", {"state": "CRCH"}),
    ("GET", "{stage}/history", None),
    ("GET", "{stage}/facts?since=3", None),
    ("POST", "{stage}/fork", None),
]


def fits(value: Any, schema: dict[str, Any]) -> None:
    Draft202012Validator({**schema, "components": DOCUMENT["components"]}).validate(value)


def operations() -> Iterator[tuple[str, dict[str, Any]]]:
    for path, methods in DOCUMENT["paths"].items():
        yield from ((f"{method.upper()} {path}", operation) for method, operation in methods.items())


def operation_of(method: str, path: str) -> dict[str, Any]:
    """The operation whose path fits: one without parameters before one with."""
    parts = path.partition("?")[0].split("/")
    for known in sorted(DOCUMENT["paths"], key=lambda known: known.count("{")):
        pairs = list(zip(known.split("/"), parts, strict=False))
        if known.count("/") == len(parts) - 1 and all(
            one == other or one.startswith("{") for one, other in pairs
        ):
            return DOCUMENT["paths"][known][method.lower()]
    raise AssertionError(f"{path} is not described")


def promised(operation: dict[str, Any], status: int) -> dict[str, Any]:
    """The schema of an answer."""
    if status >= 400:
        return {"$ref": "#/components/schemas/ProblemView"}
    schema: dict[str, Any] = operation["responses"][str(status)]["content"][JSON]["schema"]
    return schema


def is_typed(schema: dict[str, Any]) -> bool:
    several = schema.get("anyOf", [schema.get("items", schema)])
    return all("$ref" in one or is_typed(one) for one in several) if several != [schema] else "$ref" in schema


@pytest.mark.parametrize(
    ("name", "operation"), list(operations()), ids=lambda value: value if isinstance(value, str) else ""
)
def test_every_json_answer_is_a_model(name: str, operation: dict[str, Any]) -> None:
    contents = [
        answer.get("content", {})
        for status, answer in operation["responses"].items()
        if status.startswith("2")
    ]
    for content in contents:
        assert JSON not in content or is_typed(content[JSON]["schema"]), name


def test_the_answers_fit(tmp_path: Path) -> None:
    app = create_app(Settings(main_stage=False, data=tmp_path))

    async def ask() -> list[tuple[str, str, httpx.Response]]:
        async with httpx.AsyncClient(
            transport=httpx.ASGITransport(app), base_url="http://localhost", timeout=60
        ) as client:
            opened = await client.post(
                "/api/stages", json={"clock": "manual", "actors": [{"machine": "faq-walker"}]}
            )
            return [
                await answered(client, method, path.format(stage=opened.headers["Location"]), body)
                for method, path, body in REQUESTS
            ]

    async def answered(
        client: httpx.AsyncClient, method: str, path: str, body: Any
    ) -> tuple[str, str, httpx.Response]:
        sent = {"content": body} if isinstance(body, bytes) else {"json": body} if body is not None else {}
        kind = {"content-type": "model/gltf-binary"} if isinstance(body, bytes) else {}
        return method, path, await client.request(method, path, headers=kind | {"If-Match": '"1"'}, **sent)

    answers = asyncio.run(ask())
    for method, path, answer in answers:
        fits(answer.json(), promised(operation_of(method, path), answer.status_code))
    assert {answer.status_code for _, _, answer in answers} == {200, 201, 202, 404, 409, 422}


def test_the_socket_says_what_is_described(address: str, stage: str, rest: httpx.Client) -> None:
    with Watcher(address, stage) as viewer:
        viewer.say(type="event", event="FORWARD", ref="a")
        viewer.say(type="event", event="NONE", ref=2)
        viewer.say(type="event", event="STOP", tick=0)
        rest.post(f"{stage}/step", json={"ticks": 40})
        rest.post(f"{stage}/pause", json={"paused": True})
        viewer.say(type="event", event="STOP", tick=0)
        viewer.text("forked")
        viewer.say(type="ping")
        viewer.text("pong")
    for text in viewer.texts:
        fits(text, {"$ref": "#/components/schemas/ServerMessage"})
    assert {text["type"] for text in viewer.texts} >= {
        "hello",
        "status",
        "verdict",
        "accepted",
        "error",
        "forked",
        "pong",
    }


def test_every_kind_of_remedy_is_described() -> None:
    change = DOCUMENT["components"]["schemas"]["RemedyView"]["properties"]["change"]
    assert change["discriminator"]["mapping"].keys() == remedy_words.WORDS.keys()


def test_what_a_viewer_says_is_described() -> None:
    said = {"type": "event", "event": "FORWARD", "kind": "hold", "actor": 0, "ref": "a"}
    message = {"$ref": "#/components/schemas/ViewerMessage"}
    fits(said, message)
    assert not Draft202012Validator({**message, "components": DOCUMENT["components"]}).is_valid(
        said | {"kind": "tap"}
    )


def test_every_line_of_a_log_is_described() -> None:
    stage = Stage()
    role = load("walker-layers")
    assert isinstance(role, Role)
    actor = stage.add(role, (1, 2, 3), 0.5)
    for send in (stage.send, stage.hold, stage.release):
        send(actor, "GO")
    stage.set(actor, role.machine.parameters[0].name, 1.5)
    stage.travel(actor, role.machine.states[1])
    stage.edit(load("walker-layers", (MACHINES / "walker-layers" / "machine.yaml").read_text()), "text")
    stage.remove(actor)
    header, *lines = map(json.loads, stage.dump())
    fits(header, {"$ref": "#/components/schemas/LogHeader"})
    for line in lines:
        fits(line, {"$ref": "#/components/schemas/LogLine"})
    assert {line["kind"] for line in lines} == set(KINDS)

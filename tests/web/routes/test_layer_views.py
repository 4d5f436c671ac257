"""GET /api/machines/{name}: what the file says of states beside their names."""

from typing import Any

import httpx
import pytest
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
MACHINE = """
character: walker.glb
initial: CALM
fallback: CALM
defaults: {when: end, blend: {seconds: 0.4, curve: quintic}, buffer: 0.1}
parameters: {pace: {default: 1, min: 0, max: 2}}
properties: [FIGHT only after CALM]
states:
  CALM: {motion: stand, loop: true, speed: pace}
  RUN:
    motion: {over: pace, clips: {walk: 0.5, stand: 0}, markers: {walk: {right: 0.5, left: 0}}}
    loop: true
    speed: 1.5
    ground_speed: [-0.5, 2]
  FIGHT:
    resume: true
    machine: {initial: GUARD, states: {GUARD: {motion: stand, loop: true}}, table: "state | GO"}
table: |
  state | GO
  CALM  | FIGHT
  FIGHT | RUN
  RUN   | CALM
"""


@pytest.fixture
async def machine() -> dict[str, Any]:
    transport = httpx.ASGITransport(create_app(Settings(main_stage=False)))
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost") as client:
        answer = await client.put(
            "/api/machines/faq-walker", json={"text": MACHINE}, headers={"If-Match": '"1"'}
        )
        assert answer.is_success, answer.text
        got: dict[str, Any] = (await client.get("/api/machines/faq-walker")).json()
        return got


async def test_what_a_file_says_of_states_and_defaults_is_in_the_answer(machine: dict[str, Any]) -> None:
    calm, run, _ = machine["states"]
    assert (calm["speed"], run["speed"]) == ("pace", 1.5)
    assert (calm["ground_speed"], run["ground_speed"]) == (None, [-0.5, 2])
    assert (calm["points"], run["points"]) == ({}, {"walk": [0.5], "stand": [0.0]})
    assert machine["layers"][0]["composites"] == [
        {"name": "FIGHT", "initial": "FIGHT.GUARD", "resume": True, "outer": "", "final": False}
    ]
    assert machine["defaults"] == {"when": "end", "blend": 0.4, "curve": "quintic", "buffer": 0.1}
    assert (machine["fallback"], machine["properties"]) == ("CALM", ["FIGHT only after CALM"])


async def test_the_markers_of_a_blend_are_told_clip_by_clip_and_by_phase(machine: dict[str, Any]) -> None:
    calm, run, _ = machine["states"]
    assert calm["clip_markers"] == {}
    left, right = (
        {"name": name, "phase": phase, "written": True} for name, phase in (("left", 0), ("right", 0.5))
    )
    assert run["clip_markers"] == {"walk": [left, right], "stand": []}
    assert [marker["written"] for marker in run["markers"]] == [False, False]

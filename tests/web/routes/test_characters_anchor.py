"""A chain with its anchor at the end, and limits of a machine, over REST."""

import httpx
import numpy as np
import pytest
import statwalk

pytestmark = pytest.mark.anyio
PATH = "/api/characters/anchor-chain/solve"
CABLE = {"chain": ["Link01", "Crown"], "solver": "fabrik", "target": [0.5, 2.0, 0.3], "iterations": 100}


async def test_the_end_stays_and_the_root_moves(client: httpx.AsyncClient) -> None:
    character = statwalk.load("anchor-chain").character
    rest = character.world(character.bind_pose)[:, :3, 3]
    first, last = (character.skeleton.index(name) for name in CABLE["chain"])
    answer = (await client.post(PATH, json=CABLE | {"anchor": "Crown"})).json()
    assert answer["reached"] is True
    places = [joint["position"] for joint in answer["joints"]]
    np.testing.assert_allclose(places[-1], rest[last], atol=1e-5)
    np.testing.assert_allclose(places[0], CABLE["target"], atol=2e-4)
    np.testing.assert_allclose(np.array(answer["root"]) + rest[first], CABLE["target"], atol=2e-4)
    assert answer["clamped"] == {}


async def test_a_wrong_anchor_is_refused_with_its_ends(client: httpx.AsyncClient) -> None:
    answer = await client.post(PATH, json=CABLE | {"anchor": "Link03"})
    assert answer.status_code == 422
    assert "Link01 or Crown" in answer.text


async def test_a_machine_says_what_its_solvers_and_chains_are(client: httpx.AsyncClient) -> None:
    machine = (await client.get("/api/machines/anchor-chain")).json()
    drag, _, sail = machine["solvers"]
    assert (drag["target"], drag["weight"], drag["anchor"], drag["grab"]) == (
        "anchor",
        "held",
        "Link01",
        True,
    )
    assert (sail["start"], sail["end"], sail["anchor"]) == ("Link01", "Crown", "Crown")
    assert machine["chains"] == [{"name": "cable", "start": "Link01", "end": "Crown", "anchors": ["Link01"]}]
    hinge = (await client.get("/api/machines/joints.hinge")).json()
    (handle,) = [(one["joint"], one["freedom"], one["event"]) for one in hinge["parameters"]]
    assert handle == ("B", "angle", "TRY")


async def test_limits_of_a_machine_count_and_joints_may_be_elsewhere(client: httpx.AsyncClient) -> None:
    """The hinge of `joints.hinge` turns B about Z up to 80 degrees; its line of sight lies along X."""
    path = "/api/characters/hinge/solve"
    body = {
        "chain": ["B"],
        "solver": "look-at",
        "forward": [1, 0, 0],
        "target": [0.0, 1000.0, 0.0],
        "pose": {"translations": {"B": [0.0, 0.5, 0.0]}, "rotations": {"B": [0, 0, 0, 1]}},
    }
    free = (await client.post(path, json=body)).json()
    assert (free["reached"], free["clamped"]) == (True, {})
    held = (await client.post(path, json=body | {"machine": "joints.hinge"})).json()
    assert held["joints"][0]["rotation"] == pytest.approx([0, 0, 0.6428, 0.766], abs=1e-3)
    assert held["clamped"]["B"] == pytest.approx(10, abs=0.1)
    assert (await client.post(path, json=body | {"machine": "nothing"})).status_code in (404, 422)

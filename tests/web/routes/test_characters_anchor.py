"""A chain with its anchor at the end, over REST: the root moves, and the answer says where to."""

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

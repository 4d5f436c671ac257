"""Inverse kinematics over REST: the same numbers as from Python, and refusals that name the field."""

import httpx
import numpy as np
import pytest
import statwalk

pytestmark = pytest.mark.anyio
PATH = "/api/characters/walker/solve"
ARM = {"chain": ["Right.upperarm", "Right.lowerarm", "Right.hand"], "target": [-0.3, 1.2, 0.25]}


async def test_the_answer_is_that_of_python(client: httpx.AsyncClient) -> None:
    character = statwalk.load("faq-walker").character
    answer = character.solve(character.bind_pose, ARM["chain"], ARM["target"], pole=(0, 0, -1))
    body = (await client.post(PATH, json=ARM | {"pole": [0, 0, -1]})).json()
    assert (body["reached"], body["iterations"]) == (bool(answer.reached), 0)
    assert body["distance"] == pytest.approx(float(answer.distance), abs=1e-9)
    rows = [character.skeleton.index(joint["name"]) for joint in body["joints"]]
    np.testing.assert_array_equal([joint["rotation"] for joint in body["joints"]], answer.pose.rotation[rows])
    np.testing.assert_allclose(body["joints"][-1]["position"], ARM["target"], atol=1e-5)


async def test_a_pose_of_a_clip_is_solved(client: httpx.AsyncClient) -> None:
    body = ARM | {"solver": "ccd", "pose": {"clip": "walk", "time": 0.3}}
    answer = (await client.post(PATH, json=body)).json()
    assert answer["reached"] is True
    assert 1 <= answer["iterations"] <= 16


@pytest.mark.parametrize(
    ("changed", "status", "field"),
    [
        ({"solver": "ccd", "chain": ["Right.upperarm", "Nose"]}, 422, "joint"),
        ({"chain": ["Right.hand", "Right.lowerarm", "Right.upperarm"]}, 422, "chain"),
        ({"chain": ["Right.upperarm", "Right.hand"]}, 422, "chain"),
        ({"solver": "magic"}, 422, "solver"),
        ({"target": [0, 1]}, 422, "target.2"),
        ({"target": [0, 1, 1e9]}, 422, "target.2"),
        ({"weight": 1.5}, 422, "weight"),
        ({"pole": [0, 0, 1], "pole_point": [0, 0, 1]}, 422, "pole"),
        ({"rotation": [0, 0, 0, 0]}, 422, "rotation"),
        ({"solver": "ccd", "sensitivity": {"Head": 1}}, 422, "joint of the chain"),
        ({"solver": "ccd", "sensitivity": {"Right.hand": 2}}, 422, "sensitivity.Right.hand"),
        ({"solver": "ccd", "sensitivity": None}, 422, "sensitivity"),
        ({"pose": {"rotations": 1}}, 422, "pose.rotations"),
        ({"iterations": 0}, 422, "iterations"),
        ({"pose": {"clip": "SWIM"}}, 422, "clip"),
        ({"pose": {"rotations": {"Nose": [0, 0, 0, 1]}}}, 422, "joint"),
    ],
)
async def test_a_wrong_body_is_refused_with_the_field(
    client: httpx.AsyncClient, changed: dict[str, object], status: int, field: str
) -> None:
    answer = await client.post(PATH, json=ARM | changed)
    assert answer.status_code == status
    assert answer.json()["errors"][0]["field"] == field

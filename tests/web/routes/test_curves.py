"""Curves over REST: the samples are the product's own, SciPy says what they should be."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation, Slerp

pytestmark = pytest.mark.anyio

KEYS = [
    {"time": 0.0, "x_deg": 0.0, "y_deg": 0.0, "z_deg": 0.0},
    {"time": 0.5, "x_deg": 20.0, "y_deg": 40.0, "z_deg": 0.0, "weight": 4.0},
    {"time": 2.0, "x_deg": -30.0, "y_deg": 10.0, "z_deg": 30.0},
]


async def ask(client, interpolations, keys=KEYS, **more):
    return await client.post("/api/curves", json={"keys": keys, "interpolations": interpolations} | more)


async def test_slerp_is_scipys_at_constant_speed(client):
    answer = (await ask(client, ["slerp"])).json()
    (curve,) = answer["curves"]
    angles = np.array([[key["x_deg"], key["y_deg"], key["z_deg"]] for key in KEYS])
    keys = Rotation.from_euler("xyz", angles, degrees=True)
    expected = Slerp([0, 0.5, 2], keys)(answer["times"])
    assert (Rotation.from_quat(curve["rotations"]) * expected.inv()).magnitude().max() < 1e-6
    first = np.degrees((keys[0].inv() * keys[1]).magnitude()) / 0.5
    np.testing.assert_allclose(curve["speed_deg"][2:55], first, rtol=1e-3)
    np.testing.assert_allclose(curve["acceleration_deg"][2:55], 0, atol=2)


async def test_the_speed_of_slerp_jumps_at_a_key_and_dips_nowhere(client):
    curve = (await ask(client, ["slerp"])).json()["curves"][0]
    angles = np.array([[key["x_deg"], key["y_deg"], key["z_deg"]] for key in KEYS])
    turns = Rotation.from_euler("xyz", angles, degrees=True)
    ways = [np.degrees((turns[k].inv() * turns[k + 1]).magnitude()) for k in (0, 1)]
    expected = np.array([ways[0] / 0.5, ways[1] / 1.5])
    speeds = np.array(curve["speed_deg"])
    assert np.abs(speeds[:, None] - expected).min(1).max() < 1e-2


async def test_every_interpolation_begins_at_the_first_key_and_ends_at_the_last(client):
    names = ["euler linear", "linear", "slerp", "squad", "b-spline", "b-spline through", "nurbs"]
    curves = (await ask(client, names)).json()["curves"]
    assert [curve["interpolation"] for curve in curves] == names
    assert len({round(curve["angle_deg"][0], 3) for curve in curves}) == 1
    assert np.ptp([curve["angle_deg"][-1] for curve in curves]) < 1e-3


async def test_a_curve_that_cannot_be_says_why(client):
    keys = [{"time": float(k), "x_deg": 0.0, "y_deg": 170.0 * (k % 2), "z_deg": 0.0} for k in range(5)]
    bad, good = (await ask(client, ["b-spline through", "slerp"], keys)).json()["curves"]
    assert "add keys" in bad["refused"]
    assert good["refused"] is None


@pytest.mark.parametrize(
    ("keys", "interpolations", "status"),
    [
        (KEYS[::-1], ["slerp"], 422),
        (KEYS[:1], ["slerp"], 422),
        (KEYS, ["slurp"], 422),
        ([{**KEYS[0], "weight": 0.0}, KEYS[1]], ["nurbs"], 422),
    ],
)
async def test_wrong_keys_are_refused(client, keys, interpolations, status):
    assert (await ask(client, interpolations, keys)).status_code == status


async def test_twinning_of_a_clip(client):
    answer = (await client.get("/api/characters/walker/twinning", params={"clip": "crouch"})).json()
    assert answer["alone"] == []
    assert {"Left.upperleg"} <= {pair["left"] for pair in answer["pairs"] if pair["twinned"]}


async def test_the_path_of_a_joint(client):
    params = {"clip": "walk", "joint": "Left.foot"}
    answer = (await client.get("/api/characters/walker/path", params=params)).json()
    assert len(answer["times"]) == len(answer["positions"]) > 30
    refused = await client.get("/api/characters/walker/path", params=params | {"joint": "x"})
    assert refused.status_code == 422

"""What solvers clamped, over REST."""

from pathlib import Path

import httpx
import pytest
from statwalk.web.app import create_app
from statwalk.web.settings import Settings

pytestmark = pytest.mark.anyio
MACHINE = """character: leg.yaml
initial: REST
states: {REST: {motion: rest}}
parameters: {toe: {kind: point, default: [0, -2, 5]}}
solvers:
  kick: {solver: ccd, chain: [Thigh, Shin], target: toe, space: model}
table: |
  state | GO
  REST  | -
"""
CHARACTER = """skeleton: leg.txt
joints: {Thigh: {type: revolute, axis: [1, 0, 0], angle_deg: [-20, 20]}}
clips: {rest: {keys: rest.txt}}
"""


async def test_an_actor_says_by_what_its_joints_were_clamped(tmp_path: Path) -> None:
    (tmp_path / "leg.txt").write_text("Hips --- 0 0 -1 0\nThigh Hips 2 0 -1 0\nShin Thigh 2 0 -1 0\n")
    (tmp_path / "rest.txt").write_text("#time 0\n#rotate Thigh 0 0 0\n#time 1\n#rotate Thigh 0 0 0\n")
    (tmp_path / "leg.yaml").write_text(CHARACTER)
    (tmp_path / "machine.yaml").write_text(MACHINE)
    app = create_app(Settings(folders=(tmp_path,), main_stage=False))
    address = "http://localhost"
    async with httpx.AsyncClient(transport=httpx.ASGITransport(app), base_url=address) as client:
        body = {"clock": "manual", "actors": [{"machine": tmp_path.name}]}
        stage = (await client.post("/api/stages", json=body)).headers["Location"]
        await client.post(f"{stage}/step", json={"ticks": 2})
        (actor,) = (await client.get(stage)).json()["actors"]
    (clamped,) = actor["clamped"]
    # the thigh points down, 68.2 degrees away from the toe, and stops at 20
    assert (clamped["joint"], clamped["by"], clamped["distance"]) == ("Thigh", "solver", 0)
    assert clamped["angle_deg"] > 40

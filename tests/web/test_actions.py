"""Actions come once each, in order, to every viewer, whatever frames it misses."""

import shutil
from collections.abc import Iterator
from pathlib import Path

import httpx
import pytest
from paths import MACHINES
from serving import PATIENCE, serving
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from watcher import Watcher

MACHINE = """
semantics: 1
character: walker.glb
initial: STAND
states:
  STAND: {motion: stand, loop: true}
  WALK: {motion: walk, loop: true}
table: |
  state | GO   | HALT  | CALL
  STAND | WALK |       | STAND
  WALK  |      | STAND | WALK
cells:
  "*/CALL": {to: STAND, action: never}
  STAND/CALL: {to: STAND, action: call}
  STAND/GO: {to: WALK, action: start}
  WALK/HALT: {to: STAND, action: stop}
"""


@pytest.fixture
def address(tmp_path: Path) -> Iterator[str]:
    folder = tmp_path / "caller"
    folder.mkdir()
    shutil.copy(MACHINES / "faq-walker" / "walker.glb", folder)
    (folder / "machine.yaml").write_text(MACHINE)
    with serving(create_app(Settings(folders=(folder,), main_stage=False))) as address:
        yield address


def test_each_action_once_in_order(address: str) -> None:
    with httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        opened = rest.post(
            "/api/stages", json={"clock": "manual", "actors": [{"machine": "caller"}, {"machine": "caller"}]}
        )
        stage = opened.headers["Location"]
        with Watcher(address, stage) as keen, Watcher(address, stage, acknowledge=False) as slow:
            for event in ("CALL", "GO", "HALT", "CALL") * 5:
                rest.post(f"{stage}/events", json={"event": event})
                rest.post(f"{stage}/step", json={"ticks": 3})
            keen.frame_at(60)
            slow.say(type="ping")
            slow.text("pong")
        told = [[text for text in viewer.texts if text["type"] == "action"] for viewer in (keen, slow)]
    assert [action["seq"] for action in told[0]] == list(range(1, 41))
    assert [action["name"] for action in told[0] if action["actor"] == 1] == [
        "call",
        "start",
        "stop",
        "call",
    ] * 5
    assert told[0] == told[1]

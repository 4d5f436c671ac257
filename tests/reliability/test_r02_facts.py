"""R-02: a viewer whose connection was lost comes back, and has each action and each verdict once."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, NamedTuple

import httpx
import pytest
from serving import PATIENCE, serving
from statwalk.services.publish import outbox
from statwalk.web.app import create_app
from statwalk.web.settings import Settings
from watcher import Watcher

EVENTS = "FORWARD", "STOP", "JUMP", "CROUCH", "FORWARD", "LEFT"
Fact = dict[str, Any]


class Stage(NamedTuple):
    """A stage with a manual clock on a server that keeps it."""

    address: str
    path: str
    rest: httpx.Client

    def play(self) -> int:
        """Sends events, with steps between them; returns the tick of the newest verdict."""
        for event in EVENTS:
            self.rest.post(f"{self.path}/events", json={"event": event}).raise_for_status()
            self.rest.post(f"{self.path}/step", json={"ticks": 7}).raise_for_status()
        newest: int = self.since(0).raise_for_status().json()["verdicts"][-1]["tick"]
        return newest

    def since(self, tick: int) -> httpx.Response:
        return self.rest.get(f"{self.path}/facts", params={"since": tick})


@pytest.fixture(autouse=True)
def _patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """A viewer may not read for as long as a busy computer needs."""
    monkeypatch.setattr(outbox, "ACKNOWLEDGE_SECONDS", 3_600.0)


@contextmanager
def served(folder: Path) -> Iterator[tuple[str, httpx.Client]]:
    """A server in this process that keeps its stages in a folder."""
    app = create_app(Settings(kept=folder, main_stage=False))
    with serving(app) as address, httpx.Client(base_url=f"http://{address}", timeout=PATIENCE) as rest:
        yield address, rest


@contextmanager
def opened(folder: Path) -> Iterator[Stage]:
    with served(folder) as (address, rest):
        walker = {"clock": "manual", "actors": [{"machine": "faq-walker"}]}
        yield Stage(address, rest.post("/api/stages", json=walker).headers["location"], rest)


def facts_of(viewer: Watcher, until: int = 0) -> list[Fact]:
    """What a viewer has got; waits for the facts of a tick, which come after its frame."""
    while not (facts := [text for text in viewer.texts if text["type"] in ("action", "verdict")]) or (
        facts[-1]["tick"] < until
    ):
        if isinstance(message := viewer.receive(), bytes):
            viewer.acknowledged(message)
    return facts


def in_order(facts: list[Fact]) -> list[Fact]:
    """By tick; those of a tick as the server sends them, actions first."""
    return sorted(facts, key=lambda fact: (fact["tick"], fact["type"]))


def caught_up(stage: Stage, before: list[Fact], after: list[Fact]) -> list[Fact]:
    """What a viewer has that asks for the facts from the tick on of which it may have only a part."""
    newest = before[-1]["tick"]
    answer = stage.since(newest - 1).raise_for_status().json()
    return in_order(
        [fact for fact in before if fact["tick"] < newest]
        + answer["actions"]
        + answer["verdicts"]
        + [fact for fact in after if fact["tick"] > answer["tick"]]
    )


def test_r02_a_viewer_that_comes_back_has_each_fact_once(tmp_path: Path) -> None:
    with opened(tmp_path) as stage, Watcher(stage.address, stage.path) as faithful:
        with Watcher(stage.address, stage.path) as first:
            had = facts_of(first, stage.play())
        stage.play()
        with Watcher(stage.address, stage.path) as second:
            newest = stage.play()
            later = facts_of(second, newest)
        has, everything = caught_up(stage, had, later), in_order(facts_of(faithful, newest))
    assert len(everything) >= 3 * len(EVENTS)
    assert has == everything
    assert had + later != everything  # the control: without the facts in between


def test_r02_forgotten_facts_are_not_left_out_in_silence(tmp_path: Path) -> None:
    """After a start a stage remembers the facts since a snapshot."""
    with opened(tmp_path) as stage:
        stage.rest.post(f"{stage.path}/step", json={"ticks": 2_000}).raise_for_status()
        newest = stage.play()
        facts = stage.since(1_990).json()
    with served(tmp_path) as (address, rest):
        again = Stage(address, stage.path, rest)
        refused = again.since(0)
        assert refused.status_code == 409
        assert "after tick 1920; ask since 1920" in refused.json()["detail"]
        assert again.since(1_920).status_code == 200
        assert again.since(1_990).json() == facts
    assert facts["verdicts"][-1]["tick"] == newest

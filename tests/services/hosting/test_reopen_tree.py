"""After a start, stages still know their names, where they were forked, and the numbers of their inputs."""

import sqlite3
from pathlib import Path

import pytest
from keeping import keeping
from old_formats import to_format_3
from statwalk.services.hosting import stage_messages as ask
from statwalk.services.hosting.commands import AddActor, SendEvent, StageSetup
from statwalk.services.hosting.registry import Registry
from statwalk.services.hosting.reopen import reopen
from statwalk.services.hosting.stage_host import StageHost
from statwalk.services.hosting.stage_replies import PlaceInTree
from statwalk.services.hosting.store.database import FILE_NAME
from statwalk.services.hosting.store.records import MAIN
from statwalk.services.hosting.store.store import Store
from statwalk.services.library.catalogue import Catalogue

BEND = SendEvent("BEND", 1)


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue()


def opened(held: Registry) -> StageHost:
    """A stage with three inputs in four ticks."""
    host = held.open(StageSetup(clock="manual", actors=(AddActor("elbow"),), name="First"))
    for _ in range(2):
        host.handle(ask.Post((BEND,)))
        host.handle(ask.Step(2))
    return host


def place(host: StageHost) -> PlaceInTree:
    return host.handle(ask.Describe()).place


def test_a_tree_comes_back_as_it_was(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = opened(held)
        fork = held.find(host.handle(ask.Fork(3, "Second")))
        fork.handle(ask.Post((BEND,)))
        fork.handle(ask.Rename("Third"))
        before = {each.id: place(each) for each in held.all()}
    with keeping(tmp_path, catalogue) as held:
        assert {each.id: place(each) for each in held.all()} == before
    assert (before[fork.id].name, before[fork.id].inputs) == ("Third", 1)


def test_the_inputs_of_a_fork_are_counted_on_after_a_start(tmp_path: Path, catalogue: Catalogue) -> None:
    """It left before the newest input of its origin: its own log has fewer entries than its numbers say."""
    with keeping(tmp_path, catalogue) as held:
        fork = held.find(opened(held).handle(ask.Fork(1)))
    with keeping(tmp_path, catalogue) as held:
        again = held.find(fork.id)
        assert again.handle(ask.Post((BEND,))).seq == 4
        assert place(again).inputs == 1


def test_a_fork_knows_after_a_start_that_its_origin_was_deleted(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = opened(held)
        fork = held.find(host.handle(ask.Fork()))
        held.close(host.id)
    with keeping(tmp_path, catalogue) as held:
        origin = place(held.find(fork.id)).origin
    assert origin is not None
    assert (origin.stage, origin.tick, origin.is_there) == (host.id, 4, False)


def test_forks_of_main_follow_it_when_it_gets_another_id(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        fork = held.open_main().handle(ask.Fork())
    for _ in range(2):  # as it is read, and as it was written then
        with keeping(tmp_path, catalogue) as held:
            if MAIN in held.stages:
                held.stages.clear()
                reopen(held, "another scene")
            origin = place(held.find(fork)).origin
            assert origin is not None
            assert (origin.stage != MAIN, origin.is_there) == (True, True)


def test_forks_of_main_follow_it_before_the_disk_knows(
    tmp_path: Path, catalogue: Catalogue, monkeypatch: pytest.MonkeyPatch
) -> None:
    with keeping(tmp_path, catalogue) as held:
        fork = held.open_main().handle(ask.Fork())
    monkeypatch.setattr(Store, "rename", lambda *_: None)
    with keeping(tmp_path, catalogue) as held:
        held.stages.clear()
        reopen(held, "another scene")
        origin = place(held.find(fork)).origin
    assert origin is not None
    assert (origin.stage != MAIN, origin.is_there) == (True, True)


def test_what_waited_when_a_fork_was_made_is_not_its_own(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = opened(held)
        host.handle(ask.Post((BEND,)))
        fork = held.find(host.handle(ask.Fork()))
        found = [place(fork)]
    with keeping(tmp_path, catalogue) as held:
        found.append(place(held.find(fork.id)))
    assert [(each.inputs, each.newest_input) for each in found] == [(0, None)] * 2


def test_stages_of_format_3_come_up_without_names_and_origins(tmp_path: Path, catalogue: Catalogue) -> None:
    with keeping(tmp_path, catalogue) as held:
        host = opened(held)
    to_format_3(tmp_path / FILE_NAME)
    with keeping(tmp_path, catalogue) as held:
        found = place(held.find(host.id))
        held.find(host.id).handle(ask.Rename("Again"))
    assert (found.name, found.origin, found.made, found.inputs) == ("", None, None, 3)
    with keeping(tmp_path, catalogue) as held:
        assert place(held.find(host.id)).name == "Again"


@pytest.mark.parametrize(
    ("column", "change"),
    [
        ("name", "|| '1'"),
        ("parent", "|| '1'"),
        ("forked_tick", "+ 1"),
        ("forked_number", "+ 1"),
        ("made", "+ 1"),
    ],
)
def test_a_changed_name_or_origin_is_found(
    tmp_path: Path, catalogue: Catalogue, column: str, change: str
) -> None:
    with keeping(tmp_path, catalogue) as held:
        fork = opened(held).handle(ask.Fork())
    connection = sqlite3.connect(tmp_path / FILE_NAME)
    connection.execute(f"UPDATE stages SET {column} = {column} {change} WHERE id = ?", (fork,))
    connection.commit()
    connection.close()
    with keeping(tmp_path, catalogue) as held:
        assert "the row that says what it is is damaged" in held.left[fork]

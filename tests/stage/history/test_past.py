"""A stage forgets its oldest commands, and goes on as if it had not."""

import json

import pytest
from statwalk.errors import StageError
from statwalk.services.library.load import load, shipped_machines_folder
from statwalk.stage.history.snapshots import EVERY
from statwalk.stage.replay import replay
from statwalk.stage.stage import Stage

TEXT = (
    (shipped_machines_folder() / "faq-walker" / "machine.yaml")
    .read_text()
    .replace("STAT  | STWK ", "STAT  | CRCH ")
)
OLD, NEW = load("faq-walker"), load("faq-walker@2", TEXT)
EVENTS = "FORWARD", "STOP", "LEFT", "STOP"


def lived(seconds: int = 10) -> Stage:
    """A walker that gets an event every tenth of a second, and an edit of its machine after a second."""
    stage = Stage(seed=3)
    stage.add(OLD)
    for number in range(10 * seconds):
        stage.send(1, EVENTS[number % 4])
        stage.step(6)
        if number == 10:
            stage.edit(NEW, TEXT)
    return stage


@pytest.fixture
def short() -> Stage:
    stage = lived()
    assert stage.forget(50)
    return stage


def test_it_keeps_at_most_so_many_and_begins_with_a_snapshot(short: Stage) -> None:
    assert short.held <= 50
    assert short.first % EVERY == 0
    assert short.first == min(entry.tick for entry in lived().log[-short.held :]) // EVERY * EVERY


def test_it_forgets_no_more_than_it_must(short: Stage) -> None:
    assert sum(entry.tick > short.first - EVERY for entry in lived().log) > 50


def test_every_tick_that_is_left_is_as_it_was(short: Stage) -> None:
    whole = lived()
    for tick in (short.first, short.first + 1, short.head - 7, short.head):
        assert short.state_at(tick).hash == whole.state_at(tick).hash


def test_it_goes_on_as_a_stage_that_remembers_all(short: Stage) -> None:
    whole = lived()
    for stage in (whole, short):
        assert stage.send(1, "FORWARD").number == 103
        stage.step(90)
    assert short.hash == whole.hash


def test_a_tick_before_its_first_is_refused(short: Stage) -> None:
    with pytest.raises(StageError, match=f"tick 7 is not there: this stage has {short.first} … 600"):
        short.seek(7)


def test_a_seek_on_the_way_through_what_is_forgotten_is_refused() -> None:
    stage = lived()
    stage.step(1)
    way = stage.seeking(3 * EVERY - 1, most=1)
    next(way)
    stage.forget(0)
    with pytest.raises(StageError, match="is not there"):
        list(way)


def test_its_log_can_be_replayed_in_another_process(short: Stage) -> None:
    again = replay(short.dump(), load)
    assert (again.hash, again.first, again.newest) == (short.hash, short.first, short.newest)
    assert again.dump() == short.dump()


def test_numbers_go_on_although_nothing_is_left_of_the_log(short: Stage) -> None:
    short.step(2 * EVERY)
    short.forget(0)
    again = replay(short.dump(), load)
    assert (short.held, again.newest) == (0, 102)


def test_a_fork_has_what_its_origin_had_and_nothing_else(short: Stage) -> None:
    fork = short.fork_at(short.first + 30)
    assert fork.state_at(short.first).hash == short.state_at(short.first).hash
    short.step(3 * EVERY)
    first = fork.first
    short.forget(0)
    assert (fork.first, fork.state_at(first).tick) == (first, first)
    with pytest.raises(StageError):
        fork.seek(first - 1)


def test_a_fork_keeps_entries_that_its_origin_forgets() -> None:
    stage = lived()
    fork, before = stage.fork(), stage.dump()
    stage.forget(10)
    assert fork.dump() == before
    assert len(stage.dump()) < len(before)


def test_it_still_knows_its_actors(short: Stage) -> None:
    short.add(short.role("faq-walker"))
    arrivals = short.arrivals()
    assert arrivals[1] == (None, "faq-walker@2")
    assert arrivals[2] == (short.head, "faq-walker@2")


def test_it_forgets_more_as_it_goes_on(short: Stage) -> None:
    first = short.first
    for number in range(60):
        short.send(1, EVENTS[number % 4])
        short.step(6)
    assert short.forget(50)
    assert short.first > first
    assert replay(short.dump(), load).hash == short.hash


def test_a_stage_without_a_snapshot_forgets_nothing() -> None:
    stage = lived(0)
    stage.send(1, "FORWARD")
    assert not stage.forget(0)
    assert stage.held == 2


@pytest.mark.parametrize(
    ("beginning", "message"),
    [
        (None, "line 1: a beginning has a state"),
        ({"state": "?", "texts": {}, "number": 1}, "line 1: the state of the beginning is no base64"),
        ({"state": "", "texts": {}, "number": -1}, "line 1: a beginning has a state"),
        ({"state": "", "texts": {"tiny": 1}, "number": 1}, "line 1: a beginning has a state"),
        ({"state": "", "texts": {}, "number": 1}, "these bytes hold no stage"),
    ],
)
def test_a_beginning_that_cannot_be_read_is_refused(beginning: object, message: str) -> None:
    header = json.dumps({"statwalk": "log", "semantics": 1, "beginning": beginning})
    with pytest.raises(StageError, match=message):
        replay([header], load)


def test_a_log_that_begins_later_says_so(short: Stage) -> None:
    with pytest.raises(StageError, match=f"begins at tick {short.first}, not 5"):
        replay(short.dump(), load, until=5)

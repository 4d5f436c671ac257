"""A part of a stage's past has its ticks again in another process."""

import pickle

import pytest
from builders import role
from statwalk.errors import StageError
from statwalk.stage.excerpt import excerpt, stage_of, work_of
from statwalk.stage.stage import Stage

ROLE = role()


@pytest.fixture(scope="module")
def stage() -> Stage:
    """GO at tick 11; a second actor at 301; HOP at 400; 600 ticks."""
    stage = Stage(seed=3)
    actor = stage.add(ROLE)
    stage.step(10)
    stage.send(actor, "GO")
    stage.step(290)
    stage.add(ROLE)
    stage.step(99)
    stage.send(actor, "HOP")
    stage.step(201)
    return stage


def hashes(stage: Stage, ticks: range) -> list[str]:
    found = []
    for tick in ticks:
        stage.seek(tick)
        found.append(stage.hash)
    return found


@pytest.mark.parametrize(
    "ticks", [range(31), range(5, 30), range(295, 310), range(390, 405), range(580, 601)]
)
def test_its_states_are_the_states_of_the_stage(stage: Stage, ticks: range) -> None:
    sent = pickle.loads(pickle.dumps(excerpt(stage, ticks[0], ticks[-1])))
    assert hashes(stage_of(sent), ticks) == hashes(stage, ticks)


def test_it_ends_with_its_last_tick(stage: Stage) -> None:
    with pytest.raises(StageError, match="tick 401 is not there"):
        stage_of(excerpt(stage, 300, 400)).seek(401)


@pytest.mark.parametrize(("first", "last", "work"), [(590, 600, 2 * 60), (295, 310, 2 * 70)])
def test_its_work_is_what_is_computed(stage: Stage, first: int, last: int, work: int) -> None:
    """From the state that is kept every second, for each actor; the second one comes at tick 301."""
    assert work_of(stage, first, last) == work


def test_a_tick_that_is_not_there_is_refused(stage: Stage) -> None:
    with pytest.raises(StageError, match="tick 601 is not there"):
        work_of(stage, 590, 601)

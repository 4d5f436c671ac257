"""A long way through time lets others in: the lock of a stage is free between slices."""

import threading

import pytest
from statwalk.loading import load
from statwalk.stage.past.timeline import SLICE
from statwalk.stage.stage import Stage
from statwalk.web.keeping.catalogue import Catalogue
from statwalk.web.keeping.hosted import HostedStage

TICKS = 20 * SLICE


@pytest.fixture(scope="module")
def hosted():
    stage = Stage()
    stage.add(load("faq-walker"))
    return HostedStage("one", stage, "manual", Catalogue())


def turns_of_another(hosted, work):
    """The ticks at which somebody else had the stage while `work` was done in a thread of its own."""
    seen = set()
    worker = threading.Thread(target=work)
    worker.start()
    while worker.is_alive():
        with hosted.turn() as stage:
            seen.add(stage.tick)
    worker.join()
    return seen


def test_many_steps_are_seen_on_their_way(hosted):
    seen = turns_of_another(hosted, lambda: hosted.step(TICKS))
    assert hosted.stage.tick == TICKS
    assert any(0 < tick < TICKS for tick in seen)
    assert all(tick % SLICE == 0 for tick in seen)


def test_a_long_seek_moves_the_playhead_once(hosted):
    hosted.stage.seek(hosted.stage.head)
    before = hosted.stage.head
    seen = turns_of_another(hosted, lambda: hosted.seek(7))
    assert seen <= {before, 7}
    assert hosted.stage.tick == 7

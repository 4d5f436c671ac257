"""SM5: an action tied to a state change reaches whoever listens, once each, in order; and again when the past
is played again.
"""

import pytest
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage


@pytest.fixture(scope="module")
def walker():
    return load("faq-walker")


def jumps(stage, actor, ticks):
    """The actions of all ticks, while the actor walks and jumps whenever it can."""
    heard = []
    stage.hold(actor, "FORWARD")
    for _ in range(ticks):
        if actor.state == "WALK":
            stage.send(actor, "JUMP")
        stage.step(1)
        heard += stage.frame.actions
    return heard


def test_each_comes_out_once_and_in_order(walker):
    stage = Stage(seed=1)
    heard = jumps(stage, stage.add(walker), 900)
    names = [action.name for action in heard]
    assert len(names) >= 4
    assert names == [("jump", "land")[number % 2] for number in range(len(names))]
    assert [action.seq for action in heard] == list(range(1, len(heard) + 1))
    assert [action.tick for action in heard] == sorted({action.tick for action in heard})


def test_an_action_says_whose_it_is(walker):
    stage = Stage(seed=1)
    stage.add(walker)
    second = stage.add(walker)
    assert {action.actor for action in jumps(stage, second, 300)} == {second.id}


def test_the_same_ticks_bring_the_same_actions(walker):
    stage = Stage(seed=1)
    heard = jumps(stage, stage.add(walker), 300)
    again = []
    for tick in range(1, 301):
        stage.seek(tick)
        again += stage.frame.actions
    assert again == heard


def test_no_action_without_the_change(walker):
    stage = Stage(seed=1)
    actor = stage.add(walker)
    stage.send(actor, "JUMP")  # standing: the cell is -
    stage.step(30)
    assert (actor.state, stage.frame.actions) == ("STAT", ())

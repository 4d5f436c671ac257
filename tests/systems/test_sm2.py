"""SM2: events are the inputs of FAQ Q19 and the end of a motion; the control pad, held and released, walks
the character about.
"""

import math

import pytest
from statwalk.errors import UnknownNameError
from statwalk.services.library.load import load
from statwalk.stage.stage import Stage

RATE = 60


@pytest.fixture(scope="module")
def walker():
    return load("faq-walker")


def ticks(walker, state):
    """The ticks that a state's motion takes, by hand: its seconds, to the next whole tick."""
    machine = walker.machine
    return math.ceil(round(float(machine.duration[machine.states.index(state)]) * RATE, 3))


@pytest.fixture
def stage():
    return Stage(seed=1, rate=RATE)


def test_the_columns(walker):
    assert walker.machine.events == ("FORWARD", "LEFT", "RIGHT", "STOP", "JUMP", "CROUCH", "END")


def test_up_held_walks_and_released_stops(walker, stage):
    actor = stage.add(walker)
    stage.hold(actor, "FORWARD")
    stage.step(1)
    assert actor.state == "STWK"
    stage.step(ticks(walker, "STWK") - 1)
    assert actor.state == "STWK"
    stage.step(1)
    assert actor.state == "WALK"
    stage.step(3 * ticks(walker, "WALK"))
    assert actor.state == "WALK"
    stage.release(actor, "FORWARD")
    stage.send(actor, "STOP")
    stage.step(1)
    assert actor.state == "CSTP"
    stage.step(RATE)
    assert actor.state == "STAT"


@pytest.mark.parametrize(("event", "state", "sign"), [("LEFT", "TLFT", 1), ("RIGHT", "TRGT", -1)])
def test_a_tap_turns_once_the_way_the_key_says(walker, stage, event, state, sign):
    actor = stage.add(walker)
    stage.hold(actor, event)
    stage.step(5)
    stage.release(actor, event)
    stage.step(RATE - 5)  # on the spot it takes a second
    assert actor.state == state
    stage.step(2)
    assert actor.state == "STAT"
    assert actor.root[1] * sign > math.radians(20)  # about +Y: to the left is positive


def test_the_ends_of_motions_carry_a_jump_through(walker, stage):
    actor = stage.add(walker)
    stage.hold(actor, "FORWARD")
    stage.step(ticks(walker, "STWK") + 10)
    stage.send(actor, "JUMP")
    seen = []
    for _ in range(6 * RATE):
        stage.step(1)
        if not seen or seen[-1] != actor.state:
            seen.append(actor.state)
    assert seen[:8] == [
        "JUMP",
        "FLY",
        "LAND",
        "CRCH",
        "STUP",
        "STAT",
        "STWK",
        "WALK",
    ]  # the key is still down


def test_a_jump_asked_for_a_little_early_waits_for_the_walk(walker, stage):
    actor = stage.add(walker)
    stage.hold(actor, "FORWARD")
    stage.step(ticks(walker, "STWK") - 5)
    stage.send(actor, "JUMP")
    stage.step(6)
    assert actor.state == "WALK"
    stage.step(1)
    assert actor.state == "JUMP"


def test_crouch_lasts_as_long_as_its_key(walker, stage):
    actor = stage.add(walker)
    stage.hold(actor, "CROUCH")
    stage.step(5 * RATE)
    assert actor.state == "CRCH"
    stage.release(actor, "CROUCH")
    stage.step(ticks(walker, "CRCH") + 1)
    assert actor.state == "STUP"


def test_a_jump_means_nothing_to_one_who_stands(walker, stage):
    actor = stage.add(walker)
    stage.send(actor, "JUMP")
    stage.step(1)
    assert [(one.event, one.verdict, one.reason) for one in stage.frame.verdicts] == [
        ("JUMP", "dropped", "the cell is -")
    ]


def test_an_event_that_does_not_exist_is_refused(walker, stage):
    with pytest.raises(UnknownNameError, match="did you mean FORWARD"):
        stage.send(stage.add(walker), "FORWARDS")

"""Trials show what a stage shows."""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.errors import CancelledError
from statwalk.services.library.load import load_role
from statwalk.stage.measure.alone import motion_alone
from statwalk.stage.measure.measured_ground import Spot
from statwalk.stage.measure.trials import NEVER, WARM_UP, CellTrial, placed, record
from statwalk.stage.stage import Stage

WALKER = load_role(MACHINES / "faq-walker")
STATES, EVENTS = WALKER.machine.states, WALKER.machine.events
STAT, WALK, FORWARD, STOP = (
    STATES.index("STAT"),
    STATES.index("WALK"),
    EVENTS.index("FORWARD"),
    EVENTS.index("STOP"),
)


def on_stage(events, ticks):
    """(T, J, 3) the joints of an actor that gets events (tick -> name) on a stage."""
    stage, shown = Stage(), []
    actor = stage.add(WALKER)
    for tick in range(ticks):
        frame = stage.frame.casts[0]
        world = WALKER.character.world(frame.pose)[..., :3, 3].astype(float)
        shown.append(placed(world, frame.root_position, frame.heading)[0])
        if tick in events:
            stage.send(actor, events[tick])
        stage.step()
    return np.array(shown)


def test_a_trial_shows_what_a_stage_shows():
    """STAT begins at 0; after the warm-up it gets FORWARD, and STOP 20 ticks later."""
    duration = WALKER.machine.duration[STAT]
    trial = CellTrial(STAT, WARM_UP / 60 / duration, FORWARD, 20, STOP)
    recording = record(WALKER, [trial, CellTrial(STAT, 0.5)], 60)
    wanted = on_stage({WARM_UP: "FORWARD", WARM_UP + 20: "STOP"}, 60)
    assert recording.sent[0] == WARM_UP
    assert np.abs(recording.joints[:, 0] - wanted).max() < 1e-5
    assert [STATES[row] for row in recording.state[[WARM_UP, WARM_UP + 1, WARM_UP + 21], 0, 0]] == [
        "STAT",
        "STWK",
        "CSTP",
    ]
    assert recording.event[WARM_UP + 1, 0, 0] == FORWARD
    assert (recording.event[:, 1] == NEVER).all()


def test_a_motion_goes_on_as_it_is_by_itself():
    recording = record(WALKER, [CellTrial(WALK, 0.3)], 40)
    still = recording.joints[:, 0] - recording.joints[0, 0, 0] * [1, 0, 1]
    steps = np.linalg.norm(np.diff(still, axis=0), axis=-1)
    alone = np.linalg.norm(np.diff(motion_alone(WALKER, WALK, 0.0), axis=0), axis=-1)
    assert steps.max() == pytest.approx(alone.max(), rel=0.1)


def test_a_trial_is_the_same_in_a_crowd():
    alone = record(WALKER, [CellTrial(WALK, 0.3, STOP)], 40)
    crowd = record(WALKER, [CellTrial(WALK, phase, STOP) for phase in (0, 0.1, 0.2, 0.3)], 40)
    assert np.array_equal(alone.joints[:, 0], crowd.joints[:, 3])


def test_a_trial_begins_at_its_place_and_is_the_same_there():
    here, there = CellTrial(WALK, 0.3), CellTrial(WALK, 0.3, place=Spot(2, 3, np.pi))
    recording = record(WALKER, [here, there], 40)
    turned = recording.joints[:, 0] * [-1, 1, -1] + [2, 0, 3]
    assert np.abs(recording.joints[:, 1] - turned).max() < 1e-4


def test_recording_can_be_cancelled():
    def cancel():
        raise CancelledError("enough")

    with pytest.raises(CancelledError):
        record(WALKER, [CellTrial(WALK, 0.0)], 40, cancel)

"""Each cell of the corrected table (FAQ Q19), reached by the shipped walker at the tick worked out by hand
from the clips' durations.
"""

import pytest
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

WALKER = load_role(MACHINES / "faq-walker")
LASTS = {
    state: round(float(seconds) * 60)
    for state, seconds in zip(WALKER.machine.states, WALKER.machine.duration, strict=True)
}
LASTS |= {"TLFT": 60, "TRGT": 60, "CRCH": 5, "STUP": 18}  # on the spot; after a landing
SENT = 90  # the tick in which the event of a cell counts, unless the state is over sooner

WALK = 1 + LASTS["STWK"]  # FORWARD counts in tick 1; STWK plays once
JUMP = SENT
FLY = JUMP + LASTS["JUMP"]
LAND = FLY + LASTS["FLY"]
CRCH = LAND + LASTS["LAND"]
STUP = CRCH + LASTS["CRCH"]
WALKING, JUMPING = {1: "FORWARD"}, {1: "FORWARD", JUMP: "JUMP"}
TURNING = {"TLFT": {30: "LEFT"}, "TRGT": {30: "RIGHT"}}
TURNED = 30 + LASTS["TLFT"]

# state, what brings the actor there, event and the tick it counts in, the tick of the answer, and the answer
CELLS = [
    ("STAT", {}, ("FORWARD", SENT), SENT, "STWK"),
    ("STAT", {}, ("LEFT", SENT), SENT, "TLFT"),
    ("STAT", {}, ("RIGHT", SENT), SENT, "TRGT"),
    ("STAT", {}, ("STOP", SENT), SENT, "STAT"),
    ("STAT", {}, ("JUMP", SENT), SENT, "STAT"),
    ("STAT", {}, ("CROUCH", SENT), SENT, "CRCH"),
    ("STWK", WALKING, ("FORWARD", 20), 20, "STWK"),
    ("STWK", WALKING, ("STOP", 20), 20, "CSTP"),
    ("STWK", WALKING, None, WALK, "WALK"),
    ("WALK", WALKING, ("FORWARD", SENT), SENT, "WALK"),
    ("WALK", WALKING, ("LEFT", SENT), SENT, "TLFT"),
    ("WALK", WALKING, ("RIGHT", SENT), SENT, "TRGT"),
    ("WALK", WALKING, ("STOP", SENT), SENT, "CSTP"),
    ("WALK", WALKING, ("JUMP", SENT), SENT, "JUMP"),
    ("CSTP", {1: "FORWARD", 20: "STOP"}, ("STOP", 40), 40, "CSTP"),
    ("CSTP", {1: "FORWARD", 20: "STOP"}, None, 20 + LASTS["CSTP"], "STAT"),
    ("TLFT", TURNING["TLFT"], ("FORWARD", 50), TURNED, "WALK"),
    ("TLFT", TURNING["TLFT"], ("LEFT", 50), TURNED, "TLFT"),
    ("TLFT", TURNING["TLFT"], ("RIGHT", 50), 50, "TRGT"),
    ("TLFT", TURNING["TLFT"], ("STOP", 50), 50, "CSTP"),
    ("TLFT", TURNING["TLFT"], None, TURNED, "STAT"),
    ("TRGT", TURNING["TRGT"], ("FORWARD", 50), TURNED, "WALK"),
    ("TRGT", TURNING["TRGT"], ("LEFT", 50), 50, "TLFT"),
    ("TRGT", TURNING["TRGT"], ("RIGHT", 50), TURNED, "TRGT"),
    ("TRGT", TURNING["TRGT"], ("STOP", 50), 50, "CSTP"),
    ("TRGT", TURNING["TRGT"], None, TURNED, "STAT"),
    ("JUMP", JUMPING, None, FLY, "FLY"),
    ("FLY", JUMPING, None, LAND, "LAND"),
    ("LAND", JUMPING, None, CRCH, "CRCH"),
    ("CRCH", JUMPING, None, STUP, "STUP"),
    ("CRCH", JUMPING, ("CROUCH", CRCH + 3), STUP, "CRCH"),
    ("STUP", JUMPING, None, STUP + LASTS["STUP"], "STAT"),
]


@pytest.mark.parametrize(("state", "path", "event", "tick", "answer"), CELLS)
def test_a_cell_answers_in_its_tick(state, path, event, tick, answer):
    """In the tick before the answer the actor is in the row's state; in the tick of the answer, in the
    cell's.
    """
    stage = Stage()
    actor = stage.add(WALKER)
    inputs = path | ({event[1]: event[0]} if event else {})
    states = {}
    for now in range(1, tick + 1):
        if now in inputs:
            stage.send(actor, inputs[now])
        stage.step()
        states[now] = actor.state
    assert (states[tick - 1], states[tick]) == (state, answer)


def test_a_cell_that_restarts_begins_its_motion_again():
    stage = Stage()
    actor = stage.add(WALKER)
    stage.send(actor, "LEFT")
    stage.step(20)
    stage.send(actor, "LEFT")
    stage.step(1 + LASTS["TLFT"] - 20)
    assert (actor.state, actor.time) == ("TLFT", pytest.approx(0, abs=1e-6))


def test_he_stands_two_seconds_after_a_stop_at_any_moment():
    stage = Stage()
    actors = [stage.add(WALKER) for _ in range(120)]
    for actor in actors:
        stage.send(actor, "FORWARD")
    for actor in actors:
        stage.step()
        stage.send(actor, "STOP")
    stage.step(120)
    assert [actor.state for actor in actors] == ["STAT"] * len(actors)


def test_every_row_was_tried():
    assert {cell[0] for cell in CELLS} == set(WALKER.machine.states)


def test_actions_come_once_in_order():
    stage = Stage()
    actor = stage.add(WALKER)
    for now in range(1, LAND + 60):
        if now in JUMPING:
            stage.send(actor, JUMPING[now])
        stage.step()
    assert [(action.seq, action.tick, action.name) for action in stage.actions] == [
        (1, JUMP, "jump"),
        (2, LAND, "land"),
    ]


def test_a_landing_gives_control_back_within_half_a_second():
    stage = Stage()
    actor = stage.add(WALKER)
    for now in range(1, LAND + 31):
        if now in JUMPING:
            stage.send(actor, JUMPING[now])
        if now == FLY + 5:
            stage.hold(actor, "FORWARD")
        stage.step()
    assert actor.state == "STWK"

"""Curves of the shipped walker: LEFT or RIGHT early in a stride leads round by a useful amount."""

import numpy as np
import pytest
from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.stage.stage import Stage

WALKER = load_role(MACHINES / "faq-walker")
STATES = WALKER.machine.states
WALKS = 100
"""tick from which on he walks"""
PHASES = np.linspace(0, 0.5, 6)


def tap(event, phase, is_held):
    """The states that follow a tap of LEFT or RIGHT at a phase of the walk, and by how many degrees he turns;
    FORWARD is pressed once, or held.
    """
    stage, states, tapped = Stage(), [], None
    actor = stage.add(WALKER)
    (stage.hold if is_held else stage.send)(actor, "FORWARD")
    for tick in range(WALKS + 260):
        cast = stage.frame.casts[0]
        state = STATES[cast.state[0, 0]]
        if tapped is None and tick > WALKS and 0 <= cast.phase[0, 0] - phase < 0.02:
            stage.send(actor, event)
            tapped = float(cast.heading[0])
        if tapped is not None and (not states or states[-1] != state):
            states.append(state)
        stage.step()
    return states, np.degrees(float(stage.frame.casts[0].heading[0]) - tapped)


@pytest.mark.parametrize("phase", PHASES)
@pytest.mark.parametrize(("event", "turn", "way"), [("LEFT", "TLFT", 1), ("RIGHT", "TRGT", -1)])
def test_a_tap_leads_round_a_curve_and_the_walk_goes_on(event, turn, way, phase):
    states, turned = tap(event, phase, True)
    assert set(states) == {"WALK", turn}
    assert states[-1] == "WALK"
    assert 25 < way * turned < 110


@pytest.mark.parametrize(("event", "turn", "way"), [("LEFT", "TLFT", 1), ("RIGHT", "TRGT", -1)])
def test_a_curve_that_nobody_continues_ends_standing(event, turn, way):
    states, turned = tap(event, 0.1, False)
    assert states[1:] == [turn, "STAT"]
    assert 25 < way * turned < 110


def test_who_turns_on_the_spot_takes_no_last_step():
    stage, states = Stage(), set()
    actor = stage.add(WALKER)
    stage.send(actor, "LEFT")
    for _ in range(120):
        stage.step()
        states.add(STATES[stage.frame.casts[0].state[0, 0]])
    assert states == {"TLFT", "STAT"}

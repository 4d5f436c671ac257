"""SM4, no jumps (FAQ Q19): on the tiny character, from every phase, through interruptions, position and
velocity are continuous.

Continuity is measured by looking closer: with four times as many ticks a second, what changes from tick to
tick shrinks to a quarter; a jump does not. The law over the shipped walker is tests/machines/test_no_jump.py.
"""

import numpy as np
import pytest
from builders import role
from statwalk.machine.definition.cell_definition import CellDefinition
from statwalk.stage.stage import Stage

ROLE = role()
LESS = (
    0.3,
    0.45,
)  # position, velocity: a quarter, and room for the ticks not falling on the same moments; a jump gives 1
CUT = role(name="cut", cells={("STAND", "GO"): CellDefinition("WALK", 1, blend=0.0)})


def hand(role_of, rate, events):
    """(T, 3) on the stage, the arm's end, half a metre from its joint; `events` by the seconds after which
    they are sent.
    """
    stage = Stage(rate=rate)
    actor = stage.add(role_of)
    track = []
    for now in range(3 * rate):
        for event in (name for seconds, name in events.items() if round(seconds * rate) == now):
            stage.send(actor, event)
        stage.step()
        joint = actor.world[2]
        track.append(joint[:3, 3] - 0.5 * joint[:3, 1])
    return np.array(track)


def shrinks(role_of, events):
    """How the largest change of position, and of velocity, from tick to tick shrinks from 60 to 240 ticks a
    second.
    """
    most = []
    for rate in (60, 240):
        track = hand(role_of, rate, events)
        most.append(
            [
                np.linalg.norm(np.diff(track, order, axis=0), axis=-1).max() * rate ** (order - 1)
                for order in (1, 2)
            ]
        )
    return np.array(most[1]) / most[0]


@pytest.mark.parametrize("phase", np.linspace(0.1, 1.9, 10))
def test_no_jump_from_any_phase(phase):
    assert (shrinks(ROLE, {phase: "GO"}) < LESS).all()


@pytest.mark.parametrize("later", [0.05, 0.1, 0.15])
def test_no_jump_when_a_transition_is_interrupted(later):
    assert (shrinks(ROLE, {0.5: "GO", 0.5 + later: "TURN", 0.5 + 2 * later: "HOP"}) < LESS).all()


def test_a_cut_is_a_jump():
    assert (shrinks(CUT, {0.5: "GO"}) > 0.6).any()

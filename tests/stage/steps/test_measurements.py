"""What machines are told of how their actors move: the tiny character walks 1.5 m/s and turns 90° to the left
in a second.
"""

import numpy as np
import pytest
from builders import role
from statwalk.stage.stage import Stage
from statwalk.stage.steps.measurements import surroundings
from statwalk.stage.steps.memory import Memory

DT = 1 / 60


def told(stage, seed=0):
    """What the machines of the stage's only cast are told."""
    (cast,) = stage.casts
    return surroundings(cast, Memory(cast.role, len(cast.ids)), DT, seed).values


def measured(event, ticks=40, **place):
    stage = Stage()
    actor = stage.add(role(), **place)
    stage.send(actor, event)
    stage.step(ticks)
    return told(stage).measured[:, 0]


def test_speed_along_the_ground():
    assert measured("GO", heading=2.0)[:2] == pytest.approx([1.5, 0], abs=1e-6)


def test_turning_to_the_left():
    assert measured("TURN")[:2] == pytest.approx([0, np.pi / 2], abs=1e-3)


def test_height_is_that_of_the_root_joint_over_the_place():
    assert measured("GO", position=(0, 3, 0))[2] == pytest.approx(4)


def test_without_a_root_joint_it_is_that_of_the_place():
    stage = Stage()
    stage.add(role(root=None), position=(0, 3, 0))
    assert told(stage).measured[2, 0] == 3


def test_the_chance_of_actors_differs():
    stage = Stage()
    shared = role()
    for _ in range(5):
        stage.add(shared)
    assert len(set(told(stage, seed=7).key.tolist())) == 5

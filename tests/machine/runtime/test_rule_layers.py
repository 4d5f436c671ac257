"""Layers ("A state's motion"): several tables side by side on one actor, each with its own queue, END and
verdicts.
"""

import numpy as np
import pytest
from statwalk.machine.compile.compile_machine import BLANK
from ticking import Ticking, built

FILE = """
character: c.glb
initial: stand
states:
  stand: {motion: stand, loop: true}
  walk: {motion: walk, loop: true}
table: |
  state | GO | STOP | WAVE | CLAP | END
  stand | walk | - | | |
  walk | walk | stand | | |
parameters: {arm: {default: 0.5, min: 0, max: 1}}
layers:
  arms:
    mask: [Spine]
    weight: arm
    initial: REST
    states:
      REST: {motion: none}
      WAVE: {motion: wave}
    table: |
      state | WAVE | STOP | END
      REST | WAVE | |
      WAVE | WAVE! at end | REST | REST
  face:
    mode: additive
    initial: CALM
    states:
      CALM: {motion: none}
      GRIN: {motion: grin}
    table: |
      state | WAVE | END
      CALM | GRIN |
      GRIN | | CALM
"""
TICKS = {"stand": 20, "walk": 10, "wave": 6, "grin": 4}


def actor_of(*events):
    actor = Ticking.of(FILE, TICKS)
    for event in events:
        actor.step(event)
    return actor


def test_all_layers_stand_in_one_table():
    machine = built(FILE, TICKS)
    assert machine.states == ("stand", "walk", "REST", "WAVE", "CALM", "GRIN")
    assert (machine.layer_of.tolist(), machine.initials) == ([0, 0, 1, 1, 2, 2], (0, 2, 4))
    assert [list(machine.rows(layer)) for layer in range(3)] == [[0, 1], [2, 3], [4, 5]]
    assert machine.target[4].tolist() == [BLANK, BLANK, 5, BLANK, BLANK]


def test_what_a_layer_is():
    base, arms, face = built(FILE, TICKS).layers
    assert (base.name, arms.mask, arms.mode, arms.weight_parameter) == ("base", ("Spine",), "override", 0)
    assert (face.mask, face.mode, face.weight, face.weight_parameter) == ((), "additive", 1.0, -1)


def test_every_layer_has_its_initial_state():
    assert actor_of().states == ["stand", "REST", "CALM"]


def test_an_event_goes_to_the_layers_that_it_concerns():
    actor = actor_of("GO")
    assert actor.states == ["walk", "REST", "CALM"]
    actor.step("WAVE")
    assert actor.states == ["walk", "WAVE", "GRIN"]
    assert [(one.layer, actor.machine.states[one.to_state]) for one in actor.verdicts] == [
        (1, "WAVE"),
        (2, "GRIN"),
    ]


def test_to_all_of_them_if_there_are_several():
    actor = actor_of("GO", "WAVE", "STOP")
    assert actor.states == ["stand", "REST", "GRIN"]


def test_one_that_concerns_nobody_goes_to_the_base():
    actor = actor_of("CLAP")
    assert [(one.layer, one.reason) for one in actor.verdicts] == [
        (0, "the cell is blank; it waits for 0.3 s")
    ]


def test_each_layer_has_its_own_end():
    actor = actor_of("WAVE")
    actor.run(4)
    assert actor.states == ["stand", "WAVE", "CALM"]  # grin takes 4 ticks
    actor.run(2)
    assert actor.states == ["stand", "REST", "CALM"]


def test_and_its_own_queue():
    actor = actor_of("WAVE", "WAVE")
    assert actor.memory.waiting_event[0, :, 0].tolist() == [-1, 2, 2]  # at end in the arms, blank in the grin
    actor.run(5)
    assert actor.last.changes.layer.tolist() == [1]


def test_a_motion_that_is_none_has_no_markers():
    text = FILE.replace("CALM: {motion: none}", "CALM: {motion: none, markers: {start: 0}}")
    assert built(text, TICKS).markers[4] == ()


def test_a_motion_that_is_none_has_no_end():
    actor = actor_of()
    actor.run(100)
    assert actor.memory.ended.tolist() == [[0, 0, 0]]


def test_a_held_input_counts_in_each_layer_that_it_concerns_and_in_no_other():
    actor = actor_of("+WAVE")
    actor.run(6)
    assert (actor.states, actor.last.changes.restart.tolist()) == (["stand", "WAVE", "GRIN"], [True])
    assert actor.memory.waiting_event[0, 0].max() == -1
    actor.step("-WAVE")
    assert actor.memory.held.tolist() == [[0] * 5]
    actor.run(6)
    assert actor.states == ["stand", "REST", "CALM"]


@pytest.mark.parametrize("events", [(), ("GO",), ("WAVE", "GO", "STOP", "+WAVE", "-WAVE")])
def test_the_base_does_the_same_without_the_others(events):
    alone = Ticking.of(FILE.partition("layers:")[0], TICKS)
    both = actor_of(*events)
    for event in events:
        alone.step(event)
    for _ in range(30):
        assert both.step() == alone.step()
        assert both.memory.time[0, 0] == alone.memory.time[0, 0]


def test_arrays_have_an_axis_of_layers():
    memory = actor_of("WAVE").memory
    assert memory.state.shape == memory.time.shape == memory.waiting.shape == (1, 3)
    assert np.isfinite(memory.time).all()

"""Entry values ("A state's motion"): a motion may be blended over a value of the tick before its state was
entered, kept until the state is left.
"""

import numpy as np
import pytest
from machine_texts import ROBOT
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.stage.migrate.map_states import remap
from ticking import Ticking, built

TICKS = {"stand": 20, "walk": 40, "slow": 10, "quick": 10}
TEXT = """character: c.glb
initial: stand
states:
  stand: {motion: stand, loop: true}
  walk: {motion: walk, loop: true}
  STOP: {motion: {over: [entry phase, entry speed], clips: {slow: [0, 0], quick: [1, 2]}}}
table: |
  state | GO   | HALT  | END
  stand | walk | STOP  |
  walk  |      | STOP  |
  STOP  |      | STOP! | stand
"""


def actor_of(text=TEXT):
    return Ticking.of(text, TICKS)


def kept(actor):
    return actor.memory.smoothed[0].tolist()


def test_a_machine_says_what_its_columns_are():
    machine = built(TEXT, TICKS)
    assert machine.entry_values == ((2, "entry phase"), (2, "entry speed"))
    assert machine.axes == (("base", "STOP", "entry phase"), ("base", "STOP", "entry speed"))
    assert (machine.program.entry_state.tolist(), machine.program.entry_kind.tolist()) == ([2, 2], [3, 0])


@pytest.mark.parametrize(("ticks", "phase"), [(4, 0.125), (30, 0.775)])
def test_phase_and_speed_are_those_at_the_entry(ticks, phase):
    """GO counts in the first tick; HALT after `ticks` more finds walk one tick further of 40."""
    actor = actor_of()
    actor.step("GO")
    actor.run(ticks)
    actor.measure(speed=1.5)
    actor.step("HALT")
    assert kept(actor) == pytest.approx([phase, 1.5])


def test_they_are_kept_through_a_restart_until_the_state_is_left():
    actor = actor_of()
    actor.measure(speed=1.5)
    actor.run(9)
    actor.step("HALT")
    actor.measure(speed=0.25)
    actor.step("HALT")
    assert kept(actor) == pytest.approx([0.5, 1.5])
    assert actor.run(10) == "stand"
    actor.step("HALT")
    assert kept(actor)[1] == 0.25


def test_they_survive_an_edit():
    old = built(TEXT, TICKS)
    new = built(TEXT.replace("[entry phase, entry speed]", "[entry time, entry speed]"), TICKS)
    actor = actor_of()
    actor.measure(speed=1.5)
    actor.step("HALT")
    mapped = remap(old, new, actor.memory).state
    assert np.array_equal(mapped.smoothed, [[0, 1.5]])


def test_a_name_that_is_neither_is_refused_with_the_nearest():
    text = ROBOT.replace("motion: walk", "motion: {over: entry sped, clips: {walk: 0, stand: 1}}")
    with pytest.raises(MachineError, match="entry speed"):
        read_machine(text)

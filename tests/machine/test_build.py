"""From the authored machine to arrays: END is the last column; names that do not exist are refused or kept as what they are."""

import numpy as np
import pytest
from statwalk.errors import MachineError
from statwalk.files.machinefile import read_machine
from statwalk.machine.build import AT_END, BLANK, NOW, OFF, UNDEFINED, MotionFacts, build
from ticking import machine_of, text_of

TABLE = "state | GO | STOP | END\nA | B! at end | - | Z\nb | | A |"
TICKS = {"A": 30, "b": 60}
MORE = "cells: {b/STOP: {blend: 0.5, action: bow}}\nevents: {GO: {buffer: 1}}\n"


def test_the_table_is_an_integer_array():
    machine = machine_of(TABLE, TICKS, MORE)
    assert machine.events == ("GO", "STOP", "END")
    assert machine.target.tolist() == [[UNDEFINED, OFF, UNDEFINED], [BLANK, 0, BLANK]]
    assert machine.undefined == {(0, 0): "B", (0, 2): "Z"}
    assert machine.target.dtype == np.int16


def test_what_else_the_cells_say():
    machine = machine_of(TABLE, TICKS, MORE)
    assert (machine.when[0, 0], machine.when[1, 1], bool(machine.restart[0, 0])) == (AT_END, NOW, True)
    assert (float(machine.blend[1, 1]), str(machine.actions[machine.action[1, 1]])) == (0.5, "bow")
    assert machine.buffer.tolist() == pytest.approx([1, 0.3, 0])


def test_motions():
    machine = machine_of(TABLE, TICKS, MORE)
    assert (machine.loop.tolist(), machine.duration.tolist()) == ([False, True], [0.5, 1.0])
    assert [machine.motions[row] for row in machine.motion] == ["A", "b"]


def test_a_motion_says_itself_whether_it_loops_where_the_state_does_not():
    definition = read_machine(text_of(TABLE, TICKS).replace(", loop: false", ""))
    assert build(definition, {"A": MotionFacts(1, loop=True), "b": MotionFacts(1)}).loop.tolist() == [True, True]


def test_an_unknown_motion_names_the_nearest():
    with pytest.raises(MachineError, match=r"machine.yaml, line 4: the state A has no motion 'A'; did you mean AA\?"):
        build(read_machine(text_of(TABLE, TICKS)), {"AA": MotionFacts(1), "b": MotionFacts(1)})


def test_an_unknown_parameter_is_refused():
    text = text_of(TABLE, TICKS, "parameters: {pace: {default: 1, min: 0, max: 2}}").replace("loop: false", "speed: pase")
    with pytest.raises(MachineError, match=r"no parameter 'pase'; did you mean pace\?"):
        build(read_machine(text), {"A": MotionFacts(1), "b": MotionFacts(1)})


@pytest.mark.parametrize("bounds", ["min: -1, max: 2", "min: 0, max: 101"])
def test_a_parameter_that_is_a_speed_keeps_to_what_a_speed_may_be(bounds):
    text = text_of(TABLE, TICKS, f"parameters: {{pace: {{default: 1, {bounds}}}}}").replace("loop: false", "speed: pace")
    with pytest.raises(MachineError, match=r"line 10: pace is the speed of A, so it must stay in 0 … 100"):
        build(read_machine(text), {"A": MotionFacts(1), "b": MotionFacts(1)})

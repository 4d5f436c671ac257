"""From the authored machine to arrays: END is the last column; names that do not exist are refused or kept as
what they are.
"""

import numpy as np
import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import (
    AT_END,
    AT_MARKER,
    BLANK,
    NOW,
    OFF,
    UNDEFINED,
    MotionFacts,
    build,
)
from ticking import built, machine_of, text_of

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
    (to_b,), (to_a,) = machine.alternatives[0, 0], machine.alternatives[1, 1]
    assert (machine.when[0, 0], machine.when[1, 1], to_b.restart) == (AT_END, NOW, True)
    assert (to_a.blend, str(machine.actions[to_a.action])) == (0.5, "bow")
    assert machine.buffer.tolist() == pytest.approx([1, 0.3, 0])


def test_motions():
    machine = machine_of(TABLE, TICKS, MORE)
    assert (machine.loop.tolist(), machine.duration.tolist()) == ([False, True], [0.5, 1.0])
    assert [machine.motions[row] for row in machine.motion] == ["A", "b"]


def test_a_motion_says_itself_whether_it_loops_where_the_state_does_not():
    definition = read_machine(text_of(TABLE, TICKS).replace(", loop: false", ""))
    assert build(definition, {"A": MotionFacts(1, loop=True), "b": MotionFacts(1)}).loop.tolist() == [
        True,
        True,
    ]


def test_an_unknown_motion_names_the_nearest():
    with pytest.raises(
        MachineError, match=r"machine.yaml, line 4: the state A has no motion 'A'; did you mean AA\?"
    ):
        build(read_machine(text_of(TABLE, TICKS)), {"AA": MotionFacts(1), "b": MotionFacts(1)})


def test_an_unknown_parameter_is_refused():
    text = text_of(TABLE, TICKS, "parameters: {pace: {default: 1, min: 0, max: 2}}").replace(
        "loop: false", "speed: pase"
    )
    with pytest.raises(MachineError, match=r"no parameter 'pase'; did you mean pace\?"):
        build(read_machine(text), {"A": MotionFacts(1), "b": MotionFacts(1)})


@pytest.mark.parametrize("bounds", ["min: -1, max: 2", "min: 0, max: 101"])
def test_a_parameter_that_is_a_speed_keeps_to_what_a_speed_may_be(bounds):
    text = text_of(TABLE, TICKS, f"parameters: {{pace: {{default: 1, {bounds}}}}}").replace(
        "loop: false", "speed: pace"
    )
    with pytest.raises(MachineError, match=r"line 10: pace is the speed of A, so it must stay in 0 … 100"):
        build(read_machine(text), {"A": MotionFacts(1), "b": MotionFacts(1)})


@pytest.mark.parametrize(
    ("more", "message"),
    [
        (
            "cells: {b/STOP: {when: marker lef}}\n",
            r"line 9: the motion of b has no marker 'lef'; did you mean left\? There are: left",
        ),
        ("cells: {b/STOP: [{if: pase > 1, to: A}]}\n", r"line 10: .*no name is called 'pase'"),
    ],
)
def test_markers_and_conditions_that_do_not_exist_are_refused(more, message):
    with pytest.raises(MachineError, match=message):
        machine_of(TABLE, TICKS, more, {"b": {"left": 6}})


def test_a_default_may_name_a_marker_that_not_all_motions_have():
    machine = machine_of(TABLE, TICKS, 'cells: {"*/GO": {to: A, when: marker left}}\n', {"b": {"left": 6}})
    assert (machine.when[1, 0], machine.timings[1, 0].marker, machine.markers) == (
        AT_MARKER,
        "left",
        ((), (("left", 0.1),)),
    )


def test_markers_of_the_state_take_the_place_of_those_of_the_clip():
    text = text_of(TABLE, TICKS).replace("motion: b,", "motion: b, markers: {left: 0.5, more: 0.2},")
    assert built(text, TICKS, {"b": {"left": 6, "right": 30}}).markers[1] == (
        ("more", 0.2),
        ("left", 0.5),
        ("right", 0.5),
    )


BLEND = """
character: c.glb
initial: MOVE
states: {MOVE: {motion: {over: pace, clips: {walk: 1, run: 3}}, loop: true}}
parameters: {pace: {default: 1, min: 0, max: 4}}
table: |
  state | GO
  MOVE | MOVE
"""


def test_a_blend_lasts_as_long_as_its_longest_clip():
    machine = built(BLEND, {"walk": 60, "run": 30})
    assert (machine.duration.tolist(), machine.motions, machine.motion.tolist()) == (
        [1.0],
        ("walk", "run"),
        [0],
    )
    assert machine.blends[0].over == ("pace",)


def test_cells_know_where_they_are_written():
    machine = machine_of(TABLE, TICKS, 'cells: {"*/STOP": {to: A}, "b/*": {to: A}}\n')
    assert (machine.sources[0, 1], machine.sources[1, 0]) == (("A", "STOP"), ("b", "*"))


def test_what_conditions_may_ask_for_is_the_parameters_and_what_is_measured():
    machine = machine_of("state | GO\na | a", {"a": 9}, "parameters: {speed: {default: 0, min: 0, max: 1}}\n")
    assert machine.variables == ("speed", "turning", "height", "phase", "time")

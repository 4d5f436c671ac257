"""Layers: their joints, mode, weight, states and tables; what a blend, a marker and a smooth parameter
say.
"""

import pytest
from statwalk.errors import MachineError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.definition.machine_definition import NO_MOTION, BlendDefinition

TEXT = """character: c.glb
initial: MOVE
parameters:
  pace: {default: 1, min: 0, max: 4, smooth: 0.25}
  side: {default: 0, min: -1, max: 1}
  arms: {default: 1, min: 0, max: 1}
states:
  MOVE: {motion: {over: pace, clips: {walk: 1.4, run: 3.2}}, markers: {left-down: 0.05}}
  DRIFT: {motion: {over: [pace, side], clips: {walk: [1, 0], strafe: [1, 1]}}}
table: |
  state | GO    | STOP
  MOVE  | DRIFT |
layers:
  arms:
    mask: [Spine, Hand]
    mode: additive
    weight: arms
    initial: REST
    states: {REST: {motion: none}, WAVE: {motion: wave}}
    table: |
      state | WAVE | STOP
      REST  | WAVE |
      WAVE  |      | REST
  legs:
    initial: REST
    states: {REST: {motion: none}}
    cells: {REST/GO: {to: REST!}}
"""


def test_a_layer():
    arms = read_machine(TEXT).layers["arms"]
    assert (arms.mask, arms.mode, arms.weight, arms.initial, arms.line) == (
        ("Spine", "Hand"),
        "additive",
        "arms",
        "REST",
        15,
    )
    assert arms.states["REST"].motion == NO_MOTION
    assert arms.cells["REST", "WAVE"].to == "WAVE"
    assert arms.rows[0] == ("state", "WAVE", "STOP")


def test_a_layer_needs_only_states():
    legs = read_machine(TEXT).layers["legs"]
    assert (legs.mask, legs.mode, legs.weight, legs.rows) == ((), "override", 1.0, ())
    assert legs.cells["REST", "GO"].restart


def test_layers_share_the_events():
    machine = read_machine(TEXT)
    assert list(machine.events) == ["GO", "STOP", "WAVE"]
    assert list(machine.tables()) == ["base", "arms", "legs"]
    assert machine.tables()["arms"].columns == ("GO", "STOP", "WAVE", "END")


def test_blends_over_one_and_two_parameters():
    states = read_machine(TEXT).states
    assert states["MOVE"].motion == BlendDefinition(("pace",), {"walk": (1.4,), "run": (3.2,)}, 8)
    assert states["DRIFT"].motion == BlendDefinition(("pace", "side"), {"walk": (1, 0), "strafe": (1, 1)}, 9)


def test_clips_of_a_blend_have_markers_of_their_own():
    said = "run: 3.2}, markers: {walk: {left: 0.1, right: 0.6}, run: {left: 0.2}}}"
    motion = read_machine(TEXT.replace("run: 3.2}}", said)).states["MOVE"].motion
    assert motion.markers == {"walk": {"left": 0.1, "right": 0.6}, "run": {"left": 0.2}}


def test_markers_and_smooth_parameters():
    machine = read_machine(TEXT)
    assert (machine.states["MOVE"].markers, machine.parameters["pace"].smooth) == ({"left-down": 0.05}, 0.25)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("weight: arms", "weight: arm", "line 17: no parameter is called 'arm'; did you mean arms?"),
        ("weight: arms", "weight: side", "line 17: side is the weight of a layer, so it must stay in 0 … 1"),
        ("weight: arms", "weight: 2", "line 17: '2' is not a finite number from 0 to 1"),
        ("mode: additive", "mode: additiv", "line 16: no mode is called 'additiv'; did you mean additive?"),
        ("[Spine, Hand]", "Spine", "line 15: a list is needed here"),
        ("[Spine, Hand]", "[]", "line 15: a mask has 1 to 1,024 joints"),
        ("      WAVE  |  ", "      WAIVE |  ", "line 23: no state is called 'WAIVE'; did you mean WAVE?"),
        ("REST/GO", "REST/GOO", "line 27: no event is called 'GOO'; did you mean GO?"),
        (
            "run: 3.2}}",
            "run: 3.2}, markers: {rum: {}}}",
            "line 8: no clip of the blend is called 'rum'; did you mean run?",
        ),
        ("[1, 1]", "[1]", "line 9: the clip strafe needs 2 numbers, one for each parameter"),
        (
            "over: [pace, side]",
            "over: [pace, pace]",
            "line 9: a blend is over one parameter, or over two different parameters",
        ),
        ("smooth: 0.25", "smooth: -1", "line 4: '-1' is not a finite number from 0 to 60"),
    ],
)
def test_what_is_wrong_with_a_layer(old, new, message):
    assert old in TEXT
    with pytest.raises(MachineError) as caught:
        read_machine(TEXT.replace(old, new, 1))
    assert message in str(caught.value)

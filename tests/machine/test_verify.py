"""What is found in a table without running it."""

from lint_findings import found
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.machine.compile.compile_machine import MotionFacts
from statwalk.machine.verify import verify


def test_nothing_is_wrong_with_a_table_where_nothing_is_wrong():
    assert found("state | GO | END\nA | B | \nB | | A") == []


LAYERS = """character: c.glb
initial: A
states: {A: {motion: a}}
table: |
  state | WAVE | NOD
  A     |      |
parameters: {arm: {default: 1, min: 0, max: 1}}
layers:
  arms:
    weight: arm
    initial: REST
    states: {REST: {motion: none}, WAVE: {motion: wave}, LOST: {motion: wave}}
    table: |
      state | WAVE | END
      REST  | WAVE | WAVE
      WAVE  |      | REST
      LOST  |      | REST
"""


def test_layers_have_findings_of_their_own():
    findings = verify(read_machine(LAYERS), {"a": MotionFacts(1), "wave": MotionFacts(1)})
    assert [(one.kind, one.layer, one.message) for one in findings] == [
        ("unreachable state", "arms", "layer arms: LOST cannot be reached from REST"),
        (
            "cell never fires",
            "arms",
            "layer arms: REST/END never fires: REST has no motion, so it has no end",
        ),
        ("unused event", "", "no cell answers NOD"),
    ]

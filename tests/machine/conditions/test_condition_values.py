"""Each name is read from its own place: what the stage measured, what the machine knows, a parameter."""

import pytest
from statwalk.machine.conditions.variables import NAMES
from ticking import DT, Ticking

TICKS = {"stat": 8}
AFTER_TWO_TICKS = {"speed": 1.5, "turning": -2.0, "height": 3.0, "phase": 2 / 8, "time": 2 * DT}


def read(name, more=""):
    """The value of a name that a condition reads in the third tick."""
    table, cell = "state | GO\nstat | ", f"cells:\n  stat/GO: [{{if: {name} > 99, to: stat!}}]\n"
    actor = Ticking(table, TICKS, cell + more)
    actor.measure(speed=1.5, turning=-2.0, height=3.0)
    actor.run(2)
    actor.step("GO")
    (verdict,) = actor.verdicts
    return dict(verdict.values)[name]


@pytest.mark.parametrize("name", NAMES)
def test_a_name_reads_its_own_value(name):
    assert read(name) == pytest.approx(AFTER_TWO_TICKS[name])


def test_a_parameter_of_the_same_name_is_read_instead():
    assert read("speed", "parameters: {speed: {default: 7, min: 0, max: 9}}\n") == 7

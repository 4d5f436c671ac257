"""The variables of conditions: parameters first, each name once."""

from statwalk.machine.conditions.variables import NAMES, variables_of


def test_parameters_come_first():
    assert variables_of(["stamina", "fear"]) == ("stamina", "fear", *NAMES)


def test_a_parameter_hides_the_value_of_its_name():
    assert variables_of(["time"]) == ("time", *(name for name in NAMES if name != "time"))

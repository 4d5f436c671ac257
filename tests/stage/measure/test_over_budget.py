"""Findings about figures over their budgets."""

from statwalk.machine.definition.budgets_definition import BudgetDefinition
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.stage.measure.figures import Figure
from statwalk.stage.measure.measure import Measured
from statwalk.stage.measure.over_budget import over_budget

ROW = Measured(
    "WALK",
    "STOP",
    "",
    27,
    10,
    {"slide": Figure(0.294, 0.826, 0.3, "", "LEFT", 5), "sink": Figure(0, 0.001, 0.0)},
)


def findings(**budgets):
    limits = {name: BudgetDefinition(most, 1) for name, most in budgets.items()}
    definition = MachineDefinition("walker", {}, "STAT", budgets=limits)
    return list(over_budget(definition, [ROW]))


def test_what_is_over_its_budget_is_a_warning_with_the_place():
    (finding,) = findings(slide=0.015, sink=0.005)
    words = "WALK/STOP: slide 826 mm at phase 0.3, then LEFT after 5 ticks; the budget is 15 mm"
    assert (finding.message, finding.line, finding.state, finding.event) == (words, 27, "WALK", "STOP")


def test_within_the_budgets_and_without_there_is_no_finding():
    assert findings(slide=1.0) == findings() == []

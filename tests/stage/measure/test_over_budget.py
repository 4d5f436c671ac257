"""Findings about figures over their budgets."""

import numpy as np
from statwalk.machine.definition.budgets_definition import BudgetDefinition
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.machine.definition.machine_definition import MachineDefinition
from statwalk.stage.measure.figures import Figure
from statwalk.stage.measure.measure import Measured
from statwalk.stage.measure.measured_ground import Spot
from statwalk.stage.measure.over_budget import over_budget

ROW = Measured(
    "WALK",
    "STOP",
    "",
    27,
    10,
    {"slide": Figure(0.294, 0.826, 0.3, "", "LEFT", 5, Spot(0, 1.65, np.pi)), "sink": Figure(0, 0.001, 0.0)},
)


def findings(ground=(), **budgets):
    limits = {name: BudgetDefinition(most, 1) for name, most in budgets.items()}
    definition = MachineDefinition("walker", {}, "STAT", budgets=limits, ground=ground)
    return list(over_budget(definition, [ROW]))


def test_what_is_over_its_budget_is_a_warning_with_the_place():
    (finding,) = findings(slide=0.015, sink=0.005)
    words = "WALK/STOP: slide 826 mm at phase 0.3, then LEFT after 5 ticks; the budget is 15 mm"
    assert (finding.message, finding.line, finding.state, finding.event) == (words, 27, "WALK", "STOP")


def test_on_uneven_ground_it_says_where_the_trial_began():
    (finding,) = findings((GroundDefinition((-1, 1.5), (1, 1.8), 0.12, 1),), slide=0.015)
    assert "after 5 ticks, from x 0, z 1.65, heading 180°; the budget" in finding.message


def test_within_the_budgets_and_without_there_is_no_finding():
    assert findings(slide=1.0) == findings() == []

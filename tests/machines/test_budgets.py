"""faq-walker keeps the budgets that its file names, in every cell."""

from paths import MACHINES
from statwalk.services.library.load import load_role
from statwalk.services.library.measuring import measured
from statwalk.stage.measure.over_budget import over_budget

WALKER = load_role(MACHINES / "faq-walker")


def test_every_cell_keeps_the_budgets_of_the_file() -> None:
    budgets = WALKER.definition.budgets
    assert {name: budget.most for name, budget in budgets.items()} == {
        **{"jump": 1.2, "joint": 2.4, "slide": 0.015, "sink": 0.005},
        **{"hover": 0.05, "knee": 0.002, "hand": 60.0},
    }
    figures = measured(WALKER)
    assert len(figures) == 37
    assert [finding.message for finding in over_budget(WALKER.definition, figures)] == []

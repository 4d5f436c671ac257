"""The solvers of a role: what is forgotten when a pose offset takes over."""

from __future__ import annotations

import numpy as np
from paths import MACHINES
from statwalk.character.solvers import forget_feet
from statwalk.services.library.load import load_role
from statwalk.solve.foot_tables import DROP, LOWEST_X, OF_ACTOR, OF_FOOT, PIVOT_X, YAW, X, Y

WALKER = load_role(MACHINES / "faq-walker")


def test_feet_are_forgotten_only_in_the_rows_that_begin() -> None:
    memory = WALKER.solver_memory.fresh(3) + np.arange(WALKER.solver_memory.size) + 1.0
    after = forget_feet(WALKER.solvers, memory, np.array([1]))
    assert (after[[0, 2]] == memory[[0, 2]]).all()
    foot = OF_ACTOR + OF_FOOT
    assert after[1, [DROP, foot + X, foot + Y]].tolist() == [0, 0, 0]


def test_where_a_foot_stands_is_kept() -> None:
    memory = WALKER.solver_memory.fresh(1) + np.arange(WALKER.solver_memory.size) + 1.0
    after = forget_feet(WALKER.solvers, memory, np.array([0]))
    assert after[0, OF_ACTOR + PIVOT_X] == memory[0, OF_ACTOR + PIVOT_X]
    assert after[0, OF_ACTOR + YAW] == memory[0, OF_ACTOR + YAW]
    assert after[0, OF_ACTOR + LOWEST_X] == memory[0, OF_ACTOR + LOWEST_X] + memory[0, OF_ACTOR + X]

"""Programs: the same for one as among many, finite whatever comes in, and their functions against the
standard library's.
"""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy_formula import evaluate as slow_evaluate
from statwalk.maths.formula.operations import FUNCTIONS
from statwalk.maths.formula.parser import parse

LOGIC = {
    **{f"a {sign} b": 2 for sign in ("<", "<=", ">", ">=", "==", "!=", "and", "or")},
    "not a": 1,
    "-a": 1,
    "pow(a, 3) - b / 7 > c and not (a < b or c % 2 == 1)": 3,
}
EDGES = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    1e-300,
    -1e-300,
    5e-324,
    1e300,
    -1e300,
    710.0,
    -750.0,
    64.0,
    65.0,
    math.pi,
    1e15,
    1e22,
]
SAID = {
    "a / b": 2,
    "a % b": 2,
    "a * b": 2,
    "a + b": 2,
    "a - b": 2,
    **{f"{name}({', '.join('abc'[: one.takes])})": one.takes for name, one in FUNCTIONS.items()},
}


def grid(count: int) -> np.ndarray:
    """(3, N) all pairs (triples, thinned) of edges."""
    first = np.array(np.meshgrid(*[EDGES] * min(count, 2))).reshape(min(count, 2), -1)
    return np.concatenate([first, np.tile(first[:1], (3 - len(first), 1))])


@pytest.mark.parametrize(("text", "takes"), SAID.items())
def test_everything_is_finite(text: str, takes: int) -> None:
    assert np.isfinite(parse(text, ("a", "b", "c")).evaluate(grid(takes))).all()


@pytest.mark.parametrize("given", [math.nan, math.inf, -math.inf])
def test_what_is_not_finite_stays_outside(given: float) -> None:
    assert np.isfinite(parse("a * 2 + 1", ("a",)).evaluate(np.array([[given]]))).all()


@pytest.mark.parametrize(("text", "takes"), SAID.items())
def test_one_is_as_among_many(text: str, takes: int) -> None:
    program, values = parse(text, ("a", "b", "c")), np.random.default_rng(3).normal(0, 20, (3, 37))
    together = program.evaluate(values)
    alone = [program.evaluate(values[:, i : i + 1])[0] for i in range(37)]
    assert together.tolist() == alone


@pytest.mark.parametrize(
    "text", ["1 / 0", "1 % 0", "sqrt(-1)", "log(0)", "log(-1)", "pow(-2, 0.5)", "pow(0, -1)"]
)
def test_what_has_no_value_is_0(text: str) -> None:
    assert parse(text, ()).evaluate(np.zeros((0, 1)))[0] == 0


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("sin", -100, 100),
        ("cos", -100, 100),
        ("tan", -1.5, 1.5),
        ("exp", -600, 600),
        ("log", 1e-9, 1e9),
        ("sqrt", 0, 1e9),
    ],
)
def test_functions_are_those_of_the_standard_library(name: str, low: float, high: float) -> None:
    x = np.random.default_rng(5).uniform(low, high, 1000)
    ours = parse(f"{name}(x)", ("x",)).evaluate(x[None])
    assert ours == pytest.approx([getattr(math, name)(one) for one in x], rel=1e-13, abs=1e-14)


def test_powers() -> None:
    chance = np.random.default_rng(6)
    base, exponent = chance.uniform(0, 9, 500), chance.uniform(-9, 9, 500)
    ours = parse("pow(a, b)", ("a", "b")).evaluate(np.array([base, exponent]))
    assert ours == pytest.approx([math.pow(a, b) for a, b in zip(base, exponent, strict=True)], rel=1e-12)


@pytest.mark.parametrize(("text", "takes"), {**SAID, **LOGIC}.items())
def test_every_operation_gives_the_bits_of_the_same_in_numpy(text: str, takes: int) -> None:
    formula = parse(text, ("a", "b", "c"))
    values = np.concatenate([grid(takes), np.random.default_rng(4).normal(0, 20, (3, 500))], 1)
    assert formula.evaluate(values).tolist() == slow_evaluate(formula, values).tolist()


def test_variables_in_the_order_of_the_text() -> None:
    assert parse("b > a + b", ("a", "b", "c")).variables == ("b", "a")

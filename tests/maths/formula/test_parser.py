"""Conditions against Python's own arithmetic, and what is refused."""

from __future__ import annotations

import math
import random

import numpy as np
import pytest
from statwalk.maths.formula.operations import FUNCTIONS, OPERATORS
from statwalk.maths.formula.parser import parse
from statwalk.maths.formula.tokens import ConditionError

KNOWN = ("stamina", "speed", "x")


def value(text: str, **given: float) -> float:
    values = np.array([[given.get(name, 0.0)] for name in KNOWN])
    return float(parse(text, KNOWN).evaluate(values)[0])


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        ("1 + 2 * 3", 7),
        ("(1 + 2) * 3", 9),
        ("10 - 4 - 3", 3),
        ("24 / 4 / 3", 2),
        ("-2 * 3", -6),
        ("2 - -3", 5),
        ("- -3", 3),
        ("7 % 4", 3),
        ("-7 % 4", 1),
        ("not 0", 1),
        ("not 1 or 1", 1),
        ("not (1 or 1)", 0),
        ("not 1 > 2", 1),
        ("1 or 1 and 0", 1),
        ("(1 or 1) and 0", 0),
        ("1 + 1 > 1 and 2 <= 2", 1),
        ("3 != 3", 0),
        ("true and not false", 1),
        ("min(3, 2) + max(3, 2)", 5),
        ("clamp(9, 0, 5)", 5),
        ("lerp(2, 4, 0.25)", 2.5),
        ("if(2 > 1, 10, 20)", 10),
        ("pow(2, 10)", 1024),
        ("pow(2, -1)", 0.5),
        ("sign(-3) + abs(-3) + floor(1.7) + ceil(1.2)", 5),
        ("1.5e2", 150),
        (".5 + 1.", 1.5),
    ],
)
def test_what_it_comes_to(text: str, answer: float) -> None:
    assert value(text) == answer


def written(chance: random.Random, depth: int) -> str:
    """An expression that means the same in Python."""
    if depth == 0 or chance.random() < 0.2:
        return chance.choice(
            ["stamina", "speed", "x", f"{chance.uniform(0, 9):.2f}", str(chance.randrange(10))]
        )
    if chance.random() < 0.2:
        return (
            f"-{written(chance, depth - 1)}" if chance.random() < 0.5 else f"({written(chance, depth - 1)})"
        )
    sign = chance.choice(["+", "-", "*"])
    return f"{written(chance, depth - 1)} {sign} {written(chance, depth - 1)}"


@pytest.mark.parametrize("seed", range(200))
def test_arithmetic_is_pythons(seed: int) -> None:
    chance = random.Random(seed)
    text = written(chance, 4)
    given = {name: chance.uniform(-5, 5) for name in KNOWN}
    assert value(text, **given) == eval(text, {"__builtins__": {}}, given)


@pytest.mark.parametrize("seed", range(100))
def test_logic_is_pythons(seed: int) -> None:
    chance = random.Random(seed)
    terms = [
        f"{name} {chance.choice(['<', '<=', '>', '>=', '==', '!='])} {chance.randrange(-2, 3)}"
        for name in KNOWN
    ]
    joined = [chance.choice(["", "not "]) + term for term in terms]
    text = (
        f"{joined[0]} {chance.choice(['and', 'or'])} {joined[1]} {chance.choice(['and', 'or'])} {joined[2]}"
    )
    given = {name: float(chance.randrange(-2, 3)) for name in KNOWN}
    assert bool(value(text, **given)) == eval(text, {"__builtins__": {}}, given)


HOSTILE = [
    ("", 1),
    ("stamina >", 10),
    ("(stamina", 9),
    ("stamina)", 8),
    ("stamnia > 1", 1),
    ("spede(3)", 1),
    ("min(1)", 6),
    ("min(1, 2, 3)", 9),
    ("min", 4),
    ("1 2", 3),
    ("1 < x < 3", 7),
    ("x = 1", 3),
    ("x ** 2", 4),
    ("x ^ 2", 3),
    ("x.real", 1),
    ("__class__", 1),
    ("().__class__", 3),
    ("'a' == 'a'", 1),
    ("lambda: 1", 7),
    ("[1][0]", 1),
    ("x if x else 1", 3),
    ("1e999", 1),
    ("\u0664 > 1", 1),
    ("x; x", 2),
    ("(" * 100 + "1" + ")" * 100, 34),
    ("-" * 400 + "1", 34),
    ("-" * 100_000 + "1", 501),
    ("a" + ".a" * 100_000, 501),
    ("\x00", 1),
]


@pytest.mark.parametrize(("text", "column"), HOSTILE)
def test_refused_with_the_column(text: str, column: int) -> None:
    with pytest.raises(ConditionError) as refused:
        parse(text, KNOWN)
    assert refused.value.column == column


def test_the_nearest_name_is_said() -> None:
    with pytest.raises(ConditionError, match="did you mean stamina"):
        parse("stamnia > 1", KNOWN)


SIGNS = {"or", "and", "not", "<", "<=", ">", ">=", "==", "!=", "+", "-", "*", "/", "%", "minus"}
NAMES = {
    "min",
    "max",
    "abs",
    "floor",
    "ceil",
    "sign",
    "sqrt",
    "sin",
    "cos",
    "tan",
    "exp",
    "log",
    "atan2",
    "pow",
    "clamp",
    "lerp",
    "if",
    "asin",
    "acos",
    "atan",
}


@pytest.mark.parametrize("x", [-1.0, -0.999, -0.5, 0.0, 1e-9, 0.3, 1.0])
def test_angles_from_sines_cosines_and_tangents_are_pythons(x: float) -> None:
    for name in ("asin", "acos", "atan"):
        assert value(f"{name}({x})") == pytest.approx(getattr(math, name)(x), rel=1e-14, abs=1e-15)


def test_beyond_one_the_angle_is_that_of_one() -> None:
    assert value("asin(-7) + acos(7)") == -math.pi / 2
    assert value("acos(-7)") == math.pi
    assert value("atan(1e300)") == math.pi / 2


def test_there_is_no_other_way_to_do_anything() -> None:
    assert (set(OPERATORS), set(FUNCTIONS)) == (SIGNS, NAMES)


def test_a_variable_may_be_called_like_a_function() -> None:
    assert float(parse("min + 1", ("min",)).evaluate(np.array([[2.0]]))[0]) == 3

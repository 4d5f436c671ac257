"""Limits are chosen by name, and docs/limits.md says of each what it is."""

import re
from dataclasses import fields
from importlib import import_module

import pytest
from paths import ROOT
from statwalk.errors import ContentError, UnknownNameError
from statwalk.services.limits import MOST_ACTORS, Limits, chosen

UNITS = {"KiB": 1 << 10, "MiB": 1 << 20}
ROW = re.compile(
    r"^\| (?P<what>[^|]+) \| (?P<default>[\d,.]+) ?(?P<unit>[^|]*) \| [^|]+ \| (?P<change>[^|]+) \|$",
    re.MULTILINE,
)
ROWS = [match.groupdict() for match in ROW.finditer((ROOT / "docs" / "limits.md").read_text())]


def value_in_code(change: str) -> float:
    """What the code has: a field of Limits, or a constant of a module."""
    if chosen_by := re.fullmatch(r"`--limit (\w+)=`", change):
        return float(getattr(Limits(), chosen_by[1]))
    fixed = re.fullmatch(r"fixed: `([\w/]+)\.(\w+)`", change)
    assert fixed, change
    return float(getattr(import_module("statwalk." + fixed[1].replace("/", ".")), fixed[2]))


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row["what"][:40])
def test_the_table_says_what_the_code_does(row: dict[str, str]) -> None:
    default = float(row["default"].replace(",", "")) * UNITS.get(row["unit"], 1)
    assert value_in_code(row["change"]) == default


def test_every_limit_that_can_be_chosen_is_in_the_table() -> None:
    named = [found[1] for row in ROWS if (found := re.search(r"--limit (\w+)=", row["change"]))]
    assert sorted(named) == sorted(field.name for field in fields(Limits))


def test_limits_are_chosen_by_name() -> None:
    assert chosen(["stages=8", "requests=0.5"]) == Limits(stages=8, requests=0.5)
    assert chosen([]) == Limits()


@pytest.mark.parametrize(
    "word",
    [
        "stages=",
        "stages=-1",
        "stages=1.5",
        "requests=inf",
        "requests=nan",
        "stages",
        f"actors={MOST_ACTORS + 1}",
    ],
)
def test_a_value_that_limits_nothing_is_refused(word: str) -> None:
    with pytest.raises(ContentError, match="positive number"):
        chosen([word])


def test_a_limit_that_does_not_exist_is_refused_with_the_names_of_all() -> None:
    with pytest.raises(UnknownNameError, match="did you mean stages"):
        chosen(["stage=1"])

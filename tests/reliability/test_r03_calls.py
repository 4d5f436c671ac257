"""R-03: what was acknowledged survives `kill -9` at any system call that changes the disk.

`python benchmarks/reliability.py calls` does the same at each of the first 2,000.
"""

from pathlib import Path

import pytest
from keeper import Plan
from killed_calls import Used, broken_after, killed_at, used
from promised import found_in
from traced import needs_strace

OPENING = range(1, 20, 4)
"""calls that make the database"""
KEEPING = range(1, 400, 20)
MOST_INPUTS = 100


@pytest.fixture(scope="module", autouse=True)
def _strace() -> None:
    needs_strace()


@pytest.fixture(scope="module")
def before(tmp_path_factory: pytest.TempPathFactory) -> Used:
    return used(tmp_path_factory.mktemp("used") / "data")


@pytest.mark.parametrize("call", OPENING)
def test_r03_a_database_that_is_being_made(tmp_path: Path, call: int) -> None:
    promised, is_killed = killed_at(Used(tmp_path, []), call, Plan(MOST_INPUTS, call))
    assert is_killed
    assert broken_after(tmp_path, promised) == ""


@pytest.mark.parametrize("call", KEEPING)
def test_r03_a_database_in_use(before: Used, tmp_path: Path, call: int) -> None:
    folder = tmp_path / "data"
    promised, is_killed = killed_at(before.copied(folder), call, Plan(MOST_INPUTS, call))
    assert is_killed
    assert broken_after(folder, promised) == ""


def test_r03_an_answer_before_the_disk_has_it_is_found_out(before: Used, tmp_path: Path) -> None:
    """The control: of some kills at least one loses something."""

    def loses(call: int) -> bool:
        folder = tmp_path / str(call)
        plan = Plan(MOST_INPUTS, call, weakness="before")
        promised, _ = killed_at(before.copied(folder), call, plan)
        return promised.broken(found_in(folder)) != ""

    assert any(map(loses, range(20, 60, 2)))

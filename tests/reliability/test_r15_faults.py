"""R-15: when the disk is full or fails, nothing is acknowledged that it does not have; when it works
again, so does the store, without a new start.

`python benchmarks/reliability.py faults` does the same at each of the first 500 system calls.
"""

from pathlib import Path

import pytest
from disk_faults import UNTIL_TOLD, Fault, outcome
from keeper import Plan
from killed_calls import Used, used
from traced import needs_strace

PLAN = Plan(12, 1)
FLUSH = "fdatasync"
FAULTS = [
    Fault("EIO", 3, only=FLUSH),
    Fault("EIO", 4, 4, only=FLUSH),
    Fault("EIO", 20),
    Fault("ENOSPC", 31),
    Fault("ENOSPC", 25, UNTIL_TOLD),
]


@pytest.fixture(scope="module", autouse=True)
def _strace() -> None:
    needs_strace()


@pytest.fixture(scope="module")
def before(tmp_path_factory: pytest.TempPathFactory) -> Used:
    return used(tmp_path_factory.mktemp("used") / "data")


@pytest.mark.parametrize("fault", FAULTS, ids=str)
def test_r15_what_was_acknowledged_is_there_and_it_goes_on(
    before: Used, tmp_path: Path, fault: Fault
) -> None:
    found = outcome(before.copied(tmp_path / "data"), fault, PLAN)
    assert found.broken == ""
    assert found.refusals > 0


def test_r15_what_a_failed_flush_left_is_written_again(before: Used, tmp_path: Path) -> None:
    """Else SQLite reads the commit in its log, and a power cut brings an older log back."""
    fault = Fault("ENOSPC", 15, 5)
    assert outcome(before.copied(tmp_path / "data"), fault, Plan(13, 15)).broken == ""


def test_r15_a_writer_that_does_not_hear_the_disk_is_found_out(before: Used, tmp_path: Path) -> None:
    """The control."""
    found = outcome(before.copied(tmp_path / "data"), FAULTS[2], PLAN._replace(weakness="deaf"))
    assert "missing" in found.broken

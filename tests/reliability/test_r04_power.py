"""R-04: what was acknowledged survives a power cut, also one in the middle of a system call.

`python benchmarks/reliability.py power` does the same with more inputs and states.
"""

from pathlib import Path

import pytest
from keeper import Plan, recorded
from power_cuts import Counts, Sample, check
from system_calls import calls
from traced import needs_strace

ROUNDS, INPUTS = 2, 12


@pytest.fixture(scope="module", autouse=True)
def _strace() -> None:
    needs_strace()


def cut(folder: Path, sample: Sample, weakness: str = "") -> Counts:
    traces = recorded(folder, ROUNDS, Plan(INPUTS, sample.seed, weakness=weakness))
    return check(calls(traces), folder / "data", sample)


def test_r04_nothing_that_was_acknowledged_is_lost(tmp_path: Path) -> None:
    counts = cut(tmp_path, Sample(seed=1, draws=4, every=3))
    assert counts.broken == []
    assert counts.inputs == ROUNDS * INPUTS
    assert counts.opened > 200


@pytest.mark.parametrize("weakness", ["NORMAL", "OFF", "before"])
def test_r04_a_store_that_promises_less_is_found_out(tmp_path: Path, weakness: str) -> None:
    """The control."""
    assert cut(tmp_path, Sample(seed=2, draws=2, every=5), weakness).broken

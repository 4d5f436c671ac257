"""R-08: a simulated clock, disk and network around the server's own classes; one seed decides everything.

`python benchmarks/reliability.py simulation` does the same with ten thousand seeds, and for longer.
"""

import os
import subprocess
import sys

import pytest
from paths import ROOT
from simulated.planted import PLANTS
from simulated.simulate import simulate

SEEDS, PARTS = 200, 4
MINUTES = 0.5
MOST_SEEDS = 80
"""within which a planted fault must be found"""
PRINT_FINGERPRINT = (
    f"import sys; sys.path[:0] = {[str(ROOT / 'tests' / 'support')]}\n"
    "from simulated.simulate import simulate; print(simulate(7, 1.0).fingerprint)"
)


@pytest.mark.parametrize("part", range(PARTS))
def test_r08_nothing_acknowledged_is_lost_or_doubled_and_all_goes_on_after_each_storm(part: int) -> None:
    storms = 0
    for seed in range(1 + part, 1 + SEEDS, PARTS):
        outcome = simulate(seed, MINUTES)
        assert not outcome.faults, outcome.report
        storms += outcome.counts["calms"]
    assert storms > SEEDS / PARTS / 2


@pytest.mark.parametrize("name", PLANTS)
def test_r08_a_planted_fault_is_found(name: str) -> None:
    """The controls: the product with a fault, and the simulation finds it."""
    minutes, plant, first = PLANTS[name]
    with plant():
        assert any(simulate(seed, minutes).faults for seed in range(first, first + MOST_SEEDS))


def test_r08_a_seed_decides_everything() -> None:
    """In processes with other hashes of strings, too."""
    fingerprints = {
        subprocess.run(
            [sys.executable, "-c", PRINT_FINGERPRINT],
            env=os.environ | {"PYTHONHASHSEED": hash_seed},
            capture_output=True,
            text=True,
            check=True,
        ).stdout
        for hash_seed in ("0", "1")
    }
    assert fingerprints == {simulate(7, 1.0).fingerprint + "\n"}

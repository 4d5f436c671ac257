"""Two thousand seeded mutations of valid models; `tests/support/torture/mutate.py` makes more, and tells how
they are made.
"""

import gc
import signal

import pytest
from torture.mutate import join, limited, memory, mutated, outcome, sources

EACH, SETS = 100, 20


@pytest.fixture(scope="module")
def known():
    return sources()


@pytest.mark.parametrize("first", range(0, EACH * SETS, EACH))
def test_each_is_read_whole_or_refused_with_a_place(known, first):
    for seed in range(first, first + EACH):
        try:
            outcome(mutated(seed, known))
        except Exception as error:
            raise AssertionError(f"seed {seed}") from error


def test_the_sources_themselves_are_read(known):
    assert {outcome(join(*source)) for source in known} == {"read"}


def test_memory_comes_back(known):
    for seed in range(100):
        outcome(mutated(seed, known))
    gc.collect()
    before = memory()
    for seed in range(100, 400):
        outcome(mutated(seed, known))
    gc.collect()
    assert memory() - before <= 64 << 20


def test_what_hangs_is_noticed():
    with pytest.raises(TimeoutError), limited(0.01):
        signal.pause()

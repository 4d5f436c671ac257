"""Five hundred seeded mutations of valid files of each format; `tests/support/torture/mutate.py` makes more,
and tells how they are made.
"""

import gc
import signal

import pytest
from torture.mutate import MUTATORS
from torture.outcomes import limited, memory

EACH, SETS = 100, 5


@pytest.mark.parametrize("first", range(0, EACH * SETS, EACH))
@pytest.mark.parametrize("name", MUTATORS)
def test_each_is_read_whole_or_refused_with_a_place(name: str, first: int) -> None:
    mutator = MUTATORS[name]
    for seed in range(first, first + EACH):
        try:
            mutator.outcome(mutator.mutated(seed))
        except Exception as error:
            raise AssertionError(f"seed {seed}") from error


@pytest.mark.parametrize("name", MUTATORS)
def test_the_valid_files_are_read(name: str) -> None:
    mutator = MUTATORS[name]
    assert {mutator.outcome(data) for data in mutator.valid()} == {"read"}


@pytest.mark.parametrize("name", MUTATORS)
def test_mutations_are_of_both_kinds(name: str) -> None:
    """A mutator whose files are all refused, or all read, would show nothing."""
    mutator = MUTATORS[name]
    assert {mutator.outcome(mutator.mutated(seed)) for seed in range(100)} >= {"read", "refused"}


def test_memory_comes_back() -> None:
    mutator = MUTATORS["gltf"]
    for seed in range(100):
        mutator.outcome(mutator.mutated(seed))
    gc.collect()
    before = memory()
    for seed in range(100, 400):
        mutator.outcome(mutator.mutated(seed))
    gc.collect()
    assert memory() - before <= 64 << 20


def test_what_hangs_is_noticed() -> None:
    with pytest.raises(TimeoutError), limited(0.01):
        signal.pause()

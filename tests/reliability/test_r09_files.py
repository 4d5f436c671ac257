"""Five hundred seeded mutations of valid files of each format are read whole, or refused with a place;
`python benchmarks/reliability.py files` reads more. The controls are readers that break, hang, name no place,
or read what is not finite.
"""

import gc
import signal
from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
import tiny_model
from statwalk.character.character import Character
from statwalk.errors import ContentError
from statwalk.files.gltf import read_model
from torture.mutators import MUTATORS
from torture.outcomes import limited, memory, outcome

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


def break_down() -> Character:
    raise KeyError("joints")


def refuse_without_a_place() -> Character:
    raise ContentError("something is wrong")


def read_what_is_not_finite() -> Character:
    character = read_model(tiny_model.model(), "tiny")
    pose = character.bind_pose
    return replace(character, bind_pose=type(pose)(*(array + np.inf for array in pose)))


READERS = {break_down: KeyError, refuse_without_a_place: ValueError, read_what_is_not_finite: AssertionError}


@pytest.mark.filterwarnings("ignore:invalid value encountered")
@pytest.mark.parametrize(("reader", "error"), READERS.items())
def test_a_reader_that_does_wrong_is_noticed(reader: Callable[[], Character], error: type[Exception]) -> None:
    with pytest.raises(error):
        outcome(reader, ("line ",))

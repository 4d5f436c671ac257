"""R-18: a client whose connection is cut sends again, and its input counts once."""

import asyncio

import pytest
from processes import served
from retries import Retries, retried

INPUTS = 150


def through_cuts(*, has_keys: bool) -> Retries:
    with served() as (_, address):
        return asyncio.run(retried(address, INPUTS, seed=3, has_keys=has_keys))


@pytest.fixture(scope="module")
def outcome() -> Retries:
    return through_cuts(has_keys=True)


def test_every_input_counts_once_whatever_is_cut(outcome: Retries) -> None:
    assert outcome.cuts > INPUTS // 10
    assert outcome.sent > INPUTS
    assert sorted(outcome.answered.values()) == sorted(outcome.logged)
    assert len(set(outcome.logged)) == INPUTS


def test_a_request_that_comes_again_gets_the_same_number(outcome: Retries) -> None:
    assert outcome.different == 0


def test_without_keys_some_count_twice() -> None:
    assert len(through_cuts(has_keys=False).logged) > INPUTS

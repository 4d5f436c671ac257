"""Logs of another engine are refused; logs that name no engine are not."""

from importlib.metadata import version

import pytest
from statwalk.errors import StageError
from statwalk.stage.history.engine import ENGINE, RELEASE, check_engine


@pytest.mark.parametrize("header", [{}, {"engine": ENGINE}, {"engine": ENGINE, "version": "9.9"}])
def test_a_log_of_this_engine_or_of_none_fits(header):
    check_engine(header)


@pytest.mark.parametrize("player", ["9.9", None, 3])
@pytest.mark.parametrize("engine", [ENGINE + 1, 0, "1", None, [1]])
def test_a_log_of_another_engine_is_refused_and_the_message_names_both(engine, player):
    with pytest.raises(StageError) as refused:
        check_engine({"engine": engine, "version": player})
    named = "another statwalk" if player is None else f"statwalk {player}"
    assert str(refused.value) == (
        f"line 1: engine {engine} ({named}) played the log; this is engine {ENGINE} (statwalk {RELEASE}), "
        f"which may move otherwise. Play it with {named}"
    )


def test_the_release_is_that_of_the_installed_package():
    assert version("statwalk") == RELEASE

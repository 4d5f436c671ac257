"""Counts in words."""

import pytest
from statwalk.cli.counted import counted


@pytest.mark.parametrize(("number", "words"), [(0, "0 warnings"), (1, "1 warning"), (12, "12 warnings")])
def test_one_is_no_plural(number, words):
    assert counted(number, "warning") == words

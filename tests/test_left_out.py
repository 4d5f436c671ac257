"""A run of the tests says at its end what it left out, and why."""

import subprocess
import sys
from pathlib import Path

from paths import ROOT

TESTS = """
import pytest

@pytest.mark.parametrize("number", [1, 2])
@pytest.mark.skipif(True, reason="the moon is not full")
def test_by_mark(number):
    pass

def test_by_call():
    pytest.skip("the moon is new")

def test_that_runs():
    pass
"""


def test_each_reason_is_said_with_its_number_of_tests(tmp_path: Path) -> None:
    (tmp_path / "conftest.py").write_text((ROOT / "tests" / "conftest.py").read_text())
    (tmp_path / "test_few.py").write_text(TESTS)
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path)]
    said = subprocess.run(
        command, capture_output=True, text=True, cwd=tmp_path, timeout=60
    ).stdout.splitlines()
    assert [line for line in said if "did not run" in line] == [
        "2 tests did not run: the moon is not full",
        "1 test did not run: the moon is new",
    ]

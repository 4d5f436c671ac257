"""A child runs a module as `python -m` does, and lets others run first if it is told to."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from statwalk.services.work.limited_process import NICENESS, started

SAYS = """
import json, os, sys
print(json.dumps([__name__, sys.argv[1:], os.nice(0)]))
"""


@pytest.fixture
def says(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """A module that prints its name, its arguments, and how nice it is from its first line on."""
    (tmp_path / "says.py").write_text(SAYS)
    monkeypatch.setenv("PYTHONPATH", f"{tmp_path}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")
    return "says"


def said(module: str, **options: bool) -> Any:
    with started(module, ["a", "-b"], stdout=subprocess.PIPE, **options) as child:
        assert child.stdout is not None
        return json.loads(child.stdout.read())


def test_a_module_runs_as_the_program(says: str) -> None:
    assert said(says) == ["__main__", ["a", "-b"], os.nice(0)]


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no niceness")
def test_a_child_that_runs_last_is_nice_from_its_first_line(says: str) -> None:
    assert said(says, runs_last=True) == ["__main__", ["a", "-b"], min(os.nice(0) + NICENESS, 19)]

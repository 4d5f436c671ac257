"""The machine's step runs as plain Python, too, callees and all, and gives the same bits."""

import os
import subprocess
import sys
from pathlib import Path

import step_runs

PLAIN = os.environ | {
    "STATWALK_COMPILED": "0",
    "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
}


def test_the_step_gives_the_same_bits_without_a_compiler():
    command = [sys.executable, str(Path(step_runs.__file__))]
    printed = subprocess.run(command, env=PLAIN, capture_output=True, text=True, check=True).stdout.split()
    compiled = step_runs.digest()
    assert compiled.verdicts > 1000
    assert printed == [compiled.bits, str(compiled.verdicts)]

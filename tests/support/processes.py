"""`statwalk serve` as a process of its own."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path


def command(*arguments: str) -> list[str]:
    return [sys.executable, "-m", "statwalk.cli", "serve", *arguments]


@contextmanager
def served(*arguments: str, log: Path | None = None) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """The process, and the address that it prints; without `--data` its data folder is a new one. `log`: the
    file that gets its standard error.
    """
    environment = os.environ | {"COLUMNS": "200", "PYTHONUNBUFFERED": "1"}
    own = () if "--data" in arguments else ("--data", tempfile.mkdtemp())
    with log.open("w") if log else nullcontext() as errors:
        process = subprocess.Popen(
            command("--port", "0", *own, *arguments),
            stdout=subprocess.PIPE,
            stderr=errors,
            text=True,
            env=environment,
        )
    assert process.stdout is not None
    try:
        line = process.stdout.readline()
        assert "http://" in line
        yield process, line.split("http://")[1].split("/")[0]
    finally:
        process.kill()
        process.wait()
        process.stdout.close()

"""`statwalk serve` as a process of its own."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager, nullcontext
from pathlib import Path


def command(*arguments: str, change: str = "") -> list[str]:
    """`change`: Python that runs before the server does."""
    how = ("-c", f"{change}\nfrom statwalk.cli import main\nmain()") if change else ("-m", "statwalk.cli")
    return [sys.executable, *how, "serve", *arguments]


@contextmanager
def served(
    *arguments: str, log: Path | None = None, change: str = ""
) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """The process, and the address that it prints; without `--data` its data folder is a new one. `log`: the
    file that gets its standard error. `change`: Python that runs before the server does.
    """
    environment = os.environ | {"COLUMNS": "200", "PYTHONUNBUFFERED": "1"}
    own = () if "--data" in arguments else ("--data", tempfile.mkdtemp())
    with log.open("w") if log else nullcontext() as errors:
        process = subprocess.Popen(
            command("--port", "0", *own, *arguments, change=change),
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

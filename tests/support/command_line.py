"""The command `statwalk` in this process: a Python for each command would take three seconds to start."""

import contextlib
import io
import os
import sys
from pathlib import Path
from typing import NamedTuple
from unittest.mock import patch

from statwalk.cli import main


class Ended(NamedTuple):
    """What a command has printed, and its exit status."""

    returncode: int
    stdout: str
    stderr: str


def statwalk(*arguments: object, cwd: Path | None = None, columns: int = 200) -> Ended:
    """Runs a command line in a folder, in a terminal of so many columns."""
    printed, complained = (io.TextIOWrapper(io.BytesIO(), "utf-8", write_through=True) for _ in range(2))
    status = 0
    with (
        patch.object(sys, "argv", ["statwalk", *map(str, arguments)]),
        patch.dict(os.environ, COLUMNS=str(columns)),
        contextlib.chdir(cwd or Path.cwd()),
        contextlib.redirect_stdout(printed),
        contextlib.redirect_stderr(complained),
    ):
        try:
            main()
        except SystemExit as end:
            status = end.code if isinstance(end.code, int) else int(end.code is not None)
    return Ended(status, *(text(stream) for stream in (printed, complained)))


def text(stream: io.TextIOWrapper) -> str:
    """What was written to a stream."""
    stream.seek(0)
    return stream.read()

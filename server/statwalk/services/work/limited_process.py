"""Child processes of ours with bounded memory, which let the stages run first."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from functools import cache
from typing import Any

if sys.platform != "win32":
    import resource

NICENESS = 10
"""lets the stages run before the child"""
RUN_LAST = f"""
import os, runpy, sys
if sys.platform != "win32":
    os.nice({NICENESS})
runpy.run_module(sys.argv.pop(1), run_name="__main__", alter_sys=True)
"""
ONE_THREAD = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def started(
    module: str, arguments: Sequence[str], *, runs_last: bool = False, **options: Any
) -> subprocess.Popen[bytes]:
    """Starts a module of ours; the child gets no open files of this process but those in `options`.

    `runs_last`: from its first moment; its imports alone take a second of a processor.
    """
    how = ("-c", RUN_LAST) if runs_last else ("-m",)
    return subprocess.Popen(  # noqa: S603 - our own program, no shell
        [sys.executable, "-P", *how, module, *arguments], env=os.environ | ONE_THREAD, **options
    )


def limit_self(memory_bytes: int, file_bytes: int, processor_seconds: int | None = None) -> None:
    """Limits the memory of this process, the files that it writes and, if told, its computing."""
    if sys.platform != "win32":
        resource.setrlimit(resource.RLIMIT_AS, (memory_bytes, memory_bytes))
        resource.setrlimit(resource.RLIMIT_FSIZE, (file_bytes, file_bytes))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if processor_seconds:
            resource.setrlimit(resource.RLIMIT_CPU, (processor_seconds, processor_seconds + 1))


@cache
def run_last() -> None:
    """Has other processes run first, from the first call on."""
    if sys.platform != "win32":
        os.nice(NICENESS)

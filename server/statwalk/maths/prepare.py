"""Compiles every kernel, or loads it from the disk, before it is needed; `python -m statwalk.maths.prepare`
does only this.

The server prepares itself before it listens, so that no request waits for a compiler.
"""

from __future__ import annotations

import logging
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from importlib import import_module
from pathlib import Path
from typing import Any

from statwalk.errors import StatwalkError
from statwalk.maths import code_folder

KERNEL = re.compile(r"^@kernel\b", re.MULTILINE)
LOG = logging.getLogger(__name__)
MACHINES = tuple(
    f"statwalk.{name}"
    for name in (
        "machine.model_checker.explore",
        "machine.model_checker.longest",
        "machine.runtime.seen",
        "stage.steps.step_machines",
    )
)
"""modules that a second process compiles at the same time; what they share is then compiled once"""
NO_NUMBA = (
    "numba, which compiles the inner loops of statwalk, can't be imported here: {}. Install it: "
    "python -m pip install numba"
)


def prepare(alone: bool = False) -> None:
    """Imports every module with kernels, and reports compilation on stderr.

    Unless `alone`, a second process compiles the kernels of machines at the same time.

    :raises StatwalkError: when numba can't be imported.
    """
    compiling = compiler()
    listed = kernels_by_module(code_folder.PACKAGE)
    progress = _Progress(sum(listed.values()))
    with compiling.announced(progress.compiles), _helper(alone or _mark().is_file()):
        for name in sorted(listed, key=_is_beside_poses):
            import_module(name)
    progress.end()
    LOG.info("%d kernels for the processor %s", len(compiling.KERNELS), code_folder.processor()[0])
    if compiling.IS_COMPILED:
        with suppress(OSError):
            _mark().touch()


def _is_beside_poses(module: str) -> bool:
    return module in MACHINES or not module.startswith(("statwalk.motion.", "statwalk.stage."))


@contextmanager
def _helper(is_needless: bool) -> Iterator[None]:
    """A process that compiles the kernels of machines; none if it is needless or there is one processor."""
    if is_needless or (os.cpu_count() or 1) < 2:
        yield
        return
    code = f"from importlib import import_module as load; [load(name) for name in {MACHINES!r}]"
    arguments = [sys.executable, "-c", code]
    with subprocess.Popen(arguments, stdin=subprocess.DEVNULL, stderr=subprocess.DEVNULL):  # noqa: S603 - our own text
        yield


def prepare_once() -> None:
    """Runs `prepare`, unless it has completed before: for commands that need a few of the kernels, and not at
    once.

    :raises StatwalkError: when numba can't be imported.
    """
    compiler()
    if not _mark().is_file():
        prepare()


def kernels_by_module(package: Path) -> dict[str, int]:
    """Returns the number of kernels of each module of the package that has any."""
    counts = {
        path: len(KERNEL.findall(path.read_text(encoding="utf-8")))
        for path in code_folder.compiled_sources(package)
    }
    return {
        ".".join(path.relative_to(package.parent).with_suffix("").parts): count
        for path, count in counts.items()
        if count
    }


def _mark() -> Path:
    return code_folder.folder() / "complete"


def compiler() -> Any:
    """Returns the module that compiles kernels.

    :raises StatwalkError: when numba can't be imported; the message says what to install.
    """
    try:
        return import_module("statwalk.maths.compiling")
    except ImportError as error:
        raise StatwalkError(NO_NUMBA.format(error)) from error


class _Progress:
    """One line on stderr, rewritten on a terminal."""

    def __init__(self, total: int) -> None:
        self.total, self.is_rewritten, self.is_shown = total, sys.stderr.isatty(), False

    def compiles(self, number: int, _name: str) -> None:
        if self.is_rewritten:
            self._write(
                f"\rstatwalk: compiling {number} of {self.total} kernels, once for this version and "
                "processor …"
            )
        elif not self.is_shown:
            self._write(f"statwalk: compiling {self.total} kernels, once for this version and processor …\n")
        self.is_shown = True

    def end(self) -> None:
        if self.is_shown and self.is_rewritten:
            self._write("\n")

    def _write(self, text: str) -> None:
        sys.stderr.write(text)
        sys.stderr.flush()


if __name__ == "__main__":
    try:
        prepare()
    except StatwalkError as error:
        sys.stderr.write(f"statwalk: {error}\n")
        sys.exit(2)

"""The engine's number: logs and states say which engine made them, as another engine may move otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from statwalk.errors import StageError

ENGINE = 17
"""raised by a change after which some log leads to other states: see "Change the numbers" in CONTRIBUTING"""


def _release() -> str:
    try:
        return version("statwalk")
    except PackageNotFoundError:
        return ""


RELEASE = _release()
"""the version of statwalk, for people; empty if it is not installed: read before a stage is held"""


def check_engine(header: Mapping[str, Any]) -> None:
    """Looks at the header of a log; a log that names no engine, as one written by hand, fits every engine.

    :raises StageError: when another engine played the log; the message names that version of statwalk.
    """
    played = header.get("engine", ENGINE)
    if played == ENGINE:
        return
    player = f"statwalk {str(header['version'])[:40]}" if header.get("version") else "another statwalk"
    raise StageError(
        f"line 1: engine {str(played)[:40]} ({player}) played the log; this is engine {ENGINE} (statwalk "
        f"{RELEASE}), which may move otherwise. Play it with {player}"
    )

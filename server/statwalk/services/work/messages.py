"""The messages between a server and its workers."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

CANCEL = b""
"""what the server writes to cancel the job"""


class Outcome(NamedTuple):
    """What became of a job; `is_spent`: the worker should do no further one."""

    answer: Any = None
    error: Exception | None = None
    is_spent: bool = False


class StandIn(NamedTuple):
    """What stands for an argument that is too large to send: the worker calls `load(*arguments)`."""

    load: Callable[..., Any]
    arguments: tuple[Any, ...]

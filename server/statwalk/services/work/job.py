"""How long work is done: here, or in a process of its own."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Protocol, TypeVar

from statwalk.services.cancel import NEVER, CancelToken

Answer = TypeVar("Answer")
Job = Callable[..., Answer]
"""a function of a module with plain arguments; the last one is called between the pieces of the work, and
ends it by raising
"""


class DoJob(Protocol):
    """Does a job; waits for it."""

    def __call__(self, about: str, job: Job[Answer], *arguments: Any, token: CancelToken = NEVER) -> Answer:
        """Returns the answer of `job(*arguments, checkpoint)`. `about` names a machine: a process that has
        worked on the machine before is preferred, since it has loaded the machine.

        :raises CancelledError: when the token is cancelled.
        :raises OverdueError: when the time of the token is over.
        """


def do_here(about: str, job: Job[Answer], *arguments: Any, token: CancelToken = NEVER) -> Answer:  # noqa: ARG001
    """Does a job in this thread."""
    return job(*arguments, token.check)

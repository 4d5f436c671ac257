"""What a server takes from the computer that it runs on: time and threads. Both are arguments, so that a
simulation turns the same code by hand.
"""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Protocol

Now = Callable[[], float]
"""returns the seconds since some moment; they never go back, whatever happens to the time of day"""


class Started(Protocol):
    """A thread that runs."""

    def join(self) -> None:
        """Waits until it has ended."""


class Threads:
    """Threads of the operating system."""

    def condition(self) -> threading.Condition:
        """Returns a condition on which threads wait."""
        return threading.Condition()

    def start(self, run: Callable[[], None], name: str) -> Started:
        """Runs a function in a thread, which ends with the process at the latest."""
        thread = threading.Thread(target=run, name=name, daemon=True)
        thread.start()
        return thread

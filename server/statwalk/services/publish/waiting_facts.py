"""Holds actions and verdicts back until the commands that led to them would survive a crash."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence


class WaitingFacts:
    """Encoded facts in order, in batches; each batch waits for the command of a number in the log."""

    def __init__(self) -> None:
        self._batches: deque[tuple[int, Sequence[bytes]]] = deque()
        self._length = 0

    def __len__(self) -> int:
        return self._length

    def put(self, number: int, texts: Sequence[bytes]) -> None:
        """Appends the facts of a tick; `number`: the newest command that the tick may have read."""
        if texts:
            self._batches.append((number, texts))
            self._length += len(texts)

    def take(self, is_durable: Callable[[int], bool]) -> list[bytes]:
        """Removes and returns the facts whose commands are durable, and all facts before them."""
        taken: list[bytes] = []
        while self._batches and is_durable(self._batches[0][0]):
            taken.extend(self._batches.popleft()[1])
        self._length -= len(taken)
        return taken

    def drop(self) -> None:
        """Removes all facts."""
        self._batches.clear()
        self._length = 0

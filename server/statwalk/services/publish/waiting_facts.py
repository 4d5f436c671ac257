"""Holds actions and verdicts back until a crash can take back nothing that led to them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence


class WaitingFacts:
    """Encoded facts in order, in batches; each batch waits for its tick."""

    def __init__(self) -> None:
        self._batches: deque[tuple[int, Sequence[bytes]]] = deque()
        self._length = 0

    def __len__(self) -> int:
        return self._length

    def put(self, tick: int, texts: Sequence[bytes]) -> None:
        """Appends the facts of a tick."""
        if texts:
            self._batches.append((tick, texts))
            self._length += len(texts)

    def take(self, is_durable: Callable[[int], bool]) -> list[bytes]:
        """Removes and returns the facts whose ticks are durable, and all facts before them."""
        taken: list[bytes] = []
        while self._batches and is_durable(self._batches[0][0]):
            taken.extend(self._batches.popleft()[1])
        self._length -= len(taken)
        return taken

    def drop(self) -> None:
        """Removes all facts."""
        self._batches.clear()
        self._length = 0

"""The log of a stage: every command, with its sequence number and the tick in which it counts."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Protocol

from statwalk.stage.state.commands import Command, LogEntry


class Log(Protocol):
    """The interface of a log; a durable store can replace the log in memory."""

    def append(self, tick: int, commands: Iterable[Command]) -> list[int]:
        """Appends commands after all other commands of their tick; returns their sequence numbers."""

    @property
    def newest(self) -> int:
        """The sequence number of the newest command; 0 if the log is empty."""

    @property
    def last(self) -> LogEntry | None:
        """The newest entry that came to this log itself, and not to a log whose past it shares."""

    @property
    def held(self) -> int:
        """The number of entries that the log holds, or more: what is shared with another log may count."""

    def durable(self, number: int, seconds: float = 0.0) -> bool:
        """Returns whether the command of this number, and all commands before it, would survive a crash of
        the machine; waits for durability for at most `seconds`.
        """

    def at(self, tick: int) -> list[LogEntry]:
        """Returns the entries of a tick, in the order in which they came."""

    def until(self, tick: int, takes_waiting: bool = False) -> Log:
        """Returns a log that shares the entries up to `tick` (with `takes_waiting` also the entries of the
        next tick) and is independent afterwards.
        """

    def forget(self, tick: int) -> None:
        """Drops the entries up to `tick`."""

    def __iter__(self) -> Iterator[LogEntry]:
        """Yields all entries by tick, and in the order in which they came."""


class MemoryLog:
    """A log in the memory of its process; a command is as durable as it will ever be at once."""

    def __init__(self, entries: Iterable[LogEntry] = (), newest: int = 0) -> None:
        """`newest`: the number of the newest entry that came before these."""
        self._by_tick: dict[int, list[LogEntry]] = {}
        self._past: list[
            tuple[int, Mapping[int, list[LogEntry]]]
        ] = []  # (first tick that is not shared, entries), oldest first
        self.newest, self.held = newest, 0
        self.last: LogEntry | None = None
        for entry in entries:
            self._by_tick.setdefault(entry.tick, []).append(entry)
            if self.last is None or entry.number > self.last.number:
                self.last = entry
            self.held += 1
        if self.last:
            self.newest = max(newest, self.last.number)

    def append(self, tick: int, commands: Iterable[Command]) -> list[int]:
        """Appends commands after all other commands of their tick; returns their sequence numbers."""
        new = [LogEntry(number, tick, command) for number, command in enumerate(commands, self.newest + 1)]
        self._by_tick.setdefault(tick, []).extend(new)
        self.last = new[-1] if new else self.last
        self.newest += len(new)
        self.held += len(new)
        return [entry.number for entry in new]

    def durable(self, number: int, seconds: float = 0.0) -> bool:  # noqa: ARG002 - memory has no disk to wait for
        """Returns whether the command of this number has been appended."""
        return number <= self.newest

    def at(self, tick: int) -> list[LogEntry]:
        """Returns the entries of a tick, in the order in which they came."""
        for end, entries in self._past:
            if tick < end:
                return list(entries.get(tick, ()))
        return list(self._by_tick.get(tick, ()))

    def until(self, tick: int, takes_waiting: bool = False) -> MemoryLog:
        """Returns a log that shares the entries before `tick` by reference, since the past never changes, and
        copies the others.
        """
        fork = MemoryLog([*self.at(tick), *(self.at(tick + 1) if takes_waiting else ())])
        fork._past = [(min(end, tick), entries) for end, entries in (*self._past, (tick, self._by_tick))]
        fork.newest, fork.held = self.newest, self.held
        return fork

    def forget(self, tick: int) -> None:
        """Drops the entries up to `tick`; a log that shares them keeps them."""
        later = MemoryLog(entry for entry in self if entry.tick > tick)
        self._past, self._by_tick, self.held = [], later._by_tick, later.held

    def __iter__(self) -> Iterator[LogEntry]:
        """Yields all entries by tick, and in the order in which they came."""
        # tuple: another thread may append to the log that shares this past
        ticks = {tick for end, entries in self._past for tick in tuple(entries) if tick < end} | set(
            self._by_tick
        )
        for tick in sorted(ticks):
            yield from self.at(tick)

"""The log: all that ever came to a stage from outside, each entry with the tick it counts in. A stage follows from it alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

KINDS = ("add", "remove", "press", "hold", "release", "set", "travel", "edit")


@dataclass(frozen=True)
class LogEntry:
    """One thing that came from outside.

    Inputs (press, hold, release, set, travel) count in the step that makes `tick`; who is added or removed is there, or gone, after it,
    and so it is with the other version of a role that an edit brings.
    """

    tick: int
    kind: str
    """one of KINDS"""
    actor: int
    """0: nobody (edit)"""
    name: str
    """event or parameter; travel: the state to go to, empty to go on as usual; add: the actor's name; edit: the role's"""
    value: Any = None
    """set: the number; add: role, position (metres), heading (radians); edit: role (`name@version`), text of the machine file"""


class Log(Protocol):
    """What a stage needs of a log; a durable store can take the place of the one in memory."""

    def append(self, entry: LogEntry) -> None:
        """Keep an entry after all others of its tick."""

    def at(self, tick: int) -> list[LogEntry]:
        """The entries of a tick, in the order they came."""

    def until(self, tick: int) -> Log:
        """A log that shares what counts up to `tick` and goes its own way from there."""

    def __iter__(self) -> Iterator[LogEntry]:
        """All entries by tick, and in the order they came."""


class MemoryLog:
    """A log that lives as long as its process."""

    def __init__(self, entries: Iterable[LogEntry] = ()) -> None:
        self._by_tick: dict[int, list[LogEntry]] = {}
        self._past: list[tuple[int, Mapping[int, list[LogEntry]]]] = []  # (first tick that is not shared, entries), oldest first
        for entry in entries:
            self.append(entry)

    def append(self, entry: LogEntry) -> None:
        """Keep an entry after all others of its tick."""
        self._by_tick.setdefault(entry.tick, []).append(entry)

    def at(self, tick: int) -> list[LogEntry]:
        """The entries of a tick, in the order they came."""
        for end, entries in self._past:
            if tick < end:
                return list(entries.get(tick, ()))
        return list(self._by_tick.get(tick, ()))

    def until(self, tick: int) -> MemoryLog:
        """A log that shares what counts up to `tick`: all before it by reference, since the past never changes."""
        fork = MemoryLog(self.at(tick))
        fork._past = [(min(end, tick), entries) for end, entries in (*self._past, (tick, self._by_tick))]
        return fork

    def __iter__(self) -> Iterator[LogEntry]:
        """All entries by tick, and in the order they came."""
        # tuple: the stage that the past is shared with may get an entry in another thread meanwhile
        ticks = {tick for end, entries in self._past for tick in tuple(entries) if tick < end} | set(self._by_tick)
        for tick in sorted(ticks):
            yield from self.at(tick)

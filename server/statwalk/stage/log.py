"""The log: all that ever came to a stage from outside, each entry with the tick it counts in. A stage follows from it alone."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any, Protocol

import orjson

from statwalk.errors import StageError

SEMANTICS = 1
KINDS = ("add", "remove", "press", "hold", "release", "set")


@dataclass(frozen=True)
class LogEntry:
    """One thing that came from outside.

    Inputs (press, hold, release, set) count in the step that makes `tick`; an actor added or removed is there, or gone, after it.
    """

    tick: int
    kind: str
    """one of KINDS"""
    actor: int
    name: str
    """event or parameter; for add the actor's name"""
    value: Any = None
    """set: the number; add: role, position (metres), heading (radians)"""


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


def dump(log: Iterable[LogEntry], header: Mapping[str, Any]) -> list[str]:
    """A log as JSON lines, the header first."""
    first = {"statwalk": "log", "semantics": SEMANTICS, "kernels": "numpy", **header}
    return [orjson.dumps(line).decode() for line in (first, *(vars(entry) for entry in log))]


def load(lines: Iterable[str]) -> tuple[dict[str, Any], list[LogEntry]]:
    """Header and entries of JSON lines. Raises StageError that names the line which cannot be read."""
    records = [(number, _record(number, line)) for number, line in enumerate(lines, 1) if line.strip()]
    header = records[0][1] if records else {}
    if header.get("statwalk") != "log":
        raise StageError('line 1: not a statwalk log; its first line says {"statwalk": "log", …}')
    if header.get("semantics") != SEMANTICS:
        raise StageError(f"line 1: the log has semantics {header.get('semantics')!r}, this build reads {SEMANTICS}")
    return header, [_entry(number, record) for number, record in records[1:]]


def _record(number: int, line: str) -> dict[str, Any]:
    try:
        record = orjson.loads(line)
    except orjson.JSONDecodeError as error:
        raise StageError(f"line {number}: {error}") from None
    if not isinstance(record, dict):
        raise StageError(f"line {number}: a JSON object is needed")
    return record


def _entry(number: int, record: dict[str, Any]) -> LogEntry:
    if set(record) != {"tick", "kind", "actor", "name", "value"} or record["kind"] not in KINDS:
        raise StageError(f"line {number}: an entry has tick, kind ({', '.join(KINDS)}), actor, name and value")
    if type(record["tick"]) is not int or type(record["actor"]) is not int or not isinstance(record["name"], str):
        raise StageError(f"line {number}: tick and actor are whole numbers, name is text")
    return LogEntry(**record)

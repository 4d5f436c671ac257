"""The past of a stage: its log and its snapshots, from which all its states follow."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Iterator, Mapping
from itertools import chain
from typing import NamedTuple, TypeVar

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.stage.history.log import Log, MemoryLog
from statwalk.stage.history.log_codec import Beginning
from statwalk.stage.history.snapshots import Snapshots
from statwalk.stage.state.commands import Add, Command, Edit, LogEntry
from statwalk.stage.state.stage_state import StageState

LogKind = TypeVar("LogKind", bound=Log)


class Arrival(NamedTuple):
    """How an actor came: the tick (None: before the oldest tick that is kept), and the key of its role."""

    tick: int | None
    role: str


class Past:
    """The ticks `first` to `head` of a stage with fixed steps of 1/`rate` seconds.

    `first` is 0 until the past is forgotten; from then on the stage begins with the snapshot of tick `first`.
    """

    def __init__(self, seed: int, rate: int, start: StageState) -> None:
        if rate <= 0:
            raise StageError(f"a stage needs a rate above 0 Hz, not {rate}")
        self.seed, self.rate, self.head = seed, rate, start.tick
        self.roles: dict[str, Role] = {}
        """all versions of all roles by their keys in the log: the role's name, then `name@2` … for edits"""
        self.snapshots = Snapshots(start)
        self.forgotten_texts: dict[str, str] = {}
        """the machine texts of edits that are no longer in the log, by the key of the role"""
        self.forgotten_number = 0
        """the sequence number of the newest command that is no longer in the log"""
        self._log: Log = MemoryLog()

    @property
    def first(self) -> int:
        """The oldest tick that `seek` accepts."""
        return self.snapshots.first

    @property
    def beginning(self) -> Beginning | None:
        """What the log goes on from; None: from nothing, at tick 0."""
        if not self.first:
            return None
        keys = [key for key in self.roles if "@" not in key or key in self.forgotten_texts]
        texts = {key: self.forgotten_texts.get(key, "") for key in keys}
        return Beginning(self.snapshots.data[self.first], texts, self.forgotten_number)

    @property
    def log(self) -> list[LogEntry]:
        """All commands that are kept."""
        return list(self._log)

    @property
    def held(self) -> int:
        """The number of commands that the log holds, or more."""
        return self._log.held

    @property
    def newest(self) -> int:
        """The sequence number of the newest command; 0 if there was none."""
        return self._log.newest

    @property
    def last(self) -> LogEntry | None:
        """The newest command, unless it came before this stage was forked; None: there is none."""
        return self._log.last

    def commands(self, tick: int) -> list[Command]:
        """Returns the commands of one tick."""
        return [entry.command for entry in self._log.at(tick)]

    def entries(self, first: int, last: int) -> Iterator[LogEntry]:
        """Yields the commands of the ticks `first` to `last`, by tick, in the order in which they came."""
        return chain.from_iterable(map(self._log.at, range(first, last + 1)))

    def durable(self, number: int, seconds: float = 0.0) -> bool:
        """Returns whether a crash would leave the command of this number; waits for at most `seconds`."""
        return self._log.durable(number, seconds)

    def wrap_log(self, wrapped: Callable[[Log], LogKind]) -> LogKind:
        """Has the stage append to the log that `wrapped` makes of its log; returns that log."""
        self._log = log = wrapped(self._log)
        return log

    def arrivals(self) -> dict[int, Arrival]:
        """Returns how each actor came of which the stage still knows, by id."""
        came: dict[int, Arrival] = {}
        if self.first:
            start = self.snapshots.open(self.first, self.roles)
            for key, cast in start.casts.items():
                came |= dict.fromkeys(cast.ids.tolist(), Arrival(None, key))
        for entry in self._log:
            if isinstance(entry.command, Add):
                came[entry.command.actor] = Arrival(entry.tick, entry.command.role)
        return came

    def forget(self, most: int) -> bool:
        """Forgets the oldest commands, up to the oldest snapshot that leaves at most `most` of them, else up
        to the newest snapshot; the stage then begins with that snapshot. Returns whether it forgot anything.
        """
        later = sorted(self.snapshots.data)[1:]
        if not later:
            return False
        ticks = [entry.tick for entry in self._log]
        first = next((tick for tick in later if len(ticks) - bisect_right(ticks, tick) <= most), later[-1])
        for entry in self._log:
            if entry.tick <= first:
                self._remember(entry)
        self._log.forget(first)
        self.snapshots = self.snapshots.after(first)
        return True

    def _remember(self, forgotten: LogEntry) -> None:
        """Keeps what the stage goes on to need of an entry that it forgets."""
        self.forgotten_number = max(self.forgotten_number, forgotten.number)
        if isinstance(edit := forgotten.command, Edit):
            self.forgotten_texts[edit.role] = edit.text

    def check(self, tick: int) -> None:
        """:raises StageError: when the stage does not have the tick."""
        if not self.first <= tick <= self.head:
            raise StageError(f"tick {tick} is not there: this stage has {self.first} … {self.head}")

    def begin_with(self, start: StageState, beginning: Beginning) -> None:
        """Begins with a state whose past was forgotten."""
        self.head, self.snapshots, self.forgotten_number = start.tick, Snapshots(start), beginning.number
        self.forgotten_texts = {key: text for key, text in beginning.texts.items() if text}

    def take_past(self, other: Past, head: int, log: Log, roles: Mapping[str, Role]) -> None:
        """Shares the past of another stage up to `head`."""
        self.roles, self.head, self._log = dict(roles), head, log
        self.snapshots, self.forgotten_number = other.snapshots.until(head), other.forgotten_number
        self.forgotten_texts = dict(other.forgotten_texts)

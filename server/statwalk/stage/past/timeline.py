"""A log, a playhead, and snapshots to go back by: the time of a stage. What it shows follows from its log alone."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Self

from statwalk.errors import StageError
from statwalk.stage.fold import StageState, forward, recast
from statwalk.stage.frame import Action, Frame, Verdict
from statwalk.stage.past.log import Log, LogEntry, MemoryLog
from statwalk.stage.past.loglines import dump
from statwalk.stage.past.snapshot import Snapshots
from statwalk.stage.role import Role

LONGEST_HISTORY = 10_000
"""actions and verdicts that a stage remembers; the log and `seek` give all of them again"""
SLICE = 60
"""ticks after which `seeking` and `stepping` come up for air"""


class Timeline:
    """Fixed steps of 1/`rate` seconds.

    `tick` is the playhead: `seek` moves it anywhere in 0…`head`, `step` onwards; at the head, steps make new ticks.
    """

    def __init__(self, seed: int = 0, rate: int = 60) -> None:
        if rate <= 0:
            raise StageError(f"a stage needs a rate above 0 Hz, not {rate}")
        self.seed, self.rate = seed, rate
        self.roles: dict[str, Role] = {}
        """all versions of all roles by the names that the log uses: a role's own, and `name@2` … for those that edits brought"""
        self.actions: deque[Action] = deque(maxlen=LONGEST_HISTORY)
        self.verdicts: deque[Verdict] = deque(maxlen=LONGEST_HISTORY)
        self.head = 0
        self._state = StageState()
        self._log: Log = MemoryLog()
        self._snapshots = Snapshots(self._state)

    # what it shows

    @property
    def tick(self) -> int:
        """The tick that is shown."""
        return self._state.tick

    @property
    def first(self) -> int:
        """The oldest tick that can be sought."""
        return 0

    @property
    def seconds(self) -> float:
        """The time that is shown."""
        return self.tick / self.rate

    @property
    def state(self) -> StageState:
        """The state that is shown; immutable."""
        return self._state

    @property
    def frame(self) -> Frame:
        """What is shown: poses, places, and what happened in this tick."""
        return self._state.frame()

    @property
    def hash(self) -> str:
        """16 hexadecimal digits: two stages with the same hash have gone through the same states."""
        return self._state.hash

    @property
    def log(self) -> list[LogEntry]:
        """All that came from outside."""
        return list(self._log)

    def entries(self, tick: int) -> list[LogEntry]:
        """What came from outside for one tick."""
        return self._log.at(tick)

    def dump(self) -> list[str]:
        """The log as JSON lines, for `replay`."""
        return dump(self._log, {"seed": self.seed, "rate": self.rate, "head": self.head})

    # where it is

    def step(self, n: int = 1) -> None:
        """`n` ticks on: along what has been as far as it reaches, then into what is new."""
        for _ in range(n):
            self._forward()

    def stepping(self, n: int, most: int = SLICE) -> Iterator[int]:
        """`step(n)` in slices of at most `most` ticks: each time it is resumed it takes one, and yields the tick it has got to."""
        for done in range(0, n, most):
            self.step(min(most, n - done))
            yield self.tick

    def seek(self, tick: int) -> None:
        """Show another tick between `first` and `head`. Raises StageError outside."""
        for _ in self.seeking(tick):
            pass

    def seeking(self, tick: int, most: int = SLICE) -> Iterator[int]:
        """`seek(tick)` in slices of at most `most` ticks, each yielding the tick that it has got to.

        The playhead moves when it is through. In between the stage may go on, and another thread may use it.
        """
        self._check(tick)
        state = self._nearest(tick)
        while state.tick < tick:
            for _ in range(min(most, tick - state.tick)):
                state = self.after(state)
            yield state.tick
        self._state = state

    def state_at(self, tick: int) -> StageState:
        """The state of a tick, without moving the playhead; raises StageError outside `first` … `head`."""
        self._check(tick)
        state = self._nearest(tick)
        while state.tick < tick:
            state = self.after(state)
        return state

    def fork(self) -> Self:
        """A stage of its own that shares the past up to the tick that is shown; the way to change it.

        At the head it takes along what was sent and waits for the next tick.
        """
        return self._branch(self.tick, self._state, self._log.at(self.head + 1) if self.tick == self.head else ())

    def fork_at(self, tick: int) -> Self:
        """A stage of its own that shares the past up to a tick, and nothing of what was sent there; raises StageError outside."""
        return self._branch(tick, self.state_at(tick))

    def copy(self) -> Self:
        """A stage of its own with all of this one's past and its playhead, to look around in."""
        return self._branch(self.head, self._state, self._log.at(self.head + 1))

    @classmethod
    def of(cls, log: Log, roles: Mapping[str, Role], seed: int, rate: int) -> Self:
        """A stage at tick 0 whose future is in its log: steps follow it."""
        stage = cls(seed, rate)
        stage._log, stage.roles = log, dict(roles)
        stage._state = recast(stage._state, log.at(0), roles, 1 / rate)
        return stage

    def _branch(self, head: int, shown: StageState, sent: Iterable[LogEntry] = ()) -> Self:
        branch = type(self)(self.seed, self.rate)
        branch.roles, branch.head, branch._state = dict(self.roles), head, shown
        branch._log, branch._snapshots = self._log.until(head), self._snapshots.until(head)
        for entry in sent:
            branch._log.append(entry)
        branch.actions.extend(action for action in self.actions if action.tick <= head)
        branch.verdicts.extend(verdict for verdict in self.verdicts if verdict.tick <= head)
        return branch

    def _check(self, tick: int) -> None:
        if not self.first <= tick <= self.head:
            raise StageError(f"tick {tick} is not there: this stage has {self.first} … {self.head}")

    def _nearest(self, tick: int) -> StageState:
        """The latest state at hand that is not after `tick`."""
        kept = self._snapshots.nearest(tick)
        return self._state if kept.tick <= self.tick <= tick else kept

    def after(self, state: StageState) -> StageState:
        """The state of the tick that follows one, along the log."""
        entries, dt = self._log.at(state.tick + 1), 1 / self.rate
        return recast(forward(state, entries, dt, self.seed), entries, self.roles, dt)

    def _forward(self) -> None:
        """The next tick, known or new."""
        is_new = self.tick == self.head
        if is_new:
            self._snapshots.offer(self._state)  # nobody comes or goes in this tick any more
        self._state = self.after(self._state)
        if is_new:
            self.head = self.tick
            self.actions.extend(self._state.actions)
            self.verdicts.extend(self._state.verdicts)

    def _recast(self, entries: Sequence[LogEntry]) -> None:
        """Keeps entries that count at once, all in one copy."""
        for entry in entries:
            self.keep(entry)
        self._state = recast(self._state, entries, self.roles, 1 / self.rate)

    def keep(self, entry: LogEntry) -> LogEntry:
        """Takes an entry into the log, all names in it known; raises StageError where the playhead is in the past."""
        self._refuse_past()
        self._log.append(entry)
        return entry

    def _refuse_past(self) -> None:
        if self.tick < self.head:
            raise StageError(f"tick {self.tick} is past (the stage is at {self.head}): call fork() first, and change the fork")

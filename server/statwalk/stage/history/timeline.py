"""The timeline of a stage: its log, its playhead, and its snapshots. All states follow from the log alone."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Self

from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.stage.advance import advance
from statwalk.stage.apply_commands import apply_commands
from statwalk.stage.effects.effects import Effects
from statwalk.stage.effects.verdicts import RememberedVerdicts
from statwalk.stage.history.log import Log
from statwalk.stage.history.log_codec import Beginning
from statwalk.stage.history.past import Past
from statwalk.stage.history.snapshots import Snapshots
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.cast_frame import cast_frame
from statwalk.stage.state.commands import Command, LogEntry
from statwalk.stage.state.frame import Action, Frame
from statwalk.stage.state.stage_state import StageState

LONGEST_HISTORY = 10_000
"""the number of actions and of verdicts that a stage remembers; the log and `seek` give all of them again"""
SLICE = 60
"""ticks after which `seeking` and `stepping` yield"""


class Timeline(Past):
    """A past with a playhead.

    `tick` is the playhead: `seek` moves it anywhere in `first`…`head`, `step` forwards; at the head, steps
    make new ticks.
    """

    def __init__(self, seed: int = 0, rate: int = 60) -> None:
        self._state, self._effects = StageState(), Effects()
        super().__init__(seed, rate, self._state)
        self.actions: deque[Action] = deque(maxlen=LONGEST_HISTORY)
        self.verdicts = RememberedVerdicts(LONGEST_HISTORY)
        self.remembered_from = 0
        """the oldest tick whose actions and verdicts are remembered, if they are not too many"""
        self.before_tick: Callable[[], None] = lambda: None
        """called before each tick is computed; an exception from it ends a long seek"""
        self._head_hash = ""
        """that of the newest tick, while an older one is shown"""

    # the tick that is shown

    @property
    def tick(self) -> int:
        """The tick that is shown."""
        return self._state.tick

    @property
    def seconds(self) -> float:
        """The time of the tick that is shown."""
        return self.tick / self.rate

    @property
    def state(self) -> StageState:
        """The state that is shown. The next step takes this object over: keep a `copy()`."""
        return self._state

    @property
    def effects(self) -> Effects:
        """The effects of the tick that is shown."""
        return self._effects

    @property
    def casts(self) -> list[Cast]:
        """The actors at the tick that is shown, by role."""
        return [Cast.of(self.roles[key], cast) for key, cast in self._state.casts.items()]

    @property
    def frame(self) -> Frame:
        """The frame of the tick that is shown: poses, places, and the events of the tick."""
        casts = tuple(cast_frame(cast) for cast in self.casts)
        return Frame(self.tick, self.hash, casts, self._effects.actions, self._effects.verdicts)

    @property
    def hash(self) -> str:
        """16 hexadecimal digits: two stages with the same hash have gone through the same states."""
        return self._state.hash

    @property
    def head_hash(self) -> str:
        """The hash of the newest tick."""
        return self.hash if self.tick == self.head else self._head_hash

    # the playhead

    def step(self, n: int = 1) -> None:
        """Steps `n` ticks: along the log up to the head, then into new ticks."""
        for _ in range(n):
            self._forward()

    def stepping(self, n: int, most: int = SLICE) -> Iterator[int]:
        """Runs `step(n)` in slices of at most `most` ticks; yields the tick reached after each slice."""
        for done in range(0, n, most):
            self.step(min(most, n - done))
            yield self.tick

    def seek(self, tick: int) -> None:
        """Moves the playhead to a tick; :raises StageError: when the stage does not have the tick."""
        for _ in self.seeking(tick):
            pass

    def seeking(self, tick: int, most: int = SLICE) -> Iterator[int]:
        """Runs `seek(tick)` in slices of at most `most` ticks; yields the tick reached after each slice.

        The playhead moves at the end. In between the stage may go on, and another thread may use it.
        """
        self.check(tick)
        state, effects = self.state_before(tick), Effects()
        while state.tick < tick:
            for _ in range(min(most, tick - state.tick)):
                state, effects = self.after(state)
            yield state.tick
        self._head_hash = self.head_hash
        self._state, self._effects = state, effects

    def state_at(self, tick: int) -> StageState:
        """Returns a copy of a tick's state; :raises StageError: when the stage does not have the tick."""
        self.check(tick)
        state = self.state_before(tick)
        while state.tick < tick:
            state, _ = self.after(state)
        return state

    def state_before(self, tick: int) -> StageState:
        """Returns a copy of the latest available state before `tick`, so that the step to `tick` gives its
        effects again; for the oldest tick the state of that tick.
        """
        kept = self.snapshots.nearest(max(tick - 1, self.first))
        if kept <= self.tick < max(tick, self.first + 1):
            return self._state.copy()
        return self.snapshots.open(kept, self.roles)

    def fork(self) -> Self:
        """Returns an independent stage that shares the past up to the tick that is shown.

        At the head the fork also takes the commands that wait for the next tick, under the same numbers.
        """
        return self._branch(self.tick, self._state.copy(), takes_waiting=self.tick == self.head)

    def fork_at(self, tick: int) -> Self:
        """Returns an independent stage that shares the past up to a tick, without its waiting commands."""
        return self.fork_from(self.state_at(tick))

    def fork_from(self, state: StageState) -> Self:
        """Returns an independent stage that goes on from a state of this stage, which it takes over."""
        return self._branch(state.tick, state, takes_waiting=False)

    def copy(self) -> Self:
        """Returns an independent stage with the same past and playhead."""
        return self._branch(self.head, self._state.copy(), takes_waiting=True)

    @classmethod
    def of(
        cls,
        log: Log,
        roles: Mapping[str, Role],
        start: StageState,
        seed: int,
        rate: int,
        beginning: Beginning | None = None,
    ) -> Self:
        """Returns a stage at the state `start`, whose steps follow a log; `beginning`: if the past of `start`
        was forgotten.
        """
        stage = cls(seed, rate)
        stage._log, stage.roles = log, dict(roles)
        if beginning:
            stage.begin_with(start, beginning)
        stage._state = apply_commands(roles, start, stage.commands(start.tick), 1 / rate)
        return stage

    def resume(self, head: int, snapshots: Mapping[int, bytes]) -> None:
        """Takes a stage from its first tick to tick `head` of its log, from the newest snapshot on that is at
        least a second older; remembers the actions and verdicts since that snapshot.

        :raises StageError: when the snapshots do not fit the stage.
        """
        self.snapshots = Snapshots(self._state, later=snapshots)
        self.head = self.remembered_from = self.snapshots.nearest(max(head - self.rate, self.first))
        self._state = self.snapshots.open(self.head, self.roles)
        self.step(head - self.head)

    def after(self, state: StageState) -> tuple[StageState, Effects]:
        """Returns the state after the next tick, along the log, and the effects of that tick.

        Takes `state` over. :raises StageError: when that part of the log was forgotten meanwhile.
        """
        self.before_tick()
        if state.tick < self.first:
            self.check(state.tick)
        return advance(self.roles, state, self.commands(state.tick + 1), 1 / self.rate, self.seed)

    def keep(self, tick: int, command: Command) -> LogEntry:
        """Appends a command to the log; :raises StageError: when the playhead is in the past."""
        self._refuse_past()
        (number,) = self._log.append(tick, [command])
        return LogEntry(number, tick, command)

    def _branch(self, head: int, shown: StageState, *, takes_waiting: bool) -> Self:
        branch = type(self)(self.seed, self.rate)
        branch.take_past(self, head, self._log.until(head, takes_waiting), self.roles)
        branch._state, branch._head_hash = shown, self._head_hash
        branch.before_tick = self.before_tick
        branch._effects = self._effects if shown.tick == self.tick else Effects()
        branch.actions.extend(action for action in self.actions if action.tick <= head)
        branch.verdicts, branch.remembered_from = self.verdicts.until(head), self.remembered_from
        return branch

    def _forward(self) -> None:
        is_new = self.tick == self.head
        if is_new:
            self.snapshots.offer(self._state)  # no actor is added or removed in this tick any more
        self._state, self._effects = self.after(self._state)
        if is_new:
            self.head = self.tick
            self.actions.extend(self._effects.actions)
            self.verdicts.extend(self._effects.verdicts)

    def _apply(self, commands: Sequence[Command]) -> None:
        self._refuse_past()
        self._log.append(self.tick, commands)
        self._state = apply_commands(self.roles, self._state, commands, 1 / self.rate)

    def _refuse_past(self) -> None:
        if self.tick < self.head:
            past = f"tick {self.tick} is past (the stage is at {self.head})"
            raise StageError(f"{past}: call fork() first, and change the fork")

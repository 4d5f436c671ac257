"""A stage: actors, a log and a playhead. The only thing here that changes; what it shows follows from its log alone."""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from math import isfinite

from statwalk.errors import StageError, UnknownNameError
from statwalk.stage.actor import Actor
from statwalk.stage.cast import Cast
from statwalk.stage.fold import StageState, forward, recast
from statwalk.stage.frame import Action, Frame, Verdict
from statwalk.stage.log import Log, LogEntry, MemoryLog, dump
from statwalk.stage.role import Role
from statwalk.stage.snapshot import Snapshots

__all__ = ["Actor", "Stage"]

LONGEST_HISTORY = 10_000
"""actions and verdicts that a stage remembers; the log and `seek` give all of them again"""


class Stage:
    """Actors and their time, in fixed steps of 1/`rate` seconds.

        stage = Stage(seed=1)
        actor = stage.add(walker)
        stage.send(actor, "FORWARD")
        stage.step(30)
        actor.state, actor.pose, stage.hash

    `tick` is the playhead: `seek` moves it anywhere in 0…`head`, `step` onwards; at the head, steps make new ticks.
    """

    def __init__(self, seed: int = 0, rate: int = 60) -> None:
        if rate <= 0:
            raise StageError(f"a stage needs a rate above 0 Hz, not {rate}")
        self.seed, self.rate = seed, rate
        self.roles: dict[str, Role] = {}
        self.actions: deque[Action] = deque(maxlen=LONGEST_HISTORY)
        self.verdicts: deque[Verdict] = deque(maxlen=LONGEST_HISTORY)
        self.head = 0
        self._state = StageState()
        self._log: Log = MemoryLog()
        self._snapshots = Snapshots(self._state)

    # what it is

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

    @property
    def actors(self) -> list[Actor]:
        """Those who are there at this tick, in the order of their ids."""
        return [Actor(actor, self._find) for actor in sorted(int(actor) for cast in self._state.casts for actor in cast.ids)]

    def actor(self, actor: int) -> Actor:
        """The actor of that id; raises UnknownNameError where there is none at this tick."""
        self._find(actor)
        return Actor(actor, self._find)

    def dump(self) -> list[str]:
        """The log as JSON lines, for `replay`."""
        return dump(self._log, {"seed": self.seed, "rate": self.rate, "head": self.head})

    # what comes from outside

    def add(self, role: Role, position: Sequence[float] = (0.0, 0.0, 0.0), heading: float = 0.0, name: str | None = None) -> Actor:
        """A new actor at `position` (metres), facing +Z turned by `heading` radians to the left. It is there at once."""
        if self.roles.setdefault(role.name, role) is not role:
            raise StageError(f"another role on this stage is called {role.name!r}; use the one it was given first")
        place = [float(part) for part in position]
        if len(place) != 3 or not all(map(isfinite, (*place, heading))):
            raise StageError(f"a place is x, y, z and a heading, all finite; not {position!r}, {heading!r}")
        actor = self._state.next_id
        value = {"role": role.name, "position": place, "heading": float(heading)}
        self._recast(LogEntry(self.tick, "add", actor, name or f"{role.name} {actor}", value))
        return Actor(actor, self._find)

    def remove(self, actor: Actor | int) -> None:
        """The actor leaves, at once."""
        gone = self._known(actor)
        self._recast(LogEntry(self.tick, "remove", gone, ""))

    def send(self, actor: Actor | int, event: str) -> LogEntry:
        """An event, which counts in the next tick; raises UnknownNameError, and StageError when looking at the past."""
        return self._input("press", actor, event)

    def hold(self, actor: Actor | int, event: str) -> LogEntry:
        """The event counts again at every END and in every new state, until it is released."""
        return self._input("hold", actor, event)

    def release(self, actor: Actor | int, event: str) -> LogEntry:
        """The end of `hold`."""
        return self._input("release", actor, event)

    def set(self, actor: Actor | int, parameter: str, value: float) -> LogEntry:
        """A parameter of the machine, from the next tick on; raises StageError where the value is out of its range."""
        cast, _ = self._find(self._known(actor))
        known = cast.role.machine.parameters[cast.role.parameter(parameter)]
        if not known.minimum <= value <= known.maximum:
            raise StageError(f"{parameter} must lie in {known.minimum} … {known.maximum}, not at {value}")
        return self._keep(LogEntry(self.tick + 1, "set", self._known(actor), parameter, float(value)))

    # time

    def step(self, n: int = 1) -> None:
        """`n` ticks on: along what has been as far as it reaches, then into what is new."""
        for _ in range(n):
            self._forward()

    def seek(self, tick: int) -> None:
        """Show another tick between `first` and `head`. Raises StageError outside."""
        if not self.first <= tick <= self.head:
            raise StageError(f"tick {tick} is not there: this stage has {self.first} … {self.head}")
        if tick < self.tick:
            self._state = self._snapshots.nearest(tick)
        else:
            self._state = max(self._state, self._snapshots.nearest(tick), key=lambda state: state.tick)
        while self.tick < tick:
            self._forward()

    def fork(self) -> Stage:
        """A stage of its own that shares the past up to the tick that is shown; the way to change it.

        At the head it takes along what was sent and waits for the next tick.
        """
        return self._branch(self.tick)

    def copy(self) -> Stage:
        """A stage of its own with all of this one's past and its playhead, to look around in."""
        return self._branch(self.head)

    @classmethod
    def of(cls, log: Log, roles: Mapping[str, Role], seed: int, rate: int) -> Stage:
        """A stage at tick 0 whose future is in its log: steps follow it."""
        stage = cls(seed, rate)
        stage._log, stage.roles = log, dict(roles)
        stage._state = recast(stage._state, log.at(0), roles)
        return stage

    def _branch(self, head: int) -> Stage:
        branch = Stage(self.seed, self.rate)
        branch.roles, branch.head, branch._state = dict(self.roles), head, self._state
        branch._log, branch._snapshots = self._log.until(head), self._snapshots.until(head)
        for entry in self._log.at(head + 1) if head == self.head else ():
            branch._log.append(entry)
        branch.actions.extend(action for action in self.actions if action.tick <= head)
        branch.verdicts.extend(verdict for verdict in self.verdicts if verdict.tick <= head)
        return branch

    def _forward(self) -> None:
        """The next tick, known or new."""
        is_new = self.tick == self.head
        if is_new:
            self._snapshots.offer(self._state)  # nobody comes or goes in this tick any more
        entries = self._log.at(self.tick + 1)
        self._state = recast(forward(self._state, entries, 1 / self.rate), entries, self.roles)
        if is_new:
            self.head = self.tick
            self.actions.extend(self._state.actions)
            self.verdicts.extend(self._state.verdicts)

    def _input(self, kind: str, actor: Actor | int, event: str) -> LogEntry:
        known = self._known(actor)
        self._find(known)[0].role.event(event)
        return self._keep(LogEntry(self.tick + 1, kind, known, event))

    def _recast(self, entry: LogEntry) -> None:
        self._state = recast(self._state, [self._keep(entry)], self.roles)

    def _keep(self, entry: LogEntry) -> LogEntry:
        if self.tick < self.head:
            raise StageError(f"tick {self.tick} is past (the stage is at {self.head}): call fork() first, and change the fork")
        self._log.append(entry)
        return entry

    def _known(self, actor: Actor | int) -> int:
        number = actor.id if isinstance(actor, Actor) else actor
        self._find(number)
        return number

    def _find(self, actor: int) -> tuple[Cast, int]:
        found = self._state.find(actor)
        if found is None:
            raise UnknownNameError("actor", str(actor), [str(one.id) for one in self.actors])
        return found

"""A stage: actors and what they are told. It is the only thing here that changes; what it shows follows from its log alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import count
from math import isfinite

from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.travel import Plan, plan, reachable
from statwalk.stage.actor import Actor
from statwalk.stage.cast import Cast
from statwalk.stage.editing.edit import check_joints
from statwalk.stage.past.log import LogEntry
from statwalk.stage.past.timeline import LONGEST_HISTORY, Timeline
from statwalk.stage.role import Role

__all__ = ["LONGEST_HISTORY", "Actor", "Stage"]


class Stage(Timeline):
    """Actors and their time, in fixed steps of 1/`rate` seconds.

        stage = Stage(seed=1)
        actor = stage.add(walker)
        stage.send(actor, "FORWARD")
        stage.step(30)
        actor.state, actor.pose, stage.hash

    `tick` is the playhead: `seek` moves it anywhere in 0…`head`, `step` onwards; at the head, steps make new ticks.
    """

    @property
    def actors(self) -> list[Actor]:
        """Those who are there at this tick, in the order of their ids."""
        return [Actor(actor, self._find) for actor in sorted(int(actor) for cast in self._state.casts for actor in cast.ids)]

    def actor(self, actor: int) -> Actor:
        """The actor of that id; raises UnknownNameError where there is none at this tick."""
        self._find(actor)
        return Actor(actor, self._find)

    def role(self, name: str) -> Role:
        """The version of a role that is in force at this tick; raises UnknownNameError where none of that name was ever here."""
        if name not in self.roles:
            raise UnknownNameError("role", name, {role.name for role in self.roles.values()})
        return self.roles[self._state.versions.get(name, name)]

    # who is there

    def add(self, role: Role, position: Sequence[float] = (0.0, 0.0, 0.0), heading: float = 0.0, name: str | None = None) -> Actor:
        """A new actor at `position` (metres), facing +Z turned by `heading` radians to the left. It is there at once."""
        return self.add_many(role, [(position, heading)], name and [name])[0]

    def add_many(
        self, role: Role, places: Iterable[tuple[Sequence[float], float]], names: Sequence[str | None] | None = None
    ) -> list[Actor]:
        """New actors at places (position in metres, heading in radians), there at once; all together cost little more than one."""
        self.roles.setdefault(role.name, role)
        if self.role(role.name) is not role:
            raise StageError(f"another role on this stage is called {role.name!r}; use stage.role({role.name!r}), or edit it")
        key = self._state.versions.get(role.name, role.name)
        first, known = self._state.next_id, [_checked(*place) for place in places]
        called = names or [None] * len(known)
        self._recast(
            [
                LogEntry(self.tick, "add", actor, name or f"{role.name} {actor}", {"role": key, "position": place[:3], "heading": place[3]})
                for actor, place, name in zip(range(first, first + len(known)), known, called, strict=True)
            ]
        )
        return [Actor(actor, self._find) for actor in range(first, first + len(known))]

    def remove(self, actor: Actor | int) -> None:
        """The actor leaves, at once."""
        self._recast([LogEntry(self.tick, "remove", self._known(actor), "")])

    def edit(self, role: Role, text: str = "") -> LogEntry:
        """Another version of the role of that name, in force at once; `text`, its machine file, goes into the log.

        Everybody who plays it goes on where he is, by the names of states, parameters and events; raises UnknownNameError where there is
        no role of that name, and StageError where it has other joints.
        """
        check_joints(self.role(role.name), role)
        key = next(key for number in count(2) if (key := f"{role.name}@{number}") not in self.roles)
        entry = LogEntry(self.tick, "edit", 0, role.name, {"role": key, "text": text})
        self._refuse_past()
        self.roles[key] = role
        self._recast([entry])
        return entry

    # what they are told

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
        return self.keep(LogEntry(self.tick + 1, "set", self._known(actor), parameter, float(value)))

    def travel(self, actor: Actor | int, state: str) -> Plan:
        """The actor goes to a state of its base, by the events that lead there soonest; whatever else it is sent counts as well.

        Raises UnknownNameError for a state that does not exist, StageError, naming those that can be reached, where there is no way.
        """
        known = self._known(actor)
        cast, row = self._find(known)
        machine = cast.role.machine
        here, goal = int(cast.machine.state[row, 0]), cast.role.state(state)
        found = plan(machine, here, goal)
        if found is None:
            there = ", ".join(name for name in reachable(machine, here) if name != machine.states[here]) or "no other state"
            raise StageError(f"no way leads from {machine.states[here]} to {state}; from there can be reached: {there}")
        self.keep(LogEntry(self.tick + 1, "travel", known, state))
        return found

    def cancel_travel(self, actor: Actor | int) -> LogEntry:
        """The actor goes nowhere in particular any more."""
        return self.keep(LogEntry(self.tick + 1, "travel", self._known(actor), ""))

    def _input(self, kind: str, actor: Actor | int, event: str) -> LogEntry:
        known = self._known(actor)
        self._find(known)[0].role.event(event)
        return self.keep(LogEntry(self.tick + 1, kind, known, event))

    def _known(self, actor: Actor | int) -> int:
        number = actor.id if isinstance(actor, Actor) else actor
        self._find(number)
        return number

    def _find(self, actor: int) -> tuple[Cast, int]:
        found = self._state.find(actor)
        if found is None:
            raise UnknownNameError("actor", str(actor), [str(one.id) for one in self.actors])
        return found


def _checked(position: Sequence[float], heading: float) -> list[float]:
    """x, y, z, heading as numbers."""
    place = [float(part) for part in (*position, heading)]
    if len(place) != 4 or not all(map(isfinite, place)):
        raise StageError(f"a place is x, y, z and a heading, all finite; not {position!r}, {heading!r}")
    return place

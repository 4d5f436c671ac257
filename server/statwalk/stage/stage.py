"""A stage: actors and their commands.

A stage is the only object here that changes; all states follow from its log alone.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import count
from math import isfinite

from statwalk.character.role import Role
from statwalk.errors import StageError, UnknownNameError
from statwalk.machine.settings import settings
from statwalk.machine.travel import Plan, plan, reachable
from statwalk.stage.actor import Actor, Found
from statwalk.stage.history.log_codec import dump
from statwalk.stage.history.timeline import LONGEST_HISTORY, Timeline
from statwalk.stage.migrate.migrate import check_joints
from statwalk.stage.state.cast import Cast
from statwalk.stage.state.commands import (
    Add,
    Edit,
    EventInput,
    Hold,
    LogEntry,
    Press,
    Release,
    Remove,
    Set,
    Travel,
)

__all__ = ["LONGEST_HISTORY", "Actor", "Stage"]


class Stage(Timeline):
    """Actors and their time, in fixed steps of 1/`rate` seconds.

        stage = Stage(seed=1)
        actor = stage.add(walker)
        stage.send(actor, "FORWARD")
        stage.step(30)
        actor.state, actor.pose, stage.hash

    `tick` is the playhead: `seek` moves it anywhere in 0…`head`, `step` onwards; at the head, steps make new
    ticks.
    """

    def __repr__(self) -> str:
        return f"Stage(tick {self.tick} of {self.head}, {len(self._state.ids)} actors, seed {self.seed})"

    @property
    def actors(self) -> list[Actor]:
        """The actors at the tick that is shown, by id."""
        return [Actor(actor, self._find) for actor in self._state.ids]

    def actor(self, actor: int) -> Actor:
        """Returns the actor with an id.

        :raises UnknownNameError: when the actor does not exist at the tick that is shown.
        """
        self._find(actor)
        return Actor(actor, self._find)

    def role(self, name: str) -> Role:
        """Returns the version of a role in force at the tick that is shown.

        :raises UnknownNameError: when the stage never had a role of this name.
        """
        if name not in self.roles:
            raise UnknownNameError("role", name, {role.name for role in self.roles.values()})
        return self.roles[self._state.versions.get(name, name)]

    def dump(self) -> list[str]:
        """Returns the log as JSON lines, for `replay`."""
        return list(self.dumping())

    def dumping(self) -> Iterator[str]:
        """Yields the log as it is now as JSON lines, for `replay`; the stage may go on in between."""
        log = self._log.until(self.head, takes_waiting=True)
        header = {"seed": self.seed, "rate": self.rate, "head": self.head, "hash": self.head_hash}
        return dump(log, header, self.beginning)

    # actors and roles

    def add(
        self,
        role: Role,
        position: Sequence[float] = (0.0, 0.0, 0.0),
        heading: float = 0.0,
        name: str | None = None,
    ) -> Actor:
        """Adds an actor at once, at `position` (metres), facing +Z turned by `heading` radians to
        the left.
        """
        return self.add_many(role, [(position, heading)], name and [name])[0]

    def add_many(
        self,
        role: Role,
        places: Iterable[tuple[Sequence[float], float]],
        names: Sequence[str | None] | None = None,
    ) -> list[Actor]:
        """Adds actors at once, at places (position in metres, heading in radians); many cost little more than
        one.

        :raises StageError: when another role of the same name is on the stage, or a place is not finite.
        """
        self.roles.setdefault(role.name, role)
        if self.role(role.name) is not role:
            raise StageError(
                f"another role on this stage is called {role.name!r}; use stage.role({role.name!r}), or edit "
                "it"
            )
        key = self._state.versions.get(role.name, role.name)
        first, checked = self._state.next_id, [_checked(*place) for place in places]
        called = [name and _writable(name) for name in names or [None] * len(checked)]
        self._apply(
            [
                Add(actor, name or f"{role.name} {actor}", key, (place[0], place[1], place[2]), place[3])
                for actor, place, name in zip(
                    range(first, first + len(checked)), checked, called, strict=True
                )
            ]
        )
        return [Actor(actor, self._find) for actor in range(first, first + len(checked))]

    def remove(self, actor: Actor | int) -> None:
        """Removes an actor at once."""
        self._apply([Remove(self._id_of(actor))])

    def edit(self, role: Role, text: str = "") -> Edit:
        """Replaces the role of the same name by another version at once; `text`, its machine file, is logged.

        Every actor of the role keeps its state, by the names of states, parameters and events; a state that
        was renamed is found by its motion.

        :raises UnknownNameError: when the stage has no role of this name.
        :raises StageError: when the new version has other joints.
        """
        check_joints(self.role(role.name), role)
        key = next(key for number in count(2) if (key := f"{role.name}@{number}") not in self.roles)
        self._refuse_past()
        self.roles[key] = role
        command = Edit(role.name, key, text)
        self._apply([command])
        return command

    # inputs

    def send(self, actor: Actor | int, event: str) -> LogEntry:
        """Sends an event, which counts in the next tick.

        :raises UnknownNameError: when the actor or the event does not exist.
        :raises StageError: when the playhead is in the past.
        """
        return self._input(Press, actor, event)

    def hold(self, actor: Actor | int, event: str) -> LogEntry:
        """Holds an event: it counts again at every END and in every new state, until it is released."""
        return self._input(Hold, actor, event)

    def release(self, actor: Actor | int, event: str) -> LogEntry:
        """Releases an event that is held."""
        return self._input(Release, actor, event)

    def set(self, actor: Actor | int, parameter: str, value: float | Sequence[float]) -> LogEntry:
        """Sets a parameter of the machine, from the next tick on; a point, direction or rotation to a list of
        numbers, logged one by one. Returns the last entry.

        :raises UnknownNameError: when the machine has no parameter of that name.
        :raises StageError: when the value is out of range, or does not fit the kind of the parameter.
        """
        actor_id = self._id_of(actor)
        cast, row, *_ = self._find(actor_id)
        numbers = settings(cast.role.machine, parameter, value, cast.machine.parameters[row])
        return [self.keep(self.tick + 1, Set(actor_id, name, number)) for name, number in numbers][-1]

    def travel(self, actor: Actor | int, state: str) -> Plan:
        """Makes the actor travel to a state of its base layer, by the events that lead there soonest; other
        events count as well.

        :raises UnknownNameError: when the state does not exist.
        :raises StageError: when no path leads to the state; the message names the states that can be reached.
        """
        actor_id = self._id_of(actor)
        cast, row, *_ = self._find(actor_id)
        machine = cast.role.machine
        start, goal = int(cast.machine.state[row, 0]), cast.role.state(state)
        route = plan(machine, start, goal)
        if route is None:
            reachable_names = (
                ", ".join(name for name in reachable(machine, start) if name != machine.states[start])
                or "no other state"
            )
            raise StageError(
                f"no way leads from {machine.states[start]} to {state}; from there can be reached: "
                f"{reachable_names}"
            )
        self.keep(self.tick + 1, Travel(actor_id, state))
        return route

    def cancel_travel(self, actor: Actor | int) -> LogEntry:
        """Cancels travelling."""
        return self.keep(self.tick + 1, Travel(self._id_of(actor), ""))

    def _input(self, kind: type[EventInput], actor: Actor | int, event: str) -> LogEntry:
        actor_id = self._id_of(actor)
        self._find(actor_id).cast.role.event(event)
        return self.keep(self.tick + 1, kind(actor_id, event))

    def _id_of(self, actor: Actor | int) -> int:
        number = actor.id if isinstance(actor, Actor) else actor
        self._find(number)
        return number

    def _find(self, actor: int) -> Found:
        place = self._state.find(actor)
        if place is None:
            raise UnknownNameError("actor", str(actor), map(str, self._state.ids))
        key, row = place
        cast = Cast.of(self.roles[key], self._state.casts[key])
        return Found(cast, row, self._state.names[actor], self._state.tick, 1 / self.rate)


def _writable(name: str) -> str:
    """Returns the name, which a log can hold.

    :raises StageError: when UTF-8 cannot say the name.
    """
    try:
        name.encode()
    except UnicodeEncodeError:
        raise StageError(f"the name {name!r} has half a character (a lone surrogate); leave it out") from None
    return name


def _checked(position: Sequence[float], heading: float) -> list[float]:
    """x, y, z, heading as numbers."""
    place = [float(part) for part in (*position, heading)]
    if len(place) != 4 or not all(map(isfinite, place)):
        raise StageError(f"a place is x, y, z and a heading, all finite; not {position!r}, {heading!r}")
    return place

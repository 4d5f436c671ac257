"""What if: one thing is done otherwise in a fork of the past, and the event is watched there until it fires."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from statwalk.machine.authored.celldefinition import NOW as AT_ONCE
from statwalk.machine.authored.celldefinition import CellDefinition
from statwalk.machine.authored.definition import END, MachineDefinition
from statwalk.machine.built.build import MotionFacts, build
from statwalk.stage.fold import StageState, forward
from statwalk.stage.past.log import LogEntry
from statwalk.stage.role import Role
from statwalk.stage.stage import Stage

LONGEST_S = 10.0
"""seconds for which an event is watched"""
MOST_STEPS = 60_000
"""ticks times actors after which a crowd is watched no longer, but for a second in any case"""

Change = Mapping[str, Any]
"""one thing done otherwise: `kind`, and what belongs to it; see `tried`"""


class Trial(NamedTuple):
    """The fork at the tick in which it was let go, and the tick in which the event fired there, None if it did not."""

    stage: Stage
    fired: int | None


def tried(stage: Stage, actor: int, event: str, tick: int, change: Change) -> Trial:
    """What a change would have made of `event` in `tick`; `stage` itself stays as it is.

    Kinds: `send` and `moment` (`tick`: the event is sent in that one), `set` (`parameter`, `value`, `tick`), `hold`, `release`,
    `state` (`state`: the actor goes there first), `cell` (`layer`, `state`, `event`, `to`, `restart`), `buffer` (`event`, `seconds`).
    """
    attempt = Attempt(stage, actor, event, tick)
    fired = getattr(attempt, f"try_{change['kind']}")(change)
    return Trial(attempt.fork, attempt.fork.tick if fired else None)


def came(stage: Stage, actor: int, event: str, tick: int) -> bool:
    """Whether an event reached an actor in a tick, whatever became of it."""
    done = forward(stage.state_at(tick - 1), stage.entries(tick), 1 / stage.rate, stage.seed)
    return any((one.actor, one.event) == (actor, event) for one in done.verdicts)


def longest(stage: Stage, state: StageState) -> int:
    """Ticks for which a stage is watched."""
    actors = sum(len(cast.ids) for cast in state.casts)
    return max(stage.rate, min(round(LONGEST_S * stage.rate), MOST_STEPS // max(actors, 1)))


class Attempt:
    """A fork, stepped along the log of its origin with something changed."""

    def __init__(self, stage: Stage, actor: int, event: str, tick: int) -> None:
        self.origin, self.actor, self.event, self.tick = stage, actor, event, tick
        self.fork = stage
        self.press = LogEntry(tick, "press", actor, event)
        self.sent = [] if event == END else [self.press]

    def begin(self, tick: int) -> None:
        """The fork, at the tick before `tick`."""
        self.fork = self.origin.fork_at(min(tick - 1, self.origin.head))
        while self.fork.tick < tick - 1:
            self.step(self.origin.entries(self.fork.tick + 1))

    def step(self, entries: Iterable[LogEntry] = ()) -> bool:
        """A tick with these entries; whether the event fired in it."""
        for entry in entries:
            self.fork.keep(replace(entry, tick=self.fork.tick + 1))
        self.fork.step()
        return any((one.actor, one.event, one.verdict) == (self.actor, self.event, "taken") for one in self.fork.state.verdicts)

    def watch(self, along: bool = False) -> bool:
        """Steps until the event fires; `along` the log of the origin, or with nothing from outside any more."""
        ticks = range(longest(self.fork, self.fork.state))
        return any(self.step(self.origin.entries(self.fork.tick + 1) if along else ()) for _ in ticks)

    def given(self) -> list[LogEntry]:
        """The entries of the tick in question, the event among them, unless it comes about in another way."""
        entries = self.origin.entries(self.tick)
        return entries if came(self.origin, self.actor, self.event, self.tick) else [*entries, *self.sent]

    def others(self) -> Sequence[LogEntry]:
        """The entries of the tick in question without the event."""
        own = (self.actor, self.event)
        return [
            entry for entry in self.origin.entries(self.tick) if entry.kind not in ("press", "hold") or (entry.actor, entry.name) != own
        ]

    def try_send(self, change: Change) -> bool:
        """Sent in another tick."""
        self.begin(change["tick"])
        return self.step([*self.origin.entries(change["tick"]), *self.sent])

    try_moment = try_send

    def try_set(self, change: Change) -> bool:
        """A parameter at another value from some tick on."""
        self.begin(change["tick"])
        entries: list[LogEntry] = [LogEntry(0, "set", self.actor, change["parameter"], change["value"])]
        while self.fork.tick < self.tick - 1:
            self.step([*entries, *self.origin.entries(self.fork.tick + 1)])
            entries = []
        machine = self.role().machine
        senses = {machine.events[one.event] for one in machine.senses}
        return self.step([*entries, *(self.origin.entries(self.tick) if self.event in senses else self.given())])

    def try_hold(self, _: Change) -> bool:
        """Held down rather than pressed."""
        self.begin(self.tick)
        return self.step([*self.others(), replace(self.press, kind="hold")]) or self.watch()

    def try_release(self, _: Change) -> bool:
        """Let go before it is sent again."""
        self.begin(self.tick)
        return self.step([replace(self.press, kind="release"), *self.given()])

    def try_state(self, change: Change) -> bool:
        """Sent when the actor has gone to another state."""
        self.begin(self.tick)
        travel = LogEntry(self.tick, "travel", self.actor, change["state"])
        self.step([*self.others(), travel])
        for _ in range(longest(self.fork, self.fork.state)):
            if self.fork.actor(self.actor).state == change["state"]:
                return self.step([self.press])
            self.step()
        return False

    def try_cell(self, change: Change) -> bool:
        """Another cell in the table."""
        cell = CellDefinition(change["to"], 0, restart=change.get("restart", False), when=AT_ONCE)
        self.begin(self.tick)
        role = self.role()
        layer = [one.name for one in role.machine.layers][change["layer"]]
        self.fork.edit(with_definition(role, with_cell(role.definition, layer, (change["state"], change["event"]), cell)))
        return self.step(self.given()) or (self.event == END and self.watch(along=True))

    def try_buffer(self, change: Change) -> bool:
        """The event waits longer."""
        self.begin(self.tick)
        role = self.role()
        events = dict(role.definition.events)
        events[self.event] = replace(events[self.event], buffer=change["seconds"])
        self.fork.edit(with_definition(role, replace(role.definition, events=events)))
        return self.step(self.given()) or self.watch(along=True)

    def role(self) -> Role:
        """The actor's, at the tick that the fork has got to."""
        return self.fork.actor(self.actor).role


def with_definition(role: Role, definition: MachineDefinition) -> Role:
    """The role with other cells or buffers; its motions stay."""
    motions = {name: MotionFacts(clip.duration, clip.loop, clip.markers) for name, clip in role.character.clips.items()}
    return replace(role, definition=definition, machine=build(definition, motions))


def with_cell(definition: MachineDefinition, layer: str, place: tuple[str, str], cell: CellDefinition) -> MachineDefinition:
    """The machine with one cell of a layer written anew."""
    if layer not in definition.layers:
        return replace(definition, cells={**definition.cells, place: cell})
    one = definition.layers[layer]
    return replace(definition, layers={**definition.layers, layer: replace(one, cells={**one.cells, place: cell})})

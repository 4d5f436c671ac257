"""Counterfactuals: a fork of the past is changed in one thing, and watched until the event fires."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from statwalk.character.role import Role, facts_of
from statwalk.machine.compile.compile_machine import build
from statwalk.machine.compile.resolved_table import resolved_tables
from statwalk.machine.definition.cell_definition import NOW as AT_ONCE
from statwalk.machine.definition.cell_definition import CellDefinition
from statwalk.machine.definition.machine_definition import END, MachineDefinition
from statwalk.stage.explain.past_states import PastStates
from statwalk.stage.stage import Stage
from statwalk.stage.state.commands import Command, Hold, Press, Release, Set, Travel
from statwalk.stage.state.stage_state import StageState

LONGEST_S = 10.0
"""the longest time for which an event is watched, seconds"""
TICK_COST, ACTOR_COST, MOST_COST = 250, 10, 150_000
"""estimated cost of a tick for each cast and for each actor, and the most that all trials for one question
may cost, in microseconds; a second of the stage is always allowed
"""

Change = Mapping[str, Any]
"""one change: `kind`, and the members of this kind; see `tried`"""


class Trial(NamedTuple):
    """The fork at its last tick, and the tick in which the event fired in the fork, None if it did
    not fire.
    """

    stage: Stage
    fired: int | None


class Budget:
    """The number of ticks left for the trials of one question."""

    def __init__(self, ticks: int, rate: int) -> None:
        self.ticks, self.left, self.rate = ticks, ticks, rate
        self.cut: list[str] = []
        """the kinds of changes that were watched for less than LONGEST_S"""

    @classmethod
    def of(cls, state: StageState, rate: int) -> Budget:
        """Returns the budget of a question about a stage in a state."""
        cost = TICK_COST * len(state.casts) + ACTOR_COST * len(state.ids)
        return cls(max(rate, round(MOST_COST / cost)), rate)

    def watch(self, kind: str, share: float = 1.0) -> Iterator[None]:
        """Yields once for each tick to watch after a change of this kind, while a share of the remaining
        ticks lasts.
        """
        longest, most = round(LONGEST_S * self.rate), int(self.left * share)
        for _ in range(min(longest, most)):
            self.left -= 1
            yield
        if most < longest:
            self.cut.append(kind)


def tried(stage: Stage, actor: int, event: str, tick: int, change: Change) -> Trial:
    """Returns what a change would have made of `event` in `tick`; `stage` itself does not change.

    Kinds: `send` and `moment` (`tick`: the event is sent in that tick), `set` (`parameter`, `value`, `tick`),
    `hold`, `release`, `state` (`state`: the actor goes there first), `cell` (`layer`, `state`, `event`, `to`,
    `restart`), `buffer` (`event`, `seconds`).
    """
    past, watched = PastStates(stage, actor, tick), Budget(round(LONGEST_S * stage.rate), stage.rate)
    attempt = Attempt(past, event, _came(past, event), watched)
    return attempt.trial(change)


def _came(past: PastStates, event: str) -> bool:
    """Whether an event reached the actor in the tick of the question, with any verdict."""
    _, effects = past.stage.after(past.at(past.tick - 1))
    return any((verdict.actor, verdict.event) == (past.actor, event) for verdict in effects.verdicts)


class Attempt:
    """A fork that is stepped along the log of its origin, with one change.

    `came`: whether the event reached the actor in the tick of the question.
    """

    def __init__(self, past: PastStates, event: str, came: bool, budget: Budget) -> None:
        self.past, self.origin, self.actor, self.tick = past, past.stage, past.actor, past.tick
        self.event, self.came, self.budget = event, came, budget
        self.fork = past.stage
        self.press = Press(self.actor, event)
        self.sent: list[Command] = [] if event == END else [self.press]

    def trial(self, change: Change) -> Trial:
        """Returns the fork after a change, see `tried`."""
        fired = getattr(self, f"try_{change['kind']}")(change)
        return Trial(self.fork, self.fork.tick if fired else None)

    def begin(self, tick: int) -> None:
        """Sets the fork to the tick before `tick`."""
        self.fork = self.past.fork(tick - 1)

    def step(self, commands: Iterable[Command] = ()) -> bool:
        """Steps one tick with these commands; returns whether the event fired."""
        for command in commands:
            self.fork.keep(self.fork.tick + 1, command)
        self.fork.step()
        return any(
            (verdict.actor, verdict.event, verdict.verdict) == (self.actor, self.event, "taken")
            for verdict in self.fork.effects.verdicts
        )

    def watch(self, kind: str, along: bool = False) -> bool:
        """Steps until the event fires; `along` the log of the origin, else without commands."""
        return any(
            self.step(self.origin.commands(self.fork.tick + 1) if along else ())
            for _ in self.budget.watch(kind)
        )

    def commands_with_event(self) -> list[Command]:
        """Returns the commands of the tick of the question; adds the event if it did not come in
        that tick.
        """
        commands = self.origin.commands(self.tick)
        return commands if self.came else [*commands, *self.sent]

    def commands_without_event(self) -> Sequence[Command]:
        """Returns the commands of the tick of the question without the event."""
        own = (self.press, Hold(self.actor, self.event))
        return [command for command in self.origin.commands(self.tick) if command not in own]

    def try_send(self, change: Change) -> bool:
        """Sends the event in another tick."""
        self.begin(change["tick"])
        return self.step([*self.origin.commands(change["tick"]), *self.sent])

    try_moment = try_send

    def try_set(self, change: Change) -> bool:
        """Sets a parameter to another value from a tick on."""
        self.begin(change["tick"])
        first: list[Command] = [Set(self.actor, change["parameter"], change["value"])]
        while self.fork.tick < self.tick - 1:
            self.step([*first, *self.origin.commands(self.fork.tick + 1)])
            first = []
        machine = self.role().machine
        senses = {machine.events[sense.event] for sense in machine.senses}
        return self.step(
            [
                *first,
                *(self.origin.commands(self.tick) if self.event in senses else self.commands_with_event()),
            ]
        )

    def try_hold(self, _: Change) -> bool:
        """Holds the event down instead of pressing it."""
        self.begin(self.tick)
        return self.step([*self.commands_without_event(), Hold(self.actor, self.event)]) or self.watch("hold")

    def try_release(self, _: Change) -> bool:
        """Releases the event before it is sent again."""
        self.begin(self.tick)
        return self.step([Release(self.actor, self.event), *self.commands_with_event()])

    def try_state(self, change: Change) -> bool:
        """Sends the event when the actor has reached another state."""
        self.begin(self.tick)
        travel = Travel(self.actor, change["state"])
        self.step([*self.commands_without_event(), travel])
        for _ in self.budget.watch("state"):
            if self.fork.actor(self.actor).state == change["state"]:
                return self.step([self.press])
            self.step()
        return False

    def try_cell(self, change: Change) -> bool:
        """Replaces a cell of the table."""
        cell = CellDefinition(change["to"], 0, restart=change.get("restart", False), when=AT_ONCE)
        self.begin(self.tick)
        role = self.role()
        layer = [known_layer.name for known_layer in role.machine.layers][change["layer"]]
        self.fork.edit(
            _with_definition(
                role, _with_cell(role.definition, layer, (change["state"], change["event"]), cell)
            )
        )
        return self.step(self.commands_with_event()) or (self.event == END and self.watch("cell", along=True))

    def try_buffer(self, change: Change) -> bool:
        """Gives the event a longer buffer."""
        self.begin(self.tick)
        role = self.role()
        events = dict(role.definition.events)
        events[self.event] = replace(events[self.event], buffer=change["seconds"])
        self.fork.edit(_with_definition(role, replace(role.definition, events=events)))
        return self.step(self.commands_with_event()) or self.watch("buffer", along=True)

    def role(self) -> Role:
        """Returns the actor's role at the present tick of the fork."""
        return self.fork.actor(self.actor).role


def _with_definition(role: Role, definition: MachineDefinition) -> Role:
    """Returns the role with other cells or buffers and the same motions."""
    facts = facts_of(role.character)
    resolved = resolved_tables(definition, facts)
    return replace(role, definition=definition, resolved=resolved, machine=build(definition, facts, resolved))


def _with_cell(
    definition: MachineDefinition, layer: str, place: tuple[str, str], cell: CellDefinition
) -> MachineDefinition:
    """Returns the machine with one cell of a layer replaced."""
    if layer not in definition.layers:
        return replace(definition, cells={**definition.cells, place: cell})
    changed = definition.layers[layer]
    return replace(
        definition,
        layers={**definition.layers, layer: replace(changed, cells={**changed.cells, place: cell})},
    )

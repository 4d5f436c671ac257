"""`statwalk play`: a machine without a server, a browser or a clock."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, NamedTuple

import typer
from rich.console import Console
from rich.table import Table

from statwalk.errors import UnknownNameError
from statwalk.files.scenefile import FILE_NAME as SCENE_FILE
from statwalk.loading import load, load_scene, shipped_machines, shipped_scenes
from statwalk.stage.role import Role
from statwalk.stage.stage import Actor, Stage

EXAMPLES = """Examples:

  statwalk play faq-walker --events "0:FORWARD 2:STOP" --seconds 4

  statwalk play faq-walker --events "0.5:+LEFT 1.5:-LEFT" --every-tick

  statwalk play faq-walker --events "0:@JUMP" --why

  statwalk play playground --events "0:+FORWARD" --seconds 8

An event is SECONDS:EVENT; + before its name holds it, - releases it. SECONDS:@STATE travels to a state; SECONDS:NAME=VALUE sets
a parameter.
"""
EVENT = re.compile(r"(\d+(?:\.\d+)?):(?:([+@-]?)([^\s=]+)|([^\s=]+)=([+-]?\d+(?:\.\d+)?))")
HEADINGS = ("tick", "seconds", "events", "state", "x m", "z m", "turn°", "hash")
WORDS = ("events", "state", "hash")
console = Console(highlight=False)


class Input(NamedTuple):
    """What happens at a tick; `sign` is + for hold, - for release, @ for a state to travel to, = for a parameter, nothing for a press."""

    tick: int
    sign: str
    name: str
    value: float = 0.0

    def __str__(self) -> str:
        return f"{self.name}={self.value:g}" if self.sign == "=" else self.sign + self.name


def read_events(text: str, rate: int) -> list[Input]:
    """The inputs of `0:FORWARD 2:STOP`, in the order of their ticks.

    :raises typer.BadParameter: if a word is no event.
    """
    inputs = []
    for word in text.split():
        match = EVENT.fullmatch(word)
        if match is None:
            raise typer.BadParameter(f"{word!r} is not SECONDS:EVENT, as in 0:FORWARD, 1.5:+LEFT, 2:-LEFT, 3:@STATE, 4:NAME=VALUE")
        tick = round(float(match[1]) * rate)
        inputs.append(Input(tick, "=", match[4], float(match[5])) if match[4] else Input(tick, match[2], match[3]))
    return sorted(inputs, key=lambda one: one.tick)


def give(stage: Stage, actor: Actor, one: Input) -> None:
    """Tells the actor one input."""
    match one.sign:
        case "=":
            stage.set(actor, one.name, one.value)
        case "@":
            stage.travel(actor, one.name)
        case "+":
            stage.hold(actor, one.name)
        case "-":
            stage.release(actor, one.name)
        case _:
            stage.send(actor, one.name)


def run(stage: Stage, actor: Actor, inputs: list[Input], ticks: int) -> Iterator[str]:
    """Steps the stage; after each tick, the inputs that were logged before it."""
    waiting = list(inputs)
    for tick in range(ticks):
        due = [one for one in waiting if one.tick <= tick]
        waiting = waiting[len(due) :]
        for one in due:
            give(stage, actor, one)
        stage.step(1)
        yield " ".join(map(str, due))


def reasons(stage: Stage) -> Iterator[str]:
    """A line for every event of this tick: what became of it, and why."""
    for one in stage.state.verdicts:
        yield f"{one.tick:>6}  {one.event} {one.verdict} in {one.from_state}" + (f": {one.reason}" if one.reason else "")


def deeds(stage: Stage) -> Iterator[str]:
    """A line for every action of all actors."""
    names = {actor.id: actor.name for actor in stage.actors}
    for one in stage.actions:
        arguments = f"({', '.join(map(str, one.arguments))})" if one.arguments else ""
        yield f"{one.tick:>6}  {names.get(one.actor, one.actor)}: {one.name}{arguments}"


def row(stage: Stage, actor: Actor, events: str) -> list[str]:
    """A line of the table: where the actor is after a tick."""
    (x, _, z), heading = actor.root
    return [
        str(stage.tick),
        f"{stage.seconds:.3f}",
        events,
        " + ".join(actor.states),
        f"{x:.3f}",
        f"{z:.3f}",
        f"{math.degrees(heading):.1f}",
        actor.hash,
    ]


def role_of(machine: str) -> Role:
    """The machine to play.

    :raises StatwalkError: if there is none, or its files must be refused.
    """
    found = load(machine)
    if isinstance(found, Role):
        return found
    raise UnknownNameError("machine", machine, shipped_machines())


def opened(machine: str, seed: int, rate: int) -> tuple[Stage, Actor]:
    """A stage with the machine, or with all of a scene, and the actor that is told the events: of a scene, its first.

    :raises StatwalkError: if there is no such machine or scene, or its files must be refused.
    """
    if machine in shipped_scenes() or (Path(machine) / SCENE_FILE).is_file():
        scene = load_scene(machine)
        stage = Stage(seed or scene.seed, rate)
        return stage, scene.enter(stage)[0]
    stage = Stage(seed, rate)
    return stage, stage.add(role_of(machine))


def play(
    machine: Annotated[str, typer.Argument(help="A machine or scene folder, or a shipped one's name; of a scene the first actor.")],
    events: Annotated[str, typer.Option(help='What happens when, in seconds: "0:FORWARD 2:STOP"; +NAME holds, -NAME releases.')] = "",
    seconds: Annotated[float, typer.Option(help="How long to play.", min=0.0, max=3600.0)] = 4.0,
    rate: Annotated[int, typer.Option(help="Ticks a second.", min=1, max=240)] = 60,
    seed: Annotated[int, typer.Option(help="The stage's seed.", min=0)] = 0,
    every_tick: Annotated[bool, typer.Option("--every-tick", help="A line for each tick, not only where something changes.")] = False,
    why: Annotated[bool, typer.Option("--why", help="What became of every event, and why.")] = False,
) -> None:
    """Plays a machine as fast as it can, and prints what changed, and the hash that the same inputs always give."""
    stage, actor = opened(machine, seed, rate)
    table = Table(box=None)
    for heading in HEADINGS:
        table.add_column(heading, no_wrap=True, justify="left" if heading in WORDS else "right")
    states: tuple[str, ...] = ()
    said: list[str] = []
    for happened in run(stage, actor, read_events(events, rate), round(seconds * rate)):
        said += reasons(stage)
        if every_tick or happened or actor.states != states:
            table.add_row(*row(stage, actor, happened))
        states = actor.states
    console.print(table)
    if why:
        console.print("\n".join(["", "  tick  why", *said, ""]))
    if len(stage.actors) > 1:
        console.print("\n".join(["", "  tick  what was done", *deeds(stage), ""]), markup=False)
    console.print(f"after {stage.tick} ticks: [bold]{actor.state}[/], hash {stage.hash}")

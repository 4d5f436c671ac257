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

from statwalk.character.role import Role
from statwalk.errors import UnknownNameError
from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.services.library.load import load, shipped_machines
from statwalk.services.library.load_scene import load_scene, shipped_scenes
from statwalk.stage.stage import Actor, Stage

EXAMPLES = """Examples:

  statwalk play faq-walker --events "0:FORWARD 2:STOP" --seconds 4

  statwalk play faq-walker --events "0.5:+LEFT 1.5:-LEFT" --every-tick

  statwalk play faq-walker --events "0:@JUMP" --why

  statwalk play playground --events "0:+FORWARD" --seconds 8

An event is SECONDS:EVENT; + before its name holds it, - releases it. SECONDS:@STATE travels to a state;
SECONDS:NAME=VALUE sets a parameter.
"""
EVENT = re.compile(r"(\d+(?:\.\d+)?):(?:([+@-]?)([^\s=]+)|([^\s=]+)=([+-]?\d+(?:\.\d+)?))")
HEADINGS = ("tick", "seconds", "events", "state", "x m", "z m", "turn°", "hash")
WORDS = ("events", "state", "hash")
console = Console(highlight=False)


class Input(NamedTuple):
    """An input at a tick; `sign` is + for hold, - for release, @ for a state to travel to, = for a parameter,
    empty for a press.
    """

    tick: int
    sign: str
    name: str
    value: float = 0.0

    def __str__(self) -> str:
        return f"{self.name}={self.value:g}" if self.sign == "=" else self.sign + self.name


def _read_events(text: str, rate: int) -> list[Input]:
    """Returns the inputs that a text like `0:FORWARD 2:STOP` names, in the order of their ticks.

    :raises typer.BadParameter: when a word is no event.
    """
    inputs = []
    for word in text.split():
        match = EVENT.fullmatch(word)
        if match is None:
            raise typer.BadParameter(
                f"{word!r} is not SECONDS:EVENT: write 0:FORWARD, 1.5:+LEFT, 2:-LEFT, 3:@STATE, 4:NAME=1"
            )
        tick = round(float(match[1]) * rate)
        inputs.append(
            Input(tick, "=", match[4], float(match[5])) if match[4] else Input(tick, match[2], match[3])
        )
    return sorted(inputs, key=lambda planned: planned.tick)


def _post(stage: Stage, actor: Actor, planned: Input) -> None:
    match planned.sign:
        case "=":
            stage.set(actor, planned.name, planned.value)
        case "@":
            stage.travel(actor, planned.name)
        case "+":
            stage.hold(actor, planned.name)
        case "-":
            stage.release(actor, planned.name)
        case _:
            stage.send(actor, planned.name)


def run(stage: Stage, actor: Actor, inputs: list[Input], ticks: int) -> Iterator[str]:
    """Steps the stage tick by tick; yields after each tick the inputs that were posted before it."""
    pending = list(inputs)
    for tick in range(ticks):
        due = [planned for planned in pending if planned.tick <= tick]
        pending = pending[len(due) :]
        for planned in due:
            _post(stage, actor, planned)
        stage.step(1)
        yield " ".join(map(str, due))


def _verdict_lines(stage: Stage) -> Iterator[str]:
    """Yields a line for every verdict of the newest tick."""
    for verdict in stage.effects.verdicts:
        yield f"{verdict.tick:>6}  {verdict.event} {verdict.verdict} in {verdict.from_state}" + (
            f": {verdict.reason}" if verdict.reason else ""
        )


def _action_lines(stage: Stage) -> Iterator[str]:
    names = {actor.id: actor.name for actor in stage.actors}
    for action in stage.actions:
        arguments = f"({', '.join(map(str, action.arguments))})" if action.arguments else ""
        yield f"{action.tick:>6}  {names.get(action.actor, action.actor)}: {action.name}{arguments}"


def row(stage: Stage, actor: Actor, events: str) -> list[str]:
    """Returns a row of the printed table: where the actor is after a tick."""
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


def _load_role(machine: str) -> Role:
    loaded = load(machine)
    if isinstance(loaded, Role):
        return loaded
    raise UnknownNameError("machine", machine, shipped_machines())


def opened(machine: str, seed: int, rate: int) -> tuple[Stage, Actor]:
    """Returns a stage with the machine, or with all actors of a scene, and the actor that gets the events:
    the first one.

    :raises StatwalkError: when no machine or scene has this name, or a file of it is refused.
    """
    if machine in shipped_scenes() or (Path(machine) / SCENE_FILE).is_file():
        scene = load_scene(machine)
        stage = Stage(seed or scene.seed, rate)
        return stage, scene.enter(stage)[0]
    stage = Stage(seed, rate)
    return stage, stage.add(_load_role(machine))


def play(
    machine: Annotated[
        str,
        typer.Argument(
            help="A machine or scene folder, or a shipped one's name; in a scene you play the first actor."
        ),
    ],
    events: Annotated[
        str,
        typer.Option(help='Events at seconds: "0:FORWARD 2:STOP"; +NAME holds, -NAME releases.'),
    ] = "",
    seconds: Annotated[float, typer.Option(help="How long to play.", min=0.0, max=3600.0)] = 4.0,
    rate: Annotated[int, typer.Option(help="Ticks a second.", min=1, max=240)] = 60,
    seed: Annotated[int, typer.Option(help="The stage's seed.", min=0)] = 0,
    every_tick: Annotated[
        bool, typer.Option("--every-tick", help="Print a line for each tick, not only for changes.")
    ] = False,
    why: Annotated[bool, typer.Option("--why", help="Print the verdict on every event, and why.")] = False,
) -> None:
    """Plays a machine as fast as it can, and prints what changed, and the hash that the same inputs always
    give.
    """
    stage, actor = opened(machine, seed, rate)
    table = Table(box=None)
    for heading in HEADINGS:
        table.add_column(heading, no_wrap=True, justify="left" if heading in WORDS else "right")
    states: tuple[str, ...] = ()
    verdict_lines: list[str] = []
    for posted in run(stage, actor, _read_events(events, rate), round(seconds * rate)):
        verdict_lines += _verdict_lines(stage)
        if every_tick or posted or actor.states != states:
            table.add_row(*row(stage, actor, posted))
        states = actor.states
    console.print(table)
    if why:
        console.print("\n".join(["", "  tick  why", *verdict_lines, ""]))
    if len(stage.actors) > 1:
        console.print("\n".join(["", "  tick  actions", *_action_lines(stage), ""]), markup=False)
    console.print(f"after {stage.tick} ticks: [bold]{actor.state}[/], hash {stage.hash}")

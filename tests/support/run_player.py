"""Plays a run on the stage. No other file of the recorded runs knows the product's classes."""

from dataclasses import replace
from functools import cache
from typing import NamedTuple

import numpy as np
from builders import REST, clip_of
from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import StatwalkError
from statwalk.files.machine_yaml.machine_file import read_machine
from statwalk.motion.clip import Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.stage.stage import Stage


class Verdict(NamedTuple):
    """What became of an event: the row/column of its cell, what its conditions saw, and why."""

    actor: int
    layer: int
    event: str
    verdict: str
    from_state: str
    to_state: str
    cell: str
    other: int
    values: tuple[tuple[str, float], ...]
    reason: str


class Tick(NamedTuple):
    """The commands that were refused, state and seconds by actor and layer, and what happened."""

    refused: list[str]
    where: dict[tuple[int, int], tuple[str, float]]
    verdicts: list[Verdict]
    actions: list[str]


def play(machines, run) -> list[Tick]:
    """Returns all ticks of a run, from tick 1; `machines` are texts by number."""
    stage, ticks = Stage(seed=run.seed, rate=run.rate), []
    for tick in range(1, run.ticks + 1):
        told = [(line, _tell(stage, machines, run, line)) for line in run.commands.get(tick, ())]
        refused = [f"{line} ({type(error).__name__})" for line, error in told if error]
        stage.step()
        frame = stage.frame
        ticks.append(
            Tick(
                refused, _where(stage), list(map(_verdict, frame.verdicts)), list(map(_action, frame.actions))
            )
        )
    return ticks


def is_valid(text: str) -> bool:
    """Whether the product takes a machine file."""
    try:
        _role(text, "one")
    except StatwalkError:
        return False
    return True


def _tell(stage, machines, run, line) -> StatwalkError | None:
    """Follows one command; the error if the stage refuses it."""
    kind, first, *rest = line.split()
    try:
        match kind:
            case "add":
                key = machines[run.machines[["one", "two"].index(first)]]
                role = _role(key, first) if first not in stage.roles else stage.role(first)
                stage.add(role, [float(part) for part in rest[1:4]], float(rest[4]), name=rest[0])
            case "remove":
                stage.remove(int(first))
            case "edit":
                stage.edit(_role(machines[int(rest[0])], first), rest[0])
            case "set":
                stage.set(int(first), rest[0], float(rest[1]))
            case "travel" if rest[0] == "-":
                stage.cancel_travel(int(first))
            case "travel":
                stage.travel(int(first), rest[0])
            case _:
                {"press": stage.send, "hold": stage.hold, "release": stage.release}[kind](int(first), rest[0])
    except StatwalkError as error:
        return error
    return None


def _where(stage) -> dict[tuple[int, int], tuple[str, float]]:
    found = {}
    for cast in stage.casts:
        for row, actor in enumerate(cast.ids.tolist()):
            for layer, (state, time) in enumerate(
                zip(cast.machine.state[row], cast.machine.time[row], strict=True)
            ):
                found[actor, layer] = cast.role.machine.states[state], float(time)
    return found


def _verdict(one) -> Verdict:
    cell = "/".join(one.cell) if one.cell else ""
    states = one.from_state, one.to_state
    return Verdict(
        one.actor, one.layer, one.event, one.verdict, *states, cell, one.other, one.values, one.reason
    )


def _action(one) -> str:
    arguments = ", ".join(map(str, one.arguments))
    return f"{one.actor} {one.name}({arguments})" + (f" other={one.other}" if one.other >= 0 else "")


@cache
def _role(text: str, name: str) -> Role:
    return Role.build(name, _character(), read_machine(text, name), "hips")


@cache
def _character() -> Character:
    """Three joints; clips with few keys, and some durations that no tick divides."""
    skeleton, _ = Skeleton.sorted(["hips", "chest", "arm"], [None, "hips", "chest"])
    clips = [
        clip_of("stand", 2.0, 5, keys=9),
        clip_of("walk", 1.0, 40, 1.5, keys=9),
        _high(clip_of("hop", 0.5, 90, 0.4, keys=9)),
        clip_of("turn", 0.913, 20, 0.0, np.pi / 2, keys=9),
        clip_of("nod", 0.213, 30, keys=9),
    ]
    return Character(
        "tiny", skeleton, np.arange(3, dtype=np.int32), REST, {clip.name: _linear(clip) for clip in clips}
    )


def _high(clip: Clip) -> Clip:
    """With a root that rises by 0.3 m and comes down again."""
    first, *rest = clip.channels
    values = first.values.copy()
    values[:, 1] += 0.3 * np.sin(np.pi * first.times / clip.duration).astype(np.float32)
    return Clip(clip.name, (replace(first, values=values), *rest), clip.duration, REST)


def _linear(clip: Clip) -> Clip:
    """Loaded a hundred times as fast as splines."""
    channels = tuple(replace(channel, interpolation="LINEAR") for channel in clip.channels)
    return Clip(clip.name, channels, clip.duration, REST)

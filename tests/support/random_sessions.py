"""Sessions by chance: a shipped machine or scene, and everything that people do to it, from one seed."""

import re
from collections.abc import Callable
from contextlib import suppress
from functools import cache
from pathlib import Path
from random import Random

from statwalk.character.character import Character
from statwalk.character.role import Role
from statwalk.errors import StageError
from statwalk.files.machine_yaml.capture_lines import with_captures
from statwalk.files.machine_yaml.machine_file import MachineFile
from statwalk.machine.compile.machine import Machine
from statwalk.services.library.load import (
    character_path,
    load_character_file,
    load_role,
    machine_folders,
    shipped_machines_folder,
)
from statwalk.services.library.load_scene import load_scene, shipped_scenes
from statwalk.stage.stage import Stage

MACHINE_FILE = "machine.yaml"
CONTENTS = (*machine_folders(), *(f"scene-{name}" for name in shipped_scenes()))
"""every shipped machine, those of scenes too, and every shipped scene"""
RATES = (60, 60, 60, 30, 120, 50)
MOST_MORE = 4
"""actors that a session adds"""
REACH = 2.0
"""how far from its default a parameter without near bounds is set"""
BLEND = re.compile(r"(?<=blend: )[\d.]+")
character_at: Callable[[Path], Character] = cache(load_character_file)


def character_of(file: MachineFile, folder: Path) -> Character:
    """Loads the character of a machine file in a folder; each model once."""
    return with_captures(character_at(character_path(file)), file.captures, folder)


@cache
def role_of(key: str, text: str = "") -> Role:
    """The role of a key of a log, as `replay` asks for it."""
    name = key.partition("@")[0]
    return load_role(machine_folders()[name], name, text, character_of)


def session(content: str, seed: int, ticks: int) -> Stage:
    """A stage with a log of at least so many ticks."""
    chance = Random(f"{content} {seed}")
    stage = _opened(content, chance)
    most = len(stage.actors) + MOST_MORE
    while stage.head < ticks:
        for _ in range(chance.randint(0, 3)):
            with suppress(StageError):  # no way leads there
                _something(stage, chance, most)
        stage.step(chance.randint(1, 25))
        stage = _elsewhere(stage, chance)
    return stage


def _opened(content: str, chance: Random) -> Stage:
    stage = Stage(chance.getrandbits(32), chance.choice(RATES))
    if content.startswith("scene-"):
        for role, line in load_scene(content.removeprefix("scene-")).lines:
            names, places = zip(*line.places(), strict=True)
            stage.add_many(role_of(role.name), [(place, chance.uniform(-3, 3)) for place in places], names)
    else:
        stage.add(role_of(content), heading=chance.uniform(-3, 3))
    return stage


def _something(stage: Stage, chance: Random, most: int) -> None:
    """An event, more seldom a parameter, a journey, an edit, an actor who comes or goes."""
    actor = chance.choice(stage.actors)
    machine = actor.role.machine
    match chance.choices(("event", "set", "travel", "come", "go", "edit"), (12, 6, 2, 1, 1, 0.4))[0]:
        case "event" if machine.events[:-1]:
            do = chance.choice((Stage.send, Stage.send, Stage.send, Stage.hold, Stage.release))
            do(stage, actor, chance.choice(machine.events[:-1]))
        case "set" if machine.parameters:
            stage.set(actor, *_setting(machine, chance))
        case "travel":
            base = [name for k, name in enumerate(machine.states) if machine.layer_of[k] == 0]
            stage.travel(actor, chance.choice(base))
        case "come" if len(stage.actors) < most:
            place = (chance.uniform(-4, 4), 0.0, chance.uniform(-4, 4))
            stage.add(stage.role(actor.role.name), place, chance.uniform(-3, 3))
        case "go" if len(stage.actors) > 1:
            stage.remove(actor)
        case "edit" if "@" not in "".join(stage.roles):
            _edit(stage, actor.role.name, chance)


def _setting(machine: Machine, chance: Random) -> tuple[str, float | list[float]]:
    """A parameter by chance, and a value that it can have."""
    part = chance.choice(machine.parameters)
    name = part.vector or part.name
    values = [
        1.0 * chance.randint(0, 1)
        if each.kind == "flag"
        else chance.uniform(max(each.minimum, each.default - REACH), min(each.maximum, each.default + REACH))
        for each in machine.parameters
        if name in (each.vector, each.name)
    ]
    return name, values if part.vector else values[0]


def _edit(stage: Stage, name: str, chance: Random) -> None:
    """Saves the machine's file with another blend, or with a remark."""
    text = (machine_folders()[name] / MACHINE_FILE).read_text(encoding="utf-8")
    edited = BLEND.sub(f"{chance.uniform(0.05, 0.5):.2f}", text, count=1) + "\n# edited\n"
    stage.edit(role_of(f"{name}@2", edited), edited)


def _elsewhere(stage: Stage, chance: Random) -> Stage:
    """The stage after a look into its past, or a fork of it, or mostly the stage as it was."""
    what, tick = chance.random(), chance.randint(max(0, stage.head - 60), stage.head)
    if what < 0.15:
        stage.seek(chance.randint(0, stage.head))
        stage.seek(stage.head)
    elif what < 0.22:
        return stage.fork_at(tick)
    elif what < 0.25:
        return stage.fork()
    return stage


def folder_of(key: str) -> Path:
    """The folder of a machine below that of all machines."""
    return machine_folders()[key].relative_to(shipped_machines_folder())

"""Loads a Scene by path or name: the actors of a stage when it opens.

This module joins files and stage, which do not import each other.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import radians
from pathlib import Path

from statwalk.character.role import Role
from statwalk.errors import MachineError, UnknownNameError
from statwalk.files.machine_yaml.machine_file import FILE_NAME as MACHINE_FILE
from statwalk.files.scene import FILE_NAME as SCENE_FILE
from statwalk.files.scene import ActorLine, SceneFile, load_scene_file
from statwalk.services.library.load import (
    load_role,
    load_shipped,
    shipped_machines,
    shipped_machines_folder,
)
from statwalk.stage.actor import Actor
from statwalk.stage.stage import Stage


@dataclass(frozen=True)
class Scene:
    """The actors of a stage when it opens: for each line of the scene file its role and its places."""

    name: str
    title: str
    description: str
    seed: int
    lines: tuple[tuple[Role, ActorLine], ...]

    def enter(self, stage: Stage) -> list[Actor]:
        """Adds the actors to a stage; returns them in the order of the scene file."""
        actors: list[Actor] = []
        for role, line in self.lines:
            names, positions = zip(*line.places(), strict=True)
            heading = radians(line.heading_deg)
            actors += stage.add_many(role, [(position, heading) for position in positions], names)
        return actors

    def open(self, rate: int = 60) -> Stage:
        """Returns a new stage with the actors of the scene."""
        stage = Stage(self.seed, rate)
        self.enter(stage)
        return stage


def shipped_scenes() -> list[str]:
    """Returns the names of the shipped scenes, sorted."""
    return sorted(path.parent.name for path in shipped_machines_folder().glob(f"*/{SCENE_FILE}"))


def load_scene(source: str | Path) -> Scene:
    """Loads a scene from its folder or by a shipped scene's name; each of its machines is a sub-folder, or a
    shipped machine.

    :raises ContentError: when a file is refused.
    :raises UnknownNameError: when no folder and no shipped scene has this name.
    """
    shipped_folders = {name: shipped_machines_folder() / name for name in shipped_scenes()}
    folder = Path(source) if (Path(source) / SCENE_FILE).is_file() else shipped_folders.get(str(source))
    if folder is None:
        raise UnknownNameError("scene", str(source), shipped_folders)
    file = load_scene_file(folder)
    roles: dict[str, Role] = {}
    for line in file.actors:
        if line.machine not in roles:
            roles[line.machine] = _role_of(file, folder, line)
    return Scene(
        file.name,
        file.title,
        file.description,
        file.seed,
        tuple((roles[line.machine], line) for line in file.actors),
    )


def _role_of(file: SceneFile, folder: Path, line: ActorLine) -> Role:
    scene_machines = sorted(path.parent.name for path in folder.glob(f"*/{MACHINE_FILE}"))
    if line.machine in scene_machines:
        return load_role(folder / line.machine, f"{file.name}.{line.machine}")
    if line.machine in shipped_machines():
        return load_shipped(line.machine)
    raise MachineError(
        str(UnknownNameError("machine", line.machine, [*scene_machines, *shipped_machines()])),
        file=file.file,
        place=f"line {line.line}",
    )

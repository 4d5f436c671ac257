"""Scenes: a folder with `scene.yaml`, which lists the actors and their places, and a sub-folder for each
machine of the scene's own.

title: The playground
actors:
  - {machine: walker, position: [0, 0, -4], heading_deg: 90}
  - {machine: coin, name: coin, position: [2, 0, 3], count: 5, spread: [2, 0, 1]}
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from statwalk.errors import MachineError
from statwalk.files.machine_yaml import fields
from statwalk.files.yaml.yaml_text import Node, parse, read_text

FILE_NAME = "scene.yaml"
KEYS = ("title", "description", "seed", "actors")
ACTOR_KEYS = ("machine", "name", "position", "heading_deg", "count", "spread")
MOST_LINES, MOST_ACTORS = 1_000, 10_000
LARGEST_SEED = 2.0**53

Point = tuple[float, float, float]


@dataclass(frozen=True)
class ActorLine:
    """One line of `actors`: one or more actors of the same machine."""

    machine: str
    """a sub-folder of the scene's folder, or a shipped machine"""
    line: int
    name: str = ""
    """empty: the machine's name"""
    position: Point = (0.0, 0.0, 0.0)
    """metres"""
    heading_deg: float = 0.0
    count: int = 1
    spread: Point = (0.0, 0.0, 0.0)
    """metres to each side of `position`; if `count` is more than 1, the actors are spread evenly within it"""

    def places(self) -> Iterator[tuple[str, Point]]:
        """Yields the name and the position in metres of each actor."""
        name = self.name or self.machine
        if self.count == 1:
            yield name, self.position
            return
        for number in range(self.count):
            x, y, z = (
                center + offset * half_width
                for center, offset, half_width in zip(self.position, strewn(number), self.spread, strict=True)
            )
            yield f"{name} {number + 1}", (x, y, z)


@dataclass(frozen=True)
class SceneFile:
    """A scene as its file describes it."""

    name: str
    actors: tuple[ActorLine, ...]
    title: str = ""
    description: str = ""
    seed: int = 0
    file: str = ""


STEPS = (0.8191725133961644, 0.671043606703789, 0.5497004779019701)
"""1/g, 1/g², 1/g³ with g⁴ = g + 1: any number of multiples of STEPS fills a cube evenly (Roberts 2018)"""


def strewn(number: int) -> Point:
    """Returns the place of actor `number` in the cube −1…1; consecutive numbers fill the cube evenly."""
    x, y, z = ((0.5 + number * step) % 1 * 2 - 1 for step in STEPS)
    return x, y, z


def load_scene_file(folder: Path) -> SceneFile:
    """Reads the scene of a folder.

    :raises MachineError: when the file is missing or wrong; `file` and `place` say where.
    """
    path = folder / FILE_NAME
    return read_scene(read_text(path, MachineError), folder.resolve().name, str(path))


def read_scene(text: str, name: str = "scene", file: str = FILE_NAME) -> SceneFile:
    """Reads a scene from the text of its file.

    :raises MachineError: when the text is wrong; `place` is the line.
    """
    root = parse(text, file, MachineError)
    entries = root.entries(*KEYS)
    lines = fields.required(root, "actors").items()
    if len(lines) > MOST_LINES:
        raise entries["actors"].refuse(
            f"the scene has {len(lines):,} lines of actors; at most {MOST_LINES:,} are allowed"
        )
    actors = tuple(_actor_line(node) for node in lines)
    if sum(actor.count for actor in actors) > MOST_ACTORS:
        raise entries["actors"].refuse(
            f"the scene has {sum(actor.count for actor in actors):,} actors; "
            f"at most {MOST_ACTORS:,} are allowed"
        )
    return SceneFile(
        name=name,
        actors=actors,
        title=entries["title"].text() if "title" in entries else "",
        description=entries["description"].text() if "description" in entries else "",
        seed=int(entries["seed"].number(0, LARGEST_SEED)) if "seed" in entries else 0,
        file=file,
    )


def _actor_line(node: Node) -> ActorLine:
    entries = node.entries(*ACTOR_KEYS)
    return ActorLine(
        machine=fields.name(fields.required(node, "machine"), "machine"),
        line=node.line,
        name=entries["name"].text() if "name" in entries else "",
        position=fields.point(entries["position"]) if "position" in entries else ActorLine.position,
        heading_deg=entries["heading_deg"].number(-360, 360) if "heading_deg" in entries else 0.0,
        count=fields.whole(entries["count"], 1, MOST_ACTORS) if "count" in entries else 1,
        spread=spread(entries["spread"]) if "spread" in entries else ActorLine.spread,
    )


def spread(node: Node) -> Point:
    """Reads `[x, y, z]` metres to each side, or one number for x and z."""
    if not node.is_text:
        return fields.point(node)
    side = node.number(0, fields.FARTHEST)
    return side, 0.0, side

"""Scenes: a folder with `scene.yaml`, which says who stands where, and a sub-folder for each machine of its own.

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
from statwalk.files.machine import fields
from statwalk.files.yamltext import Node, parse, read_text

FILE_NAME = "scene.yaml"
KEYS = ("title", "description", "seed", "actors")
ACTOR_KEYS = ("machine", "name", "position", "heading_deg", "count", "spread")
MOST_LINES, MOST_ACTORS = 1_000, 10_000
LARGEST_SEED = 2.0**53

Point = tuple[float, float, float]


@dataclass(frozen=True)
class ActorLine:
    """Some actors of one machine."""

    machine: str
    """a sub-folder of the scene's folder, or a shipped machine"""
    line: int
    name: str = ""
    """empty: as the machine"""
    position: Point = (0.0, 0.0, 0.0)
    """metres"""
    heading_deg: float = 0.0
    count: int = 1
    spread: Point = (0.0, 0.0, 0.0)
    """metres to each side within which several are strewn evenly"""

    def places(self) -> Iterator[tuple[str, Point]]:
        """The name and the position of each."""
        name = self.name or self.machine
        if self.count == 1:
            yield name, self.position
            return
        for number in range(self.count):
            x, y, z = (middle + part * side for middle, part, side in zip(self.position, strewn(number), self.spread, strict=True))
            yield f"{name} {number + 1}", (x, y, z)


@dataclass(frozen=True)
class SceneFile:
    """A scene as read."""

    name: str
    actors: tuple[ActorLine, ...]
    title: str = ""
    description: str = ""
    seed: int = 0
    file: str = ""


STEPS = (0.8191725133961644, 0.671043606703789, 0.5497004779019701)
"""1/g, 1/g², 1/g³ with g⁴ = g + 1: multiples of it fill a cube evenly, however many they are (Roberts 2018)"""


def strewn(number: int) -> Point:
    """The place −1…1 of one of many that are strewn evenly."""
    x, y, z = ((0.5 + number * step) % 1 * 2 - 1 for step in STEPS)
    return x, y, z


def load_scene_file(folder: Path) -> SceneFile:
    """The scene of a folder; raises MachineError with file and line."""
    path = folder / FILE_NAME
    return read_scene(read_text(path, MachineError), folder.resolve().name, str(path))


def read_scene(text: str, name: str = "scene", file: str = FILE_NAME) -> SceneFile:
    """The scene that a text says; raises MachineError with line."""
    root = parse(text, file, MachineError)
    entries = root.entries(*KEYS)
    lines = fields.required(root, "actors").items()
    if len(lines) > MOST_LINES:
        raise entries["actors"].refuse(f"there are {len(lines):,} lines of actors; at most {MOST_LINES:,} can be read")
    actors = tuple(actor_line(node) for node in lines)
    if sum(one.count for one in actors) > MOST_ACTORS:
        raise entries["actors"].refuse(f"there are {sum(one.count for one in actors):,} actors; at most {MOST_ACTORS:,} can come")
    return SceneFile(
        name=name,
        actors=actors,
        title=entries["title"].text() if "title" in entries else "",
        description=entries["description"].text() if "description" in entries else "",
        seed=int(entries["seed"].number(0, LARGEST_SEED)) if "seed" in entries else 0,
        file=file,
    )


def actor_line(node: Node) -> ActorLine:
    """One line of `actors`."""
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
    """`[x, y, z]` metres to each side, or one number for x and z."""
    if not node.is_text:
        return fields.point(node)
    side = node.number(0, fields.FARTHEST)
    return side, 0.0, side

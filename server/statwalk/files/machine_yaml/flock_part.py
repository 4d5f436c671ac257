"""Reads `flock` of a machine file.

flock:
  distance: 2
  reach: 15
  sight_deg: 270
  nearest: 6
  max_speed: 14
  max_acceleration: 12
  goal: {at: [0, 8, 0], radius: 25, seconds: 40}
  obstacles: [{sphere: 3, at: [5, 6, 0]}, {plane: [0, 1, 0], at: [0, 2, 0]}]
  speed_parameter: pace
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from statwalk.files.machine_yaml import fields
from statwalk.files.machine_yaml.senses import direction
from statwalk.files.yaml.yaml_text import Node
from statwalk.machine.definition.flock_definition import FlockDefinition, GoalDefinition, ObstacleDefinition

NUMBERS: Mapping[str, tuple[float, float]] = {
    "distance": (0.001, 1e4),
    "reach": (0.001, 1e5),
    "sight_deg": (0, 360),
    "strength": (0, 1e4),
    "min_speed": (0, 1e3),
    "max_speed": (0, 1e3),
    "max_acceleration": (0, 1e4),
    "max_turn_deg": (0, 1e4),
    "wander": (0, 1e4),
    "follow": (0, 1),
}
"""fields that are numbers, each with its least and greatest value"""
SETS = ("speed", "climb", "turn")
MOST_NEAREST, MOST_OBSTACLES = 32, 64
OTHERS = ("nearest", "formation", "goal", "obstacles", "avoid", *(f"{name}_parameter" for name in SETS))


def flock(node: Node | None, parameters: Iterable[str]) -> FlockDefinition | None:
    """Reads the flock of a machine; None if the file has none.

    :raises MachineError: when a field is wrong or a name does not exist.
    """
    if node is None:
        return None
    entries = node.entries(*NUMBERS, *OTHERS)
    numbers = {name: entries[name].number(*limits) for name, limits in NUMBERS.items() if name in entries}
    definition = FlockDefinition(
        line=node.line,
        nearest=fields.whole(entries["nearest"], 1, MOST_NEAREST)
        if "nearest" in entries
        else FlockDefinition.nearest,
        formation=_formation(entries["formation"]) if "formation" in entries else None,
        goal=goal(entries["goal"]) if "goal" in entries else None,
        obstacles=tuple(_obstacles(entries["obstacles"])) if "obstacles" in entries else (),
        avoid=tuple(fields.name(collider, "collider") for collider in entries["avoid"].items())
        if "avoid" in entries
        else (),
        sets={
            name: fields.chosen(entries[key], "parameter", parameters)
            for name in SETS
            if (key := f"{name}_parameter") in entries
        },
        **numbers,
    )
    if definition.min_speed > definition.max_speed:
        raise entries["min_speed" if "min_speed" in entries else "max_speed"].refuse(
            "min_speed is more than max_speed"
        )
    return definition


def _formation(node: Node) -> tuple[float, float]:
    """Reads `{beside: 1.2, behind: 1.5}` metres."""
    entries = node.entries("beside", "behind")
    return fields.required(node, "beside").number(0, 1e3), entries["behind"].number(
        0, 1e3
    ) if "behind" in entries else 0.0


def goal(node: Node) -> GoalDefinition:
    """Reads `{at: [x, y, z]}`; a goal that moves in a circle also has `radius` in metres and `seconds` per
    round.
    """
    entries = node.entries("at", "radius", "seconds")
    center = fields.point(fields.required(node, "at"))
    radius = entries["radius"].number(0, 1e5) if "radius" in entries else GoalDefinition.radius
    return GoalDefinition(
        center,
        radius,
        entries["seconds"].number(0.1, 1e5) if "seconds" in entries else GoalDefinition.seconds,
    )


def _obstacles(node: Node) -> Iterable[ObstacleDefinition]:
    """Reads `[{sphere: 3, at: [5, 6, 0]}, {plane: [0, 1, 0], at: [0, 2, 0]}]`."""
    if len(node.items()) > MOST_OBSTACLES:
        raise node.refuse(f"a flock has at most {MOST_OBSTACLES} obstacles, not {len(node.items())}")
    for obstacle in node.items():
        entries = obstacle.entries("sphere", "plane", "at")
        if ("sphere" in entries) == ("plane" in entries):
            raise obstacle.refuse(
                "an obstacle is either a `sphere: RADIUS` or a `plane: [x, y, z]`, whose normal points to "
                "the free side"
            )
        center = fields.point(entries["at"]) if "at" in entries else (0.0, 0.0, 0.0)
        if "sphere" in entries:
            yield ObstacleDefinition("sphere", center, entries["sphere"].number(0, 1e5))
        else:
            yield ObstacleDefinition("plane", center, normal=direction(entries["plane"]))

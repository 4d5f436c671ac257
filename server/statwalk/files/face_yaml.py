"""Reads muscles and named expressions of a face (DS9), in a character file or in the extras of a model.

muscles:
  corner.left:
    to: [0.028, 1.575, 0.094]            # the insertion: a point of the skin, or a list of points (a line)
    radius: 0.024                        # metres around it; the pull falls smoothly to 0
    path: [[0.004, 0.002, 0], [0.008, 0.007, -0.003], [0.010, 0.012, -0.008]]
    material: skin                       # only this material's vertices; `joint: Jaw` only a joint's
    mirror: corner.right                 # a second muscle on the other side (-X)
  lid: {vertices: [3, 4, 10-20], path: [[0, -0.004, 0]]}      # these vertices, counted from 0, as one
  brow.left: {to: [0.036, 1.675, 0.09], radius: 0.02, from: [0.03, 1.73, 0.08], pull: 0.15}
faces:
  smile: {corner.left: 0.9, corner.right: 0.85}
clips:
  greet: {faces: {0: {}, 0.3: smile, 1.2: {smile: 0.4}}, loop: false}
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from statwalk.files.vertex_numbers import read_vertices, vertices_in_words
from statwalk.files.yaml.yaml_text import Node
from statwalk.skin.face_muscles import POWERS, Muscle, Point

MOST_MUSCLES, MOST_FACES, MOST_POINTS, MOST_POWERS, MOST_KEYS = 64, 64, 16, 3, 1000
LONGEST_NAME = 60
FARTHEST, SMALLEST = 1e4, 1e-6
"""metres"""
LONGEST_CLIP = 600.0
"""seconds"""
Faces = Mapping[str, Mapping[str, float]]
FaceKeys = dict[str, tuple[Mapping[float, Mapping[str, float]], bool]]
"""by clip: contractions by seconds, and whether it repeats"""


def read_muscles(node: Node | None) -> dict[str, Muscle]:
    """Reads `muscles`, by name.

    :raises ContentError: when a key is unknown, a value is out of its range, or a name is there twice.
    """
    muscles: dict[str, Muscle] = {}
    for name, entry in (node.entries() if node is not None else {}).items():
        for each, muscle in _muscle(name, entry):
            if each in muscles:
                raise entry.refuse(f"the muscle {each} is there twice")
            muscles[each] = muscle
    if node is not None and len(muscles) > MOST_MUSCLES:
        raise node.refuse(f"there are {len(muscles)} muscles; at most {MOST_MUSCLES} are allowed")
    return muscles


def _muscle(name: str, node: Node) -> list[tuple[str, Muscle]]:
    entries = node.entries("to", "radius", "path", "from", "pull", "joint", "material", "vertices", "mirror")
    _check_keys(entries, node)
    _check_name(name, node)
    to = _points(entries["to"], MOST_POINTS) if "to" in entries else ()
    path = _points(entries["path"], MOST_POWERS) if "path" in entries else (_pull(entries, to),)
    muscle = Muscle(
        to,
        entries["radius"].number(SMALLEST, FARTHEST) if "radius" in entries else None,
        path,
        entries["joint"].text() if "joint" in entries else "",
        entries["material"].text() if "material" in entries else "",
        read_vertices(entries["vertices"]) if "vertices" in entries else None,
    )
    if "mirror" not in entries:
        return [(name, muscle)]
    other = entries["mirror"].text()
    _check_name(other, entries["mirror"])
    return [(name, muscle), (other, replace(muscle, to=_mirrored(to), path=_mirrored(path)))]


def _check_keys(entries: Mapping[str, Node], node: Node) -> None:
    """Checks that a muscle says which vertices move, and where they go."""
    is_chosen = "vertices" in entries
    has_place = "to" in entries or (is_chosen and not {"radius", "from"} & entries.keys())
    has_extent = "radius" in entries or is_chosen
    if not has_place or not has_extent or ("path" in entries) == ("from" in entries):
        raise node.refuse(
            "a muscle needs `to` (its insertion) and `radius`, or `vertices`, and either `path` (1 to 3 "
            "control points) or `from` (its attachment, which needs `to`)"
        )
    if "pull" in entries and "from" not in entries:
        raise entries["pull"].refuse("`pull` is the share of the way to the attachment: it needs `from`")
    if "mirror" in entries and "vertices" in entries:
        raise entries["mirror"].refuse(
            "a muscle with `vertices` has no mirror: name the vertices of the other side in another muscle"
        )


def _check_name(name: str, node: Node) -> None:
    if not 0 < len(name) <= LONGEST_NAME or name.endswith(POWERS[1:]) or "'" in name:
        raise node.refuse(
            f"a muscle's name has 1 to {LONGEST_NAME} characters, no quotes, and does not end in .2 or .3: "
            f"{name[:LONGEST_NAME]!r}"
        )


def _pull(entries: Mapping[str, Node], to: tuple[Point, ...]) -> Point:
    share = entries["pull"].number(0, 1) if "pull" in entries else 0.3
    attachment = _point(entries["from"])
    middle = tuple(sum(axis) / len(to) for axis in zip(*to, strict=True))
    x, y, z = (share * (end - start) for end, start in zip(attachment, middle, strict=True))
    return x, y, z


def _mirrored(points: tuple[Point, ...]) -> tuple[Point, ...]:
    return tuple((-x, y, z) for x, y, z in points)


def _points(node: Node, most: int) -> tuple[Point, ...]:
    """Reads one point, or a list of 1 to `most`."""
    items = node.items()
    if items and not isinstance(items[0].value, list):
        return (_point(node),)
    if not 0 < len(items) <= most:
        raise node.refuse(f"1 to {most} points are needed here: [[x, y, z], …]")
    return tuple(_point(item) for item in items)


def _point(node: Node) -> Point:
    items = node.items()
    if len(items) != 3:
        raise node.refuse("a point is [x, y, z], in metres")
    x, y, z = (item.number(-FARTHEST, FARTHEST) for item in items)
    return x, y, z


def read_faces(node: Node | None, muscles: Mapping[str, Muscle]) -> Faces:
    """Reads `faces`: named expressions, each the contractions 0…1 of some muscles.

    :raises ContentError: when a muscle is unknown, or a contraction is out of its range.
    """
    entries = node.entries() if node is not None else {}
    if node is not None and len(entries) > MOST_FACES:
        raise node.refuse(f"there are {len(entries)} faces; at most {MOST_FACES} are allowed")
    faces: dict[str, dict[str, float]] = {}
    for name, entry in entries.items():
        faces[name] = _contractions(entry, muscles, {})
    return faces


def _contractions(node: Node, muscles: Mapping[str, Muscle], faces: Faces) -> dict[str, float]:
    """Reads `{corner.left: 0.9, smile: 0.5}`; what several of them say about a muscle adds up."""
    found: dict[str, float] = {}
    for name, value in node.entries().items():
        if name not in muscles and name not in faces:
            raise node.unknown("muscle or face", name, (*muscles, *faces), node.key_lines[name])
        amount = value.number(0, 1)
        whole: Mapping[str, float] = faces.get(name, {name: 1.0})
        for muscle, contraction in whole.items():
            found[muscle] = min(1.0, found.get(muscle, 0.0) + amount * contraction)
    return found


def read_face_clips(node: Node | None, muscles: Mapping[str, Muscle], faces: Faces) -> FaceKeys:
    """Reads the clips that key faces: `greet: {faces: {0: {}, 0.3: smile, 1.2: {smile: 0.4}}}`.

    :raises ContentError: when a time, a name or a contraction is wrong.
    """
    clips: FaceKeys = {}
    for name, entry in (node.entries() if node is not None else {}).items():
        if "faces" in entry.entries():
            entries = entry.entries("faces", "loop")
            keys = _face_keys(entries["faces"], muscles, faces)
            clips[name] = keys, "loop" in entries and entries["loop"].truth()
    return clips


def _face_keys(
    node: Node, muscles: Mapping[str, Muscle], faces: Faces
) -> Mapping[float, Mapping[str, float]]:
    entries = node.entries()
    if not 0 < len(entries) <= MOST_KEYS:
        raise node.refuse(f"1 to {MOST_KEYS} keys are needed here: {{0: {{}}, 0.3: smile}}")
    keys: dict[float, Mapping[str, float]] = {}
    for key, value in entries.items():
        time = Node(key, node.key_lines[key], node.file, node.error).number(0, LONGEST_CLIP)
        if keys and time <= max(keys):
            raise node.refuse("the times of keys rise", node.key_lines[key])
        if value.is_mapping:
            keys[time] = _contractions(value, muscles, faces)
        elif value.text() in faces:
            keys[time] = faces[value.text()]
        else:
            raise value.unknown("face", value.text(), faces)
    return keys


def in_words(muscles: Mapping[str, Muscle], faces: Mapping[str, Mapping[str, float]]) -> dict[str, Any]:
    """Returns muscles and faces as a character file says them; empty without."""
    words: dict[str, Any] = {}
    if muscles:
        words["muscles"] = {name: _in_words(muscle) for name, muscle in muscles.items()}
    if faces:
        words["faces"] = {name: dict(face) for name, face in faces.items()}
    return words


def _in_words(muscle: Muscle) -> dict[str, Any]:
    words: dict[str, Any] = {"to": [list(point) for point in muscle.to]} if muscle.to else {}
    if muscle.radius is not None:
        words["radius"] = muscle.radius
    words["path"] = [list(point) for point in muscle.path]
    if muscle.joint:
        words["joint"] = muscle.joint
    if muscle.material:
        words["material"] = muscle.material
    if muscle.vertices is not None:
        words["vertices"] = vertices_in_words(muscle.vertices)
    return words

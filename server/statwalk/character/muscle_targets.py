"""Compiles the muscles of a face (DS9) into the morph targets of a character's meshes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from statwalk.character.added_targets import AddedTarget, check_new, check_room, with_targets
from statwalk.character.character import Character
from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths.arrays import Bools, Floats
from statwalk.skin.chosen_vertices import chosen_vertices
from statwalk.skin.face_muscles import Muscle, coefficients, distance_to_line, shares, target_names
from statwalk.skin.primitive import TRIANGLES, Primitive

STILL = 1e-7
"""metres, and parts of a normal, below which a vertex does not move"""
POWERS = {
    1: ((1.0,),),
    2: ((1 / 2, 1 / 4), (1.0, 1.0)),
    3: ((1 / 3, 1 / 9, 1 / 27), (2 / 3, 4 / 9, 8 / 27), (1.0, 1.0, 1.0)),
}
"""for n powers of a contraction: their values at the contractions 1/n, 2/n … 1"""
THROUGH = {
    1: ((1.0,),),
    2: ((4.0, -1.0), (-4.0, 2.0)),
    3: ((9.0, -4.5, 1.0), (-22.5, 18.0, -4.5), (13.5, -13.5, 4.5)),
}
"""the inverse matrices: the polynomial through 0 and given values at those contractions"""


Key = tuple[int, int]
"""the numbers of a mesh and of a primitive in it"""


def with_muscle_targets(character: Character, muscles: Mapping[str, Muscle]) -> Character:
    """Returns the character with muscles and their morph targets, after those that it has; without a model.

    :raises ContentError: when a muscle moves no vertex, a morph target has its name, a chosen vertex does not
        exist, or there would be too many numbers.
    :raises UnknownNameError: when a muscle names a joint or a material that the character does not have.
    """
    made = with_targets(character, muscle_targets(character, muscles))
    return replace(made, muscles={**character.muscles, **muscles})


def muscle_targets(character: Character, muscles: Mapping[str, Muscle]) -> list[AddedTarget]:
    """Returns the morph targets of all muscles for each mesh that a muscle moves, on all its nodes.

    :raises ContentError: when a muscle moves no vertex, a morph target has its name, a chosen vertex does not
        exist, or there would be too many numbers.
    :raises UnknownNameError: when a muscle names a joint or a material that the character does not have.
    """
    _check_names(character, muscles)
    parts = {(part.mesh, part.primitive): part for part in reversed(character.parts)}
    meshes: dict[int, list[Primitive]] = {}
    for key in sorted(parts):
        meshes.setdefault(key[0], []).append(parts[key])
    pulled = {name: _pulls(character, parts, name, muscle) for name, muscle in muscles.items()}
    moved = {key[0] for pulls in pulled.values() for key, pull in pulls.items() if np.any(pull)}
    count = sum(muscle.powers for muscle in muscles.values())
    check_room(count * sum(len(part.positions) for mesh in moved for part in meshes[mesh]))
    rows: dict[Key, list[int]] = {}
    for row, part in enumerate(character.parts):
        rows.setdefault((part.mesh, part.primitive), []).append(row)
    bodies = [(meshes[mesh], _Body(meshes[mesh])) for mesh in sorted(moved)]
    return [
        target
        for name, muscle in muscles.items()
        for target in _targets(name, muscle, pulled[name], bodies, rows)
    ]


def check_targets(character: Character, muscles: Mapping[str, Muscle]) -> None:
    """Checks that the character has the morph targets of muscles.

    :raises UnknownNameError: when a target is missing.
    :raises ContentError: when there are not as many targets of each power.
    """
    for name, muscle in muscles.items():
        counts = {len(character.target(target)) for target in target_names(name, muscle)}
        if len(counts) > 1:
            raise ContentError(f"the morph targets of the muscle {name} do not belong together")


def _check_names(character: Character, muscles: Mapping[str, Muscle]) -> None:
    materials = [str(material.get("name", "")) for material in character.materials]
    for name, muscle in muscles.items():
        for target in target_names(name, muscle):
            check_new(character, target)
        if muscle.joint:
            character.skeleton.index(muscle.joint)
        if muscle.material and muscle.material not in materials:
            raise UnknownNameError("material", muscle.material, materials)


def _pulls(
    character: Character, parts: Mapping[Key, Primitive], name: str, muscle: Muscle
) -> dict[Key, Floats]:
    """How far the vertices of each primitive move with a muscle."""
    chosen = _chosen(character, name, muscle)
    pulls = {
        key: _pull(character, part, muscle) * (1.0 if chosen is None else chosen[key])
        for key, part in parts.items()
    }
    if not any(np.any(pull) for pull in pulls.values()):
        raise ContentError(f"the muscle {name} moves no vertex: {_nearest(character, muscle)}")
    return pulls


def _chosen(character: Character, name: str, muscle: Muscle) -> dict[Key, Bools] | None:
    """Which vertices of each primitive a muscle names; a mesh on several nodes moves on all of them."""
    if muscle.vertices is None:
        return None
    ends = np.cumsum([len(part.positions) for part in character.parts])
    try:
        flags = chosen_vertices(muscle.vertices, int(ends[-1]) if len(ends) else 0)
    except ContentError as error:
        raise ContentError(f"the muscle {name}: {error.message}") from None
    chosen: dict[Key, Bools] = {}
    for part, own in zip(character.parts, np.split(flags, ends[:-1]), strict=True):
        key = part.mesh, part.primitive
        chosen[key] = own | chosen[key] if key in chosen else own
    return chosen


def _pull(character: Character, part: Primitive, muscle: Muscle) -> Floats:
    material = character.materials[part.material].get("name") if part.material is not None else None
    if muscle.material and material != muscle.material:
        return np.zeros(len(part.positions))
    return shares(part.positions.astype(np.float64), muscle) * _following(character, part, muscle.joint)


def _following(character: Character, part: Primitive, joint: str) -> Floats:
    """How far the vertices of a primitive follow a joint: their weight; all of them without a joint."""
    if not joint:
        return np.ones(len(part.positions))
    row = character.skeleton.index(joint)
    if part.skin is None or part.joints is None or part.weights is None:
        return np.full(len(part.positions), float(part.joint == row))
    rows = character.skins[part.skin].joints[part.joints]
    return np.asarray((part.weights * (rows == row)).sum(-1), np.float64)


def _nearest(character: Character, muscle: Muscle) -> str:
    if muscle.radius is None or muscle.vertices is not None:
        return "none of its vertices has its joint and its material, within its radius"
    away = [
        float(distance_to_line(part.positions.astype(np.float64), np.array(muscle.to)).min())
        for part in character.parts
    ]
    if not away:
        return "the model has no mesh"
    return (
        f"its radius is {muscle.radius:g} m, and the nearest vertex is {min(away):.3g} m from its insertion"
    )


def _targets(
    name: str,
    muscle: Muscle,
    pulls: Mapping[Key, Floats],
    bodies: Sequence[tuple[Sequence[Primitive], _Body]],
    rows: Mapping[Key, Sequence[int]],
) -> list[AddedTarget]:
    """Returns the morph targets of one muscle; `rows` are the parts that show a primitive."""
    targets = [AddedTarget(target, {}, {}) for target in target_names(name, muscle)]
    for parts, body in bodies:
        keys = [(part.mesh, part.primitive) for part in parts]
        pull = np.concatenate([pulls[key] for key in keys])
        moves = pull[None, :, None] * coefficients(muscle.path)[:, None, :]
        ends = np.cumsum([len(part.positions) for part in parts])[:-1].tolist()
        for target, *columns in zip(targets, moves, body.normal_moves(moves), strict=True):
            for values, arrays in zip(columns, (target.positions, target.normals), strict=True):
                still = np.where(np.abs(values) < STILL, 0, values).astype(np.float32)
                for key, split in zip(keys, np.split(still, ends), strict=True):
                    arrays.update(dict.fromkeys(rows[key], split))
    return targets


class _Body:
    """The vertices and triangles of all primitives of a mesh; vertices at one place share a normal."""

    def __init__(self, parts: Sequence[Primitive]) -> None:
        self.points = np.concatenate([part.positions for part in parts]).astype(np.float64)
        _, same = np.unique(self.points, axis=0, return_inverse=True)
        self.same = same.reshape(-1)
        starts = np.cumsum([0, *(len(part.positions) for part in parts)])
        faces = [
            start
            + (np.arange(len(part.positions)) if part.indices is None else part.indices).astype(np.int64)
            for start, part in zip(starts, parts, strict=False)
            if part.mode == TRIANGLES
        ]
        whole = [row[: len(row) // 3 * 3] for row in faces]
        self.faces = np.concatenate([np.zeros(0, np.int64), *whole]).reshape(-1, 3)

    def normals(self, points: Floats) -> Floats:
        """Returns unit normals (V, 3), the mean of the triangles around by their area; 0 without."""
        corners = points[self.faces]
        across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        total = np.zeros((len(points), 3))
        for corner in range(3):
            np.add.at(total, self.same[self.faces[:, corner]], across)
        normals = total[self.same]
        length = np.linalg.norm(normals, axis=-1, keepdims=True)
        return np.asarray(normals / np.where(length > 0, length, 1))

    def normal_moves(self, moves: Floats) -> Floats:
        """Returns (n, V, 3) the displacements of the normals for those of the positions: exact where the
        contraction is 1/n, 2/n … 1, and the polynomial through them between.
        """
        rest = self.normals(self.points)
        shown = [self.normals(self.points + _mixed(row, moves)) - rest for row in POWERS[len(moves)]]
        return np.stack([_mixed(row, shown) for row in THROUGH[len(moves)]])


def _mixed(shares: Sequence[float], moves: Sequence[Floats] | Floats) -> Floats:
    """The sum of moves (V, 3), each by its share, in their order: the same bits on every processor."""
    total = np.zeros_like(moves[0])
    for share, move in zip(shares, moves, strict=True):
        total = total + share * move
    return total

"""Compiles muscle bulges (DS8, FAQ Q22): the angle of a joint gives a scale factor by a cubic, and the factor
moves chosen vertices away from a point or an axis.

A bulge becomes a morph target and an expression. The target moves each vertex by its offset from the point or
axis; the weight is the scale factor - 1, so that the vertex is at factor · offset. Any glTF viewer shows it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from statwalk.character.added_targets import AddedTarget, check_new, with_targets
from statwalk.character.character import Character
from statwalk.errors import ContentError, UnknownNameError
from statwalk.machine.definition.expression_lines import read_lines
from statwalk.maths import transform
from statwalk.maths.arrays import Bools, Floats
from statwalk.maths.formula.assignments import Assignment, AssignmentError
from statwalk.rig.evaluate import world_from_local
from statwalk.skin.bulge import Bulge
from statwalk.skin.chosen_vertices import chosen_vertices
from statwalk.skin.deform import surface
from statwalk.skin.primitive import TRIANGLES, Primitive
from statwalk.skin.shading import smooth_normals, triangles

USUAL = 0.3
"""the weight at which the change of normals is measured; normals between are on the straight line"""
SMALLEST = 1e-12


def with_bulges(character: Character, bulges: Sequence[Bulge]) -> Character:
    """Returns the character with the morph target and the expression of each bulge, without a model.

    :raises ContentError: when a morph target has the name already, no vertex is chosen, or a joint does not
        exist; `place` is the line.
    """
    targets = []
    for bulge in bulges:
        try:
            targets.append(_target(character, bulge))
        except (ContentError, UnknownNameError) as error:
            message = error.message if isinstance(error, ContentError) else str(error)
            raise ContentError(message, place=f"line {bulge.line}") from None
    lines = [(line.line, line.text) for line in character.expressions]
    try:
        expressions = read_lines([*lines, *((bulge.line, bulge.expression) for bulge in bulges)], ())
    except AssignmentError as error:
        raise ContentError(error.message, place=f"line {error.line}") from None
    named = {**character.bulges, **{bulge.name: replace(bulge, line=0) for bulge in bulges}}
    return replace(with_targets(character, targets), expressions=expressions, bulges=named)


def expressions_of_bulges(
    expressions: Sequence[Assignment], bulges: Mapping[str, Bulge]
) -> tuple[Assignment, ...]:
    """Returns the expressions of a file in which every bulge sets its weight as it says itself: a bulge that
    someone changed in the file gets its new line.

    :raises ContentError: when the lines do not fit each other.
    """
    own = {bulge.weight: bulge for bulge in bulges.values()}
    kept = {line.target: line.text for line in expressions}
    if all(kept.get(target) == bulge.expression for target, bulge in own.items()):
        return tuple(expressions)
    lines = [(line.line, line.text) for line in expressions if line.target not in own]
    try:
        return read_lines([*lines, *((bulge.line, bulge.expression) for bulge in bulges.values())], ())
    except AssignmentError as error:
        raise ContentError(f"bulges: {error.message}") from None


def checked_bulges(character: Character, bulges: Mapping[str, Bulge]) -> dict[str, Bulge]:
    """Returns the bulges that a model carries, after a look at its bones and morph targets.

    :raises UnknownNameError: when one is missing.
    """
    for bulge in bulges.values():
        character.target(bulge.name)
        character.skeleton.index(bulge.bone)
        character.skeleton.index(bulge.joint)
    return {name: replace(bulge, line=0) for name, bulge in bulges.items()}


def _target(character: Character, bulge: Bulge) -> AddedTarget:
    """Returns the morph target of a bulge."""
    check_new(character, bulge.name)
    character.skeleton.index(bulge.joint)
    moves, parts = _displacements(character, bulge), character.parts
    is_moved: Bools = np.asarray((np.abs(moves) > SMALLEST).any(-1))
    if not is_moved.any():
        raise ContentError("no vertex is chosen, or all are on the point or axis")
    ends = np.cumsum([len(part.positions) for part in parts]).tolist()
    spans = [slice(end - len(part.positions), end) for part, end in zip(parts, ends, strict=True)]
    rows = {row: moves[span] for row, span in enumerate(spans) if is_moved[span].any()}
    return AddedTarget(
        bulge.name,
        {row: move.astype(np.float32) for row, move in rows.items()},
        {row: _normal_change(parts[row], move) for row, move in rows.items()},
    )


def _displacements(character: Character, bulge: Bulge) -> Floats:
    """Returns (V, 3) the offset of each vertex of all parts, times its share; in the space of its mesh."""
    world = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    rest = surface(character.parts, character.skins)
    bone = world[character.skeleton.index(bulge.bone)]
    bind = transform.mul(world[rest.palette.joints], rest.palette.inverse_bind.astype(np.float64))
    blended = (rest.weights.astype(np.float64)[..., None, None] * bind[rest.bones]).sum(1)
    placed = transform.apply(blended, rest.positions.T.astype(np.float64))
    with np.errstate(all="ignore"):
        own = transform.apply(transform.invert(bone), placed) - np.array(bulge.point)
        moved = transform.apply_vector(bone, _from_axis(own, bulge) * _share(own, bulge)[:, None])
        back = transform.invert(np.concatenate([blended[..., :3], 0 * blended[..., 3:]], -1))
        moves: Floats = np.nan_to_num(transform.apply_vector(back, moved), nan=0, posinf=0, neginf=0)
        return moves


def _from_axis(offset: Floats, bulge: Bulge) -> Floats:
    """Returns the offsets (V, 3) from the point, or from the axis through it."""
    if bulge.axis is None:
        return offset
    axis = np.array(bulge.axis) / np.linalg.norm(bulge.axis)
    across: Floats = offset - (offset @ axis)[:, None] * axis
    return across


def _share(offset: Floats, bulge: Bulge) -> Floats:
    """Returns the share (V) of the bulge that each vertex has: 1 if it is chosen, 0 if not, and between these
    inside an ellipsoid: (1 - e²)² at the share e of the way out.
    """
    share = np.ones(len(offset))
    if bulge.vertices is not None:
        share *= chosen_vertices(bulge.vertices, len(offset))
    if bulge.radius is not None:
        outwards = ((offset / np.array(bulge.radius)) ** 2).sum(-1)
        share *= np.where(outwards < 1, (1 - outwards) ** 2, 0)
    return share


def _normal_change(part: Primitive, moves: Floats) -> NDArray[np.float32]:
    """Returns the change of the normals (V, 3) with the weight: the change of the normals of a smooth surface
    through the vertices, in which vertices at one place are joined.
    """
    if part.normals is None or part.mode < TRIANGLES:
        return np.zeros(part.positions.shape, np.float32)
    order = np.arange(len(part.positions)) if part.indices is None else part.indices
    _, first, place = np.unique(part.positions, axis=0, return_index=True, return_inverse=True)
    faces = place.reshape(-1)[triangles(order.astype(np.int64), part.mode)]
    before, moved = part.positions[first].astype(np.float64), moves[first]
    change = smooth_normals(before + USUAL * moved, faces) - smooth_normals(before, faces)
    own = part.normals + change[place.reshape(-1)]
    own /= np.maximum(np.linalg.norm(own, axis=1, keepdims=True), SMALLEST)
    return np.asarray((own - part.normals) / USUAL, np.float32)

"""Crossings of uneven ground: how deep skin is in steps and slopes, how far feet slide, how joints jump."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from statwalk.character.feet import Foot, feet_of
from statwalk.character.role import Role
from statwalk.character.skin_points import SkinPoints, outermost_points
from statwalk.machine.definition.ground_definition import GroundDefinition
from statwalk.stage.measure.jump import STILL, changes_of, joints_shown
from statwalk.stage.stage import Stage

NEAR = 0.006
"""metres: a sole point that is nearer to the ground stands on it"""
ROUND, FARTHEST = 16, 0.15


class Crossing(NamedTuple):
    """The joints (T, J, 3, 4) of a walk on the stage, and the root's heights (T,)."""

    world: np.ndarray
    root: np.ndarray


def crossing(
    role: Role, place: Sequence[float], heading: float, ticks: int, event: str = "FORWARD"
) -> Crossing:
    """Holds an event for some ticks."""
    stage = Stage(seed=1)
    actor = stage.add(role, place, heading)
    stage.hold(actor, event)
    shots = []
    for _ in range(ticks):
        stage.step()
        shots.append((np.asarray(actor.world)[:, :3].copy(), float(actor.matrix[1, 3])))
    return Crossing(np.array([world for world, _ in shots]), np.array([height for _, height in shots]))


def heights_at(pieces: Sequence[GroundDefinition], x: np.ndarray, z: np.ndarray) -> np.ndarray:
    """The height of the ground from the corners' heights in the file."""
    heights = np.zeros(np.broadcast(x, z).shape)
    for piece in pieces:
        (x0, z0), (x1, z1) = piece.corner, piece.opposite
        end = piece.height if piece.end_height is None else piece.end_height
        share = (x - x0) / (x1 - x0) if piece.axis == "x" else (z - z0) / (z1 - z0)
        inside = (x >= x0) & (x <= x1) & (z >= z0) & (z <= z1)
        heights = np.where(inside, np.maximum(heights, piece.height + share * (end - piece.height)), heights)
    return heights


def depths(pieces: Sequence[GroundDefinition], points: np.ndarray) -> np.ndarray:
    """How far points (…, 3) are from the nearest place outside the ground, upwards or to a side."""
    flat = points.reshape(-1, 3).astype(np.float64)
    depth = (heights_at(pieces, flat[:, 0], flat[:, 2]) - flat[:, 1]).clip(0)
    rows = np.flatnonzero(depth > 0.001)
    inside, least = flat[rows], depth[rows]
    for angle in np.arange(ROUND) * (2 * np.pi / ROUND):
        for away in np.arange(0.002, FARTHEST, 0.002):
            x, z = inside[:, 0] + away * np.sin(angle), inside[:, 2] + away * np.cos(angle)
            least = np.where(heights_at(pieces, x, z) <= inside[:, 1], np.minimum(least, away), least)
    depth[rows] = least
    return depth.reshape(points.shape[:-1])


def skin_depth(role: Role, walk: Crossing) -> np.ndarray:
    """(T,) the depth of the deepest point of the skin."""
    joints = [joint for foot in feet_of(role.character) for joint in foot.joints]
    skin: SkinPoints = outermost_points(role.character, whole=joints)
    points = np.array([skin.at(world) for world in walk.world])
    return depths(role.definition.ground, points).max(1)


def slide(role: Role, walk: Crossing, foot: Foot) -> float:
    """The farthest that a sole point moves in one contact, as `stage/measure/slide.py` over a level floor."""
    points = foot.skin.at(walk.world).astype(np.float64)
    over = np.abs(points[..., 1] - heights_at(role.definition.ground, points[..., 0], points[..., 2]))
    near, higher = over < NEAR, np.maximum(over[1:], over[:-1]).clip(0, NEAR)
    steps = np.linalg.norm(np.diff(points, axis=0), axis=-1) * (near[1:] & near[:-1])
    farthest, way = 0.0, np.zeros(points.shape[1])
    for is_near, step in zip(near[1:], steps * (2 - 2 ** (higher / NEAR)), strict=True):
        way = np.where(is_near.any(), way + step, 0)
        farthest = max(farthest, float(way.max()))
    return farthest


def jumps(role: Role, walk: Crossing, level: Crossing) -> tuple[float, float]:
    """The largest change of position or velocity from tick to tick relative to a walk on a level floor: of
    the liveliest joint, and of any single joint.
    """
    joints = joints_shown(role)
    changes, usual = (changes_of(each.world[..., 3][:, joints].astype(float)) for each in (walk, level))
    body = (changes.max(1) / usual.max(1)).max()
    return float(body), float((changes / (usual + STILL)).max())

"""The soles of a character's feet: the lowest points of what each foot carries, at rest."""

from __future__ import annotations

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import SIDES, ancestors
from statwalk.maths.arrays import Bools, Floats

MOST_POINTS = 64
SOLE_SHARE = 0.35
"""of the ankle's height: points below count as sole"""


def soles_of(body: Body) -> dict[str, Floats]:
    """Returns by foot bone the points (K, 3) of its sole in the character's space at rest; a foot without a
    mesh has its joints.
    """
    return {side + "Foot": _sole(body, side) for side in SIDES if side + "Foot" in body.bones}


def ground_of(soles: dict[str, Floats]) -> float:
    """Returns the height (metres) of the ground that the character stands on at rest."""
    return min((float(points[:, 1].min()) for points in soles.values()), default=0.0)


def _sole(body: Body, side: str) -> Floats:
    roots = {body.bones[side + bone] for bone in ("Foot", "Toes") if side + bone in body.bones}
    skeleton = body.character.skeleton
    carried = np.array([not roots.isdisjoint(ancestors(skeleton, joint)) for joint in range(len(skeleton))])
    points = _points(body, carried)
    if not len(points):
        joints: Floats = body.position[carried]
        return joints
    low, ankle = points[:, 1].min(), body.at(side + "Foot")[1]
    sole: Floats = points[points[:, 1] <= low + SOLE_SHARE * max(ankle - low, 0.0) + 1e-6]
    spread: Floats = sole[:: -(-len(sole) // MOST_POINTS)]
    return spread


def _points(body: Body, carried: Bools) -> Floats:
    """Returns the vertices (K, 3) that the joints `carried` move most, in the character's space at rest."""
    character = body.character
    found: list[Floats] = []
    for part, posed in zip(character.parts, character.vertices(character.bind_pose), strict=True):
        if part.skin is None or part.joints is None or part.weights is None:
            own = np.full(len(posed.positions), carried[part.joint])
        else:
            joints = character.skins[part.skin].joints[part.joints]
            own = (carried[joints] * part.weights).sum(-1) > 0.5
        found.append(posed.positions[own].astype(np.float64))
    return np.concatenate(found) if found else np.zeros((0, 3))

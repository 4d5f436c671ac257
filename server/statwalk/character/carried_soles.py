"""Finds how far soles reach below their ankles while a body moves as another body does."""

from __future__ import annotations

from collections.abc import Container, Mapping
from typing import NamedTuple

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import ancestors
from statwalk.character.feet import BONES, Foot, feet_of
from statwalk.character.feet import SIDES as SIDE_OF
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.rig.evaluate import world_from_local


class Sole(NamedTuple):
    """The sole of a foot, at rest.

    foot      the foot's bone
    toes      the toes' bone; "": the toes turn with the foot
    arms      (K, 3) its points from the ankle
    toe_arms  (L, 3) the points that turn with the toes, from the joint of the toes
    ball      (3,) the joint of the toes from the ankle
    lowest    the height of its lowest point
    """

    foot: str
    toes: str
    arms: Floats
    toe_arms: Floats
    ball: Floats
    lowest: float

    def under(self, body: Body, turn: Floats, turns: Mapping[str, Floats]) -> Floats:
        """Returns how far (F,) the lowest point is under the ankle, with the foot turned by `turn` (F, 4) and
        the toes as in `turns`.
        """
        foot = _heights_of(body, self.foot, turn)
        lowest = _lowest(foot, self.arms)
        if self.toes:
            toes = _heights_of(body, self.toes, turns[self.toes])
            lowest = np.minimum(lowest, vector.dot(foot, self.ball) + _lowest(toes, self.toe_arms))
        return -lowest


def soles_of(body: Body, turning: Container[str]) -> dict[str, Sole]:
    """Returns the soles by foot bone; `turning`: the bones that turn by themselves."""
    names = body.character.skeleton.names
    legs = {
        foot: {
            part: names[body.bones[side + bone]] for part, bone in BONES.items() if side + bone in body.bones
        }
        for foot, side in SIDE_OF.items()
        if side + "Foot" in body.bones
    }
    rest = world_from_local(body.character.skeleton, body.character.bind_pose).astype(np.float64)
    feet = [foot for foot in feet_of(body.character, legs) if foot.name in legs]
    return {
        SIDE_OF[foot.name] + "Foot": _sole(body, foot, foot.skin.at(rest), SIDE_OF[foot.name], turning)
        for foot in feet
    }


def _sole(body: Body, foot: Foot, points: Floats, side: str, turning: Container[str]) -> Sole:
    toes = side + "Toes" if side + "Toes" in turning and side + "Toes" in body.bones else ""
    skeleton, at_toes = body.character.skeleton, np.zeros(len(points), bool)
    if toes:
        carried = [body.bones[toes] in ancestors(skeleton, carrier) for carrier in foot.carriers.tolist()]
        at_toes = np.array(carried, bool)
    ankle = body.at(f"{side}Foot")
    joint = body.at(toes) if toes else ankle
    arms, toe_arms = points[~at_toes] - ankle, points[at_toes] - joint
    return Sole(f"{side}Foot", toes, arms, toe_arms, joint - ankle, float(points[:, 1].min()))


def _heights_of(body: Body, bone: str, turn: Floats) -> Floats:
    """What (F, 3) vectors fixed to a bone, given at rest, are multiplied with for their heights."""
    away = quat.mul(turn, quat.conjugate(body.rotation[body.bones[bone]]))
    heights: Floats = quat.to_matrix(away)[:, 1, :]
    return heights


def _lowest(heights: Floats, arms: Floats) -> Floats:
    lowest = np.full(len(heights), np.inf)
    for arm in arms:
        np.minimum(lowest, vector.dot(heights, arm), out=lowest)
    return lowest

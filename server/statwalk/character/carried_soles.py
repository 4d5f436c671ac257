"""Finds how far soles reach below their ankles while a body moves as another body does."""

from __future__ import annotations

from collections.abc import Container, Iterator, Mapping
from typing import NamedTuple

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import ancestors
from statwalk.character.feet import BONES, Foot, feet_of
from statwalk.character.feet import SIDES as SIDE_OF
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.rig.evaluate import world_from_local

SHARED = 0.005
"""in legs: points of a sole that are so much higher than the lowest one carry the foot by a third as much"""
THINNEST, LEAST_SHARE = 1e-4, 1e-300
"""metres: SHARED is no less; the sum of what all points carry: of a foot that turns too fast to roll"""


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

    def under(self, body: Body, turns: Mapping[str, Floats]) -> Floats:
        """Returns how far (F,) the lowest point is under the ankle, with foot and toes turned (F, 4)."""
        foot = _heights_of(body, self.foot, turns[self.foot])
        lowest = _lowest(foot, self.arms)
        if self.toes:
            toes = _heights_of(body, self.toes, turns[self.toes])
            lowest = np.minimum(lowest, vector.dot(foot, self.ball) + _lowest(toes, self.toe_arms))
        return -lowest

    def rolled(self, body: Body, turns: Mapping[str, Floats]) -> Floats:
        """Returns (F - 1, 3) how far the lowest points go in each frame, as seen from the ankle."""
        lowest, band = -self.under(body, turns), max(SHARED * body.leg(), THINNEST)
        way, whole = np.zeros((len(lowest) - 1, 3)), np.zeros(len(lowest) - 1)
        for arm in self._arms(body, turns):
            above = (arm[1:, 1] - lowest[1:]) + (arm[:-1, 1] - lowest[:-1])
            weight = np.exp(-above / band)
            way += np.diff(arm, axis=0) * weight[:, None]
            whole += weight
        rolled: Floats = way / np.maximum(whole, LEAST_SHARE)[:, None]
        return rolled

    def _arms(self, body: Body, turns: Mapping[str, Floats]) -> Iterator[Floats]:
        """The points (F, 3) from the ankle, one after the other."""
        foot = _away(body, self.foot, turns[self.foot])
        yield from (quat.rotate(foot, arm) for arm in self.arms)
        if self.toes:
            ball, toes = quat.rotate(foot, self.ball), _away(body, self.toes, turns[self.toes])
            yield from (ball + quat.rotate(toes, arm) for arm in self.toe_arms)


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
    heights: Floats = quat.to_matrix(_away(body, bone, turn))[:, 1, :]
    return heights


def _away(body: Body, bone: str, turn: Floats) -> Floats:
    """The turn (F, 4) of a bone from its rest."""
    return quat.mul(turn, quat.conjugate(body.rotation[body.bones[bone]]))


def _lowest(heights: Floats, arms: Floats) -> Floats:
    lowest = np.full(len(heights), np.inf)
    for arm in arms:
        np.minimum(lowest, vector.dot(heights, arm), out=lowest)
    return lowest

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
"""metres that SHARED makes at least; the least sum of what all points carry: a foot may turn so fast that no
point is near the ground in two frames
"""


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
        lowest = np.full(len(turns[self.foot]), np.inf)
        for height, _ in self._points(body, turns):
            np.minimum(lowest, height, out=lowest)
        return -lowest

    def rolled(self, body: Body, turns: Mapping[str, Floats]) -> Floats:
        """Returns (F - 1, 3) how far the lowest points go in each frame, as seen from the ankle."""
        lowest, band = -self.under(body, turns), max(SHARED * body.leg(), THINNEST)
        frames = len(lowest) - 1
        share, carried = np.full(frames, LEAST_SHARE), {bone: np.zeros((frames, 3)) for bone in turns}
        for height, arms in self._points(body, turns):
            above = height - lowest
            weight = np.exp(-(above[1:] + above[:-1]) / band)
            share += weight
            for bone, arm in arms.items():
                carried[bone] += weight[:, None] * arm
        way: Floats = np.zeros((frames, 3))
        for bone, arm in carried.items():
            turned = np.diff(quat.to_matrix(_away(body, bone, turns[bone])), axis=0)
            way = way + (turned @ (arm / share[:, None])[..., None])[..., 0]
        return way

    def _points(self, body: Body, turns: Mapping[str, Floats]) -> Iterator[tuple[Floats, dict[str, Floats]]]:
        """Yields of each point its height (F,) above the ankle, and the vectors (3,) that lead to it, by the
        bone to which each is fixed.
        """
        foot = _heights_of(body, self.foot, turns[self.foot])
        for arm in self.arms:
            yield vector.dot(foot, arm), {self.foot: arm}
        if self.toes:
            toes, ball = _heights_of(body, self.toes, turns[self.toes]), vector.dot(foot, self.ball)
            for arm in self.toe_arms:
                yield ball + vector.dot(toes, arm), {self.foot: self.ball, self.toes: arm}


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

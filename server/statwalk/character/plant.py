"""Puts a carried motion on the ground: hips at the height that the target's legs give them, ankles where the
captured ankles go, no sole below the ground. Rule 12 finds the knees, bent forward.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import PARENTS, SIDES
from statwalk.character.captured_steps import CapturedSteps, standing_height, steps_of
from statwalk.character.carried_soles import Sole, soles_of
from statwalk.character.held_soles import held
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import low_pass_rotations
from statwalk.solve.rules import joint_between

LONGEST_REACH = 0.998
"""of a leg's length: a knee that is fully straight has no side to bend to"""
MOST_LIFT = 0.1
"""of the leg's length, by which a tilted foot may lift its ankle"""
ROUNDS = 4
"""in which the part of a tilt is found that does not lift the ankle too far"""
CALM = 8.0
"""Hz: feet do not turn faster to and fro"""
Y = np.array([0.0, 1.0, 0.0])


class CapturedPath(NamedTuple):
    """The captured places in the target's space and scale, before the target stands on its own ground.

    hips   (F, 3)
    feet   by foot bone, (F, 3) of the ankle
    toes   by foot bone, (F, 3) of the toes, where they are known
    drop   metres that the source's hip joints are below its hips
    times  (F,) seconds
    """

    hips: Floats
    feet: dict[str, Floats]
    toes: dict[str, Floats]
    drop: float
    times: Floats


class BodyKeys(NamedTuple):
    """The target's motion in its own space.

    turns    by bone, (F, 4)
    places   by bone, (F, 3): the hips, and feet that do not hang on their legs
    """

    turns: dict[str, Floats]
    places: dict[str, Floats]


def planted(body: Body, turns: dict[str, Floats], path: CapturedPath) -> BodyKeys:
    """Returns the turns of the bones with the legs on the ground, and where the hips are."""
    soles = soles_of(body, turns)
    ground = min((sole.lowest for sole in soles.values()), default=0.0)
    steps = {foot: _steps(path, foot, body.leg()) for foot in path.feet}
    hips = _hips(body, path, soles, steps)
    solved, places = dict(turns), {"Hips": hips}
    for side in SIDES:
        leg = [side + bone for bone in ("UpperLeg", "LowerLeg", "Foot")]
        if all(bone in turns for bone in leg) and leg[2] in path.feet:
            sole, foot_steps = soles[leg[2]], steps[leg[2]]
            captured = _ankle(body, turns, hips, path, leg[2])
            height = captured[:, 1] - ground - foot_steps.floor
            feet = _flattened(body, _calmed(turns, sole, path.times), height - foot_steps.above, sole)
            under = sole.under(body, feet)
            above = foot_steps.above if leg[2] in path.toes else np.maximum(height - under, 0)
            raised = captured + Y * (ground + under + above - captured[:, 1])[:, None]
            target = held(body, sole, feet, raised, foot_steps.stands)
            solved |= feet | _leg(body, turns, hips, target, leg)
    return BodyKeys(solved, places | _detached(body, solved, places))


def _steps(path: CapturedPath, foot: str, leg: float) -> CapturedSteps:
    toes = [path.toes[foot]] if foot in path.toes else []
    return steps_of([path.feet[foot], *toes], leg, path.times)


def _hips(body: Body, path: CapturedPath, soles: dict[str, Sole], steps: dict[str, CapturedSteps]) -> Floats:
    """Returns the hips (F, 3): the hip joints as high above the standing ankle as the captured ones,
    in scale.
    """
    if not path.feet or not soles:
        upright: Floats = path.hips + Y * (body.at("Hips")[1] - path.hips[0, 1])
        return upright
    standing = min(map(standing_height, path.feet.values()))
    ankle = min(float(body.at(foot)[1]) for foot in soles)
    legs = [bone for bone in ("LeftUpperLeg", "RightUpperLeg") if bone in body.bones]
    drop = float(np.mean([body.at("Hips")[1] - body.at(bone)[1] for bone in legs])) if legs else path.drop
    floor = np.min([step.floor for step in steps.values()], axis=0)
    raised: Floats = path.hips + Y * (ankle - standing + drop - path.drop - floor)[:, None]
    return raised


def _ankle(body: Body, turns: dict[str, Floats], hips: Floats, path: CapturedPath, foot: str) -> Floats:
    """Returns where an ankle goes (F, 3): as the captured one, further aside by as much as hips are wider."""
    captured = path.feet[foot]
    free = _freely(body, turns, hips, foot)
    aside = (free - captured) * np.array([1.0, 0.0, 1.0])
    heading = _heading(body, turns)
    left = quat.rotate(heading, quat.rotate(body.axes, np.array([1.0, 0.0, 0.0])))
    wider = np.median(vector.dot(aside, left))
    return captured + left * wider + Y * (float(body.at(foot)[1]) - standing_height(captured))


def _heading(body: Body, turns: dict[str, Floats]) -> Floats:
    """Returns the turn (F, 4) of the hips about the vertical."""
    turn = quat.mul(turns["Hips"], quat.conjugate(body.rotation[body.bones["Hips"]]))
    twist = turn * np.array([0.0, 1.0, 0.0, 1.0])
    return quat.normalize(twist)


def _freely(body: Body, turns: dict[str, Floats], hips: Floats, bone: str) -> Floats:
    """Returns where a bone's joint (F, 3) is if every bone above it only turns."""
    chain = [bone]
    while chain[-1] != "Hips":
        chain.append(next(above for above in _above(chain[-1]) if above in turns))
    place = hips
    for upper, lower in zip(chain[:0:-1], chain[-2::-1], strict=True):
        place = place + _turned(body, turns, upper, body.at(lower) - body.at(upper))
    return place


def _above(bone: str) -> list[str]:
    """Returns the bones above a bone, the nearest first."""
    above = [PARENTS[bone]]
    while above[-1] != "Hips":
        above.append(PARENTS[above[-1]])
    return above


def _turned(body: Body, turns: dict[str, Floats], bone: str, at_rest: Floats) -> Floats:
    """Returns vectors (…, 3) that are fixed to a bone, given at rest, in every frame."""
    turn = quat.mul(turns[bone], quat.conjugate(body.rotation[body.bones[bone]]))
    return quat.rotate(turn, np.broadcast_to(at_rest, (*turn.shape[:-1], 3)))


def _calmed(turns: Mapping[str, Floats], sole: Sole, times: Floats) -> dict[str, Floats]:
    """Returns the turns (F, 4) of the foot, and of toes that turn by themselves, without what shakes them: on
    a long foot it would lift the ankle.
    """
    bones = [bone for bone in (sole.foot, sole.toes) if bone]
    if len(times) < 2:
        return {bone: turns[bone] for bone in bones}
    rate = 1 / float(np.median(np.diff(times)))
    return {bone: low_pass_rotations(turns[bone], rate, CALM) for bone in bones}


def _flattened(body: Body, tilted: Mapping[str, Floats], height: Floats, sole: Sole) -> dict[str, Floats]:
    """Returns the turns (F, 4) of foot and toes, nearer to level where their tilt would lift the ankle, which
    is so high (F,) above the ground, too far: a long foot on a short leg.
    """
    level = {bone: _level(body, bone, turn) for bone, turn in tilted.items()}
    least, part = sole.under(body, level), np.ones(len(height))
    allowed = np.maximum(MOST_LIFT * body.leg() + height - least, 0)
    for _ in range(ROUNDS):
        under = sole.under(body, _between(level, tilted, part))
        part = part * np.minimum(allowed / np.maximum(under - least, 1e-9), 1)
    return _between(level, tilted, part)


def _between(level: Mapping[str, Floats], tilted: Mapping[str, Floats], part: Floats) -> dict[str, Floats]:
    return {bone: quat.nlerp(level[bone], turn, part) for bone, turn in tilted.items()}


def _level(body: Body, bone: str, turn: Floats) -> Floats:
    """Returns the turn (F, 4) of a bone with what it turns about the vertical alone."""
    rest = body.rotation[body.bones[bone]]
    away = quat.mul(turn, quat.conjugate(rest))
    return quat.mul(quat.normalize(away * np.array([0.0, 1.0, 0.0, 1.0])), rest)


def _leg(
    body: Body, turns: dict[str, Floats], hips: Floats, target: Floats, leg: list[str]
) -> dict[str, Floats]:
    """Returns the turns of thigh and shin that bring the ankle to its target; the knee bends forward."""
    upper, lower, foot = leg
    root, mid = _freely(body, turns, hips, upper), _freely(body, turns, hips, lower)
    end = _freely(body, turns, hips, foot)
    thigh, shin = vector.length(mid - root), vector.length(end - mid)
    reach = (thigh + shin) * LONGEST_REACH
    way = target - root
    far = np.minimum(1, reach / np.maximum(vector.length(way), 1e-9))
    forward = quat.rotate(body.axes, np.array([0.0, 0.0, 1.0]))
    pole = _turned(body, turns, upper, forward)
    ankle = root + way * far[:, None]
    knee = joint_between(root, thigh, ankle, shin, pole).point
    turn_upper = quat.between(vector.unit(mid - root), vector.unit(knee - root))
    turn_lower = quat.between(vector.unit(end - mid), vector.unit(ankle - knee))
    return {upper: quat.mul(turn_upper, turns[upper]), lower: quat.mul(turn_lower, turns[lower])}


def _detached(body: Body, turns: dict[str, Floats], places: dict[str, Floats]) -> dict[str, Floats]:
    """Returns the places of bones that hang on a bone above which their joint does not hang in the file."""
    parent = body.character.skeleton.parent
    found: dict[str, Floats] = {}
    for bone, joint in body.bones.items():
        if bone not in turns or bone not in PARENTS:
            continue
        upper = body.bones[next(above for above in _above(bone) if above in turns)]
        row = int(parent[joint])
        while row >= 0 and row != upper:
            row = int(parent[row])
        if row < 0:
            found[bone] = _freely(body, turns, places["Hips"], bone)
    return found

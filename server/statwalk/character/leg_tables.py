"""Builds the tables of the foot lock from a character's feet and their contacts in its clips."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from statwalk.character.body_bones import carrier
from statwalk.character.character import Character
from statwalk.character.feet import Foot
from statwalk.character.foot_contacts import ClipContacts, joined
from statwalk.character.foot_prints import (
    DECIMALS,
    Contacts,
    beside,
    foot_print,
    from_ankle,
    in_units,
    joints_below,
    landings,
    unit_of,
)
from statwalk.character.sole_points import sole_points
from statwalk.maths import transform, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.columns import locked
from statwalk.motion.blend_space import Motion
from statwalk.rig.evaluate import world_from_local
from statwalk.rig.model_buffer import JointList
from statwalk.solve.chains import POLE_DIRECTION, Chain
from statwalk.solve.foot_stretch import SOFTENING
from statwalk.solve.foot_tables import OF_ACTOR, OF_FOOT, SINCE, FootTables


def leg_chain(character: Character, foot: Foot) -> Chain:
    """Returns the two-bone chain of a leg: hip, knee, ankle."""
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    along = character.bind_pose.translation[foot.knee].astype(np.float64)
    x, y, z = np.cross(bend_of(character, foot), vector.unit(along)).tolist()
    softening = SOFTENING * foot.length(rest)
    return Chain(
        "two-bone", foot.leg, hinge=(x, y, z), softening=softening, pole_kind=POLE_DIRECTION, turns_end=True
    )


def foot_memory(feet: int) -> tuple[float, ...]:
    """Returns the numbers of a new actor in the memory of the foot lock."""
    foot = [0.0] * OF_FOOT
    foot[SINCE] = -1.0
    return (0.0,) * OF_ACTOR + tuple(foot) * feet


def has_leg(character: Character, foot: Foot) -> bool:
    """Returns whether a foot hangs on a hip by two bones, as the solver of legs needs it."""
    parent = character.skeleton.parent
    return min(foot.leg) >= 0 and parent[foot.ankle] == foot.knee and parent[foot.knee] == foot.hip


def leg_tables(
    character: Character,
    feet: Sequence[Foot],
    contacts: Mapping[str, ClipContacts],
    motions: Sequence[Motion | None],
    weight: tuple[float, int] = (1.0, -1),
    ground: NDArray[np.float64] | None = None,
    columns: tuple[int, int] = (0, -1),
) -> FootTables:
    """Returns the tables for feet with legs; `weight`: a number, and the parameter that replaces it or -1;
    `columns`: the first of the foot lock in the solvers' memory, and the first for uneven ground or -1.
    """
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    unit = unit_of([foot.length(rest) for foot in feet])
    soles = [sole_points(character, foot, rest, unit if columns[1] >= 0 else None) for foot in feet]
    pelvis = carrier(character.skeleton, [foot.hip for foot in feet])
    pelvis = -1 if pelvis is None else pelvis
    above = int(character.skeleton.parent[pelvis]) if pelvis >= 0 else -1
    wanted = {joint for foot in feet for joint in foot.leg} | {above} - {-1}
    carriers = np.concatenate([sole.carriers for sole in soles] or [np.zeros(0, np.int64)])
    joints = JointList.of(character.skeleton, sorted(wanted | set(carriers.tolist())))
    stands = _contacts(feet, contacts, motions)
    if columns[1] >= 0:
        stands = [(motion, foot, joined(spans) if motion.loop else spans) for motion, foot, spans in stands]
    spans = [span for _, _, span in stands]
    forward = [_ahead(foot, rest) for foot in feet]
    left = _rows([_left(foot, rest, way) for foot, way in zip(feet, forward, strict=True)])
    prints = [foot_print(foot, rest, way) for foot, way in zip(feet, forward, strict=True)]
    sizes = np.array(prints, np.float64).reshape(-1, 4)
    of_feet = list(zip(feet, forward, prints, strict=True))
    skins = [from_ankle(foot, rest, way, foot.skin.at(rest)) - size[:2] for foot, way, size in of_feet]
    on_print = [
        from_ankle(foot, rest, way, transform.apply(rest[sole.carriers], sole.places)) - size[:2]
        for (foot, way, size), sole in zip(of_feet, soles, strict=True)
    ]
    below = joints_below(character, feet, joints.joints)
    bends = [bend_of(character, foot) for foot in feet]
    return locked(
        FootTables(
            joints=joints.joints,
            parents=joints.parents,
            pelvis=np.array([pelvis], np.int32),
            above_pelvis=joints.places(np.array([above])).astype(np.int32),
            hip=joints.places(np.array([foot.hip for foot in feet], np.int64)).astype(np.int32),
            ankle=joints.places(np.array([foot.ankle for foot in feet], np.int64)).astype(np.int32),
            left=left,
            bend=_rows(bends),
            across=_rows([_across(foot, rest, bend) for foot, bend in zip(feet, bends, strict=True)]),
            length=np.array([foot.length(rest) for foot in feet], np.float64) / unit,
            unit=np.array([unit]),
            other=beside(rest, feet),
            first_point=_firsts([len(sole.places) for sole in soles]),
            lowest=np.array([sole.lowest for sole in soles], np.int32),
            spread=np.array([sole.spread for sole in soles], np.int32),
            carrier=joints.places(carriers).astype(np.int32),
            point=_rows([place for sole in soles for place in sole.places]),
            first_span=_firsts([len(row) for row in spans]),
            span=np.array([span for row in spans for span in row], np.float64).reshape(-1, 2),
            on_print=np.concatenate([np.zeros((0, 2)), *on_print]).round(DECIMALS) / unit,
            weight=np.array([weight[0]]),
            weight_parameter=np.array([weight[1]], np.int64),
            ground=np.zeros((0, 7)) if ground is None else in_units(ground, unit),
            memory=np.array(columns[:1], np.int64),
            fit=np.array(columns[1:], np.int64),
            print=sizes / unit,
            first_below=_firsts([len(rows) for rows in below]),
            below=np.concatenate([np.zeros(0, np.int64), *below]).astype(np.int32),
            landing=landings(character, feet, left, skins, stands if columns[1] >= 0 else ()),
        )
    )


def _rows(vectors: Sequence[Floats]) -> NDArray[np.float64]:
    return np.array(vectors, np.float64).reshape(-1, 3)


def _firsts(counts: Sequence[int]) -> NDArray[np.int32]:
    return np.concatenate([[0], np.cumsum(counts, dtype=np.int64)]).astype(np.int32)


def _ahead(foot: Foot, rest: Floats) -> Floats:
    """The horizontal direction from the ankle to the middle of the ball; forward if there is none."""
    points = foot.skin.at(rest)[foot.is_front] - rest[foot.ankle, :, 3]
    ahead = points.mean(0) * (1.0, 0.0, 1.0) if len(points) else np.zeros(3)
    length = float(vector.length(ahead))
    return ahead / length if length > 1e-6 else np.array([0.0, 0.0, 1.0])


def _left(foot: Foot, rest: Floats, ahead: Floats) -> Floats:
    """The horizontal direction to the left of the foot, in the frame of its ankle."""
    x, _, z = ahead
    return _local(rest, foot.ankle, np.array([z, 0.0, -x]))


def _across(foot: Foot, rest: Floats, bend: Floats) -> Floats:
    """The direction at right angles to the bend of a knee on the side of the thigh, in the hip's frame."""
    hip, knee, _ = foot.leg
    thigh = _local(rest, hip, rest[knee, :, 3] - rest[hip, :, 3])
    aside = thigh - float(vector.dot(thigh, bend)) * bend
    return aside / max(float(vector.length(aside)), 1e-12)


def _local(rest: Floats, joint: int, direction: Floats) -> Floats:
    """A direction in the frame of a joint."""
    local = _turned_back(rest[joint, :, :3], direction)
    return local / max(float(vector.length(local)), 1e-12)


def _turned_back(turn: Floats, directions: Floats) -> Floats:
    """Directions (…, 3) in the frames of turns (…, 3, 3), without a product of matrices: its last bits depend
    on the processor.
    """
    x, y, z = (turn[..., axis, :] * directions[..., axis, None] for axis in range(3))
    return x + y + z


def bend_of(character: Character, foot: Foot) -> Floats:
    """Returns the direction in which a knee bends, in the frame of the hip: its mean in the clips; where all
    hold the leg straight, the direction of the foot.
    """
    rest = world_from_local(character.skeleton, character.bind_pose).astype(np.float64)
    total = 1e-3 * _local(rest, foot.hip, _ahead(foot, rest))
    for clip in character.clips.values():
        world = world_from_local(character.skeleton, clip.sample(np.linspace(0, clip.duration, 16)))
        hip, knee, ankle = (world[:, joint, :, 3].astype(np.float64) for joint in foot.leg)
        onward = ankle - hip
        onward /= np.maximum(vector.length(onward)[..., None], 1e-9)
        bend = knee - hip
        bend -= vector.dot(bend, onward)[..., None] * onward
        total += _turned_back(world[:, foot.hip, :, :3].astype(np.float64), bend).sum(0)
    return total / float(vector.length(total))


def _contacts(
    feet: Sequence[Foot], contacts: Mapping[str, ClipContacts], motions: Sequence[Motion | None]
) -> list[Contacts]:
    """The contacts of each member of the motions and each foot; none where a clip walks on the spot, and its
    actor stays there.
    """
    found: list[Contacts] = []
    for motion in motions:
        for member in motion.members if motion is not None else ():
            known = contacts.get(member.clip.name)
            stays = known is None or (any(known.drift) and not any(member.ground_speed))
            of_foot = {} if known is None or stays else {foot.foot: foot.planted for foot in known.feet}
            found += [(member, number, of_foot.get(foot.name, ())) for number, foot in enumerate(feet)]
    return found

"""Retargets a clip: a motion captured from one body is carried over to another (KF8, FAQ Q18).

    clip, report = retarget(walk.clips["walk"], walk, knight)

Bones are found by their names (`body_bones`). Each turns from its rest as its counterpart does, after the
rest poses are brought into line; lengths follow the legs' lengths; the feet go where the captured feet go,
and the soles stay on the ground (`plant`). The clip begins at the origin and faces +Z.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from statwalk.character.body import Body
from statwalk.character.body_bones import BODY_BONES, NEEDED, SIDES, body_bones
from statwalk.character.carry import CapturedMotion, motion_of, rotations, to_world
from statwalk.character.character import Character
from statwalk.character.joint_keys import channels_of, travelling_joint
from statwalk.character.plant import CapturedPath, planted
from statwalk.errors import ContentError, UnknownNameError
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.motion.clip import Clip

MOST_JOINT_FRAMES = 4_000_000
GRID_RATE = 60.0
JUMP, TIMES_USUAL = 0.35, 8.0
"""radians between the first two frames, and how often the usual turn, that make the first a reference pose"""


@dataclass(frozen=True)
class Retargeted:
    """How a clip was carried over.

    bones             bone -> (the source's joint, the target's joint)
    missing           the bones of hips and legs that one of the two lacks: name their joints
    unmapped_source   the source's joints that move, and whose motion no joint takes
    unmapped_target   the target's joints that no motion reaches; they rest
    scale             the target's metres per unit of the source
    root              the joint that travels: `root:` of a machine file
    notes             what else was done
    """

    bones: Mapping[str, tuple[str, str]]
    missing: tuple[str, ...]
    unmapped_source: tuple[str, ...]
    unmapped_target: tuple[str, ...]
    scale: float
    root: str
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Wish:
    """What a user may say about retargeting.

    bones          bone -> the source's joint, "" for none, where the names do not tell
    target_bones   the same for the target
    start, end     seconds: the piece of the clip that is carried over; `end` None: to its end
    """

    bones: Mapping[str, str] | None = None
    target_bones: Mapping[str, str] | None = None
    start: float = 0.0
    end: float | None = None


def retarget(
    clip: Clip,
    source: Character,
    target: Character,
    *,
    bones: Mapping[str, str] | None = None,
    target_bones: Mapping[str, str] | None = None,
    start: float = 0.0,
    end: float | None = None,
) -> tuple[Clip, Retargeted]:
    """Returns the clip of `source` as a clip of `target`, and a report; the arguments are those of `Wish`.

    :raises ContentError: when the clip is not one of `source`, the two have too few bones in common, a bone
        or joint does not exist, or the clip is too long.
    """
    return retargeted(clip, source, target, Wish(bones, target_bones, start, end))


def retargeted(clip: Clip, source: Character, target: Character, wish: Wish) -> tuple[Clip, Retargeted]:
    """Returns the clip of `source` as a clip of `target`, and a report.

    :raises ContentError: as `retarget`.
    """
    joints = clip.rest.rotation.shape[-2]
    if joints != len(source.skeleton):
        raise ContentError(
            f"the clip {clip.name} moves {joints} joints, and its source {source.name} has "
            f"{len(source.skeleton)}: give the character whose clip it is"
        )
    ours = Body.of(source, _bones(source, wish.bones, "bones"))
    theirs = Body.of(target, _bones(target, wish.target_bones, "target_bones"))
    common = [bone for bone in BODY_BONES if bone in ours.bones and bone in theirs.bones]
    _check(common, ours, theirs)
    times, notes = _times(clip, ours, wish)
    motion = motion_of(ours, clip.sample(times), times - times[0])
    world = to_world(ours, theirs, motion)
    turns = rotations(ours, theirs, motion, world)
    path, scale = _path(ours, theirs, motion, world)
    keys = planted(theirs, turns, path)
    channels = channels_of(theirs, keys, motion.times)
    carried = Clip(clip.name, channels, float(np.float32(motion.times[-1])), target.bind_pose)
    root = target.skeleton.names[travelling_joint(theirs, keys)]
    return carried, _report(ours, theirs, turns, clip, (scale, root, notes))


def _bones(character: Character, chosen: Mapping[str, str] | None, key: str) -> dict[str, int]:
    try:
        return body_bones(character.skeleton, chosen)
    except (ContentError, UnknownNameError) as error:
        raise ContentError(getattr(error, "message", str(error)), place=key) from None


def _check(common: list[str], source: Body, target: Body) -> None:
    if "Hips" in common and len(common) > 2:
        return
    for body, key in ((source, "bones"), (target, "target_bones")):
        missing = [bone for bone in NEEDED if bone not in body.bones]
        if missing:
            raise ContentError(
                f"the names of {body.character.name[:60]!r} do not tell {', '.join(missing)}; "
                f"name them: {key}: {{{missing[0]}: JOINT}}",
                place=key,
            )
    raise ContentError("the two skeletons have no bones in common besides the hips")


def _times(clip: Clip, body: Body, wish: Wish) -> tuple[Floats, tuple[str, ...]]:
    """Returns the times (F,) at which the clip is carried over, and notes."""
    end = clip.duration if wish.end is None else min(wish.end, clip.duration)
    if not 0 <= wish.start <= end:
        raise ContentError(
            f"the clip lasts {clip.duration:g} s; start and end must lie within, start first", place="start"
        )
    own = {channel.times.tobytes(): channel.times for channel in clip.channels}
    even = np.arange(0, np.floor(clip.duration * GRID_RATE) + 1) / GRID_RATE
    times = next(iter(own.values())) if len(own) == 1 else even
    times = np.asarray(times, np.float64)
    kept = times[(times >= wish.start - 1e-9) & (times <= end + 1e-9)]
    kept = kept if len(kept) else np.array([wish.start])
    if len(kept) * len(body.character.skeleton) > MOST_JOINT_FRAMES:
        raise ContentError(
            f"{len(kept)} frames of {len(body.character.skeleton)} joints are too many at once; choose "
            "a piece with start and end",
            place="end",
        )
    if wish.start == 0 and _begins_with_reference(clip, body, kept):
        return kept[1:], ("the first frame is a reference pose, far from the second; it is left out",)
    return kept, ()


def _begins_with_reference(clip: Clip, body: Body, times: Floats) -> bool:
    """Returns whether the pose jumps between the first two frames, and nowhere near so far afterwards."""
    if len(times) < 4:
        return False
    joints = list(body.bones.values())
    turns = clip.sample(times[:60]).rotation[:, joints].astype(np.float64)
    angles = 2 * np.arccos(np.clip(np.abs(quat.dot(turns[1:], turns[:-1])), 0, 1)).max(-1)
    return bool(angles[0] > JUMP and angles[0] > TIMES_USUAL * angles[1:].max())


def _path(source: Body, target: Body, motion: CapturedMotion, world: Floats) -> tuple[CapturedPath, float]:
    """Returns the places of hips and ankles in the target's space before they are planted, and the scale."""
    ours, theirs = source.leg(), target.leg()
    scale = theirs / ours if ours > 0 and theirs > 0 else _height(target) / _height(source)
    first = motion.places["Hips"][0]

    def placed(bone: str) -> Floats:
        """Relative to the ground point below the first frame's hips."""
        turned = quat.rotate(world, motion.places[bone])
        start = quat.rotate(world, first) * np.array([1.0, 0.0, 1.0])
        place: Floats = (turned - start) * scale
        return place

    feet = {f"{side}Foot": placed(f"{side}Foot") for side in SIDES if f"{side}Foot" in source.bones}
    toes = {f"{side}Foot": placed(f"{side}Toes") for side in SIDES if f"{side}Toes" in source.bones}
    return CapturedPath(placed("Hips"), feet, toes, _drop(source, source.up) * scale, motion.times), scale


def _height(body: Body) -> float:
    """Returns how far the joints reach up the body at rest."""
    heights = body.position @ body.up
    return float(np.ptp(heights)) or 1.0


def _drop(body: Body, up: Floats) -> float:
    """Returns how far the hip joints are below the hips at rest."""
    legs = [bone for bone in ("LeftUpperLeg", "RightUpperLeg") if bone in body.bones]
    return float(np.mean([(body.at("Hips") - body.at(bone)) @ up for bone in legs])) if legs else 0.0


def _report(
    source: Body,
    target: Body,
    turns: Mapping[str, Floats],
    clip: Clip,
    facts: tuple[float, str, tuple[str, ...]],
) -> Retargeted:
    ours, theirs = source.character.skeleton.names, target.character.skeleton.names
    bones = {
        bone: (ours[source.bones[bone]] if bone in source.bones else "(the spine as a whole)", theirs[joint])
        for bone, joint in target.bones.items()
        if bone in turns
    }
    moving = {channel.joint for channel in clip.channels if channel.path == "rotation"}
    used = {
        joint for bone, joint in source.bones.items() if bone in turns or bone.endswith(("Spine", "Chest"))
    }
    taken = {target.bones[bone] for bone in turns}
    return Retargeted(
        bones,
        tuple(bone for bone in NEEDED if bone not in source.bones or bone not in target.bones),
        tuple(ours[joint] for joint in sorted(moving - used)),
        tuple(name for joint, name in enumerate(theirs) if joint not in taken),
        *facts,
    )

"""Solves the tracks of optical markers to the bones of a body (KF8; FAQ Q18 and Q26).

Markers show points of the body. Rule 8 turns each bone from its parent towards the point at its end; where a knee
or an elbow was not seen, rule 12 places it between the points that were. Rest is the T-pose: arms along ±X, feet
along +Z, lengths the medians of the whole capture.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.body_bones import SIDES
from statwalk.character.marker_names import point_of
from statwalk.errors import TextError
from statwalk.maths import pose as poses
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.filters import continuous
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Channel, Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.rules import find_matrix, joint_between

X, Y, Z = np.eye(3)


class Segment(NamedTuple):
    """A bone between two points of the body, along `direction` at rest."""

    bone: str
    parent: str
    start: str
    end: str
    direction: tuple[float, float, float]


def _limbs(side: str, left: float) -> tuple[Segment, ...]:
    return (
        Segment(side + "UpperLeg", "Hips", side + "UpperLeg", side + "LowerLeg", (0, -1, 0)),
        Segment(side + "LowerLeg", side + "UpperLeg", side + "LowerLeg", side + "Foot", (0, -1, 0)),
        Segment(side + "Foot", side + "LowerLeg", side + "Foot", side + "Toes", (0, 0, 1)),
        Segment(side + "UpperArm", "Spine", side + "UpperArm", side + "LowerArm", (left, 0, 0)),
        Segment(side + "LowerArm", side + "UpperArm", side + "LowerArm", side + "Hand", (left, 0, 0)),
        Segment(side + "Hand", side + "LowerArm", side + "Hand", side + "HandEnd", (left, 0, 0)),
    )


SEGMENTS = (
    Segment("Head", "Spine", "Neck", "Head", (0, 1, 0)),
    *_limbs("Left", 1),
    *_limbs("Right", -1),
)
_ENDS = {side + bone: side + end for side in SIDES for bone, end in (("Foot", "Toes"), ("LowerArm", "Hand"))}
"""the joint at the end of a bone that carries no other"""
_HINGES = {"LowerLeg": ("UpperLeg", "Foot", 1.0), "LowerArm": ("UpperArm", "Hand", -1.0)}
"""joints that rule 12 finds: the joints above and below, and whether they bend forward or back"""


class SolvedBody(NamedTuple):
    """A body made of markers, its clip, and what is to be said about the markers."""

    skeleton: Skeleton
    rest: Pose
    clip: Clip
    notes: tuple[str, ...]


def solve_markers(names: Sequence[str], times: Floats, places: Floats, name: str) -> SolvedBody:
    """Returns the body that markers (F, M, 3) show, NaN where one was lost, as a clip at `times` (F,).

    The file's vertical may be Y or Z; the result's is Y.

    :raises TextError: when the names tell no hips and no limb.
    """
    points, notes = _points(names, places)
    points = _upright(_with_pelvis(points))
    points, found = _with_hinges(points)
    points = {point: _without_gaps(track) for point, track in points.items()}
    segments = [segment for segment in SEGMENTS if segment.start in points and segment.end in points]
    if "Pelvis" not in points or not segments:
        known = ", ".join(sorted({str(point_of(marker)) for marker in names} - {"None"})) or "nothing"
        raise TextError(
            f"the markers' names tell {known}; a body needs a pelvis (LASI, RASI, LPSI, RPSI or Hips) and a limb "
            "(LKNE and LANK, LKnee and LAnkle, …)"
        )
    frames = _trunk(points)
    matrices = _turned(points, segments, frames)
    skeleton, rest = _skeleton(points, segments)
    clip = _clip(name, skeleton, times, matrices, points["Pelvis"], rest)
    return SolvedBody(skeleton, rest, clip, (*notes, *found))


def _points(names: Sequence[str], places: Floats) -> tuple[dict[str, Floats], tuple[str, ...]]:
    """Returns the mean track (F, 3) of the markers that show each point, and notes about the others."""
    rows: dict[str, list[int]] = {}
    unknown: list[str] = []
    for row, marker in enumerate(names):
        point = point_of(marker)
        if point is None:
            unknown.append(marker)
        else:
            rows.setdefault(point, []).append(row)
    points: dict[str, Floats] = {}
    for point, markers in rows.items():
        seen = np.isfinite(places[:, markers]).all((1, 2))
        if seen.any():
            points[point] = np.where(seen[:, None], places[:, markers].mean(1), np.nan)
    notes = (f"markers that show no joint are left out: {', '.join(unknown[:20])}",) if unknown else ()
    if "Pelvis" in points:
        points |= _hip_joints(names, places, points)
    return points, notes


def _hip_joints(names: Sequence[str], places: Floats, points: Mapping[str, Floats]) -> dict[str, Floats]:
    """Returns the hip joints, where no marker shows them: from the front of the pelvis a fifth of its width
    inwards and back and three tenths down (after Bell, Brand and Pedersen 1989).
    """
    row_of = {marker.split(":")[-1].upper().replace(".", ""): row for row, marker in enumerate(names)}
    rows = [
        next((row_of[name] for name in names if name in row_of), None)
        for names in (("LASI", "LASIS"), ("RASI", "RASIS"))
    ]
    if "LeftUpperLeg" in points or rows[0] is None or rows[1] is None:
        return {}
    left, right = places[:, rows[0]], places[:, rows[1]]
    width = vector.length(left - right)[:, None]
    across = (left - right) / np.where(width > 0, width, 1)
    down = _downwards(points)
    back = vector.cross(across, down)
    inner = width * (-0.3 * -down - 0.19 * -back)
    return {
        "LeftUpperLeg": left - across * width * 0.14 + inner,
        "RightUpperLeg": right + across * width * 0.14 + inner,
    }


def _downwards(points: Mapping[str, Floats]) -> Floats:
    """Returns the unit vector (3,) from the pelvis to the feet on average, along an axis of the file."""
    low = [
        points[side + bone]
        for side in ("Left", "Right")
        for bone in ("Foot", "LowerLeg")
        if side + bone in points
    ]
    ways = [np.nanmean(track - points["Pelvis"], 0) for track in low] or [np.array([0.0, -1.0, 0.0])]
    way = np.mean(ways, 0)
    axis = np.zeros(3)
    row = 2 if abs(way[2]) > abs(way[1]) else 1
    axis[row] = np.sign(way[row]) or -1.0
    return axis


def _with_pelvis(points: dict[str, Floats]) -> dict[str, Floats]:
    """Returns the points with a pelvis between the hip joints, and a neck between the shoulders."""
    made = dict(points)
    for point, bone in (("Pelvis", "UpperLeg"), ("Neck", "UpperArm")):
        pair = [points[side + bone] for side in ("Left", "Right") if side + bone in points]
        if point not in made and len(pair) == 2:
            made[point] = (pair[0] + pair[1]) / 2
    return made


def _upright(points: dict[str, Floats]) -> dict[str, Floats]:
    """Returns the points turned so that +Y is up."""
    if "Pelvis" not in points:
        return points
    turn = quat.between(-_downwards(points), Y)
    return {point: quat.rotate(turn, track) for point, track in points.items()}


def _with_hinges(points: dict[str, Floats]) -> tuple[dict[str, Floats], tuple[str, ...]]:
    """Returns the points with the knees and elbows that no marker showed, by rule 12, and notes."""
    made, notes = dict(points), []
    if not {"LeftUpperLeg", "RightUpperLeg"} <= points.keys():
        return made, ()
    across = points["LeftUpperLeg"] - points["RightUpperLeg"]
    forward = vector.unit(vector.cross(across, np.broadcast_to(Y, across.shape)))
    for side in ("Left", "Right"):
        for bone, (upper, lower, way) in _HINGES.items():
            above, below = points.get(side + upper), points.get(side + lower)
            if above is None or below is None:
                continue
            seen = points.get(side + bone, np.full_like(above, np.nan))
            lost = ~np.isfinite(seen).all(-1)
            if lost.any():
                lengths = _lengths(above, seen, below)
                placed = joint_between(above, lengths[0], below, lengths[1], forward * way).point
                made[side + bone] = np.where(lost[:, None], placed, seen)
                notes.append(f"{side}{bone} was not seen in {int(lost.sum())} frames; rule 12 placed it")
    return made, tuple(notes)


def _lengths(above: Floats, seen: Floats, below: Floats) -> tuple[Floats, Floats]:
    """Returns the lengths (F,) of the bones on both sides of a joint: as seen, else half of the furthest reach."""
    if np.isfinite(seen).all(-1).any():
        upper, lower = np.nanmedian(vector.length(seen - above)), np.nanmedian(vector.length(below - seen))
    else:
        upper = lower = np.nanmax(vector.length(below - above)) / 2 * 1.0001
    return np.full(len(above), upper), np.full(len(above), lower)


def _without_gaps(track: Floats) -> Floats:
    """Returns a track (F, 3) with straight lines over its gaps; the ends hold."""
    seen = np.flatnonzero(np.isfinite(track).all(-1))
    if len(seen) == len(track):
        return track
    rows = np.arange(len(track))
    return np.stack([np.interp(rows, seen, column[seen]) for column in track.T], -1)


def _trunk(points: Mapping[str, Floats]) -> dict[str, Floats]:
    """Returns the matrices (F, 3, 3) of hips and spine: up from the pelvis to the neck, left as the legs and as the
    shoulders are.
    """
    pelvis = points["Pelvis"]
    up = points["Neck"] - pelvis if "Neck" in points else np.broadcast_to(Y, pelvis.shape)

    def across(bone: str, fallback: Floats) -> Floats:
        pair = [points[side + bone] for side in ("Left", "Right") if side + bone in points]
        return pair[0] - pair[1] if len(pair) == 2 else fallback

    legs = across("UpperLeg", np.broadcast_to(X, pelvis.shape))
    spine = _frame(across("UpperArm", legs), up, keep_up=True)
    return {"Hips": _frame(legs, up, keep_up=False), "Spine": spine}


def _frame(left: Floats, up: Floats, keep_up: bool) -> Floats:
    forward = vector.unit(vector.cross(left, up))
    x, y = (vector.cross(vector.unit(up), forward), vector.unit(up)) if keep_up else (vector.unit(left), None)
    y = vector.cross(forward, x) if y is None else y
    return np.stack([x, y, forward], -1)


def _turned(
    points: Mapping[str, Floats], segments: Sequence[Segment], matrices: dict[str, Floats]
) -> dict[str, Floats]:
    """Returns the matrices (F, 3, 3) of all bones, by rule 8 from each parent's."""
    found = dict(matrices)
    for segment in segments:
        parent = found[segment.parent if segment.parent in found else "Hips"]
        direction = np.broadcast_to(np.array(segment.direction, np.float64), points[segment.start].shape)
        found[segment.bone] = find_matrix(parent, direction, points[segment.end] - points[segment.start])
    return found


def _skeleton(points: Mapping[str, Floats], segments: Sequence[Segment]) -> tuple[Skeleton, Pose]:
    """Returns the bones as joints with their places at rest; a bone that carries no other has an end joint."""
    names, parents, offsets = ["Hips", "Spine"], [-1, 0], [np.zeros(3), np.zeros(3)]
    hips_height = _length(points, "Pelvis", "Neck") if "Neck" in points else 0.5
    place: dict[str, int] = {"Hips": 0, "Spine": 1}
    at = {"Pelvis": np.zeros(3), "Neck": Y * hips_height}
    for segment in segments:
        if segment.start not in at:
            side = 1.0 if segment.start.startswith("Left") else -1.0
            base = at["Neck"] if segment.parent == "Spine" else at["Pelvis"]
            other = (
                segment.start.replace("Left", "Right") if side > 0 else segment.start.replace("Right", "Left")
            )
            apart = _length(points, segment.start, other) / 2 if other in points else 0.0
            at[segment.start] = base + X * side * apart
        start = at[segment.start]
        at[segment.end] = start + np.array(segment.direction) * _length(points, segment.start, segment.end)
        parent = place.get(segment.parent, 0)
        above = segments[[one.bone for one in segments].index(segment.parent)] if parent > 1 else None
        base = at[above.start] if above else np.zeros(3)
        place[segment.bone] = len(names)
        names.append(segment.bone)
        parents.append(parent)
        offsets.append(start - base)
    carrying = {segment.parent for segment in segments}
    for segment in segments:
        if segment.bone not in carrying:
            names.append(_ENDS.get(segment.bone, f"{segment.bone}.end"))
            parents.append(place[segment.bone])
            offsets.append(at[segment.end] - at[segment.start])
    rest = poses.rest(len(names))
    rest.translation[:] = np.array(offsets)
    return Skeleton(tuple(names), np.array(parents, np.int32)), rest


def _length(points: Mapping[str, Floats], start: str, end: str) -> float:
    return float(np.median(vector.length(points[end] - points[start])))


def _clip(
    name: str, skeleton: Skeleton, times: Floats, matrices: Mapping[str, Floats], pelvis: Floats, rest: Pose
) -> Clip:
    """Returns the turns of the bones relative to their parents, and the way of the hips, as keys."""
    keys = times.astype(np.float32)
    channels = [Channel(0, "translation", keys, pelvis.astype(np.float32))]
    world = {bone: quat.from_matrix(matrix) for bone, matrix in matrices.items()}
    for joint, (bone, parent) in enumerate(zip(skeleton.names, skeleton.parent.tolist(), strict=True)):
        if bone in world:
            above = world[skeleton.names[parent]] if parent >= 0 else quat.IDENTITY
            local = continuous(quat.mul(quat.conjugate(above), world[bone]))
            channels.append(Channel(joint, "rotation", keys, local.astype(np.float32)))
    return Clip(name, tuple(channels), float(keys[-1]), rest)

"""Solves the tracks of optical markers to the bones of a body (KF8; FAQ Q18 and Q26).

Markers show points of the body. Rule 8 turns each bone from its parent towards the point at its end; where a
knee or an elbow was not seen, rule 12 places it between the points that were. Rest is the T-pose: arms along
±X, feet along +Z, lengths the medians of the whole capture.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from statwalk.character.marker_body import SEGMENTS, clip_of, skeleton_of, trunk, turned
from statwalk.character.marker_names import plain_name, points_of
from statwalk.errors import TextError
from statwalk.maths import quat, vector
from statwalk.maths.arrays import Floats
from statwalk.maths.pose import Pose
from statwalk.motion.clip import Clip
from statwalk.rig.skeleton import Skeleton
from statwalk.solve.rules import joint_between

Y = np.array([0.0, 1.0, 0.0])


FRONT_OF_PELVIS = tuple(
    (f"{side}ASI", f"{side}ASIS", f"{side}FWT", f"{side}IAS", f"WAIST{side}FRONT", f"{word}ASIS")
    for side, word in (("L", "LEFT"), ("R", "RIGHT"))
)
"""the markers on the left and the right front of the pelvis (ASIS), of which a set has one pair"""
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
        known = ", ".join(sorted({point for point in points_of(names) if point})) or "nothing"
        raise TextError(
            f"the markers' names tell {known}; a body needs a pelvis (LASI, RASI or Hips) and a limb "
            "(LKNE and LANK, LKnee and LAnkle, …)"
        )
    frames = trunk(points)
    matrices = turned(points, segments, frames)
    skeleton, rest = skeleton_of(points, segments)
    clip = clip_of(name, skeleton, times, matrices, points["Pelvis"], rest)
    return SolvedBody(skeleton, rest, clip, (*notes, *found))


def _points(names: Sequence[str], places: Floats) -> tuple[dict[str, Floats], tuple[str, ...]]:
    """Returns the mean track (F, 3) of the markers that show each point, and notes about the others."""
    rows: dict[str, list[int]] = {}
    unknown: list[str] = []
    for row, (marker, point) in enumerate(zip(names, points_of(names), strict=True)):
        if point is None:
            unknown.append(marker)
        else:
            rows.setdefault(point, []).append(row)
    points: dict[str, Floats] = {}
    for point, markers in rows.items():
        seen = np.isfinite(places[:, markers].sum((1, 2)))
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
    row_of = {_letters(marker): row for row, marker in enumerate(names)}
    rows = [next((row_of[name] for name in names if name in row_of), None) for names in FRONT_OF_PELVIS]
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


def _letters(marker: str) -> str:
    return "".join(letter for letter in plain_name(marker).upper() if letter.isalnum())


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
            lost = ~np.isfinite(seen.sum(-1))
            if lost.any():
                lengths = _lengths(above, seen, below)
                placed = joint_between(above, lengths[0], below, lengths[1], forward * way).point
                made[side + bone] = np.where(lost[:, None], placed, seen)
                notes.append(f"{side}{bone} was not seen in {int(lost.sum())} frames; rule 12 placed it")
    return made, tuple(notes)


def _lengths(above: Floats, seen: Floats, below: Floats) -> tuple[Floats, Floats]:
    """Returns the lengths (F,) of the bones on both sides of a joint: as seen, else half of the furthest
    reach.
    """
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

"""Which point of the body an optical marker shows: the names of Plug-in Gait, Helen Hayes, CMU, OpenSim and
OpenCap, the Human Body Model, CAST and Qualisys' and OptiTrack's own sets; of joint centres (OpenPose, HALPE,
Pose2Sim, Theia); and of the joints of skeletons.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from statwalk.character.body_bones import SIDES, words_of

_SIDED = {
    "UpperLeg": "hjc hip upperleg upleg hipjoint",
    "LowerLeg": "kne knee kjc mkne mknee knm lkne lowerleg lfc mfc fle fme lek mek kneelateral kneemedial",
    "Foot": "ank ankle ajc mank mankle anm med lm mm lmal mmal fal tam malleolus foot",
    "Toes": "toe toes bigtoe smalltoe toetip mt mth mtp meta hlx fm forefoot footindex toebase ball smh",
    "UpperArm": "sho shoulder sjc acromium acromion acr sae",
    "LowerArm": "elb elbow ejc melb melbow lelbow lel mel lee mee hle hme",
    "Hand": "wra wrb wrist wjc lwrist mwrist lw mw wristrad wristuln rsp usp faradius faulna hand wri",
    "HandEnd": "fin finger handend hm",
    "Pelvis": "asi psi asis psis ias ips fwt bwt waist",
    "Head": "fhd bhd ear head",
}
_SEGMENTS = {
    "UpperLeg": "thigh",
    "LowerLeg": "leg shin calf",
    "UpperArm": "upperarm arm",
    "LowerArm": "lowerarm forearm",
}
"""a joint in skeletons; in a set with a marker of the knee or elbow a place in the middle of the segment"""
_HINGE = {"UpperLeg": "LowerLeg", "LowerLeg": "LowerLeg", "UpperArm": "LowerArm", "LowerArm": "LowerArm"}
_MIDDLE = {
    "Pelvis": "hips hip pelvis midhip chip sacr vsacral sacral sacrum root waist waistback",
    "Neck": "neck clav sternum strn jn sjn thorax spinetop",
    "Head": "head nose tophead headtop headfront fronthead rearhead thead fhead arie ariel",
}
_WHOLE = {"C7": "Neck", "CV7": "Neck"}
_QUALIFIERS = frozenset(
    ("lat", "med", "lateral", "medial", "out", "in", "outer", "inner", "front", "back", "top", "tip")
)
"""words that say on which side of a joint its marker is"""
_LETTERS = {"L": "Left", "R": "Right"}


def _by_word(words: dict[str, str], side: str) -> dict[str, str]:
    apart = ("Pelvis", "Head")
    return {
        word: point if not side or point in apart else side + point
        for point, names in words.items()
        for word in names.split()
    }


_BY_WORD = {"": _by_word(_MIDDLE, "")} | {side: _by_word(_SIDED, side) for side in SIDES}
_SEGMENT_BY_WORD = {side: _by_word(_SEGMENTS, side) for side in SIDES}


def plain_name(marker: str) -> str:
    """Returns a marker's name without the prefixes of its file: `subject:LASI`, `Q_WaistLFront`."""
    return marker.split(":")[-1].removeprefix("Q_")


def points_of(markers: Sequence[str]) -> list[str | None]:
    """Returns the point that each marker of a set shows (`LeftLowerLeg`: the knee), None for other markers.

    `LThigh` is the hip of a skeleton; beside a marker of the knee it is a place on the thigh, and no joint.
    """
    named = [_found(marker, _BY_WORD) for marker in markers]
    found = list(named)
    for row, marker in enumerate(markers):
        point = None if named[row] else _found(marker, _SEGMENT_BY_WORD)
        if point and _hinge_of(point) not in named:
            # a skeleton: its `LeftShoulder` is the collar bone, and `LeftArm` begins at the shoulder
            found = [None if other == named[at] == point else other for at, other in enumerate(found)]
            found[row] = point
    return found


def _hinge_of(point: str) -> str:
    side = next(side for side in SIDES if point.startswith(side))
    return side + _HINGE[point.removeprefix(side)]


def _found(marker: str, by_word: Mapping[str, Mapping[str, str]]) -> str | None:
    name = plain_name(marker)
    if by_word is _BY_WORD and name.upper() in _WHOLE:
        return _WHOLE[name.upper()]
    side, words = words_of(name)
    plain = [word for word in words if not word.isdecimal()]
    for form in (plain, [word for word in plain if word not in _QUALIFIERS]):
        word = "".join(form)
        point = by_word.get(side, {}).get(word)
        if point is None and not side and name[:1].upper() in _LETTERS:  # LKNE: the side is its first letter
            point = by_word[_LETTERS[name[0].upper()]].get(word[1:])
        if point is not None:
            return point
    return None

"""Which point of the body an optical marker shows: the names of Plug-in Gait, OpenSim, Helen Hayes, of joint
centres (OpenPose, Pose2Sim, Theia), and of the joints of skeletons.
"""

from __future__ import annotations

from statwalk.character.body_bones import SIDES, words_of

_SIDED = {
    "UpperLeg": "hjc hip upperleg upleg thigh hipjoint",
    "LowerLeg": "kne knee kjc mkne knm kneelat kneemed lowerleg leg shin calf",
    "Foot": "ank ankle ajc mank anm med anklelat anklemed foot",
    "Toes": "toe toes bigtoe toetip mt mtp toebase ball",
    "UpperArm": "sho shoulder sjc acromium acromion upperarm arm",
    "LowerArm": "elb elbow ejc melb elbowlat elbowmed elblat lowerarm forearm",
    "Hand": "wra wrb wrist wjc wristrad wristuln hand wri",
    "HandEnd": "fin finger handend",
    "Pelvis": "asi psi asis psis",
    "Head": "fhd bhd ear",
}
_MIDDLE = {
    "Pelvis": "hips hip pelvis midhip chip sacr vsacral sacrum root",
    "Neck": "neck c clav sternum strn jn thorax",
    "Head": "head nose tophead headtop arie",
}
_BY_WORD = {"": {word: point for point, words in _MIDDLE.items() for word in words.split()}} | {
    side: {
        word: point if point in ("Pelvis", "Head") else side + point
        for point, words in _SIDED.items()
        for word in words.split()
    }
    for side in SIDES
}
_LETTERS = {"L": "Left", "R": "Right"}


def point_of(marker: str) -> str | None:
    """Returns the point that a marker shows (`LeftLowerLeg`: the knee), None for other markers."""
    name = marker.split(":")[-1]
    side, words = words_of(name)
    plain = "".join(word for word in words if not word.isdecimal())
    found = _BY_WORD[side].get(plain)
    if found is None and not side and name[:1].upper() in _LETTERS:  # LKNE: the side is a letter of the word
        found = _BY_WORD[_LETTERS[name[0].upper()]].get(plain[1:])
    return found

"""The bones that bodies have in common, found by the names that Mixamo, VRM, Unreal, Rigify, CMU, KayKit,
Quaternius, Biped, OptiTrack, Poser and the FAQ give them.

Hips and spine are found by their place: the hips carry both legs, the spine leads from there to the arms.
Names like `Hips` and `Body` mean another joint in every rig.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

import numpy as np

from statwalk.errors import ContentError, UnknownNameError
from statwalk.rig.skeleton import Skeleton

SIDES = ("Left", "Right")
_LIMBS = {  # in the order in which names are taken: a `shoulder` is the upper arm where no other joint is
    "UpperLeg": "upperleg upleg thigh hip legupper femur",
    "LowerLeg": "lowerleg lowleg shin calf knee leglower tibia leg",
    "Foot": "foot ankle",
    "Toes": "toes toe toebase ball toe0 toe1 football",
    "UpperArm": "upperarm uparm uarm armupper shldr humerus arm shoulder",
    "LowerArm": "lowerarm lowarm forearm farm armlower elbow radius",
    "Hand": "wrist hand palm palm2 fist handbase",
    "Shoulder": "clavicle collar shoulder",
}
_LIMB_WORDS = frozenset(" ".join(_LIMBS.values()).split())
_CHAINED = ("LowerLeg", "Foot", "Toes", "LowerArm", "Hand")
"""bones that hang on their parent; in some rigs only the feet do not"""
_FINGERS = {"Thumb": "thumb", "Index": "index", "Middle": "middle", "Ring": "ring", "Little": "pinky little"}
_SEGMENTS = {"": 1, "proximal": 1, "intermediate": 2, "distal": 3}
_THUMB_OF_VRM_1 = {"metacarpal": 1, "proximal": 2, "distal": 3}
_MIDDLE = {
    "Hips": "hips hip pelvis cog",
    "Head": "head spine006 spine6",
    "Neck": "neck neck1 neck01 lowerneck spine004",
}
_SIDE_WORDS = {"l": "Left", "left": "Left", "r": "Right", "right": "Right"}
_PREFIXES = ("mixamorig", "def", "org", "bip", "bip01", "bip001", "jbip", "j", "valvebiped", "b", "c")
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|[0-9]+")

SPINE = ("Spine", "Chest", "UpperChest")
PARENTS = {"Neck": "Hips", "Head": "Hips"} | {
    side + bone: parent if parent == "Hips" else side + parent
    for side in SIDES
    for bone, parent in {
        "UpperLeg": "Hips",
        "LowerLeg": "UpperLeg",
        "Foot": "LowerLeg",
        "Toes": "Foot",
        "Shoulder": "Hips",
        "UpperArm": "Shoulder",
        "LowerArm": "UpperArm",
        "Hand": "LowerArm",
    }.items()
}
"""the bone on which a bone hangs"""
FINGERS = tuple(f"{side}{finger}{number}" for side in SIDES for finger in _FINGERS for number in (1, 2, 3))
BODY_BONES = ("Hips", *SPINE, *PARENTS, *FINGERS)
"""all names that a mapping may use"""
NEEDED = ("Hips", *(side + bone for side in SIDES for bone in ("UpperLeg", "LowerLeg", "Foot")))
"""without them no walk is carried over: the page asks for these first"""


def body_bones(skeleton: Skeleton, chosen: Mapping[str, str] | None = None) -> dict[str, int]:
    """Returns the joint of each bone that the names of a skeleton tell; `chosen` (bone -> joint's name, ""
    for none) comes first.

    :raises ContentError: when a bone has no such name.
    :raises UnknownNameError: when the skeleton has no joint of a name.
    """
    found = _by_name(skeleton)
    _find_hips(skeleton, found)
    spine = _spine(skeleton, found)
    if found.get("Neck") in spine.values():  # `spine.004` is Rigify's neck, and the back of others
        del found["Neck"]
    found |= spine
    for bone, joint in (chosen or {}).items():
        if bone not in BODY_BONES:
            raise ContentError(str(UnknownNameError("bone", bone, BODY_BONES)))
        found.pop(bone, None)
        if joint:
            found[bone] = skeleton.index(joint)
    return {bone: found[bone] for bone in BODY_BONES if bone in found}


def words_of(name: str) -> tuple[str, list[str]]:
    """Returns the side that a joint's name tells ("" for none) and its other words, in lower case, without
    the prefixes that tools add: `mixamorig:LeftUpLeg` is Left, up, leg.
    """
    words = [word.lower() for word in _WORD.findall(re.split(r"[:|]", name)[-1])]
    sides = [word for word in words if word in _SIDE_WORDS]
    rest = [word for word in words if word not in _SIDE_WORDS]
    while len(rest) > 1 and ("".join(rest[:1]) in _PREFIXES or (rest[0].isdecimal() and rest[1:])):
        rest = rest[1:]
    return _SIDE_WORDS[sides[0]] if len(set(sides)) == 1 else "", rest


def _side_and_name(name: str) -> tuple[str, str]:
    """Returns the side and the other words of a joint's name, as one; CMU's `lfemur` begins with its side."""
    side, words = words_of(name)
    plain = "".join(words)
    if not side and plain[:1] in ("l", "r") and plain[1:] in _LIMB_WORDS:
        return _SIDE_WORDS[plain[0]], plain[1:]
    return side, plain


def _by_name(skeleton: Skeleton) -> dict[str, int]:
    """Returns the joints that have one of the known names, the better-known name first."""
    named: dict[tuple[str, str], int] = {}
    for joint, name in enumerate(skeleton.names):
        if name not in skeleton.muscle_bones:
            named.setdefault(_side_and_name(name), joint)
    found: dict[str, int] = {}
    taken: set[int] = set()

    wanted = [("", bone, names) for bone, names in _MIDDLE.items()]
    wanted += [(side, bone, names) for side in SIDES for bone, names in _LIMBS.items()]
    for side, bone, names in wanted:
        joints = [named[side, name] for name in names.split() if (side, name) in named]
        parent = found.get(PARENTS.get(side + bone, "")) if bone in _CHAINED else None
        carried = [joint for joint in joints if parent is None or parent in ancestors(skeleton, joint)[1:]]
        free = [joint for joint in (carried or joints if bone == "Foot" else carried) if joint not in taken]
        if free:
            found[side + bone] = free[0]
            taken.add(free[0])
    for side in SIDES:  # a leg of one joint is a thigh
        if {side + "UpperLeg", side + "Foot"}.isdisjoint(found) and side + "LowerLeg" in found:
            found[side + "UpperLeg"] = found.pop(side + "LowerLeg")
    return found | _fingers(named)


def _fingers(named: Mapping[tuple[str, str], int]) -> dict[str, int]:
    """Returns the joints of fingers: `LeftHandIndex1`, `index_01_l`, `Index2.L`, `leftIndexProximal`."""
    found: dict[str, int] = {}
    for (side, name), joint in named.items():
        has_metacarpal = name.startswith("thumb") and (side, "thumbmetacarpal") in named
        segments = _THUMB_OF_VRM_1 if has_metacarpal else _SEGMENTS
        match = re.fullmatch(r"(?:hand|f)?(thumb|index|middle|ring|pinky|little)([a-z]*)0*([1-3]?)", name)
        if side and match and match[2] in segments:
            finger = next(bone for bone, names in _FINGERS.items() if match[1] in names.split())
            found.setdefault(f"{side}{finger}{match[3] or segments[match[2]]}", joint)
    return found


def ancestors(skeleton: Skeleton, joint: int) -> list[int]:
    """Returns a joint and the joints above it, up to its root."""
    path: list[int] = []
    while joint >= 0:
        path.append(joint)
        joint = int(skeleton.parent[joint])
    return path


def carrier(skeleton: Skeleton, joints: list[int]) -> int | None:
    """Returns the lowest joint that carries all of them."""
    paths = [ancestors(skeleton, joint)[1:] for joint in joints]
    common = set.intersection(*map(set, paths)) if paths else set()
    return max(common, default=None)


def _find_hips(skeleton: Skeleton, found: dict[str, int]) -> None:
    """Makes the joint that carries both legs the hips, whatever its name."""
    legs = [found[side + "UpperLeg"] for side in SIDES if side + "UpperLeg" in found]
    hips = carrier(skeleton, legs) if len(legs) == 2 else None
    if hips is not None:
        found["Hips"] = hips


def _spine(skeleton: Skeleton, found: Mapping[str, int]) -> dict[str, int]:
    """Returns up to three joints between the hips and the joint that carries the arms (or the head)."""
    tops = [found[side + bone] for bone in ("UpperArm",) for side in SIDES if side + bone in found]
    tops = tops if len(tops) == 2 else [found[bone] for bone in ("Neck", "Head") if bone in found]
    if "Hips" not in found or not tops:
        return {}
    top = carrier(skeleton, tops) if len(tops) > 1 else int(skeleton.parent[tops[0]])
    path = ancestors(skeleton, top)[::-1] if top is not None and top >= 0 else []
    if found["Hips"] not in path:
        return {}
    between = path[path.index(found["Hips"]) + 1 :]
    if not between:
        return {}
    rows = np.unique(np.linspace(0, len(between) - 1, min(3, len(between))).round().astype(int))
    return dict(zip(SPINE, (between[row] for row in rows), strict=False))

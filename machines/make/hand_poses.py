"""The poses of the hand: a turn for each of its 16 bones, and one finger after the other between two poses.

Fingers point up (+Y), the palm looks ahead (+Z), the thumb is at +X: a right hand.
"""

from collections.abc import Callable

import numpy as np
from scipy.optimize import brentq
from scipy.spatial.transform import Rotation
from shapes import Array
from statwalk.files.faq.skeleton_text import shipped_skeleton

CM = 0.01
UPRIGHT = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])
"""from the FAQ's table, where the hand lies along +X, to a hand that stands"""
BONES = shipped_skeleton("hand")
FINGERS = ("little", "ring", "mid", "index")
INSIDE = 2.0
"""centimetres before the palm's middle: where the tips of a fist end"""
FOLDED_DEG, LAST_DEG = 80.0, 65.0
STAGGER_S, TURN_S = 0.09, 0.42
"""between two fingers, and of each finger"""
SHAKE_S = 4.0
Pose = dict[str, Array]
"""quaternions by bone; a bone that is not named is at rest"""


def length(bone: str) -> float:
    """Of a bone, centimetres."""
    return float(BONES.length[BONES.skeleton.index(bone)])


def direction(bone: str) -> Array:
    """Of a bone at rest, of the hand that stands."""
    return np.asarray(UPRIGHT @ BONES.direction[BONES.skeleton.index(bone)])


def bent(first: float, middle: float, last: float, aside: float = 0.0) -> tuple[Array, Array, Array]:
    """The turns of a finger's bones: bent towards the palm, the first also aside (to the little finger)."""
    base = Rotation.from_euler("xz", [first, aside], degrees=True)
    return (
        base.as_quat(),
        Rotation.from_euler("x", middle, degrees=True).as_quat(),
        Rotation.from_euler("x", last, degrees=True).as_quat(),
    )


def folded(finger: str) -> tuple[Array, Array, Array]:
    """The turns of a finger of the fist: its tip ends INSIDE before the palm."""
    first = length(f"{finger}base") * direction(f"{finger}base")[1]
    angles = np.radians([FOLDED_DEG, FOLDED_DEG, FOLDED_DEG + LAST_DEG])

    def over(middle: float) -> float:
        sines = np.sin(angles + np.array([0.0, middle, middle]))
        return float(sines @ [first, length(f"{finger}mid"), length(f"{finger}end")]) - INSIDE

    return bent(FOLDED_DEG, float(np.degrees(brentq(over, np.radians(70), np.radians(120)))), LAST_DEG)


def thumb(base: tuple[float, float, float], end: tuple[float, float, float]) -> Pose:
    """The thumb with its two bones in these directions."""
    turn = _between(direction("thumbbase"), np.array(base))
    back = turn.inv().apply(np.array(end) / np.linalg.norm(end))
    return {"thumbbase": turn.as_quat(), "thumbend": _between(direction("thumbend"), back).as_quat()}


def _between(start: Array, end: Array) -> Rotation:
    axis = np.cross(start, end)
    size = float(np.linalg.norm(axis))
    return Rotation.from_rotvec(axis / max(size, 1e-12) * np.arctan2(size, float(start @ end)))


def _fingers(**turns: tuple[Array, Array, Array]) -> Pose:
    return {
        f"{finger}{part}": turn
        for finger, three in turns.items()
        for part, turn in zip(("base", "mid", "end"), three, strict=True)
    }


OVER_THE_FINGERS = thumb((0.5, 0.72, 0.5), (-0.93, 0.2, 0.3))
REST = {
    **_fingers(
        index=bent(14, 20, 12, -2), mid=bent(18, 24, 14), ring=bent(21, 27, 16, 2), little=bent(23, 28, 18, 5)
    ),
    **thumb((0.55, 0.78, 0.3), (0.2, 0.95, 0.22)),
}
FIST = {**_fingers(**{finger: folded(finger) for finger in FINGERS}), **OVER_THE_FINGERS}
POINT = {**FIST, **_fingers(index=bent(2, 3, 2))}
SPREAD = {
    **_fingers(
        index=bent(-4, 1, 1, -9), mid=bent(-5, 1, 1, -1), ring=bent(-4, 1, 1, 8), little=bent(-3, 2, 2, 19)
    ),
    **thumb((0.86, 0.5, 0.05), (0.8, 0.6, -0.05)),
}


def alive(pose: Pose, most: float) -> dict[str, Callable[[Array], Array]]:
    """The pose with fingers that move a little, each at its own moment, `most` degrees; SHAKE_S long."""
    motion = {}
    for place, (bone, turn) in enumerate(pose.items()):

        def turns(t: Array, turn: Array = turn, late: float = 0.7 * (place // 3)) -> Array:
            angle = np.radians(most) * np.sin(2 * np.pi * t / SHAKE_S - late)
            return np.asarray((Rotation.from_quat(turn) * Rotation.from_euler("x", angle[:, None])).as_quat())

        motion[bone] = turns
    return motion


def one_after_another(
    start: Pose, end: Pose, order: tuple[str, ...]
) -> tuple[float, dict[str, Callable[[Array], Array]]]:
    """Seconds and motion from one pose to the other: the digits of `order` begin one after the other."""
    motion = {}
    for bone in start:
        digit = next(place for place, name in enumerate(order) if bone.startswith(name))
        first, last = Rotation.from_quat(start[bone]), Rotation.from_quat(end[bone])
        way = (first.inv() * last).as_rotvec()

        def turns(
            t: Array, first: Rotation = first, way: Array = way, late: float = STAGGER_S * digit
        ) -> Array:
            x = np.clip((np.asarray(t, float) - late) / TURN_S, 0, 1)
            part = x * x * x * (10 + x * (6 * x - 15))
            return np.asarray((first * Rotation.from_rotvec(part[:, None] * way)).as_quat())

        motion[bone] = turns
    return STAGGER_S * (len(order) - 1) + TURN_S, motion

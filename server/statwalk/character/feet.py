"""The feet of a character: the joints of each leg, and the points of the sole that touch the ground."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from statwalk.character.body_bones import ancestors, body_bones, words_of
from statwalk.character.character import Character
from statwalk.character.skin_points import SkinPoints, bound_points, outermost
from statwalk.maths import transform, vector
from statwalk.maths.arrays import Bools, Floats, Ints
from statwalk.maths.columns import lock_fields
from statwalk.maths.elementary import sincos
from statwalk.rig.evaluate import world_from_local

SIDES = {"left": "Left", "right": "Right"}
"""the feet that names tell, and the sides of `body_bones`"""
BONES = {"hip": "UpperLeg", "knee": "LowerLeg", "ankle": "Foot", "toe": "Toes"}
GIRDLES = {"front": "front fore", "back": "back hind rear"}
"""the words by which names tell the legs of four-legged characters: `Front_Leg_Ankle_L` is `front-left`"""
PARTS = {
    "hip": "upper thigh upperleg legupper",
    "knee": "lower shin lowerleg leglower",
    "ankle": "ankle hock paw foot",
    "toe": "foot toe toes tip",
}
SOLE = 0.02
"""metres above the lowest point of a foot at rest, for a leg of one metre: the height of its sole"""
AZIMUTHS, TILTS = np.linspace(0, 2 * np.pi, 16, endpoint=False), np.radians([15, 60, 88])
MOST_POINTS = len(AZIMUTHS) * len(TILTS)


@dataclass(frozen=True, eq=False)
class Foot:
    """A foot; joints are rows of the skeleton, -1 none.

    The points of the sole are at rest in the space of the joint that carries most of each (`carriers`: the
    ankle, the toe, or a joint below them), in metres of that joint's space.
    """

    name: str
    hip: int
    knee: int
    ankle: int
    toe: int
    hangs: bool
    """whether the ankle is below the knee: in some rigs feet hang on the root, and follow their legs"""
    carriers: Ints
    """(K,)"""
    points: Floats
    """(K, 3) float64"""
    skin: SkinPoints
    """the same points as the skin moves them"""
    is_front: Bools
    """(K,) the points of the ball, not of the heel"""

    def __post_init__(self) -> None:
        lock_fields(self)

    @property
    def leg(self) -> tuple[int, int, int]:
        """Returns hip, knee and ankle."""
        return self.hip, self.knee, self.ankle

    def length(self, world: Floats) -> float:
        """Returns the length of the leg, in metres, for matrices (J, 3, 4): hip to knee to ankle; of a foot
        without leg the height of its ankle above the sole.
        """
        if min(self.leg) < 0:
            return max(float(world[self.ankle, 1, 3] - self.skin.heights(world).min()), 1e-3)
        hip, knee, ankle = (world[joint, :, 3] for joint in self.leg)
        return float(vector.length(knee - hip) + vector.length(ankle - knee))

    @property
    def joints(self) -> list[int]:
        """Returns ankle and toe, and the other joints that carry the sole."""
        return sorted({self.ankle, *self.carriers.tolist(), *([self.toe] if self.toe >= 0 else [])})


def feet_of(character: Character, legs: Mapping[str, Mapping[str, str]] | None = None) -> tuple[Foot, ...]:
    """Returns the feet that the names of the joints tell, then the feet that `legs` adds; none for a
    character without feet.

    `legs`: for feet by name the names of their joints: `ankle`, and perhaps `hip`, `knee`, `toe`; a joint
    that is left out is as the names tell for that foot, or the joint above.

    :raises UnknownNameError: when the skeleton has no joint of a name.
    """
    key = tuple(sorted((name, *sorted(joints.items())) for name, joints in (legs or {}).items()))
    known = _known.setdefault(character, {})
    if key not in known:
        known[key] = _find(character, legs or {})
    return known[key]


_known: WeakKeyDictionary[Character, dict[tuple[object, ...], tuple[Foot, ...]]] = WeakKeyDictionary()


def _find(character: Character, legs: Mapping[str, Mapping[str, str]]) -> tuple[Foot, ...]:
    """The feet that joints' names tell, and the feet that `legs` adds."""
    known, skeleton = _legs_by_name(character), character.skeleton
    for name, joints in legs.items():
        rows = {part: skeleton.index(joint) for part, joint in joints.items() if joint}
        known[name] = _above(character, rows["ankle"]) | known.get(name, {}) | rows
    world = world_from_local(skeleton, character.bind_pose).astype(np.float64)
    return tuple(_foot(character, name, joints, world) for name, joints in known.items())


def _legs_by_name(character: Character) -> dict[str, dict[str, int]]:
    """The joints of the legs that names tell."""
    bones = body_bones(character.skeleton)
    legs = {
        name: {part: bones[side + bone] for part, bone in BONES.items() if side + bone in bones}
        for name, side in SIDES.items()
    }
    legs = {name: leg for name, leg in legs.items() if "ankle" in leg}
    return legs or _four_legs(character)


def _four_legs(character: Character) -> dict[str, dict[str, int]]:
    """The legs whose names tell front or back, side and part."""
    legs: dict[str, dict[str, int]] = {}
    for joint, name in enumerate(character.skeleton.names):
        side, words = words_of(name)
        girdle = next((girdle for girdle, names in GIRDLES.items() if words[0] in names.split()), "")
        part = "".join(word for word in words[1:] if word != "leg")
        if side and girdle and part:
            leg = legs.setdefault(f"{girdle}-{side.lower()}", {})
            free = [key for key, names in PARTS.items() if part in names.split() and key not in leg]
            if free:
                leg[free[0]] = joint
    return {name: leg for name, leg in legs.items() if {"hip", "knee", "ankle"} <= leg.keys()}


def _above(character: Character, ankle: int) -> dict[str, int]:
    """The knee and the hip of an ankle whose leg has no known names: its parent, and the parent of that."""
    return dict(zip(("knee", "hip"), ancestors(character.skeleton, ankle)[1:], strict=False))


def _foot(character: Character, name: str, joints: Mapping[str, int], world: Floats) -> Foot:
    ankle, skeleton = joints["ankle"], character.skeleton
    hip, knee, toe = (joints.get(part, -1) for part in ("hip", "knee", "toe"))
    below = [row for row in range(len(skeleton)) if ankle in ancestors(skeleton, row)]
    skin = _sole(character, below, world)
    points = transform.apply(transform.invert(world[skin.carriers]), skin.at(world))
    at = skin.at(world)[:, ::2]
    ahead = at.mean(0) - world[ankle, ::2, 3]
    x, z = ahead if np.abs(ahead).max() > 1e-6 else (0.0, 1.0)
    along = at[:, 0] * x + at[:, 1] * z
    is_front = along > (along.min() + along.max()) / 2
    hangs = knee in ancestors(skeleton, ankle)
    toe = toe if toe in below else -1
    return Foot(name, hip, knee, ankle, toe, hangs, skin.carriers, points, skin, is_front)


def _sole(character: Character, below: list[int], world: Floats) -> SkinPoints:
    """The lowest points of the skin of the joints `below`; the joints themselves if they have none."""
    points = bound_points(character, below)
    if not points.count:
        points = SkinPoints.of_joints_themselves(below, len(character.skeleton))
    height = points.heights(world)
    leg = max(float(world[below[0], 1, 3] - height.min()), float(np.ptp(world[:, 1, 3])), 1e-6)
    low = np.flatnonzero(height <= height.min() + SOLE * leg)
    return points.take(_spread(points.at(world)[low], low))


def _spread(points: Floats, rows: Ints) -> Ints:
    """At most MOST_POINTS of some rows: those that lie furthest out (K, 3) in directions all round and down,
    the corners on which a foot can stand.
    """
    if len(rows) <= MOST_POINTS:
        return rows
    turn, tilt = (grid.ravel() for grid in np.meshgrid(AZIMUTHS, TILTS))
    (sine, cosine), (down, out) = sincos(turn), sincos(tilt)
    furthest: Ints = rows[outermost(points, np.stack([cosine * out, -down, sine * out]))]
    return furthest

"""The bones of the tree: a skeleton table (FAQ Q11) whose lengths grow from 0 (Q12), the trunk first, then
the boughs, the twigs, and the leaves at their ends.
"""

from functools import cached_property
from typing import NamedTuple

import numpy as np
from shapes import Array

GOLDEN_DEG = 137.508
TRUNK = (0.5, 0.46, 0.4, 0.34, 0.28)
BOUGHS = ((0.62, 20.0), (0.66, 32.0), (0.54, 42.0), (0.4, 54.0))
"""metres of the first bone, degrees above the horizon, for the ends of trunk bones 1 to 4"""
TRUNK_S, BOUGH_S, TWIG_S, LEAF_S = 1.2, 1.0, 0.8, 0.7
"""seconds in which a bone grows"""
OVERLAP = 0.7
"""the part of its parent's time after which a bone goes on where its parent ends; branches wait for all"""
TIP, PIPES = 0.009, 2.2
"""metres: the radius of a twig; boughs add up like pipes, to this power of the radius"""


class Bone(NamedTuple):
    """A row of the table, and when it grows."""

    name: str
    parent: str
    length: float
    direction: Array
    begin_s: float
    seconds: float


def grown(t: Array, begin: float, seconds: float) -> Array:
    """The part that has grown: 3x² − 2x³."""
    x = np.clip((np.asarray(t, float) - begin) / seconds, 0, 1)
    return np.asarray(x * x * (3 - 2 * x))


class Tree:
    """All bones, parents first."""

    def __init__(self) -> None:
        self.bones: dict[str, Bone] = {}
        lean = [(0.03, 0.0), (-0.06, 0.05), (0.05, -0.07), (0.02, 0.08), (-0.05, -0.02)]
        for place, (length, (x, z)) in enumerate(zip(TRUNK, lean, strict=True)):
            self._add(f"trunk{place + 1}", f"trunk{place}" if place else "", length, (x, 1.0, z), TRUNK_S)
        for place, (length, rise) in enumerate(BOUGHS):
            for side in range(2):
                self._bough(2 * place + side, f"trunk{place + 2}", length * (1 - 0.12 * side), rise)
        for side in range(3):
            self._twig(f"top{side + 1}", "trunk5", 0.26, 120.0 * side + 40, 62.0, branch=True)

    def _bough(self, number: int, parent: str, length: float, rise: float) -> None:
        name, turn = f"bough{number + 1}", GOLDEN_DEG * number
        self._add(name, parent, length, _way(turn, rise), BOUGH_S, branch=True)
        self._add(f"{name}.mid", name, 0.62 * length, _way(turn + 12, rise + 10), BOUGH_S)
        for side, aside in (("a", 48.0), ("b", -46.0)):
            self._twig(f"{name}.{side}", name, 0.5 * length, turn + aside, rise + 12, branch=True)
            self._twig(
                f"{name}.mid.{side}",
                f"{name}.mid",
                0.36 * length,
                turn + 0.75 * aside,
                rise + 24,
                branch=True,
            )
        self._twig(f"{name}.far", f"{name}.mid", 0.46 * length, turn - 6, rise + 18)

    def _twig(
        self, name: str, parent: str, length: float, turn: float, rise: float, branch: bool = False
    ) -> None:
        self._add(name, parent, length, _way(turn, rise), TWIG_S, branch)

    def _add(
        self,
        name: str,
        parent: str,
        length: float,
        direction: tuple[float, float, float] | Array,
        seconds: float,
        branch: bool = False,
    ) -> None:
        begin = 0.0
        if parent:
            above = self.bones[parent]
            begin = above.begin_s + (1.0 if branch else OVERLAP) * above.seconds
        way = np.array(direction, float)
        self.bones[name] = Bone(name, parent, length, way / np.linalg.norm(way), begin, seconds)

    @cached_property
    def children(self) -> dict[str, list[str]]:
        """The bones that begin at the end of each bone; the one that goes on most straight is first."""
        found: dict[str, list[str]] = {name: [] for name in self.bones}
        for bone in self.bones.values():
            if bone.parent:
                found[bone.parent].append(bone.name)
        for name, below in found.items():
            below.sort(key=lambda child: -float(self.bones[child].direction @ self.bones[name].direction))
        return found

    @cached_property
    def tips(self) -> list[str]:
        """The bones at the ends."""
        return [name for name, below in self.children.items() if not below]

    @property
    def seconds(self) -> float:
        """Until the last leaf has grown."""
        return max(bone.begin_s + bone.seconds for bone in self.bones.values()) + LEAF_S

    def start(self, name: str) -> Array:
        """Where the bone begins when all have grown, metres."""
        bone = self.bones[name]
        return self.start(bone.parent) + self.offset(bone.parent) if bone.parent else np.zeros(3)

    def offset(self, name: str) -> Array:
        """From the beginning to the end of the grown bone."""
        return self.bones[name].direction * self.bones[name].length

    def radius(self, name: str, t: Array) -> Array:
        """The radius at the beginning of a bone at times (K,): that of its twig, and of all that it feeds."""
        bone = self.bones[name]
        own = TIP * grown(t, bone.begin_s, bone.seconds)
        fed = [self.radius(child, t) for child in self.children[name]]
        total = sum((radius**PIPES for radius in fed), np.zeros_like(own))
        return np.maximum(own, total ** (1 / PIPES))


def _way(turn_deg: float, rise_deg: float) -> Array:
    turn, rise = np.radians(turn_deg), np.radians(min(rise_deg, 85.0))
    return np.array([np.sin(turn) * np.cos(rise), np.sin(rise), np.cos(turn) * np.cos(rise)])

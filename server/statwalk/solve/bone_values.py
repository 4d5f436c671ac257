"""What is known about each bone while the twelve rules run: values with their sources (FAQ Q26)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from statwalk.maths.arrays import Floats

SHAPES: dict[str, tuple[int, ...]] = {
    "RA": (3,), "RM": (3, 3), "SP": (3,), "EP": (3,), "TR": (3,), "DIR": (3,), "LEN": (),
}  # fmt: skip
"""the quantities of a bone"""
DATA: dict[str, tuple[int, ...]] = {"path": (2, 3), "bend": (3,)}
"""data that no rule finds: the motion path on which a bone slides, from one point to another; the direction
in which the joint at a bone's start bends
"""
CHANNELS = {
    f"{name}_{axis}": (quantity, column)
    for name, quantity in {
        "rotate": "RA", "start": "SP", "end": "EP", "trans": "TR", "dir": "DIR",
    }.items()
    for column, axis in enumerate("xyz")
} | {"length": ("LEN", 0)}  # fmt: skip
"""the numbers that expressions read and set: quantity and component"""
GIVEN, DEFAULT = "given", "default"


class BoneSet(NamedTuple):
    """J bones, parents first. NaN: not known."""

    names: tuple[str, ...]
    parent: NDArray[np.int32]
    """(J,) -1: no parent; the bone then hangs on the origin of the character's space"""
    length: Floats
    """(J,)"""
    direction: Floats
    """(J, 3) unit vectors in the bone's own space; 0 of a bone of length 0"""
    translation: Floats
    """(J, 3) TR where nothing else is given"""


class BoneValue(NamedTuple):
    """The value of one quantity, and its source: `given`, `default`, `rule 8`, `expression, line 3`."""

    value: Floats
    source: str

    @property
    def rule(self) -> int:
        """Returns the number of the rule that found the value; 0: no rule."""
        return int(self.source.removeprefix("rule ")) if self.source.startswith("rule ") else 0


@dataclass(eq=False)
class BoneValues:
    """The values of all bones, of which rules and expressions add more; a value has the shape of its
    quantity after any leading axes.
    """

    bones: BoneSet
    values: dict[tuple[int, str], BoneValue] = field(default_factory=dict)
    data: dict[tuple[int, str], Floats] = field(default_factory=dict)
    parts: dict[tuple[int, str, int], BoneValue] = field(default_factory=dict)
    """components that expressions have set"""
    changed: set[int] = field(default_factory=set)
    """bones with values that `DueBones` has not noted yet"""

    def get(self, bone: int, name: str) -> Floats | None:
        """Returns the value of a quantity, of the parent's with a `P` in front; None: not known. The parent
        of a root is the character's space: PEP 0, PRM the identity.
        """
        if name in DATA:
            return self.data.get((bone, name))
        if name.startswith("P"):
            bone, name = int(self.bones.parent[bone]), name[1:]
            if bone < 0:
                return {"EP": np.zeros(3), "RM": np.eye(3)}.get(name)
        known = self.values.get((bone, name))
        return None if known is None else known.value

    def put(self, bone: int, name: str, value: Floats, source: str) -> None:
        """Makes the value of a quantity known."""
        if name.startswith("P"):
            bone, name = int(self.bones.parent[bone]), name[1:]
        self.values[bone, name] = BoneValue(value, source)
        self.changed.add(bone)

    def component(self, bone: int, channel: str) -> Floats | None:
        """Returns a number of a bone as expressions read it, angles in degrees; None: not known."""
        quantity, column = CHANNELS[channel]
        known = self.values.get((bone, quantity)) or self.parts.get((bone, quantity, column))
        if known is None:
            return None
        value = known.value
        if quantity != "LEN" and (bone, quantity) in self.values:
            value = value[..., column]
        return np.degrees(value) if quantity == "RA" else value

    def put_component(self, bone: int, channel: str, value: Floats, source: str) -> None:
        """Makes a number known; a vector is known when its three components are."""
        quantity, column = CHANNELS[channel]
        self.changed.add(bone)
        self.parts[bone, quantity, column] = BoneValue(
            np.radians(value) if quantity == "RA" else value, source
        )
        parts = [self.parts.get((bone, quantity, k)) for k in range(3 if SHAPES[quantity] else 1)]
        known = [part for part in parts if part is not None]
        if len(known) == len(parts):
            values = np.broadcast_arrays(*(part.value for part in known))
            whole = np.stack(values, -1) if SHAPES[quantity] else values[0]
            self.values[bone, quantity] = BoneValue(whole, source)

"""Parameters: what you set from outside, numbers or vectors.

A vector is stored as its components, one number each: a point `reach` is `reach.x`, `reach.y` and `reach.z`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np

Kind = Literal["number", "flag", "point", "direction", "rotation"]
KINDS: tuple[Kind, ...] = get_args(Kind)
COMPONENTS: Mapping[Kind, str] = {"point": "xyz", "direction": "xyz", "rotation": "xyzw"}
"""the components of the kinds that are vectors"""


@dataclass(frozen=True)
class ParameterDefinition:
    """A named number that you set from outside, or a component of a vector."""

    default: float
    minimum: float
    maximum: float
    line: int
    smooth: float = 0.0
    """seconds in which a new value is reached, without a jump in value or rate; 0: immediately"""
    kind: Kind = "number"
    vector: str = ""
    """the parameter that this number is a component of; empty: none"""
    joint: str = ""
    """the joint at which the page has a handle for it; empty: none"""
    freedom: str = ""
    """the degree of freedom of that joint that the handle moves, degrees or metres"""
    event: str = ""
    """the event that the page sends when the handle is taken; empty: none"""


def component_names(name: str, kind: Kind) -> tuple[str, ...]:
    """Returns the names under which the numbers of a parameter are stored."""
    return tuple(f"{name}.{letter}" for letter in COMPONENTS[kind]) if kind in COMPONENTS else (name,)


def fitting(name: str, kind: Kind, value: float | Sequence[float]) -> tuple[float, ...]:
    """Returns the numbers that a value of a parameter stores; directions and rotations at unit length.

    :raises ValueError: when the value has another number of components, a flag is neither 0 nor 1, or a
        direction or rotation has no length.
    """
    given = np.asarray(value, np.float64)
    numbers = tuple(given.ravel().tolist())
    wanted = component_names(name, kind)
    if len(numbers) != len(wanted) or given.ndim != (kind in COMPONENTS):
        form = f"a list of {len(wanted)} numbers" if kind in COMPONENTS else "one number"
        raise ValueError(f"{name} is a {kind}: it needs {form}")
    if kind == "flag" and numbers[0] not in (0.0, 1.0):
        raise ValueError(f"{name} is a flag: 0 or 1, not {numbers[0]:g}")
    return _unit(name, kind, numbers) if kind in ("direction", "rotation") else numbers


SHORTEST = 1e-6


def _unit(name: str, kind: Kind, numbers: tuple[float, ...]) -> tuple[float, ...]:
    length = sum(number * number for number in numbers) ** 0.5
    if not SHORTEST < length < float("inf"):
        raise ValueError(f"{name} is a {kind}: its length must be more than 0")
    return tuple(number / length for number in numbers)

"""The six types of joints, SK5 (FAQ Q4-Q10): their symbols, degrees of freedom and limits.

A joint is a JointLimit of a type. Radians; the character's unit of length.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from statwalk.maths.clamp_kinds import CONE, EULER, HINGE, RANGE
from statwalk.maths.clamp_table import FREE_TURN, JointLimit, Range, frame_of

LARGEST_SWING = np.pi / 2
ORDERS = ("PPR", "PRP", "RPP")
NOWHERE: Range = (0.0, 0.0)


class JointType(NamedTuple):
    """A type of joints; its degrees of freedom have these names, in this order."""

    symbol: str
    freedoms: tuple[str, ...]
    forms: Mapping[str, str] = {}
    """the symbol of each form"""


TYPES: Mapping[str, JointType] = {
    "revolute": JointType("R", ("angle",), {"hinge": "R1", "twist": "R2", "turn": "R3"}),
    "prismatic": JointType("P", ("slide",)),
    "helical": JointType("H", ("angle",)),
    "cylindrical": JointType("RP", ("angle", "slide"), {"offset": "RP", "coaxial": "R͠P"}),
    "spherical": JointType("3R", ("swing_x", "swing_z", "twist")),
    "planar": JointType("PPR", ("slide_x", "slide_z", "angle")),
}
OF_EACH_AXIS = ("rotate_x", "rotate_y", "rotate_z", "translate_x", "translate_y", "translate_z")


class Freedom(NamedTuple):
    """A degree of freedom: radians if it is an angle, else units of length."""

    name: str
    is_angle: bool
    low: float
    high: float


def joint(
    kind: str,
    ranges: Mapping[str, Range],
    axis: Sequence[float] | None = None,
    side: Sequence[float] | None = None,
    form: str = "",
    pitch: float = 0.0,
    order: str = "PPR",
    shape: str = "cone",
) -> JointLimit:
    """Returns a joint of one of TYPES; `ranges`: smallest and largest value by degree of freedom.

    axis (3,): of rotation and slide, a sphere's twist, a plane's normal (default Y; of a hinge X); side (3,):
    X of the joint's frame. pitch: units of length for each turn of a helical joint. shape: `cone` or `range`
    of a spherical joint's swing.

    :raises ValueError: when a type, form, order, shape or degree of freedom does not exist; when a range ends
        below its beginning, or a swing reaches a quarter turn; when a slide or pitch is missing.
    """
    _check(kind, ranges, form, pitch, order, shape)
    form = form or next(iter(TYPES[kind].forms), "")
    direction = axis or ((1.0, 0.0, 0.0) if form == "hinge" else (0.0, 1.0, 0.0))
    frame = tuple(frame_of(direction, side).tolist())
    limit = JointLimit(
        HINGE, frame, ranges.get("angle", FREE_TURN), slide=(NOWHERE,) * 3, type=kind, form=form
    )
    if kind == "prismatic":
        return replace(limit, twist=NOWHERE, slide=(NOWHERE, ranges["slide"], NOWHERE))
    if kind == "cylindrical":
        return replace(limit, slide=(NOWHERE, ranges["slide"], NOWHERE))
    if kind == "helical":
        return replace(limit, pitch=pitch / (2 * np.pi))
    if kind == "planar":
        return replace(limit, slide=(ranges["slide_x"], NOWHERE, ranges["slide_z"]), order=order)
    if kind == "spherical":
        quarter = (-LARGEST_SWING, LARGEST_SWING)
        swing = ranges.get("swing_x", quarter), ranges.get("swing_z", quarter)
        is_cone = shape == "cone" and all(low < 0 < high for low, high in swing)
        twist = ranges.get("twist", FREE_TURN)
        return replace(limit, kind=CONE if is_cone else RANGE, twist=twist, swing=swing)
    return limit


def axis_limits(angles: Sequence[Range], slide: Sequence[Range] | None) -> JointLimit:
    """Returns limits of the angles about X, then Y, then Z (FAQ order), and of the translation along each
    axis (Q13); None: the translation is free.

    :raises ValueError: when a range ends below its beginning.
    """
    for name, ends in zip(OF_EACH_AXIS, (*angles, *(slide or ())), strict=False):
        _check_range(name, ends)
    turns, ways = tuple(angles), None if slide is None else tuple(slide)
    return JointLimit(EULER, angles=(turns[0], turns[1], turns[2]),
                      slide=None if ways is None else (ways[0], ways[1], ways[2]))  # fmt: skip


def symbol(limit: JointLimit) -> str:
    """Returns the FAQ's symbol of a joint; empty for limits of each axis."""
    if limit.type not in TYPES:
        return ""
    kind = TYPES[limit.type]
    return limit.order if limit.type == "planar" else kind.forms.get(limit.form, kind.symbol)


def freedoms(limit: JointLimit) -> tuple[Freedom, ...]:
    """Returns the degrees of freedom of a joint with their limits, in the order of their values."""
    slide = limit.slide or ((-np.inf, np.inf),) * 3
    ranges: tuple[Range, ...] = (limit.twist,)
    if limit.type not in TYPES:
        ranges = (*limit.angles, *slide)
    elif limit.type == "prismatic":
        ranges = (slide[1],)
    elif limit.type == "cylindrical":
        ranges = (limit.twist, slide[1])
    elif limit.type == "spherical":
        ranges = (*limit.swing, limit.twist)
    elif limit.type == "planar":
        ranges = (slide[0], slide[2], limit.twist)
    names = TYPES[limit.type].freedoms if limit.type in TYPES else OF_EACH_AXIS
    is_angle = [not name.startswith(("slide", "translate")) for name in names]
    return tuple(
        Freedom(*row, *ends) for row, ends in zip(zip(names, is_angle, strict=True), ranges, strict=True)
    )


def _check(kind: str, ranges: Mapping[str, Range], form: str, pitch: float, order: str, shape: str) -> None:
    for text, name, names in (
        ("type of joints", kind, tuple(TYPES)),
        ("form", form, ("", *(TYPES[kind].forms if kind in TYPES else ()))),
        ("order of a planar joint", order, ORDERS),
        ("shape of a swing", shape, ("cone", "range")),
    ):
        if name not in names:
            raise ValueError(
                f"no {text} is called {name[:40]!r}; there are: {', '.join(filter(None, names)) or 'none'}"
            )
    for name, ends in ranges.items():
        if name not in TYPES[kind].freedoms:
            listed = ", ".join(TYPES[kind].freedoms)
            raise ValueError(f"a {kind} joint has no {name[:40]}; its degrees of freedom are: {listed}")
        _check_range(name, ends)
        if name.startswith("swing") and max(-ends[0], ends[1]) >= LARGEST_SWING:
            raise ValueError(f"the {name} of a spherical joint must be less than 90 degrees (FAQ Q9)")
    for name in TYPES[kind].freedoms:
        if name.startswith("slide") and name not in ranges:
            raise ValueError(f"a {kind} joint needs the range of its {name}: [min, max]")
    if (kind == "helical") != (pitch != 0):
        raise ValueError("a helical joint, and no other, has a pitch, the way of one turn, which is not 0")


def _check_range(name: str, ends: Range) -> None:
    if not ends[0] <= ends[1]:
        raise ValueError(f"the minimum of {name} is more than its maximum: {ends[0]:g} > {ends[1]:g}")

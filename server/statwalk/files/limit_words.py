"""Writes the limits of joints in the words in which `joint_limits` reads them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import numpy as np

from statwalk.maths import quat
from statwalk.maths.clamp_kinds import FREE, RANGE
from statwalk.maths.clamp_table import FREE_TURN, JointLimit
from statwalk.rig.joint_types import LARGEST_SWING, freedoms

FREE_SWING = (-LARGEST_SWING, LARGEST_SWING)
"""the swing of a joint whose file does not limit it"""


def limits_in_words(limits: Mapping[str, JointLimit]) -> dict[str, Any]:
    """Returns `joints` and `limits` of a character file, degrees and metres; empty without limits."""
    joints = {name: _joint(limit) for name, limit in limits.items() if limit.type}
    axes = {name: _axes(limit) for name, limit in limits.items() if not limit.type and limit.kind != FREE}
    return {key: said for key, said in (("joints", joints), ("limits", axes)) if said}


def _joint(limit: JointLimit) -> dict[str, Any]:
    said: dict[str, Any] = {"type": limit.type}
    if limit.form:
        said["form"] = limit.form
    for name, direction in (("axis", (0.0, 1.0, 0.0)), ("side", (1.0, 0.0, 0.0))):
        said[name] = quat.rotate(np.array(limit.frame), np.array(direction)).tolist()
    if limit.pitch:
        said["pitch"] = limit.pitch * 2 * math.pi
    if limit.type == "planar":
        said["order"] = limit.order
    if limit.type == "spherical" and limit.kind == RANGE:
        said["shape"] = "range"
    for freedom in freedoms(limit):
        ends = freedom.low, freedom.high
        free = FREE_SWING if freedom.name.startswith("swing") else FREE_TURN
        if freedom.is_angle and ends != free:
            said[f"{freedom.name}_deg"] = [math.degrees(end) for end in ends]
        elif not freedom.is_angle:
            said[freedom.name] = list(ends)
    return said


def _axes(limit: JointLimit) -> dict[str, Any]:
    turns = [[math.degrees(ends[k]) for ends in limit.angles] for k in (0, 1)]
    if limit.slide is None:
        return {"rotation_deg": turns}
    return {"rotation_deg": turns, "translation": [[ends[k] for ends in limit.slide] for k in (0, 1)]}

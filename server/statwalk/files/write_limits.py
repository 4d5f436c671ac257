"""Writes the limits of joints for a character file whose bones have the axes of the character at rest: joints
with a type in the file itself, limits of each axis as the FAQ's table (Q13).
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from statwalk.character.character import Character
from statwalk.files.faq.constraint_text import write_constraints
from statwalk.files.held_parts import axes_at_rest, carriers, limits_about_turned_axes
from statwalk.files.limit_words import limits_in_words
from statwalk.maths import quat
from statwalk.maths.arrays import Floats
from statwalk.maths.clamp_kinds import EULER
from statwalk.maths.clamp_table import JointLimit


def limit_entries(
    character: Character, names: Sequence[str], table: str
) -> tuple[dict[str, Any], dict[str, str]]:
    """Returns the entries `joints` and `limits` of the character file, and the files that they name.

    `names`: of the joints in the file; `table`: the name of the file with the FAQ's table. Limits about axes
    that are turned at rest are left out.
    """
    left_out, axes = set(limits_about_turned_axes(character)), axes_at_rest(character)
    without = carriers(character)
    joints = {name: row for row, name in enumerate(character.skeleton.names) if row not in without}
    kept = {
        names[joints[name]]: _turned(limit, axes[joints[name]])
        for name, limit in character.limits.items()
        if name in joints and name not in left_out
    }
    entries = limits_in_words(kept)
    of_axes = {name: limit for name, limit in kept.items() if limit.kind == EULER}
    if not of_axes or any(limit.slide is None for limit in of_axes.values()):
        return entries, {}
    return {**entries, "limits": table}, {table: write_constraints(of_axes)}


def entry_lines(entries: Mapping[str, Any]) -> list[str]:
    """Returns entries as lines of YAML, each joint on a line of its own."""
    lines: list[str] = []
    for key, value in entries.items():
        rows = value.items() if isinstance(value, dict) else ()
        lines.append(f"{key}:" if rows else f"{key}: {json.dumps(value)}")
        lines += [f"  {json.dumps(name)}: {json.dumps(words)}" for name, words in rows]
    return lines


def _turned(limit: JointLimit, axes: Floats) -> JointLimit:
    """Returns the limit in the axes of the character; a limit of each axis stays as it is."""
    if limit.kind == EULER:
        return limit
    x, y, z, w = quat.mul(axes, np.array(limit.frame)).tolist()
    return replace(limit, frame=(x, y, z, w))

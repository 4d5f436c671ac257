"""The limits of a joint as a file defines them (SK5, SK6)."""

from __future__ import annotations

from typing import NamedTuple

from statwalk.maths.clamp_table import JointLimit


class LimitDefinition(NamedTuple):
    """The limits of a joint, and their line in the file."""

    limit: JointLimit
    line: int

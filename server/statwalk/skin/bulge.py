"""A muscle that bulges with the angle of a joint, as authored (DS8, FAQ Q22); `character/bulge_targets`
compiles it.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from statwalk.maths.formula.tokens import as_written

AXES = "xyz"
Point = tuple[float, float, float]


@dataclass(frozen=True)
class Bulge:
    """A muscle that bulges; `point`, `axis` and `radius` are metres in the space of the joint `bone` at
    rest.
    """

    name: str
    """of the morph target"""
    joint: str
    """the joint whose angle is read"""
    turn: str
    """the axis of the angle: x, y or z"""
    cubic: tuple[float, float, float, float]
    """the scale factor is c0 + c1·a + c2·a² + c3·a³ of the angle a in degrees"""
    bone: str
    point: Point
    axis: Point | None = None
    """a direction through `point`, from which the vertices move away; without it they move away from
    `point`
    """
    radius: Point | None = None
    """half axes of an ellipsoid around `point`: the bulge fades out towards its surface"""
    vertices: frozenset[int] | None = None
    """the chosen vertices, counted from 0 through all parts of the character; None: all"""
    line: int = 0
    """in the file that is read; 0 in a character"""

    def factor(self, angle_deg: float) -> float:
        """Returns the scale factor at an angle in degrees."""
        c0, c1, c2, c3 = self.cubic
        return c0 + angle_deg * (c1 + angle_deg * (c2 + angle_deg * c3))

    @property
    def weight(self) -> str:
        """Returns the name of the weight that the bulge's expression sets."""
        return f"{self.name}.weight"

    @property
    def expression(self) -> str:
        """Returns the line that gives the morph target its weight."""
        a = as_written(f"{self.joint}.rotate_{self.turn}")
        c0, *rest = (_plain(number) for number in (self.cubic[0] - 1, *self.cubic[1:]))
        c1, c2, c3 = rest
        return f"{as_written(self.weight)} = {c0} + {a} * ({c1} + {a} * ({c2} + {a} * {c3}))"


def _plain(number: float) -> str:
    return np.format_float_positional(number, trim="-")

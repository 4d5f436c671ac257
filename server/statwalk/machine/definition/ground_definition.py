"""The uneven ground on which the actors of a machine walk."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class GroundDefinition:
    """A rectangle, level or sloping along one axis, above the floor; metres."""

    corner: tuple[float, float]
    """x, z"""
    opposite: tuple[float, float]
    """x, z of the opposite corner, both larger"""
    height: float
    """of a slope: at the side of `corner`"""
    line: int
    end_height: float | None = None
    """of a slope: at the opposite side"""
    axis: str = "z"
    """x or z: the axis along which a slope rises"""

    @property
    def heights(self) -> list[float]:
        """Returns the heights of the four corners: x0 z0, x1 z0, x1 z1, x0 z1."""
        _, _, _, _, level, along_x, along_z = self.numbers
        (x0, z0), (x1, z1) = self.corner, self.opposite
        return [level + along_x * x + along_z * z for x, z in ((x0, z0), (x1, z0), (x1, z1), (x0, z1))]

    @property
    def numbers(self) -> tuple[float, ...]:
        """Returns both corners, and a, b, c of the height a + b·x + c·z."""
        rise = 0.0 if self.end_height is None else self.end_height - self.height
        number = 0 if self.axis == "x" else 1
        slope = rise / (self.opposite[number] - self.corner[number])
        level = self.height - slope * self.corner[number]
        return (*self.corner, *self.opposite, level, *((slope, 0.0) if self.axis == "x" else (0.0, slope)))

"""The `solvers:` of a machine as written (IK13 to IK15): chains that reach for a parameter in every tick."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from statwalk.machine.definition.expression_definition import channel_of_name


@dataclass(frozen=True)
class SolverDefinition:
    """A chain of joints whose end comes to a target."""

    line: int
    solver: str
    """two-bone, ccd, fabrik, force or look-at"""
    chain: tuple[str, ...]
    """joints from start to end"""
    target: str
    """a parameter of kind point; look-at: or direction"""
    space: Literal["stage", "model"] = "stage"
    """of target, pole and rotation parameters"""
    pole: str | tuple[float, float, float] | None = None
    """a parameter of kind point or direction, or a direction in model space"""
    rotation: str | tuple[float, float, float, float] | None = None
    """of the end: a parameter of kind rotation, or x y z w in model space; None: the end keeps its rotation
    from its parent
    """
    weight: float | str | Mapping[str, float | str] = 1.0
    """0…1, a parameter, or a channel of the pose (`grip.weight`, `Prop.trans_x`); or one of them for each
    state of the base; states left out: 0
    """
    ease: float = 0.3
    """seconds in which a weight by state is reached"""
    travel: float | None = None
    """seconds in which the end travels to its target; None: `force` 0.3, others are there immediately"""
    anchor: str = ""
    """the first joint of the chain, or the last: it stays, the other comes to the target; empty: the first"""
    grab: bool = False
    """the page has a handle at the chain's free end, and `weight` is 1 while it is dragged"""
    softening: float = 0.0
    tolerance: float = 1e-4
    iterations: int | None = None
    sensitivity: Mapping[str, float] = field(default_factory=dict)
    forward: tuple[float, float, float] = (0.0, 0.0, 1.0)
    cone_deg: float = 180.0
    """look-at: it looks no further than this from the front, +Z of model space"""

    @property
    def parameters(self) -> tuple[str, ...]:
        """Returns the parameters that the solver reads."""
        weights = self.weight.values() if isinstance(self.weight, Mapping) else (self.weight,)
        names = [name for name in (self.target, self.pole, self.rotation, *weights) if isinstance(name, str)]
        return tuple(name for name in names if not channel_of_name(name))

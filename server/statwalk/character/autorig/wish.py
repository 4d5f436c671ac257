"""What autorigging is asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from statwalk.errors import ContentError, UnknownNameError
from statwalk.skin.binding.bind_surface import Weighting

SkeletonKind = Literal["own", "human", "mammal", "parts"]
Facing = Literal["+x", "-x", "+z", "-z"]
SKELETONS: tuple[SkeletonKind, ...] = get_args(SkeletonKind)
WEIGHTINGS: tuple[Weighting, ...] = get_args(Weighting)
FACINGS: tuple[Facing, ...] = get_args(Facing)


@dataclass(frozen=True)
class RigWish:
    """How a character is rigged.

    skeleton    own: the joints that the file has; human, mammal: a template placed in the mesh; parts: a
                skeleton made of the mesh alone
    weights     heat: smooth; nearest: each vertex follows one bone
    facing      where the character looks, for templates

    :raises ContentError: when there is no such choice.
    """

    skeleton: SkeletonKind = "parts"
    weights: Weighting = "heat"
    facing: Facing = "+z"

    def __post_init__(self) -> None:
        for name, known in (("skeleton", SKELETONS), ("weights", WEIGHTINGS), ("facing", FACINGS)):
            value = str(getattr(self, name))
            if value not in known:
                raise ContentError(str(UnknownNameError(name, value, known)), place=name)

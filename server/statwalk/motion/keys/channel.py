"""The parts of a clip as written: keyed channels and markers."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal, NamedTuple

from statwalk.errors import ContentError
from statwalk.maths.arrays import Floats

Path = Literal["translation", "rotation", "scale", "weights"]
Interpolation = Literal[
    "STEP", "LINEAR", "CUBICSPLINE", "BSPLINE", "BSPLINE_THROUGH", "NURBS", "NURBS_THROUGH"
]

WEIGHT_RANGE = (1e-3, 1e3)
"""of the keys of a NURBS curve"""
WIDTHS = {"translation": 3, "rotation": 4, "scale": 3}


class Marker(NamedTuple):
    """A named marker of a clip: `time` in seconds from its start."""

    name: str
    time: float


@dataclass(frozen=True, eq=False)
class Channel:
    """The keys of one property of one joint.

    :raises ContentError: when the times do not rise, or the values do not fit them.
    """

    joint: int
    """row of the pose; for weights, the joint that carries the mesh"""
    path: Path
    times: Floats
    """(K,) seconds, strictly increasing"""
    values: Floats
    """(K, n), n = 3, 4 (xyzw) or the number of weights; CUBICSPLINE (K, 3, n): in-tangent, value, out-tangent
    (glTF, appendix C)
    """
    interpolation: Interpolation = "LINEAR"
    weight_first: int = 0
    """for weights: the column of the pose's weights for the first value"""
    key_weights: Floats | None = None
    """(K,) for NURBS: how strongly each key pulls, > 0; None: all alike"""

    def __post_init__(self) -> None:
        if self.times.ndim != 1 or not len(self.times) or (self.times[1:] <= self.times[:-1]).any():
            raise ContentError(f"the key times of joint {self.joint}'s {self.path} must rise from key to key")
        expected = (len(self.times), 3) if self.interpolation == "CUBICSPLINE" else (len(self.times),)
        width = WIDTHS.get(self.path, self.values.shape[-1])
        if self.values.shape != (*expected, width):
            raise ContentError(
                f"joint {self.joint}'s {self.path} needs values of shape {(*expected, width)}, not "
                f"{self.values.shape}"
            )
        if self.key_weights is not None:
            self._check_weights(self.key_weights)

    def _check_weights(self, weights: Floats) -> None:
        least, most = WEIGHT_RANGE
        if weights.shape != self.times.shape or not ((weights >= least) & (weights <= most)).all():
            raise ContentError(
                f"joint {self.joint}'s {self.path} needs a weight of {least:g} to {most:g} for each key"
            )

    @classmethod
    def checked(
        cls,
        joint: int,
        path: Path,
        times: Floats,
        values: Floats,
        interpolation: Interpolation,
        weight_first: int = 0,
    ) -> Channel:
        """Returns a channel without checks, for readers of files that have checked times and values already:
        a file has thousands of channels.
        """
        channel = object.__new__(cls)
        channel.__dict__.update(
            joint=joint,
            path=path,
            times=times,
            values=values,
            interpolation=interpolation,
            weight_first=weight_first,
        )
        return channel


def duration_of(channels: Iterable[Channel]) -> float:
    """Returns the seconds from 0 to the last key of all channels; 0 if there are no channels."""
    return max((float(channel.times[-1]) for channel in channels), default=0.0)

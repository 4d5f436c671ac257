"""A motion: named handles as functions of time, two feet, a length; and the tools to put motions together."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from curves import Array, Curve
from feet import Track
from pose import Controls, solve
from skeleton import SIDES, mirrored_joints

Body = Callable[[Array], dict[str, Array]]
Feet = Callable[[Array], dict[str, Track]]


@dataclass(frozen=True)
class Motion:
    """`body` and `feet` give handles and foot tracks at times (F,) seconds; `mirror` swaps left and right of the result."""

    name: str
    duration: float
    body: Body
    feet: Feet
    loop: bool = False
    rate: int = 60
    mirror: bool = False

    def frames(self) -> tuple[Array, Array, Array]:
        """Times (F,), local rotations (F, J, 4), root translation (F, 3)."""
        count = round(self.duration * self.rate)
        times = np.arange(count + 1) / self.rate
        rotation, root = self.at(times)
        if self.loop:  # the last frame is the first, one stride further
            rotation[-1] = rotation[0] * np.sign((rotation[0] * rotation[-1]).sum(-1, keepdims=True))
        return times, rotation, root

    def at(self, times: Array) -> tuple[Array, Array]:
        """Local rotations (F, J, 4) and root translation (F, 3) at any times."""
        rotation, root = solve(Controls(self.body(times), self.feet(times)))
        if self.mirror:
            rotation = rotation[:, mirrored_joints()] * np.array([1.0, -1.0, -1.0, 1.0])
            root = root * np.array([-1.0, 1.0, 1.0])
        return rotation, root


def body_of(curves: dict[str, Curve]) -> Body:
    """Handles from one curve of time each."""
    return lambda t: {name: curve(t) for name, curve in curves.items()}


def both(name: str, curve: Curve, lag: float = 0.0) -> dict[str, Curve]:
    """The same curve for a handle of both sides; the right one comes `lag` seconds later, since nothing moves in mirror time."""
    return {f"Left.{name}": curve, f"Right.{name}": lambda t: curve(t - lag)}


def mixed(first: Body, second: Body, weight: Curve) -> Body:
    """`first` where the weight is 0, `second` where it is 1."""

    def body(t: Array) -> dict[str, Array]:
        a, b, w = first(t), second(t), weight(t)
        zero = np.zeros_like(t)
        return {name: a.get(name, zero) * (1 - w) + b.get(name, zero) * w for name in sorted({*a, *b})}

    return body


def sides(make: Callable[[str, float], Callable[[Array], Track]]) -> Feet:
    """Feet from one maker called with a side's name and its sign."""
    tracks = {side: make(side, sign) for side, sign in SIDES.items()}
    return lambda t: {side: track(t) for side, track in tracks.items()}

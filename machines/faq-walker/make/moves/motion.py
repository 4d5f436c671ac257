"""A motion: named handles as functions of time, two feet, a length; and the tools to put motions together."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from curves import Array, Curve
from moves.feet import STEP, Track
from moves.pose import Controls, solve
from skeleton import SIDES

Body = Callable[[Array], dict[str, Array]]
TrackOf = Callable[[Array], Track]
Feet = Callable[[Array], dict[str, Track]]


@dataclass(frozen=True)
class Motion:
    """`body` and `feet` give handles and foot tracks at times (F,) seconds; the clip is the span from
    `start`. The lids are closed at the times `blinks` of the clip.
    """

    name: str
    duration: float
    body: Body
    feet: Feet
    loop: bool = False
    rate: int = 60
    start: float = 0.0
    blinks: tuple[float, ...] = ()

    def frames(self) -> tuple[Array, Array, Array]:
        """Times (F,), local rotations (F, J, 4), root translation (F, 3)."""
        count = round(self.duration * self.rate)
        times = np.linspace(0.0, self.duration, count + 1)
        rotation, root = self.at(times)
        if self.loop:  # the last frame is the first, one stride further
            rotation[-1] = rotation[0] * np.sign((rotation[0] * rotation[-1]).sum(-1, keepdims=True))
        return times, rotation, root

    def at(self, times: Array) -> tuple[Array, Array]:
        """Local rotations (F, J, 4) and root translation (F, 3) at any times since the clip's start; the path
        begins at z = 0.
        """
        moments = np.concatenate([[0.0], times]) + self.start
        rotation, root = solve(Controls(self.body(moments), self.feet(moments)))
        return rotation[1:], root[1:] - root[:1] * (0.0, 0.0, 1.0)


def body_of(curves: dict[str, Curve]) -> Body:
    """Handles from one curve of time each."""
    return lambda t: {name: curve(t) for name, curve in curves.items()}


def both(name: str, curve: Curve, lag: float = 0.0) -> dict[str, Curve]:
    """The same curve for a handle of both sides; the right one comes `lag` seconds later, since nothing moves
    in mirror time.
    """
    return {f"Left.{name}": curve, f"Right.{name}": lambda t: curve(t - lag)}


def held(body: Body, at: float) -> Body:
    """The handles as they are at one time, at all times."""
    return lambda t: body(np.full_like(t, at))


def later(body: Body, by: float, z: float) -> Body:
    """The same handles `by` seconds later, on a path that is `z` metres further."""

    def shifted(t: Array) -> dict[str, Array]:
        values = body(t - by)
        return {**values, "z": values["z"] + z}

    return shifted


def added(body: Body, curves: dict[str, Curve]) -> Body:
    """Handles plus curves of time on top of them."""

    def sum_of(t: Array) -> dict[str, Array]:
        values = body(t)
        extra = {name: values.get(name, np.zeros_like(t)) + curve(t) for name, curve in curves.items()}
        return {**values, **extra}

    return sum_of


def replaced(body: Body, curves: dict[str, Curve]) -> Body:
    """Handles, some of them by other curves."""
    return lambda t: {**body(t), **{name: curve(t) for name, curve in curves.items()}}


def slope(body: Body, name: str, at: float) -> float:
    """Rate of change of a handle, per second."""
    values = body(np.array([at - STEP, at + STEP]))[name]
    return float(values[1] - values[0]) / (2 * STEP)


def value(body: Body, name: str, at: float) -> float:
    """A handle at one time."""
    return float(body(np.array([at]))[name][0])


def mixed(first: Body, second: Body, weight: Curve) -> Body:
    """`first` where the weight is 0, `second` where it is 1."""

    def body(t: Array) -> dict[str, Array]:
        a, b, w = first(t), second(t), weight(t)
        zero = np.zeros_like(t)
        return {name: a.get(name, zero) * (1 - w) + b.get(name, zero) * w for name in sorted({*a, *b})}

    return body


def sides(make: Callable[[str, float], TrackOf]) -> Feet:
    """Feet from one maker called with a side's name and its sign."""
    tracks = {side: make(side, sign) for side, sign in SIDES.items()}
    return lambda t: {side: track(t) for side, track in tracks.items()}

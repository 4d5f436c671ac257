"""Times and places of a stop: what it goes on from, and where its last two steps come down."""

from dataclasses import dataclass

import numpy as np
from curves import Array, ramp
from moves.feet import Plant
from moves.motion import Body, Feet
from moves.stand import FOOT_X, FOOT_Z, TOES_OUT, stand_plant
from moves.start import FIRST_STEP, START, start_body, start_feet
from moves.walk import CYCLE, OFF, walk_body, walk_feet, walk_plant

STOP = 1.0
LONGEST = 0.45  # of a cycle: the earliest that the last step is shortened
SHORTER = 0.21  # metres: by how much at the most
QUICKER = 0.13  # the share of its time that the last step saves at the most


@dataclass(frozen=True)
class Stop:
    """The times and places of one stop: `sign` +1 if the left foot is the last to step.

    It goes on from `body` and `feet` as they are at the time `begin`; the heel of the last foot touches at
    `touch` seconds instead of at the time `strike`, and `short` metres before its place there; the other
    foot leaves the ground at `lift`, and is beside it at `closed`.
    """

    sign: float
    begin: float
    strike: float
    short: float
    touch: float
    lift: float
    closed: float
    body: Body
    feet: Feet
    place: Plant
    """where the last foot comes to rest"""
    stands: Plant
    """where the other one stands before"""
    off: float = 0.0
    """seconds until the last foot is in the air"""

    @property
    def middle(self) -> float:
        """x between the feet that have come to rest."""
        return self.sign * (abs(self.place.x) - FOOT_X)

    @property
    def end(self) -> float:
        """z of the pelvis at the end."""
        return self.place.z - FOOT_Z

    def going(self, t: Array) -> Array:
        """The time of `body` and `feet` at a time of the stop: it runs a little ahead until the heel
        touches.
        """
        if self.touch <= 0:
            return self.begin + t
        saved = self.strike - self.begin - self.touch
        return np.asarray(self.begin + t + saved * ramp(t, 0.0, self.touch))

    def shifted(self, seconds: float) -> float:
        """When something happens that follows the heel strike by so many seconds: all is over at the end."""
        return self.touch + seconds * min(1.0, STOP - self.touch)


def stop_of_walk(sign: float, ahead: float) -> Stop:
    """A stop that begins this part of a cycle before the last foot's heel touches."""
    part, strike = max(ahead, 0.0) / LONGEST, (1.0 if sign > 0 else 1.5) * CYCLE
    touch, place = ahead * CYCLE * (1 - QUICKER * part), walk_plant(sign, 1)
    short = SHORTER * part**1.5
    return Stop(
        sign=sign,
        begin=strike - ahead * CYCLE,
        strike=strike,
        short=short,
        touch=touch,
        lift=touch + 0.131 - 0.012 * part,
        closed=touch + 0.50 - 0.05 * part,
        body=walk_body,
        feet=walk_feet(),
        place=place._replace(start=touch, end=9.0, z=place.z - short),
        stands=walk_plant(-sign, 0 if sign > 0 else 1),
        off=max(0.0, (ahead - (1 - OFF)) * CYCLE),
    )


def stop_of_start(begin: float, step: float) -> Stop:
    """A stop after so many seconds of the start: the first step is `step` metres, and the last."""
    strike = START - CYCLE / 2
    touch = 0.9 * (strike - begin)
    return Stop(
        sign=-1.0,
        begin=begin,
        strike=strike,
        short=FIRST_STEP - step,
        touch=touch,
        lift=touch + 0.10,
        closed=touch + 0.45,
        body=start_body(),
        feet=start_feet(),
        place=Plant(touch, 9.0, walk_plant(-1.0, 0).x, FOOT_Z + step, -TOES_OUT),
        stands=stand_plant(1.0),
    )

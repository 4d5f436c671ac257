"""All motions of the figure, in the order of the file."""

from moves.crouch import CROUCH, STAND_UP
from moves.curve import CURVE_LEFT, CURVE_RIGHT
from moves.jump import ABSORB, FLY, GET_UP, JUMPS, LAND
from moves.motion import Motion
from moves.stand import STAND
from moves.start import START_WALK
from moves.stop import NOT_GONE, SHORT_STOPS, STOPS
from moves.turn import TURN_LEFT, TURN_RIGHT
from moves.walk import WALK

MOTIONS: list[Motion] = [
    STAND,
    START_WALK,
    WALK,
    *STOPS,
    *SHORT_STOPS,
    NOT_GONE,
    TURN_LEFT,
    TURN_RIGHT,
    CURVE_LEFT,
    CURVE_RIGHT,
    *JUMPS,
    FLY,
    LAND,
    ABSORB,
    GET_UP,
    CROUCH,
    STAND_UP,
]

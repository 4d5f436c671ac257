"""All motions of the figure, in the order of the file."""

from moves.crouch import STAND_UP
from moves.curve import CURVE_LEFT, CURVE_RIGHT
from moves.jump import CROUCH, FLY, JUMP, LAND
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
    JUMP,
    FLY,
    LAND,
    CROUCH,
    STAND_UP,
]

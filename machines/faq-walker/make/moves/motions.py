"""All motions of the figure, in the order of the file."""

from moves.crouch import STAND_UP
from moves.jump import CROUCH, FLY, JUMP, LAND
from moves.motion import Motion
from moves.stand import STAND
from moves.start_stop import COME_TO_STOP, START_WALK
from moves.turn import TURN_LEFT, TURN_RIGHT
from moves.walk import WALK

MOTIONS: list[Motion] = [
    STAND,
    START_WALK,
    WALK,
    COME_TO_STOP,
    TURN_LEFT,
    TURN_RIGHT,
    JUMP,
    FLY,
    LAND,
    CROUCH,
    STAND_UP,
]

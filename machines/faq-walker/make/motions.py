"""All motions of the figure, in the order of the file."""

from crouch import STAND_UP
from jump import CROUCH, FLY, JUMP, LAND
from motion import Motion
from stand import STAND
from start_stop import COME_TO_STOP, START_WALK
from turn import TURN_LEFT, TURN_RIGHT
from walk import WALK

MOTIONS: list[Motion] = [STAND, START_WALK, WALK, COME_TO_STOP, TURN_LEFT, TURN_RIGHT, JUMP, FLY, LAND, CROUCH, STAND_UP]

"""Times, heights and speeds of the leap, from which body and feet are keyed (seconds, metres)."""

from moves.crouch import BACK
from moves.stand import FOOT_Z

GRAVITY = 9.81
TAKE_OFF, FLIGHT = 0.55, 31 / 60
ABSORB, SINK, HOLD = 6 / 60, 0.42, 0.75  # from touch-down: end of land, lowest and still, end of the crouch
TOUCH, END = TAKE_OFF + FLIGHT, TAKE_OFF + FLIGHT + SINK
UP, FORWARD = 2.45, 1.45  # metres a second at take-off
HIGH, FAR = 0.940, 0.665  # pelvis at take-off
TOUCH_HEIGHT = HIGH + UP * FLIGHT - GRAVITY / 2 * FLIGHT**2
TOUCH_FAR = FAR + FORWARD * FLIGHT
STOP_FAR = TOUCH_FAR + 0.130  # pelvis at the end
LANDING_Z = STOP_FAR - BACK + FOOT_Z

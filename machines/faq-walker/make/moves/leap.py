"""Times, heights and speeds of the leap, from which body and feet are keyed (seconds, metres)."""

from moves.stand import FOOT_Z

GRAVITY = 9.81
TAKE_OFF, FLIGHT = 0.55, 31 / 60
LANDED, ABSORBED, STOOD = 6 / 60, 11 / 60, 29 / 60  # from touch-down: the ends of land, absorb and rise
TOUCH, END = TAKE_OFF + FLIGHT, TAKE_OFF + FLIGHT + STOOD
UP, FORWARD = 2.45, 1.45  # metres a second at take-off
HIGH, FAR = 0.940, 0.665  # pelvis at take-off
TOUCH_HEIGHT = HIGH + UP * FLIGHT - GRAVITY / 2 * FLIGHT**2
TOUCH_FAR = FAR + FORWARD * FLIGHT
STOP_FAR = TOUCH_FAR + 0.200  # pelvis at the end
LANDING_Z = STOP_FAR + FOOT_Z

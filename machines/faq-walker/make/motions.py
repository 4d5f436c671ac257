"""All motions of the figure, in the order of the file."""

from dataclasses import replace

from motion import Motion
from stand import STAND
from walk import WALK

MOTIONS: list[Motion] = [
    STAND,
    *(
        replace(STAND, name=name, duration=1.0, loop=False)
        for name in ("start-walk", "come-to-stop", "turn-left", "turn-right", "jump", "fly", "land", "crouch", "stand-up")
    ),
    WALK,
]

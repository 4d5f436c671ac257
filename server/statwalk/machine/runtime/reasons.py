"""Codes of verdicts and of their reasons.

`stage.effects.words` turns the codes into sentences when they are read.
"""

TAKEN, WAITS, DROPPED = range(3)
VERDICTS = ("taken", "waits", "dropped")
"""names of the verdicts, by code"""

(
    AT_ONCE,
    AFTER_THE_END,
    AT_ITS_MOMENT,
    AT_THE_END,
    IDLE,
    CHANGES_ARE_MADE,
    FOR_ITS_MOMENT,
    BLANK_CELL,
    NOTHING_TRUE,
    BLANK_AND_OVER,
    NOTHING_TRUE_AND_OVER,
    TOO_MANY_WAIT,
    RELEASED,
    HELD_ALREADY,
    ONLY_MOTIONS_END,
    OFF_CELL,
    NO_STATE,
    STATE_WAS_LEFT,
) = range(18)
"""Taken: AT_ONCE; AFTER_THE_END of the motion, which ended before; AT_ITS_MOMENT, a marker or a window;
AT_THE_END of the motion; IDLE: no other event answered END. Waits: CHANGES_ARE_MADE, eight in this tick;
FOR_ITS_MOMENT. Waits or dropped: BLANK_CELL; NOTHING_TRUE in the cell. Dropped: BLANK_AND_OVER and
NOTHING_TRUE_AND_OVER, the buffer has run out; TOO_MANY_WAIT, and it was the oldest; RELEASED; HELD_ALREADY;
ONLY_MOTIONS_END, END cannot be sent; OFF_CELL, a `-`; NO_STATE has the name in the cell; STATE_WAS_LEFT
before the moment of the cell
"""

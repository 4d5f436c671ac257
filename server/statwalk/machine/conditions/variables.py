"""The variables of conditions: a machine's parameters, and the values of an actor after the tick before.

A new value is a name here, and one assignment: in `stage/steps/measurements.py` if the stage measures it, in
`condition_values.observe` if the machine knows it.
"""

from __future__ import annotations

from collections.abc import Iterable

PARAMETER = -1
"""the kind of a variable that is a parameter; the kind of every other variable is its row of NAMES"""
MEASURED = ("speed", "turning", "height")
"""measured by the stage: metres per second along the ground, radians per second (left positive), metres"""
OBSERVED = ("phase", "time")
"""known to the machine, of one layer: 0…1 of the motion, seconds in the state"""
NAMES = (*MEASURED, *OBSERVED)
SPEED, TURNING, HEIGHT, PHASE, TIME = range(len(NAMES))
COUNT_MEASURED = len(MEASURED)
ENTRY = {f"entry {name}": kind for kind, name in enumerate(NAMES)}
"""what a state's motion may be blended over beside parameters: a value at the moment in which the state was
entered; the row of NAMES
"""


def variables_of(parameters: Iterable[str]) -> tuple[str, ...]:
    """Returns the variables of a machine with these parameters, which come first; a parameter hides the value
    of the same name.
    """
    return tuple(dict.fromkeys((*parameters, *NAMES)))

"""What the upper body does beside walking: the right arm waves, the head nods.

Both begin and end as one stands.
"""

import numpy as np
from curves import Array, Curve, eased
from moves.motion import Motion, added, held, replaced, value
from moves.stand import stand_body, stand_feet

STAND_POSE = held(stand_body, 0.0)
WAVE, NOD = 2.8, 1.1  # seconds
UP, DOWN = 0.62, 2.15  # when the arm has come up, and when it begins to come down
SWINGS = 3


def _rise(name: str, peak: float, early: float = 0.0) -> Curve:
    """From where the arm hangs to `peak` and back, with a little anticipation; parts that lead come `early`
    seconds before.
    """
    rest = value(STAND_POSE, f"Right.{name}", 0.0)
    over = peak + 0.06 * (peak - rest)
    keys = [
        (0.0, rest),
        (0.14 - early, rest - 0.02 * (peak - rest)),
        (UP - 0.06 - early, over),
        (UP + 0.14 - early, peak),
        (DOWN - early, peak),
        (WAVE - 0.22 - early, rest - 0.03 * (peak - rest)),
        (WAVE, rest),
    ]
    return eased(keys)


def _to_and_fro(size: float, lag: float) -> Curve:
    """Degrees to either side while the arm is up."""
    share = eased(
        [(0.0, 0.0), (UP - 0.2, 0.0), (UP + 0.12, 1.0), (DOWN - 0.12, 1.0), (DOWN + 0.25, 0.0), (WAVE, 0.0)]
    )

    def curve(t: Array) -> Array:
        part = (t - lag - UP) / (DOWN - UP)
        return np.asarray(size * share(t) * np.sin(2 * np.pi * SWINGS * part))

    return curve


def _sum(*curves: Curve) -> Curve:
    return lambda t: np.asarray(np.sum([curve(t) for curve in curves], axis=0))


# the upper arm goes out to the side, the forearm stands up beside the head and swings; the hand trails
ARM = {
    "Right.raise": _rise("raise", 8.0, 0.05),
    "Right.reach": _rise("reach", 6.0, 0.04),
    "Right.swing": _rise("swing", 16.0, 0.02),
    "Right.abduct": _sum(_rise("abduct", 66.0, 0.03), _to_and_fro(3.0, 0.0)),
    "Right.twist": _rise("twist", -88.0),
    "Right.elbow": _sum(_rise("elbow", 100.0, -0.03), _to_and_fro(16.0, 0.03)),
    "Right.forearm": _rise("forearm", 40.0),
    "Right.wrist": _rise("wrist", -4.0, -0.04),
    "Right.wrist_side": _sum(_rise("wrist_side", 0.0), _to_and_fro(-12.0, 0.09)),
}
LOOK = {
    "head_pitch": eased(
        [(0.0, 0.0), (0.14, -1.0), (0.36, 13.0), (0.58, 2.0), (0.78, 9.0), (NOD - 0.1, 0.0), (NOD, 0.0)]
    )
}

GESTURES = [
    Motion("wave", WAVE, replaced(STAND_POSE, ARM), stand_feet(), rate=30),
    Motion("nod", NOD, added(STAND_POSE, LOOK), stand_feet(), rate=30),
]

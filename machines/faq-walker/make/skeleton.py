"""The FAQ's 20-bone mammal (Q11, misprints corrected) in human proportions: metres, +Y up, facing +Z, left is
+X.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROOT_HEIGHT = 0.96
HIP, THIGH, SHIN, FOOT = 0.10, 0.43, 0.42, 0.20
LOWER_BACK, UPPER_BACK, HEAD = 0.22, 0.27, 0.30
SHOULDER, UPPER_ARM, LOWER_ARM, HAND = 0.19, 0.29, 0.26, 0.18
ANKLE_HEIGHT = ROOT_HEIGHT - THIGH - SHIN
WRIST = UPPER_ARM + LOWER_ARM
SIDES = {"Left": 1.0, "Right": -1.0}

UP, DOWN, FORWARD = (0.0, 1.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)


def _limbs(side: str, sign: float) -> list[tuple[str, str, float, tuple[float, float, float]]]:
    out = (sign, 0.0, 0.0)
    return [
        (f"{side}.shoulder", "Upperback", SHOULDER, out),
        (f"{side}.upperarm", f"{side}.shoulder", UPPER_ARM, DOWN),
        (f"{side}.lowerarm", f"{side}.upperarm", LOWER_ARM, DOWN),
        (f"{side}.hand", f"{side}.lowerarm", HAND, DOWN),
        (f"{side}.butt", "Root", HIP, out),
        (f"{side}.upperleg", f"{side}.butt", THIGH, DOWN),
        (f"{side}.lowerleg", f"{side}.upperleg", SHIN, DOWN),
        (f"{side}.foot", f"{side}.lowerleg", FOOT, FORWARD),
    ]


# name, parent, length, direction; parents first
BONES: list[tuple[str, str, float, tuple[float, float, float]]] = [
    ("Root", "", 0.0, UP),
    ("Lowerback", "Root", LOWER_BACK, UP),
    ("Upperback", "Lowerback", UPPER_BACK, UP),
    ("Head", "Upperback", HEAD, UP),
    *_limbs("Left", 1.0),
    *_limbs("Right", -1.0),
]
NAMES = [bone[0] for bone in BONES]
INDEX = {name: index for index, name in enumerate(NAMES)}

# joints beyond the FAQ's, by their parents: no clip moves them
MORE: dict[str, str] = {
    **{f"{side}.{part}": "Head" for part in ("eye", "lid") for side in SIDES},
    "Jaw": "Head",
    **{
        f"{side}.{finger}": f"{side}.hand"
        for side in SIDES
        for finger in ("index", "middle", "ring", "little", "thumb")
    },
}
PARENT = [INDEX.get(bone[1], -1) for bone in BONES]


def rest_translation() -> Array:
    """Local translations (J, 3): a bone starts where its parent ends."""
    ends = [np.multiply(length, direction) for _, _, length, direction in BONES]
    rows = [ends[parent] if parent >= 0 else np.array([0.0, ROOT_HEIGHT, 0.0]) for parent in PARENT]
    return np.array(rows)

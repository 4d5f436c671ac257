"""Small captures, made by hand: a body that walks in place, as BVH and as TRC."""

from collections.abc import Mapping, Sequence
from math import pi, sin

import numpy as np

BODY = (  # name, parent, offset in centimetres
    ("Hips", "", (0, 0, 0)),
    ("LeftUpLeg", "Hips", (10, -5, 0)),
    ("LeftLeg", "LeftUpLeg", (0, -40, 0)),
    ("LeftFoot", "LeftLeg", (0, -40, 0)),
    ("LeftToeBase", "LeftFoot", (0, -6, 12)),
    ("RightUpLeg", "Hips", (-10, -5, 0)),
    ("RightLeg", "RightUpLeg", (0, -40, 0)),
    ("RightFoot", "RightLeg", (0, -40, 0)),
    ("RightToeBase", "RightFoot", (0, -6, 12)),
    ("Spine", "Hips", (0, 20, 0)),
    ("Neck", "Spine", (0, 30, 0)),
    ("Head", "Neck", (0, 10, 0)),
    ("LeftArm", "Spine", (18, 25, 0)),
    ("LeftForeArm", "LeftArm", (28, 0, 0)),
    ("LeftHand", "LeftForeArm", (25, 0, 0)),
    ("RightArm", "Spine", (-18, 25, 0)),
    ("RightForeArm", "RightArm", (-28, 0, 0)),
    ("RightHand", "RightForeArm", (-25, 0, 0)),
)
FRAMES, RATE = 31, 30.0


def turns(phase: float) -> dict[str, tuple[float, float, float]]:
    """Degrees about Z, X, Y of the joints at a phase of the walk, 0…1."""
    swing = 25 * sin(2 * pi * phase)
    bend = {
        side: 20 + 20 * sin(2 * pi * phase + shift) for side, shift in (("Left", 1.0), ("Right", 1.0 + pi))
    }
    return {
        "LeftUpLeg": (0, -swing - 10, 0),
        "RightUpLeg": (0, swing - 10, 0),
        "LeftLeg": (0, bend["Left"], 0),
        "RightLeg": (0, bend["Right"], 0),
        "LeftArm": (-75, 0, swing),
        "RightArm": (75, 0, swing),
        "Spine": (0, 5, swing / 5),
    }


def walk(names: Mapping[str, str] | None = None, speed: float = 100.0, heading: float = 0.0) -> str:
    """A BVH of one second: 100 cm/s along +Z (or turned by `heading` degrees), hips 90 cm high.

    `names` gives joints other names.
    """
    shown = {name: (names or {}).get(name, name) for name, _, _ in BODY}
    rows = []
    for frame in range(FRAMES):
        phase, way = frame / (FRAMES - 1), speed * frame / RATE
        turned = turns(phase)
        radians = heading * pi / 180
        row: list[float] = [way * sin(radians), 90, way * sin(pi / 2 - radians), 0, 0, heading]
        for name, _, _ in BODY[1:]:
            row += turned.get(name, (0, 0, 0))
        rows.append(" ".join(f"{value:.6f}" for value in row))
    motion = f"MOTION\nFrames: {FRAMES}\nFrame Time: {1 / RATE:.9f}\n"
    return "HIERARCHY\n" + _joint("Hips", shown, 0) + motion + "\n".join(rows) + "\n"


def _joint(name: str, shown: Mapping[str, str], depth: int) -> str:
    offset = next(offset for own, _, offset in BODY if own == name)
    positions = "" if depth else "Xposition Yposition Zposition "
    kind, count = ("JOINT", 3) if depth else ("ROOT", 6)
    children = [own for own, parent, _ in BODY if parent == name]
    below = "".join(_joint(child, shown, depth + 1) for child in children) or "End Site\n{\nOFFSET 0 0 5\n}\n"
    x, y, z = offset
    channels = f"CHANNELS {count} {positions}Zrotation Xrotation Yrotation"
    return f"{kind} {shown[name]}\n{{\nOFFSET {x} {y} {z}\n{channels}\n{below}}}\n"


def trc(names: Sequence[str], places: np.ndarray, rate: float = RATE) -> str:
    """A TRC of marker places (F, M, 3) in metres, written in millimetres; NaN becomes a blank."""
    keys = [
        "DataRate",
        "CameraRate",
        "NumFrames",
        "NumMarkers",
        "Units",
        "OrigDataRate",
        "OrigDataStartFrame",
        "OrigNumFrames",
    ]
    values = [rate, rate, len(places), len(names), "mm", rate, 1, len(places)]
    lines = ["PathFileType\t4\t(X/Y/Z)\twalk.trc", "\t".join(keys), "\t".join(map(str, values))]
    lines.append("Frame#\tTime\t" + "\t\t\t".join(names) + "\t\t")
    lines.append("\t\t" + "\t".join(f"{axis}{row + 1}" for row in range(len(names)) for axis in "XYZ"))
    for number, frame in enumerate(places):
        fields = ["" if np.isnan(value) else f"{value * 1000:.6f}" for value in frame.reshape(-1)]
        lines.append("\t".join([str(number + 1), f"{number / rate:.6f}", *fields]))
    return "\n".join(lines) + "\n"

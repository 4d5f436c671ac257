"""Motion captures that nobody should send; each must be refused with the line and the reason."""

import captures
import numpy as np

WALK = captures.walk()
TRC = captures.trc(["Hips", "LKNE", "LANK", "RHip"], np.random.default_rng(1).random((3, 4, 3)))
COUNT = "1000000000000"


def _changed(text: str, old: str, new: str) -> bytes:
    assert old in text
    return text.replace(old, new, 1).encode()


def _deep(joints: int) -> bytes:
    body = "OFFSET 0 1 0\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
    parts = ["HIERARCHY\nROOT a\n{\n", body]
    parts += [f"JOINT a{number}\n{{\n{body}" for number in range(joints)]
    return "".join([*parts, "}\n" * (joints + 1), "MOTION\nFrames: 1\nFrame Time: 0.1\n"]).encode()


HOSTILE_CAPTURES = {
    "a million million frames": (_changed(WALK, "Frames: 31", f"Frames: {COUNT}"), "31 rows follow"),
    "fewer frames than rows": (_changed(WALK, "Frames: 31", "Frames: 3"), "rows follow"),
    "minus one frame": (_changed(WALK, "Frames: 31", "Frames: -1"), "-1"),
    "no time between frames": (_changed(WALK, "Frame Time: 0.033333333", "Frame Time: 0"), "Frame Time"),
    "not a number": (_changed(WALK, " 90.000000 ", " nan "), "nan"),
    "infinity": (_changed(WALK, " 90.000000 ", " 1e999 "), "1e999"),
    "a word among numbers": (_changed(WALK, " 90.000000 ", " ninety "), "ninety"),
    "a million million channels": (_changed(WALK, "CHANNELS 3", f"CHANNELS {COUNT}"), "CHANNELS"),
    "an unknown channel": (_changed(WALK, "Zrotation", "Wrotation"), "Wrotation"),
    "a hundred thousand joints": (_deep(100_000), "at most"),
    "an open brace": (_changed(WALK, "}\n", ""), "MOTION"),
    "a brace without a joint": (b"HIERARCHY\n{\n", "{"),
    "nothing after the word": (b"HIERARCHY", "ends before MOTION"),
    "noise after the word": (b"HIERARCHY\n" + bytes(range(256)) * 400, ""),
    "one line of ten megabytes": (b"HIERARCHY\nROOT " + b"x " * 5_000_000, ""),
    "markers: a million million frames": (_changed(TRC, "\t3\t4\tmm", f"\t{COUNT}\t4\tmm"), "3 rows follow"),
    "markers: a million million markers": (_changed(TRC, "\t3\t4\tmm", f"\t3\t{COUNT}\tmm"), "2000 markers"),
    "markers: no such unit": (_changed(TRC, "\tmm\t", "\tparsec\t"), "parsec"),
    "markers: not a rate": (_changed(TRC, "30.0\t", "inf\t"), "DataRate"),
    "markers: a row too wide": (_changed(TRC, "\n2\t", "\n2\t5\t"), "this one has"),
    "markers: names that say nothing": (TRC.replace("Hips", "m1").replace("RHip", "m2").encode(), "a body"),
    "markers: the head alone": (TRC.split("\n")[0].encode() + b"\n" * 5, "line"),
}
"""by what is wrong: the file, and a part of the reason"""

"""Reads names of joints: the side of the body, and the part that a joint is, in the spellings of Mixamo, VRM,
Unreal, Blender's Rigify, CMU, KayKit, Quaternius and the FAQ.
"""

from __future__ import annotations

import re
from itertools import pairwise

WORDS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
SIDES = {"left": "left", "l": "left", "lft": "left", "right": "right", "r": "right", "rgt": "right"}
SUFFIX = re.compile(r"(?<=[a-z])([LR])(?=[._]?\d*$)")
"""the side of names like FootL and Foot_L.001"""


def words_of(name: str) -> list[str]:
    """Returns the words of a joint's name in lower case: `mixamorig:LeftUpLeg` -> left, up, leg."""
    spaced = SUFFIX.sub(r"_\1", name.rsplit(":", 1)[-1])
    return [word.lower() for word in WORDS.findall(spaced)]


def side_of(name: str) -> str:
    """Returns `left` or `right`; empty if the name has no side."""
    return next((SIDES[word] for word in words_of(name) if word in SIDES), "")


def is_part(name: str, stems: str) -> bool:
    """Returns whether a word of the name, or two words in a row, begin with one of the stems."""
    words = words_of(name)
    pairs = [first + second for first, second in pairwise(words)]
    return any(word.startswith(stem) for word in (*words, *pairs) for stem in stems.split())

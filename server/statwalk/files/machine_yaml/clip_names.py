"""Reads the name of a clip: the kind of its motion, and the names that its state and its event may have."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Literal

Kind = Literal["loop", "once", "rest"]
"""loop: repeats until an event ends it; once: returns to the idle state; rest: ends in a pose that stays"""

STILL_SECONDS = 0.1
KINDS: tuple[tuple[str, Kind], ...] = (
    ("hit react to", "once"),
    ("idle loop cycle", "loop"),
    ("stand standup", "once"),
    ("death crdeath dead die dying defeat lie lay sit sleep pose duck crouch", "rest"),
    ("jump land start stop flip roll dodge", "once"),
    ("walk run jog sprint gallop trot canter danc fly swim hover climb crawl strafe float", "loop"),
    (
        "attack punch kick throw shoot reload chop slice stab slash wave yes no thumbs nod cheer clap bow "
        "pick pickup",
        "once",
    ),
    ("use interact open close taunt", "once"),
    ("breath survey wait rest swing spin block aim cast spellcasting eat talk type driv turn", "loop"),
)
"""stems and the kind that they mean; the first row that matches a word of the clip decides: a running jump is
a jump, a shot on the run is a run
"""
WORDS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_a-zA-Z]+")


def without_armature(clip: str) -> str:
    """Returns the name without the armature that some exporters put before a `|`."""
    return clip.rsplit("|", 1)[-1] or clip


def words(clip: str) -> list[str]:
    """Returns the words of a clip's name in lower case: `CharacterArmature|Run_Gun` -> run, gun; `WalkJump`
    -> walk, jump.
    """
    return [word.lower() for word in WORDS.findall(without_armature(clip))]


def has_stem(clip: str, stems: str) -> bool:
    """Returns whether a word of the clip begins with one of the stems; a stem of two letters must be the
    whole word.
    """
    return any(
        word == stem or (len(stem) > 2 and word.startswith(stem))
        for word in words(clip)
        for stem in stems.split()
    )


def kind(clip: str, duration: float, comes_round: bool) -> Kind:
    """Returns the kind of a motion by its name; if no stem matches, by whether its last pose is its first.

    `duration` is in seconds.
    """
    if duration < STILL_SECONDS:
        return "rest"
    return next(
        (matching_kind for stems, matching_kind in KINDS if has_stem(clip, stems)),
        "loop" if comes_round else "once",
    )


def idle_rank(clip: str) -> tuple[int, int]:
    """Returns how well a clip suits as idle motion: the lowest rank is best."""
    for rank, stems in enumerate(("idle", "survey breath wait stand")):
        if has_stem(clip, stems):
            return rank, len(words(clip))
    return 2, 0


def state_name(clip: str, taken: Iterable[str]) -> str:
    """Returns a valid and unused name for the clip's state: other characters become `_`."""
    return unused_name(re.sub(r"[^\w.-]+", "_", without_armature(clip)).strip("_.-") or "Motion", taken)


def unused_name(name: str, taken: Iterable[str]) -> str:
    """Returns the name, with a number after it if the name is taken."""
    taken_names, number, unused = set(taken), 2, name
    while unused in taken_names:
        unused, number = f"{name}_{number}", number + 1
    return unused

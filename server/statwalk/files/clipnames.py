"""What the name of a clip says: what kind of motion it is, and what a state or an event of it may be called."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Literal

Kind = Literal["loop", "once", "rest"]
"""loop: goes on until somebody says otherwise; once: comes back to the idle state; rest: ends in a pose that stays"""

STILL_SECONDS = 0.1
KINDS: tuple[tuple[str, Kind], ...] = (
    ("hit react to", "once"),
    ("idle loop cycle", "loop"),
    ("stand standup", "once"),
    ("death dead die dying defeat lie lay sit sleep pose duck crouch", "rest"),
    ("jump land start stop flip roll dodge", "once"),
    ("walk run jog sprint gallop trot canter danc fly swim hover climb crawl strafe float", "loop"),
    ("attack punch kick throw shoot reload chop slice stab slash wave yes no thumbs nod cheer clap bow pick pickup", "once"),
    ("use interact open close taunt", "once"),
    ("breath survey wait rest swing spin block aim cast spellcasting eat talk type driv turn", "loop"),
)
"""the first that has a stem of one of the clip's words decides: a running jump is a jump, a shot on the run is a run"""
WORDS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+|[^\W\d_a-zA-Z]+")


def bare(clip: str) -> str:
    """The name without the armature before `|` that some exporters put there."""
    return clip.rsplit("|", 1)[-1] or clip


def words(clip: str) -> list[str]:
    """`CharacterArmature|Run_Gun` -> run, gun; `WalkJump` -> walk, jump."""
    return [word.lower() for word in WORDS.findall(bare(clip))]


def says(clip: str, stems: str) -> bool:
    """Whether one of its words begins with one of the stems; one of two letters must be the whole word."""
    return any(word == stem or (len(stem) > 2 and word.startswith(stem)) for word in words(clip) for stem in stems.split())


def kind(clip: str, duration: float, comes_round: bool) -> Kind:
    """The kind of a motion, from its name, else from its last pose being its first; `duration` in seconds."""
    if duration < STILL_SECONDS:
        return "rest"
    return next((found for stems, found in KINDS if says(clip, stems)), "loop" if comes_round else "once")


def idle_rank(clip: str) -> tuple[int, int]:
    """How well a clip suits standing about: the least is best."""
    for rank, stems in enumerate(("idle", "survey breath wait stand")):
        if says(clip, stems):
            return rank, len(words(clip))
    return 2, 0


def state_name(clip: str, taken: Iterable[str]) -> str:
    """A valid name for its state that is not taken: other characters become `_`."""
    return distinct(re.sub(r"[^\w.-]+", "_", bare(clip)).strip("_.-") or "Motion", taken)


def distinct(name: str, taken: Iterable[str]) -> str:
    """The name, with a number after it where it is taken."""
    known, number, found = set(taken), 2, name
    while found in known:
        found, number = f"{name}_{number}", number + 1
    return found

"""Proposes states for the clips of a model: the FAQ's names (Q19) if the clip's name fits, otherwise the
clip's own name in capitals.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from statwalk.files.machine_yaml.clip_names import has_stem, state_name, unused_name, without_armature, words

MEANINGS = {
    "STAT": "stands about",
    "STWK": "begins to walk",
    "WALK": "walks",
    "CSTP": "comes to a stop",
    "TLFT": "turns left",
    "TRGT": "turns right",
    "JUMP": "jumps off",
    "FLY": "is in the air",
    "LAND": "lands",
    "CRCH": "crouches",
    "STUP": "stands up again",
    "RUN": "runs",
}
"""what a state is for; RUN is not one of the FAQ's states, but most characters run"""


class Rule(NamedTuple):
    """A clip may be `state` if its name has a stem of each group of `wanted` and no stem of `unwanted`."""

    state: str
    wanted: tuple[str, ...]
    unwanted: str = ""


SIDEWAYS = "back left right strafe jump turn start stop end"
RULES = (
    Rule("STAT", ("idle",), "jump fall fly sit lie crouch hit walk run"),
    Rule("STAT", ("survey breath wait stand",), "up jump"),
    Rule("STAT", ("pose static rest",), "sit lie death"),
    Rule("STWK", ("walk", "start begin")),
    Rule("CSTP", ("walk", "stop end")),
    Rule("WALK", ("walk trot",), SIDEWAYS),
    Rule("RUN", ("run jog sprint gallop",), SIDEWAYS),
    Rule("TLFT", ("turn", "left")),
    Rule("TRGT", ("turn", "right")),
    Rule("JUMP", ("jump", "start off")),
    Rule("JUMP", ("jump hop leap",), "idle loop air land end fall run walk gallop"),
    Rule("JUMP", ("jump", "to"), "run walk gallop"),
    Rule("FLY", ("jump", "idle loop air"), "to"),
    Rule("FLY", ("fly fall hover glide",)),
    Rule("LAND", ("land landing",)),
    Rule("CRCH", ("crouch duck",), "walk up idle"),
    Rule("STUP", ("crouch duck", "up exit")),
)
"""for each state the first rule that fits a clip counts; of several clips the clip with the fewest words,
then the first clip
"""


def proposed(clips: Iterable[str]) -> dict[str, str]:
    """Returns the state of each clip, in the order of the clips; no two clips share a state."""
    names = list(clips)
    chosen: dict[str, str] = {}
    for clip in names:
        if without_armature(clip) in MEANINGS and without_armature(clip) not in chosen.values():
            chosen[clip] = without_armature(clip)
    for rule in RULES:
        matching = [clip for clip in names if clip not in chosen and _fits(clip, rule)]
        if matching and rule.state not in chosen.values():
            chosen[min(matching, key=lambda clip: len(words(clip)))] = rule.state
    taken = set(MEANINGS)
    for clip in names:
        if clip not in chosen:
            chosen[clip] = unused_name(_own_name(clip), taken)
        taken.add(chosen[clip])
    return {clip: chosen[clip] for clip in names}


def _fits(clip: str, rule: Rule) -> bool:
    return all(has_stem(clip, stems) for stems in rule.wanted) and not has_stem(clip, rule.unwanted)


def _own_name(clip: str) -> str:
    """Returns the clip's own name in capitals: `Armature|WalkJump` -> WALK_JUMP, `1H_Melee_Attack` ->
    1H_MELEE_ATTACK; at most 80 letters.
    """
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", state_name(clip, ()))[:80].upper()


EVENTS = {"WALK": "FORWARD", "TLFT": "LEFT", "TRGT": "RIGHT", "CRCH": "CROUCH"}
"""the FAQ's names of events; the event of any other state has the state's name"""
CHAINS = (("STWK", "WALK"), ("CSTP", "STAT"), ("JUMP", "FLY", "LAND"), ("CRCH", "STUP"))
"""states that follow one another at the end of a motion, if a machine has all states of the chain"""
LOOPS = ("WALK", "RUN")
"""states that repeat until an event ends them, whatever the clip's name is"""
ENTRY_STATES = {"WALK": "STWK", "STAT": "CSTP"}
"""the state that is passed first if the key's state is requested"""


def next_state(state: str, states: Iterable[str]) -> str:
    """Returns the state that the end of a state leads to; empty if no chain has one, or the machine does not
    have all states of the chain.
    """
    existing = set(states)
    chains = (chain for chain in CHAINS if state in chain[:-1] and existing.issuperset(chain))
    return next((chain[chain.index(state) + 1] for chain in chains), "")


def entry_state(state: str, states: Iterable[str]) -> str:
    """Returns the state that is passed on the way into a state: STWK before WALK, CSTP before STAT."""
    entry = ENTRY_STATES.get(state, "")
    return entry if entry in states else ""


def event_of(state: str, states: Iterable[str]) -> str:
    """Returns the event that requests a state; empty for a state that only comes before or after another one:
    STWK, CSTP, FLY, LAND, STUP.
    """
    existing = set(states)
    is_entry = state in ENTRY_STATES.values() and next_state(state, existing) != ""
    follows = any(
        next_state(previous, existing) == state
        for previous in existing
        if previous not in ENTRY_STATES.values()
    )
    return "" if is_entry or follows else EVENTS.get(state, state)

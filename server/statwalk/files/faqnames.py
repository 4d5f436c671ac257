"""The states that the clips of a model may be: the FAQ's names (Q19) where a clip's name says so, else its own in capitals."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from statwalk.files.clipnames import bare, distinct, says, state_name, words

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
"""what a state is for; RUN is not one of the FAQ's, but most characters do"""


class Rule(NamedTuple):
    """A clip may be `state` where it says one stem of each group of `wanted` and none of `unwanted`."""

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
"""for each state the first that some clip keeps; of several clips the one of the fewest words, and of these the first"""


def proposed(clips: Iterable[str]) -> dict[str, str]:
    """The state of each clip, in the order of the clips; every state is there once."""
    names = list(clips)
    chosen: dict[str, str] = {}
    for clip in names:
        if bare(clip) in MEANINGS and bare(clip) not in chosen.values():
            chosen[clip] = bare(clip)
    for rule in RULES:
        free = [clip for clip in names if clip not in chosen and keeps(clip, rule)]
        if free and rule.state not in chosen.values():
            chosen[min(free, key=lambda clip: len(words(clip)))] = rule.state
    taken = set(MEANINGS)
    for clip in names:
        if clip not in chosen:
            chosen[clip] = distinct(own_name(clip), taken)
        taken.add(chosen[clip])
    return {clip: chosen[clip] for clip in names}


def keeps(clip: str, rule: Rule) -> bool:
    """Whether a clip's name is as a rule wants it."""
    return all(says(clip, stems) for stems in rule.wanted) and not says(clip, rule.unwanted)


def own_name(clip: str) -> str:
    """`Armature|WalkJump` -> WALK_JUMP, `1H_Melee_Attack` -> 1H_MELEE_ATTACK; at most 80 letters."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", state_name(clip, ()))[:80].upper()


EVENTS = {"WALK": "FORWARD", "TLFT": "LEFT", "TRGT": "RIGHT", "CRCH": "CROUCH"}
"""what the FAQ's events are called; other states are asked for by their own names"""
CHAINS = (("STWK", "WALK"), ("CSTP", "STAT"), ("JUMP", "FLY", "LAND"), ("CRCH", "STUP"))
"""what follows at the end of a motion, where a machine has all of the chain"""
LOOPS = ("WALK", "RUN")
"""what goes on until an event says otherwise, whatever the clip is called"""
DOORS = {"WALK": "STWK", "STAT": "CSTP"}
"""the ways in, which are taken when the state behind them is asked for"""


def follower(state: str, states: Iterable[str]) -> str:
    """The state that the end of a state leads to; none where the FAQ knows none, or the machine has not all of the chain."""
    known = set(states)
    whole = (chain for chain in CHAINS if state in chain[:-1] and known.issuperset(chain))
    return next((chain[chain.index(state) + 1] for chain in whole), "")


def door(state: str, states: Iterable[str]) -> str:
    """The state that is passed on the way into a state: STWK before WALK, CSTP before STAT."""
    way_in = DOORS.get(state, "")
    return way_in if way_in in states else ""


def event_of(state: str, states: Iterable[str]) -> str:
    """The event that asks for a state; none for one that only comes before or after another: STWK, CSTP, FLY, LAND, STUP."""
    known = set(states)
    is_door = state in DOORS.values() and follower(state, known) != ""
    follows = any(follower(one, known) == state for one in known if one not in DOORS.values())
    return "" if is_door or follows else EVENTS.get(state, state)
